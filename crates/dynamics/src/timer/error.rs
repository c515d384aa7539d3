//! Why an escapement makes no timer.

use crate::steady::SteadyError;
use crate::{EquationError, ParameterError};
use std::fmt;

/// What stands in the way of an answer about a timer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimerError {
    /// A neighbour of the escapement, or one that was asked about, cannot be.
    Parameter(ParameterError),
    /// It has no steady motion.
    Steady(SteadyError),
    /// Its equation of motion has no single solution at an instant.
    Equation(EquationError),
}

impl fmt::Display for TimerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => write!(f, "{error}"),
            Self::Steady(error) => write!(f, "{error}"),
            Self::Equation(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for TimerError {}

impl From<ParameterError> for TimerError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}

impl From<SteadyError> for TimerError {
    fn from(error: SteadyError) -> Self {
        Self::Steady(error)
    }
}

impl From<EquationError> for TimerError {
    fn from(error: EquationError) -> Self {
        Self::Equation(error)
    }
}
