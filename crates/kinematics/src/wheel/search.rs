//! The least value of a function whose greatest rate is known.
//!
//! Within an interval the value is at least the value in the middle less half the interval times the greatest rate in it.
//! Intervals are halved until none can hold a value below the least that was found, less the tolerance.

use std::cell::Cell;

/// Intervals to begin with.
const INTERVALS: u32 = 16;

/// How exactly a least value is looked for, and at how many places.
pub(crate) struct Search<'a> {
    /// How much less than what is found a value may be, in the function's own unit.
    pub tolerance: f64,
    /// A value that is enough, in the function's own unit: where no lesser one is possible, nothing is looked for.
    pub enough: f64,
    /// Places that may still be looked at.
    pub places: &'a Cell<u32>,
}

/// A value, in the function's own unit, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Minimum {
    /// The value, in the function's own unit.
    pub value: f64,
    /// Its place, in the unit of places.
    pub place: f64,
}

impl Minimum {
    /// The lesser of two, the first of equals.
    fn or(self, other: Self) -> Self {
        if other.value < self.value { other } else { self }
    }
}

impl Search<'_> {
    /// The least value of a function between two places that changes no faster than `rate` says between two of them, or
    /// what is known to be less; a value below the tolerance will do where `enough` is one, and any where no places are
    /// left.
    pub(crate) fn minimize(
        &self,
        from: f64,
        to: f64,
        known: Option<Minimum>,
        value: impl Fn(f64) -> f64,
        rate: impl Fn(f64, f64) -> f64,
    ) -> Minimum {
        let at = |place: f64| Minimum { value: value(place), place };
        let mut least = known.map_or(at(from), |known| known.or(at(from))).or(at(to));
        let width = (to - from) / f64::from(INTERVALS);
        let first = |k: u32| (from + width * f64::from(k), from + width * f64::from(k + 1));
        let mut intervals: Vec<(f64, f64)> = (0..INTERVALS).map(first).collect();
        while let Some((from, to)) = intervals.pop() {
            let is_settled = self.enough < f64::INFINITY && least.value < self.tolerance;
            if is_settled || self.places.get() == 0 {
                break;
            }
            self.places.set(self.places.get() - 1);
            let middle = (from + to) / 2.0;
            let here = at(middle);
            least = least.or(here);
            let bound = here.value - rate(from, to) * (to - from) / 2.0;
            if bound < self.enough.min(least.value - self.tolerance) && from < middle && middle < to {
                intervals.extend([(middle, to), (from, middle)]);
            }
        }
        least
    }
}

/// The greatest size, dimensionless, of the speed ratio of a wheel that a pin drives, between two crank angles of one side
/// of the line of centres, in radians, the first nearer to it. `ratio` is centre distance over crank radius.
///
/// The ratio falls from the line of centres to the ends of the engagement, and beyond them it is negative.
pub(super) fn greatest_speed_ratio(ratio: f64, from: f64, to: f64) -> f64 {
    let at = |theta: f64| {
        let cosine = libm::cos(theta);
        (ratio * cosine - 1.0) / (1.0 + ratio * ratio - 2.0 * ratio * cosine)
    };
    at(from).max(-at(to))
}
