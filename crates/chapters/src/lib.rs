//! This book: its pages, its numbers, tables and figures, as a [`BOOK`] that the book builder turns into pages.
//!
//! It says which number stands in which chapter and how it is drawn; the solvers compute it, and the ledger has the verdicts.
//! Nothing here prints a line, and nothing derives a formula.

// The book as a list.
pub mod bibliography;
mod imprint;
mod keys;
mod modules;
mod open_groups;
pub mod pages;
mod synonyms;

// What stands for a placeholder.
pub mod computed;
pub mod elsewhere;
pub mod figures;
pub mod live;
pub mod proofreading_form;
pub mod questions;
pub mod tables;

// What stands in the project beside the book.
pub mod readme;

// What these need.
mod lookup;
mod printed_cells;
mod proofreading_record;
mod rows;

#[cfg(test)]
mod tests;

use geneva_documents::LEDGER;
use geneva_figures::notation::NOTATION;
use geneva_press::Book;
use geneva_press::book::{Examples, LedgerCrate, NotationLetter};
use geneva_press::pages::generate_summary;

/// This book.
pub static BOOK: Book = Book {
    imprint: imprint::IMPRINT,
    ledger: &LEDGER,
    pages: pages::PAGES,
    sections: pages::SECTIONS,
    keys: keys::KEYS,
    own_numbers: computed::own_numbers,
    own_words: computed::OWN_WORDS,
    figures: figures::on_a_page,
    tables: tables::TABLES,
    works: bibliography::WORKS,
    open_groups: open_groups::OPEN_GROUPS,
    notation,
    // Lengths in crank radii.
    letter_units: &["R"],
    address_and_day: geneva_documents::wild::read,
    synonyms: synonyms::SYNONYMS,
    field_meanings: FIELD_MEANINGS,
    modules: modules::MODULES,
    ledger_crate: Some(LedgerCrate {
        package: "geneva-documents",
        folder: "crates/documents",
        command: "cargo run -- claims ID --printed 'CHARACTERS'",
        account_command: "cargo run -- claims ID",
    }),
    examples: EXAMPLES,
    citation_file: include_str!("../../../CITATION.cff"),
    changelog: include_str!("../../../CHANGELOG.md"),
};

/// The examples in the chapters: the root package, and the crates that an example may use.
pub const EXAMPLES: Examples = Examples {
    package: "geneva-suite",
    crates: &[
        "geneva_kinematics",
        "geneva_dynamics",
        "geneva_mimic",
        "geneva_case1973",
        "geneva_evidence",
        "geneva_documents",
        "geneva_figures",
        "approx",
        "nalgebra",
        "ode_solvers",
        "plotters",
        "insta",
        "mdbook_driver",
    ],
};

/// The files of figures, as the list of fields names them.
const OF_A_FIGURE: &str = "CSV of a figure";

/// Fields of the data of which this book has more to say than what they are in every book.
const FIELD_MEANINGS: &[(&str, &str, &str)] = &[
    (
        "claims",
        "source",
        "The source: `pin`, `quick-return`, `jazar` (the handout), `meyer` (the thesis) or `wild` (pages elsewhere, which the book counts separately).",
    ),
    (
        "claims",
        "kind",
        "What sort of claim it is: `value` (a printed number), `equation`, `figure`, `statement`, or `example` (sizes of a mechanism that a program builds).",
    ),
    (
        "claims",
        "verdict",
        "The class of the verdict that the program derived. A table in *How it is checked* says which verdict on the pages each class is.",
    ),
    (
        "every JSON file",
        "address",
        "Where the book can be read. Null if that isn't settled. The address of a claim is this one, `ledger.html#` and the claim's `id`.",
    ),
    (OF_A_FIGURE, "theta", "The angle of the driver or the crank."),
    (OF_A_FIGURE, "phi", "The angle of the wheel, the follower or the lever."),
    (OF_A_FIGURE, "an apostrophe behind a letter", "It stands for the dot that marks a rate of change."),
    (OF_A_FIGURE, "other letters", "Those of the book, in ASCII: glossary.html#letters."),
    (OF_A_FIGURE, "slots", "The number of slots."),
    (
        OF_A_FIGURE,
        "pins",
        "The number of pins. In the mechanisms of the thesis, six pins go with three slots, and three pins with six slots.",
    ),
    (
        OF_A_FIGURE,
        "columns with the unit `unit`",
        "Both speeds and times from runs of the thesis: the unit is one rad/s for a speed, but one millisecond for a time. \
         For each row of a table of the thesis, in the order of the tables, the rows give the peak speed, the minimum \
         speed and the period.",
    ),
];

/// The letters of the triangle, of its motion and of the force in the slot.
fn notation() -> Vec<NotationLetter> {
    let letter = |of: &geneva_figures::notation::Letter| NotationLetter {
        tex: of.tex,
        meaning: of.meaning,
        counted: of.counted,
    };
    NOTATION.iter().map(letter).collect()
}

/// What this crate writes into the project: paths and texts.
pub fn generate_files() -> anyhow::Result<Vec<(String, String)>> {
    Ok([generate_summary(BOOK.pages)].into_iter().chain(readme::pictures()?).collect())
}
