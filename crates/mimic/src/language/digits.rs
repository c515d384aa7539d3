//! Numbers in messages.

/// A number in a message: eight significant digits, and a power of ten rather than a row of zeros.
pub(super) fn eight_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.7e}").parse().unwrap_or(value);
    let text = format!("{rounded:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}
