//! Numbers as the pages show them.

use geneva_figures::with_minus_sign;

/// A number with so many decimals.
pub fn fixed(number: f64, decimals: usize) -> String {
    with_minus_sign(&format!("{number:.decimals$}"))
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
    fn a_minus_is_no_hyphen_and_zero_has_no_sign() {
        assert_eq!([fixed(-7.5, 1), signed(-7.5, 1), signed(7.5, 1)], ["−7.5", "−7.5", "+7.5"]);
        assert_eq!([signed(-0.04, 1), signed(0.0, 0)], ["0.0", "0"]);
    }
}
