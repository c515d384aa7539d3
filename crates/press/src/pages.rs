//! The pages of a book: one list, from which the table of contents and the list of chapters to be tested are written; and the
//! sections in which its ledger lists the claims.
//!
//! Records that are looked up and not read stand behind the book: they have no number, and no chapter leads on to them.

use geneva_evidence::{Claim, Consequence, Document, Ledger};
use std::ops::{Range, RangeInclusive};

/// A page of a book.
#[derive(Clone, Copy, Debug)]
pub struct Page {
    /// Its file in `book/src`, without the ending.
    pub name: &'static str,
    /// As the table of contents has it.
    pub title: &'static str,
    /// How it stands in the table of contents.
    pub place: PagePlace,
    /// What the book has it for.
    pub role: PageRole,
    /// Whether the document for paper has it.
    pub is_printed: bool,
}

/// How a page stands in the table of contents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PagePlace {
    /// Before the parts, without a number: the first page.
    Before,
    /// A chapter of this part, with a number.
    In(&'static str),
    /// Below the chapter before it, folded.
    Below,
    /// Behind the book, without a number: what is looked up.
    Behind,
}

/// What a book has a page for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PageRole {
    /// It is read.
    Chapter,
    /// It lists every claim, section by section.
    Claims,
    /// It has a box for each slip with these consequences, and leads to where the others are told.
    Slips(&'static [Consequence]),
    /// It lists how much of each document the claims account for, and what the copies have lost.
    Coverage,
    /// It says of each group of open claims what would settle it.
    OpenClaims,
    /// It tells the slips of what is no mirrored document.
    SlipsElsewhere,
    /// It says what terms mean.
    Glossary,
    /// It says what the book is made from and how it is cited, and lists the works of others.
    Sources,
}

impl PageRole {
    /// Whether the builder lists records on the page, where the page asks for them.
    pub fn is_listing(self) -> bool {
        matches!(self, Self::Claims | Self::Slips(_) | Self::Coverage)
    }
}

impl Page {
    /// A page by its name, its title and its place.
    pub const fn new(name: &'static str, title: &'static str, place: PagePlace) -> Self {
        let is_printed = !matches!(place, PagePlace::Behind);
        Self { name, title, place, role: PageRole::Chapter, is_printed }
    }

    /// A page with another role.
    pub const fn with_role(self, role: PageRole) -> Self {
        Self { role, ..self }
    }

    /// A page behind the book that the document for paper has all the same.
    pub const fn printed(self) -> Self {
        Self { is_printed: true, ..self }
    }

    /// Whether it is a page to look things up in: what it says of a thing stands behind what a chapter says.
    pub fn is_looked_up(&self) -> bool {
        self.place == PagePlace::Behind
            || self.role.is_listing()
            || matches!(self.role, PageRole::OpenClaims | PageRole::SlipsElsewhere)
    }
}

/// A section of a source, as the page of all claims lists it.
#[derive(Clone, Debug)]
pub struct LedgerSection {
    /// The anchor of its heading.
    pub name: &'static str,
    /// The slug of the source.
    pub document: &'static str,
    /// Which of the source's claims it lists.
    pub part: SectionPart,
    /// What the section is.
    pub title: &'static str,
}

/// Some of the claims of a source.
#[derive(Clone, Debug)]
pub enum SectionPart {
    /// All of them.
    Whole,
    /// Those made in these lines of a mirrored document.
    Lines(RangeInclusive<u32>),
    /// Those in these places among the source's claims, from zero.
    Places(fn() -> Range<usize>),
}

impl LedgerSection {
    /// The source, if the ledger has one with its slug.
    pub fn document(&self, ledger: &'static Ledger) -> Option<&'static Document> {
        ledger.document(self.document)
    }

    /// The ids of its claims, in the order of the ledger.
    pub fn ids(&self, ledger: &'static Ledger) -> Vec<&'static str> {
        let Some(document) = self.document(ledger) else { return Vec::new() };
        let own = ledger.claims().iter().copied().filter(|claim| claim.document == document);
        let id = |claim: &Claim| claim.id;
        match &self.part {
            SectionPart::Whole => own.map(id).collect(),
            SectionPart::Places(places) => {
                let places = places();
                own.take(places.end).skip(places.start).map(id).collect()
            }
            SectionPart::Lines(range) => {
                let lines = document.lines().unwrap_or_default().iter();
                let lines = lines.filter(|line| range.contains(&line.number));
                let made: Vec<_> = lines.flat_map(|line| &line.entries).filter_map(|entry| entry.claimed()).collect();
                own.map(id).filter(|id| made.contains(id)).collect()
            }
        }
    }
}

/// Numbers pages in the order of the contents, as mdBook does.
#[derive(Default)]
pub struct Numbering {
    chapter: usize,
    below: usize,
}

impl Numbering {
    /// The number of the next page, with a point behind it; empty for a page that has none.
    pub fn next(&mut self, place: PagePlace) -> String {
        match place {
            PagePlace::In(_) => {
                (self.chapter, self.below) = (self.chapter + 1, 0);
                format!("{}.", self.chapter)
            }
            PagePlace::Below => {
                self.below += 1;
                format!("{}.{}.", self.chapter, self.below)
            }
            PagePlace::Before | PagePlace::Behind => String::new(),
        }
    }
}

/// The table of contents: its path in the project and its text.
pub fn generate_summary(pages: &[Page]) -> (String, String) {
    let mut out = "# Summary\n\n".to_owned();
    let mut part = "";
    let mut behind = false;
    for page in pages {
        let indent = match page.place {
            PagePlace::Before => "",
            PagePlace::In(of) => {
                if part != of {
                    out.push_str(&format!("\n# {of}\n\n"));
                    part = of;
                }
                "- "
            }
            PagePlace::Below => "  - ",
            PagePlace::Behind => {
                if !std::mem::replace(&mut behind, true) {
                    out.push_str("\n---\n\n");
                }
                ""
            }
        };
        out.push_str(&format!("{indent}[{}]({}.md)\n", page.title, page.name));
    }
    ("book/src/SUMMARY.md".to_owned(), out)
}

/// The chapters as `book/lib.rs` lists them, each to be compiled as tests.
pub fn chapters_to_test(pages: &[Page]) -> String {
    let line = |page: &Page| format!("    {} = \"src/{}.md\",\n", page.name.replace('-', "_"), page.name);
    pages.iter().map(line).collect()
}
