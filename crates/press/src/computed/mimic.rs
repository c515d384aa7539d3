//! Of the language: what the escapement's deck gives of the thesis's tables.

use super::Number;
use anyhow::Context;
use geneva_ledger::meyer::runs::{Column, Row, Run, deck, rows};

/// The numbers of the page on the language.
pub const NUMBERS: &[(&str, Number)] = &[
    ("mimic.runs", || Ok(rows().len().to_string())),
    ("mimic.minima", || within_one(Column::Minimum)),
    ("mimic.periods", || within_one(Column::Period)),
    ("mimic.peaks", || within_one(Column::Peak)),
];

/// In how many rows a column comes within one unit of the last printed place.
fn within_one(column: Column) -> anyhow::Result<String> {
    let runs = deck::runs().context("the escapement's deck does not run")?;
    let is_near = |(row, run): &(&Row, &Run)| column.is_within_one(row.number(column), run.number(column));
    Ok(rows().iter().zip(&runs).filter(is_near).count().to_string())
}
