//! One escapement: whether it runs, its steady state, its rise from rest, the run itself, what a clockmaker asks of it, and its
//! drawings.

mod question;
mod report;
mod run;
mod timer;

pub use question::{EscapementQuestion, Further, UnitSystem};
pub use timer::rates;

use crate::Error;
use crate::number_format::{as_typed, rounded_up};
use geneva_dynamics::steady::{Engagement, MOST_CYCLES, SteadyState, TOLERANCE};
use geneva_dynamics::{DynamicsError as Motion, Inertias, Parameters};
use geneva_figures::Figure;
use geneva_figures::escapement::{mechanism, normal_force};
use geneva_figures::runs::speeds;
use geneva_kinematics::Mechanism;

/// The drawings of an escapement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EscapementDrawing {
    /// The mechanism, to scale.
    Mechanism,
    /// Normal force and friction torque over one engagement of the steady state.
    NormalForce,
    /// Speeds of driver and follower over the first engagements from rest.
    Run,
}

/// How near to the steady speed the rise from rest must come.
const SETTLED: f64 = 0.01;

/// An escapement that a question describes.
#[derive(Debug)]
pub struct EscapementDesign {
    question: EscapementQuestion,
    parameters: Parameters,
    /// The turn of the driver, in degrees, after which its angle is reset: the question's, or that of the mechanism.
    reset_deg: f64,
    engagement: Engagement,
}

impl EscapementDesign {
    /// The escapement that a question describes.
    ///
    /// # Errors
    ///
    /// What is impossible, with the arguments to change.
    pub fn new(question: EscapementQuestion) -> Result<Self, Error> {
        let parameters = parameters(&question)?;
        let reset_deg = question.reset_deg.unwrap_or(own_reset(parameters.mechanism()));
        let engagement = engagement(&parameters, reset_deg).map_err(|error| unsteady(&question, error))?;
        Ok(Self { question, parameters, reset_deg, engagement })
    }

    fn steady_state(&self) -> Result<SteadyState, Error> {
        self.engagement.steady_state().map_err(|error| unsteady(&self.question, error))
    }

    /// One of its drawings.
    ///
    /// # Errors
    ///
    /// A drawing of a steady state that there is not.
    pub fn drawing(&self, drawing: EscapementDrawing) -> Result<Figure, Error> {
        Ok(match drawing {
            EscapementDrawing::Mechanism => {
                let escapement = self.parameters.mechanism();
                mechanism(&escapement, -escapement.engagement_half_angle() / 3.0)?
            }
            EscapementDrawing::NormalForce => {
                if self.reset_deg != own_reset(self.parameters.mechanism()) {
                    return Err(refused!(
                        "--reset-deg {}: --figure normal-force shows an engagement of a real mechanism; leave --reset-deg out",
                        as_typed(self.reset_deg)
                    ));
                }
                normal_force(&self.parameters, self.steady_state()?.entry_speed)?
            }
            EscapementDrawing::Run => {
                self.steady_state()?;
                speeds(&self.engagement, "")?
            }
        })
    }
}

/// The parameters that were typed, if there is such an escapement; too much friction is refused in terms of the option and
/// in degrees.
fn parameters(question: &EscapementQuestion) -> Result<Parameters, Error> {
    let mechanism = Mechanism::new(question.slots)?;
    let inertias = Inertias::new(question.driver_inertia, question.follower_inertia)?;
    match Parameters::new(mechanism, inertias, question.torque, question.friction) {
        Err(Motion::TooMuchFriction { asked, limit, angle }) => Err(refused!(
            "--friction {} is too high for this mechanism: from {} on it may jam, because the motion is not determined \
             {:.2}° to either side of the line of centres; give less friction, or a driver with more inertia",
            as_typed(asked),
            rounded_up(limit),
            angle.to_degrees()
        )),
        other => Ok(other?),
    }
}

/// The reset angle of a mechanism in degrees: 360 over the number of pins, an integer.
pub fn own_reset(mechanism: Mechanism) -> f64 {
    360.0 / f64::from(mechanism.pins())
}

/// The engagement that ends after so many degrees.
pub fn engagement(parameters: &Parameters, reset_deg: f64) -> Result<Engagement, Motion> {
    if reset_deg == own_reset(parameters.mechanism()) {
        Engagement::new(parameters)
    } else {
        Engagement::reset_after(parameters, reset_deg.to_radians(), TOLERANCE)
    }
}

/// The library's refusal of a steady motion, in terms of the options.
fn unsteady(question: &EscapementQuestion, error: Motion) -> Error {
    let friction = as_typed(question.friction);
    match error {
        Motion::Reset { asked, limit } => no_reset(question.reset_deg.unwrap_or(asked.to_degrees()), limit),
        Motion::NoTerminalSpeed { .. } => refused!(
            "--friction {friction}: there is no terminal speed, because nothing brakes the driver and it gains speed \
             without end; give a friction above zero, or --format csv for the run from rest"
        ),
        Motion::TooSharp { angle, margin } => refused!(
            "--friction {friction}, --driver-inertia {}, --follower-inertia {}: the motion changes too quickly to be \
             computed at {:.2}° from the line of centres, where A − |D| is {margin:.1e}; give less friction, or \
             inertias that differ less",
            as_typed(question.driver_inertia),
            as_typed(question.follower_inertia),
            angle.to_degrees()
        ),
        other => other.into(),
    }
}

/// A reset angle that is out of range, and the range. The limit is in radians.
pub fn no_reset(asked_deg: f64, limit: f64) -> Error {
    refused!(
        "--reset-deg {}: the driver's angle must be reset after more than 0° and less than {}°, where the pin is \
         farthest from the follower; give an angle in this range, or leave it out for a real mechanism",
        as_typed(asked_deg),
        limit.to_degrees().round()
    )
}

/// Engagements and time of the rise from rest; none if it takes more engagements than the library counts.
///
/// The more the speed, the nearer to the line of centres is the switch, and the more an engagement contracts: below the
/// steady speed it contracts by no more than there. So the multiplier of the steady state tells how many engagements
/// are needed at least, and a rise that is too long for certain is not tried.
pub fn engagements_until_steady(engagement: &Engagement, steady: &SteadyState) -> Result<Option<(usize, f64)>, Motion> {
    let enough = (1.0 - SETTLED) * (1.0 - SETTLED);
    let least = libm::log(1.0 - enough) / libm::log(steady.multiplier);
    // A little is left to rounding.
    if least > 1.001 * MOST_CYCLES as f64 {
        return Ok(None);
    }
    match engagement.engagements_to_settle(SETTLED) {
        Err(Motion::TooMany { .. }) => Ok(None),
        result => result.map(Some),
    }
}
