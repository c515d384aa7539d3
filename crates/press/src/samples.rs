//! A small book of another field for the tests of this crate: a leaflet on falling bodies, of which one number is wrong.

use crate::book::Expansion::Of;
use crate::book::{Book, CitedWork, Examples, PageFigure, PageModule, PlaceholderKey};
use crate::imprint::Imprint;
use crate::pages::{Page, PagePlace, PageRole};
use crate::table::{Cells, Table};
use geneva_evidence::{
    Cache, Claim, Consequence, Document, Evidence, InventoryFile, Ledger, Locator, Origin, Slip, Symbol,
};

/// What the book says of itself.
pub(crate) const IMPRINT: Imprint = Imprint {
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

/// The leaflet: acceleration and height of a fall, its time, and its speed at the end, which is wrong.
pub(crate) static LEAFLET: Document = Document {
    slug: "leaflet",
    title: "leaflet",
    citation: "A leaflet on falling bodies",
    inventory: Some(InventoryFile {
        path: "leaflet.inventory",
        text: "# The leaflet.\n\nline 1: 9.81 20\n  claim leaflet.gravity\n  exception leaflet.height (20): what is given\nline \
               2: 2.02 18.9\n  claim leaflet.time\n  claim leaflet.speed\n",
    }),
    claims,
    answers: &["leaflet.speed"],
    given: || vec!["leaflet.gravity".to_owned()],
    conclusions: &[],
    symbols: &[Symbol { printed: "h", ours: "h", meaning: "height of the fall" }],
    units: &[],
    test: "",
    cache: Cache::new(),
};

/// The mistake in the speed.
const SLIP: Slip = Slip {
    id: "",
    reason: "The speed is the acceleration times the time.",
    witness: "The square of the speed is twice acceleration times height.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Result,
    changes: "The speed is greater.",
};

fn claims() -> Vec<Claim> {
    let number = |id: &'static str| LEAFLET.printed_number(id);
    let (given, found) = (Locator::new(&LEAFLET, "line 1"), Locator::new(&LEAFLET, "line 2"));
    vec![
        given
            .value("leaflet.gravity", "9.81", "m/s^2", "acceleration of a falling body")
            .first_route(Evidence::CLOSED_FORM, || 9.806_65)
            .second_route(Evidence::LIMIT_CASE, || 9.806_65),
        found
            .value("leaflet.time", "2.02", "s", "time of a fall")
            .first_route(Evidence::CLOSED_FORM, move || (2.0 * HEIGHT / number("leaflet.gravity")).sqrt())
            .second_route(Evidence::LIMIT_CASE, move || {
                2.0 * HEIGHT / (2.0 * number("leaflet.gravity") * HEIGHT).sqrt()
            }),
        found
            .value("leaflet.speed", "18.9", "m/s", "speed at the end of the fall")
            .first_route(Evidence::CLOSED_FORM, move || (2.0 * number("leaflet.gravity") * HEIGHT).sqrt())
            .second_route(Evidence::LIMIT_CASE, move || {
                number("leaflet.gravity") * (2.0 * HEIGHT / number("leaflet.gravity")).sqrt()
            })
            .corrected("19.8", SLIP),
    ]
}

/// The height of the fall, in metres.
const HEIGHT: f64 = 20.0;

/// The leaflet with its verdicts.
pub(crate) static LEDGER: Ledger = Ledger::new(&[&LEAFLET], &[Evidence::CLOSED_FORM, Evidence::LIMIT_CASE]);

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

/// Its pages.
const PAGES: &[Page] = &[
    Page::new("preface", "First", PagePlace::Before),
    Page::new("pin", "A chapter", PagePlace::In("Part")),
    Page::new("jazar", "Another chapter", PagePlace::In("Part")),
    Page::new("about", "Sources", PagePlace::In("Part")).with_role(PageRole::Sources),
    Page::new("errata", "Errata", PagePlace::In("Part")).with_role(PageRole::Slips(&[Consequence::Result])),
    Page::new("ledger", "All claims", PagePlace::Behind).with_role(PageRole::Claims),
];

/// The book.
pub(crate) static BOOK: Book = Book {
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
    tables: &[("rows", || {
        Table::with_rows(Cells::Numbers, [1_u32]).column("x", |x| *x).column("y", |x| 2 * x).finish()
    })],
    works: &[work("alon", "Alon"), work("johnson", "Johnson")],
    modules: &[PageModule {
        attributes: &["data-live", "data-given"],
        name: "live",
        package: "sample-live",
        folder: "live",
        script: "",
        style: "",
        later: &[],
    }],
    examples: Examples { package: "sample", crates: &[] },
    ..Book::new(IMPRINT, &LEDGER, PAGES)
};

/// The file of the first chapter below the book's folder, that of the second, and a text of the second that leads to the first.
pub(crate) const FIRST: &str = "src/pin.md";
pub(crate) const SECOND: &str = "src/jazar.md";
pub(crate) const LED: &str = "See [the first](pin.md). Text";
