//! Why a run was not begun, or not ended.

use crate::{MOST_STEPS, SolverStats};
use core::fmt;
use nalgebra::SVector;
use thiserror::Error;

/// The numbers that a parameter can take. All are finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AllowedRange {
    /// Above zero.
    Positive,
    /// From the first to the second, both included.
    FromTo(f64, f64),
    /// Between the two, neither included.
    Between(f64, f64),
}

impl AllowedRange {
    /// Whether the number is one of them.
    pub fn includes(&self, number: f64) -> bool {
        let inside = match *self {
            Self::Positive => number > 0.0,
            Self::FromTo(least, most) => least <= number && number <= most,
            Self::Between(low, high) => low < number && number < high,
        };
        inside && number.is_finite()
    }
}

impl fmt::Display for AllowedRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Positive => f.write_str("positive and finite"),
            Self::FromTo(least, most) if *most == f64::MAX => write!(f, "at least {least:?} and finite"),
            Self::FromTo(least, most) => write!(f, "from {least:?} to {most:?}"),
            Self::Between(low, high) => write!(f, "above {low:?} and below {high:?}"),
        }
    }
}

/// A parameter with which no run can be made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ParameterError {
    /// A number outside its range.
    #[error("{name} {asked:?}: it must be {allowed}; give a number that is")]
    Range {
        /// The field of [`SolverParameters`](crate::SolverParameters).
        name: &'static str,
        /// What was asked for, in the field's own unit.
        asked: f64,
        /// What it can be.
        allowed: AllowedRange,
    },
    /// A bound on the number of steps that is zero or above [`MOST_STEPS`].
    #[error("most_steps {0}: it must be from 1 to {MOST_STEPS}; give a number in this range")]
    MostSteps(u64),
    /// There are more points to print than steps to reach them with.
    #[error(
        "{points:?} printed points: most_steps allows {most_steps} steps, and each point takes at least one; print at a \
         longer interval, run for a shorter time or allow more steps"
    )]
    PrintedPoints {
        /// The run length over the print interval, dimensionless.
        points: f64,
        /// The bound on the number of steps.
        most_steps: u64,
    },
}

/// Quantity that was found not to be finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SolverQuantity {
    /// The state that the run was to start from.
    Start,
    /// The state at the end of a step, however small.
    State,
    /// The derivative at the point that was reached.
    Derivative,
}

impl fmt::Display for SolverQuantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Start => "the start",
            Self::State => "the state after the smallest step from there",
            Self::Derivative => "the derivative there",
        })
    }
}

/// Cause that stopped a run.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum Cause<F> {
    /// The error is too large and the step cannot be made smaller.
    #[error(
        "with a step of {step:?} the error is {excess:?} times what is allowed, and a step must be at least \
         {smallest_step:?} and move the time; look for a singularity there, or allow a smaller step or a larger error"
    )]
    StepUnderflow {
        /// The step that was refused or is too short for time to be told apart, in the unit of the right-hand side's
        /// time.
        step: f64,
        /// The smallest step allowed, in the same unit.
        smallest_step: f64,
        /// The error of the last attempt over what is allowed, dimensionless.
        excess: f64,
    },
    /// A number is infinite or not a number.
    #[error(
        "component {component} of {quantity} is {value:?}; it must be finite: look for a division by zero, a root of a \
         negative number or a growth without bound"
    )]
    NonFinite {
        /// What it belongs to.
        quantity: SolverQuantity,
        /// Its place in the state, counted from 0.
        component: usize,
        /// Its value, in the component's own unit.
        value: f64,
    },
    /// The bound on the number of steps is reached.
    #[error(
        "the limit of {most_steps} steps, refused ones included, is reached; allow more, a larger error or a shorter run"
    )]
    TooManySteps {
        /// The bound.
        most_steps: u64,
    },
    /// The system itself gave up.
    #[error("{0}")]
    System(F),
}

/// Point where a run was stopped, and the cause.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("stopped at time {time:?} in state {:?}: {cause}", .state.as_slice())]
pub struct EarlyStop<const D: usize, F> {
    /// Time of the last point that was kept, in the unit of the right-hand side's time.
    pub time: f64,
    /// State at that time.
    pub state: SVector<f64, D>,
    /// The work up to there.
    pub work: SolverStats,
    /// What stopped it.
    pub cause: Cause<F>,
}

/// Why a run has no end.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum IntegrationError<const D: usize, F> {
    /// It was not begun.
    #[error("{0}")]
    Parameter(ParameterError),
    /// It was stopped on the way.
    #[error("{0}")]
    EarlyStop(EarlyStop<D, F>),
}

impl<const D: usize, F> From<ParameterError> for IntegrationError<D, F> {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}

impl<const D: usize, F> From<EarlyStop<D, F>> for IntegrationError<D, F> {
    fn from(stopped: EarlyStop<D, F>) -> Self {
        Self::EarlyStop(stopped)
    }
}
