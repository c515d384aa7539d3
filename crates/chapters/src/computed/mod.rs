//! Our numbers in a sentence: what a chapter says with a number that no source prints.

mod built;
mod escapement;
pub(crate) mod found;
mod front;
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

use crate::lookup;
use crate::numbers::significant;

/// A number with its unit, as HTML.
pub type Number = fn() -> anyhow::Result<String>;

/// The numbers of each chapter.
const ALL: &[&[(&str, Number)]] = &[
    built::NUMBERS,
    escapement::NUMBERS,
    found::NUMBERS,
    front::NUMBERS,
    joints::NUMBERS,
    making::NUMBERS,
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

/// A number to so many digits that count, with its unit.
fn with_unit(number: f64, digits: usize, unit: &str) -> String {
    format!("{}&nbsp;{unit}", significant(number, digits))
}

/// From the least to the greatest of some numbers, with so many decimals.
fn over(values: &[f64], decimals: usize) -> anyhow::Result<String> {
    anyhow::ensure!(!values.is_empty(), "there are no rows");
    let [least, greatest] = [least(values), most(values)].map(|end| format!("{end:.decimals$}"));
    Ok(if least == greatest { least } else { format!("{least} to {greatest}") })
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
