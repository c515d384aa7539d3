//! Of what is said elsewhere: how many pages and programs, how many statements are right and wrong, and by how much.

use super::Number;
use crate::{lookup, numbers};
use anyhow::Context;
use geneva_ledger::{Judged, Truth, Work, wild};
use std::collections::BTreeSet;

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("wild.addresses", || Ok(addresses(|_| true).to_string())),
    ("wild.addresses-wrong", || Ok(addresses(|judged| judged.truth() == Truth::Wrong).to_string())),
    ("wild.right", || Ok(count(Truth::Right))),
    ("wild.wrong", || Ok(count(Truth::Wrong))),
    ("wild.move.six", || times("wild.firgelli-time.index", 6, 0)),
    ("wild.move.eight", || times("wild.firgelli-time.index", 8, 0)),
    ("wild.centres.six", || times("wild.firgelli-time.centres", 6, 1)),
];

fn statements() -> impl Iterator<Item = &'static Judged> {
    lookup::of_work(Work::Wild)
}

/// How many pages and programs make such a statement.
fn addresses(such: impl Fn(&Judged) -> bool) -> usize {
    let read = statements().filter(|judged| such(judged)).filter_map(|judged| wild::read(judged.claim.locator));
    read.map(|(address, _)| address).collect::<BTreeSet<_>>().len()
}

fn count(truth: Truth) -> String {
    statements().filter(|judged| judged.truth() == truth).count().to_string()
}

/// What a wrong formula gives over what is right; the other way round if that is less than one.
fn times(id: &str, slots: u32, places: usize) -> anyhow::Result<String> {
    let ratio = wild::ratio(id, slots).with_context(|| format!("`{id}` gives no ratio"))?;
    Ok(numbers::fixed(ratio.max(1.0 / ratio), places))
}
