//! Placeholders in a chapter, and what the ledger and the figures put in their place.
//!
//! A placeholder is `{{key:argument}}` or `{{key}}`. The braces of Rust and of mdBook's own `{{#include}}` are left alone; those
//! of other keys stop the build before (`braces.rs`).

mod reading;

pub use reading::readings;

use crate::citing::TITLE;
use crate::data::File;
use crate::edition::Edition;
use crate::html::{Table, code, escape, plain};
use crate::ledger_pages::{compare, elsewhere, errata, inline, lists, open, records};
use crate::pages::LEDGER;
use crate::{
    address, asked, bibliography, citing, computed, figures, live, maths, measurements, options, proofread, tables,
    units,
};
use anyhow::{Context, bail, ensure};
use std::collections::BTreeSet;
use std::ops::Range;

/// What is put in the place of a placeholder.
#[derive(Clone, Copy)]
enum Put {
    /// What needs no argument.
    Alone(fn() -> anyhow::Result<String>),
    /// What needs one.
    Of(fn(&str) -> anyhow::Result<String>),
    /// What bears the mark of a claim, whose note is put at the end of the page.
    Marked(fn(&str) -> anyhow::Result<String>),
    /// What says which edition of the book this is.
    Dated(fn(&Edition) -> anyhow::Result<String>),
    /// What says something that the argument names about the edition.
    DatedOf(fn(&str, &Edition) -> anyhow::Result<String>),
    /// A figure with its number in the chapter.
    Figure,
    /// A figure with its number in the chapter and with what a reader may move.
    Live,
    /// A table with its number in the chapter.
    Numbered(fn(&str) -> anyhow::Result<Table>),
    /// The number of a figure or a table, as a link.
    Reference,
}
use Put::{Alone, Dated, DatedOf, Marked, Numbered, Of};

/// Every key, what it says or shows, and how that is made.
const KEYS: &[(&str, &str, Put)] = &[
    ("ask", "a number of a mechanism's answer: QUESTION.KEY, and after a colon its digits", Of(asked::number)),
    ("bibtex", "how to cite the book, as BibTeX", Dated(|of| Ok(code(&citing::bibtex(of, address::known()))))),
    ("citation", "what the source is", Of(inline::citation)),
    ("cite", "a work of others, by its key, and after a semicolon where in it", Of(bibliography::cite)),
    ("cite-book", "how to cite the book, in words", Dated(|of| Ok(citing::in_words(of, address::known())))),
    ("cite-claim", "how to cite a claim, in words", DatedOf(|id, of| citing::claim(id, of, address::known()))),
    ("claim", "a claim's printed characters with its mark", Marked(inline::claim)),
    (
        "compare",
        "a table of printed against computed numbers: claims, and a caption after a semicolon",
        Numbered(compare::table),
    ),
    ("computed", "a number of ours, by name", Of(computed::by_name)),
    ("consequences", "how many slips there are, by what they do", Alone(|| Ok(errata::summary()?.html()))),
    ("count", "a number of claims: of a source, or of all documents", Of(inline::count)),
    ("erratum", "one erratum", Of(errata::one)),
    ("elsewhere", "every statement elsewhere that is wrong, in a fold", Alone(elsewhere::statements)),
    ("elsewhere-addresses", "where statements were read, and how many", Alone(|| Ok(elsewhere::addresses()?.html()))),
    ("elsewhere-examples", "examples that do not fit, in a table", Alone(|| Ok(elsewhere::wrong_examples()?.html()))),
    ("elsewhere-wrong", "what is wrong elsewhere, in a table", Alone(|| Ok(elsewhere::wrong()?.html()))),
    ("evidence", "the kinds of evidence and how many claims use each", Alone(|| Ok(lists::evidence()?.html()))),
    (
        "fields",
        "the fields of a file of the records: claims, errata or coverage",
        Of(|of| Ok(records::fields(of)?.html())),
    ),
    ("figure", "a numbered figure", Put::Figure),
    ("grave-errata", "what changes a result or a conclusion, in a table", Alone(|| Ok(errata::grave()?.html()))),
    ("letter", "what a letter stands for in the chapters on a source", Of(lists::letter)),
    ("live", "a numbered figure that a reader moves", Put::Live),
    ("notation", "the letters of the triangle in the whole book", Alone(|| Ok(lists::notation()?.html()))),
    ("open", "the open claims of a group, with what each lacks", Of(open::list)),
    ("open-count", "how many open claims a group has", Of(open::count)),
    ("picture", "a figure without number and caption", Of(figures::picture)),
    ("printed", "a claim's printed characters", Of(inline::printed)),
    ("proofread", "the form for a text of the reader's own, with an example", Alone(proofread::form)),
    ("proofread-weight", "what that form loads at most", Alone(|| Ok(proofread::weight()))),
    ("question", "a question to a mechanism, as it is typed at the command line", Of(asked::question)),
    (
        "recorded",
        "what the record of the benchmarks says of its making: processor, cores, compiler, date",
        Of(|name| Ok(escape(measurements::condition(name)?))),
    ),
    ("records", "what the list of pages puts on this page: claims, slips or lines of sources", Of(records::page)),
    ("ref", "the number of a figure or a table, as a link", Put::Reference),
    ("right", "the right number of a claim whose printed one is not", Of(inline::right)),
    ("slips", "a number of slips: of a consequence, or of all but those of the copy", Of(errata::count)),
    ("symbols", "a source's letters and the book's", Of(|of| Ok(lists::symbols(of)?.html()))),
    ("table", "a chapter's table of computed numbers, by name", Numbered(tables::by_name)),
    ("tolerances", "the table of tolerances", Alone(|| Ok(lists::tolerances()?.html()))),
    ("value", "a claim's computed number", Of(inline::value)),
    ("verdict", "a claim's mark", Marked(inline::mark)),
    ("verdicts", "the classes of verdict and how many claims have each", Alone(|| Ok(lists::verdicts()?.html()))),
    ("works", "all works of others that the chapters cite", Alone(bibliography::list)),
    ("wheels", "a table of wheels, from one number of stations to another", Numbered(tables::wheels)),
];

