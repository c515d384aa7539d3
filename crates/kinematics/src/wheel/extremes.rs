//! What the greatest acceleration of the wheel is, and the number on which its place depends.

use super::Wheel;

/// Where the acceleration is greatest, and how great.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationPeak {
    /// Crank angle of the peak of deceleration, in radians; the acceleration has its peak at minus this angle.
    pub angle: f64,
    /// Size of the acceleration over the square of the driver's speed, dimensionless.
    pub ratio: f64,
}

/// γ = (1 + sin² α) / (2 sin α), dimensionless, never below 1. Work::Jazar2003, Eq. (5.33).
///
/// ```
/// use geneva_kinematics::wheel::{Wheel, gamma};
///
/// assert!((gamma(&Wheel::new(6)?) - 5.0 / 4.0).abs() < 1e-15); // (1 + 1/4) / 1
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub fn gamma(wheel: &Wheel) -> f64 {
    wheel.constants.gamma.hi
}
