//! The greatest speed that a run prints, without its other lines.

use super::engagement::Engagement;
use super::passage::Passage;
use super::run::{Clock, MOST_PRINTED};
use crate::DynamicsError;

/// Engagements whose squares of the entry speed differ by no more than this part of them are alike.
const ALIKE: f64 = 1e-14;

impl Engagement {
    /// The greatest driver's speed that a run from rest prints, at `first` and each multiple of the interval after it up
    /// to a duration, all in units of time; in radians per unit of time.
    ///
    /// Between two places where the speed is level it rises or falls. So only the lines next to such places are worked out,
    /// and the first and the last of each engagement: a small part of the [whole run](Self::run).
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
    /// let engagement = Engagement::new(&timer)?;
    /// let (interval, duration) = (0.5, 20.0); // s
    /// let all = engagement.run(interval, duration)?;
    /// let largest = all.iter().map(|line| line.speed).fold(0.0, f64::max); // rad/s
    /// assert!((engagement.largest_printed(interval, 0.0, duration)? - largest).abs() < 1e-9);
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::run`]; [`DynamicsError::Negative`] for a `first` that is negative or not finite.
    pub fn largest_printed(&self, interval: f64, first: f64, duration: f64) -> Result<f64, DynamicsError> {
        for (name, asked) in [("print interval", interval), ("duration", duration)] {
            if !(asked > 0.0 && asked.is_finite()) {
                return Err(DynamicsError::NotPositive { name, asked });
            }
        }
        crate::error::not_negative("first line", first)?;
        if duration / interval >= MOST_PRINTED as f64 {
            return Err(DynamicsError::TooMany { name: "printed lines", limit: MOST_PRINTED });
        }
        // A duration within rounding of a multiple is one.
        let last = ((duration - first) / interval * (1.0 + 1e-12)).floor();
        let engagement = self.refine()?;
        let unit = engagement.unit;
        let (mut square, mut start, mut largest) = (0.0, 0.0, 0.0_f64);
        let mut passed = Passed::of(&engagement, square);
        for _ in 0..MOST_PRINTED {
            if (passed.passage.entry - square).abs() > ALIKE * square {
                passed = Passed::of(&engagement, square);
            }
            let time = |number: f64| (first + number * interval) * unit;
            // The number of the first line at or after a time, in units of 1/√E as all here.
            let line = |at: f64| ((at / unit - first) / interval).ceil().max(0.0);
            let end = passed.clocks.iter().fold(start, |end, clock| end + clock.whole);
            for level in &passed.levels {
                let ahead = line(start + level);
                // The end of the run is an end too.
                for number in [ahead - 1.0, ahead, last] {
                    if number <= last {
                        largest = largest.max(passed.speed(start, time(number)).unwrap_or(0.0));
                    }
                }
            }
            start = end;
            if line(start) > last {
                return Ok(largest);
            }
            square = passed.passage.end;
        }
        Err(DynamicsError::TooMany { name: "engagements", limit: MOST_PRINTED })
    }
}

/// A passage with its clocks. Times are from its start, in units of 1/√E.
struct Passed<'a> {
    passage: Passage<'a>,
    clocks: Vec<Clock>,
    /// Its ends, and where the speed is level.
    levels: Vec<f64>,
}

impl<'a> Passed<'a> {
    /// With u at entry.
    fn of(engagement: &'a Engagement, square: f64) -> Self {
        let passage = engagement.pass(square);
        let clocks = passage.traversals.iter().map(|traversal| traversal.clock(engagement.rule)).collect();
        let levels = passage.level_times();
        Self { passage, clocks, levels }
    }

    /// The driver's speed at a time of the run, if the passage, which begins at `start`, holds it; in radians per unit of
    /// time.
    fn speed(&self, mut start: f64, time: f64) -> Option<f64> {
        for (traversal, clock) in self.passage.traversals.iter().zip(&self.clocks) {
            let end = start + clock.whole;
            if time < end {
                return (time >= start).then(|| self.passage.line(traversal, clock, time - start, time, 0).speed);
            }
            start = end;
        }
        None
    }
}
