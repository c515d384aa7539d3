//! Placeholders in a chapter, and what the ledger and the figures put in their place.
//!
//! A placeholder is `{{key:argument}}` or `{{key}}`. That of a numbered table has its caption behind a semicolon, which may
//! have placeholders in it: `{{table:name; caption}}`. The braces of Rust and of mdBook's own `{{#include}}` are left alone; those
//! of other keys stop the build before (`braces.rs`).

use crate::book::{Book, Expansion, InteractiveFigure, PageFigure, PlaceholderKey};
use crate::cache::Shelf;
use crate::data::PageFile;
use crate::edition::Edition;
use crate::html::{code, escape, plain};
use crate::ledger_pages::{compare, errata, inline, lists, open, own_numbers, records};
use crate::lookup::unknown;
use crate::page_items::{ItemKind, PageItem, numbered_items};
use crate::table::Table;
use crate::{address, citing, maths, nowrap_options, nowrap_units, works};
use Expansion::{Bare, Dated, DatedOf, Interactive, Marked, Numbered, Of, Placed};
use anyhow::{Context, anyhow, bail, ensure};
use std::collections::BTreeSet;
use std::ops::Range;

/// The keys of every book: what each says or shows, and how that is made.
pub const ENGINE_KEYS: &[PlaceholderKey] = &[
    PlaceholderKey::new(
        "bibtex",
        "how to cite the book, as BibTeX",
        Dated(|book, of| Ok(code(&citing::bibtex(&book.imprint, of, address::known(&book.imprint).as_ref())))),
    ),
    PlaceholderKey::new("citation", "what the source is", Of(inline::citation)),
    PlaceholderKey::new("cite", "a work of others, by its key, and after a semicolon where in it", Of(works::cite)),
    PlaceholderKey::new(
        "cite-book",
        "how to cite the book, in words",
        Dated(|book, of| Ok(citing::citation_in_words(&book.imprint, of, address::known(&book.imprint).as_ref()))),
    ),
    PlaceholderKey::new(
        "cite-claim",
        "how to cite a claim, in words",
        DatedOf(|book, id, of| citing::claim_citation(book, id, of, address::known(&book.imprint).as_ref())),
    ),
    PlaceholderKey::new("claim", "a claim's printed characters with its mark", Marked(inline::claim)),
    PlaceholderKey::new(
        COMPARE,
        "a table of printed against computed numbers: claims, and its caption after a semicolon",
        Numbered(compare::table),
    ),
    PlaceholderKey::new(
        "consequences",
        "how many slips there are, by what they do",
        Bare(|book| Ok(errata::consequences_table(book)?.html("Mistakes by what they do"))),
    ),
    PlaceholderKey::new(
        "computed",
        "a number that we compute: a claim's by its id, or one of our own by its name",
        Of(own_numbers::computed),
    ),
    PlaceholderKey::new("count", "a number of claims: of a source, or of all documents", Of(inline::claim_count)),
    PlaceholderKey::new(ERRATUM, "one erratum", Of(errata::erratum_fold)),
    PlaceholderKey::new(
        "evidence",
        "the kinds of evidence and how many claims use each",
        Bare(|book| Ok(lists::evidence(book)?.html("Kinds of evidence"))),
    ),
    PlaceholderKey::new("figure", "a numbered figure", Expansion::Figure),
    PlaceholderKey::new(
        "grave-errata",
        "what changes a result or a conclusion, in a table",
        Bare(|book| Ok(errata::grave_errata(book)?.html("What changes a result or a conclusion"))),
    ),
    PlaceholderKey::new("letter", "what a letter stands for in the chapters on a source", Of(lists::letter)),
    PlaceholderKey::new(
        "notation",
        "the letters of the whole book",
        Bare(|book| Ok(lists::notation(book)?.html(&format!("{} of this book", lists::LETTERS)))),
    ),
    PlaceholderKey::new("open", "the open claims of a group, with what each lacks", Of(open::open_list)),
    PlaceholderKey::new("open-count", "how many open claims a group has", Of(open::open_count)),
    PlaceholderKey::new(
        "own-numbers",
        "the numbers of our own and how many routes they have, in a table",
        Bare(|book| Ok(own_numbers::backing_table(book)?.html("Numbers of our own"))),
    ),
    PlaceholderKey::new("picture", "a figure without number and caption", Of(picture)).without_text(),
    PlaceholderKey::new("printed", "a claim's printed characters", Of(inline::printed)),
    PlaceholderKey::new(
        "records",
        "what the list of pages puts on this page: claims, slips or lines of sources",
        Placed(records::page),
    )
    .without_text(),
    PlaceholderKey::new("ref", "the number of a figure or a table, as a link", Expansion::Reference),
    PlaceholderKey::new("right", "the right number of a claim whose printed one is not", Of(inline::right)),
    PlaceholderKey::new(
        "slips",
        "a number of slips: of a consequence, or of all but those of the copy",
        Of(errata::slip_count),
    ),
    PlaceholderKey::new(
        "spoil",
        "a link to the check of a claim with other characters: its id, some of its characters, others for them, and the words of \
         the link, with semicolons between",
        Of(inline::spoiling),
    ),
    PlaceholderKey::new(
        "symbols",
        "a source's letters and the book's",
        Of(|book, of| Ok(lists::symbols(book, of)?.html(lists::LETTERS))),
    ),
    PlaceholderKey::new(
        TABLE,
        "a chapter's table of computed numbers: its name, and its caption after a semicolon",
        Numbered(table_of_name),
    ),
    PlaceholderKey::new(
        "tolerances",
        "the table of tolerances",
        Bare(|book| Ok(lists::tolerances(book)?.html("Tolerances"))),
    ),
    PlaceholderKey::new("verdict", "a claim's mark", Marked(inline::mark)),
    PlaceholderKey::new(
        "verdict-classes",
        "the classes of verdict in the data, and which verdict on the pages each is",
        Bare(|book| Ok(lists::classes_of_verdict(book)?.html("Classes of verdict in the data"))),
    ),
    PlaceholderKey::new(
        "verdicts",
        "the verdicts in plain words and how many claims have each",
        Bare(|book| Ok(lists::verdicts(book)?.html("Verdicts"))),
    ),
    PlaceholderKey::new(
        "verify",
        "a button by which a reader has everything checked in the page",
        Bare(|_| Ok("<div data-verify-all></div>".to_owned())),
    )
    .without_text(),
    PlaceholderKey::new("works", "all works of others that the chapters cite", Bare(works::works_list)),
];

