//! The sources line by line: which claims stand where, and what is no claim, with the reason.

use super::inline::linked_id;
use super::lookup;
use crate::html::{Cells, escape, table};
use geneva_ledger::{Entry, Line};

/// The tables of the sources with these slugs, with spaces between.
pub fn page(slugs: &str) -> anyhow::Result<String> {
    let mut out = String::new();
    for slug in slugs.split_whitespace() {
        let work = lookup::work(slug)?;
        let lines = work.inventory()?;
        let numbers: usize = lines.iter().map(|line| line.numbers.len()).sum();
        out.push_str(&format!(
            "## Source {work}\n\n{} claims, with the labels of equations and figures and the exceptions below, account for \
             all {numbers} numbers in {} lines.\n\n",
            lookup::of_work(work).count(),
            lines.len()
        ));
        let rows: Vec<_> = lines.iter().map(row).collect();
        out.push_str(&table(
            &format!("Lines of {work}"),
            Cells::Words,
            &["Line", "Claims", "Numbers", "Accounted for"],
            &rows,
        ));
        out.push_str(&format!("\n\n### No claims: {work}\n\n{}\n\n", exceptions(lines)));
    }
    Ok(out)
}

fn row(line: &Line) -> Vec<String> {
    let claims: Vec<_> = line.entries.iter().filter_map(|entry| entry.claimed()).map(linked_id).collect();
    vec![
        line.number.to_string(),
        if claims.is_empty() { "–".to_owned() } else { claims.join(", ") },
        line.numbers.len().to_string(),
        if line.is_accounted_for() { "yes" } else { "no" }.to_owned(),
    ]
}

fn exceptions(lines: &[Line]) -> String {
    let rows: Vec<_> = lines
        .iter()
        .flat_map(|line| line.entries.iter().map(|entry| (line.number, entry)))
        .filter_map(|(number, entry)| match entry {
            Entry::Exception { id, reason, .. } => {
                Some(vec![format!("<code>{id}</code>"), number.to_string(), escape(reason)])
            }
            _ => None,
        })
        .collect();
    table("Exceptions", Cells::Words, &["Exception", "Line", "Why there is nothing to check"], &rows)
}
