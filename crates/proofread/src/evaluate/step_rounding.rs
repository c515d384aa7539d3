//! What happens to digits on the way to a result: quotients, roots and functions that may have been rounded before they went on, and
//! differences that leave few of the digits of their terms.

use crate::evaluate::interval::Interval;
use crate::evaluate::printed::power_of_ten;
use crate::evaluate::value::{Literal, SideValue};

/// The rounding on the way to a result.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct StepRounding {
    /// To how many significant digits quotients, roots, powers and functions are rounded; not at all if none.
    pub digits: Option<i32>,
    /// Whether a difference lost most of the digits of its terms.
    pub cancels: bool,
    /// Whether one of these terms is more than a printed integer, which has no other digits.
    pub cancels_decimals: bool,
    /// The last value that was rounded, without its rounding and with it.
    last: Option<[Interval; 2]>,
}

/// How small a difference is, relative to its larger term, if it lost digits.
const SMALL: f64 = 0.3;

impl StepRounding {
    /// Rounding to so many significant digits.
    pub(crate) fn to_digits(digits: i32) -> Self {
        Self { digits: Some(digits), ..Self::default() }
    }

    /// A value as it may go on.
    pub(crate) fn round(&mut self, value: SideValue) -> SideValue {
        let (Some(digits), Ok(before)) = (self.digits, value.number()) else { return value };
        let point = before.point.abs();
        if point == 0.0 || !point.is_finite() {
            return value;
        }
        let half = 0.5 * power_of_ten(libm::floor(libm::log10(point)) - f64::from(digits - 1));
        let after = Interval { low: before.low - half, point: before.point, high: before.high + half };
        self.last = Some([before, after]);
        SideValue { parts: value.parts.map(|_| after), ..value }
    }

    /// A whole side, whose last value did not go on.
    pub(crate) fn result(&self, value: SideValue) -> SideValue {
        match (self.last, value.number()) {
            (Some([before, after]), Ok(number)) if number == after => {
                SideValue { parts: value.parts.map(|_| before), ..value }
            }
            _ => value,
        }
    }

    /// Notes whether the sum of two terms lost their digits.
    pub(crate) fn note_sum(&mut self, terms: [&SideValue; 2], sum: &SideValue) {
        let [Ok(one), Ok(other), Ok(sum)] = [terms[0], terms[1], sum].map(SideValue::number) else { return };
        let open = one.half_width() > 0.0 || other.half_width() > 0.0;
        let size = one.point.abs().max(other.point.abs());
        let cancels = open && sum.point.abs() < SMALL * size;
        let is_integer = |term: &SideValue, of: Interval| term.literal == Literal::Number && of.point.fract() == 0.0;
        self.cancels |= cancels;
        self.cancels_decimals |= cancels && !(is_integer(terms[0], one) && is_integer(terms[1], other));
    }
}

/// How many significant digits a printed result has; none if nothing is open.
pub(crate) fn significant_digits(printed: Interval) -> Option<i32> {
    let (size, unit) = (printed.point.abs(), 2.0 * printed.half_width());
    (unit > 0.0 && size > 0.0).then(|| libm::floor(libm::log10(size / unit * 1.000_001)) as i32 + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_counted_from_the_first_that_is_not_zero() {
        let digits = |value: f64, half: f64| significant_digits(Interval::with_half_width(value, half));
        assert_eq!(digits(8.65, 0.005), Some(3));
        assert_eq!(digits(0.0100, 0.000_05), Some(3));
        assert_eq!(digits(9.6, 0.05), Some(2));
        assert_eq!(digits(15_000.0, 500.0), Some(2));
        assert_eq!(digits(1.0, 0.0), None);
    }

    #[test]
    fn only_what_goes_on_was_rounded() {
        let mut steps = StepRounding::to_digits(3);
        let root = steps.round(SideValue::from_interval(Interval::exact(1.732_05)));
        assert!((root.number().expect("a number").half_width() - 0.005).abs() < 1e-12);
        assert_eq!(steps.result(root).number().expect("a number"), Interval::exact(1.732_05));
    }
}
