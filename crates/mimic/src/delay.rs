//! A value of a moment before: MIMIC's time delay `TDL`.

use std::collections::VecDeque;
use thiserror::Error;

/// Value of a delay line at a time between two of its entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// The straight line between the two.
    Linear,
    /// The earlier of the two.
    Hold,
}

/// Value of a delay line at a time after its latest entry, which is needed if a step is longer than the delay.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Extrapolation {
    /// The latest entry. Nothing is made up, but the delay is then longer than was asked for, up to a whole step.
    Hold,
    /// The straight line through the latest two entries.
    Linear,
}

/// The past of one quantity, as far back as its delay.
///
/// Entries come from [`record`](Self::record), at rising times of any spacing: the steps that were kept. Reading
/// changes nothing. The memory grows as it must, to `CAPACITY` entries at most, at least 2; what no later reading can
/// need makes room.
///
/// A run's error test does not see how well the past is read: the whole step and the two halves read the same entries.
/// [`SolverParameters::largest_step`](crate::SolverParameters::largest_step) keeps the entries close.
///
/// The thesis has one such line, the crank's angular acceleration a tenth of the print interval before; how MIMIC read
/// between its entries is not said, nor what the third argument of `TDL`, 100, is: perhaps this capacity.
/// MEYER, Appendix B.
///
/// ```
/// use geneva_mimic::{DelayLine, Extrapolation, Interpolation};
///
/// // A value of half a unit of time before, read from entries a unit apart.
/// let mut line = DelayLine::<10>::new(0.5, 7.0, Interpolation::Linear, Extrapolation::Hold)?;
/// line.record(0.0, 2.0)?;
/// assert_eq!(line.value(0.25)?, 7.0); // before the first entry: the initial value
/// line.record(1.0, 4.0)?;
/// assert_eq!(line.value(1.0)?, 3.0); // at 0.5, half-way between 2 and 4
/// # Ok::<(), geneva_mimic::DelayError>(())
/// ```
#[derive(Clone, Debug)]
pub struct DelayLine<const CAPACITY: usize> {
    delay: f64,
    initial: f64,
    interpolation: Interpolation,
    extrapolation: Extrapolation,
    /// The oldest first.
    entries: VecDeque<PastValue>,
    /// Whether an entry has made room: before the oldest is then not before the beginning.
    forgotten: bool,
}

#[derive(Clone, Copy, Debug)]
struct PastValue {
    time: f64,
    value: f64,
}

/// Errors of a delay line.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum DelayError {
    /// A capacity below two: between which entries should it read?
    #[error("capacity {0}: a delay line needs at least 2 entries; give it more")]
    Capacity(usize),
    /// A delay that is not positive and finite.
    #[error("delay {0:?}: it must be positive and finite; give a number above zero")]
    Delay(f64),
    /// An initial value that is not finite.
    #[error("initial value {0:?}: it must be finite")]
    Initial(f64),
    /// A value that is not finite.
    #[error("value {asked:?} at time {time:?}: it must be finite; find out where it comes from")]
    Value {
        /// The value, in the quantity's own unit.
        asked: f64,
        /// When, in the caller's unit of time.
        time: f64,
    },
    /// A time that is not finite.
    #[error("time {0:?}: it must be finite")]
    Time(f64),
    /// A time for an entry that is not after that of the latest one.
    #[error(
        "time {asked:?}: to be recorded it must be after the latest entry's {latest:?}; record kept steps only, each once"
    )]
    Order {
        /// The time, in the caller's unit of time.
        asked: f64,
        /// The time of the latest entry, in the same unit.
        latest: f64,
    },
    /// All entries are within the delay and there is no room for another.
    #[error(
        "no room for an entry at time {time:?}: all {capacity} entries, from time {oldest:?} on, are within the delay \
         {delay:?}; give the line a larger capacity, or the run longer steps"
    )]
    Full {
        /// The time of the entry that does not fit, in the caller's unit of time.
        time: f64,
        /// The time of the oldest entry, in the same unit.
        oldest: f64,
        /// The delay, in the same unit.
        delay: f64,
        /// The capacity.
        capacity: usize,
    },
    /// A time so long ago that its entries have made room.
    #[error("time {asked:?}: the line remembers from {oldest:?} on; ask at times not before the latest entry")]
    Forgotten {
        /// The time that was asked for, less the delay, in the caller's unit of time.
        asked: f64,
        /// The time of the oldest entry, in the same unit.
        oldest: f64,
    },
}

