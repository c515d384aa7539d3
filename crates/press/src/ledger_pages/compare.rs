//! The table of printed against computed numbers, with the differing digits marked.

use super::inline::{computed, linked_badge, rounded, with_unit};
use crate::html::{Cells, Table, escape, table as html_table};
use crate::lookup;
use geneva_evidence::{Claim, Decimal, Judged, Kind, Mark, Marked};

const LEGEND: &str = "<p class=\"legend\">Printed digits that agree with the computed number are not underlined. If \
     only the last digit differs, it has <span class=\"digit last\">a dotted underline</span>. Otherwise all digits \
     from the first wrong one onwards have <span class=\"digit wrong\">a wavy underline</span>.</p>";

/// The table for all numbers of a source, or for the claims listed with spaces between; a caption after a semicolon.
pub fn table(of: &str) -> anyhow::Result<Table> {
    let (of, caption) =
        of.split_once(';').map_or((of.trim(), "Printed and computed"), |(of, caption)| (of.trim(), caption.trim()));
    let listed: Vec<&Judged> = if of.contains('.') {
        of.split_whitespace().map(lookup::judged).collect::<Result<_, _>>()?
    } else {
        lookup::of_work(lookup::work(of)?).filter(|judged| judged.claim.kind == Kind::Value).collect()
    };
    // Claims that mean the same are told apart by their places.
    let alike = |claim: &Claim| listed.iter().filter(|other| other.claim.meaning == claim.meaning).count() > 1;
    let name = |claim: &Claim| {
        if alike(claim) { format!("{}: {}", claim.locator, claim.meaning) } else { claim.meaning.to_owned() }
    };
    let rounds = listed.iter().any(|judged| judged.from_rounded.is_some());
    let rows = listed.iter().map(|judged| row(judged, &name(judged.claim), rounds));
    let mut head = vec!["Quantity", "Printed", "Computed", "Verdict"];
    if rounds {
        head.insert(3, "From rounded steps");
    }
    let table = html_table(caption, Cells::NamedNumbers, &head, rows)?;
    // The legend explains marks; a table without marks needs none.
    Ok(if table.holds("class=\"digit") { table.with_legend(LEGEND) } else { table })
}

fn row(judged: &Judged, name: &str, rounds: bool) -> anyhow::Result<Vec<String>> {
    let claim = judged.claim;
    let (digits, remark) = match (claim.printed.parse::<Decimal>(), judged.computed) {
        (Ok(decimal), Some(number)) => marked(&decimal.marks(claim.printed, number)),
        _ => (escape(claim.printed), ""),
    };
    let printed = with_unit(&digits, claim.unit)?;
    let dash = || "–".to_owned();
    let mut row = vec![
        escape(name),
        if remark.is_empty() { printed } else { format!("{printed} <small>{remark}</small>") },
        computed(judged).unwrap_or_else(dash),
        linked_badge(judged),
    ];
    if rounds {
        row.insert(3, judged.from_rounded.map_or_else(dash, |number| rounded(judged, number)));
    }
    Ok(row)
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
