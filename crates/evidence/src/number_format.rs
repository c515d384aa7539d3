//! Numbers as pages show them.

/// Puts a minus sign in place of each hyphen of a text.
pub fn with_minus_sign(text: &str) -> String {
    text.replace('-', "−")
}

/// A number with so many decimals.
pub fn fixed(number: f64, decimals: usize) -> String {
    with_minus_sign(&format!("{number:.decimals$}"))
}

/// A number to so many digits that count, zeros at its end kept.
pub fn significant(number: f64, digits: usize) -> String {
    let scientific = format!("{number:.*e}", digits.saturating_sub(1));
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0);
    let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
    fixed(scientific.parse().unwrap_or(number), decimals)
}

/// A number with so many decimals and its sign; a zero has none.
pub fn signed(number: f64, decimals: usize) -> String {
    let text = format!("{number:+.decimals$}");
    let is_zero = !text.contains(|c: char| c.is_ascii_digit() && c != '0');
    if is_zero { text[1..].to_owned() } else { with_minus_sign(&text) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_count_from_the_first() {
        let written = [0.0999, 9.999, 233.32, 1234.5, -4.1].map(|number| significant(number, 3));
        assert_eq!(written, ["0.0999", "10.0", "233", "1230", "−4.10"]);
    }

    #[test]
    fn a_minus_is_no_hyphen_and_zero_has_no_sign() {
        assert_eq!([fixed(-7.5, 1), signed(-7.5, 1), signed(7.5, 1)], ["−7.5", "−7.5", "+7.5"]);
        assert_eq!([signed(-0.04, 1), signed(0.0, 0)], ["0.0", "0"]);
    }
}
