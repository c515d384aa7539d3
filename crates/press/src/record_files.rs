//! The files of the data: the ledger's claims, slips and lines, the works that a book cites, and what their fields say.

use crate::book::Book;
use crate::cache::Shelf;
use crate::data::{self, PageFile};
use crate::edition::{Edition, SIGN};
use crate::fields::{self, DataRow, FieldValue};
use crate::records::{claim, entries, slip, slips_of_copies};
use crate::{address, citing, feed, field_list, schema, works};
use geneva_evidence::Consequence;

/// The file that says how the book is cited.
const CITATION: &str = "CITATION.cff";

/// The files of the records of this edition, most of which may come from a shelf.
pub(crate) fn of_edition(book: &Book, edition: &Edition, shelf: &Shelf) -> anyhow::Result<Vec<PageFile>> {
    // They are the same in every edition but for what they say of it at their beginning, and how it is cited.
    let any = Edition { commit: Some(SIGN.to_owned()), ..Edition::without_commit(edition.version) };
    let [from, to] = [edition_lines(&any)?, edition_lines(edition)?];
    let own = PageFile::text_file(CITATION, citing::cff_of_edition(book.citation_file, edition));
    let files = data::recall(shelf, "records", &[], || {
        let files = files(book, &any)?.into_iter().filter(|(name, _)| name != CITATION);
        Ok(files.map(|(name, text)| PageFile::text_file(&name, text)).collect())
    })?;
    let files = files.into_iter().map(|file| file.with_text(|text| text.replacen(&from, &to, 1)));
    Ok(files.chain([own].into_iter().filter(|file| !file.text().is_empty())).collect())
}

/// The files of the records of this edition: their names and texts.
pub fn files(book: &Book, edition: &Edition) -> anyhow::Result<Vec<(String, String)>> {
    let ledger = book.ledger;
    let of_sources = ledger.slips().iter().filter(|places| places.slip.consequence != Consequence::Copy);
    let copies: Vec<_> = slips_of_copies(ledger).map(slip).collect();
    let entries = entries(ledger)?;
    let works: Vec<_> = works::rows(book.works).collect();
    let meanings = field_list::rows(book)?;
    let claims = ledger.verdicts().iter().copied().map(|judged| claim(ledger, judged));
    let versioned = |what, rows: &mut dyn Iterator<Item = DataRow>| versioned(book, what, edition, rows);
    let files = [
        ("claims.json", versioned("claims", &mut claims.into_iter())?),
        ("errata.json", versioned("errata", &mut of_sources.map(slip))?),
        ("copies.json", versioned("copies", &mut copies.iter().cloned())?),
        ("copies.csv", fields::csv(copies.first(), copies.iter().cloned())?),
        ("coverage.json", versioned("entries", &mut entries.iter().cloned())?),
        ("coverage.csv", fields::csv(entries.first(), entries.iter().cloned())?),
        ("works.csv", fields::csv(works.first(), works.iter().cloned())?),
        (field_list::FILE, fields::csv(meanings.first(), meanings.iter().cloned())?),
        (feed::FILE, feed::atom(&book.imprint, book.changelog, book.slips_page().map(|(page, _)| page))),
    ];
    let citation = (CITATION.to_owned(), citing::cff_of_edition(book.citation_file, edition));
    let named = files.into_iter().map(|(name, text)| (name.to_owned(), text));
    // A book that cites no work has no list of works, and so on.
    Ok(named.chain(schema::files(book)?).chain([citation]).filter(|(_, text)| !text.is_empty()).collect())
}

/// Rows in a file that says what it belongs to, in which edition of the project.
fn versioned(
    book: &Book,
    what: &'static str,
    edition: &Edition,
    rows: &mut dyn Iterator<Item = DataRow>,
) -> anyhow::Result<String> {
    let imprint = &book.imprint;
    let [commit, changed] = edition_fields(edition);
    let file = schema::FILES.iter().find(|(_, key, _)| *key == what).map_or(what, |(file, ..)| file);
    fields::json(&DataRow(vec![
        ("$schema", schema::name(file).into()),
        ("format", schema::FORMAT.into()),
        ("title", imprint.title.into()),
        ("version", imprint.version.into()),
        commit,
        changed,
        ("license", imprint.licence.into()),
        ("address", address::known(imprint).map(|address| address.book).into()),
        (what, FieldValue::List(rows.map(FieldValue::Object).collect())),
    ]))
}

/// What a file says of the edition that it belongs to.
fn edition_fields(edition: &Edition) -> [(&'static str, FieldValue); 2] {
    [
        ("commit", edition.commit.as_deref().into()),
        ("changed", edition.commit.as_ref().map(|_| edition.is_changed).into()),
    ]
}

/// The lines of a file that say to which edition it belongs.
fn edition_lines(edition: &Edition) -> anyhow::Result<String> {
    let lines = fields::json(&DataRow(edition_fields(edition).into()))?;
    Ok(lines.trim().trim_start_matches('{').trim_end_matches('}').trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    #[test]
    fn the_files_of_every_edition_become_those_of_this_one() {
        let none = Edition::without_commit(BOOK.imprint.version);
        let commit = Some("0123456789".repeat(4));
        let date = Some("2026-11-29".to_owned());
        let committed = Edition { commit, date, ..none.clone() };
        let changed = Edition { is_changed: true, ..committed.clone() };
        for edition in [&none, &committed, &changed] {
            let made = of_edition(&BOOK, edition, &Shelf::empty()).expect("files");
            let made: Vec<_> = made.iter().map(|file| (file.path(), file.text().to_owned())).collect();
            let afresh = files(&BOOK, edition).expect("files").into_iter();
            assert_eq!(made, afresh.map(|(name, text)| (format!("data/{name}"), text)).collect::<Vec<_>>());
            assert!(made.iter().all(|(_, text)| !text.contains(SIGN)));
        }
    }
}
