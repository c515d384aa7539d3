//! Our numbers in a sentence: what a chapter says with a number that no source prints.

mod built;
mod escapement;
mod found;
mod front;
mod jazar;
mod joints;
pub mod making;
mod method;
mod mimic;
mod mistake;
mod never_printed;
mod pin;
mod program;
pub mod runs;
mod solver;
mod terminal_speed;
pub mod timer;
mod wild;

use crate::{lookup, numbers};

/// A number with its unit, as HTML.
pub type Number = fn() -> anyhow::Result<String>;

/// The numbers of each chapter.
const ALL: &[&[(&str, Number)]] = &[
    built::NUMBERS,
    escapement::NUMBERS,
    found::NUMBERS,
    front::NUMBERS,
    jazar::NUMBERS,
    joints::NUMBERS,
    making::NUMBERS,
    making::ADVICE,
    method::NUMBERS,
    mimic::NUMBERS,
    mistake::NUMBERS,
    never_printed::NUMBERS,
    pin::NUMBERS,
    program::NUMBERS,
    runs::NUMBERS,
    solver::NUMBERS,
    terminal_speed::NUMBERS,
    timer::NUMBERS,
    wild::NUMBERS,
];

/// The names of all numbers; each is said in some chapter.
pub fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().copied().flatten().map(|(name, _)| *name)
}

/// The number of this name.
pub fn by_name(name: &str) -> anyhow::Result<String> {
    let found = ALL.iter().copied().flatten().find(|(known, _)| *known == name).map(|(_, number)| number);
    found.ok_or_else(|| lookup::unknown("number", name, names()))?()
}

/// A number to so many significant digits, trailing zeros kept, with its unit.
pub(crate) fn with_unit(number: f64, digits: i32, unit: &str) -> String {
    let after_first = usize::try_from(digits - 1).unwrap_or(0);
    let scientific = format!("{number:.after_first$e}");
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0);
    let decimals = usize::try_from(digits - 1 - exponent).unwrap_or(0);
    format!("{}&nbsp;{unit}", numbers::fixed(scientific.parse().unwrap_or(number), decimals))
}

/// An angle in degrees with one decimal.
fn degrees(radians: f64) -> String {
    format!("{:.1}°", radians.to_degrees())
}

/// The least of some numbers.
fn least(all: &[f64]) -> f64 {
    all.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The greatest of some numbers.
fn most(all: &[f64]) -> f64 {
    all.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use super::with_unit;

    #[test]
    fn digits_count_from_the_first() {
        let written = [0.0999, 9.999, 233.32, 1234.5, -4.1].map(|number| with_unit(number, 3, "m"));
        assert_eq!(written, ["0.0999&nbsp;m", "10.0&nbsp;m", "233&nbsp;m", "1230&nbsp;m", "−4.10&nbsp;m"]);
    }
}
