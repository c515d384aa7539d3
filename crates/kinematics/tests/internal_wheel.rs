//! The internal wheel against dual numbers, vector diagrams and its own proven formulas.

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::{InternalWheel, acceleration_ratio, jerk_ratio, velocity_ratio};
use geneva_kinematics::relative_motion::accelerations;
use geneva_kinematics::{KinematicsError, Turn, pin_vectors};
use nalgebra::Vector2;
use num_dual::{DualNum, third_derivative};
use std::f64::consts::PI;

#[test]
fn what_cannot_be_built_is_said_with_what_can() {
    assert_eq!(InternalWheel::new(2), Err(KinematicsError::Stations(2)));
    assert!(InternalWheel::new(1001).is_err());
    let message = InternalWheel::with_pins(6, 2).unwrap_err().to_string();
    assert!(message.contains("2 pins") && message.contains("has only 1,") && message.ends_with("give 1"), "{message}");
}

#[test]
fn a_library_of_dual_numbers_agrees() {
    for stations in [3, 4, 6, 12, 60, 1000] {
        let wheel = InternalWheel::new(stations).unwrap();
        let ratio = wheel.centre_distance_ratio();
        for share in [-1.0, -0.97, -0.4, 0.0, 0.3, 0.8, 1.0] {
            let crank = share * wheel.engagement_half_angle();
            let motion = wheel.engaged(crank).unwrap();
            let (angle, first, second, third) = third_derivative(|t| (t.sin() / (t.cos() + ratio)).atan(), crank);
            for (ours, theirs, scale) in [
                (motion.angle, angle, wheel.half_pitch_angle()),
                (motion.velocity, first, wheel.peak_velocity()),
                (motion.acceleration, second, wheel.entry_acceleration()),
                (motion.jerk, third, wheel.jerk_peak().ratio),
            ] {
                approx::assert_abs_diff_eq!(ours, theirs, epsilon = 4e-15 * scale);
            }
        }
    }
}

#[test]
fn the_numbers_are_those_of_the_proven_formulas() {
    for stations in [3, 5, 11, 12, 31, 32, 300] {
        let wheel = InternalWheel::new(stations).unwrap();
        let sine = libm::sin(PI / f64::from(stations));
        for share in [-0.99, -0.5, 0.1, 0.7] {
            let crank = share * wheel.engagement_half_angle();
            let (turn, motion) = (Turn::from_radians(crank), wheel.engaged(crank).unwrap());
            for (ours, formula) in [
                (motion.velocity, velocity_ratio(&sine, &turn)),
                (motion.acceleration, acceleration_ratio(&sine, &turn)),
                (motion.jerk, jerk_ratio(&sine, &turn)),
            ] {
                approx::assert_relative_eq!(ours, formula, max_relative = 1e-12);
            }
        }
    }
}

/// The vector diagrams of the pin know nothing of an internal wheel: their crank angle is that from the far side.
#[test]
fn the_vector_diagrams_agree() {
    for stations in [3, 4, 6, 60] {
        let wheel = InternalWheel::new(stations).unwrap();
        for share in [-1.0, -0.6, 0.2, 0.9] {
            let crank = share * wheel.engagement_half_angle();
            let turn = Turn::from_radians(crank);
            let motion = pin_vectors::solve(&1.0, &wheel.centre_distance_ratio(), &turn, &1.0).unwrap();
            let terms = accelerations(&motion, &Vector2::new(-turn.cos, -turn.sin)).unwrap();
            let (ours, pin) = (wheel.engaged(crank).unwrap(), wheel.pin_in_slot(crank).unwrap());
            let outwards = motion.position / motion.position.norm();
            for (ours, theirs) in [
                (ours.velocity, motion.follower_speed),
                (ours.acceleration, terms.follower_acceleration),
                (pin.radius, motion.position.norm()),
                (pin.radius_rate, motion.sliding_velocity.dot(&outwards)),
                (pin.sliding, -motion.sliding_velocity.dot(&outwards)),
                (pin.coriolis, outwards.perp(&terms.coriolis)),
            ] {
                approx::assert_abs_diff_eq!(ours, theirs, epsilon = 1e-13 * (1.0 + ours.abs()));
            }
        }
    }
}

#[test]
fn sizes_are_those_of_the_tangent_slot() {
    for stations in [3, 4, 7, 60, 1000] {
        let wheel = InternalWheel::new(stations).unwrap();
        let (centres, mouth) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
        approx::assert_relative_eq!(libm::hypot(1.0, mouth), centres, max_relative = 1e-14);
        approx::assert_relative_eq!(wheel.pin_in_slot(0.0).unwrap().radius, centres + 1.0, max_relative = 1e-13);
        approx::assert_relative_eq!(wheel.slot_bottom_ratio(), centres + 1.0, max_relative = 1e-14);
        approx::assert_relative_eq!(wheel.slot_length_ratio(), centres + 1.0 - mouth, max_relative = 1e-11);
        let entry = wheel.pin_in_slot(-wheel.engagement_half_angle()).unwrap();
        approx::assert_relative_eq!(entry.radius, mouth, max_relative = 1e-13);
    }
}

#[test]
fn with_many_stations_it_is_a_scotch_yoke() {
    let wheel = InternalWheel::new(1000).unwrap();
    let sine = libm::sin(PI / 1000.0);
    for crank in [-1.5, -0.7, 0.0, 1.0] {
        let ratio = wheel.engaged(crank).unwrap().velocity / sine;
        approx::assert_abs_diff_eq!(ratio, libm::cos(crank), epsilon = 3.0 * sine);
    }
    approx::assert_abs_diff_eq!(wheel.dwell_fraction(), 0.5, epsilon = 1.1e-3);
}

#[test]
fn where_the_jerk_is_greatest_depends_on_the_number_of_stations() {
    for stations in 3..=1000 {
        let wheel = InternalWheel::new(stations).unwrap();
        let (peak, end) = (wheel.jerk_peak(), wheel.engagement_half_angle());
        assert_eq!(peak.angle == end, stations <= 11, "{stations}");
        assert_eq!(peak.angle == 0.0, stations >= 32, "{stations}");
        if stations <= 11 {
            let tangent = wheel.entry_acceleration();
            approx::assert_relative_eq!(peak.ratio, 3.0 * tangent * tangent, max_relative = 1e-12);
        }
    }
}
