//! The motion over one engagement, and the forces on the way.

use crate::FigureError;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{DynamicsError, Parameters};

/// Steps from entry to exit that are kept; an even number, so that one ends on the line of centres.
pub(super) const STEPS: u32 = 180;
/// Relative error of the motion: far below what a series is written to.
const TOLERANCE: f64 = 1e-13;

/// What acts at one instant of an engagement, over the driving torque K.
#[derive(Clone, Copy, Debug)]
pub(super) struct EngagementState {
    /// θ, in radians.
    pub theta: f64,
    /// θ', in radians per unit of time.
    pub speed: f64,
    /// F R / K; positive where the pin drives the follower.
    pub normal: f64,
    /// Size of the friction's torque over K, −τ₂ / K, never negative.
    pub friction: f64,
    /// What stands between the bars of the equation of motion, C θ'² + D θ'', over E = K / I_f.
    pub bars: f64,
    /// φ'' over the same.
    pub follower_acceleration: f64,
}

impl EngagementState {
    /// The forces at an angle and a speed.
    pub(super) fn new(parameters: &Parameters, theta: f64, speed: f64) -> Result<Self, DynamicsError> {
        let forces = parameters.contact_forces(theta, speed)?;
        let acceleration = parameters.acceleration(theta, speed)?.value;
        let (torque, drive) = (parameters.torque(), parameters.drive());
        Ok(Self {
            theta,
            speed,
            normal: forces.normal_moment / torque,
            friction: forces.friction_torque / torque,
            bars: parameters.coefficients(theta).between_the_bars(&speed, &acceleration) / drive,
            follower_acceleration: forces.follower_acceleration / drive,
        })
    }
}

/// θ and θ' of a driver that has this speed (≥ 0) as a pin enters, at equal steps of θ from entry to exit.
///
/// The speed at an angle is that at the end of an engagement that ends there.
pub(crate) fn speeds(parameters: &Parameters, entry_speed: f64) -> Result<Vec<[f64; 2]>, FigureError> {
    let half = parameters.mechanism().engagement_half_angle();
    let at = |step: u32| {
        // Counted from the line of centres, so that both halves have the same angles.
        let theta = half * ((2.0 * f64::from(step) - f64::from(STEPS)) / f64::from(STEPS));
        Ok([theta, if step == 0 { entry_speed } else { speed_at(parameters, entry_speed, theta)? }])
    };
    (0..=STEPS).map(at).collect()
}

/// θ' at a driver angle behind the entry (θ in radians), of a driver that has this speed (≥ 0) as the pin enters.
///
/// # Errors
///
/// [`FigureError::Dynamics`] if the angle is not behind the entry, or if the motion cannot be followed so far.
pub(super) fn speed_at(parameters: &Parameters, entry_speed: f64, theta: f64) -> Result<f64, FigureError> {
    let turned = parameters.mechanism().engagement_half_angle() + theta;
    Ok(Engagement::reset_after(parameters, turned, TOLERANCE)?.passage(entry_speed)?.end_speed())
}
