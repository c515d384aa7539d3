//! Printed digits, and the interval that they leave open.

use crate::decimal::{POWERS_OF_TEN, parse_decimal};
use std::borrow::Cow;

/// How much a printed number leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Nothing: the digits as they are.
    Point,
    /// Inside an expression: half a unit of the last decimal; an integer of three or more digits likewise.
    Strict,
    /// Inside an expression, with integers that may have been rounded to tens.
    Lenient,
    /// Alone as a result: half a unit of the last place, or of the last place that is not zero in an integer.
    Result,
}

/// A number as printed, without its sign.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PrintedNumber {
    /// The value of the digits, dimensionless.
    pub value: f64,
    /// Digits behind the point; none if there is no point.
    pub decimals: Option<usize>,
    digits: usize,
    trailing_zeros: usize,
    /// Whether dots stand for the digits that follow.
    goes_on: bool,
}

impl PrintedNumber {
    /// Reads digits with at most one point and commas between thousands.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let (text, goes_on) = text.strip_suffix('…').map_or((text, false), |text| (text, true));
        let plain = if text.contains(',') { Cow::Owned(text.replace(',', "")) } else { Cow::Borrowed(text) };
        let allowed = |c: char| c.is_ascii_digit() || c == '.';
        if !plain.chars().all(allowed) || !plain.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let value = parse_decimal(&plain).filter(|value| value.is_finite())?;
        let decimals = plain.split_once('.').map(|(_, behind)| behind.len());
        let trailing = plain.len() - plain.trim_end_matches('0').len();
        // What follows the dots is anything up to the next digit.
        let more = if goes_on { 0.5 * power_of_ten(-(decimals.unwrap_or(0) as f64)) } else { 0.0 };
        Some(Self {
            value: value + more,
            goes_on,
            decimals,
            digits: plain.trim_start_matches('0').len(),
            trailing_zeros: if value == 0.0 || decimals.is_some() { 0 } else { trailing },
        })
    }

    /// Half of what the digits leave open, and one unit of the last place, both dimensionless. `scaled` says that a power of
    /// ten follows.
    pub(crate) fn open(&self, mode: Mode, scaled: bool) -> (f64, f64) {
        if let Some(decimals) = self.decimals {
            let unit = power_of_ten(-(decimals as f64));
            return (if mode == Mode::Point && !self.goes_on { 0.0 } else { unit / 2.0 }, unit);
        }
        let exact_one = self.value == 1.0;
        match mode {
            Mode::Point => (0.0, 1.0),
            Mode::Result if exact_one && !scaled => (0.0, 1.0),
            Mode::Result => {
                let unit = if scaled { 1.0 } else { power_of_ten(self.trailing_zeros as f64) };
                (unit / 2.0, unit)
            }
            Mode::Strict => (if self.digits >= 3 && !scaled { 0.5 } else { 0.0 }, 1.0),
            Mode::Lenient if scaled => (0.5, 1.0),
            Mode::Lenient => {
                let half = match self.digits {
                    0 | 1 => 0.0,
                    2 => 0.5,
                    _ => power_of_ten((self.trailing_zeros as f64 - 1.0).max(0.0)) / 2.0,
                };
                (half, 1.0)
            }
        }
    }
}

/// Ten to a power, the same on every machine.
pub(crate) fn power_of_ten(exponent: f64) -> f64 {
    if exponent.fract() == 0.0 && exponent.abs() <= 400.0 {
        let exponent = exponent as i32;
        // Up to here the powers themselves are exact, and so the quotient is the nearest number to the power below one.
        return match POWERS_OF_TEN.get(exponent.unsigned_abs() as usize) {
            Some(power) if exponent >= 0 => *power,
            Some(power) => 1.0 / power,
            None => parse_decimal(&format!("1e{exponent}")).unwrap_or(f64::INFINITY),
        };
    }
    libm::pow(10.0, exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_ten_is_the_nearest_number_to_it() {
        for exponent in -330..=310 {
            let nearest: f64 = format!("1e{exponent}").parse().expect("a number");
            assert_eq!(power_of_ten(f64::from(exponent)), nearest, "{exponent}");
        }
    }

    #[test]
    fn the_last_place_says_how_much_is_open() {
        let half = |text: &str, mode| PrintedNumber::read(text).expect("a number").open(mode, false).0;
        for (text, mode, expected) in [
            ("0.50", Mode::Result, 0.005),
            ("2300", Mode::Result, 50.0),
            ("1", Mode::Result, 0.0),
            ("7", Mode::Result, 0.5),
            ("7", Mode::Strict, 0.0),
            ("1,234", Mode::Strict, 0.5),
            ("12.5", Mode::Point, 0.0),
            ("1500", Mode::Lenient, 5.0),
        ] {
            assert!((half(text, mode) - expected).abs() < 1e-12, "{text} {mode:?}");
        }
        assert_eq!(PrintedNumber::read("1,234.50").map(|of| (of.value, of.decimals)), Some((1234.5, Some(2))));
        for text in ["", ".", "1.2.3", "abc", "1e3"] {
            assert_eq!(PrintedNumber::read(text), None, "{text}");
        }
    }
}