impl<const CAPACITY: usize> DelayLine<CAPACITY> {
    /// A line without entries. `delay` is positive, in the unit of time; `initial` is the value before the first entry.
    ///
    /// # Errors
    ///
    /// [`DelayError::Capacity`] for a `CAPACITY` below 2, [`DelayError::Delay`] for a delay that is not positive and
    /// finite, [`DelayError::Initial`] for an initial value that is not finite.
    pub fn new(
        delay: f64,
        initial: f64,
        interpolation: Interpolation,
        extrapolation: Extrapolation,
    ) -> Result<Self, DelayError> {
        if CAPACITY < 2 {
            return Err(DelayError::Capacity(CAPACITY));
        }
        if !(delay > 0.0 && delay.is_finite()) {
            return Err(DelayError::Delay(delay));
        }
        if !initial.is_finite() {
            return Err(DelayError::Initial(initial));
        }
        Ok(Self { delay, initial, interpolation, extrapolation, entries: VecDeque::new(), forgotten: false })
    }

    /// Number of entries that there is memory for.
    pub fn room(&self) -> usize {
        self.entries.capacity()
    }

    /// Enters the value at a time later than that of all entries. On an error nothing is entered.
    ///
    /// # Errors
    ///
    /// [`DelayError::Time`] and [`DelayError::Value`] for what is not finite; [`DelayError::Order`] for a time that is
    /// not after the latest entry's; [`DelayError::Full`] if all entries are within the delay and fill the memory.
    pub fn record(&mut self, time: f64, value: f64) -> Result<(), DelayError> {
        if !time.is_finite() {
            return Err(DelayError::Time(time));
        }
        let latest = self.entries.back().map(|latest| latest.time);
        if let Some(latest) = latest.filter(|latest| time <= *latest) {
            return Err(DelayError::Order { asked: time, latest });
        }
        if !value.is_finite() {
            return Err(DelayError::Value { asked: value, time });
        }
        // From now on nobody asks for a time before this; the entry at it or next before it must stay.
        let needed = time - self.delay;
        while self.entries.get(1).is_some_and(|second| second.time <= needed) {
            self.entries.pop_front();
            self.forgotten = true;
        }
        if let Some(oldest) = self.entries.front().filter(|_| self.entries.len() >= CAPACITY) {
            return Err(DelayError::Full { time, oldest: oldest.time, delay: self.delay, capacity: CAPACITY });
        }
        self.entries.push_back(PastValue { time, value });
        Ok(())
    }

    /// The value at `time` less the delay, in the quantity's own unit, for a `time` not before that of the latest
    /// entry.
    ///
    /// Before the first entry of all it is the initial value; at the time of an entry, the entry's.
    ///
    /// # Errors
    ///
    /// [`DelayError::Time`] for a time that is not finite; [`DelayError::Forgotten`] if the entries at `time` less the
    /// delay have made room.
    pub fn value(&self, time: f64) -> Result<f64, DelayError> {
        let asked = time - self.delay;
        if !asked.is_finite() {
            return Err(DelayError::Time(time));
        }
        let entry = |place: Option<usize>| place.and_then(|place| self.entries.get(place)).copied();
        let later = self.count_until(asked);
        let Some(before) = entry(later.checked_sub(1)) else {
            let forgotten = self.entries.front().filter(|_| self.forgotten);
            let forgotten = forgotten.map(|oldest| DelayError::Forgotten { asked, oldest: oldest.time });
            return forgotten.map_or(Ok(self.initial), Err);
        };
        Ok(match (entry(Some(later)), self.interpolation, self.extrapolation) {
            (Some(later), Interpolation::Linear, _) => line(before, later, asked),
            (None, _, Extrapolation::Linear) => {
                entry(later.checked_sub(2)).map_or(before.value, |earlier| line(before, earlier, asked))
            }
            _ => before.value,
        })
    }

    /// How many entries are at or before a time. It is looked for among the oldest first: what no reading can need has made
    /// room, so the time is there, whatever the number of entries.
    fn count_until(&self, asked: f64) -> usize {
        const OLDEST: usize = 4;
        let later = self.entries.iter().take(OLDEST).position(|entry| entry.time > asked);
        later.unwrap_or_else(|| self.entries.partition_point(|entry| entry.time <= asked))
    }
}

/// The straight line through two entries, at a time; at the first entry its value to the bit.
fn line(one: PastValue, other: PastValue, time: f64) -> f64 {
    one.value + (other.value - one.value) * ((time - one.time) / (other.time - one.time))
}
