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
    /// Whether a pin moves the wheel, or the wheel dwells.
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
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// let middle = wheel.engaged(0.0)?; // pin on the line of centres
    /// assert!((middle.velocity - 1.0).abs() < 1e-15); // 1 / (k − 1) with k = 2
    /// assert_eq!((middle.angle, middle.acceleration), (0.0, 0.0));
    /// let entry = wheel.engaged(-wheel.engagement_half_angle())?; // without a blow
    /// assert!(entry.velocity.abs() < 1e-15);
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
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
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// assert!((wheel.velocity_ratio(0.0)? - 1.0).abs() < 1e-15); // 1 / (k − 1) with k = 2
    /// assert_eq!(wheel.velocity_ratio(-0.5)?, wheel.velocity_ratio(0.5)?); // even in the crank angle
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`engaged`](Self::engaged).
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

    /// The motion after `turns` whole turns of the driver and `crank` radians, −π to π, of the next.
    ///
    /// At crank angle zero a pin is on the line of centres. Turns are counted in integers, so the wheel's angle
    /// has no running error however many there are. At the very ends of an engagement the wheel is in it.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Phase, Wheel};
    /// use std::f64::consts::PI;
    ///
    /// let wheel = Wheel::new(4)?;
    /// let middle = wheel.at(3, 0.0)?; // three turns of the driver: three stations
    /// assert_eq!((middle.phase, middle.stations, middle.angle), (Phase::Advance, 3, 0.0));
    /// let dwell = wheel.at(3, 2.0)?; // 2 rad later the wheel stands, half a station on
    /// assert_eq!((dwell.phase, dwell.stations, dwell.velocity), (Phase::Dwell, 3, 0.0));
    /// assert!((dwell.angle - PI / 4.0).abs() < 1e-15); // rad
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
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
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// let (slow, fast) = (wheel.peaks(10.0)?, wheel.peaks(20.0)?); // driver speeds in rad/s
    /// assert!((slow.0 - 10.0).abs() < 1e-13); // rad/s: sin α / (1 − sin α) = 1 with six stations
    /// assert!((fast.1 / slow.1 - 4.0).abs() < 1e-13); // accelerations go as the square of the speed
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a speed that is not positive and finite.
    pub fn peaks(&self, driver_speed: f64) -> Result<(f64, f64), KinematicsError> {
        let speed = size("driver speed", driver_speed)?;
        Ok((speed * super::peak_velocity(self), speed * speed * super::acceleration_peak(self).ratio))
    }
}
