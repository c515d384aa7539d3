//! The whole book as one document to be printed, `print.html`: title page, contents, all chapters in their order.
//!
//! It is made from the finished pages. Everything in it stands on the paper as a reader needs it:
//!
//! - What a chapter folds is open: solutions, derivations, tables. Of an example in Rust only its first line is printed, which
//!   says what it shows; of a mistake only the line that names it if the page of errata prints all on it.
//! - The notes on single claims, the controls of figures that move and the links to data are left out, and so are the pages
//!   that only list records: the ledger and the coverage of the sources.
//! - Links lead to places in the document. A link to a page that is left out leads to the book's address if that is known.
//!   Otherwise its words are printed without a link.

pub mod numbers;

use crate::address::Address;
use crate::book::Book;
use crate::cache::Shelf;
use crate::citing;
use crate::edition::Edition;
use crate::html::escape;
use crate::ledger_pages::errata;
use crate::modules;
use crate::pages::{Numbering, PagePlace};
use anyhow::Context;
use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{
    BufferQueue, EndTag, StartTag, Tag, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
};
use std::cell::RefCell;
use std::fs;
use std::path::Path;

/// The document's file in the book.
pub const FILE: &str = "print.html";
/// The style sheet that it alone loads.
const STYLE: (&str, &str) = ("theme/print.css", include_str!("../theme/print.css"));
/// What has no place on paper, by the class of the element.
const LEFT_OUT: [&str; 4] = ["beside", "edition", "source", "controls"];

/// A page of the book as it is in the document.
struct Chapter {
    name: &'static str,
    /// With a point behind it, or empty.
    number: String,
    title: &'static str,
    /// The part of the book that begins with this chapter.
    part: Option<&'static str>,
    html: String,
    /// The headings of its sections: id and text.
    sections: Vec<(String, String)>,
}

