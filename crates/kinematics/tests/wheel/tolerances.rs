//! Does the mechanism jam where a single size is beyond its tolerance, and not before?

use super::assembly::{Point, between, sized};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, Loop, Sizes};
use std::f64::consts::PI;

/// The greatest distance of a part of the driver from the wheel that any angle of the wheel near its right one leaves.
fn room(sizes: &Sizes, part: &Loop, theta: f64, axis: f64, middle: f64) -> f64 {
    let wheel = sizes.outline().wheel.outer;
    let part = part.transform(PI - theta, Point::new(axis, 0.0));
    let at = |by: f64| between(&wheel.transform(middle + by, Point::zeros()), &part);
    (-4..=4).map(|step| at(4e-4 * f64::from(step))).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn each_size_of_a_chain_may_be_off_by_its_gap() {
    for stations in [3, 4, 6, 8] {
        let sizes = sized(stations, 1, &Choices { bottom_clearance: Some(0.02), ..Choices::default() });
        let (bottom, arc) = (sizes.bottom_gap(), sizes.locking_gap().unwrap());
        approx::assert_relative_eq!(bottom, sizes.slot_gap() + 0.02, max_relative = 1e-14);
        for (share, runs) in [(0.9, true), (1.1, false)] {
            // At mid-index: a crank that is too long, a slot that ends too far out, axes that are too near.
            let pin = |of: &Sizes| of.outline().pins[0].clone();
            let (mut long, mut short) = (sizes, sizes);
            long.crank_radius += share * bottom;
            short.slot_end += share * bottom;
            let c = sizes.centre_distance;
            for (of, axis) in [(long, c), (short, c), (sizes, c - share * bottom)] {
                assert_eq!(room(&of, &pin(&of), 0.0, axis, 0.0) > 0.0, runs, "{stations}: {share}");
            }
            // In the dwell: a disc that is too large, an arc that is too small, axes that are too near.
            let (mut large, mut small) = (sizes, sizes);
            large.locking_disc.as_mut().unwrap().radius += share * arc;
            small.locking_arc_radius -= share * arc;
            for (of, axis) in [(large, c), (small, c), (sizes, c - share * arc)] {
                let disc = of.outline().disc.unwrap().outer;
                let room = room(&of, &disc, PI, axis, of.wheel.half_pitch_angle());
                assert_eq!(room > 0.0, runs, "{stations}: {share}, {room}");
            }
        }
    }
}

#[test]
fn a_longer_crank_sticks_at_entry_or_on_the_bottom() {
    for (stations, pins) in [(4, 1), (6, 1), (8, 2)] {
        let sizes = sized(stations, pins, &Choices::default());
        let (outline, c) = (sizes.outline(), Point::new(sizes.centre_distance, 0.0));
        let (half, entry) = (sizes.wheel.half_pitch_angle(), sizes.wheel.engagement_half_angle());
        let room = |part: &Loop, theta: f64, by: f64| {
            between(&outline.wheel.outer.transform(by - half, Point::zeros()), &part.transform(PI - theta, c))
        };
        // As far back as the disc lets the wheel turn.
        let disc = outline.disc.as_ref().unwrap();
        let (mut free, mut touching) = (0.0, 0.05);
        for _ in 0..20 {
            let middle = (free + touching) / 2.0;
            if room(&disc.outer, -entry, -middle) > 0.0 { free = middle } else { touching = middle }
        }
        let tolerance = sizes.crank_radius_tolerance().unwrap();
        assert!(tolerance > 1.5 * sizes.slot_gap() && tolerance < sizes.bottom_gap(), "{stations}: {tolerance}");
        for (share, runs) in [(0.95, true), (1.05, false)] {
            let mut long = sizes;
            long.crank_radius += share * tolerance;
            // The pin is farthest across the slot where the crank stands across the turned slot.
            let seen = room(&long.outline().pins[0], free - entry, -free);
            assert_eq!(seen > 0.0, runs, "{stations}: {share}, {seen}");
        }
        let shallow = sized(stations, pins, &Choices { bottom_clearance: Some(0.0), ..Choices::default() });
        assert_eq!(shallow.crank_radius_tolerance(), Some(shallow.bottom_gap()));
    }
}

#[test]
fn a_slot_may_be_off_by_the_play_of_the_dwell_and_of_its_mouth() {
    for (stations, pins) in [(4, 1), (6, 1), (8, 2)] {
        let sizes = sized(stations, pins, &Choices::default());
        let (outline, c) = (sizes.outline(), sizes.centre_distance);
        let (half, entry) = (sizes.wheel.half_pitch_angle(), sizes.wheel.engagement_half_angle());
        let is_free = |part: &Loop, by: f64| {
            let wheel = outline.wheel.outer.transform(by - half, Point::zeros());
            between(&wheel, &part.transform(PI + entry, Point::new(c, 0.0))) > 0.0
        };
        // As the pin enters: how far back the disc alone lets the wheel turn, and how far the slot may be beside the pin.
        let last = |part: &Loop, side: f64| {
            let (mut free, mut touching) = (0.0, 0.05);
            for _ in 0..20 {
                let middle = (free + touching) / 2.0;
                if is_free(part, side * middle) { free = middle } else { touching = middle }
            }
            free
        };
        let seen = last(&outline.disc.as_ref().unwrap().outer, -1.0) + last(&outline.pins[0], 1.0);
        approx::assert_relative_eq!(sizes.slot_direction_tolerance().unwrap(), seen, max_relative = 0.02);
    }
}
