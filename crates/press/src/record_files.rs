//! The files of the data: the ledger's claims, slips and lines, the works that a book cites, and what their fields say.

use crate::book::Book;
use crate::edition::Edition;
use crate::fields::{self, DataRow, FieldValue};
use crate::records::{claim, entries, slip, slips_of_copies};
use crate::{address, citing, field_list, works};
use geneva_evidence::Consequence;

/// The files of the records of this edition: their names and texts.
pub fn files(book: &Book, edition: &Edition) -> anyhow::Result<Vec<(&'static str, String)>> {
    let ledger = book.ledger;
    let of_sources = ledger.slips().iter().filter(|places| places.slip.consequence != Consequence::Copy);
    let copies: Vec<_> = slips_of_copies(ledger).map(slip).collect();
    let entries = entries(ledger)?;
    let works: Vec<_> = works::rows(book.works).collect();
    let meanings = field_list::rows(book)?;
    let claims = ledger.verdicts().iter().copied().map(|judged| claim(ledger, judged));
    let versioned = |what, rows: &mut dyn Iterator<Item = DataRow>| versioned(book, what, edition, rows);
    let mut files = vec![
        ("claims.json", versioned("claims", &mut claims.into_iter())?),
        ("errata.json", versioned("errata", &mut of_sources.map(slip))?),
        ("copies.json", versioned("copies", &mut copies.iter().cloned())?),
        ("copies.csv", fields::csv(copies.first(), copies.iter().cloned())?),
        ("coverage.json", versioned("entries", &mut entries.iter().cloned())?),
        ("coverage.csv", fields::csv(entries.first(), entries.iter().cloned())?),
        ("works.csv", fields::csv(works.first(), works.iter().cloned())?),
        (field_list::FILE, fields::csv(meanings.first(), meanings.iter().cloned())?),
        ("CITATION.cff", citing::cff_of_edition(book.citation_file, edition)),
    ];
    // A book that cites no work has no list of works, and so on.
    files.retain(|(_, text)| !text.is_empty());
    Ok(files)
}

/// Rows in a file that says what it belongs to, in which edition of the project.
fn versioned(
    book: &Book,
    what: &'static str,
    edition: &Edition,
    rows: &mut dyn Iterator<Item = DataRow>,
) -> anyhow::Result<String> {
    let imprint = &book.imprint;
    fields::json(&DataRow(vec![
        ("title", imprint.title.into()),
        ("version", imprint.version.into()),
        ("commit", edition.commit.as_deref().into()),
        ("changed", edition.commit.as_ref().map(|_| edition.is_changed).into()),
        ("license", imprint.licence.into()),
        ("address", address::known(imprint).map(|address| address.book).into()),
        (what, FieldValue::List(rows.map(FieldValue::Object).collect())),
    ]))
}
