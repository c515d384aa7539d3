//! Intervals with the point inside them that is computed from the printed digits as they are.

/// The least, the printed and the greatest value; `low <= point <= high` where they are finite.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Interval {
    /// The least value, in any unit.
    pub low: f64,
    /// The value of the printed digits, in the same unit.
    pub point: f64,
    /// The greatest value, in the same unit.
    pub high: f64,
}

/// Relative slack for the rounding of floating-point arithmetic.
pub(crate) const SLACK: f64 = 1e-9;

impl Interval {
    /// An exact number.
    pub(crate) fn exact(value: f64) -> Self {
        Self { low: value, point: value, high: value }
    }

    /// A number known to within `half` either way.
    pub(crate) fn with_half_width(value: f64, half: f64) -> Self {
        Self { low: value - half, point: value, high: value + half }
    }

    /// Whether it is exactly zero.
    pub(crate) fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// Whether all three values are finite.
    pub(crate) fn is_finite(self) -> bool {
        self.low.is_finite() && self.point.is_finite() && self.high.is_finite()
    }

    /// Each value times a number.
    #[must_use]
    pub(crate) fn scaled(self, by: f64) -> Self {
        self * Self::exact(by)
    }

    /// Each value through a function that rises or falls all along the interval.
    #[must_use]
    pub(crate) fn map_monotone(self, function: impl Fn(f64) -> f64) -> Self {
        let (a, b) = (function(self.low), function(self.high));
        Self { low: a.min(b), point: function(self.point), high: a.max(b) }
    }

    /// Each value moved by a number.
    #[must_use]
    pub(crate) fn shifted(self, by: f64) -> Self {
        self + Self::exact(by)
    }

    /// One over each value, unless zero is among them.
    #[must_use]
    pub(crate) fn inverse(self) -> Option<Self> {
        (self.low > 0.0 || self.high < 0.0).then(|| self.map_monotone(|x| 1.0 / x))
    }

    /// Each value, zero if no more than the rounding of a sum with terms up to this size is left: (49 + 20√6) − 10(5 + 2√6) + 1.
    #[must_use]
    pub(crate) fn without_residue(self, largest: f64) -> Self {
        let rounded = |x: f64| if x.abs() <= RESIDUE * largest { 0.0 } else { x };
        Self { low: rounded(self.low), point: rounded(self.point), high: rounded(self.high) }
    }

    /// The sizes of the values.
    #[must_use]
    pub(crate) fn abs(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Self { low: 0.0, point: self.point.abs(), high: self.high.max(-self.low) }
        }
    }

    /// Half of the width, in the interval's own unit.
    pub(crate) fn half_width(self) -> f64 {
        (self.high - self.low) / 2.0
    }

    /// Whether two intervals meet if each is widened by `width` times the larger of their points.
    pub(crate) fn meets(self, other: Self, width: f64) -> bool {
        let size = self.point.abs().max(other.point.abs());
        let slack = (SLACK + width) * size + 1e-300;
        self.high >= other.low - slack && other.high >= self.low - slack
    }

    /// Each value to a power, if that is a number for all of them.
    pub(crate) fn power(self, exponent: Self) -> Option<Self> {
        let e = exponent.point;
        let whole = exponent.low == exponent.high && e.fract().abs() < 1e-12 && e.abs() < 1e6;
        let result = if whole {
            let n = e.round();
            if n < 0.0 && self.low <= 0.0 && self.high >= 0.0 {
                return None;
            }
            let raised = self.map_monotone(|x| libm::pow(x, n));
            let around_zero = n % 2.0 == 0.0 && self.low < 0.0 && self.high > 0.0;
            if around_zero { Self { low: 0.0, ..raised } } else { raised }
        } else {
            if self.low < 0.0 {
                return None;
            }
            let corners = [self.low, self.high].map(|x| [exponent.low, exponent.high].map(|y| libm::pow(x, y)));
            let all = corners.as_flattened();
            let low = all.iter().copied().fold(f64::INFINITY, f64::min);
            let high = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            Self { low, point: libm::pow(self.point, e), high }
        };
        result.is_finite().then_some(result)
    }
}

/// A sum, zero if no more than the rounding of its terms is left.
fn sum(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if sum.abs() <= RESIDUE * a.abs().max(b.abs()) { 0.0 } else { sum }
}

/// What the rounding of a few operations leaves, relative to their size.
pub(crate) const RESIDUE: f64 = 8.0 * f64::EPSILON;

impl std::ops::Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { low: sum(self.low, other.low), point: sum(self.point, other.point), high: sum(self.high, other.high) }
    }
}

impl std::ops::Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, point: -self.point, high: -self.low }
    }
}

impl std::ops::Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let corners = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        let low = corners.iter().copied().fold(f64::INFINITY, f64::min);
        let high = corners.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self { low, point: self.point * other.point, high }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_take_the_outermost_corners() {
        let x = Interval { low: -1.0, point: 1.0, high: 2.0 };
        assert_eq!(x * Interval::with_half_width(3.0, 1.0), Interval { low: -4.0, point: 3.0, high: 8.0 });
        assert_eq!(x.abs(), Interval { low: 0.0, point: 1.0, high: 2.0 });
        assert_eq!(x.inverse(), None);
    }

    #[test]
    fn even_powers_around_zero_begin_at_zero() {
        let x = Interval { low: -2.0, point: 0.5, high: 1.0 };
        let squared = x.power(Interval::exact(2.0)).expect("a square");
        assert_eq!((squared.low, squared.high), (0.0, 4.0));
        assert_eq!(x.power(Interval::exact(0.5)), None);
        assert_eq!(x.power(Interval::exact(-1.0)), None);
        assert_eq!(Interval::exact(10.0).power(Interval::exact(400.0)), None);
    }

    #[test]
    fn what_rounding_leaves_of_a_sum_is_zero() {
        let exact = Interval::exact;
        assert_ne!(0.1 + 0.2 - 0.3, 0.0);
        assert!((exact(0.1) + exact(0.2) + exact(-0.3)).is_zero());
        assert!(!(exact(1.0) + exact(-1.0 + 1e-13)).is_zero());
    }

    #[test]
    fn meeting_is_symmetric_and_forgives_rounding() {
        let (a, b) = (Interval::with_half_width(1.0, 0.05), Interval::with_half_width(1.1, 0.05));
        assert!(a.meets(b, 0.0) && b.meets(a, 0.0));
        assert!(!a.meets(Interval::with_half_width(1.2, 0.05), 0.0));
    }
}
