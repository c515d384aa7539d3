//! The times at which results are printed.

/// A remainder below this part of a step is no step of its own: it is rounding, and the step is stretched over it.
pub(crate) const SLIVER: f64 = 1e-9;

/// The multiples of the print interval up to the run length, and the run length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    interval: f64,
    end: f64,
    /// Number of the last multiple.
    whole: u64,
    /// Number of the last point.
    pub(crate) last: u64,
}

impl Grid {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn times(interval: f64, end: f64) -> Vec<f64> {
        let grid = Grid::new(interval, end);
        (0..=grid.last).map(|index| grid.time(index)).collect()
    }

    #[test]
    fn a_run_length_within_rounding_of_a_multiple_is_that_multiple() {
        assert_eq!(times(0.1, 0.3 + 1e-7).last(), Some(&(0.3 + 1e-7)));
        assert_eq!(Grid::new(5e-4, 0.2).last, 400);
    }

    #[test]
    fn extreme_sizes_give_a_grid_too() {
        assert_eq!(times(f64::MAX, f64::MAX), [0.0, f64::MAX]);
        assert_eq!(times(f64::MAX * 0.7, f64::MAX).last(), Some(&f64::MAX));
        assert_eq!(times(f64::MAX, f64::MIN_POSITIVE), [0.0, f64::MIN_POSITIVE]);
        assert_eq!(Grid::new(1e-12, 1.0).last, 1_000_000_000_000);
    }
}
