//! The table of a source's equations, figures and statements, with what was found of each.

use super::inline::linked_badge;
use crate::html::{Cells, Table, escape, table as html_table, tex_or_text};
use crate::lookup;
use geneva_ledger::{Check, Judged, Kind, in_full};

/// The table for a source.
pub fn table(slug: &str) -> anyhow::Result<Table> {
    let forms = lookup::of_work(lookup::work(slug)?).filter(|judged| judged.claim.kind != Kind::Value);
    let head = ["What it says", "Printed", "Verdict", "How it was found"];
    html_table("Equations, figures and statements", Cells::Words, &head, forms.map(row))
}

fn row(judged: &Judged) -> anyhow::Result<Vec<String>> {
    let claim = judged.claim;
    Ok(vec![escape(claim.meaning), tex_or_text(&in_full(claim))?, linked_badge(judged), briefly(judged)])
}

/// How a form was found to hold or to fail, without the neighbours that it was told from.
fn briefly(judged: &Judged) -> String {
    told(judged, |role| !role.contains("neighbour") && role != "as printed by the witness")
}

/// How a form was found to hold or to fail; for a missing datum, what is missing.
pub fn how(judged: &Judged) -> String {
    let mut how = told(judged, |_| true);
    if let Check::Statement { neighbour: Some(words), .. } = &judged.claim.check {
        how.push_str(&format!(";<br>the neighbour: {}", escape(words)));
    }
    how
}

/// The findings of these roles, with the reading.
fn told(judged: &Judged, wanted: fn(&str) -> bool) -> String {
    if let Check::Missing { reason } = &judged.claim.check {
        return escape(reason);
    }
    let evidence = judged.claim.check.evidence();
    let kind = |role: &str| match role {
        "as printed" | "corrected" | "neighbour" => evidence.first(),
        "witness" | "neighbour by the witness" | "as printed by the witness" => evidence.last(),
        _ => None,
    };
    let mut parts: Vec<_> = judged
        .findings
        .iter()
        .filter(|(role, _)| wanted(role))
        .map(|(role, finding)| {
            let kind = kind(role).map_or_else(String::new, |kind| format!(" ({kind})"));
            let says = if finding.holds { "holds" } else { "fails" };
            format!("{role}{kind} {says}: {}", escape(&finding.how))
        })
        .collect();
    if let Some(reading) = judged.claim.reading {
        parts.insert(0, format!("read as: {}", escape(reading.trim_end_matches('.'))));
    }
    parts.join(";<br>")
}
