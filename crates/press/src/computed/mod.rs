//! Numbers of ours in a sentence: what a chapter says with a number that no source prints.

mod front;
mod jazar;
mod joints;
mod timer;

use crate::lookup;

/// A number with its unit, as HTML.
pub type Number = fn() -> anyhow::Result<String>;

/// The numbers of each chapter.
const ALL: &[&[(&str, Number)]] = &[front::NUMBERS, jazar::NUMBERS, timer::NUMBERS, joints::NUMBERS];

/// The names of all numbers; each is said in some chapter.
pub fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().copied().flatten().map(|(name, _)| *name)
}

/// The number of this name.
pub fn by_name(name: &str) -> anyhow::Result<String> {
    let found = ALL.iter().copied().flatten().find(|(known, _)| *known == name).map(|(_, number)| number);
    found.ok_or_else(|| lookup::unknown("number", name, names()))?()
}
