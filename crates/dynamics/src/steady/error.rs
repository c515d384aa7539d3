//! Why there is no steady motion, or none that can be computed.

use std::f64::consts::TAU;
use std::fmt;

/// What stands in the way of a steady motion, a rise or a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyError {
    /// A fold that is not positive, or that takes the pin past the far side of its circle.
    Fold {
        /// What was asked for, in radians.
        asked: f64,
        /// The greatest possible: π + π/m.
        limit: f64,
    },
    /// A tolerance outside [`TOLERANCES`](super::TOLERANCES).
    Tolerance(f64),
    /// So near the critical friction, or with such different inertias, that the motion has no scale to be computed at.
    TooSharp {
        /// Crank angle in radians where the equation changes too quickly.
        angle: f64,
        /// A − |D| there.
        margin: f64,
    },
    /// Nothing brakes: the speed grows without end.
    NoTerminalSpeed {
        /// Factor by which two motions approach one another in one engagement; one, or within rounding of it.
        contraction: f64,
    },
    /// An entry speed that is negative or not finite, or whose square is.
    Speed(f64),
    /// A print interval or duration that is not positive and finite.
    Time {
        /// Which.
        name: &'static str,
        /// What was asked for.
        asked: f64,
    },
    /// More engagements, or more printed points, than are allowed.
    TooMany {
        /// Engagements, or printed points.
        name: &'static str,
        /// How many are allowed.
        limit: usize,
    },
}

impl fmt::Display for SteadyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fold { asked, limit } => write!(
                f,
                "fold {asked} rad: a pin's motion must be taken up again after a positive turn of less than {limit} rad, \
                 where the pin is farthest from the follower; give {} over the number of pins, or another angle in range",
                TAU
            ),
            Self::Tolerance(asked) => write!(
                f,
                "tolerance {asked}: it must lie from {} to {}; give a number between",
                super::TOLERANCES.start(),
                super::TOLERANCES.end()
            ),
            Self::TooSharp { angle, margin } => write!(
                f,
                "A - |D| = {margin} at {angle} rad: the equation changes there too quickly to be computed; lower the \
                 friction, or take inertias that are less different"
            ),
            Self::NoTerminalSpeed { contraction } => write!(
                f,
                "no terminal speed: nothing brakes, an engagement takes a difference of speeds to {contraction} of \
                 itself; give a friction above zero"
            ),
            Self::Speed(asked) => {
                write!(
                    f,
                    "entry speed {asked}: it and its square must be finite, and it not negative; give zero or more"
                )
            }
            Self::Time { name, asked } => {
                write!(f, "{name} {asked}: it must be positive and finite; give a number above zero")
            }
            Self::TooMany { name, limit } => {
                write!(f, "more than {limit} {name}: allow more, or ask for less time or more friction")
            }
        }
    }
}

impl std::error::Error for SteadyError {}
