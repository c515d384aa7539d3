//! How the sources are covered, in sums: the lists themselves are files of data.

use crate::html::{Cells, table};
use crate::lookup;
use crate::records::slips_of_copies;
use anyhow::bail;
use geneva_documents::LEDGER;
use geneva_evidence::{Document, line_gap};
use geneva_evidence::{Entry, Line, TracedSlip};

/// How much of each document the claims account for, and which characters its copy has lost or changed.
pub fn page() -> anyhow::Result<String> {
    let mut rows = Vec::new();
    for work in LEDGER.mirrored() {
        rows.push(row(work, work.lines()?));
    }
    let head = ["Source", "Lines", "Numbers", "Claims", "Exceptions", "Characters of the copy"];
    let sums = table("Coverage of the sources", Cells::NamedNumbers, &head, rows)?.html();
    // As text, not as code: there are many. Each bears the anchor that it had on a page of its own.
    let copies = of_documents().map(|places| {
        let id = places.slip.id;
        format!("<a id=\"slip-{id}\" href=\"{}\">{id}</a>", crate::pages::address_of_claim(id))
    });
    let copies = copies.collect::<Vec<_>>().join(", ");
    Ok(format!(
        "{sums}\n\n## Characters of the copies {{#copies}}\n\nWe read the sources in copies that a machine has \
         made from paper. In the following claims, a character in the copy is wrong, and the context demands another. \
         If one mistake of a copy affects several claims, we list only one of them: {copies}.\n"
    ))
}

/// What the copies of the documents have lost or changed.
fn of_documents() -> impl Iterator<Item = &'static TracedSlip> {
    slips_of_copies().filter(|places| places.is_mirrored())
}

/// The sums of a source.
fn row(work: &'static Document, lines: &[Line]) -> anyhow::Result<Vec<String>> {
    if let Some(line) = lines.iter().find(|line| line_gap(work, line).is_some()) {
        bail!("line {} of {work} has numbers that nothing accounts for", line.number);
    }
    let entries = || lines.iter().flat_map(|line| &line.entries);
    let sums = [
        lines.len(),
        lines.iter().map(|line| line.numbers.len()).sum(),
        lookup::of_work(work).count(),
        entries().filter(|entry| matches!(entry, Entry::Exception { .. })).count(),
        of_documents().filter(|places| places.main().claim.document == work).count(),
    ];
    Ok([vec![work.to_string()], sums.map(|sum| sum.to_string()).into()].concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_character_of_a_copy_is_counted_with_its_source_and_has_an_anchor() {
        let page = page().expect("a page");
        let all = of_documents().count();
        assert_eq!(page.matches("<a id=\"slip-").count(), all);
        let of = |work: &&'static Document| row(work, work.lines().expect("lines")).expect("a row")[5].parse::<usize>();
        assert_eq!(LEDGER.mirrored().iter().map(|work| of(work).expect("a number")).sum::<usize>(), all);
    }
}