/// Writes the document of a book into the folder in which it is built. Where none of its pages is there, there is none.
pub(crate) fn write(
    book: &Book,
    folder: &Path,
    edition: &Edition,
    address: Option<&Address>,
    shelf: &Shelf,
) -> anyhow::Result<()> {
    let mut styles = String::new();
    let mut chapters = Vec::new();
    let (mut numbering, mut part) = (Numbering::default(), "");
    for page in book.pages.iter().filter(|page| page.is_printed) {
        let path = folder.join(format!("{}.html", page.name));
        if !path.is_file() {
            continue;
        }
        let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let (head, main) = text.split_once("<main>").with_context(|| format!("{} has no text", path.display()))?;
        let (main, _) = main.split_once("</main>").with_context(|| format!("{} has no end", path.display()))?;
        if styles.is_empty() {
            let is_style = |line: &&str| line.contains("rel=\"stylesheet\"") && !line.contains("highlight");
            styles = head.lines().map(str::trim).filter(is_style).collect::<Vec<_>>().join("\n");
        }
        let number = numbering.next(page.place);
        let of = match page.place {
            PagePlace::In(of) => of,
            PagePlace::Behind => "Appendices",
            PagePlace::Before | PagePlace::Below => part,
        };
        let begins = (std::mem::replace(&mut part, of) != of).then_some(of);
        let at = address.map_or("", |address| &address.book);
        // The foot of the page is left out.
        let main = &citing::without_foot(main);
        let mut texts = shelf
            .recall("printed", &[main, page.name, &number, at], || {
                let (html, sections) = reset(book, main, page.name, &number, address);
                Ok([html].into_iter().chain(sections.into_iter().flat_map(|(id, title)| [id, title])).collect())
            })?
            .into_iter();
        let html = texts.next().unwrap_or_default();
        let sections = std::iter::from_fn(|| Some((texts.next()?, texts.next()?))).collect();
        chapters.push(Chapter { name: page.name, number, title: page.title, part: begins, html, sections });
    }
    if chapters.is_empty() {
        return Ok(());
    }
    // What is live is set by a sheet of its own, which is there where it is.
    for style in modules::styles(book).filter(|style| folder.join(style).is_file()) {
        styles.push_str(&format!("\n<link rel=\"stylesheet\" href=\"{style}\">"));
    }
    for (name, text) in [STYLE, (FILE, &*document(book, &styles, &chapters, edition, address))] {
        let path = folder.join(name);
        // Only a book with sheets of its own has a folder for them.
        fs::create_dir_all(path.parent().unwrap_or(folder))
            .with_context(|| format!("cannot make the folder of {}", path.display()))?;
        fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

/// The whole document.
fn document(book: &Book, styles: &str, chapters: &[Chapter], edition: &Edition, address: Option<&Address>) -> String {
    let imprint = &book.imprint;
    let mut contents = String::new();
    for chapter in chapters {
        if let Some(part) = chapter.part {
            contents.push_str(&format!("<li class=\"of-part\">{}</li>\n", escape(part)));
        }
        contents.push_str(&line(chapter.name, "of-chapter", &format!("{} {}", chapter.number, chapter.title)));
        for (id, title) in &chapter.sections {
            contents.push_str(&line(id, "of-section", title));
        }
    }
    let read = address.map_or_else(String::new, |at| format!("\n<p><a href=\"{0}\">{0}</a></p>", escape(&at.book)));
    let chapters: String = chapters
        .iter()
        .map(|chapter| format!("<section class=\"printed\" id=\"{}\">\n{}\n</section>\n", chapter.name, chapter.html))
        .collect();
    format!(
        "<!DOCTYPE HTML>\n<html lang=\"en\" class=\"light\">\n<head>\n<meta charset=\"UTF-8\">\n<title>{title} (to be printed)</title>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n{styles}\n<link rel=\"stylesheet\" href=\"{style}\">\n\
         </head>\n<body>\n<div class=\"content\">\n<header class=\"title-page\">\n<p class=\"title\">{title}</p>\n<p \
         class=\"subtitle\">{subtitle}</p>\n<p>{authors}</p>\n<p>{edition}</p>{read}\n<p class=\"notice\">This is the whole book for \
         paper. The marks ✓ ≈ ✗ ? say that we checked what is before them: right, right as finely as we could read it off, wrong, \
         open. The ledger of all claims, the coverage of the sources and the data are not printed, and of an example in Rust you \
         see only the line that says what it shows. Text and figures: {licence}.</p>\n</header>\n<nav class=\"contents\" \
         aria-label=\"Contents\">\n<h1 id=\"contents\">Contents</h1>\n<ol>\n{contents}</ol>\n</nav>\n<main>\n{chapters}</main>\n<footer \
         class=\"edition\">{title}, {edition}.</footer>\n</div>\n</body>\n</html>\n",
        title = escape(imprint.title),
        subtitle = escape(imprint.subtitle),
        authors = escape(imprint.authors),
        edition = escape(&edition.words()),
        licence = escape(imprint.licence_words),
        style = STYLE.0,
    )
}

/// A line of the contents. What prints the document puts the number of the page at its end.
fn line(id: &str, class: &str, title: &str) -> String {
    let title = escape(title.trim());
    format!(
        "<li class=\"{class}\"><a href=\"#{id}\">{title}</a> <span class=\"at\" data-page-of=\"{id}\"></span></li>\n"
    )
}

/// The text of a page set anew for the document, and the headings of its sections.
fn reset(
    book: &Book,
    main: &str,
    page: &str,
    number: &str,
    address: Option<&Address>,
) -> (String, Vec<(String, String)>) {
    let state = State::new(book, page, number, address);
    let tokenizer = Tokenizer::new(Anew(RefCell::new(state)), TokenizerOpts::default());
    let queue = BufferQueue::default();
    queue.push_back(main.into());
    // What it passes over holds no script that would have to run while it is read.
    let _ = tokenizer.feed(&queue);
    tokenizer.end();
    let state = tokenizer.sink.0.into_inner();
    (state.out, state.sections)
}

struct Anew<'a>(RefCell<State<'a>>);

struct State<'a> {
    book: &'a Book,
    page: String,
    number: String,
    address: Option<Address>,
    out: String,
    sections: Vec<(String, String)>,
    /// The element that is left out, and how many of its name are open.
    passed: Option<(String, usize)>,
    /// Of the folds that are open: whether only their first line is printed.
    folds: Vec<bool>,
    is_in_section: bool,
    is_raw: bool,
}

