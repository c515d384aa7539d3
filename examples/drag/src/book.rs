//! The book on the section: what it says of itself, and its pages.

use crate::LEDGER;
use crate::editions::own_numbers;
use geneva_evidence::Consequence;
use geneva_press::Book;
use geneva_press::book::LedgerCrate;
use geneva_press::imprint::Imprint;
use geneva_press::pages::{Page, PagePlace, PageRole};

/// Its pages.
const PAGES: &[Page] = &[
    Page::new("falling", "Falling through air", PagePlace::In("The section")),
    Page::new("slowing", "Drag in liquids", PagePlace::In("The section")),
    Page::new("editions", "Against the newest edition", PagePlace::In("Records")),
    Page::new("errata", "Errata", PagePlace::In("Records"))
        .with_role(PageRole::Slips(&[Consequence::Result, Consequence::Number])),
    Page::new("ledger", "All claims", PagePlace::Behind).with_role(PageRole::Claims),
    Page::new("coverage", "Coverage", PagePlace::Behind).with_role(PageRole::Coverage),
];

/// What it says of itself.
const IMPRINT: Imprint = Imprint {
    subtitle: "A textbook section, computed again",
    key: "drag",
    summary: &["A textbook section on drag and terminal speed, computed again."],
    keywords: &["drag", "terminal speed"],
    ..Imprint::new("Drag and terminal speed, checked", "The example's authors", PACKAGE, env!("CARGO_PKG_VERSION"))
};

const PACKAGE: &str = "geneva-example-drag";

/// The book on the section.
pub static BOOK: Book = Book {
    own_numbers,
    ledger_crate: Some(LedgerCrate { package: PACKAGE, folder: ".", command: "", account_command: "" }),
    ..Book::new(IMPRINT, &LEDGER, PAGES)
};
