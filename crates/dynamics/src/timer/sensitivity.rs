//! How much the mean speed changes with what drives and brakes the escapement.

use super::TimerError;
use crate::steady::Engagement;
use crate::{Inertias, Parameters};

/// Powers of the mean speed: one per cent more of the quantity makes the speed so many per cent greater.
///
/// d ln(mean speed) / d ln(quantity), all others kept. A timer that runs for a given angle loses as much time as its
/// mean speed gains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivities {
    /// To the torque K: one half, by the law of similarity.
    pub torque: f64,
    /// To the friction μ.
    pub friction: f64,
    /// To the driver's moment of inertia I_D.
    pub driver_inertia: f64,
    /// To the follower's moment of inertia I_f.
    pub follower_inertia: f64,
}

/// Relative change of a quantity by which the powers are found. The solver errs by 10⁻¹², so the rounding of the
/// quotient is about 10⁻⁹; the fourth power of the change, which the second difference leaves over, is 10⁻¹².
const CHANGE: f64 = 1e-3;

impl Sensitivities {
    /// Of an escapement, to about nine digits; the one to the torque is exact.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]: without friction there is no steady state. Too near to the critical friction
    /// the neighbours of the escapement have none either.
    pub fn new(parameters: &Parameters) -> Result<Self, TimerError> {
        let friction = power(|factor| of(parameters, factor, 1.0))?;
        let driver_inertia = power(|factor| of(parameters, 1.0, factor))?;
        // Speeds are a function of μ and I_D/I_f times √(K/I_f).
        Ok(Self { torque: 0.5, friction, driver_inertia, follower_inertia: -0.5 - driver_inertia })
    }
}

/// The logarithm of the mean speed with this much times the friction and the driver's inertia.
fn of(parameters: &Parameters, friction: f64, driver: f64) -> Result<f64, TimerError> {
    let inertias = parameters.inertias();
    let inertias = Inertias::new(inertias.driver() * driver, inertias.follower())?;
    let changed =
        Parameters::new(parameters.mechanism(), inertias, parameters.torque(), parameters.friction() * friction)?;
    Ok(libm::log(Engagement::new(&changed)?.steady_state()?.mean_speed))
}

/// d f / d ln x at x = 1, by differences of the whole and of half the change.
fn power(f: impl Fn(f64) -> Result<f64, TimerError>) -> Result<f64, TimerError> {
    let slope = |change: f64| -> Result<f64, TimerError> {
        Ok((f(libm::exp(change))? - f(libm::exp(-change))?) / (2.0 * change))
    };
    let (whole, half) = (slope(CHANGE)?, slope(CHANGE / 2.0)?);
    Ok(half + (half - whole) / 3.0)
}
