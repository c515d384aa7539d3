//! The pages of the book: one list, from which the table of contents, the list of chapters to be tested and the pages
//! that only list something are written.
//!
//! What is written stands in `book`; a test writes it anew and fails on a difference. One page for the whole ledger
//! would be too heavy for a phone, so each page lists some sections of the sources.

use crate::readme;
use geneva_ledger::{Claim, Consequence, Slip, Work, claim, claims, wild};
use std::collections::HashMap;
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
}

/// What a page lists.
pub enum Records {
    /// Nothing.
    None,
    /// The claims of these sections.
    Claims(Vec<Section>),
    /// The slips with these consequences.
    Slips(&'static [Consequence]),
    /// The lines of these sources.
    Lines(&'static [Work]),
}

/// A section of a source.
pub struct Section {
    /// The source.
    pub work: Work,
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

/// The page of what is said elsewhere.
const ELSEWHERE: &str = "wild";

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
    let listing = |name: &'static str, title: &str, heading: &str, lead: &str, records| Page {
        records,
        written: Some([heading.to_owned(), lead.to_owned()]),
        ..below(name, title)
    };
    let whole = |work, title| Section { work, lines: 0..=u32::MAX, title };
    let thesis = |name: &'static str, of: &str, lines, title| {
        let lead = "This page lists the claims of these parts of the thesis in the order of the source and says what we \
                    found out about each.";
        let records = Records::Claims(vec![Section { work: Work::Meyer1973, lines, title }]);
        listing(name, &format!("Thesis: {of}"), &format!("The ledger of the thesis: {of}"), lead, records)
    };
    let elsewhere = |lines, title| Records::Claims(vec![Section { work: Work::Wild, lines, title }]);
    // The first subjects of what is said elsewhere are times, steps and sizes.
    let of_sizes = wild::SUBJECTS.iter().take(3).map(|(_, claims)| claims().len() as u32).sum::<u32>();
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
        chapter(WILD, ELSEWHERE, "Geneva formulas on the web, checked"),
        Page {
            records: Records::Slips(&[Consequence::Result, Consequence::Conclusion]),
            ..chapter(RECORDS, "errata", "Errata")
        },
        listing(
            "errata-small",
            "In displays and words",
            "Errata in displays and words",
            "These mistakes in the sources change no result and no conclusion. For those that do, see [Errata](errata.md).",
            Records::Slips(&[Consequence::Remark, Consequence::Number, Consequence::Derivation, Consequence::Wording]),
        ),
        Page { records: Records::Slips(&[Consequence::Copy]), ..below("errata-copy", "Characters of the copies") },
        chapter(RECORDS, "method", "How it is checked"),
        Page {
            records: Records::Claims(vec![
                whole(Work::Pin, "the pin in the slot"),
                whole(Work::QuickReturn, "the quick-return mechanism"),
            ]),
            ..below("ledger", "The ledger: both problems")
        },
        listing(
            "ledger-jazar",
            "Handout: the wheel of N stations",
            "The ledger of the handout",
            "This page lists the claims of the handout in the order of the source and says what we found out about each.",
            Records::Claims(vec![whole(Work::Jazar2003, "the wheel of N stations")]),
        ),
        thesis("ledger-meyer", "geometry", 0..=262, "front matter and geometry"),
        thesis("ledger-meyer-motion", "friction and motion", 263..=425, "friction, energy, Lagrange’s equation"),
        thesis("ledger-meyer-study", "chapter II and appendix A", 426..=592, "chapter II, appendix A"),
        thesis("ledger-meyer-program", "appendices B to D", 593..=775, "appendices B, C and D"),
        thesis("ledger-meyer-runs", "appendix E, six pins", 776..=799, "appendix E, six pins"),
        thesis("ledger-meyer-more-runs", "appendix E, other runs", 800..=u32::MAX, "appendix E, four and three pins"),
        listing(
            "ledger-wild",
            "Elsewhere: times, steps, sizes",
            "The ledger of what is said elsewhere: times, steps, sizes",
            "Statements of public pages and programs, with what we found out about each. They are the subject of [In the \
             wild](wild.md), and the rest of them are on [another page](ledger-wild-parts.md).\n\n\
             ## Where we read them {#where-they-were-read}\n\n{{elsewhere-addresses}}",
            elsewhere(0..=of_sizes - 1, "statements elsewhere on times, steps and sizes"),
        ),
        listing(
            "ledger-wild-parts",
            "Elsewhere: parts and motion",
            "The ledger of what is said elsewhere: parts and motion",
            "Statements of public pages and programs, and examples that programs build, with what we found out about \
             each. All addresses are at the beginning of [the first part](ledger-wild.md).",
            elsewhere(of_sizes..=u32::MAX, "statements and examples elsewhere on parts and motion"),
        ),
        Page {
            records: Records::Lines(&[Work::Pin, Work::QuickReturn, Work::Jazar2003]),
            ..below("coverage", "Coverage")
        },
        listing(
            "coverage-meyer",
            "Coverage of the thesis",
            "Coverage of the thesis",
            "Here is the thesis line by line. For what coverage means, see [the page on the other sources](coverage.md).",
            Records::Lines(&[Work::Meyer1973]),
        ),
        chapter(RECORDS, "about", "Sources, data, how to cite"),
        below("glossary", "Glossary"),
        below("solver", "The solver"),
        below("mimic", "The language MIMIC"),
        below("architecture", "Architecture"),
    ]
});

