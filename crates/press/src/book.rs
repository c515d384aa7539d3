//! A book, as a value: its ledger, its pages, and what it adds to the keys that every book has.

use crate::edition::Edition;
use crate::imprint::Imprint;
use crate::page_items::PageItem;
use crate::pages::{LedgerSection, Page, PageRole};
use crate::synonyms::Synonym;
use crate::table::Table;
use anyhow::ensure;
use geneva_evidence::{Consequence, Document, Ledger, OwnNumber, Slip};

/// What a book is made of. It is made once, as a `static`; [`build`](crate::build) turns it into pages.
pub struct Book {
    /// What it says of itself.
    pub imprint: Imprint,
    /// Its sources, their claims and the verdicts.
    pub ledger: &'static Ledger,
    /// All pages, in their order.
    pub pages: &'static [Page],
    /// The sections of the page of all claims; empty for one section to each source.
    pub sections: &'static [LedgerSection],
    /// The keys in double braces that it adds to those of every book.
    pub keys: &'static [PlaceholderKey],
    /// The numbers of its own that its chapters state: those that no source prints.
    pub own_numbers: fn() -> &'static [OwnNumber],
    /// What its chapters state of its own and is no number, by name.
    pub own_words: &'static [(&'static str, MakeText)],
    /// Draws the figure of a name. An unknown name is answered with those there are; see [`find_named`](crate::lookup::find_named).
    pub figures: fn(&str) -> anyhow::Result<PageFigure>,
    /// Tables of computed numbers, by name.
    pub tables: &'static [(&'static str, MakeTable)],
    /// The works of others that its chapters cite, in the order of the list.
    pub works: &'static [CitedWork],
    /// Groups of open claims that the same thing would settle.
    pub open_groups: &'static [OpenGroup],
    /// The letters that stand for one thing in the whole book.
    pub notation: fn() -> Vec<NotationLetter>,
    /// Units that are letters of formulas, such as a radius in which lengths are printed.
    pub letter_units: &'static [&'static str],
    /// Address and day of a locator that is that of a page elsewhere.
    pub address_and_day: fn(&str) -> Option<(&str, &str)>,
    /// What readers may search for that the pages call otherwise.
    pub synonyms: &'static [Synonym],
    /// What the book says of a field of its data in place of the builder's words, or of one that only it has: file, path and
    /// meaning.
    pub field_meanings: &'static [(&'static str, &'static str, &'static str)],
    /// Programs that answer its pages, compiled for WebAssembly.
    pub modules: &'static [PageModule],
    /// The crate that has its ledger, so that readers can check claims in its pages; none for pages without checks.
    pub ledger_crate: Option<LedgerCrate>,
    /// The examples in its chapters.
    pub examples: Examples,
    /// The text of `CITATION.cff`, which is among its data.
    pub citation_file: &'static str,
    /// The text of its changelog, which says when a version was released and which verdicts it changed; empty for none.
    pub changelog: &'static str,
}

/// The figures of a book that has none.
///
/// # Errors
///
/// That there is no figure of this name.
pub fn no_figures(name: &str) -> anyhow::Result<PageFigure> {
    anyhow::bail!("no figure `{name}`: this book has no figures")
}

/// Makes a text.
pub type MakeText = fn() -> anyhow::Result<String>;

/// Makes a table of computed numbers.
pub type MakeTable = fn() -> anyhow::Result<Table>;

/// A key in double braces, `{{key:argument}}` or `{{key}}`.
#[derive(Clone, Copy)]
pub struct PlaceholderKey {
    /// The key.
    pub name: &'static str,
    /// What it says or shows.
    pub meaning: &'static str,
    /// How that is made.
    pub expansion: Expansion,
    /// Whether it is text of a chapter, and no drawing, form or record of its own.
    pub is_text: bool,
}

impl PlaceholderKey {
    /// A key, what it says or shows, and how that is made.
    pub const fn new(name: &'static str, meaning: &'static str, expansion: Expansion) -> Self {
        Self { name, meaning, expansion, is_text: true }
    }

    /// A key for a drawing, a form or a record of its own.
    pub const fn without_text(self) -> Self {
        Self { is_text: false, ..self }
    }
}