/// A placeholder in a chapter.
struct Placeholder<'a> {
    range: Range<usize>,
    key: &'static str,
    /// What the key says or shows.
    what: &'static str,
    put: Put,
    argument: Option<&'a str>,
}

/// The page that a chapter becomes.
#[derive(Clone, Copy)]
pub struct Page<'a> {
    /// Its file, without the ending.
    pub name: &'a str,
    /// The chapter's number, with a point behind it, or nothing.
    pub number: &'a str,
    /// The edition of the book.
    pub edition: &'a Edition,
    /// The chapter as its author wrote it, which gives the lines of errors.
    pub written: &'a str,
}

/// A figure or a table in its frame.
struct Framed<'a> {
    /// The attributes of the figure element, its class among them.
    attributes: &'a str,
    /// Its caption, in HTML.
    caption: &'a str,
    /// The drawing or the table, in HTML.
    inner: &'a str,
    /// The function that makes its numbers.
    source: &'a str,
    /// Its numbers.
    csv: String,
}

/// A figure or a table where it stands in the book.
pub struct Shown {
    /// By which a chapter refers to it.
    name: String,
    /// `Figure` or `Table`.
    kind: &'static str,
    /// As it is printed: that of the chapter, and its own.
    number: String,
    /// The page.
    page: String,
    /// Where the placeholder stands in the chapter.
    at: usize,
}

/// The figures and tables of a chapter, in their order.
pub fn shown(chapter: &str, page: Page<'_>) -> Vec<Shown> {
    let (mut figures, mut tables) = (0, 0);
    let all = placeholders(chapter).into_iter().filter_map(|placeholder| {
        let (kind, count) = match placeholder.put {
            Put::Figure | Put::Live => ("Figure", &mut figures),
            Numbered(_) => ("Table", &mut tables),
            _ => return None,
        };
        *count += 1;
        let argument = placeholder.argument.unwrap_or_default();
        let name = match placeholder.key {
            "compare" => format!("{}-printed-{count}", page.name),
            "wheels" => "wheels".to_owned(),
            "live" => geneva_live::by_name(argument).map_or(argument, |live| live.figure).to_owned(),
            _ => argument.to_owned(),
        };
        let number = format!("{}{count}", page.number);
        Some(Shown { name, kind, number, page: page.name.to_owned(), at: placeholder.range.start })
    });
    all.collect()
}

impl Shown {
    /// The anchor on its page.
    fn anchor(&self) -> String {
        format!("{}-{}", if self.kind == "Figure" { "fig" } else { "table" }, self.name)
    }

    /// The name of its data: a figure and a table may bear the same.
    fn file(&self) -> String {
        if self.kind == "Figure" { self.name.clone() } else { format!("table-{}", self.name) }
    }

