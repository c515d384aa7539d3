//! Wheels that other people made, with what was found of them by other programs: an own sweep of polygons over the turn.

use super::points::Outlines;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, BuiltContact, BuiltCrescent, MeasuredSize, MeasuredWheel};
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
use std::f64::consts::PI;

fn drawn(stations: u32, crank: f64, pin: f64, slot_play: f64, horn: Option<f64>) -> Sizes {
    let play = Some(Play { slot: slot_play, locking: 0.4, bore: 0.0, pin: 0.0 });
    let choices = Choices { pin_diameter: Some(pin), play, horn_thickness: horn, ..Choices::default() };
    Sizes::new(Wheel::new(stations).unwrap(), Scale::CrankRadius(crank), &choices).unwrap()
}

#[test]
fn a_star_that_is_cut_back_is_met_late_and_hard() {
    // A parametric model of 2012: five slots, crank 25 mm, pin 10 mm, clearance 0.35 mm on each side, the star short by 5.35 mm. A
    // sweep found that the pin meets it 11 degrees late, at 60 turns per minute with 62.7 mm/s.
    let sizes = drawn(5, 25.0, 10.0, 0.7, Some(2.0));
    let mut built = AsBuiltWheel::from(&sizes);
    built.slots_mut().iter_mut().for_each(|slot| slot.tip_radius = sizes.wheel_radius - 5.35);
    let entry = built.turn().unwrap().stations[0].entry.unwrap();
    assert!((entry.lost_motion.to_degrees() - 11.0).abs() < 0.5, "{entry:?}");
    assert!((entry.centred * 25.0 * 2.0 * PI - 62.7).abs() < 1.0, "{entry:?}");
}

#[test]
fn a_cut_about_the_wheels_axis_leaves_no_free_angle_ten_degrees_from_mid_index() {
    // A school's project: four slots, wheel radius 12 mm, pin 3 mm, stop arc a − p^1.5 = 6.80 mm, the disc 0.2 mm less, and a cut of
    // the wheel's radius and as much about the wheel's axis. A sweep found no free angle ten degrees to either side of mid-index.
    let sizes = drawn(4, 12.0, 3.0, 0.2, None);
    let mut built = AsBuiltWheel::from(&sizes);
    built.arcs_mut().iter_mut().for_each(|arc| arc.radius = 6.8);
    built.disc_radius = Some(6.6);
    let crescent = BuiltCrescent { centre: sizes.centre_distance, radius: 12.2, direction_error: 0.0 };
    built.pins_mut().iter_mut().for_each(|pin| pin.crescent = crescent);
    for degrees in [-10.0_f64, 10.0] {
        assert!(built.free_angles(0, degrees.to_radians()).unwrap().width() < 0.0, "{degrees}");
    }
    let jam = built.turn().unwrap().jam.unwrap();
    let contacts = [jam.free.forward.contact, jam.free.backward.contact];
    assert!(contacts.contains(&BuiltContact::Crescent), "{jam:?}");
}

#[test]
fn a_cut_of_the_wheels_radius_overlaps_by_what_the_rim_is_larger() {
    // The rim's corners are farther out than the wheel's radius, to which the cut is drawn: in mid-index they are in the disc.
    let sizes = drawn(4, 50.0, 6.0, 0.35, None);
    let mut built = AsBuiltWheel::from(&sizes);
    let crescent = BuiltCrescent { centre: sizes.centre_distance, radius: sizes.wheel_radius, direction_error: 0.0 };
    built.pins_mut().iter_mut().for_each(|pin| pin.crescent = crescent);
    let free = built.free_angles(0, 0.0).unwrap();
    assert!((free.room() + (sizes.tip_radius - sizes.wheel_radius)).abs() < 1e-9, "{free:?}");
}

#[test]
fn the_outline_of_a_circuit_board_is_a_right_wheel() {
    // Six slots, axes 18 mm apart, slot 3.2 mm, pin 3.0 mm, slot end at 9.0 mm, arc 5.09 mm.

    let mut measured = MeasuredWheel::new(Wheel::new(6).unwrap());
    let sizes = [
        (MeasuredSize::CentreDistance, 18.0),
        (MeasuredSize::SlotWidth(None), 3.2),
        (MeasuredSize::PinDiameter, 3.0),
        (MeasuredSize::SlotEnd(None), 9.0),
        (MeasuredSize::ArcRadius(None), 5.09),
    ];
    for (size, value) in sizes {
        measured.add(size, value, 0.02).unwrap();
    }
    let nearest = measured.nearest().unwrap();
    assert!(nearest.culprit.is_none() && (nearest.crank_radius - 9.0).abs() < 0.01, "{nearest:?}");
    assert!(measured.as_built(&nearest).turn().unwrap().jam.is_none());
}

#[test]
fn a_pin_that_lands_on_the_corner_of_a_mouth_is_told_to_and_pushes_the_wheel_aside() {
    // Axes 0.2 mm too far apart, and a gap of 0.05 mm between pin and wall.
    for (stations, by) in [(6, 0.2), (6, 0.4), (4, 0.2), (8, 0.3)] {
        let sizes = drawn(stations, 25.0, 6.0, 0.1, None);
        let mut built = AsBuiltWheel::from(&sizes);
        built.centre_distance += by;
        let turn = built.turn().unwrap();
        let entry = turn.stations[0].entry.unwrap();
        assert_eq!(entry.contact, BuiltContact::PinAtMouth, "{stations} {by} {entry:?}");
        assert!(turn.jam.is_none() && entry.lost_motion < 0.0, "{stations} {by} {turn:?}");
        // The pin comes in by small steps, and the wheel gives way by no more than it must.
        let outlines = Outlines::new(&built);
        let half = PI / f64::from(stations);
        let tangent = half - PI / 2.0;
        let (mut wheel, mut first) = (-half, None);
        let (mut theta, step, turned) = (tangent - 0.25, 0.001, 0.0002);
        while theta < tangent + 0.3 {
            let is_free = |wheel: f64| outlines.depth(0, theta, wheel) < 2e-3;
            let way = |k: i32| [0.0, 1.0, -1.0].map(|sign| wheel + sign * turned * f64::from(k));
            let next = (0..60).flat_map(way).find(|wheel| is_free(*wheel));
            let next = next.unwrap_or_else(|| panic!("{stations} {by}: stuck at {theta}, {wheel}"));
            if first.is_none() && next != wheel {
                first = Some(theta);
            }
            (wheel, theta) = (next, theta + step);
        }
        let met = first.unwrap() - tangent;
        assert!((met - entry.lost_motion).abs() < 0.015, "{stations} {by}: {met} {entry:?}");
        // Inside the slot both turn together.
        let free = built.free_angles(0, theta).unwrap();
        assert!((wheel - free.middle()).abs() < free.width(), "{stations} {by}: {wheel} {free:?}");
    }
}