/// Characters of a caption that is hardly higher than its drawing if it stands beside it in a narrow margin.
const LONGEST_BESIDE: usize = 420;

/// The key of a table by its name.
const TABLE: &str = "table";
/// The key of a table of claims, which is named by its page.
const COMPARE: &str = "compare";
/// The key of one erratum in its chapter.
const ERRATUM: &str = "erratum";

/// The table of this name.
fn table_of_name(book: &Book, name: &str) -> anyhow::Result<Table> {
    crate::lookup::find_named(TABLE, name, book.tables)?()
}

/// A drawing alone, without number and caption: a picture of a page that has no number.
fn picture(book: &Book, name: &str) -> anyhow::Result<String> {
    Ok(format!("<div class=\"fig picture\">\n{}\n</div>", with_pause((book.figures)(name)?.drawing)))
}

/// A drawing, and below it a box by which a reader stops it if it moves by itself.
///
/// The style sheet shows the box where the drawing moves, and stops what a figure with a ticked box contains: WCAG 2.2, success criterion 2.2.2.
fn with_pause(drawing: String) -> String {
    if !drawing.contains("@keyframes ") {
        return drawing;
    }
    drawing + "\n<label class=\"pause\"><input type=\"checkbox\" autocomplete=\"off\"> Pause</label>"
}

/// Every key that a chapter of this book may have: those of every book and its own.
pub fn keys(book: &Book) -> impl Iterator<Item = &'static PlaceholderKey> + Clone {
    ENGINE_KEYS.iter().chain(book.keys)
}

/// A placeholder in a chapter.
pub struct Placeholder<'a> {
    /// Where it stands in the chapter, in bytes.
    pub range: Range<usize>,
    /// Its key.
    pub key: &'static PlaceholderKey,
    /// What is behind the colon; of a numbered table, what is before the semicolon.
    pub argument: Option<&'a str>,
    /// What is behind the semicolon of a numbered table.
    pub caption: Option<&'a str>,
}

