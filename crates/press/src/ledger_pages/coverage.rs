//! How the sources are covered, in sums: the lists themselves are files of data.

use crate::book::Book;
use crate::html::escape;
use crate::lookup;
use crate::records::slips_of_copies;
use crate::table::{Cells, Table};
use anyhow::bail;
use geneva_evidence::{Document, Entry, Ledger, Line, TracedSlip, UnfinishedLine, numbers_left};

/// How much of each document the claims account for, what they leave over, and which characters its copy has lost or changed.
pub fn page(book: &Book) -> anyhow::Result<String> {
    let mut sources = Vec::new();
    for document in book.ledger.mirrored() {
        let lines = document.lines()?;
        refuse_contradiction(document, lines)?;
        sources.push((document, lines));
    }
    let exceptions = |line: &Line| line.entries.iter().filter(|of| matches!(of, Entry::Exception { .. })).count();
    let sums = Table::with_rows(Cells::NamedNumbers, sources)
        .column("Source", |(document, _)| document.to_string())
        .column("Lines", |(_, lines)| lines.len())
        .column("Numbers", |(_, lines)| lines.iter().map(|line| line.numbers.len()).sum::<usize>())
        .column("Claims", |(document, _)| lookup::verdicts_of(book.ledger, document).count())
        .column("Exceptions", |(_, lines)| lines.iter().map(exceptions).sum::<usize>())
        .column("Characters of the copy", |(document, _)| slips_of_copy(book.ledger, document))
        .finish()?
        .html("Coverage of the sources");
    let sums = sums + &unfinished(book)?;
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

/// How many characters the copy of a document has lost or changed.
pub fn slips_of_copy(ledger: &'static Ledger, document: &Document) -> usize {
    slips_of_documents(ledger).filter(|places| places.main().claim.document == document).count()
}

/// Stops where the entries of a line say other numbers than the line.
fn refuse_contradiction(document: &'static Document, lines: &[Line]) -> anyhow::Result<()> {
    match lines.iter().find_map(|line| Some((line, numbers_left(document, line).err()?))) {
        Some((line, gap)) => bail!("line {} of {document}: {gap}", line.number),
        None => Ok(()),
    }
}

/// What is not yet accounted for, line by line; nothing of a ledger that is finished.
fn unfinished(book: &Book) -> anyhow::Result<String> {
    let lines = book.ledger.unfinished_lines()?;
    if lines.is_empty() {
        return Ok(String::new());
    }
    let item =
        |line: &UnfinishedLine| format!("<li>{}, {}</li>\n", escape(line.document.title), escape(&line.to_string()));
    Ok(format!(
        "\n\n## Not yet accounted for {{#unfinished}}\n\nNo claim and no exception accounts for these numbers.\n\n\
         <ul>\n{}</ul>\n",
        lines.iter().map(item).collect::<String>()
    ))
}
