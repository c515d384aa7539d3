//! How fast the terminal speed is reached.

use crate::Parameters;
use crate::steady::{Engagement, SteadyError};

/// How an escapement forgets how it was started.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settling {
    /// Factor by which one engagement reduces a small difference of two speeds.
    pub contraction: f64,
    /// Units of time that an engagement takes in the steady motion.
    pub period: f64,
}

impl Settling {
    /// Of an escapement.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]: without friction there is no steady state.
    pub fn new(parameters: &Parameters) -> Result<Self, SteadyError> {
        let steady = Engagement::new(parameters)?.steady_state()?;
        Ok(Self { contraction: steady.contraction, period: steady.period })
    }

    /// Engagements, not rounded, until a small difference is down to this part of itself, which is between 0 and 1.
    pub fn engagements(&self, part: f64) -> f64 {
        libm::log(part) / libm::log(self.contraction)
    }

    /// Units of time until then, counted as if each engagement took a period.
    ///
    /// A start from rest lasts longer than its first engagement, however small the number is here.
    pub fn time(&self, part: f64) -> f64 {
        self.engagements(part) * self.period
    }
}
