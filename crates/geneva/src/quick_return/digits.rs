//! Numbers as they stand on the sheet.

use crate::sheet::DIGITS;

/// A number with [`DIGITS`] significant digits and a true minus sign.
pub fn number(value: f64) -> String {
    crate::sheet::number(value).replace('-', "−")
}

/// Degrees that are zero but for rounding.
const NO_ANGLE: f64 = 1e-9;

/// An angle in degrees, from above −180 to 180, with as many digits.
pub fn angle(degrees: f64) -> String {
    let written = number(if degrees.abs() <= NO_ANGLE { 0.0 } else { degrees });
    // What is rounded to the half turn is on neither side of it.
    if written == number(-180.0) { number(180.0) } else { written }
}

/// The direction of a vector in degrees, from above −180 to 180, with as many decimals as its neighbours in a column.
pub fn direction(degrees: f64) -> String {
    match format!("{degrees:.2}").as_str() {
        "-0.00" => "0.00".to_owned(),
        "-180.00" => "180.00".to_owned(),
        written => written.replace('-', "−"),
    }
}

/// A number that was typed, with all its digits, as it can be typed again.
pub fn typed(value: f64) -> String {
    let (plain, scientific) = (format!("{value}"), format!("{value:e}"));
    if plain.len() > 4 * DIGITS && scientific.len() < plain.len() { scientific } else { plain }
}

#[cfg(test)]
mod tests {
    use super::{angle, direction, number, typed};

    #[test]
    fn numbers_have_a_few_digits_and_no_long_rows_of_zeros() {
        let written = [0.0, 2.0, -1.0 / 3.0, 99.999, 12_345.6, 1e9, 1e-9].map(number);
        assert_eq!(written, ["0", "2.000", "−0.3333", "100.0", "12346", "1.000e9", "1.000e−9"]);
    }

    #[test]
    fn an_angle_that_is_rounded_to_nothing_or_to_a_half_turn_has_no_sign() {
        assert_eq!([-1e-15, 1e-3, -179.999_99, 180.0, -30.0].map(angle), ["0", "0.001000", "180.0", "180.0", "−30.00"]);
        assert_eq!([-1e-3, -179.999, -7.5].map(direction), ["0.00", "180.00", "−7.50"]);
    }

    #[test]
    fn what_was_typed_is_told_back() {
        assert_eq!([-60.0, 0.125, 1e-20, 1e30].map(typed), ["-60", "0.125", "1e-20", "1e30"]);
    }
}
