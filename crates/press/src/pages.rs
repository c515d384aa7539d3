//! The pages of the book: one list, from which the table of contents, the list of chapters to be tested and the pages
//! that only list something are written.
//!
//! What is written stands in `book`; a test writes it anew and fails on a difference. Records that are looked up and not
//! read stand behind the book: they have no number, and no chapter leads on to them.

use crate::readme;
use geneva_documents::{self as documents, JAZAR, MEYER, PIN, QUICK_RETURN, wild};
use geneva_evidence::Document;
use geneva_evidence::{Claim, Consequence, Slip};
use std::ops::RangeInclusive;
use std::sync::LazyLock;

/// A page of the book.
pub struct Page {
    /// Its file in `book/src`, without the ending.
    pub name: &'static str,
    /// As the table of contents has it.
    pub title: String,
    /// How it stands in the table of contents.
    pub place: Place,
    /// What it shows of the records, which stand at the end of the book.
    pub records: Records,
    /// Of a page that only lists records the heading and what stands before the list; the others are written by hand.
    pub written: Option<[String; 2]>,
}

/// How a page stands in the table of contents.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Before the parts, without a number: the first page.
    Before,
    /// A chapter of this part, with a number.
    In(&'static str),
    /// Below the chapter before it, folded.
    Below,
    /// Behind the book, without a number: what is looked up.
    Behind,
}

/// What a page lists.
pub enum Records {
    /// Nothing.
    None,
    /// Every claim, section by section.
    Claims,
    /// The slips with these consequences.
    Slips(&'static [Consequence]),
    /// How much of each source the claims account for, and what the copies have lost.
    Coverage,
}

/// A section of a source.
pub struct Section {
    /// The anchor of its heading. With `ledger-` before it, the page that it had of its own in earlier editions.
    pub name: &'static str,
    /// The source.
    pub work: &'static Document,
    /// The lines of the source's text; of what is no document the places of its claims in the ledger, from zero.
    pub lines: RangeInclusive<u32>,
    /// What the section is.
    pub title: &'static str,
}

/// The parts of the book.
const WHEEL: &str = "The wheel";
const LEVER: &str = "The lever";
const CASE: &str = "The case of 1973";
const WILD: &str = "Elsewhere";
const RECORDS: &str = "Records";

/// The page of the wrong statements that are no document's, each with its proof.
const ELSEWHERE: &str = "errata-elsewhere";
/// The page that lists all claims.
pub const LEDGER: &str = "ledger";
/// The page of the claims that are open, which says again what the chapters say of them.
pub const OPEN: &str = "open";
/// The page that says how the sources are covered.
pub const COVERAGE: &str = "coverage";

/// All pages, in the order of the book.
pub static PAGES: LazyLock<Vec<Page>> = LazyLock::new(|| {
    let page = |name: &'static str, title: &str, place| Page {
        name,
        title: title.to_owned(),
        place,
        records: Records::None,
        written: None,
    };
    let chapter = |part, name: &'static str, title: &str| page(name, title, Place::In(part));
    let below = |name: &'static str, title: &str| page(name, title, Place::Below);
    let behind = |name: &'static str, title: &str| page(name, title, Place::Behind);
    vec![
        page("preface", "Geneva, verified", Place::Before),
        chapter(WHEEL, "pin", "The pin in the slot: a problem solved"),
        chapter(WHEEL, "jazar", "The wheel of N stations: sizes and times"),
        chapter(WHEEL, "making", "Make a wheel"),
        chapter(LEVER, "quick-return", "The quick-return mechanism: a problem solved"),
        chapter(CASE, "escapement", "The Geneva escapement"),
        chapter(CASE, "program", "The program of 1973"),
        chapter(CASE, "runs", "What the runs of 1973 were"),
        chapter(CASE, "mistake", "Make the mistake of 1973"),
        chapter(CASE, "never-printed", "The corrected tables"),
        chapter(CASE, "terminal-speed", "Why it reaches a steady speed"),
        chapter(CASE, "timer", "Is it a clock? Seven recommendations"),
        chapter(CASE, "joints", "A pin of finite radius, and friction in the bearings"),
        chapter(WILD, "wild", "Geneva formulas on the web, checked"),
        chapter(WILD, "proofread", "Proofread your own text"),
        chapter(WILD, "found", "What proofreading found"),
        Page {
            records: Records::Slips(&[Consequence::Result, Consequence::Conclusion]),
            ..chapter(RECORDS, "errata", "Errata")
        },
        Page {
            records: Records::Slips(&[
                Consequence::Remark,
                Consequence::Number,
                Consequence::Derivation,
                Consequence::Wording,
            ]),
            written: Some([
                "Errata in displays and words".to_owned(),
                "These mistakes in the sources change no result and no conclusion. [Errata](errata.md) lists the mistakes that do."
                    .to_owned(),
            ]),
            ..below("errata-small", "In displays and words")
        },
        below(ELSEWHERE, "On pages elsewhere"),
        chapter(RECORDS, OPEN, "Open questions"),
        chapter(RECORDS, "method", "How it is checked"),
        chapter(RECORDS, "about", "Sources, data, how to cite"),
        below("glossary", "Glossary"),
        Page { records: Records::Claims, ..behind(LEDGER, "The ledger: every claim") },
        Page { records: Records::Coverage, ..behind(COVERAGE, "Coverage of the sources") },
        behind("fields", "The data, field by field"),
        behind("tests", "The tests behind the chapters"),
        behind("solver", "The solver"),
        behind("mimic", "The language MIMIC"),
        behind("architecture", "Architecture"),
    ]
});

