//! Numbers as people write them.

use crate::decimal::{fixed, parse_decimal, scientific};
use crate::evaluate::printed::power_of_ten;

/// A number of so many significant digits, without a sign; `trims` leaves zeros at the end of its decimals out.
pub(crate) fn significant(size: f64, digits: usize, trims: bool) -> String {
    let digits = digits.clamp(1, 15);
    if size == 0.0 || !size.is_finite() {
        return fixed(size, 0);
    }
    let text = scientific(size, digits - 1);
    let (_, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let places = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
    let text = fixed(parse_decimal(&text).unwrap_or(size), places);
    match trims && text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// Digits, and perhaps decimals behind them, with commas between thousands.
pub(crate) fn part_thousands(digits: &str) -> String {
    let (whole, decimals) = digits.split_at(digits.find('.').unwrap_or(digits.len()));
    let mut text = String::new();
    for (at, digit) in whole.char_indices() {
        if at > 0 && (whole.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text + decimals
}

/// A number with a minus sign, if it is negative.
pub(crate) fn signed(size: String, is_negative: bool) -> String {
    if is_negative { format!("−{size}") } else { size }
}

/// A size as a number from 1 to 10 with so many digits, and a power of ten.
pub(crate) fn power_form(size: f64, digits: usize) -> String {
    let text = scientific(size, digits.clamp(1, 15) - 1);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{mantissa} × 10^{exponent}").replace("^-", "^−")
}

/// A number with so many digits: a whole one as it is, a very large or small one with a power of ten.
pub(crate) fn sized(value: f64, digits: usize) -> String {
    let size = value.abs();
    let is_whole = (size - libm::round(size)).abs() < 1e-12 * size;
    let text = match () {
        () if size == 0.0 => "0".to_owned(),
        () if is_whole && size < 1e9 => fixed(size, 0),
        () if (1e-4..1e6).contains(&size) => significant(size, digits, false),
        () => power_form(size, digits),
    };
    signed(text, value < 0.0)
}

/// Largest denominator of a fraction that is shown as one.
const LARGEST_BELOW: f64 = 1000.0;

/// The fraction of two integers that a number is, in lowest terms; none if its denominator is beyond a thousand.
pub(crate) fn rational(value: f64) -> Option<(f64, f64)> {
    let size = value.abs();
    if !size.is_finite() || size > power_of_ten(9.0) {
        return None;
    }
    let (mut rest, mut before, mut last) = (size, (0.0, 1.0), (1.0, 0.0));
    for _ in 0..20 {
        let whole = libm::floor(rest);
        let next: (f64, f64) = (whole * last.0 + before.0, whole * last.1 + before.1);
        if next.1 > LARGEST_BELOW {
            return None;
        }
        (before, last) = (last, next);
        if (last.0 / last.1 - size).abs() <= 1e-10 * size {
            return Some((if value < 0.0 { -last.0 } else { last.0 }, last.1));
        }
        rest = 1.0 / (rest - whole);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_with_as_many_digits_as_asked() {
        for (value, digits, expected) in [
            (0.577_35, 3, "0.577"),
            (4210.4, 4, "4210"),
            (-1.234e-7, 2, "−1.2 × 10^−7"),
            (12.0, 3, "12"),
            (0.0, 3, "0"),
            (2.5e12, 3, "2.50 × 10^12"),
        ] {
            assert_eq!(sized(value, digits), expected);
        }
        assert_eq!(significant(1.999_9, 3, true), "2");
        assert_eq!(significant(0.1, 15, false), "0.100000000000000");
    }

    #[test]
    fn fractions_are_in_lowest_terms() {
        assert_eq!(rational(0.75), Some((3.0, 4.0)));
        assert_eq!(rational(-7.0 / 12.0), Some((-7.0, 12.0)));
        assert_eq!(rational(5.0), Some((5.0, 1.0)));
        assert_eq!(rational(std::f64::consts::PI), None);
        assert_eq!(rational(1.0 / 1001.0), None);
    }
}
