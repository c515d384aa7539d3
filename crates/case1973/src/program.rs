//! The program of 1973: the equation of motion on a variable-step integrator, with the driver's angle reset.
//!
//! It is what the thesis describes, not what a mechanism does. The driver's angle is reset to the start of an
//! engagement after a *reset angle*, whatever the number of pins. The sign of the friction term is chosen by the
//! acceleration of a moment before. Both are fields here, beside the choices that describe the mechanism: a reset angle
//! of 2π/m and the exact sign. For the motion itself there is a faster and sharper way,
//! [`steady`](geneva_dynamics::steady).
//! MEYER, Appendix B.

use geneva_dynamics::steady::PrintedLine;
use geneva_dynamics::{Coefficients, Inertias, Parameters, Pose, Sign};
use geneva_kinematics::{Mechanism, Turn};
use geneva_mimic::{
    DelayError, DelayLine, Extrapolation, IntegrationError, Interpolation, SolverStats, System, integrate,
};
use nalgebra::Vector2;
use std::fmt;

/// Why there is no run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ProgramError {
    /// The numbers on the data card make no escapement.
    #[error(transparent)]
    Escapement(#[from] geneva_dynamics::DynamicsError),
    /// The integrator stopped, in its own words.
    #[error("{0}")]
    Stopped(String),
}

/// Rule by which the program chooses between the two signs of C θ'² + D θ''.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SignRule {
    /// The one sign that agrees with itself.
    Exact,
    /// By the acceleration of so long ago, in units of time.
    ///
    /// Before the integrator's steps are as short, it is the acceleration at the step before that counts.
    Delayed(f64),
}

/// One run's data cards, and what the program makes of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Program1973 {
    /// Pins, slots and centre distance.
    pub mechanism: Mechanism,
    /// The two moments of inertia.
    pub inertias: Inertias,
    /// Torque on the driver, in any unit that is consistent with those of the inertias and of time.
    pub torque: f64,
    /// Coefficient of friction between pin and slot, dimensionless.
    pub friction: f64,
    /// Centre distance over crank radius, dimensionless.
    pub ratio: f64,
    /// Crank angle at the start of an engagement, in radians from the line of centres.
    pub start: f64,
    /// Angle in radians after which the driver's angle is reset to the start.
    pub reset: f64,
    /// How the sign of the friction term is chosen.
    pub sign_rule: SignRule,
}

/// What can go wrong at an instant of a run.
#[derive(Clone, Debug, PartialEq)]
enum ProgramFault {
    NoSolution { angle: f64, error: geneva_dynamics::DynamicsError },
    Delay(DelayError),
}

impl fmt::Display for ProgramFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSolution { angle, error } => write!(f, "at the crank angle {angle} rad: {error}"),
            Self::Delay(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for ProgramFault {}

impl Program1973 {
    /// The program for a mechanism as it is: reset after one engagement, the sign exact.
    pub fn ideal(parameters: &Parameters) -> Self {
        let mechanism = parameters.mechanism();
        let half = mechanism.engagement_half_angle();
        Self {
            mechanism,
            inertias: parameters.inertias(),
            torque: parameters.torque(),
            friction: parameters.friction(),
            ratio: mechanism.centre_distance_ratio(),
            start: -half,
            reset: 2.0 * half,
            sign_rule: SignRule::Exact,
        }
    }

    /// Runs it from rest, and gives the printed lines.
    ///
    /// # Errors
    ///
    /// A reset angle that is not positive, or whatever stops the integrator: a bad parameter of its own, a step that
    /// becomes too small, an angle at which the equation has no single solution.
    pub fn run(&self, integrator: &geneva_mimic::SolverParameters) -> Result<Printout, ProgramError> {
        use geneva_dynamics::DynamicsError::{NotFinite, NotPositive};
        if !(self.reset > 0.0 && self.reset.is_finite()) {
            Err(NotPositive { name: "reset angle", asked: self.reset })?;
        }
        for (name, asked) in [("start of an engagement", self.start), ("centre distance ratio", self.ratio)] {
            if !asked.is_finite() {
                Err(NotFinite { name, asked })?;
            }
        }
        // Checks the ranges of torque and friction; the friction's limit is that of the mechanism as it is.
        Parameters::new(self.mechanism, self.inertias, self.torque, self.friction)?;
        let sign_source = SignSource::new(&self.sign_rule).map_err(|error| ProgramError::Stopped(error.to_string()))?;
        let mut motion = ProgramMotion { program: *self, sign_source, acceleration: 0.0 };
        let mut lines = Vec::new();
        let outcome = integrate(&mut motion, Vector2::zeros(), integrator, |point| {
            let turned = point.state[0];
            let (angle, pose) = self.pose(turned);
            lines.push(PrintedLine {
                time: point.time,
                turned,
                angle,
                speed: point.state[1],
                acceleration: point.derivative[1],
                follower_speed: pose.velocity_ratio() * point.state[1],
                engagement: (turned / self.reset) as usize,
            });
        });
        let stopped = |error: IntegrationError<2, ProgramFault>| ProgramError::Stopped(error.to_string());
        Ok(Printout { lines, work: outcome.map_err(stopped)?.work })
    }

    /// The reset crank angle, and the pose there.
    fn pose(&self, turned: f64) -> (f64, Pose<f64>) {
        let angle = libm::fmod(turned, self.reset) + self.start;
        (angle, Pose::new(&self.ratio, &Turn::from_radians(angle)))
    }
}

/// All lines of a run, and the work that it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Printout {
    /// The lines, the start included. Their crank angles and the velocity ratio of the follower's speed are of the reset angle.
    pub lines: Vec<PrintedLine>,
    /// Steps and evaluations.
    pub work: SolverStats,
}

