//! How the sign of the friction term is chosen: exactly, or by an acceleration of a moment before.

use geneva_mimic::{DelayError, DelayLine, Extrapolation, Interpolation};

/// How the program chooses between the two signs of C θ'² + D θ''.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// The one sign that agrees with itself.
    Exact,
    /// By the acceleration of so long ago, in units of time.
    ///
    /// Before the integrator's steps are as short, it is the acceleration at the step before that counts.
    Delayed(f64),
}

/// Kept points that a delay line holds. The integrator's steps are a few to a print interval, but crowd where a late sign
/// makes the acceleration jump to and fro.
const KEPT: usize = 16_384;

/// What a run remembers for its choice.
pub enum Memory {
    /// Nothing: the sign is exact.
    None,
    /// The accelerations.
    Line(Box<DelayLine<KEPT>>),
}

impl Memory {
    /// An empty memory for a way to choose.
    pub fn new(contact: &Contact) -> Result<Self, DelayError> {
        Ok(match contact {
            Contact::Exact => Self::None,
            Contact::Delayed(delay) => {
                Self::Line(Box::new(DelayLine::new(*delay, 0.0, Interpolation::Linear, Extrapolation::Hold)?))
            }
        })
    }
}