/// The page that lists a claim. The ledger's first one if none does, which a test excludes.
pub fn page_of_claim(id: &str) -> &'static str {
    static PAGE: LazyLock<HashMap<&str, &str>> = LazyLock::new(|| {
        let sections = PAGES.iter().flat_map(|page| page.sections().iter().map(|section| (page.name, section)));
        sections.flat_map(|(page, section)| section.ids().map(move |id| (id, page))).collect()
    });
    PAGE.get(id).copied().unwrap_or("ledger")
}

/// The page that tells a slip: of a document by its consequence, of another page with its statements. The first of the
/// errata if none does, which a test excludes.
pub fn page_of_slip(slip: &Slip) -> &'static str {
    if claim(slip.id).is_some_and(|claim| !claim.work.is_document()) {
        return ELSEWHERE;
    }
    let tells = |page: &&Page| matches!(page.records, Records::Slips(told) if told.contains(&slip.consequence));
    PAGES.iter().find(tells).map_or("errata", |page| page.name)
}

impl Page {
    /// The sections whose claims it lists.
    pub fn sections(&self) -> &[Section] {
        if let Records::Claims(sections) = &self.records { sections } else { &[] }
    }
}

impl Section {
    /// The ids of the claims made in these lines, or in these places of the ledger, in the order of the ledger.
    pub fn ids(&self) -> impl Iterator<Item = &'static str> {
        let work = self.work;
        let lines = self.work.inventory().unwrap_or_default().iter().filter(|line| self.lines.contains(&line.number));
        let made: Vec<_> = lines.flat_map(|line| &line.entries).filter_map(|entry| entry.claimed()).collect();
        let own = claims().iter().filter(move |claim| claim.work == work).zip(0..);
        let stands = move |(claim, place): &(&Claim, u32)| {
            if work.is_document() { made.contains(&claim.id) } else { self.lines.contains(place) }
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

fn table_of_contents() -> String {
    let mut out = "# Summary\n\n".to_owned();
    let mut part = "";
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
    fn every_claim_stands_on_one_page() {
        let listed: Vec<_> =
            PAGES.iter().flat_map(Page::sections).flat_map(|section| section.ids().collect::<Vec<_>>()).collect();
        for claim in claims() {
            assert_eq!(listed.iter().filter(|id| **id == claim.id).count(), 1, "{}", claim.id);
        }
    }

    #[test]
    fn every_slip_and_every_line_stands_on_one_page() {
        for consequence in Consequence::ALL {
            let tells = |page: &&Page| matches!(page.records, Records::Slips(told) if told.contains(consequence));
            assert_eq!(PAGES.iter().filter(tells).count(), 1, "{consequence}");
        }
        for work in Work::DOCUMENTS {
            let lists = |page: &&Page| matches!(page.records, Records::Lines(works) if works.contains(work));
            assert_eq!(PAGES.iter().filter(lists).count(), 1, "{work}");
        }
    }
}
