//! The table of printed against computed numbers, with the differing digits marked.

use super::inline::{computed, linked_sign, with_unit};
use crate::book::Book;
use crate::html::escape;
use crate::lookup;
use crate::table::{Cells, Table};
use geneva_evidence::{Claim, Decimal, Judged, Kind, Mark, Marked};

const LEGEND: &str = "<p class=\"legend\">Printed digits that agree with the computed number are not underlined. If \
     only the last digit differs, it has <span class=\"digit last\">a dotted underline</span>. Otherwise all digits \
     from the first wrong one onwards have <span class=\"digit wrong\">a wavy underline</span>.</p>";

/// The table for all numbers of a source, or for the claims listed with spaces between.
pub fn table(book: &Book, of: &str) -> anyhow::Result<Table> {
    let listed: Vec<&Judged> = if of.contains('.') {
        of.split_whitespace().map(|id| lookup::verdict(book.ledger, id)).collect::<Result<_, _>>()?
    } else {
        let document = lookup::document(book.ledger, of)?;
        lookup::verdicts_of(book.ledger, document).filter(|judged| judged.claim.kind == Kind::Value).collect()
    };
    // Claims that mean the same are told apart by their places.
    let alike = |claim: &Claim| listed.iter().filter(|other| other.claim.meaning == claim.meaning).count() > 1;
    let name = |claim: &Claim| {
        if alike(claim) { format!("{}: {}", claim.locator, claim.meaning) } else { claim.meaning.to_owned() }
    };
    let dash = || "–".to_owned();
    let rounds = listed.iter().any(|judged| judged.from_rounded.is_some()).then_some("From rounded steps");
    let table = Table::with_rows(Cells::NamedNumbers, &listed)
        .column("Quantity", |judged| escape(&name(judged.claim)))
        .column("Printed", |judged| printed(book, judged))
        .column("Computed", |judged| computed(judged).unwrap_or_else(dash))
        .columns(
            rounds,
            |head| (*head).to_owned(),
            |judged, _| judged.from_rounded.map_or_else(dash, |number| judged.rounded(number)),
        )
        .column("Verdict", |judged| linked_sign(book, judged))
        .finish()?;
    // The legend explains marks; a table without marks needs none.
    Ok(if table.contains("class=\"digit") { table.with_legend(LEGEND) } else { table })
}

/// The printed number with its digits marked.
fn printed(book: &Book, judged: &Judged) -> anyhow::Result<String> {
    let claim = judged.claim;
    let (digits, remark) = match (claim.printed.parse::<Decimal>(), judged.computed) {
        (Ok(decimal), Some(number)) => marked(&decimal.marks(claim.printed, number)),
        _ => (escape(claim.printed), ""),
    };
    let printed = with_unit(book, &digits, claim.unit)?;
    Ok(if remark.is_empty() { printed } else { format!("{printed} <small>{remark}</small>") })
}

/// The digits with their marks, and the same in words.
fn marked(digits: &Marked) -> (String, &'static str) {
    let mut html = String::new();
    for (c, mark) in digits {
        match mark {
            Mark::Agree => html.push(*c),
            Mark::Last => html.push_str(&format!("<span class=\"digit last\">{c}</span>")),
            Mark::Wrong => html.push_str(&format!("<span class=\"digit wrong\">{c}</span>")),
        }
    }
    let has = |wanted| digits.iter().any(|(_, mark)| *mark == wanted);
    let remark = match (has(Mark::Wrong), has(Mark::Last)) {
        (true, _) => "(wrong digits)",
        (_, true) => "(last place differs)",
        _ => "",
    };
    (html, remark)
}
