//! What the pages of the records list: all claims, all slips, how the sources are covered; and the fields of the data.

use super::{coverage, errata, ledger};
use crate::book::Book;
use crate::html::escape;
use crate::lookup::unknown;
use crate::pages::PageRole;
use crate::records::{described, types};
use crate::table::{Cells, Table};
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
    Table::with_rows(Cells::Words, fields)
        .column("Field", |(path, _)| format!("<span><code>{}</code></span>", escape(path)))
        .column("Type", |(path, _)| types(&rows, path))
        .column("What it says", |(_, meaning)| with_code(meaning))
        .finish()
}

/// Text with the words of the data, which stand between grave accents, as code.
fn with_code(text: &str) -> String {
    let parts = text.split('`').enumerate().map(|(at, part)| match at % 2 {
        1 => format!("<code>{}</code>", escape(part)),
        _ => in_italics(part),
    });
    parts.collect()
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