/// The sections of the ledger, in the order of the sources.
pub static SECTIONS: LazyLock<Vec<Section>> = LazyLock::new(|| {
    let section = |name, work, lines, title| Section { name, work, lines, title };
    let whole = |name, work, title| section(name, work, 0..=u32::MAX, title);
    let thesis = |name, lines, title| section(name, &MEYER, lines, title);
    // The first subjects of what is said elsewhere are times, steps and sizes.
    let of_sizes = wild::SUBJECTS.iter().take(3).map(|(_, claims)| claims().len() as u32).sum::<u32>();
    let elsewhere = |name, lines, title| section(name, &documents::WILD, lines, title);
    vec![
        whole("pin", &PIN, "Textbook problem: the pin in the slot"),
        whole("quick-return", &QUICK_RETURN, "Examination problem: the quick-return mechanism"),
        whole("jazar", &JAZAR, "Handout: the wheel of N stations"),
        thesis("meyer", 0..=262, "Thesis: front matter and geometry"),
        thesis("meyer-motion", 263..=425, "Thesis: friction, energy, Lagrange’s equation"),
        thesis("meyer-study", 426..=592, "Thesis: chapter II and appendix A"),
        thesis("meyer-program", 593..=775, "Thesis: appendices B, C and D"),
        thesis("meyer-runs", 776..=799, "Thesis: appendix E, six pins"),
        thesis("meyer-more-runs", 800..=u32::MAX, "Thesis: appendix E, four and three pins"),
        elsewhere("wild", 0..=of_sizes - 1, "Pages elsewhere: times, steps, sizes"),
        elsewhere("wild-parts", of_sizes..=u32::MAX, "Pages elsewhere: parts and motion"),
    ]
});

/// Where a claim stands in the ledger, from any page.
pub fn address_of_claim(id: &str) -> String {
    format!("{LEDGER}.html#{id}")
}

/// The page that tells a slip: of a document by its consequence, of another page with its statements. What only a copy has
/// is listed where the copies are.
pub fn page_of_slip(slip: &Slip) -> &'static str {
    if documents::LEDGER.claim(slip.id).is_some_and(|claim| !claim.document.is_mirrored()) {
        return ELSEWHERE;
    }
    let tells = |page: &&Page| matches!(page.records, Records::Slips(told) if told.contains(&slip.consequence));
    PAGES.iter().find(tells).map_or(COVERAGE, |page| page.name)
}

/// Whether a page is one to look things up in, by its name: what it says of a thing stands behind what a chapter says.
pub fn is_looked_up(name: &str) -> bool {
    let is_record = |page: &Page| {
        page.place == Place::Behind || [OPEN, ELSEWHERE].contains(&page.name) || !matches!(page.records, Records::None)
    };
    PAGES.iter().any(|page| page.name == name && is_record(page))
}

