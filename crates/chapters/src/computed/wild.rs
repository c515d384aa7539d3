//! Of what is said elsewhere: how many pages and programs, how many statements are right and wrong, how many examples that
//! are built, and by how much a formula is wrong.

use super::{Number, least, most};
use crate::{figures, lookup, numbers};
use anyhow::{Context, ensure};
use geneva_documents::WILD;
use geneva_documents::wild;
use geneva_evidence::{Judged, Kind, Truth};
use std::collections::BTreeSet;

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("wild.addresses", || Ok(addresses(|_| true).to_string())),
    ("wild.addresses-whole", || Ok(addresses(is_of_a_page_taken_whole).to_string())),
    ("wild.addresses-wrong", || Ok(addresses(|judged| is_statement(judged) && is_wrong(judged)).to_string())),
    ("wild.statements", || Ok(count(is_statement))),
    ("wild.right", || Ok(count(|judged| is_statement(judged) && judged.truth() == Truth::Right))),
    ("wild.wrong", || Ok(count(|judged| is_statement(judged) && is_wrong(judged)))),
    ("wild.copy", || Ok(count(|judged| is_statement(judged) && judged.is_miscopied()))),
    ("wild.examples", || Ok(count(|judged| !is_statement(judged)))),
    ("wild.examples-wrong", || Ok(count(|judged| !is_statement(judged) && is_wrong(judged)))),
    ("wild.bite.least", || bites(least)),
    ("wild.bite.most", || bites(most)),
    ("wild.move.six", || times("wild.firgelli-time.index", 6, 0)),
    ("wild.move.eight", || times("wild.firgelli-time.index", 8, 0)),
    ("wild.centres.six", || times("wild.firgelli-time.centres", 6, 1)),
];

fn all() -> impl Iterator<Item = &'static Judged> {
    lookup::of_work(&WILD)
}

/// Whether it is stated, and not only built as an example.
fn is_statement(judged: &Judged) -> bool {
    judged.claim.kind != Kind::Example
}

/// Whether the page is wrong, and not only the copy that we read.
fn is_wrong(judged: &Judged) -> bool {
    judged.truth() == Truth::Wrong && !judged.is_miscopied()
}

/// Whether it is on a page of which every formula was taken.
fn is_of_a_page_taken_whole(judged: &Judged) -> bool {
    wild::read(judged.claim.locator).is_some_and(|(address, _)| wild::is_taken_whole(address))
}

/// How many pages and programs have such a statement or example.
fn addresses(such: impl Fn(&Judged) -> bool) -> usize {
    let read = all().filter(|judged| such(judged)).filter_map(|judged| wild::read(judged.claim.locator));
    read.map(|(address, _)| address).collect::<BTreeSet<_>>().len()
}

fn count(such: impl Fn(&Judged) -> bool) -> String {
    all().filter(|judged| such(judged)).count().to_string()
}

/// How deep the horns come into the disc in the figure of the cuts, with a cut of the wheel's radius: the least or the
/// greatest depth over its numbers of slots. With the other cut they must stay clear.
fn bites(of: fn(&[f64]) -> f64) -> anyhow::Result<String> {
    let rows = figures::by_name("locking-cuts")?.series.rows;
    ensure!(rows.iter().all(|row| row[1] < 0.0 && row[2] > 0.0), "the first cut bites and the second one does not");
    let depths: Vec<f64> = rows.iter().map(|row| -row[1]).collect();
    Ok(numbers::fixed(of(&depths), 1))
}

/// What a wrong formula gives over what is right; the other way round if that is less than one.
fn times(id: &str, slots: u32, places: usize) -> anyhow::Result<String> {
    let ratio = wild::ratio(id, slots).with_context(|| format!("`{id}` gives no ratio"))?;
    Ok(numbers::fixed(ratio.max(1.0 / ratio), places))
}