/// The page that a chapter becomes.
#[derive(Clone, Copy)]
pub struct ChapterContext<'a> {
    /// The book.
    pub book: &'a Book,
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
struct FigureFrame<'a> {
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

/// The figures, tables and errata of a chapter, in their order.
pub fn page_items(chapter: &str, page: ChapterContext<'_>) -> Vec<PageItem> {
    let (mut figures, mut tables) = (0, 0);
    let all = placeholders(page.book, chapter).into_iter().filter_map(|placeholder| {
        let argument = placeholder.argument.unwrap_or_default();
        let at = placeholder.range.start;
        let (kind, count) = match placeholder.key.expansion {
            Expansion::Figure | Interactive(..) => (ItemKind::Figure, &mut figures),
            Numbered(_) => (ItemKind::Table, &mut tables),
            _ if placeholder.key.name == ERRATUM => {
                let (name, page) = (argument.to_owned(), page.name.to_owned());
                return Some(PageItem { name, kind: ItemKind::Erratum, number: String::new(), page, at });
            }
            _ => return None,
        };
        *count += 1;
        let name = match (placeholder.key.expansion, placeholder.key.name) {
            (Interactive(name, _), _) => name(argument).unwrap_or(argument).to_owned(),
            (Numbered(_), COMPARE) => format!("{}-printed-{count}", page.name),
            (Expansion::Figure, _) | (_, TABLE) => argument.to_owned(),
            // A book shows a table of a key of its own once.
            (_, key) => key.to_owned(),
        };
        let number = format!("{}{count}", page.number);
        Some(PageItem { name, kind, number, page: page.name.to_owned(), at })
    });
    all.collect()
}

/// Caption and drawing or table, and what it was made of as a file, with another one that describes it.
fn framed(
    item: &PageItem,
    frame: FigureFrame<'_>,
    page: ChapterContext<'_>,
) -> anyhow::Result<(String, [PageFile; 2])> {
    let FigureFrame { attributes, caption, inner, source, csv } = frame;
    let imprint = &page.book.imprint;
    let file = PageFile::csv(&item.file(), csv);
    let (kind, number, path) = (item.kind.title(), &item.number, file.path());
    // A caption that moves is compared with what its script writes.
    let caption = if attributes.contains("live") { caption.to_owned() } else { nowrap_units::tied(caption) };
    let title = format!("{kind} {number}. {}", plain(&caption));
    let book = format!("{}, {}, page {}", imprint.title, page.edition.words(), page.name);
    let described = file.metadata(&title, &book, imprint.licence_address)?;
    let caption = format!(
        "<figcaption><strong>{kind}&nbsp;{number}.</strong> <span class=\"says\">{caption}</span> <small class=\"source\"><a href=\"{path}\" \
         title=\"made by {}\" download>Data (CSV)</a></small></figcaption>",
        escape(source),
    );
    let inner =
        if item.kind == ItemKind::Figure { format!("{inner}\n{caption}") } else { format!("{caption}\n{inner}") };
    // The caption of a figure that moves says what it shows now, and is no name.
    let moves = page.book.modules.iter().any(|module| attributes.contains(&format!("{}=\"", module.asking())));
    let name = if moves { format!(" aria-label=\"Live {kind} {number}\"") } else { String::new() };
    let html = format!("<figure {attributes} id=\"{}\"{name}>\n{inner}\n</figure>", item.anchor());
    Ok((html, [file, described]))
}

/// Replaces the placeholders of a chapter, in a book that shows these figures and tables. Returns also the files to
/// which the page leads.
pub fn expand(chapter: &str, page: ChapterContext<'_>, all: &[PageItem]) -> anyhow::Result<(String, Vec<PageFile>)> {
    expand_with(&Shelf::empty(), chapter, page, all)
}

