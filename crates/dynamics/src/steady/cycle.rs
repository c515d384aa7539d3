//! The steady cycle, instant by instant.

use super::engagement::Engagement;
use super::error::SteadyError;
use super::trajectory::{Grid, MOST_PRINTED, Printed};

impl Engagement {
    /// The steady motion over one engagement, from its start to its end, at the ends of `parts` equal parts of the period.
    ///
    /// Times are from the start of the engagement, which has the number 0.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]; [`SteadyError::TooMany`] for [`MOST_PRINTED`] parts or more.
    pub fn steady_cycle(&self, parts: usize) -> Result<Vec<Printed>, SteadyError> {
        if parts >= MOST_PRINTED {
            return Err(SteadyError::TooMany { name: "parts of a period", limit: MOST_PRINTED });
        }
        let engagement = self.refined()?;
        let repeated = engagement.repeated()?;
        let passage = engagement.pass_with(repeated.entry, repeated.split.as_ref());
        let period = passage.duration();
        let mut lines = Vec::with_capacity(parts + 1);
        if let Some(last) = parts.checked_sub(1) {
            passage.print(&mut lines, Grid { interval: period / parts as f64, last, number: 0 }, 0.0);
        }
        lines.extend(passage.last_line(period, 0));
        Ok(lines)
    }
}