/// What takes the place of a key in double braces.
#[derive(Clone, Copy)]
pub enum Expansion {
    /// What needs no argument.
    Bare(fn(&Book) -> anyhow::Result<String>),
    /// What needs one.
    Of(fn(&Book, &str) -> anyhow::Result<String>),
    /// What leads to figures, tables and errata, and needs to know on which pages they are.
    Placed(fn(&Book, &str, &[PageItem]) -> anyhow::Result<String>),
    /// What bears the mark of a claim, whose note is put at the end of the page.
    Marked(fn(&Book, &str) -> anyhow::Result<String>),
    /// What says which edition of the book this is.
    Dated(fn(&Book, &Edition) -> anyhow::Result<String>),
    /// What says something that the argument names about the edition.
    DatedOf(fn(&Book, &str, &Edition) -> anyhow::Result<String>),
    /// A figure with its number in the chapter.
    Figure,
    /// A figure with its number in the chapter and with what a reader may move: the name by which a chapter refers to it, if it
    /// is known, and the figure.
    Interactive(fn(&str) -> Option<&'static str>, fn(&Book, &str) -> anyhow::Result<InteractiveFigure>),
    /// A table with its number in the chapter, which gives its caption behind a semicolon.
    Numbered(fn(&Book, &str) -> anyhow::Result<Table>),
    /// The number of a figure or a table, as a link.
    Reference,
}

/// A figure as a page shows it.
#[derive(Clone, Debug)]
pub struct PageFigure {
    /// The drawing, as SVG within HTML.
    pub drawing: String,
    /// What it shows, as plain text.
    pub caption: String,
    /// Its numbers, as CSV.
    pub csv: String,
    /// What makes it, for who wants to read the program.
    pub source: &'static str,
}

/// A figure as it stands at first, and what makes it move.
#[derive(Clone, Debug)]
pub struct InteractiveFigure {
    /// The still figure, its drawing with the controls.
    pub figure: PageFigure,
    /// The attributes of the figure element that its script reads, each with a space before it.
    pub attributes: String,
}

/// A work of others on which a sentence of the book leans.
#[derive(Clone, Copy, Debug)]
pub struct CitedWork {
    /// By which a chapter cites it.
    pub key: &'static str,
    /// As a citation names the authors.
    pub short: &'static str,
    /// All authors, or the body that published it.
    pub authors: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Publisher, journal with volume and pages, or what kind of page it is.
    pub published: &'static str,
    /// The year, empty where the work has none.
    pub year: &'static str,
    /// Its address, empty where none is known.
    pub address: &'static str,
    /// Where these details were read.
    pub read: &'static str,
    /// The day on which they were read.
    pub read_on: &'static str,
}

/// Open claims that the same thing would settle.
#[derive(Clone, Copy, Debug)]
pub struct OpenGroup {
    /// The anchor of its section on the page of open claims.
    pub name: &'static str,
    /// The heading of the section.
    pub title: &'static str,
    /// The ids of its claims; a star stands for any characters.
    pub ids: &'static [&'static str],
}

/// A letter that stands for one thing in a whole book.
#[derive(Clone, Copy, Debug)]
pub struct NotationLetter {
    /// The letter in TeX.
    pub tex: &'static str,
    /// What it stands for.
    pub meaning: &'static str,
    /// From where and in which sense it counts.
    pub counted: &'static str,
}

/// A program that answers pages, compiled for WebAssembly, and what loads it into a page.
#[derive(Clone, Copy, Debug)]
pub struct PageModule {
    /// The attributes of an element that are its own, by their beginnings. The first is a whole name, by which a page asks for it.
    pub attributes: &'static [&'static str],
    /// The name of its files.
    pub name: &'static str,
    /// The package that is compiled.
    pub package: &'static str,
    /// Its folder among the crates.
    pub folder: &'static str,
    /// The controls.
    pub script: &'static str,
    /// How they look.
    pub style: &'static str,
    /// Programs that the controls load when a reader first asks for what they do.
    pub later: &'static [LaterModule],
}

/// A program that controls load later than their own, because few readers need it.
#[derive(Clone, Copy, Debug)]
pub struct LaterModule {
    /// The name of its file, `NAME-module.js`.
    pub name: &'static str,
    /// The package that is compiled.
    pub package: &'static str,
    /// Its folder among the crates.
    pub folder: &'static str,
}

/// The crate that has a book's ledger, as `LEDGER`, a `static` at its root. It is compiled for WebAssembly, so it may depend on the
/// builder only where that is not the target: in `[target.'cfg(not(target_family = "wasm"))'.dependencies]`.
#[derive(Clone, Copy, Debug)]
pub struct LedgerCrate {
    /// Its package.
    pub package: &'static str,
    /// Its folder, from the workspace of the book.
    pub folder: &'static str,
    /// What to type for the check of a claim without a browser, with words for what is to be put in; empty for nothing.
    pub command: &'static str,
    /// What to type for all that is known of a claim, with `ID` for its id.
    pub account_command: &'static str,
}

/// The examples in Rust in a book's chapters.
#[derive(Clone, Copy, Debug)]
pub struct Examples {
    /// The package whose library has all crates that they use.
    pub package: &'static str,
    /// These crates, by the names that a program gives them.
    pub crates: &'static [&'static str],
}

impl PageModule {
    /// The attribute by which a page asks for it.
    pub fn asking(&self) -> &'static str {
        self.attributes.first().copied().unwrap_or(self.name)
    }
}

