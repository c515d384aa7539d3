//! Where the driver, started from rest, first stops slowing down.

use super::engagement::Engagement;
use super::error::SteadyError;
use super::extremes::Extreme;

/// Engagements within which there must be one. One is enough: past the line of centres the follower drives the driver.
const LOOKED_AT: usize = 4;

impl Engagement {
    /// The first place from rest where the speed stops falling and rises again, with the time from the start; none if
    /// there is none in the first engagements.
    ///
    /// It is not the least speed of an engagement, which from rest is zero at the start. Meyer 1973, chapter II, takes it
    /// for the end of the rise.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::new`].
    pub fn first_minimum(&self) -> Result<Option<Extreme>, SteadyError> {
        let engagement = self.refined()?;
        let (mut square, mut time) = (0.0, 0.0);
        for _ in 0..LOOKED_AT {
            let passage = engagement.pass(square);
            if let Some(lowest) = passage.first_valley() {
                return Ok(Some(Extreme { time: time + lowest.time, ..lowest }));
            }
            time += passage.duration();
            square = passage.end;
        }
        Ok(None)
    }
}
