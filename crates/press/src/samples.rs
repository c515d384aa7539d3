//! A small book for the tests of this crate.

use crate::book::Expansion::Of;
use crate::book::{Book, CitedWork, Examples, PageFigure, PageModule, PlaceholderKey};
use crate::html::{Cells, table};
use crate::imprint::Imprint;
use crate::ledger::LEDGER;
use crate::pages::{Page, PagePlace, PageRole};

/// What the book says of itself.
pub const IMPRINT: Imprint = Imprint {
    title: "A sample",
    subtitle: "For tests",
    authors: "Nobody",
    key: "sample",
    summary: &["A book of a few pages."],
    request: &["Please cite it."],
    keywords: &["sample"],
    version: "1.2.3",
    licence: "CC-BY-4.0",
    licence_words: "CC BY 4.0",
    licence_address: "file:licence",
    program_licences: &["MIT"],
    homepage: "",
    repository: "",
    program: "sample",
    compiled_from: None,
};

const fn work(key: &'static str, short: &'static str) -> CitedWork {
    CitedWork {
        key,
        short,
        authors: short,
        title: "Of shafts",
        published: "a page",
        year: "1985",
        address: "",
        read: "here",
        read_on: "2026-11-26",
    }
}

/// The book.
pub static BOOK: Book = Book {
    imprint: IMPRINT,
    ledger: &LEDGER,
    pages: &[
        Page::new("preface", "First", PagePlace::Before),
        Page::new("pin", "A chapter", PagePlace::In("Part")),
        Page::new("jazar", "Another chapter", PagePlace::In("Part")),
        Page::new("about", "Sources", PagePlace::In("Part")).with_role(PageRole::Sources),
        Page::new("ledger", "All claims", PagePlace::Behind).with_role(PageRole::Claims),
        Page::new("tests", "Programs", PagePlace::Behind).with_role(PageRole::Programs),
    ],
    sections: &[],
    keys: &[PlaceholderKey::new(
        "double",
        "a number twice",
        Of(|_, number| Ok((2 * number.parse::<u32>()?).to_string())),
    )],
    figures: |name| {
        let figure = PageFigure {
            drawing: "<svg></svg>".to_owned(),
            caption: format!("What {name} shows."),
            csv: "x\n1\n".to_owned(),
            source: "samples",
        };
        crate::lookup::find_named("figure", name, &[("circle", ())]).map(|()| figure)
    },
    tables: &[("rows", || table("Rows", Cells::Numbers, &["x", "y"], [Ok(vec!["1".to_owned(), "2".to_owned()])]))],
    works: &[work("alon", "Alon"), work("johnson", "Johnson")],
    open_groups: &[],
    notation: Vec::new,
    source_names: &[],
    evidence_words: &[],
    letter_units: &[],
    address_and_day: |_| None,
    field_meanings: &[],
    modules: &[PageModule {
        attributes: &["data-live", "data-given"],
        name: "live",
        package: "sample-live",
        folder: "live",
        script: "",
        style: "",
    }],
    examples: Examples { package: "sample", crates: &[] },
    citation_file: "",
};
