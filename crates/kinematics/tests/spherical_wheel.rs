//! The spherical wheel against dual numbers and against vectors in space.

use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use nalgebra::Vector3;
use num_dual::{DualNum, third_derivative};
use std::f64::consts::{FRAC_PI_2, PI};

#[test]
fn what_cannot_be_built_is_said_with_what_can() {
    assert_eq!(SphericalWheel::new(2), Err(KinematicsError::Stations(2)));
    assert!(SphericalWheel::new(1001).is_err() && SphericalWheel::with_pins(6, 0).is_err());
    let message = SphericalWheel::with_pins(6, 3).unwrap_err().to_string();
    assert!(message.contains("3 pins") && message.contains("1 to 2"), "{message}");
    assert_eq!(SphericalWheel::with_pins(6, 2).unwrap().dwell_fraction(), 0.0);
}

#[test]
fn a_library_of_dual_numbers_agrees() {
    for stations in [3, 4, 6, 7, 8, 60, 1000] {
        let wheel = SphericalWheel::new(stations).unwrap();
        let tangent = libm::tan(PI / f64::from(stations));
        for share in [-1.0, -0.97, -0.4, 0.0, 0.3, 0.8, 1.0] {
            let crank = share * FRAC_PI_2;
            let motion = wheel.engaged(crank).unwrap();
            let (angle, first, second, third) = third_derivative(|t| (t.sin() * tangent).atan(), crank);
            for (ours, theirs, scale) in [
                (motion.angle, angle, wheel.half_pitch_angle()),
                (motion.velocity, first, wheel.peak_velocity()),
                (motion.acceleration, second, wheel.acceleration_peak().ratio),
                (motion.jerk, third, wheel.jerk_peak().ratio),
            ] {
                approx::assert_abs_diff_eq!(ours, theirs, epsilon = 4e-15 * scale);
            }
        }
    }
}

/// A pin on a turning driver in space, and a slot whose plane holds the wheel's axis: velocities across the slot are
/// equal, and so are accelerations with that of Coriolis.
#[test]
fn vectors_in_space_agree() {
    for stations in [3, 4, 6, 8, 60] {
        let wheel = SphericalWheel::new(stations).unwrap();
        let (sphere, alpha) = (wheel.sphere_radius_ratio(), PI / f64::from(stations));
        for crank in [-FRAC_PI_2, -1.2, -0.3, 0.5, 1.5] {
            let place = sphere
                * Vector3::new(
                    libm::cos(alpha),
                    libm::sin(alpha) * libm::sin(crank),
                    libm::sin(alpha) * libm::cos(crank),
                );
            // The driver turns about x, from z to y.
            let driver = -Vector3::x();
            let velocity = driver.cross(&place);
            let acceleration = driver.cross(&velocity);
            let axis = Vector3::z();
            let from_axis = place - axis * place.z;
            let radius = from_axis.norm();
            let (outwards, across) = (from_axis / radius, axis.cross(&from_axis) / radius);
            let speed = velocity.dot(&across) / radius;
            let sliding = velocity - axis.cross(&place) * speed;
            let coriolis = 2.0 * (axis * speed).cross(&sliding).dot(&across);
            let turning = (acceleration.dot(&across) - coriolis) / radius;

            let (motion, pin) = (wheel.engaged(crank).unwrap(), wheel.pin_in_slot(crank).unwrap());
            // Into the slot the pin moves towards the wheel's axis along z.
            let out = -sliding.z.signum() * sliding.norm();
            for (ours, theirs) in [
                (motion.angle, libm::atan2(place.y, place.x)),
                (motion.velocity, speed),
                (motion.acceleration, turning),
                (pin.radius, radius),
                (pin.radius_rate, sliding.dot(&outwards)),
                (pin.sliding, out),
                (pin.coriolis, coriolis),
            ] {
                approx::assert_abs_diff_eq!(ours, theirs, epsilon = 1e-12 * (1.0 + ours.abs()));
            }
        }
    }
}

#[test]
fn where_the_acceleration_is_greatest_depends_on_the_number_of_stations() {
    for stations in 3..=1000 {
        let wheel = SphericalWheel::new(stations).unwrap();
        let peak = wheel.acceleration_peak();
        assert_eq!(peak.angle == FRAC_PI_2, stations >= 8, "{stations}");
        let at_entry = 0.5 * libm::sin(2.0 * PI / f64::from(stations));
        assert!(peak.ratio >= at_entry * (1.0 - 1e-14), "{stations}");
        approx::assert_relative_eq!(wheel.entry_acceleration(), at_entry, max_relative = 1e-13);
    }
}

#[test]
fn with_many_stations_it_is_a_scotch_yoke() {
    let wheel = SphericalWheel::new(1000).unwrap();
    let tangent = libm::tan(PI / 1000.0);
    for crank in [-1.5, -0.7, 0.0, 1.0] {
        let ratio = wheel.engaged(crank).unwrap().velocity / tangent;
        approx::assert_abs_diff_eq!(ratio, libm::cos(crank), epsilon = 2e-5);
    }
}

#[test]
fn the_slot_reaches_as_far_as_the_pin() {
    for stations in [3, 4, 7, 60, 1000] {
        let wheel = SphericalWheel::new(stations).unwrap();
        // The meridian from the equator to the pin's greatest height, one crank radius.
        let height = libm::asin(1.0 / wheel.sphere_radius_ratio());
        let length = wheel.sphere_radius_ratio() * height;
        approx::assert_relative_eq!(wheel.slot_length_ratio(), length, max_relative = 1e-12);
        let deepest = wheel.pin_in_slot(0.0).unwrap().radius;
        approx::assert_relative_eq!(libm::hypot(deepest, 1.0), wheel.sphere_radius_ratio(), max_relative = 1e-13);
    }
}