impl Section {
    /// The ids of the claims made in these lines, or in these places of the ledger, in the order of the ledger.
    pub fn ids(&self) -> impl Iterator<Item = &'static str> {
        let work = self.work;
        let lines = self.work.lines().unwrap_or_default().iter().filter(|line| self.lines.contains(&line.number));
        let made: Vec<_> = lines.flat_map(|line| &line.entries).filter_map(|entry| entry.claimed()).collect();
        let own = documents::LEDGER.claims().iter().copied().filter(move |claim| claim.document == work).zip(0..);
        let stands = move |(claim, place): &(&Claim, u32)| {
            if work.is_mirrored() { made.contains(&claim.id) } else { self.lines.contains(place) }
        };
        own.filter(stands).map(|(claim, _)| claim.id)
    }
}

/// What this crate writes into the project: paths and texts.
pub fn written() -> anyhow::Result<Vec<(String, String)>> {
    let listing = |page: &Page| {
        let [heading, lead] = page.written.as_ref()?;
        let text = format!("# {heading}\n\n{lead}\n\n{{{{records:{}}}}}\n", page.name);
        Some((format!("book/src/{}.md", page.name), text))
    };
    let mut written: Vec<_> = PAGES.iter().filter_map(listing).collect();
    written.push(("book/src/SUMMARY.md".to_owned(), table_of_contents()));
    written.extend(readme::pictures()?);
    Ok(written)
}

/// Numbers pages in the order of the contents, as mdBook does.
#[derive(Default)]
pub struct Numbering {
    chapter: usize,
    below: usize,
}

impl Numbering {
    /// The number of the next page, with a point behind it; empty for a page that has none.
    pub fn next(&mut self, place: Place) -> String {
        match place {
            Place::In(_) => {
                (self.chapter, self.below) = (self.chapter + 1, 0);
                format!("{}.", self.chapter)
            }
            Place::Below => {
                self.below += 1;
                format!("{}.{}.", self.chapter, self.below)
            }
            Place::Before | Place::Behind => String::new(),
        }
    }
}

fn table_of_contents() -> String {
    let mut out = "# Summary\n\n".to_owned();
    let mut part = "";
    let mut behind = false;
    for page in PAGES.iter() {
        let indent = match page.place {
            Place::Before => "",
            Place::In(of) => {
                if part != of {
                    out.push_str(&format!("\n# {of}\n\n"));
                    part = of;
                }
                "- "
            }
            Place::Below => "  - ",
            Place::Behind => {
                if !std::mem::replace(&mut behind, true) {
                    out.push_str("\n---\n\n");
                }
                ""
            }
        };
        out.push_str(&format!("{indent}[{}]({}.md)\n", page.title, page.name));
    }
    out
}

/// The chapters as `book/lib.rs` lists them, each to be compiled as tests.
pub fn chapters_to_test() -> String {
    let line = |page: &Page| format!("    {} = \"src/{}.md\",\n", page.name.replace('-', "_"), page.name);
    PAGES.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_claim_stands_in_one_section() {
        let listed: Vec<_> = SECTIONS.iter().flat_map(Section::ids).collect();
        for claim in documents::LEDGER.claims() {
            assert_eq!(listed.iter().filter(|id| **id == claim.id).count(), 1, "{}", claim.id);
        }
        assert_eq!(listed.len(), documents::LEDGER.claims().len());
    }

    #[test]
    fn every_slip_that_is_not_the_copys_stands_on_one_page() {
        for consequence in Consequence::ALL {
            let tells = |page: &&Page| matches!(page.records, Records::Slips(told) if told.contains(consequence));
            let pages = usize::from(*consequence != Consequence::Copy);
            assert_eq!(PAGES.iter().filter(tells).count(), pages, "{consequence}");
        }
    }

    #[test]
    fn each_kind_of_record_that_is_listed_whole_has_one_page() {
        let named = |wanted: fn(&Records) -> bool| {
            PAGES.iter().filter(|page| wanted(&page.records)).map(|page| page.name).collect::<Vec<_>>()
        };
        assert_eq!(named(|records| matches!(records, Records::Claims)), [LEDGER]);
        assert_eq!(named(|records| matches!(records, Records::Coverage)), [COVERAGE]);
        assert!(is_looked_up("errata") && is_looked_up(LEDGER) && is_looked_up("solver") && !is_looked_up("pin"));
    }
}
