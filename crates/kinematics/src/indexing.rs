//! What every Geneva wheel does, be it external, internal or spherical: it moves by a station while a pin is in a slot,
//! and rests until the next pin enters.
//!
//! Notation: θ crank angle from the middle of the engagement, φ wheel angle from there; α = π/N half the angle between
//! slots, a the crank radius. The driver turns at constant speed, and θ and φ grow as driver and wheel turn.

use crate::KinematicsError;
use crate::error::size;
use crate::wheel::{AccelerationPeak, Motion, Phase};
use std::f64::consts::{PI, TAU};

/// Where the jerk is greatest while a pin is in a slot, and how great.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JerkPeak {
    /// Crank angle in radians, zero or positive; at its negative the jerk is the same.
    pub angle: f64,
    /// Size of the jerk over the cube of the driver's speed, dimensionless.
    pub ratio: f64,
}

/// The pin in its slot at one crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinInSlot {
    /// Distance of the pin's centre from the wheel's axis, in crank radii.
    pub radius: f64,
    /// Rate of change of that distance with the crank angle, in crank radii per radian.
    pub radius_rate: f64,
    /// Velocity of the pin along the slot over its speed on the crank circle, dimensionless. Negative while it goes in,
    /// positive while it comes out.
    pub sliding: f64,
    /// Coriolis acceleration of the pin over its acceleration on the crank circle, dimensionless: twice the wheel's
    /// velocity ratio times [`radius_rate`](Self::radius_rate). Positive in the sense in which the wheel turns.
    pub coriolis: f64,
}

/// A Geneva wheel with its driver.
pub trait Indexing {
    /// Number of slots, N.
    fn stations(&self) -> u32;

    /// Number of evenly spaced pins on the driver.
    fn pins(&self) -> u32;

    /// Crank angle at which a pin enters and leaves, in radians from the middle of the engagement.
    fn engagement_half_angle(&self) -> f64;

    /// Position, velocity, acceleration and jerk while a pin is in a slot. Both ends of the engagement belong to it.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] beyond the ends, and for what is not finite.
    fn engaged(&self, crank: f64) -> Result<Motion, KinematicsError>;

    /// The pin in its slot.
    ///
    /// # Errors
    ///
    /// As for [`engaged`](Self::engaged).
    fn pin_in_slot(&self, crank: f64) -> Result<PinInSlot, KinematicsError>;

    /// Crank angle in radians at which the wheel is at this angle, from the middle of the index, in radians too: from −α to α.
    ///
    /// Near the ends a small change of the wheel's angle is a large one of the crank's: half of the digits are left there.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::WheelAngle`] beyond a half pitch angle, and for what is not finite.
    fn crank_at(&self, wheel_angle: f64) -> Result<f64, KinematicsError>;

    /// Greatest velocity ratio, in the middle of the engagement, dimensionless.
    fn peak_velocity(&self) -> f64;

    /// Size of the acceleration ratio as a pin enters and as it leaves, dimensionless.
    fn entry_acceleration(&self) -> f64;

    /// Where the acceleration is greatest, and how great; at the end of the engagement if it is greatest there.
    fn acceleration_peak(&self) -> AccelerationPeak;

    /// Where the jerk is greatest while a pin is in a slot, and how great.
    fn jerk_peak(&self) -> JerkPeak;

    /// α, half the angle between successive slots, in radians: π/N.
    fn half_pitch_angle(&self) -> f64 {
        PI / f64::from(self.stations())
    }

    /// Part of the driver's turn during which the wheel moves, all pins together, dimensionless.
    fn motion_fraction(&self) -> f64 {
        f64::from(self.pins()) * self.engagement_half_angle() / PI
    }

    /// Part of the driver's turn during which the wheel stands still, dimensionless.
    fn dwell_fraction(&self) -> f64 {
        1.0 - self.motion_fraction()
    }

    /// Time of one index in seconds, for a driver of this angular speed in rad/s.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a speed that is not positive and finite.
    fn indexing_time(&self, driver_speed: f64) -> Result<f64, KinematicsError> {
        Ok(2.0 * self.engagement_half_angle() / size("driver speed", driver_speed)?)
    }

    /// Time of one dwell in seconds, for a driver of this angular speed in rad/s.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a speed that is not positive and finite.
    fn dwell_time(&self, driver_speed: f64) -> Result<f64, KinematicsError> {
        Ok(TAU / size("driver speed", driver_speed)? * self.dwell_fraction() / f64::from(self.pins()))
    }

    /// The wheel after `turns` whole turns of the driver and `crank` radians, −π to π, of the next.
    ///
    /// At crank angle zero a pin is in the middle of its engagement. At the very ends of an engagement the wheel is in it.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Turn`] for a crank angle beyond half a turn, and for what is not finite.
    fn at(&self, turns: i64, crank: f64) -> Result<Motion, KinematicsError> {
        if !(-PI..=PI).contains(&crank) {
            return Err(KinematicsError::Turn(crank));
        }
        let (pin, from_pin) = self.nearest_pin(crank);
        let stations = turns.saturating_mul(i64::from(self.pins())).saturating_add(pin);
        Ok(self.engaged(from_pin).map_or_else(
            |_| {
                let angle = if from_pin > 0.0 { self.half_pitch_angle() } else { -self.half_pitch_angle() };
                Motion { phase: Phase::Dwell, stations, angle, velocity: 0.0, acceleration: 0.0, jerk: 0.0 }
            },
            |motion| Motion { stations, ..motion },
        ))
    }

    /// Which pin is nearest to the middle of its engagement at this crank angle, in radians, and how far past it: the
    /// pins are counted against the driver's sense from the one that is there at zero.
    fn nearest_pin(&self, crank: f64) -> (i64, f64) {
        let pitch = TAU / f64::from(self.pins());
        let pin = libm::round(crank / pitch);
        (pin as i64, crank - pin * pitch)
    }
}

/// A wheel angle in radians, if it is within a half pitch angle.
pub(crate) fn within_half_pitch(wheel: &dyn Indexing, asked: f64) -> Result<f64, KinematicsError> {
    let most = wheel.half_pitch_angle();
    if (-most..=most).contains(&asked) { Ok(asked) } else { Err(KinematicsError::WheelAngle { asked, most }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::internal_wheel::InternalWheel;
    use crate::spherical_wheel::SphericalWheel;
    use crate::wheel::Wheel;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

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
            let whole = |motion: Motion| motion.stations as f64 * 2.0 * wheel.half_pitch_angle() + motion.angle;
            let mut last = whole(wheel.at(0, -PI).unwrap());
            for (turns, step) in [0, 1].into_iter().flat_map(|turns| (-90..=90).map(move |step| (turns, step))) {
                let angle = whole(wheel.at(turns, PI * f64::from(step) / 90.0).unwrap());
                assert!(angle >= last - 1e-12, "{} stations, step {step}: {angle} after {last}", wheel.stations());
                last = angle;
            }
            assert!(wheel.at(0, 3.2).is_err() && wheel.at(0, f64::NAN).is_err());
            assert!(wheel.dwell_time(0.0).is_err() && wheel.indexing_time(f64::NAN).is_err());
        }
    }
}
