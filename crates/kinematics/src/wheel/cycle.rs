//! The wheel over whole turns of its driver: advance, dwell, advance.

use super::Wheel;
use super::accurate::Double;
use crate::error::{KinematicsError, size};
use crate::indexing::Indexing;

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
    pub(super) fn engaged_at(&self, crank: Double) -> Result<Motion, KinematicsError> {
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
        Ok((speed * self.peak_velocity(), speed * speed * self.acceleration_peak().ratio))
    }
}