impl TokenSink for Anew<'_> {
    type Handle = ();

    fn process_token(&self, token: Token, _: u64) -> TokenSinkResult<()> {
        let mut state = self.0.borrow_mut();
        match token {
            Token::TagToken(tag) if tag.kind == StartTag => {
                state.open(&tag);
                if &*tag.name == "style" {
                    state.is_raw = true;
                    return TokenSinkResult::RawData(RawKind::Rawtext);
                }
            }
            Token::TagToken(tag) if tag.kind == EndTag => state.close(&tag.name),
            Token::CharacterTokens(text) if state.passed.is_none() => state.text(&text),
            _ => {}
        }
        TokenSinkResult::Continue
    }
}

impl<'a> State<'a> {
    fn new(book: &'a Book, page: &str, number: &str, address: Option<&Address>) -> Self {
        Self {
            book,
            page: page.to_owned(),
            number: number.to_owned(),
            address: address.cloned(),
            out: String::new(),
            sections: Vec::new(),
            passed: None,
            folds: Vec::new(),
            is_in_section: false,
            is_raw: false,
        }
    }

    fn open(&mut self, tag: &Tag) {
        let name: &str = &tag.name;
        if let Some((passed, depth)) = &mut self.passed {
            *depth += usize::from(passed == name && !is_single(name) && !tag.self_closing);
            return;
        }
        let attribute = |name: &str| tag.attrs.iter().find(|of| &*of.name.local == name).map(|of| of.value.to_string());
        let class = attribute("class").unwrap_or_default();
        let has = |wanted: &str| class.split(' ').any(|of| of == wanted);
        let is_left_out = ["script", "link", "input", "label", "select"].contains(&name)
            || attribute("popover").is_some()
            || attribute("hidden").is_some()
            || LEFT_OUT.iter().any(|class| has(class))
            || name == "button" && !has("mark");
        if is_left_out {
            if !is_single(name) && !tag.self_closing {
                self.passed = Some((name.to_owned(), 1));
            }
            return;
        }
        if name == "details" {
            self.folds.push(has("proof") || has(errata::FOLD) && !has(errata::TOLD_HERE));
        }
        let name = if name == "button" { "span" } else { name };
        self.out.push_str(&format!("<{name}"));
        for of in &tag.attrs {
            let (key, value): (&str, &str) = (&of.name.local, &of.value);
            let value = match key {
                "tabindex" | "type" | "popovertarget" | "download" | "aria-label" | "aria-live"
                    if name != "div" || key == "tabindex" =>
                {
                    continue;
                }
                "open" => continue,
                _ if modules::is_own_attribute(self.book, key) => continue,
                "id" | "for" => format!("{}--{value}", self.page),
                "aria-labelledby" | "aria-describedby" | "aria-controls" => {
                    value.split(' ').map(|id| format!("{}--{id}", self.page)).collect::<Vec<_>>().join(" ")
                }
                "href" if name == "a" && has("header") => continue,
                "href" if name == "a" => match self.link(value) {
                    Some(link) => link,
                    None => continue,
                },
                _ => value.to_owned(),
            };
            let value = value.replace('&', "&amp;").replace('"', "&quot;");
            self.out.push_str(&format!(" {key}=\"{value}\""));
        }
        if name == "details" {
            self.out.push_str(" open");
        }
        self.out.push_str(if tag.self_closing { " />" } else { ">" });
        if name == "h1" && !self.number.is_empty() {
            self.out.push_str(&format!("{} ", self.number));
        }
        if let ("h2", Some(id)) = (name, attribute("id")) {
            self.is_in_section = true;
            self.sections.push((format!("{}--{id}", self.page), String::new()));
        }
    }

    fn close(&mut self, name: &str) {
        self.is_raw = false;
        if let Some((passed, depth)) = &mut self.passed {
            *depth -= usize::from(passed == name);
            if *depth == 0 {
                self.passed = None;
            }
            // The rest of a fold ends with the fold, which is still to be closed.
            if self.passed.is_some() || name != "details" || self.folds.last() != Some(&true) {
                return;
            }
        }
        match name {
            "h2" => self.is_in_section = false,
            "details" => drop(self.folds.pop()),
            _ => {}
        }
        let tag = if name == "button" { "span" } else { name };
        self.out.push_str(&format!("</{tag}>"));
        // Behind its first line, a fold of which only that is printed is passed over.
        if name == "summary" && self.folds.last() == Some(&true) {
            self.passed = Some(("details".to_owned(), 1));
        }
    }