/// Does what [`expand`] does, and takes from a shelf what an earlier build has made.
pub(crate) fn expand_with(
    shelf: &Shelf,
    chapter: &str,
    page: ChapterContext<'_>,
    all: &[PageItem],
) -> anyhow::Result<(String, Vec<PageFile>)> {
    let (mut edits, mut errors, mut files, mut marked) = (Vec::new(), Vec::new(), Vec::new(), BTreeSet::new());
    let found = placeholders(page.book, chapter);
    let lines = lines(chapter, &found, page);
    for (placeholder, line) in found.iter().zip(lines) {
        if let (Marked(_), Some(id)) = (placeholder.key.expansion, placeholder.argument) {
            marked.insert(id);
        }
        match expansion(shelf, placeholder, page, all, &mut files) {
            Ok(text) => edits.push((placeholder.range.clone(), text)),
            Err(error) => errors.push(format!("line {line}: {error:#}")),
        }
    }
    ensure!(errors.is_empty(), "{}", errors.join("\n"));
    let is_ledger = page.book.is_ledger_page(page.name);
    let tie = if is_ledger { nowrap_units::tied_without_tags } else { nowrap_units::tied };
    let mut text = inline::glued(&maths::apply(chapter, &edits));
    for id in marked {
        let note = shelf.text("note", &[id], || inline::note(page.book, id))?;
        text.push_str(&format!("\n{note}\n"));
    }
    Ok((nowrap_options::in_one_piece(&tie(&text)), files))
}

/// The lines of these placeholders in the chapter as its author wrote it, which formulas and folded programs have changed
/// since. They still follow one another.
fn lines(chapter: &str, found: &[Placeholder], page: ChapterContext<'_>) -> Vec<usize> {
    let before = placeholders(page.book, page.written);
    let (text, found) = if before.len() == found.len() { (page.written, &*before) } else { (chapter, found) };
    found.iter().map(|placeholder| maths::line(text, placeholder.range.start)).collect()
}

/// The placeholders of a chapter whose keys the book has.
pub fn placeholders<'a>(book: &Book, chapter: &'a str) -> Vec<Placeholder<'a>> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(open) = chapter[from..].find("{{").map(|at| from + at) {
        from = open + 2;
        let Some(inside) = end(&chapter[from..]).map(|length| &chapter[from..from + length]) else { continue };
        let (name, argument) = match inside.split_once(':') {
            Some((name, argument)) => (name, Some(argument.trim())),
            None => (inside, None),
        };
        if let Some(key) = keys(book).find(|key| key.name == name) {
            from += inside.len() + 2;
            let (argument, caption) = match (key.expansion, argument.and_then(|of| of.split_once(';'))) {
                (Numbered(_), Some((argument, caption))) => (Some(argument.trim()), Some(caption.trim())),
                _ => (argument, None),
            };
            found.push(Placeholder { range: open..from, key, argument, caption });
        }
    }
    found
}

/// A figure as texts: what its class goes on with, and the figure.
fn figure_parts(class: String, figure: PageFigure) -> Vec<String> {
    vec![class, with_pause(figure.drawing), figure.caption, figure.csv, figure.source.to_owned()]
}

/// The texts that a shelf has for something that has so many.
fn take_parts<const COUNT: usize>(parts: Vec<String>) -> anyhow::Result<[String; COUNT]> {
    parts.try_into().map_err(|_| anyhow!("a cache that has other texts: remove the folder `book-cache` in `target`"))
}

/// Whether a chapter says which edition of the book this is.
pub(crate) fn is_dated(book: &Book, chapter: &str) -> bool {
    let names = |key: &&PlaceholderKey| matches!(key.expansion, Dated(_) | DatedOf(_));
    keys(book).filter(names).any(|key| chapter.contains(&format!("{{{{{}", key.name)))
}

/// Where double braces end of which this is the inside and what follows: others may be inside.
fn end(inside: &str) -> Option<usize> {
    let (mut from, mut open) = (0, 1);
    loop {
        let ends = inside[from..].find("}}").map(|at| from + at)?;
        match inside[from..ends].find("{{") {
            Some(at) => (open, from) = (open + 1, from + at + 2),
            None if open == 1 => return Some(ends),
            None => (open, from) = (open - 1, ends + 2),
        }
    }
}