impl Book {
    /// A book without figures, tables, works and numbers of its own, whose pages nobody can check in a browser. Everything else is
    /// given by its field:
    ///
    /// ```
    /// use geneva_evidence::Ledger;
    /// use geneva_press::Book;
    /// use geneva_press::imprint::Imprint;
    ///
    /// static LEDGER: Ledger = Ledger::new(&[], &[]);
    /// static BOOK: Book = Book {
    ///     synonyms: &[],
    ///     ..Book::new(Imprint::new("Falling bodies, checked", "The authors", "falling", "1.0.0"), &LEDGER, &[])
    /// };
    /// assert_eq!(BOOK.examples.package, "falling");
    /// ```
    pub const fn new(imprint: Imprint, ledger: &'static Ledger, pages: &'static [Page]) -> Self {
        let package = imprint.program;
        Self {
            imprint,
            ledger,
            pages,
            sections: &[],
            keys: &[],
            own_numbers: Default::default,
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
            ledger_crate: None,
            examples: Examples { package, crates: &[] },
            citation_file: "",
            changelog: "",
        }
    }

    /// The page of a role, by its name.
    pub fn page_of_role(&self, role: PageRole) -> Option<&'static str> {
        self.pages.iter().find(|page| page.role == role).map(|page| page.name)
    }

    /// Whether a page is one to look things up in, by its name.
    pub fn is_looked_up(&self, name: &str) -> bool {
        self.pages.iter().any(|page| page.name == name && page.is_looked_up())
    }

    /// The page that lists all claims. [`Book::check`] asks for one.
    fn ledger_page(&self) -> &'static str {
        self.page_of_role(PageRole::Claims).unwrap_or("ledger")
    }

    /// Whether this is the page that lists all claims.
    pub fn is_ledger_page(&self, name: &str) -> bool {
        self.ledger_page() == name
    }

    /// Where a claim stands in the ledger, from any page.
    pub fn address_of_claim(&self, id: &str) -> String {
        format!("{}.html#{id}", self.ledger_page())
    }

    /// The page that tells a slip or leads to where it is told: of a mirrored document the page of slips, of another page the one
    /// with its statements. What only a copy has is listed where the copies are. Without such a page, the page of all claims tells
    /// it.
    pub fn page_of_slip(&self, slip: &Slip) -> &'static str {
        let page = match slip.consequence {
            _ if self.is_elsewhere(slip) => self.page_of_role(PageRole::SlipsElsewhere),
            Consequence::Copy => None,
            _ => self.slips_page().map(|(page, _)| page),
        };
        page.or_else(|| self.page_of_role(PageRole::Coverage)).unwrap_or(self.ledger_page())
    }

    /// The page of slips, and the consequences of those that have boxes on it.
    pub(crate) fn slips_page(&self) -> Option<(&'static str, &'static [Consequence])> {
        self.pages
            .iter()
            .find_map(|page| if let PageRole::Slips(boxed) = page.role { Some((page.name, boxed)) } else { None })
    }

    /// Whether a slip has a box on the page of slips.
    pub fn is_boxed(&self, slip: &Slip) -> bool {
        !self.is_elsewhere(slip) && self.slips_page().is_some_and(|(_, boxed)| boxed.contains(&slip.consequence))
    }

    /// Whether a slip is made in no mirrored document.
    fn is_elsewhere(&self, slip: &Slip) -> bool {
        self.ledger.claim(slip.id).is_some_and(|claim| !claim.document.is_mirrored())
    }

    /// The sections of the page of all claims: the book's own, or one to each source.
    pub fn ledger_sections(&self) -> Vec<LedgerSection> {
        if !self.sections.is_empty() {
            return self.sections.to_vec();
        }
        let whole = |document: &&'static Document| LedgerSection {
            name: document.slug,
            document: document.slug,
            part: crate::pages::SectionPart::Whole,
            title: document.title,
        };
        self.ledger.documents().iter().map(whole).collect()
    }

    /// Holds the book against what the builder needs: a page that lists all claims, pages of different names, sections of
    /// sources that the ledger has, and keys that no other key hides.
    pub fn check(&self, engine: &[PlaceholderKey]) -> anyhow::Result<()> {
        let claims = self.pages.iter().filter(|page| page.role == PageRole::Claims).count();
        ensure!(claims == 1, "{claims} pages list all claims: give one page of the book `PageRole::Claims`");
        for (at, page) in self.pages.iter().enumerate() {
            let is_twice = self.pages[..at].iter().any(|other| other.name == page.name);
            ensure!(!is_twice, "two pages have the name `{}`: name one of them otherwise", page.name);
        }
        for section in self.sections {
            ensure!(
                section.document(self.ledger).is_some(),
                "the section `{}` is of a source `{}`, which the ledger does not have",
                section.name,
                section.document
            );
        }
        for (at, key) in self.keys.iter().enumerate() {
            let is_twice = engine.iter().chain(&self.keys[..at]).any(|other| other.name == key.name);
            ensure!(!is_twice, "two keys have the name `{}`: name the book's otherwise", key.name);
        }
        Ok(())
    }
}
