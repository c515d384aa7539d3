//! Do the outlines, looked at point by point, give the same tolerance of the centre distance?

use super::assembly::{Point, between, marched, sized};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, EntryContact, Play, Sizes};
use std::f64::consts::PI;

/// Least distance of the driver from the wheel over half the engagement and in the dwell, with the axes wrong by so much
/// and the pin in the middle of its slot.
fn seen(sizes: &Sizes, error: f64) -> f64 {
    let outline = sizes.outline();
    let (a, axis) = (sizes.crank_radius, Point::new(sizes.centre_distance + error, 0.0));
    let end = sizes.wheel.engagement_half_angle();
    let instants = (0..=40).map(|step| end * f64::from(step) / 40.0);
    let apart = |theta: f64, phi: f64| {
        let wheel = outline.wheel.outer.transform(phi, Point::zeros());
        let on_driver = |of: &geneva_kinematics::wheel::Loop| of.transform(PI - theta, axis);
        let pins = outline.pins.iter().map(|pin| between(&wheel, &on_driver(pin)));
        pins.chain(outline.disc.iter().map(|disc| between(&wheel, &on_driver(&disc.outer))))
            .fold(f64::INFINITY, f64::min)
    };
    let engaged = instants.map(|theta| apart(theta, (a * theta.sin()).atan2(axis.x - a * theta.cos())));
    engaged.fold(apart(PI, sizes.wheel.half_pitch_angle()), f64::min)
}

#[test]
fn just_within_nothing_touches_and_just_beyond_something_does() {
    for stations in [3, 4, 6, 12] {
        let sizes = sized(stations, 1, &Choices::default());
        let tolerance = sizes.centre_tolerance();
        assert!(seen(&sizes, -0.98 * tolerance.nearer) > 0.0, "{stations}: {tolerance:?}");
        assert!(seen(&sizes, -1.03 * tolerance.nearer) < 0.0, "{stations}: {tolerance:?}");
        // Farther, a corner of the slot is met before the wall.
        let along = |share: f64| {
            let error = share * tolerance.farther;
            let (theta, _) = marched(&sizes, error).unwrap();
            let (sin, cos) = sizes.wheel.half_pitch_angle().sin_cos();
            let axis = sizes.centre_distance + error;
            let (x, y) = (axis - sizes.crank_radius * theta.cos(), sizes.crank_radius * theta.sin());
            x * cos - y * sin
        };
        assert!(along(0.97) < sizes.wheel_radius, "{stations}: {tolerance:?}");
        assert!(along(1.03) > sizes.wheel_radius, "{stations}: {tolerance:?}");
    }
}

#[test]
fn no_smaller_error_fails_and_no_greater_one_runs() {
    for (stations, pins) in [(3, 1), (3, 6), (4, 3), (5, 2), (6, 1), (8, 2), (12, 1), (30, 1)] {
        let sizes = sized(stations, pins, &Choices::default());
        let tolerance = sizes.centre_tolerance();
        for (limit, sign) in [(tolerance.nearer, -1.0), (tolerance.farther, 1.0)] {
            assert!(limit > 0.0 && limit < 0.5 * sizes.pin_radius(), "{stations} {pins}: {tolerance:?}");
            for part in 1..=40 {
                let share = 0.05 * f64::from(part);
                let error = sign * share * limit;
                let is_clear =
                    sizes.clearance_at(sizes.centre_distance + error).unwrap().closest_approach().distance > 0.0;
                let on_wall = sizes.entry(error).unwrap().contact == EntryContact::DrivingWall;
                if (share - 1.0).abs() > 0.01 {
                    assert_eq!(is_clear && on_wall, share < 1.0, "{stations} {pins}: {error} mm, {tolerance:?}");
                }
            }
        }
    }
}