    fn text(&mut self, text: &str) {
        if self.is_in_section
            && let Some((_, title)) = self.sections.last_mut()
        {
            title.push_str(text);
        }
        if self.is_raw {
            self.out.push_str(text);
        } else {
            self.out.push_str(&text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;"));
        }
    }

    /// Where a link leads from the document, if anywhere.
    fn link(&self, link: &str) -> Option<String> {
        if link.starts_with("http") {
            return Some(link.to_owned());
        }
        let (file, fragment) = link.split_once('#').unwrap_or((link, ""));
        let name = match file.trim_end_matches(".html") {
            "" => &self.page,
            "index" => self.book.pages.first().map_or("index", |page| page.name),
            name => name,
        };
        let is_here = self.book.pages.iter().any(|page| page.name == name && page.is_printed);
        match (is_here, fragment) {
            (true, "") => Some(format!("#{name}")),
            (true, _) => Some(format!("#{name}--{fragment}")),
            _ => self.address.as_ref().map(|address| address.page(link)),
        }
    }
}

/// Whether an element has no end.
fn is_single(name: &str) -> bool {
    ["link", "input", "img", "br", "hr", "meta"].contains(&name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    fn set(main: &str, address: Option<&Address>) -> String {
        reset(&BOOK, main, "pin", "1.", address).0
    }

    #[test]
    fn links_lead_to_places_in_the_document_or_to_the_books_address() {
        let page = "<h1 id=\"t\"><a class=\"header\" href=\"#t\">T</a></h1><a href=\"#x\">1</a><a href=\"jazar.html#y\">2</a><a \
                    href=\"index.html\">3</a><a href=\"ledger.html#pin.x\">4</a><a href=\"https://example.org/?a&amp;b\">5</a>";
        let expected = "<h1 id=\"pin--t\">1. <a class=\"header\">T</a></h1><a href=\"#pin--x\">1</a><a href=\"#jazar--y\">2</a><a \
                        href=\"#preface\">3</a><a>4</a><a href=\"https://example.org/?a&amp;b\">5</a>";
        assert_eq!(set(page, None), expected);
        let address = Address::from_manifest("https://example.org/geneva", "").expect("an address");
        assert!(set(page, Some(&address)).contains("<a href=\"https://example.org/geneva/ledger.html#pin.x\">4</a>"));
    }

    #[test]
    fn folds_are_open_except_examples_and_mistakes_that_the_errata_print() {
        let page = "<details><summary>a</summary><p>b</p></details><details class=\"proof\"><summary>c</summary><pre>d</pre><details>\
                    <summary>e</summary></details></details><p>f</p><details class=\"erratum\" id=\"g\"><summary>h</summary>i</details>\
                    <details class=\"erratum told-here\"><summary>j</summary>k</details>";
        let expected = "<details open><summary>a</summary><p>b</p></details><details class=\"proof\" open><summary>c</summary></details>\
                        <p>f</p><details class=\"erratum\" id=\"pin--g\" open><summary>h</summary></details>\
                        <details class=\"erratum told-here\" open><summary>j</summary>k</details>";
        assert_eq!(set(page, None), expected);
    }

    #[test]
    fn notes_controls_and_links_to_data_are_left_out_and_marks_stay() {
        let page = "a<button type=\"button\" class=\"mark verdict-x\" popovertarget=\"n\" aria-label=\"b\">✓</button><div popover \
                    id=\"n\"><div>c</div></div><div hidden><label>d<input></label></div><small class=\"source\">e</small><script \
                    src=\"f\"></script><svg viewbox=\"0 0 1 1\"><style>a>b{}</style><path d=\"M0 0\" /></svg>1 &lt; 2";
        let expected = "a<span class=\"mark verdict-x\">✓</span><svg viewbox=\"0 0 1 1\"><style>a>b{}</style><path d=\"M0 0\" /></svg>1 \
                        &lt; 2";
        assert_eq!(set(page, None), expected);
    }

    #[test]
    fn the_sections_of_a_chapter_are_in_the_contents() {
        let (_, sections) = reset(&BOOK, "<h2 id=\"a\"><a>One</a> two</h2><h3 id=\"b\">Three</h3>", "pin", "", None);
        assert_eq!(sections, [("pin--a".to_owned(), "One two".to_owned())]);
    }
}
