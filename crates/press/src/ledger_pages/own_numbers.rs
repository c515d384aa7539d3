//! The numbers of a book's own, which no source prints: by name, and how they are backed.

use super::inline;
use crate::book::Book;
use crate::html::escape;
use crate::lookup;
use crate::table::{Cells, Table};
use anyhow::anyhow;
use geneva_evidence::{Backing, ids_with_backing};

/// A number that the book computes: that of the claim with this id, or one of its own.
pub fn computed(book: &Book, name: &str) -> anyhow::Result<String> {
    if let Some(judged) = book.ledger.verdict(name) {
        return inline::computed_value(book, judged);
    }
    let numbers = (book.own_numbers)();
    if let Some(number) = numbers.iter().find(|number| number.id == name) {
        return number.show().map_err(|error| anyhow!(error));
    }
    if let Some((_, words)) = book.own_words.iter().find(|(known, _)| *known == name) {
        return words();
    }
    let own = numbers.iter().map(|number| number.id).chain(book.own_words.iter().map(|(known, _)| *known));
    let all = own.chain(book.ledger.claims().iter().map(|claim| claim.id));
    Err(lookup::unknown("number", name, all))
}

/// How many of the book's own numbers are backed by what, with the names of those that one route alone gives.
pub fn backing_table(book: &Book) -> anyhow::Result<Table> {
    let numbers = (book.own_numbers)();
    let names = |backing| {
        let ids = ids_with_backing(numbers, backing);
        ids.iter().map(|id| format!("<code>{}</code>", escape(id))).collect::<Vec<_>>().join(", ")
    };
    Table::with_rows(Cells::Words, Backing::ALL)
        .column("How a number of our own is backed", |backing| backing.meaning())
        .column("Numbers", |backing| ids_with_backing(numbers, *backing).len())
        .column("Which", |backing| if *backing == Backing::OneRoute { names(*backing) } else { String::new() })
        .finish()
}
