//! The times at which results are printed.

/// A remainder below this part of a step is no step of its own: it is rounding, and the step is stretched over it.
pub(crate) const SLIVER: f64 = 1e-9;

/// The multiples of the print interval up to the run length, and the run length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PrintTimes {
    interval: f64,
    end: f64,
    /// Number of the last multiple.
    whole: u64,
    /// Number of the last point.
    pub(crate) last: u64,
}

impl PrintTimes {
    /// Both must be positive and finite, and their ratio at most [`MOST_STEPS`](crate::MOST_STEPS).
    ///
    /// A run length within rounding of a multiple is taken for the multiple; any other is a last point of its own.
    pub(crate) fn new(interval: f64, end: f64) -> Self {
        let ratio = end / interval;
        let nearest = (ratio + 0.5) as u64;
        let off = (nearest as f64 * interval - end).abs();
        if nearest >= 1 && off <= (SLIVER * interval).max(2.0 * f64::EPSILON * end) {
            return Self { interval, end, whole: nearest, last: nearest };
        }
        let whole = ratio as u64;
        Self { interval, end, whole, last: whole + 1 }
    }

    /// Time of the point of this number, the start being number 0: a product, so that no error builds up.
    pub(crate) fn time(&self, index: u64) -> f64 {
        if index <= self.whole { index as f64 * self.interval } else { self.end }
    }
}
