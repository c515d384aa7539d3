//! The book on the section: what it says of itself, and its pages.

use crate::LEDGER;
use crate::editions::own_numbers;
use geneva_evidence::Consequence;
use geneva_press::Book;
use geneva_press::book::{Examples, LedgerCrate, no_figures};
use geneva_press::imprint::Imprint;
use geneva_press::pages::{Page, PagePlace, PageRole};

/// The book on the section.
pub static BOOK: Book = Book {
    imprint: Imprint {
        title: "Drag and terminal speed, checked",
        subtitle: "A textbook section, computed again",
        authors: "The example's authors",
        key: "drag",
        summary: &["A textbook section on drag and terminal speed, computed again."],
        request: &["Please cite it by its title."],
        keywords: &["drag", "terminal speed"],
        version: env!("CARGO_PKG_VERSION"),
        licence: "CC-BY-4.0",
        licence_words: "CC BY 4.0",
        licence_address: "https://creativecommons.org/licenses/by/4.0/",
        program_licences: &["MIT", "Apache-2.0"],
        homepage: "",
        repository: "",
        program: "geneva-example-drag",
        compiled_from: None,
    },
    ledger: &LEDGER,
    pages: &[
        Page::new("falling", "Falling through air", PagePlace::In("The section")),
        Page::new("slowing", "Drag in liquids", PagePlace::In("The section")),
        Page::new("editions", "Against the newest edition", PagePlace::In("Records")),
        Page::new("errata", "Errata", PagePlace::In("Records"))
            .with_role(PageRole::Slips(&[Consequence::Result, Consequence::Number])),
        Page::new("ledger", "All claims", PagePlace::Behind).with_role(PageRole::Claims),
        Page::new("coverage", "Coverage", PagePlace::Behind).with_role(PageRole::Coverage),
    ],
    sections: &[],
    keys: &[],
    own_numbers,
    own_words: &[],
    figures: no_figures,
    tables: &[],
    works: &[],
    open_groups: &[],
    notation: Vec::new,
    letter_units: &[],
    address_and_day: |_| None,
    synonyms: &[],
    field_meanings: &[],
    modules: &[],
    ledger_crate: Some(LedgerCrate { package: "geneva-example-drag", folder: ".", command: "", account_command: "" }),
    examples: Examples { package: "geneva-example-drag", crates: &[] },
    citation_file: "",
    changelog: "",
};
