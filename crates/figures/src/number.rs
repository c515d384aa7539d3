//! Numbers as text: rounded explicitly, and zero without a sign.

use geneva_dynamics::Parameters;

/// `value` with so many digits after the point; a value that rounds to zero has no sign.
pub(crate) fn format_fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| b == b'0' || b == b'.') => digits.to_owned(),
        _ => text,
    }
}

/// `value` rounded to so many digits after the point, written without trailing zeros: coordinates and angles.
pub(crate) fn format_trimmed(value: f64, decimals: usize) -> String {
    let text = format_fixed(value, decimals);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// `value` rounded to so many significant digits (at least one), trailing zeros kept.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    let after_first = digits.saturating_sub(1);
    let rounded = format!("{value:.after_first$e}").parse().unwrap_or(value);
    let decimals = usize::try_from(after_first as i32 - exponent(rounded)).unwrap_or(0);
    format_fixed(rounded, decimals)
}

/// A number of pins as a word.
pub(crate) fn count_word(pins: u32) -> &'static str {
    match pins {
        3 => "three",
        4 => "four",
        _ => "six",
    }
}

/// Which escapement a figure shows, as its caption ends: pins, friction and the ratio of the inertias.
pub(crate) fn describe_parameters(parameters: &Parameters) -> String {
    format!(
        "Shown: {} pins and {} slots, friction μ = {}, ratio of the driver's moment of inertia to the follower's: {}.",
        parameters.mechanism().pins(),
        parameters.mechanism().slots(),
        format_trimmed(parameters.friction(), 4),
        significant(parameters.inertias().ratio(), 2)
    )
}

/// `value`, or zero where it is nothing but rounding error beside a value of the size of `scale`.
pub(crate) fn without_noise(value: f64, scale: f64) -> f64 {
    if value.abs() <= 1e-12 * scale.abs() { 0.0 } else { value }
}

/// Puts a minus sign in place of each hyphen of a text, for display.
pub fn with_minus_sign(text: &str) -> String {
    text.replace('-', "−")
}

/// Puts the typographic hyphen, which a label does not take for a minus sign, in place of each hyphen of a text.
pub(crate) fn with_hyphens(text: &str) -> String {
    text.replace('-', "\u{2010}")
}

/// An angle given in radians, as text: degrees to a tenth, with their sign.
pub(crate) fn degrees(radians: f64) -> String {
    with_minus_sign(&format!("{}°", format_trimmed(radians.to_degrees(), 1)))
}

/// A number to so many significant digits, with a power of ten if it is very small or large; zero is 0.
pub(crate) fn short(value: f64, digits: usize) -> String {
    let text = match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e6).contains(&size) => significant(value, digits),
        size => {
            let scientific = format!("{value:.*e}", digits.saturating_sub(1));
            let mantissa = scientific.split_once('e').map_or("", |(mantissa, _)| mantissa);
            let rounded = scientific.parse::<f64>().map_or(size, f64::abs);
            format!("{mantissa}·{}", power_of_ten(rounded))
        }
    };
    with_minus_sign(&text)
}

/// A number with all its digits, with a power of ten if it is very small or large.
pub(crate) fn whole(value: f64) -> String {
    let text = match value.abs() {
        size if size == 0.0 || (1e-3..1e6).contains(&size) => (value + 0.0).to_string(),
        size => {
            let scientific = format!("{value:e}");
            let mantissa = scientific.split_once('e').map_or("", |(mantissa, _)| mantissa);
            format!("{mantissa}·{}", power_of_ten(size))
        }
    };
    with_minus_sign(&text)
}

/// The exponent of the power of ten not above the size of a number; 0 for zero.
pub(crate) fn exponent(value: f64) -> i32 {
    format!("{value:e}").split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// A power of ten.
pub(crate) fn power(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(1.0)
}

/// The power of ten not above a positive value: 10⁻³.
pub(crate) fn power_of_ten(value: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let scientific = format!("{value:e}");
    let exponent = scientific.split_once('e').map_or("0", |(_, exponent)| exponent);
    let raised = |c: char| c.to_digit(10).and_then(|digit| DIGITS.get(digit as usize)).copied().unwrap_or('⁻');
    format!("10{}", exponent.chars().map(raised).collect::<String>())
}

/// The least and the greatest of some numbers; without any, infinity and its negative.
pub(crate) fn extent(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    values
        .into_iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| [least.min(value), most.max(value)])
}

/// The smallest of 1, 2, 2.5 and 5 times a power of ten that is not below `least`; 1 if `least` is no positive number.
pub(crate) fn round_step(least: f64) -> f64 {
    if !(least > 0.0 && least.is_finite()) {
        return 1.0;
    }
    let exponent = exponent(least);
    let decade = power(exponent);
    let slack = 1.0 - 1e-9;
    [1.0, 2.0, 2.5, 5.0]
        .map(|m| m * decade)
        .into_iter()
        .find(|step| *step >= least * slack)
        .unwrap_or(power(exponent + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(
            [format_fixed(-0.0, 3), format_fixed(-0.0004, 3), format_fixed(-0.0006, 3)],
            ["0.000", "0.000", "-0.001"]
        );
        assert_eq!([format_trimmed(-0.0004, 3), format_trimmed(2.5, 3), format_trimmed(100.0, 0)], ["0", "2.5", "100"]);
    }

    #[test]
    fn significant_digits_count_from_the_first() {
        let written = [significant(0.0, 4), significant(7.0, 4), significant(99.996, 4), significant(123_456.0, 4)];
        assert_eq!(written, ["0.000", "7.000", "100.0", "123500"]);
        assert_eq!(significant(-0.012_345, 3), "-0.0123");
    }

    #[test]
    fn only_what_is_lost_in_rounding_counts_as_noise() {
        assert_eq!([without_noise(-3e-13, 2.0), without_noise(-3e-11, 2.0)], [0.0, -3e-11]);
    }

    #[test]
    fn very_small_and_large_numbers_have_a_power_of_ten() {
        let texts = [0.0, -2.5, 0.012_345, 123_456.0, -1.5e-6, 9.999_99e11].map(|value| short(value, 4));
        assert_eq!(texts, ["0", "−2.500", "0.01235", "123500", "−1.500·10⁻⁶", "1.000·10¹²"]);
    }

    #[test]
    fn a_whole_number_loses_no_digit() {
        let texts = [0.0, -1.000_002, 123_456.0, -1.5e-6, 1e300].map(whole);
        assert_eq!(texts, ["0", "−1.000002", "123456", "−1.5·10⁻⁶", "1·10³⁰⁰"]);
    }

    #[test]
    fn powers_of_ten_are_raised() {
        assert_eq!([1.0, 1e-12, 2e15].map(power_of_ten), ["10⁰", "10⁻¹²", "10¹⁵"]);
    }

    #[test]
    fn steps_are_round() {
        assert_eq!([round_step(0.8), round_step(1.0), round_step(21.0), round_step(0.06)], [1.0, 1.0, 25.0, 0.1]);
        assert_eq!([round_step(0.0), round_step(f64::NAN)], [1.0, 1.0]);
    }
}
