//! What the pages of the records list: all claims, all slips, how the sources are covered.

use super::{coverage, errata, ledger};
use crate::book::Book;
use crate::lookup::unknown;
use crate::page_items::PageItem;
use crate::pages::PageRole;
use anyhow::bail;

/// What the list of pages puts on the page of this name, in a book with these figures, tables and errata.
pub fn page(book: &Book, name: &str, items: &[PageItem]) -> anyhow::Result<String> {
    let page = book.pages.iter().find(|page| page.name == name);
    let page = page.ok_or_else(|| unknown("page", name, book.pages.iter().map(|page| page.name)))?;
    match page.role {
        PageRole::Claims => ledger::page(book),
        PageRole::Slips(boxed) => {
            let boxes = boxed.iter().map(|of| errata::errata_list(book, *of)).collect::<anyhow::Result<String>>()?;
            Ok(boxes + &errata::errata_in_chapters(book, items))
        }
        PageRole::Coverage => coverage::page(book),
        _ => bail!("the list of pages puts no records on `{name}`"),
    }
}
