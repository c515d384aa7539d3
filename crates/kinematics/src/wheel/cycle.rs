//! The wheel over whole turns of its driver: advance, dwell, advance.

use super::Wheel;
use super::accurate::{Double, fraction_of_pi};
use crate::error::{KinematicsError, size};
use std::f64::consts::PI;

/// Whether a pin is in a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// A pin is in a slot.
    Advance,
    /// The wheel is locked.
    Dwell,
}

/// The wheel at one crank angle, for a driver of constant speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Advance or dwell.
    pub phase: Phase,
    /// Whole stations that the wheel has passed: the middle of the last advance begun, or the dwell behind it.
    pub stations: i64,
    /// Wheel angle from there in radians, between −α and α; the whole angle is `stations` times 2α and this.
    pub angle: f64,
    /// Angular velocity over the driver's, dimensionless.
    pub velocity: f64,
    /// Angular acceleration over the square of the driver's speed, dimensionless.
    pub acceleration: f64,
    /// Jerk over the cube of the driver's speed, dimensionless.
    pub jerk: f64,
}

impl Wheel {
    /// Position, velocity, acceleration and jerk while the pin is at this crank angle, from the line of centres.
    ///
    /// Both ends of the engagement belong to it. Work::Jazar2003, Eqs. (5.30) to (5.32).
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] beyond the ends, and for what is not finite.
    pub fn engaged(&self, crank: f64) -> Result<Motion, KinematicsError> {
        self.engaged_at(Double::from(crank))
    }

    /// The angular velocity over the driver's alone, dimensionless, as [`engaged`](Self::engaged) gives it, where speed
    /// matters.
    ///
    /// # Errors
    ///
    /// Those of [`engaged`](Self::engaged).
    #[inline]
    pub fn velocity_ratio(&self, crank: f64) -> Result<f64, KinematicsError> {
        let (size, most) = (crank.abs(), self.engagement_half_angle());
        if size <= most {
            Ok(self.constants.velocity(Double::from(size)))
        } else {
            Err(KinematicsError::OutsideEngagement { asked: crank, most })
        }
    }

    /// The motion at a crank angle of twice the precision.
    fn engaged_at(&self, crank: Double) -> Result<Motion, KinematicsError> {
        let most = self.engagement_half_angle();
        if !(-most..=most).contains(&crank.hi) {
            return Err(KinematicsError::OutsideEngagement { asked: crank.hi, most });
        }
        let before = crank.hi < 0.0;
        let size = if before { crank.negated() } else { crank };
        let (angle, acceleration, jerk) = self.constants.angle_acceleration_jerk(size);
        Ok(Motion {
            phase: Phase::Advance,
            stations: 0,
            angle: if before { -angle } else { angle },
            velocity: self.constants.velocity(size),
            // No negative zero on the line of centres.
            acceleration: if before { acceleration } else { 0.0 - acceleration },
            jerk,
        })
    }

    /// The same after `turns` whole turns of the driver and `crank` radians, −π to π, of the next.
    ///
    /// At crank angle zero a pin is on the line of centres. Turns are counted in whole numbers, so the wheel's angle
    /// has no running error however many there are. At the very ends of an engagement the wheel is in it.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Turn`] for a crank angle beyond half a turn, and for what is not finite.
    pub fn at(&self, turns: i64, crank: f64) -> Result<Motion, KinematicsError> {
        if !(-PI..=PI).contains(&crank) {
            return Err(KinematicsError::Turn(crank));
        }
        let pitch = 2.0 * PI / f64::from(self.pins());
        let pin = libm::round(crank / pitch);
        let advances = turns.saturating_mul(i64::from(self.pins())).saturating_add(pin as i64);
        let behind = fraction_of_pi(2 * libm::fabs(pin) as u32, self.pins());
        let from_pin = Double::from(crank).minus(if pin < 0.0 { behind.negated() } else { behind });
        match self.engaged_at(from_pin) {
            Ok(motion) => Ok(Motion { stations: advances, ..motion }),
            Err(_) => {
                let angle = if from_pin.hi > 0.0 { self.half_pitch_angle() } else { -self.half_pitch_angle() };
                let (velocity, acceleration, jerk) = (0.0, 0.0, 0.0);
                Ok(Motion { phase: Phase::Dwell, stations: advances, angle, velocity, acceleration, jerk })
            }
        }
    }

    /// Peak angular speed in rad/s and peak angular acceleration in rad/s² for a driver of this speed in rad/s.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a speed that is not positive and finite.
    pub fn peaks(&self, driver_speed: f64) -> Result<(f64, f64), KinematicsError> {
        let speed = size("driver speed", driver_speed)?;
        Ok((speed * super::peak_velocity(self), speed * speed * super::acceleration_peak(self).ratio))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Turn;
    use crate::pin_slot::{pin_from_pivot, velocity_ratio};
    use crate::wheel::{acceleration_peak, acceleration_ratio, jerk_ratio};

    #[test]
    fn angles_outside_the_domain_are_refused() {
        let wheel = Wheel::new(6).unwrap();
        for crank in [1.5, -1.5, f64::NAN, f64::INFINITY] {
            assert!(matches!(wheel.engaged(crank), Err(KinematicsError::OutsideEngagement { .. })), "{crank}");
        }
        assert!(wheel.at(0, 3.2).is_err() && wheel.at(0, f64::NAN).is_err());
        assert!(wheel.engaged(wheel.engagement_half_angle()).is_ok());
    }

    #[test]
    fn the_motion_is_what_the_proven_formulas_give() {
        for stations in [3, 4, 5, 8, 60, 1000] {
            let wheel = Wheel::new(stations).unwrap();
            let ratio = wheel.centre_distance_ratio();
            let peak = acceleration_peak(&wheel).ratio;
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
            let whole = |m: Motion| m.stations as f64 * 2.0 * wheel.half_pitch_angle() + m.angle;
            let mut last = f64::NEG_INFINITY;
            for turns in [0, 1] {
                for step in -500..500 {
                    let angle = whole(wheel.at(turns, PI * f64::from(step) / 500.0).unwrap());
                    assert!(
                        angle >= last - 1e-12,
                        "{stations} stations, {pins} pins, step {step}: {angle} after {last}"
                    );
                    last = angle;
                }
            }
            let far = 1_000_000_007;
            let (near, away) = (wheel.at(0, 0.1).unwrap(), wheel.at(far, 0.1).unwrap());
            assert_eq!(away.stations - near.stations, far * i64::from(pins));
            assert_eq!(away.angle, near.angle);
        }
    }
}
