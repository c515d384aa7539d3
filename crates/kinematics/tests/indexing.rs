//! What holds for any kind of wheel: rest at both ends, peaks, rates, one station for each pin.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::{Indexing, WheelMotion};
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::{PI, TAU};

/// Wheels of every kind and many numbers.
fn wheels() -> Vec<Box<dyn Indexing>> {
    let mut wheels: Vec<Box<dyn Indexing>> = Vec::new();
    for stations in (3..=36).chain([60, 200, 1000]) {
        wheels.push(Box::new(InternalWheel::new(stations).unwrap()));
        wheels.push(Box::new(SphericalWheel::new(stations).unwrap()));
        wheels.push(Box::new(SphericalWheel::with_pins(stations, 2).unwrap()));
        wheels.extend((1..=6).filter_map(|pins| Some(Box::new(Wheel::with_pins(stations, pins).ok()?) as Box<_>)));
    }
    wheels
}

#[test]
fn every_wheel_starts_and_stops_at_rest_and_passes_one_station() {
    for wheel in wheels() {
        let end = wheel.engagement_half_angle();
        for sense in [-1.0, 1.0] {
            let motion = wheel.engaged(sense * end).unwrap();
            assert_abs_diff_eq!(motion.velocity, 0.0, epsilon = 1e-15);
            assert_relative_eq!(motion.angle, sense * wheel.half_pitch_angle(), max_relative = 1e-13);
            let entry = -sense * wheel.entry_acceleration();
            assert_relative_eq!(motion.acceleration, entry, max_relative = 1e-11);
            let pin = wheel.pin_in_slot(sense * end).unwrap();
            assert_relative_eq!(pin.sliding, sense, max_relative = 1e-11);
            assert_abs_diff_eq!(pin.coriolis, 0.0, epsilon = 1e-15);
        }
        let middle = wheel.engaged(0.0).unwrap();
        assert_eq!([middle.angle, middle.acceleration], [0.0, 0.0]);
        assert_relative_eq!(middle.velocity, wheel.peak_velocity(), max_relative = 1e-13);
        for crank in [end * (1.0 + 1e-9), -1.01 * end, f64::NAN, f64::INFINITY] {
            assert!(matches!(wheel.engaged(crank), Err(KinematicsError::OutsideEngagement { .. })), "{crank}");
            assert!(wheel.pin_in_slot(crank).is_err(), "{crank}");
        }
    }
}

#[test]
fn the_peaks_are_the_greatest_of_a_fine_scan() {
    for wheel in wheels() {
        let (acceleration, jerk) = (wheel.acceleration_peak(), wheel.jerk_peak());
        let at = |angle: f64| wheel.engaged(angle).unwrap();
        assert_relative_eq!(at(acceleration.angle).acceleration, -acceleration.ratio, max_relative = 1e-11);
        assert_relative_eq!(at(jerk.angle).jerk.abs(), jerk.ratio, max_relative = 1e-11);
        let (mut greatest, mut sharpest) = (0.0_f64, 0.0_f64);
        for step in 0..=4000 {
            let motion = at(wheel.engagement_half_angle() * f64::from(step) / 4000.0);
            assert!(motion.velocity <= wheel.peak_velocity() * (1.0 + 1e-12));
            greatest = greatest.max(-motion.acceleration);
            sharpest = sharpest.max(motion.jerk.abs());
        }
        for (peak, scan) in [(acceleration.ratio, greatest), (jerk.ratio, sharpest)] {
            assert!(scan <= peak * (1.0 + 1e-12), "{} stations: {scan} above {peak}", wheel.stations());
            // Peaks are flat: of four thousand steps one is near enough.
            assert!(scan >= peak * (1.0 - 1e-4), "{} stations: {scan} below {peak}", wheel.stations());
        }
    }
}

#[test]
fn each_ratio_is_the_rate_of_the_one_before_and_the_radius_has_its_own() {
    for wheel in wheels() {
        let end = wheel.engagement_half_angle();
        let step = 1e-5 * end;
        for share in [-0.9, -0.5, -0.1, 0.2, 0.6, 0.95] {
            let (crank, at) = (share * end, |by: f64| wheel.engaged(share * end + by).unwrap());
            let (before, here, after) = (at(-step), at(0.0), at(step));
            let most = [wheel.peak_velocity(), wheel.acceleration_peak().ratio, wheel.jerk_peak().ratio];
            for (rate, [low, high], scale) in [
                (here.velocity, [before.angle, after.angle], most[0]),
                (here.acceleration, [before.velocity, after.velocity], most[1]),
                (here.jerk, [before.acceleration, after.acceleration], most[2]),
            ] {
                assert_abs_diff_eq!(rate, (high - low) / (2.0 * step), epsilon = 1e-6 * scale);
            }
            let radius = |by: f64| wheel.pin_in_slot(crank + by).unwrap().radius;
            let pin = wheel.pin_in_slot(crank).unwrap();
            let rate = (radius(step) - radius(-step)) / (2.0 * step);
            assert_abs_diff_eq!(pin.radius_rate, rate, epsilon = 1e-6);
            assert_relative_eq!(pin.coriolis, 2.0 * here.velocity * pin.radius_rate, max_relative = 1e-12);
            // Across the slot the pin moves with the wheel, along it it slides: both make up its speed.
            let across = pin.radius * here.velocity;
            assert_relative_eq!(libm::hypot(across, pin.sliding), 1.0, max_relative = 1e-10);
        }
    }
}

#[test]
fn the_crank_is_found_again_from_the_wheel() {
    for wheel in wheels() {
        for share in [-1.0, -0.9, -0.2, 0.0, 0.4, 0.97, 1.0] {
            let crank = share * wheel.engagement_half_angle();
            let angle = wheel.engaged(crank).unwrap().angle;
            let found = wheel.crank_at(angle.clamp(-wheel.half_pitch_angle(), wheel.half_pitch_angle())).unwrap();
            assert_abs_diff_eq!(found, crank, epsilon = if share.abs() < 0.99 { 1e-12 } else { 1e-6 });
            assert!(wheel.engaged(found).is_ok());
        }
        for angle in [1.001 * wheel.half_pitch_angle(), -2.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(wheel.crank_at(angle), Err(KinematicsError::WheelAngle { .. })), "{angle}");
        }
    }
}

#[test]
fn motion_and_dwell_make_a_turn_and_the_angle_has_no_gap() {
    for wheel in wheels() {
        assert_relative_eq!(wheel.motion_fraction() + wheel.dwell_fraction(), 1.0, max_relative = 1e-15);
        let cycle = wheel.indexing_time(3.0).unwrap() + wheel.dwell_time(3.0).unwrap();
        assert_relative_eq!(cycle * f64::from(wheel.pins()), TAU / 3.0, max_relative = 1e-14);
        let whole = |motion: WheelMotion| motion.stations as f64 * 2.0 * wheel.half_pitch_angle() + motion.angle;
        let mut last = whole(wheel.motion(0, -PI).unwrap());
        for (turns, step) in [0, 1].into_iter().flat_map(|turns| (-90..=90).map(move |step| (turns, step))) {
            let angle = whole(wheel.motion(turns, PI * f64::from(step) / 90.0).unwrap());
            assert!(angle >= last - 1e-12, "{} stations, step {step}: {angle} after {last}", wheel.stations());
            last = angle;
        }
        assert!(wheel.motion(0, 3.2).is_err() && wheel.motion(0, f64::NAN).is_err());
        assert!(wheel.dwell_time(0.0).is_err() && wheel.indexing_time(f64::NAN).is_err());
    }
}
