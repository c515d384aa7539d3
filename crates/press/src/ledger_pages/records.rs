//! What the pages of the records list: all claims, all slips, how the sources are covered; and the fields of the data.

use super::{coverage, errata, ledger};
use crate::book::Book;
use crate::html::{Cells, Table, escape, table};
use crate::lookup::unknown;
use crate::pages::PageRole;
use crate::records::{described, types};
use anyhow::bail;

/// What the list of pages puts on the page of this name.
pub fn page(book: &Book, name: &str) -> anyhow::Result<String> {
    let page = book.pages.iter().find(|page| page.name == name);
    let page = page.ok_or_else(|| unknown("page", name, book.pages.iter().map(|page| page.name)))?;
    match page.role {
        PageRole::Claims => ledger::page(book),
        PageRole::Slips(consequences) => consequences.iter().map(|of| errata::errata_list(book, *of)).collect(),
        PageRole::Coverage => coverage::page(book),
        _ => bail!("the list of pages puts no records on `{name}`"),
    }
}

/// The fields of a file of the records, with what each says.
pub fn fields(book: &Book, file: &str) -> anyhow::Result<Table> {
    let (fields, rows) = described(book, file)?;
    let rows = fields.iter().map(|(path, meaning)| {
        // Between grave accents stand words of the data.
        let parts = meaning.split('`').enumerate().map(|(at, part)| match at % 2 {
            1 => format!("<code>{}</code>", escape(part)),
            _ => in_italics(part),
        });
        Ok(vec![format!("<span><code>{}</code></span>", escape(path)), types(&rows, path), parts.collect()])
    });
    table(&format!("Fields of {file}.json"), Cells::Words, &["Field", "Type", "What it says"], rows)
}

/// Text with the titles between asterisks in italics.
fn in_italics(text: &str) -> String {
    let parts = text.split('*').enumerate().map(|(at, part)| match at % 2 {
        1 => format!("<em>{}</em>", escape(part)),
        _ => escape(part),
    });
    parts.collect()
}

#[cfg(test)]
mod tests {
    use super::in_italics;

    #[test]
    fn titles_between_asterisks_are_set_in_italics() {
        assert_eq!(in_italics("see *Errata* <b>"), "see <em>Errata</em> &lt;b&gt;");
    }
}