impl Printout {
    /// The largest printed speed of the driver, in radians per unit of time.
    pub fn largest(&self) -> f64 {
        self.lines.iter().map(|line| line.speed).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Kept points that a delay line holds. The integrator's steps are a few to a print interval, but crowd where a lagged
/// sign makes the acceleration jump to and fro.
const KEPT: usize = 16_384;

/// Where a run takes the sign of C θ'² + D θ'' from.
enum SignSource {
    /// The state of the motion at this instant.
    Exact,
    /// Accelerations of the past, which the line keeps.
    Delayed(Box<DelayLine<KEPT>>),
}

impl SignSource {
    /// A source for this rule, with no accelerations kept yet.
    fn new(sign_rule: &SignRule) -> Result<Self, DelayError> {
        Ok(match sign_rule {
            SignRule::Exact => Self::Exact,
            SignRule::Delayed(delay) => {
                Self::Delayed(Box::new(DelayLine::new(*delay, 0.0, Interpolation::Linear, Extrapolation::Hold)?))
            }
        })
    }
}

/// The motion as the integrator sees it: θ and θ'.
struct ProgramMotion {
    program: Program1973,
    sign_source: SignSource,
    /// θ'' at the point that was asked for last.
    acceleration: f64,
}

impl System<2> for ProgramMotion {
    type Fault = ProgramFault;

    fn derivative(&mut self, time: f64, state: &Vector2<f64>) -> Result<Vector2<f64>, ProgramFault> {
        let (angle, pose) = self.program.pose(state[0]);
        let drive = self.program.torque / self.program.inertias.follower();
        let coefficients =
            Coefficients::from_pose(&pose, &self.program.inertias.ratio(), &self.program.friction, &drive);
        let (a, d) = (coefficients.a, coefficients.d.abs());
        if a.partial_cmp(&d) != Some(std::cmp::Ordering::Greater) {
            return Err(ProgramFault::NoSolution { angle, error: geneva_dynamics::DynamicsError::NotUnique { a, d } });
        }
        let speed = state[1];
        let sign = match &self.sign_source {
            SignSource::Exact => Sign::from_number(coefficients.sign_switching_function(&speed)),
            // At rest the friction opposes the driver, whatever was before.
            SignSource::Delayed(_) if time <= 0.0 => Sign::from_number(coefficients.d),
            SignSource::Delayed(line) => {
                let before = line.value(time).map_err(ProgramFault::Delay)?;
                Sign::from_number(coefficients.between_the_bars(&speed, &before))
            }
        };
        self.acceleration = coefficients.acceleration_with(&speed, sign);
        Ok(Vector2::new(speed, self.acceleration))
    }

    fn accepted(&mut self, time: f64, _: &Vector2<f64>, derivative: &Vector2<f64>) -> Result<(), ProgramFault> {
        match &mut self.sign_source {
            SignSource::Exact => Ok(()),
            SignSource::Delayed(line) => line.record(time, derivative[1]).map_err(ProgramFault::Delay),
        }
    }
}