    /// Caption and drawing or table, and what it was made of as a file, with another one that describes it.
    fn framed(&self, framed: Framed<'_>, page: Page<'_>) -> anyhow::Result<(String, [File; 2])> {
        let Framed { attributes, caption, inner, source, csv } = framed;
        let file = File::of(&self.file(), csv);
        let (kind, number, path) = (self.kind, &self.number, file.path());
        // A caption that moves is compared with what its script writes.
        let caption = if attributes.contains("live") { caption.to_owned() } else { units::tied(caption) };
        let title = format!("{} {}. {}", self.kind, self.number, plain(&caption));
        let book = format!("{TITLE}, {}, page {}", page.edition.words(), page.name);
        let described = file.describing(&title, &book)?;
        let caption = format!(
            "<figcaption><strong>{kind}&nbsp;{number}.</strong> <span class=\"says\">{caption}</span> <small class=\"source\"><a href=\"{path}\" \
             title=\"made by {}\" download>Data (CSV)</a></small></figcaption>",
            escape(source),
        );
        let inner = if kind == "Figure" { format!("{inner}\n{caption}") } else { format!("{caption}\n{inner}") };
        let html = format!("<figure {attributes} id=\"{}\">\n{inner}\n</figure>", self.anchor());
        Ok((html, [file, described]))
    }
}

/// Replaces the placeholders of a chapter, in a book that shows these figures and tables. Returns also the files to
/// which the page leads.
pub fn put_in(chapter: &str, page: Page<'_>, all: &[Shown]) -> anyhow::Result<(String, Vec<File>)> {
    let (mut edits, mut errors, mut files, mut marked) = (Vec::new(), Vec::new(), Vec::new(), BTreeSet::new());
    let found = placeholders(chapter);
    let lines = lines(chapter, &found, page.written);
    for (placeholder, line) in found.iter().zip(lines) {
        if let (Marked(_), Some(id)) = (placeholder.put, placeholder.argument) {
            marked.insert(id);
        }
        match text(placeholder, page, all, &mut files) {
            Ok(text) => edits.push((placeholder.range.clone(), text)),
            Err(error) => errors.push(format!("line {line}: {error:#}")),
        }
    }
    ensure!(errors.is_empty(), "{}", errors.join("\n"));
    let tie = if page.name == LEDGER { units::tied_without_tags } else { units::tied };
    let mut page = inline::glued(&maths::apply(chapter, &edits));
    for id in marked {
        page.push_str(&format!("\n{}\n", inline::note(id)?));
    }
    Ok((options::in_one_piece(&tie(&page)), files))
}

/// The lines of these placeholders in the chapter as its author wrote it, which formulas and folded programs have changed
/// since. They still follow one another.
fn lines(chapter: &str, found: &[Placeholder], written: &str) -> Vec<usize> {
    let before = placeholders(written);
    let (text, found) = if before.len() == found.len() { (written, &*before) } else { (chapter, found) };
    found.iter().map(|placeholder| maths::line(text, placeholder.range.start)).collect()
}

/// Every key of a placeholder.
pub fn keys() -> impl Iterator<Item = &'static str> {
    KEYS.iter().map(|(key, ..)| *key)
}

/// The placeholders of our keys.
fn placeholders(chapter: &str) -> Vec<Placeholder<'_>> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(open) = chapter[from..].find("{{").map(|at| from + at) {
        from = open + 2;
        let Some(inside) = chapter[from..].find("}}").map(|length| &chapter[from..from + length]) else { continue };
        let (name, argument) = match inside.split_once(':') {
            Some((name, argument)) => (name, Some(argument.trim())),
            None => (inside, None),
        };
        if let Some(&(key, what, put)) = KEYS.iter().find(|(key, ..)| *key == name) {
            from += inside.len() + 2;
            found.push(Placeholder { range: open..from, key, what, put, argument });
        }
    }
    found
}

