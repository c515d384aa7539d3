//! The book on the leaflet: what it says of itself, and its pages.

use crate::LEDGER;
use geneva_evidence::Consequence;
use geneva_press::Book;
use geneva_press::book::LedgerCrate;
use geneva_press::imprint::Imprint;
use geneva_press::pages::{Page, PagePlace, PageRole};

/// Its pages.
const PAGES: &[Page] = &[
    Page::new("falling", "Falling", PagePlace::In("The leaflet")),
    Page::new("swinging", "Swinging", PagePlace::In("The leaflet")),
    Page::new("errata", "Errata", PagePlace::In("Records"))
        .with_role(PageRole::Slips(&[Consequence::Result, Consequence::Number])),
    Page::new("ledger", "All claims", PagePlace::Behind).with_role(PageRole::Claims),
    Page::new("coverage", "Coverage", PagePlace::Behind).with_role(PageRole::Coverage),
];

/// What it says of itself.
const IMPRINT: Imprint = Imprint {
    subtitle: "A leaflet, computed again",
    key: "bodies",
    summary: &["A leaflet on falling and swinging bodies, computed again."],
    keywords: &["falling bodies", "pendulum"],
    ..Imprint::new("Falling bodies, checked", "The example's authors", PACKAGE, env!("CARGO_PKG_VERSION"))
};

const PACKAGE: &str = "geneva-example-bodies";

/// The book on the leaflet.
pub static BOOK: Book = Book {
    ledger_crate: Some(LedgerCrate { package: PACKAGE, folder: ".", command: "", account_command: "" }),
    ..Book::new(IMPRINT, &LEDGER, PAGES)
};
