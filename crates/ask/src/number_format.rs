//! Numbers as a sheet, a title or a message writes them.

/// A number that was typed, with all its digits, in a form that can be typed again. A zero has no sign.
pub fn as_typed(value: f64) -> String {
    let written = format!("{:?}", value + 0.0);
    written.strip_suffix(".0").map_or(written.clone(), str::to_owned)
}

/// A computed limit in a message, to four significant digits: never below it, so that what is said of it holds.
pub fn rounded_up(limit: f64) -> String {
    as_typed(to_one_side(limit, 1.0, DIGITS))
}

/// A computed limit in a message, to four significant digits: never above it, so that a number up to it is accepted.
pub fn rounded_down(limit: f64) -> String {
    as_typed(to_one_side(limit, -1.0, DIGITS))
}

/// The greatest number of so many significant digits, one or more, that is no greater than `limit`, up to what is lost in
/// computing, the difference of two lengths a thousand times as great: what is 0.04 to twelve digits is 0.04.
pub fn no_greater(limit: f64, digits: usize) -> f64 {
    to_one_side(format!("{limit:.11e}").parse().unwrap_or(limit), -1.0, digits)
}

/// `limit` to so many significant digits, never on the other side of it than `side`, which is 1 or −1.
fn to_one_side(limit: f64, side: f64, digits: usize) -> f64 {
    let behind = digits.max(1) - 1;
    let nearest: f64 = format!("{limit:.behind$e}").parse().unwrap_or(limit);
    let half: f64 = format!("5e{}", exponent(&format!("{limit:e}")) - 1 - behind as i32).parse().unwrap_or(0.0);
    let is_safe = (nearest - limit) * side >= 0.0;
    if is_safe { nearest } else { format!("{:.behind$e}", limit + side * half).parse().unwrap_or(limit) }
}

/// The power of ten of a number that is written with one, as by `{:e}`.
fn exponent(scientific: &str) -> i32 {
    scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// The number that a reader would have typed: rounded to fifteen digits, which any number between typed ones may need.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// Significant digits of a number on a sheet.
const DIGITS: usize = 4;

/// Degrees that are zero but for rounding.
const NO_ANGLE: f64 = 1e-9;

/// `value` with four significant digits and a true minus sign: trailing zeros kept, and no more zeros than a reader
/// counts.
pub fn number(value: f64) -> String {
    to_digits(value, DIGITS)
}

/// `value` as by [`number`], with other than four significant digits, one or more.
pub fn to_digits(value: f64, digits: usize) -> String {
    let behind = digits.max(1) - 1;
    let scientific = format!("{value:.behind$e}");
    let exponent = exponent(&scientific);
    let number = match usize::try_from(behind as i32 - exponent) {
        _ if value == 0.0 => "0".to_owned(),
        Ok(decimals) if decimals < 2 * DIGITS => format!("{value:.decimals$}"),
        Err(_) if exponent < 2 * DIGITS as i32 => format!("{value:.0}"),
        _ => scientific,
    };
    geneva_figures::with_minus_sign(&number)
}

/// A length in millimetres in inches, to a thousandth, or to a ten-thousandth below a tenth; a limit is rounded towards zero.
pub fn inches(millimetres: f64, is_limit: bool) -> String {
    let inches = millimetres / MILLIMETRES_OF_AN_INCH;
    let (decimals, scale) = if inches.abs() < 0.1 { (4, 1e4) } else { (3, 1e3) };
    let rounded = if is_limit {
        // What is lost in computing is no part of a limit.
        (no_greater(inches.abs(), DIGITS_OF_A_LIMIT) * scale).floor().copysign(inches) / scale
    } else {
        inches
    };
    geneva_figures::with_minus_sign(&format!("{:.decimals$} in", rounded + 0.0))
}

/// Millimetres of an inch, by definition.
pub(crate) const MILLIMETRES_OF_AN_INCH: f64 = 25.4;

/// Significant digits of a limit before it is rounded to decimals.
const DIGITS_OF_A_LIMIT: usize = 10;

/// An angle in degrees with as many digits. Zero and the half turn have no sign.
pub fn angle(degrees: f64) -> String {
    let written = number(if degrees.abs() <= NO_ANGLE { 0.0 } else { degrees });
    if written == number(-180.0) { number(180.0) } else { written }
}

/// The size of an angle in radians, in degrees, as it appears in a sentence.
pub(crate) fn degrees(radians: f64) -> String {
    number(radians.abs().to_degrees())
}

/// "1 claim", "2 claims".
pub fn count(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_few_digits_and_no_long_rows_of_zeros() {
        let written = [0.0, 2.0, -1.0 / 3.0, 99.999, 12_345.6, 1e9, 1e-9].map(number);
        assert_eq!(written, ["0", "2.000", "−0.3333", "100.0", "12346", "1.000e9", "1.000e−9"]);
        assert_eq!([-1e-15, 1e-3, -179.999_99, 180.0, -30.0].map(angle), ["0", "0.001000", "180.0", "180.0", "−30.00"]);
    }

    #[test]
    fn inches_have_thousandths_and_short_ones_a_digit_more() {
        let plain = [25.4, 12.7, 86.720_1, -0.5, 0.02, 2.54, 0.0].map(|length| inches(length, false));
        assert_eq!(plain, ["1.000 in", "0.500 in", "3.414 in", "−0.0197 in", "0.0008 in", "0.100 in", "0.0000 in"]);
        // 0.049 mm are 0.00193 in; what holds must not be told larger.
        let limits = [0.049, 0.0254, 2.539_9, 3.0, -0.049].map(|length| inches(length, true));
        assert_eq!(limits, ["0.0019 in", "0.0010 in", "0.0999 in", "0.118 in", "−0.0019 in"]);
    }

    #[test]
    fn a_limit_is_rounded_to_the_side_on_which_it_holds() {
        assert_eq!([as_typed(-0.0), as_typed(-0.5)], ["0", "-0.5"]);
        assert_eq!([0.1 + 0.2, 3e-4 * 3.0, 0.0].map(rounded), [0.3, 9e-4, 0.0]);
        let limits = [0.424_956_373_400_169_8, 0.424_956_9, 2.0, 1.6e-16, 0.999_999_9].map(rounded_up);
        assert_eq!(limits, ["0.425", "0.425", "2", "1.6e-16", "1"]);
        let limits = [19.471_220_634_490_69, 25.714_285_714_285_715, 90.0, 13.846_153_846_153_847].map(rounded_down);
        assert_eq!(limits, ["19.47", "25.71", "90", "13.84"]);
        // On a sheet with two digits; what is lost in computing is no part of a limit.
        let limits =
            [0.034_99, 0.035_01, 0.04 * (1.0 - 1e-13), 0.04 * (1.0 - 1e-11), 127.0].map(|limit| no_greater(limit, 2));
        assert_eq!(limits, [0.034, 0.035, 0.04, 0.039, 120.0]);
        assert_eq!(to_digits(no_greater(0.010_04, 2), 2), "0.010");
    }
}
