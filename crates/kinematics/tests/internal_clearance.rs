//! Does the clearance of an internal wheel over a whole turn agree with points and polygons at many angles, and do wheels whose
//! sizes are all wrong within the shared tolerance turn?

use super::internal_sizes::Pair;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::{Choices, Play};
use std::f64::consts::PI;

fn sizes(stations: u32, play: Play, pin: f64) -> InternalSizes {
    let choices = Choices { play: Some(play), pin_diameter: Some(pin), ..Choices::default() };
    InternalSizes::new(InternalWheel::new(stations).unwrap(), 30.0, &choices).unwrap()
}

/// The least distance at many crank angles.
pub(super) fn sampled(pair: &Pair) -> f64 {
    let angles = 160;
    (0..=angles).map(|k| pair.distance(PI * f64::from(k) / f64::from(angles))).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_least_clearance_is_that_of_points_and_polygons_at_many_angles() {
    let mut overlaps = 0;
    for (stations, pin) in [(3, 4.5), (4, 6.0), (6, 4.5), (12, 3.0)] {
        let sizes = sizes(stations, Play::from_slot(0.4), pin);
        for error in [-0.3, -0.05, 0.0, 0.1, 0.19, 0.5] {
            let axes = sizes.centre_distance + error;
            let found = sizes.least_clearance_at(axes).unwrap();
            let pair = Pair::apart(sizes, axes);
            let (there, least) = (pair.distance(found.crank_angle), sampled(&pair));
            // Polygons say less exactly how deep an overlap is.
            let is_overlap = found.distance < 0.0 && there < 0.0;
            // In the dwell the segment counts as if it filled its circle, so less may be found where the axes are nearer.
            let is_locked = error < 0.0 && found.crank_angle == PI;
            let is_close = is_overlap || is_locked || (found.distance - there).abs() < 2e-3;
            let name = format!("{stations} stations, {error}: {found:?}, by points {there} there and {least}");
            assert!(is_close && (is_overlap || found.distance < least + 2e-3), "{name}");
            overlaps += usize::from(is_overlap);
        }
    }
    assert!(overlaps >= 4, "{overlaps}");
}

#[test]
fn with_all_sizes_wrong_within_the_shared_tolerance_nothing_touches_and_with_twice_as_much_it_does() {
    for (stations, pin) in [(3, 4.5), (4, 5.0), (6, 4.5), (12, 3.0)] {
        let sizes = sizes(stations, Play { bore: 0.02, ..Play::from_slot(0.4) }, pin);
        let shared = sizes.shared_tolerance().unwrap_or_else(|| panic!("{stations} stations: no room"));
        let touches = |times: f64| {
            let mut least = f64::INFINITY;
            for error in [-shared.nearer * times - 0.02, shared.farther * times + 0.02] {
                for sense in [-1.0, 1.0] {
                    let mut wrong = sizes;
                    wrong.segment_radii[0] += times * shared.locking;
                    wrong.locking_arc_radius -= times * shared.locking;
                    wrong.crank_radius += times * sense * shared.crank;
                    wrong.pin_diameter += times * shared.width;
                    wrong.slot_width -= times * shared.width;
                    wrong.slot_end -= times * shared.slot_end;
                    wrong.mouth_radius = wrong.wheel_radius.hypot(wrong.slot_width / 2.0);
                    least = least.min(sampled(&Pair::apart(wrong, sizes.centre_distance + error)));
                }
            }
            least < 0.0
        };
        assert!(!touches(1.0), "{stations} stations: {shared:?}");
        assert!(touches(2.5), "{stations} stations: {shared:?}");
    }
}

#[test]
fn a_pin_off_its_place_leaves_less_to_all_sizes_and_nothing_touches_then_either() {
    for stations in [3, 4, 6, 12] {
        let pin = 0.03;
        let sizes = sizes(stations, Play { pin, ..Play::from_slot(0.4) }, 3.0);
        let mut exact = sizes;
        exact.play.pin = 0.0;
        let [shared, other] = [sizes, exact].map(|sizes| sizes.shared_tolerance().expect("room"));
        assert!(shared.crank < other.crank - 0.1 * pin, "{stations}: {shared:?}");
        for direction in 0..12 {
            let (sine, cosine) = (PI * f64::from(direction) / 6.0).sin_cos();
            let mut wrong = sizes;
            wrong.segment_radii[0] += shared.locking;
            wrong.locking_arc_radius -= shared.locking;
            wrong.crank_radius = (sizes.crank_radius + shared.crank + pin * cosine).hypot(pin * sine);
            wrong.pin_diameter += shared.width;
            wrong.slot_width -= shared.width;
            wrong.slot_end -= shared.slot_end;
            wrong.mouth_radius = wrong.wheel_radius.hypot(wrong.slot_width / 2.0);
            for error in [-shared.nearer - sizes.play.bore, shared.farther + sizes.play.bore] {
                let least = sampled(&Pair::apart(wrong, sizes.centre_distance + error));
                assert!(least > 0.0, "{stations} stations, {direction}, {error}: {least}");
            }
        }
    }
}

#[test]
fn no_shared_tolerance_is_said_where_loose_bores_take_all() {
    assert_eq!(sizes(6, Play { bore: 0.3, ..Play::from_slot(0.4) }, 4.5).shared_tolerance(), None);
    let none = sizes(6, Play::from_slot(0.0), 4.5);
    assert_eq!(none.shared_tolerance(), None);
}

#[test]
fn a_distance_that_no_axes_have_is_refused() {
    let sizes = sizes(6, Play::from_slot(0.4), 4.5);
    for wrong in [f64::NAN, f64::INFINITY, 30.0, -1.0] {
        assert!(sizes.least_clearance_at(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn horns_that_meet_the_inside_of_a_segment_that_is_too_thick_are_found() {
    for stations in [3, 4, 5] {
        let right = sizes(stations, Play::from_slot(0.4), 4.5);
        let mut wrong = right;
        for (inner, is_clear) in [(right.segment_radii[1], true), (1.0, false)] {
            wrong.segment_radii[1] = inner;
            let found = wrong.least_clearance_at(wrong.centre_distance).unwrap();
            let theirs = sampled(&Pair::apart(wrong, wrong.centre_distance));
            assert_eq!((found.distance > 0.0, theirs > 0.0), (is_clear, is_clear), "{stations}: {found:?} {theirs}");
        }
    }
}

#[test]
fn a_horn_that_comes_nearer_to_the_segment_than_the_pin_to_its_slot_is_found() {
    for stations in [3, 4, 5, 6] {
        let right = sizes(stations, Play::from_slot(0.4), 4.5);
        let with_inner = |inner: f64| {
            let mut sizes = right;
            sizes.segment_radii[1] = inner;
            sizes
        };
        // So thick that by points something is nearer than the pin, which has 0.2 mm, and hardly touches.
        let (mut touches, mut clear) = (0.5, right.segment_radii[1]);
        for _ in 0..9 {
            let middle = f64::midpoint(touches, clear);
            if sampled(&Pair::new(with_inner(middle))) > 0.1 { clear = middle } else { touches = middle }
        }
        let sizes = with_inner(clear);
        let (found, pair) = (sizes.least_clearance_at(sizes.centre_distance).unwrap(), Pair::new(sizes));
        let (there, least) = (pair.distance(found.crank_angle), sampled(&pair));
        let name = format!("{stations} stations: {found:?}, by points {there} there and {least}");
        assert!(least < 0.19 && found.distance < least + 2e-3, "{name}");
        // A millimetre apart, points say a little more than there is.
        assert!(there > found.distance - 2e-3 && there < found.distance + 0.02, "{name}");
    }
}
