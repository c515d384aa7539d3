//! Lists: the classes of verdict, the kinds of evidence, the tolerances, the letters of a source.

use super::inline::badge;
use crate::html::{Cells, Table, escape, table, tex_or_text};
use crate::{lookup, maths};
use geneva_ledger::{Evidence, Judged, TOLERANCES, Verdict};

/// The classes of verdict with their meaning and how many claims of the documents have each.
pub fn verdicts() -> anyhow::Result<Table> {
    let rows = Verdict::ALL.iter().map(|verdict| {
        let count = lookup::of_documents().filter(|judged| judged.verdict == *verdict).count();
        Ok(vec![badge(*verdict), escape(verdict.meaning()), verdict.truth().to_string(), count.to_string()])
    });
    table("Classes of verdict", Cells::Words, &["Verdict", "What it means", "Is it right?", "Claims"], rows)
}

/// The kinds of evidence and how many claims of the documents use each.
pub fn evidence() -> anyhow::Result<Table> {
    let rows = Evidence::ALL.iter().map(|kind| {
        let uses = |judged: &&Judged| judged.claim.check.evidence().contains(kind);
        let count = lookup::of_documents().filter(uses).count();
        Ok(vec![kind.to_string(), escape(kind.meaning()), count.to_string()])
    });
    table("Kinds of evidence", Cells::Words, &["Evidence", "What it is", "Claims"], rows)
}

/// The tolerances that are not printed digits.
pub fn tolerances() -> anyhow::Result<Table> {
    let rows = TOLERANCES.iter().map(|tolerance| {
        Ok(vec![tolerance.name.to_owned(), format!("{:e}", tolerance.relative), escape(tolerance.reason)])
    });
    table("Tolerances", Cells::Words, &["Tolerance", "Relative", "Why"], rows)
}

/// The letters of a source and the book's.
pub fn symbols(slug: &str) -> anyhow::Result<Table> {
    let rows = lookup::work(slug)?.symbols().iter().map(|symbol| {
        let ours = maths::formula(symbol.ours, false)?;
        Ok(vec![tex_or_text(symbol.printed)?, ours, escape(symbol.meaning)])
    });
    table("Letters", Cells::Words, &["In the source", "In this book", "What it stands for"], rows)
}
