//! Numbers of ours in a sentence: what a chapter says with a number that no source prints.

mod escapement;
mod front;
mod never_printed;
mod program;
mod runs;
mod solver;
mod terminal_speed;

use crate::lookup;

/// A number with its unit, as HTML.
pub type Number = fn() -> anyhow::Result<String>;

/// The numbers of each chapter.
const ALL: &[&[(&str, Number)]] = &[escapement::NUMBERS, front::NUMBERS, never_printed::NUMBERS, program::NUMBERS, runs::NUMBERS, solver::NUMBERS, terminal_speed::NUMBERS];
pub fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().copied().flatten().map(|(name, _)| *name)
}

/// The number of this name.
pub fn by_name(name: &str) -> anyhow::Result<String> {
    let found = ALL.iter().copied().flatten().find(|(known, _)| *known == name).map(|(_, number)| number);
    found.ok_or_else(|| lookup::unknown("number", name, names()))?()
}
