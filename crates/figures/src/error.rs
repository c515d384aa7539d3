//! Why there is no drawing.

use geneva_kinematics::{EscapementError, KinematicsError};

/// Why there is no drawing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FigureError {
    /// The crank angle is beyond the engagement of the wheel.
    #[error(transparent)]
    Wheel(#[from] KinematicsError),
    /// The driver angle is beyond the engagement of the escapement.
    #[error(transparent)]
    Escapement(#[from] EscapementError),
    /// The data make no escapement, the equation of motion has no forces at this state, or there is no steady motion.
    #[error(transparent)]
    Dynamics(#[from] geneva_dynamics::DynamicsError),
    /// A design lies beyond the axes of a map.
    #[error("{name} of a design is {value}, the map shows {least} to {greatest}: leave the design out")]
    OffTheMap {
        /// What is too small or too large.
        name: &'static str,
        /// How large it is.
        value: f64,
        /// The least that is shown.
        least: f64,
        /// The greatest that is shown.
        greatest: f64,
    },
    /// An instant outside of what is shown.
    #[error("a share of {0} of what is shown: give one from 0 to 1")]
    Share(f64),
    /// There is nothing to draw.
    #[error("nothing to draw: give at least one run that reaches its steady motion")]
    Nothing,
}