/// What stands for a placeholder on a page; the files to which it leads are added to those of the page.
fn text(placeholder: &Placeholder, page: Page<'_>, all: &[Shown], files: &mut Vec<File>) -> anyhow::Result<String> {
    let here = || {
        let is_it = |shown: &&Shown| shown.page == page.name && shown.at == placeholder.range.start;
        all.iter().find(is_it).with_context(|| format!("`{}` is in no list", placeholder.key))
    };
    let show = |framed: Framed<'_>, files: &mut Vec<File>| {
        let (html, of_it) = here()?.framed(framed, page)?;
        files.extend(of_it);
        Ok(html)
    };
    let Placeholder { key, what, .. } = placeholder;
    match (placeholder.put, placeholder.argument) {
        (Alone(put), None) => put(),
        (Alone(_), Some(argument)) => bail!("`{{{{{key}:{argument}}}}}` takes no argument"),
        (Of(put) | Marked(put), Some(argument)) => put(argument),
        (Dated(put), None) => put(page.edition),
        (Dated(_), Some(argument)) => bail!("`{{{{{key}:{argument}}}}}` takes no argument"),
        (DatedOf(put), Some(argument)) => put(argument, page.edition),
        (Put::Figure, Some(name)) => {
            let figure = figures::by_name(name)?;
            let svg = figure.on_a_page();
            let (caption, csv) = (escape(&figure.caption), figure.series.to_csv());
            show(
                Framed { attributes: "class=\"fig\"", caption: &caption, inner: &svg, source: figure.source, csv },
                files,
            )
        }
        (Put::Live, Some(name)) => {
            let live::Moved { figure, html, attributes } = live::moved(name)?;
            let (caption, csv) = (escape(&figure.caption), figure.series.to_csv());
            let attributes = format!("class=\"fig live\"{attributes}");
            show(Framed { attributes: &attributes, caption: &caption, inner: &html, source: figure.source, csv }, files)
        }
        (Numbered(make), Some(argument)) => {
            let table = make(argument)?;
            let caption = format!("{}.", escape(table.caption()));
            let (html, csv) = (table.html(), table.csv()?);
            let framed =
                Framed { attributes: "class=\"tab\"", caption: &caption, inner: &html, source: table.source(), csv };
            show(framed, files)
        }
        (Put::Reference, Some(name)) => match all.iter().find(|shown| shown.name == name) {
            Some(shown) => {
                let file = if shown.page == page.name { String::new() } else { format!("{}.html", shown.page) };
                Ok(format!("<a href=\"{file}#{}\">{}&nbsp;{}</a>", shown.anchor(), shown.kind, shown.number))
            }
            None => {
                let names: Vec<_> = all.iter().map(|shown| shown.name.as_str()).collect();
                bail!("no figure or table `{name}` in the book; it shows: {}", names.join(", "))
            }
        },
        (_, None) => bail!("`{{{{{key}}}}}` needs an argument, `{{{{{key}:…}}}}`: {what}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: Page<'_> = Page { name: "pin", number: "1.", edition: &Edition::NONE, written: "" };

    fn put(chapter: &str) -> anyhow::Result<String> {
        Ok(put_in(chapter, PAGE, &shown(chapter, PAGE))?.0)
    }

    #[test]
    fn braces_that_are_not_ours_stay() {
        let text = "format!(\"{{}}\") {{#include x}} {{ unclosed";
        assert_eq!(put(text).expect("nothing to draw"), text);
    }

    #[test]
    fn every_key_is_drawn_or_asks_for_its_argument() {
        for (key, _, kind) in KEYS {
            let bare = put(&format!("{{{{{key}}}}}"));
            assert_eq!(bare.is_ok(), matches!(kind, Alone(_) | Dated(_)), "{key}: {bare:?}");
        }
    }

    #[test]
    fn an_unknown_id_is_named_with_its_line_and_a_neighbour() {
        let error = put("one\n\n{{value:pin.radiuss}}").expect_err("no such claim").to_string();
        assert!(
            error.starts_with("line 3:") && error.contains("pin.radiuss") && error.contains("pin.radius`"),
            "{error}"
        );
    }

    #[test]
    fn an_error_has_the_line_that_its_author_wrote() {
        let written = "one\n\n$$\na\n= b\n$$\n\n```rust\n// A program.\nf();\n```\n\n{{value:pin.radiuss}}\n";
        let chapter = crate::fences::fold(&maths::render(written).expect("a formula"));
        let error = put_in(&chapter, Page { written, ..PAGE }, &[]).err().expect("no such claim").to_string();
        assert!(error.starts_with("line 13: "), "{error}");
    }

    #[test]
    fn figures_and_tables_are_numbered_where_they_stand() {
        let chapter =
            "see {{ref:pin-velocity}}\n\n{{figure:pin-position}}\n\n{{wheels:3 4}}\n\n{{figure:pin-velocity}}\n";
        let page = put(chapter).expect("all are drawn");
        assert!(page.contains("<a href=\"#fig-pin-velocity\">Figure\u{a0}1.2</a>"), "{page}");
        assert!(page.contains("Figure\u{a0}1.1") && page.contains("Table\u{a0}1.1"));
        assert!(put("{{ref:pin-position}}").is_err());
        let other = put_in(
            "{{ref:wheels}}",
            Page { name: "other", number: "2.", edition: &Edition::NONE, written: "" },
            &shown(chapter, PAGE),
        );
        assert_eq!(other.expect("known").0, "<a href=\"pin.html#table-wheels\">Table\u{a0}1.1</a>");
    }

    #[test]
    fn a_mark_has_one_note_on_its_page() {
        let page = put("at rest{{verdict:pin.standstill}} twice{{verdict:pin.standstill}}").expect("a claim");
        assert_eq!(page.matches("popovertarget=\"note-pin.standstill\"").count(), 2);
        assert_eq!(page.matches("id=\"note-pin.standstill\"").count(), 1);
    }
}