/// The caption of a numbered table, in HTML, with a point at its end.
pub(crate) fn caption(
    shelf: &Shelf,
    placeholder: &Placeholder,
    page: ChapterContext<'_>,
    all: &[PageItem],
    files: &mut Vec<PageFile>,
) -> anyhow::Result<String> {
    let text = placeholder.caption.filter(|text| !text.is_empty()).with_context(|| {
        let (key, of) = (placeholder.key.name, placeholder.argument.unwrap_or_default());
        format!("`{{{{{key}:{of}}}}}` needs a caption: `{{{{{key}:{of}; what the table shows}}}}`")
    })?;
    let (mut html, mut from) = (String::new(), 0);
    let words = |text: &str| escape(&text.replace('\n', " "));
    for inner in placeholders(page.book, text) {
        html += &words(&text[from..inner.range.start]);
        html += &expansion(shelf, &inner, page, all, files)?;
        from = inner.range.end;
    }
    Ok(html + &words(&text[from..]) + ".")
}

/// What stands for a placeholder on a page; the files to which it leads are added to those of the page. What follows from the
/// key and the argument alone may come from a shelf.
pub(crate) fn expansion(
    shelf: &Shelf,
    placeholder: &Placeholder,
    page: ChapterContext<'_>,
    all: &[PageItem],
    files: &mut Vec<PageFile>,
) -> anyhow::Result<String> {
    let PlaceholderKey { name: key, meaning, expansion, .. } = *placeholder.key;
    let here = || {
        let is_it = |item: &&PageItem| item.page == page.name && item.at == placeholder.range.start;
        all.iter().find(is_it).with_context(|| format!("`{key}` is in no list"))
    };
    let show = |frame: FigureFrame<'_>, files: &mut Vec<PageFile>| {
        let (html, of_it) = framed(here()?, frame, page)?;
        files.extend(of_it);
        Ok(html)
    };
    let show_figure = |parts: Vec<String>, files: &mut Vec<PageFile>| {
        let [class, drawing, caption, csv, source] = take_parts(parts)?;
        let (attributes, caption) = (&*format!("class=\"fig{class}"), &*escape(&caption));
        show(FigureFrame { attributes, caption, inner: &drawing, source: &source, csv }, files)
    };
    let book = page.book;
    match (expansion, placeholder.argument) {
        (Bare(make), None) => shelf.text(key, &[], || make(book)),
        (Of(make) | Marked(make), Some(argument)) => shelf.text(key, &[argument], || make(book, argument)),
        (Dated(make), None) => make(book, page.edition),
        (Bare(_) | Dated(_), Some(argument)) => bail!("`{{{{{key}:{argument}}}}}` takes no argument"),
        (DatedOf(make), Some(argument)) => make(book, argument, page.edition),
        (Expansion::Figure, Some(name)) => {
            let parts = shelf.recall(key, &[name], || {
                let figure = (book.figures)(name)?;
                let is_long = figure.caption.chars().count() > LONGEST_BESIDE;
                Ok(figure_parts(if is_long { " long\"" } else { "\"" }.to_owned(), figure))
            })?;
            show_figure(parts, files)
        }
        (Interactive(_, make), Some(name)) => {
            let parts = shelf.recall(key, &[name], || {
                let InteractiveFigure { figure, attributes } = make(book, name)?;
                Ok(figure_parts(format!(" live\"{attributes}"), figure))
            })?;
            show_figure(parts, files)
        }
        (Numbered(make), Some(argument)) => {
            // A table that is not there is named before a caption that it lacks.
            let caption = match caption(shelf, placeholder, page, all, files) {
                Ok(caption) => caption,
                Err(error) => return make(book, argument).and(Err(error)),
            };
            let title = plain(&caption);
            let parts = shelf.recall(key, &[argument, &title], || {
                let table = make(book, argument)?;
                Ok(vec![table.html(&title), table.csv()?, table.source().to_owned()])
            })?;
            let [inner, csv, source] = take_parts(parts)?;
            let frame =
                FigureFrame { attributes: "class=\"tab\"", caption: &caption, inner: &inner, source: &source, csv };
            show(frame, files)
        }
        (Placed(make), Some(argument)) => make(book, argument, all),
        (Expansion::Reference, Some(name)) => match numbered_items(all).find(|item| item.name == name) {
            Some(item) => {
                let file = if item.page == page.name { String::new() } else { format!("{}.html", item.page) };
                Ok(format!("<a href=\"{file}#{}\">{}&nbsp;{}</a>", item.anchor(), item.kind.title(), item.number))
            }
            None => {
                let names: Vec<_> = numbered_items(all).map(|item| item.name.as_str()).collect();
                let unknown = unknown("figure or table", name, names.iter().copied());
                bail!("{unknown}; the book shows: {}", names.join(", "))
            }
        },
        (_, None) => bail!("`{{{{{key}}}}}` needs an argument, `{{{{{key}:…}}}}`: {meaning}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    static EDITION: Edition = Edition::without_commit(BOOK.imprint.version);
    const PAGE: ChapterContext<'_> =
        ChapterContext { book: &BOOK, name: "pin", number: "1.", edition: &EDITION, written: "" };

    fn expanded(chapter: &str) -> anyhow::Result<String> {
        Ok(expand(chapter, PAGE, &page_items(chapter, PAGE))?.0)
    }

    #[test]
    fn a_drawing_that_moves_by_itself_has_a_box_that_stops_it() {
        let still = "<svg><path d=\"M0 0\"/></svg>".to_owned();
        assert_eq!(with_pause(still.clone()), still);
        let moving = "<svg><style>@keyframes a{}</style></svg>".to_owned();
        let boxed = with_pause(moving.clone());
        assert!(boxed.starts_with(&moving) && boxed.matches("type=\"checkbox\"").count() == 1, "{boxed}");
    }

    #[test]
    fn braces_of_others_stay() {
        let text = "format!(\"{{}}\") {{#include x}} {{ unclosed";
        assert_eq!(expanded(text).expect("nothing to draw"), text);
    }

    #[test]
    fn every_key_is_drawn_or_asks_for_its_argument() {
        for key in keys(&BOOK) {
            let bare = expanded(&format!("{{{{{}}}}}", key.name));
            assert_eq!(bare.is_ok(), matches!(key.expansion, Bare(_) | Dated(_)), "{}: {bare:?}", key.name);
        }
    }

    #[test]
    fn figures_and_tables_are_numbered_where_they_stand_and_an_unknown_one_is_answered_with_the_nearest() {
        let page = expanded("{{ref:rows}}\n\n{{figure:circle}}\n\n{{table:rows; Rows}}\n").expect("all are drawn");
        assert!(
            page.contains("<a href=\"#table-rows\">Table\u{a0}1.1</a>") && page.contains("Figure\u{a0}1.1"),
            "{page}"
        );
        for (placeholder, nearest) in [
            ("{{figure:circel}}", "circle"),
            ("{{table:row; Rows}}", "rows"),
            ("{{ref:row}} {{table:rows; Rows}}", "rows"),
        ] {
            let error = expanded(&format!("one\n\n{placeholder}")).expect_err(placeholder).to_string();
            assert!(error.starts_with("line 3: ") && error.contains(&format!("the nearest is `{nearest}`")), "{error}");
        }
    }

    #[test]
    fn a_caption_may_have_numbers_and_lines_and_is_the_name_of_its_table() {
        let page =
            expanded("{{table:rows; Rows of <b> & {{count:all}}\nclaims; see {{ref:circle}}}} {{figure:circle}}");
        let page = page.expect("all are drawn");
        let count = BOOK.ledger.claims().len();
        assert!(
            page.contains(&format!("Rows of &lt;b&gt; &amp; {count} claims; see <a href=\"#fig-circle\">")),
            "{page}"
        );
        assert!(page.contains(&format!("aria-label=\"Rows of &lt;b&gt; &amp; {count} claims; see Figure")), "{page}");
        assert!(page.contains("</span> <small class=\"source\">") && !page.contains("}}"), "{page}");
    }

    #[test]
    fn a_table_without_a_caption_is_refused_and_so_is_one_in_a_caption() {
        for (chapter, why) in [
            ("{{table:rows}}", "needs a caption: `{{table:rows; what the table shows}}`"),
            ("{{table:rows;}}", "needs a caption"),
            ("{{table:rows; a {{table:rows; b}}}}", "is in no list"),
            ("{{table:rows; a {{figure:circle}}}}", "is in no list"),
        ] {
            let error = expanded(&format!("one\n\n{chapter}\n")).expect_err(chapter).to_string();
            assert!(error.starts_with("line 3: ") && error.contains(why), "{chapter}: {error}");
        }
    }
}