#[test]
fn loose_bores_leave_something_of_it() {
    for stations in (3..=9).chain([14, 30, 60, 250, 360, 1000]) {
        for pins in 1..=6 {
            let Ok(wheel) = geneva_kinematics::wheel::Wheel::with_pins(stations, pins) else { continue };
            let sizes =
                Sizes::new(wheel, geneva_kinematics::wheel::Scale::CrankRadius(25.0), &Choices::default()).unwrap();
            let nearer = sizes.centre_tolerance().nearer;
            assert!(sizes.play.bore < 0.9 * nearer, "{stations} {pins}: {:?}, {nearer}", sizes.play);
        }
    }
}

#[test]
fn it_grows_with_the_play_and_is_nothing_without() {
    let tolerance = |play: f64| {
        sized(6, 1, &Choices { play: Some(Play::from_slot(play)), ..Choices::default() }).centre_tolerance()
    };
    let [none, some, twice] = [0.0, 0.1, 0.2].map(tolerance);
    assert_eq!([none.nearer, none.farther], [0.0; 2]);
    approx::assert_relative_eq!(twice.nearer, 2.0 * some.nearer, max_relative = 0.02);
    approx::assert_relative_eq!(twice.farther, 2.0 * some.farther, max_relative = 0.02);
    // The pin's way across the slot is the error times sin 30°.
    approx::assert_relative_eq!(some.farther, 0.1, max_relative = 0.005);
}

#[test]
fn a_close_fit_of_a_large_wheel_is_decided_by_few_crank_angles() {
    // As many angles as the page that a reader moves has time for; 0.04 mm is the least play of H8/e8 for these pins.
    for stations in [3, 4, 6, 7, 8, 12, 24] {
        for (radius, play) in [(80.0, 0.04), (80.0, 0.06), (100.0, 0.15), (25.0, 0.02)] {
            let choices = Choices { play: Some(Play::from_slot(play)), ..Choices::default() };
            let wheel = geneva_kinematics::wheel::Wheel::new(stations).unwrap();
            let sizes = Sizes::new(wheel, geneva_kinematics::wheel::Scale::CrankRadius(radius), &choices).unwrap();
            let found = sizes.centre_tolerance_within(12_000);
            assert!(found.is_ok(), "{stations}, {radius} mm, {play} mm: {found:?}");
            let (least, tolerance) = sizes.least_clearance_within(sizes.centre_distance, 40_000).unwrap();
            approx::assert_relative_eq!(least.distance, play / 2.0, max_relative = 1e-9);
            assert!(tolerance < 0.01 * play, "{stations}, {radius} mm, {play} mm: {tolerance}");
        }
    }
}

/// The first error at which parts touch is above the limit by less than a thousandth, as the least clearance of the whole turn says.
#[test]
fn the_axes_nearer_is_below_first_touching_by_a_thousandth_at_most() {
    let (mut exact, mut greatest) = (0, 0.0_f64);
    for stations in [3, 4, 5, 6, 8, 12, 24] {
        for (play, deeper) in [(0.02, 0.01), (0.1, 0.5), (0.4, 0.01), (1.0, 2.0)] {
            let choices = Choices {
                play: Some(Play { locking: 3.0 * play, ..Play::from_slot(play) }),
                bottom_clearance: Some(deeper * play),
                ..Choices::default()
            };
            let wheel = geneva_kinematics::wheel::Wheel::new(stations).unwrap();
            let Ok(sizes) = Sizes::new(wheel, geneva_kinematics::wheel::Scale::CrankRadius(40.0), &choices) else {
                continue;
            };
            let nearer = sizes.centre_tolerance_within(400_000).unwrap().nearer;
            let least =
                |error: f64| sizes.least_clearance_within(sizes.centre_distance - error, 4_000_000).unwrap().0.distance;
            assert!(least(nearer) >= 0.0, "{stations} {play}: {nearer}");
            assert!(least(1.001 * nearer) < 0.0, "{stations} {play}: {nearer}");
            // Where pin and bottom or disc and arc meet first, the gap says the same.
            let gap = sizes.bottom_gap().min(sizes.locking_gap().unwrap_or(f64::INFINITY));
            greatest = greatest.max(1.0 - nearer / gap);
            exact += u32::from((nearer / gap - 1.0).abs() < 2e-9);
        }
    }
    assert!(exact >= 5 && greatest > 0.05, "{exact} {greatest}");
}
