//! Of the language: what the escapement's deck gives of the thesis's tables.

use super::kinds::PROGRAM;
use super::second_routes::NEWTON;
use super::second_routes::printed_rows::{count_near, rows_as_run};
use anyhow::Context;
use geneva_case1973::{Column, Reset, within_one};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::study::{AS_LISTED, by_deck};
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::OwnNumber;
use geneva_press::book::MakeText;
use geneva_press::html::escape;

/// The numbers of the page on the language.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        OwnNumber::count("mimic.runs", || Ok(rows().len())),
        count_reproduced("mimic.minima", Column::Minimum),
        count_reproduced("mimic.periods", Column::Period),
        count_reproduced("mimic.peaks", Column::Peak),
    ]
}

/// Options of the command line on the page.
pub(super) const WORDS: &[(&str, MakeText)] = &[("mimic.as-listed", || Ok(listed_settings()))];

/// What makes the escapement's deck that of the thesis, as options of the command line.
fn listed_settings() -> String {
    let set = AS_LISTED.iter().filter_map(|(name, id)| Some(format!("--set {name}={}", LEDGER.claim(id)?.printed)));
    format!("<code>{}</code>", escape(&set.collect::<Vec<_>>().join(" ")))
}

/// In how many rows a column comes within one unit of the last printed place.
fn count_reproduced(id: &'static str, column: Column) -> OwnNumber {
    OwnNumber::new(id, "{.0}", PROGRAM, move || {
        let runs = by_deck(Reset::QuarterTurn).context("the escapement's deck does not run")?;
        Ok(within_one(column, rows(), runs))
    })
    .with_second_route("the deck reproduces the tables", NEWTON, move || Ok(count_near(rows_as_run(), &[column])))
}
