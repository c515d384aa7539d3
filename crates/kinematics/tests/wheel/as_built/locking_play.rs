//! Play in the dwell of a wheel by its measured sizes: it comes from the disc and its arc, however wide the slots are worn.

use super::points::Outlines;
use geneva_kinematics::wheel::Wheel;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, MeasuredSize, MeasuredWheel};
use std::f64::consts::PI;

/// A wheel with six slots as a calliper finds it, its slots worn to a width in millimetres.
fn worn(width: f64) -> AsBuiltWheel {
    let mut measured = MeasuredWheel::new(Wheel::new(6).unwrap());
    for (size, value) in [
        (MeasuredSize::CentreDistance, 50.0),
        (MeasuredSize::CrankRadius, 25.0),
        (MeasuredSize::TipRadius, 43.4),
        (MeasuredSize::PinDiameter, 6.0),
        (MeasuredSize::SlotWidth(None), width),
        (MeasuredSize::DiscRadius, 15.3),
        (MeasuredSize::ArcRadius(None), 15.4),
    ] {
        measured.add(size, value, 0.05).unwrap();
    }
    measured.as_built(&measured.nearest().unwrap())
}

/// Between which wheel angles points of the outlines are free at a crank angle, beside one at which they are.
fn swept(built: &AsBuiltWheel, theta: f64, around: f64) -> f64 {
    let outlines = Outlines::new(built);
    let is_free = |angle: f64| outlines.depth(0, theta, angle) <= 0.0;
    assert!(is_free(around));
    let edge = |sign: f64| {
        let (mut inside, mut outside) = (0.0, 0.1);
        assert!(!is_free(around + sign * outside));
        for _ in 0..40 {
            let middle = f64::midpoint(inside, outside);
            if is_free(around + sign * middle) { inside = middle } else { outside = middle }
        }
        inside
    };
    edge(1.0) + edge(-1.0)
}

#[test]
fn the_play_in_the_dwell_is_that_of_disc_and_arc_however_worn_the_slots_are() {
    /// What points at some distance from each other leave open, in radians.
    const NEAR: f64 = 4e-5;
    let mut plays = Vec::new();
    for width in [6.06, 6.4, 7.0] {
        let built = worn(width);
        let station = built.turn().unwrap().stations[0];
        let rest = built.free_angles(0, PI).unwrap().middle();
        assert!((swept(&built, PI, rest) - station.dwell_backlash).abs() < NEAR, "{width}: {station:?}");
        let middle = built.free_angles(0, 0.0).unwrap().middle();
        assert!((swept(&built, 0.0, middle) - station.index_backlash).abs() < NEAR, "{width}: {station:?}");
        plays.push([station.dwell_backlash, station.index_backlash]);
    }
    for [dwell, index] in &plays[1..] {
        assert!((dwell - plays[0][0]).abs() < 1e-12 && *index > plays[0][1] + 0.01, "{plays:?}");
    }
}
