//! The greatest velocity and acceleration of the wheel, in closed form.

use super::Wheel;

/// Where the acceleration is greatest, and how great.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationPeak {
    /// Crank angle of the peak of deceleration, in radians; that of acceleration is its negative.
    pub angle: f64,
    /// Size of the acceleration over the square of the driver's speed, dimensionless.
    pub ratio: f64,
}

/// Peak of the velocity ratio, on the line of centres: sin α / (1 − sin α), dimensionless. Work::Jazar2003, example (d).
pub fn peak_velocity(wheel: &Wheel) -> f64 {
    wheel.constants.sine.over(wheel.constants.rest).hi
}

/// Size of the acceleration ratio as the pin enters and as it leaves, tan α, dimensionless: it jumps from and to zero.
pub fn entry_acceleration(wheel: &Wheel) -> f64 {
    wheel.constants.sine.over(wheel.constants.cosine).hi
}

/// γ = (1 + sin² α) / (2 sin α), dimensionless, never below 1. Work::Jazar2003, Eq. (5.33).
pub fn gamma(wheel: &Wheel) -> f64 {
    wheel.constants.gamma.hi
}

/// The peak of the acceleration: cos θ = (−γ + √(γ² + 8)) / 2. Work::Jazar2003, Eqs. (5.33), (5.34) and (5.32).
///
/// It lies inside the engagement for every N.
pub fn acceleration_peak(wheel: &Wheel) -> AccelerationPeak {
    let peak = wheel.constants.peak;
    let (_, ratio, _) = wheel.constants.angle_acceleration_jerk(peak);
    AccelerationPeak { angle: peak.hi, ratio }
}
