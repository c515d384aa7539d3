//! How the sources are covered, in sums: the lists themselves are files of data.

use crate::book::Book;
use crate::html::{Cells, table};
use crate::lookup;
use crate::records::slips_of_copies;
use anyhow::bail;
use geneva_evidence::{Document, Entry, Ledger, Line, TracedSlip, line_gap};

/// How much of each document the claims account for, and which characters its copy has lost or changed.
pub fn page(book: &Book) -> anyhow::Result<String> {
    let mut rows = Vec::new();
    for document in book.ledger.mirrored() {
        rows.push(row(book.ledger, document, document.lines()?));
    }
    let head = ["Source", "Lines", "Numbers", "Claims", "Exceptions", "Characters of the copy"];
    let sums = table("Coverage of the sources", Cells::NamedNumbers, &head, rows)?.html();
    // As text, not as code: there are many. Each bears the anchor that it had on a page of its own.
    let copies = slips_of_documents(book.ledger).map(|places| {
        let id = places.slip.id;
        format!("<a id=\"slip-{id}\" href=\"{}\">{id}</a>", book.address_of_claim(id))
    });
    let copies = copies.collect::<Vec<_>>().join(", ");
    if copies.is_empty() {
        return Ok(format!("{sums}\n"));
    }
    Ok(format!(
        "{sums}\n\n## Characters of the copies {{#copies}}\n\nWe read the sources in copies that a machine has \
         made from paper. In the following claims, a character in the copy is wrong, and the context demands another. \
         If one mistake of a copy affects several claims, we list only one of them: {copies}.\n"
    ))
}

/// What the copies of the documents have lost or changed.
pub fn slips_of_documents(ledger: &'static Ledger) -> impl Iterator<Item = &'static TracedSlip> {
    slips_of_copies(ledger).filter(|places| places.is_mirrored())
}

/// The sums of a source.
pub fn row(ledger: &'static Ledger, document: &'static Document, lines: &[Line]) -> anyhow::Result<Vec<String>> {
    if let Some((line, gap)) = lines.iter().find_map(|line| Some((line, line_gap(document, line)?))) {
        bail!("line {} of {document} has numbers that nothing accounts for: {gap}", line.number);
    }
    let entries = || lines.iter().flat_map(|line| &line.entries);
    let sums = [
        lines.len(),
        lines.iter().map(|line| line.numbers.len()).sum(),
        lookup::verdicts_of(ledger, document).count(),
        entries().filter(|entry| matches!(entry, Entry::Exception { .. })).count(),
        slips_of_documents(ledger).filter(|places| places.main().claim.document == document).count(),
    ];
    Ok([vec![document.to_string()], sums.map(|sum| sum.to_string()).into()].concat())
}
