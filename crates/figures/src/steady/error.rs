//! Why there is no drawing of a steady motion.

use crate::escapement::DrawingError;
use geneva_dynamics::ParameterError;
use geneva_dynamics::steady::SteadyError;
use std::fmt;

/// Why there is no drawing of a steady motion.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionError {
    /// The data make no escapement.
    Parameters(ParameterError),
    /// There is no steady motion, or none that can be computed.
    Steady(SteadyError),
    /// A single engagement could not be followed.
    Engagement(DrawingError),
    /// There is nothing to draw.
    Nothing,
}

impl fmt::Display for MotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameters(error) => error.fmt(f),
            Self::Steady(error) => error.fmt(f),
            Self::Engagement(error) => error.fmt(f),
            Self::Nothing => write!(f, "nothing to draw: give at least one run that reaches its steady motion"),
        }
    }
}

impl std::error::Error for MotionError {}

impl From<ParameterError> for MotionError {
    fn from(error: ParameterError) -> Self {
        Self::Parameters(error)
    }
}

impl From<SteadyError> for MotionError {
    fn from(error: SteadyError) -> Self {
        Self::Steady(error)
    }
}

impl From<DrawingError> for MotionError {
    fn from(error: DrawingError) -> Self {
        Self::Engagement(error)
    }
}
