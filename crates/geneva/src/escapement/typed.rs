//! Numbers as they are typed, and as they are told back.

use anyhow::{anyhow, ensure};
use std::ops::RangeInclusive;

/// Torques and inertias whose quotients and products are numbers of full precision, far outside of any machine.
const COMPUTABLE: RangeInclusive<f64> = 1e-30..=1e30;

/// A number of slots; which are possible, the library says.
pub fn slots(text: &str) -> Result<u32, &'static str> {
    text.trim().parse().map_err(|_| "not a number of slots; give 3, 4 or 6")
}

/// A number that should be above zero.
pub fn positive(text: &str) -> Result<f64, &'static str> {
    number(text).ok_or("not a number; give one above zero, with a point before its decimals")
}

/// A number that may be zero.
pub fn plain(text: &str) -> Result<f64, &'static str> {
    number(text).ok_or("not a number; give zero or more, with a point before the decimals")
}

/// An angle.
pub fn degrees(text: &str) -> Result<f64, &'static str> {
    number(text).ok_or("not an angle; give degrees, with a point before the decimals")
}

/// A number, with either of the signs for minus: the sheet has the typographer's.
pub fn number(text: &str) -> Option<f64> {
    text.trim().replace('−', "-").parse().ok()
}

/// A number that was typed, with all its digits, as it can be typed again.
pub fn again(value: f64) -> String {
    let written = format!("{value:?}");
    written.strip_suffix(".0").map_or(written.clone(), str::to_owned)
}

/// The number that a reader would have typed: rounded to fifteen digits, which any number between typed ones may need.
pub fn neat(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// The value of an option, if it is above zero and can be computed with.
pub fn computable(option: &str, value: f64) -> anyhow::Result<f64> {
    ensure!(
        value > 0.0 && value.is_finite(),
        "{option} {}: it must be positive and finite; give a number above zero",
        again(value)
    );
    ensure!(COMPUTABLE.contains(&value), beyond(option, value));
    Ok(value)
}

/// The coefficient of friction, if there can be such a one.
pub fn friction(option: &str, value: f64) -> anyhow::Result<f64> {
    ensure!(
        value >= 0.0 && value.is_finite(),
        "{option} {}: it must be finite and not negative; give zero or more",
        again(value)
    );
    // A zero has no sign.
    Ok(value + 0.0)
}

/// A value is allowed, but what follows from it is no number that can be held.
fn beyond(option: &str, value: f64) -> anyhow::Error {
    let (least, most) = (COMPUTABLE.start(), COMPUTABLE.end());
    anyhow!(
        "{option} {}: too large or too small to compute with; give one that a machine can have, between {least:e} and \
         {most:e}",
        again(value)
    )
}

#[cfg(test)]
mod tests {
    use super::{again, neat, number};

    #[test]
    fn what_was_typed_is_told_back() {
        for text in ["-60", "0.125", "1e-20", "1e30", "4e-6", "0.3", "2"] {
            assert_eq!(number(text).map(again).as_deref(), Some(text));
        }
        assert_eq!(number(" −7 "), Some(-7.0));
        assert_eq!(number("0,3"), None);
        assert_eq!([0.1 + 0.2, 3e-4 * 3.0, 0.0].map(neat), [0.3, 9e-4, 0.0]);
    }
}
