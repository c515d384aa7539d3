//! Lists: all claims, the classes of verdict, the tolerances, the letters of a source.

use super::forms::how;
use super::inline::{badge, computed, rounded, with_unit};
use super::{errata, lookup, pages};
use crate::html::{Cells, escape, table, tex_or_text};
use crate::maths;
use anyhow::ensure;
use geneva_ledger::{Evidence, Judged, TOLERANCES, Verdict, in_full, verdicts as judged};

/// The claims of a page of the ledger, a table for each stretch; every row can be linked to by the claim's id.
pub fn ledger(page: &str) -> anyhow::Result<String> {
    let mut out = String::new();
    for stretch in pages::of_page(page) {
        let rows = stretch.ids().map(|id| row(lookup::judged(id)?)).collect::<anyhow::Result<Vec<_>>>()?;
        let head = ["Claim", "Where", "What", "Printed", "Computed", "Evidence", "Verdict"];
        let title = format!("Source {}: {}", stretch.work, stretch.title);
        out.push_str(&format!("## {title}\n\n{}\n\n", table(&title, Cells::Words, &head, &rows)));
    }
    ensure!(!out.is_empty(), "no page `{page}` of the ledger");
    Ok(out)
}

fn row(judged: &Judged) -> anyhow::Result<Vec<String>> {
    let claim = judged.claim;
    let evidence: Vec<_> = claim.check.evidence().iter().map(ToString::to_string).collect();
    Ok(vec![
        format!("<code id=\"{0}\">{0}</code>", claim.id),
        escape(claim.locator),
        format!("{}: {}", claim.kind, escape(claim.meaning)),
        with_unit(&tex_or_text(&in_full(claim))?, claim.unit)?,
        numbers(judged),
        if judged.computed.is_some() { evidence.join(", ") } else { how(judged) },
        badge(judged.verdict) + &slip(judged),
    ])
}

/// What was computed and, where the printed number is not right, what is.
fn numbers(judged: &Judged) -> String {
    let computed = computed(judged).unwrap_or_else(|| "–".to_owned());
    let in_error = judged.right_value.filter(|right| judged.computed != Some(*right));
    in_error.map_or(computed.clone(), |right| format!("{computed}; right: {}", rounded(judged, right)))
}

/// The slip that reaches a claim, as a link to where it is told.
fn slip(judged: &Judged) -> String {
    let Some(erratum) = &judged.claim.erratum else { return String::new() };
    let page = errata::page_of(erratum.slip.consequence);
    format!("<br><a href=\"{page}.html#slip-{}\">{}</a>", erratum.slip.id, erratum.slip.consequence)
}

/// The classes of verdict with their meaning and how many claims have each.
pub fn verdicts() -> String {
    let rows: Vec<_> = Verdict::ALL
        .iter()
        .map(|verdict| {
            let count = judged().iter().filter(|judged| judged.verdict == *verdict).count();
            vec![badge(*verdict), escape(verdict.meaning()), verdict.truth().to_string(), count.to_string()]
        })
        .collect();
    table("Classes of verdict", Cells::Words, &["Verdict", "What it means", "Is it right?", "Claims"], &rows)
}

/// The kinds of evidence and how many claims use each.
pub fn evidence() -> String {
    let rows: Vec<_> = Evidence::ALL
        .iter()
        .map(|kind| {
            let count = judged().iter().filter(|judged| judged.claim.check.evidence().contains(kind)).count();
            vec![kind.to_string(), escape(kind.meaning()), count.to_string()]
        })
        .collect();
    table("Kinds of evidence", Cells::Words, &["Evidence", "What it is", "Claims"], &rows)
}

/// The tolerances that are not printed digits.
pub fn tolerances() -> String {
    let rows: Vec<_> = TOLERANCES
        .iter()
        .map(|tolerance| vec![tolerance.name.to_owned(), format!("{:e}", tolerance.relative), escape(tolerance.reason)])
        .collect();
    table("Tolerances", Cells::Words, &["Tolerance", "Relative", "Why"], &rows)
}

/// The letters of a source and the book's.
pub fn symbols(slug: &str) -> anyhow::Result<String> {
    let rows = lookup::work(slug)?
        .symbols()
        .iter()
        .map(|symbol| {
            let ours = maths::formula(symbol.ours, false)?;
            Ok(vec![tex_or_text(symbol.printed)?, ours, escape(symbol.meaning)])
        })
        .collect::<anyhow::Result<Vec<_>>>()?;
    Ok(table("Letters", Cells::Words, &["In the copy", "In this book", "What it stands for"], &rows))
}
