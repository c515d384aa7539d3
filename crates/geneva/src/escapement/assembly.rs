//! From what was typed to an escapement and its engagement, or to a refusal in terms of the options.

use super::arguments::{EscapementArguments, Units};
use super::typed::{self, again};
use anyhow::anyhow;
use geneva_dynamics::steady::{Engagement, SteadyError};
use geneva_dynamics::{Inertias, ParameterError, Parameters};
use geneva_kinematics::Mechanism;

const FRICTION: &str = "--friction";
const MODULUS: &str = "--modulus-deg";

/// Relative error that integrals are asked for. As [`Engagement::new`] does.
const TOLERANCE: f64 = 1e-12;

/// An escapement, and the turn of the driver after which the next engagement begins.
pub struct Assembly {
    pub parameters: Parameters,
    pub modulus_deg: f64,
    pub engagement: Engagement,
    pub units: Option<Units>,
}

impl Assembly {
    /// The one that is wanted.
    pub fn new(wanted: &EscapementArguments) -> anyhow::Result<Self> {
        let mechanism = Mechanism::new(wanted.slots)?;
        let torque = typed::computable("--torque", wanted.torque)?;
        let driver = typed::computable("--driver-inertia", wanted.driver_inertia)?;
        let follower = typed::computable("--follower-inertia", wanted.follower_inertia)?;
        let friction = typed::friction(FRICTION, wanted.friction)?;
        let parameters =
            Parameters::new(mechanism, Inertias::new(driver, follower)?, torque, friction).map_err(jams)?;
        let modulus_deg = wanted.modulus_deg.unwrap_or(own_modulus(mechanism));
        let engagement = engagement(&parameters, modulus_deg).map_err(|error| unsteady(wanted, error))?;
        Ok(Self { parameters, modulus_deg, engagement, units: wanted.units })
    }
}

/// The modulus of a mechanism in degrees: 360 over the number of pins, a whole number.
pub fn own_modulus(mechanism: Mechanism) -> f64 {
    360.0 / f64::from(mechanism.pins())
}

/// The engagement that ends after so many degrees.
pub fn engagement(parameters: &Parameters, modulus_deg: f64) -> Result<Engagement, SteadyError> {
    if modulus_deg == own_modulus(parameters.mechanism()) {
        Engagement::new(parameters)
    } else {
        Engagement::folded(parameters, modulus_deg.to_radians(), TOLERANCE)
    }
}

/// Too much friction, in terms of the option and in degrees.
fn jams(error: ParameterError) -> anyhow::Error {
    match error {
        ParameterError::TooMuchFriction { asked, limit, angle } => anyhow!(
            "{FRICTION} {}: from {limit} on the mechanism may jam: the equation of motion has no single solution {:.2}° to \
             either side of the line of centres; give less friction, or a driver with more inertia",
            again(asked),
            angle.to_degrees()
        ),
        other => other.into(),
    }
}

/// The library's refusal of a steady motion, in terms of the options.
pub fn unsteady(wanted: &EscapementArguments, error: SteadyError) -> anyhow::Error {
    match error {
        SteadyError::Fold { asked, limit } => no_fold(wanted.modulus_deg.unwrap_or(asked.to_degrees()), limit),
        SteadyError::NoTerminalSpeed { .. } => anyhow!(
            "{FRICTION} {}: there is no terminal speed, because nothing brakes and the driver gains speed without end; \
             give a friction above zero, or --format csv for the run from rest",
            again(wanted.friction)
        ),
        SteadyError::TooSharp { angle, margin } => anyhow!(
            "{FRICTION} {}, --driver-inertia {}, --follower-inertia {}: the motion changes too quickly to be computed \
             at {:.2}° from the line of centres, where A − |D| is {margin:.1e}; give less friction, or inertias that \
             are less different",
            again(wanted.friction),
            again(wanted.driver_inertia),
            again(wanted.follower_inertia),
            angle.to_degrees()
        ),
        other => other.into(),
    }
}

/// A modulus that is out of range, and the range. The limit is in radians.
pub fn no_fold(asked_deg: f64, limit: f64) -> anyhow::Error {
    anyhow!(
        "{MODULUS} {}: the driver's angle must be put back after a turn above 0° and below {}°, where the pin is farthest \
         from the follower; give one between, or leave it out for what a mechanism does",
        again(asked_deg),
        limit.to_degrees().round()
    )
}

/// A modulus within which nothing happens.
pub fn too_short(asked_deg: f64) -> anyhow::Error {
    anyhow!("{MODULUS} {}: too small to compute with; give more, or leave it out", again(asked_deg))
}
