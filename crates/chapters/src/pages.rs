//! The pages of this book, and the sections in which its ledger lists the claims.
//!
//! What is written from them stands in `book`; a test writes it anew and fails on a difference.

use geneva_documents::wild;
use geneva_evidence::Consequence;
use geneva_press::pages::PagePlace::{Before, Behind, Below, In};
use geneva_press::pages::{LedgerSection, Page, PageRole, SectionPart};
use std::ops::Range;

/// The parts of the book.
const WHEEL: &str = "The wheel";
const LEVER: &str = "The lever";
const CASE: &str = "The case of 1973";
const WILD: &str = "Elsewhere";
const RECORDS: &str = "Records";

/// All pages, in the order of the book.
pub const PAGES: &[Page] = &[
    Page::new("preface", "Geneva, verified", Before),
    Page::new("pin", "The pin in the slot: a problem solved", In(WHEEL)),
    Page::new("jazar", "The wheel of N stations: sizes and times", In(WHEEL)),
    Page::new("making", "Make a wheel", In(WHEEL)),
    Page::new("quick-return", "The quick-return mechanism: a problem solved", In(LEVER)),
    Page::new("escapement", "The Geneva escapement", In(CASE)),
    Page::new("program", "The program of 1973", In(CASE)),
    Page::new("runs", "What the runs of 1973 were", In(CASE)),
    Page::new("mistake", "Make the mistake of 1973", In(CASE)),
    Page::new("never-printed", "The corrected tables", In(CASE)),
    Page::new("terminal-speed", "Why it reaches a steady speed", In(CASE)),
    Page::new("timer", "Is it a clock? Seven recommendations", In(CASE)),
    Page::new("joints", "A pin of finite radius, and friction in the bearings", In(CASE)),
    Page::new("wild", "Geneva formulas on the web, checked", In(WILD)),
    Page::new("your-document", "Check your own document", In(WILD)),
    Page::new("proofread", "Proofread your own text", In(WILD)),
    Page::new("found", "What proofreading found", In(WILD)),
    Page::new("errata", "Errata", In(RECORDS))
        .with_role(PageRole::Slips(&[Consequence::Result, Consequence::Conclusion])),
    Page::new("errata-elsewhere", "On pages elsewhere", Below).with_role(PageRole::SlipsElsewhere),
    Page::new("open", "Open questions", In(RECORDS)).with_role(PageRole::OpenClaims),
    Page::new("method", "How it is checked", In(RECORDS)),
    Page::new("about", "Sources, data, how to cite", In(RECORDS)).with_role(PageRole::Sources),
    Page::new("glossary", "Glossary", Below).with_role(PageRole::Glossary),
    Page::new("ledger", "The ledger: every claim", Behind).with_role(PageRole::Claims),
    Page::new("coverage", "Coverage of the sources", Behind).with_role(PageRole::Coverage),
    Page::new("mimic", "The language MIMIC", Behind).printed(),
];

/// The sections of the ledger, in the order of the sources. With `ledger-` before its name, the address of a section is that of
/// the page that it had of its own in earlier editions.
pub const SECTIONS: &[LedgerSection] = &[
    section("pin", "pin", SectionPart::Whole, "Textbook problem: the pin in the slot"),
    section("quick-return", "quick-return", SectionPart::Whole, "Examination problem: the quick-return mechanism"),
    section("jazar", "jazar", SectionPart::Whole, "Handout: the wheel of N stations"),
    thesis("meyer", 0, 262, "Thesis: front matter and geometry"),
    thesis("meyer-motion", 263, 425, "Thesis: friction, energy, Lagrange’s equation"),
    thesis("meyer-study", 426, 592, "Thesis: chapter II and appendix A"),
    thesis("meyer-program", 593, 775, "Thesis: appendices B, C and D"),
    thesis("meyer-runs", 776, 799, "Thesis: appendix E, six pins"),
    thesis("meyer-more-runs", 800, u32::MAX, "Thesis: appendix E, four and three pins"),
    section("wild", "wild", SectionPart::Places(first_subjects), "Pages elsewhere: times, steps, sizes"),
    section("wild-parts", "wild", SectionPart::Places(other_subjects), "Pages elsewhere: parts and motion"),
];

const fn section(name: &'static str, document: &'static str, part: SectionPart, title: &'static str) -> LedgerSection {
    LedgerSection { name, document, part, title }
}

/// A section of the thesis, from one line of its text to another.
const fn thesis(name: &'static str, first: u32, last: u32, title: &'static str) -> LedgerSection {
    section(name, "meyer", SectionPart::Lines(first..=last), title)
}

/// The places of the claims elsewhere on the first subjects, which are times, steps and sizes.
fn first_subjects() -> Range<usize> {
    0..wild::SUBJECTS.iter().take(3).map(|(_, claims)| claims().len()).sum()
}

/// The places of the claims elsewhere on the other subjects.
fn other_subjects() -> Range<usize> {
    first_subjects().end..usize::MAX
}
