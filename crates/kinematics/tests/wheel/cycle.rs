//! Is the motion what the proven formulas give, and does the angle go on from turn to turn?

use geneva_kinematics::indexing::{Indexing, WheelMotion};
use geneva_kinematics::pin_slot::{pin_from_pivot, velocity_ratio};
use geneva_kinematics::wheel::{Wheel, acceleration_ratio, jerk_ratio};
use geneva_kinematics::{KinematicsError, Turn};
use std::f64::consts::PI;

#[test]
fn angles_outside_the_domain_are_refused() {
    let wheel = Wheel::new(6).unwrap();
    for crank in [1.5, -1.5, f64::NAN, f64::INFINITY] {
        assert!(matches!(wheel.engaged(crank), Err(KinematicsError::OutsideEngagement { .. })), "{crank}");
    }
    assert!(wheel.motion(0, 3.2).is_err() && wheel.motion(0, f64::NAN).is_err());
    assert!(wheel.engaged(wheel.engagement_half_angle()).is_ok());
}

#[test]
fn the_motion_is_what_the_proven_formulas_give() {
    for stations in [3, 4, 5, 8, 60, 1000] {
        let wheel = Wheel::new(stations).unwrap();
        let ratio = wheel.centre_distance_ratio();
        let peak = wheel.acceleration_peak().ratio;
        for step in -19..=19 {
            let crank = wheel.engagement_half_angle() * f64::from(step) / 20.0;
            let (motion, turn) = (wheel.engaged(crank).unwrap(), Turn::from_radians(crank));
            let pin = pin_from_pivot(&ratio, &turn);
            approx::assert_relative_eq!(motion.angle, libm::atan2(pin.y, pin.x), max_relative = 1e-12);
            approx::assert_relative_eq!(motion.velocity, velocity_ratio(&ratio, &turn), max_relative = 1e-11);
            let acceleration = acceleration_ratio(&ratio, &turn);
            approx::assert_relative_eq!(motion.acceleration, acceleration, max_relative = 1e-11);
            let jerk = jerk_ratio(&ratio, &turn);
            approx::assert_relative_eq!(motion.jerk, jerk, max_relative = 1e-11, epsilon = 1e-11 * peak);
        }
    }
}

#[test]
fn the_angle_goes_on_without_a_gap_and_without_running_error() {
    for (stations, pins) in [(3, 1), (4, 1), (4, 4), (6, 3), (7, 2)] {
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        let whole = |m: WheelMotion| m.stations as f64 * 2.0 * wheel.half_pitch_angle() + m.angle;
        let mut last = f64::NEG_INFINITY;
        for turns in [0, 1] {
            for step in -500..500 {
                let angle = whole(wheel.motion(turns, PI * f64::from(step) / 500.0).unwrap());
                assert!(angle >= last - 1e-12, "{stations} stations, {pins} pins, step {step}: {angle} after {last}");
                last = angle;
            }
        }
        let far = 1_000_000_007;
        let (near, away) = (wheel.motion(0, 0.1).unwrap(), wheel.motion(far, 0.1).unwrap());
        assert_eq!(away.stations - near.stations, far * i64::from(pins));
        assert_eq!(away.angle, near.angle);
    }
}
