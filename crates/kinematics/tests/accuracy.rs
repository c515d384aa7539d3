//! Every ratio of the wheel within two units in the last place of a 240-bit evaluation.
//!
//! `cargo run --release --example accuracy` does the same over a grid three hundred times as fine.

use crate::oracle::{MOTION, Oracle};
use geneva_kinematics::indexing::{Indexing, Phase};
use geneva_kinematics::wheel::Wheel;

/// Units in the last place; what is reached is 1.5 for the velocity and 0.5 for the rest.
const TOLERANCE: f64 = 2.0;

/// The angles at and near the end of an engagement and near its middle, and some evenly spaced between.
fn angles(most: f64) -> Vec<f64> {
    let mut angles: Vec<f64> = (0..40).map(|step| most * f64::from(step) / 39.7).collect();
    let mut near = most;
    for _ in 0..4 {
        angles.push(near);
        near = near.next_down();
    }
    for power in 2..=16 {
        let small = 10f64.powi(-power);
        angles.extend([small, most - small]);
    }
    angles
}

#[test]
fn the_motion_is_that_of_240_bits() {
    for stations in [3, 4, 5, 6, 7, 8, 12, 18, 37, 60, 1000] {
        let (wheel, oracle) = (Wheel::new(stations).unwrap(), Oracle::new(stations));
        let peak = wheel.acceleration_peak().angle;
        let mut angles = angles(wheel.engagement_half_angle());
        angles.extend([peak * 0.999_999, peak * 1.000_001]);
        for (index, size) in angles.into_iter().enumerate() {
            let crank = if index % 2 == 0 { size } else { -size };
            let motion = wheel.engaged(crank).unwrap();
            assert_eq!(wheel.velocity_ratio(crank), Ok(motion.velocity));
            for (name, error) in MOTION.iter().zip(oracle.motion_errors(&motion, crank, (0, 1))) {
                assert!(error <= TOLERANCE, "{stations} stations, {crank}: {name} off by {error} ulp");
            }
        }
    }
}

#[test]
fn the_motion_under_a_later_pin_is_that_of_240_bits() {
    for (stations, pins) in [(3, 6), (5, 3), (6, 3), (60, 2)] {
        let (wheel, oracle) = (Wheel::with_pins(stations, pins).unwrap(), Oracle::new(stations));
        for step in -30..=30 {
            let crank = f64::from(step) * 0.1;
            let motion = wheel.motion(0, crank).unwrap();
            if motion.phase == Phase::Advance {
                let pin = (crank * f64::from(pins) / std::f64::consts::TAU).round() as i32;
                for (name, error) in MOTION.iter().zip(oracle.motion_errors(&motion, crank, (pin, pins))) {
                    assert!(error <= TOLERANCE, "{stations} stations, {crank}: {name} off by {error} ulp");
                }
            }
        }
    }
}

#[test]
fn the_sizes_are_those_of_240_bits() {
    for stations in (3..=60).chain([100, 333, 1000]) {
        let oracle = Oracle::new(stations);
        for pins in 1..=2 {
            let wheel = Wheel::with_pins(stations, pins).unwrap();
            for (name, error) in oracle.size_errors(&wheel) {
                assert!(error <= TOLERANCE, "{stations} stations: {name} off by {error} ulp");
            }
        }
    }
}
