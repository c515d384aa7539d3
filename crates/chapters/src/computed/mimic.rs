//! Of the language: what the escapement's deck gives of the thesis's tables.

use super::Number;
use crate::html::escape;
use anyhow::Context;
use geneva_case1973::{Column, Reset};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::study::{AS_LISTED, by_deck};
use geneva_documents::meyer::runs::table::rows;

/// The numbers of the page on the language.
pub const NUMBERS: &[(&str, Number)] = &[
    ("mimic.runs", || Ok(rows().len().to_string())),
    ("mimic.minima", || within_one(Column::Minimum)),
    ("mimic.periods", || within_one(Column::Period)),
    ("mimic.peaks", || within_one(Column::Peak)),
    ("mimic.as-listed", || Ok(as_listed())),
];

/// What makes the escapement's deck that of the thesis, as options of the command line.
fn as_listed() -> String {
    let set = AS_LISTED.iter().filter_map(|(name, id)| Some(format!("--set {name}={}", LEDGER.claim(id)?.printed)));
    format!("<code>{}</code>", escape(&set.collect::<Vec<_>>().join(" ")))
}

/// In how many rows a column comes within one unit of the last printed place.
fn within_one(column: Column) -> anyhow::Result<String> {
    let runs = by_deck(Reset::QuarterTurn).context("the escapement's deck does not run")?;
    Ok(geneva_case1973::within_one(column, rows(), runs).to_string())
}
