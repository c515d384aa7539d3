//! The greatest velocity and acceleration of the wheel, in closed form.

use super::Wheel;

/// Where the acceleration is greatest, and how great.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationPeak {
    /// Crank angle of the peak of deceleration, in radians; the acceleration has its peak at minus this angle.
    pub angle: f64,
    /// Size of the acceleration over the square of the driver's speed, dimensionless.
    pub ratio: f64,
}

/// Peak of the velocity ratio, on the line of centres: sin α / (1 − sin α), dimensionless. Work::Jazar2003, example (d).
///
/// ```
/// use geneva_kinematics::wheel::{Wheel, peak_velocity};
///
/// assert!((peak_velocity(&Wheel::new(6)?) - 1.0).abs() < 1e-15); // sin 30° = 1/2
/// assert!((peak_velocity(&Wheel::new(4)?) - (1.0 + 2_f64.sqrt())).abs() < 1e-15);
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub fn peak_velocity(wheel: &Wheel) -> f64 {
    wheel.constants.sine.over(wheel.constants.rest).hi
}

/// Size of the acceleration ratio as the pin enters and as it leaves, tan α, dimensionless: it jumps from and to zero.
///
/// ```
/// use geneva_kinematics::wheel::{Wheel, entry_acceleration};
///
/// assert!((entry_acceleration(&Wheel::new(4)?) - 1.0).abs() < 1e-15); // tan 45°
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub fn entry_acceleration(wheel: &Wheel) -> f64 {
    wheel.constants.sine.over(wheel.constants.cosine).hi
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

/// The peak of the acceleration: cos θ = (−γ + √(γ² + 8)) / 2. Work::Jazar2003, Eqs. (5.33), (5.34) and (5.32).
///
/// It lies inside the engagement for every N.
///
/// ```
/// use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration};
///
/// let wheel = Wheel::new(4)?;
/// let peak = acceleration_peak(&wheel);
/// assert!(peak.ratio > entry_acceleration(&wheel)); // it is not at the ends of the engagement,
/// assert!(wheel.engaged(peak.angle)?.jerk.abs() < 1e-12); // so the acceleration is level there
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub fn acceleration_peak(wheel: &Wheel) -> AccelerationPeak {
    let peak = wheel.constants.peak;
    let (_, ratio, _) = wheel.constants.angle_acceleration_jerk(peak);
    AccelerationPeak { angle: peak.hi, ratio }
}
