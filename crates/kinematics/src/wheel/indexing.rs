//! The external wheel as one of the three kinds, and the pin in its slot.

use super::Wheel;
use crate::indexing::{Indexing, JerkPeak, PinInSlot, within_half_pitch};
use crate::wheel::{AccelerationPeak, Motion};
use crate::{KinematicsError, Turn, pin_slot};

/// Peak of the jerk, on the line of centres: sin α (1 + sin α) / (1 − sin α)³, dimensionless.
///
/// It is the greatest of the engagement for every N: [`wheel_jerk_proofs`](crate::wheel_jerk_proofs). As the pin enters
/// and leaves the acceleration jumps, and the jerk has no finite value.
///
/// ```
/// use geneva_kinematics::wheel::{Wheel, peak_jerk};
///
/// assert!((peak_jerk(&Wheel::new(6)?) - 6.0).abs() < 1e-14); // (1/2) (3/2) / (1/2)³
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub fn peak_jerk(wheel: &Wheel) -> f64 {
    let (sine, rest) = (wheel.constants.sine, wheel.constants.rest);
    sine.plus(sine.times(sine)).over(rest.times(rest).times(rest)).hi
}

impl Indexing for Wheel {
    fn stations(&self) -> u32 {
        Wheel::stations(self)
    }

    fn pins(&self) -> u32 {
        Wheel::pins(self)
    }

    fn half_pitch_angle(&self) -> f64 {
        Wheel::half_pitch_angle(self)
    }

    fn engagement_half_angle(&self) -> f64 {
        Wheel::engagement_half_angle(self)
    }

    fn engaged(&self, crank: f64) -> Result<Motion, KinematicsError> {
        Wheel::engaged(self, crank)
    }

    /// With the distance from the law of cosines as √((k − 1)² + 2 k vers θ), in which nothing cancels.
    fn pin_in_slot(&self, crank: f64) -> Result<PinInSlot, KinematicsError> {
        let velocity = self.velocity_ratio(crank)?;
        let (rest, sine) = (self.constants.rest.hi, self.constants.sine.hi);
        let (turn, half) = (Turn::from_radians(crank), libm::sin(0.5 * crank));
        let radius = (rest * rest + 4.0 * sine * half * half).sqrt() / sine;
        let rate = pin_slot::sliding_product(&Wheel::centre_distance_ratio(self), &turn) / radius;
        Ok(PinInSlot { radius, radius_rate: rate, sliding: rate, coriolis: 2.0 * velocity * rate })
    }

    /// By the law of sines, sin(θ + φ) = sin φ / sin α.
    fn crank_at(&self, wheel_angle: f64) -> Result<f64, KinematicsError> {
        let (angle, most) = (within_half_pitch(self, wheel_angle)?, Wheel::engagement_half_angle(self));
        let sine = (libm::sin(angle) / self.constants.sine.hi).clamp(-1.0, 1.0);
        Ok((libm::asin(sine) - angle).clamp(-most, most))
    }

    fn peak_velocity(&self) -> f64 {
        super::peak_velocity(self)
    }

    fn entry_acceleration(&self) -> f64 {
        super::entry_acceleration(self)
    }

    fn acceleration_peak(&self) -> AccelerationPeak {
        super::acceleration_peak(self)
    }

    fn jerk_peak(&self) -> JerkPeak {
        JerkPeak { angle: 0.0, ratio: peak_jerk(self) }
    }

    fn motion_fraction(&self) -> f64 {
        Wheel::motion_fraction(self)
    }

    fn dwell_fraction(&self) -> f64 {
        Wheel::dwell_fraction(self)
    }

    fn indexing_time(&self, driver_speed: f64) -> Result<f64, KinematicsError> {
        Wheel::indexing_time(self, driver_speed)
    }

    fn dwell_time(&self, driver_speed: f64) -> Result<f64, KinematicsError> {
        Wheel::dwell_time(self, driver_speed)
    }

    fn at(&self, turns: i64, crank: f64) -> Result<Motion, KinematicsError> {
        Wheel::at(self, turns, crank)
    }
}
