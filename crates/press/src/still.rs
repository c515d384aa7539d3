//! A page of the book where nothing can be pressed or moved: on paper, in an ebook, and for other renderers of mdBook.
//!
//! What a chapter folds is open: solutions, derivations, tables. Of an example in Rust only its first line stays, which says
//! what it shows; of a mistake only the line that names it if the page of errata tells all on it. The notes on single claims, the
//! controls of figures that move and the links to data are left out.

use crate::address::Address;
use crate::book::Book;
use crate::ledger_pages::errata;
use crate::{maths, modules, xhtml};
use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{
    BufferQueue, EndTag, StartTag, Tag, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
};
use pulldown_cmark::{Event, Options, Parser};
use std::cell::RefCell;

/// What has no place where nothing can be pressed, by the class of the element.
const LEFT_OUT: [&str; 4] = ["beside", "edition", "source", "controls"];

/// Where a page stands still.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Medium {
    /// In one document in HTML with all other pages: the page's name is put before each id.
    Paper,
    /// In a file of its own, in XHTML.
    Ebook,
    /// In Markdown, for a renderer that mdBook calls.
    Markdown,
}

/// A page as it stands in its medium.
#[derive(Debug)]
pub(crate) struct StillPage {
    /// Its text.
    pub(crate) html: String,
    /// The headings of its sections: id and text.
    pub(crate) sections: Vec<(String, String)>,
    /// The places to which a link may lead.
    pub(crate) ids: Vec<String>,
}

/// What is known of the page that is set.
#[derive(Clone, Copy)]
pub(crate) struct PageSetting<'a> {
    /// The book.
    pub(crate) book: &'a Book,
    /// The page's name.
    pub(crate) page: &'a str,
    /// Its number, with a point behind it, or nothing.
    pub(crate) number: &'a str,
    /// Where it stands still.
    pub(crate) medium: Medium,
    /// Where the book can be read, if that is known.
    pub(crate) address: Option<&'a Address>,
}

/// The text of a page of the book set anew for its medium.
pub(crate) fn set(main: &str, setting: PageSetting<'_>) -> StillPage {
    let tokenizer = tokenizer(setting);
    feed(&tokenizer, main);
    tokenizer.end();
    let State { out, sections, ids, .. } = tokenizer.sink.0.into_inner();
    StillPage { html: out, sections, ids }
}

/// A chapter in Markdown with everything of its HTML that stands still. The Markdown stays as it is.
pub(crate) fn markdown(book: &Book, chapter: &str) -> String {
    let setting = PageSetting { book, page: "", number: "", medium: Medium::Markdown, address: None };
    let tokenizer = tokenizer(setting);
    let verbatim = |text: &str| {
        let mut state = tokenizer.sink.0.borrow_mut();
        if state.passed.is_none() {
            state.out.push_str(text);
        }
    };
    // Pieces of HTML that follow one another are one.
    let mut pieces: Vec<std::ops::Range<usize>> = Vec::new();
    for (event, range) in Parser::new_ext(chapter, maths::dialect() - Options::ENABLE_MATH).into_offset_iter() {
        match (event, pieces.last_mut()) {
            (Event::Html(_) | Event::InlineHtml(_), Some(last)) if last.end == range.start => last.end = range.end,
            (Event::Html(_) | Event::InlineHtml(_), _) => pieces.push(range),
            _ => {}
        }
    }
    let mut from = 0;
    for piece in pieces {
        verbatim(&chapter[from..piece.start]);
        from = piece.end;
        let (html, at) = (&chapter[piece], tokenizer.sink.0.borrow().out.len());
        feed(&tokenizer, html);
        let mut state = tokenizer.sink.0.borrow_mut();
        // An empty line ends a block of HTML, so none may come from what is left out.
        if !has_empty_line(html) {
            let set = state.out.split_off(at);
            state.out.push_str(&without_empty_lines(&set));
        }
    }
    verbatim(&chapter[from..]);
    tokenizer.end();
    tokenizer.sink.0.into_inner().out
}

fn has_empty_line(text: &str) -> bool {
    let lines: Vec<_> = text.split('\n').collect();
    lines.len() > 2 && lines[1..lines.len() - 1].iter().any(|line| line.trim().is_empty())
}

fn without_empty_lines(text: &str) -> String {
    let last = text.matches('\n').count();
    let lines = text.split('\n').enumerate();
    lines
        .filter(|(at, line)| *at == 0 || *at == last || !line.trim().is_empty())
        .map(|(_, line)| line)
        .collect::<Vec<_>>()
        .join("\n")
}

fn tokenizer(setting: PageSetting<'_>) -> Tokenizer<StillSink<'_>> {
    Tokenizer::new(StillSink(RefCell::new(State::new(setting))), TokenizerOpts::default())
}

fn feed(tokenizer: &Tokenizer<StillSink<'_>>, html: &str) {
    let queue = BufferQueue::default();
    queue.push_back(html.into());
    // What it passes over holds no script that would have to run while it is read.
    let _ = tokenizer.feed(&queue);
}

struct StillSink<'a>(RefCell<State<'a>>);

struct State<'a> {
    setting: PageSetting<'a>,
    out: String,
    sections: Vec<(String, String)>,
    ids: Vec<String>,
    /// The elements that are open: their names on the page, and what ends them here.
    open: Vec<(String, String)>,
    /// The element that is left out, and how many of its name are open.
    passed: Option<(String, usize)>,
    /// Of the folds that are open: whether only their first line stays.
    folds: Vec<bool>,
    is_in_section: bool,
    is_raw: bool,
}

impl TokenSink for StillSink<'_> {
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
            Token::EOFToken => state.close_all(),
            _ => {}
        }
        TokenSinkResult::Continue
    }
}

impl<'a> State<'a> {
    fn new(setting: PageSetting<'a>) -> Self {
        Self {
            setting,
            out: String::new(),
            sections: Vec::new(),
            ids: Vec::new(),
            open: Vec::new(),
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
        let is_paper = self.setting.medium == Medium::Paper;
        let is_left_out = ["script", "link", "input", "label", "select"].contains(&name)
            || attribute("popover").is_some()
            || attribute("hidden").is_some()
            || LEFT_OUT.iter().any(|class| has(class))
            || ["form", "textarea"].contains(&name) && !is_paper
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
        let link = attribute("href").filter(|_| !has("header")).and_then(|link| self.link(&link));
        let here = match name {
            "button" => "span",
            // What no control changes is no output, and what leads nowhere is no link.
            "output" if !is_paper => "span",
            "a" if link.is_none() && self.setting.medium == Medium::Ebook => "span",
            name => name,
        };
        let mut attributes = Vec::new();
        for of in &tag.attrs {
            let (key, value): (&str, &str) = (&of.name.local, &of.value);
            let value = match key {
                "aria-label" if self.setting.medium == Medium::Ebook && here != "span" => value.to_owned(),
                "tabindex" | "type" | "popovertarget" | "download" | "aria-label" | "aria-live"
                    if name != "div" || key == "tabindex" =>
                {
                    continue;
                }
                "open" => continue,
                "name" | "for" | "form" | "rel" | "target" | "title" if here != name && !is_paper => continue,
                _ if modules::is_own_attribute(self.setting.book, key) => continue,
                "id" => {
                    let id = self.id(value);
                    self.ids.push(id.clone());
                    id
                }
                "for" => self.id(value),
                "aria-labelledby" | "aria-describedby" | "aria-controls" => {
                    value.split(' ').map(|id| self.id(id)).collect::<Vec<_>>().join(" ")
                }
                "href" if name == "a" => match &link {
                    Some(link) => link.clone(),
                    None => continue,
                },
                _ => value.to_owned(),
            };
            attributes.push((key.to_owned(), value));
        }
        if name == "details" {
            attributes.push(("open".to_owned(), String::new()));
        }
        let ends_here = is_single(name) || tag.self_closing;
        if self.setting.medium == Medium::Ebook {
            let is_drawn = name == "svg" || self.open.iter().any(|(name, _)| name == "svg");
            let end = xhtml::start_tag(&mut self.out, here, &attributes, is_drawn, ends_here);
            if !ends_here {
                self.open.push((name.to_owned(), end));
            }
        } else {
            self.out.push_str(&format!("<{here}"));
            for (key, value) in attributes {
                let value = value.replace('&', "&amp;").replace('"', "&quot;");
                let is_bare = key == "open" && value.is_empty();
                self.out.push_str(&if is_bare { format!(" {key}") } else { format!(" {key}=\"{value}\"") });
            }
            self.out.push_str(if tag.self_closing { " />" } else { ">" });
            if !ends_here {
                self.open.push((name.to_owned(), format!("</{here}>")));
            }
        }
        if name == "h1" && !self.setting.number.is_empty() {
            self.out.push_str(&format!("{} ", self.setting.number));
        }
        if let ("h2", Some(id)) = (name, attribute("id")) {
            self.is_in_section = true;
            self.sections.push((self.id(&id), String::new()));
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
        // What is open inside ends with it. An end without a beginning ends nothing.
        if let Some(at) = self.open.iter().rposition(|(open, _)| open == name) {
            self.out.extend(self.open.drain(at..).rev().map(|(_, end)| end));
        }
        // Behind its first line, a fold of which only that stays is passed over.
        if name == "summary" && self.folds.last() == Some(&true) {
            self.passed = Some(("details".to_owned(), 1));
        }
    }

    fn close_all(&mut self) {
        self.out.extend(self.open.drain(..).rev().map(|(_, end)| end));
    }

    fn text(&mut self, text: &str) {
        if self.is_in_section
            && let Some((_, title)) = self.sections.last_mut()
        {
            title.push_str(text);
        }
        match self.setting.medium {
            Medium::Ebook => self.out.push_str(&xhtml::escape(text)),
            _ if self.is_raw => self.out.push_str(text),
            _ => self.out.push_str(&text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")),
        }
    }

    /// An id of the page where it stands now.
    fn id(&self, id: &str) -> String {
        match self.setting.medium {
            Medium::Paper => format!("{}--{id}", self.setting.page),
            Medium::Ebook | Medium::Markdown => id.to_owned(),
        }
    }

    /// Where a link leads from here, if anywhere.
    fn link(&self, link: &str) -> Option<String> {
        let PageSetting { book, page, medium, address, .. } = self.setting;
        if link.starts_with("http") || medium == Medium::Markdown {
            return Some(link.to_owned());
        }
        let (file, fragment) = link.split_once('#').unwrap_or((link, ""));
        let name = match file.trim_end_matches(".html") {
            "" => page,
            "index" => book.pages.first().map_or("index", |page| page.name),
            name => name,
        };
        let is_here = book.pages.iter().any(|page| page.name == name && page.is_printed);
        match (is_here, medium, fragment) {
            (true, Medium::Paper, "") => Some(format!("#{name}")),
            (true, Medium::Paper, _) => Some(format!("#{name}--{fragment}")),
            (true, _, "") => Some(xhtml::file_name(name)),
            (true, ..) => Some(format!("{}#{fragment}", xhtml::file_name(name))),
            _ => address.map(|address| address.page(link)),
        }
    }
}

/// Whether an element has no end.
fn is_single(name: &str) -> bool {
    ["link", "input", "img", "br", "hr", "meta", "wbr", "col"].contains(&name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    fn on(medium: Medium, main: &str, address: Option<&Address>) -> String {
        super::set(main, PageSetting { book: &BOOK, page: "pin", number: "1.", medium, address }).html
    }

    fn set(main: &str, address: Option<&Address>) -> String {
        on(Medium::Paper, main, address)
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
        let setting = PageSetting { book: &BOOK, page: "pin", number: "", medium: Medium::Paper, address: None };
        let StillPage { sections, .. } = super::set("<h2 id=\"a\"><a>One</a> two</h2><h3 id=\"b\">Three</h3>", setting);
        assert_eq!(sections, [("pin--a".to_owned(), "One two".to_owned())]);
    }

    #[test]
    fn in_an_ebook_every_element_ends_and_links_lead_to_its_files_or_are_text() {
        let page = "<h1 id=\"t\"><a class=\"header\" href=\"#t\">T</a></h1><p>a<br>b &amp; c<p><a href=\"jazar.html#y\">2</a>\
                    <a rel=\"x\" href=\"data/a.csv\">3</a><math><mi>x</mi></math><svg viewbox=\"0 0 1 1\"><style>a>b{}</style>\
                    <path d=\"M0 0\" /></svg></i><output name=\"o\">4</output><details><summary>5</summary>";
        let set = on(Medium::Ebook, page, None);
        let expected = "<h1 id=\"t\">1. <span class=\"header\">T</span></h1><p>a<br/>b &amp; c<p><a href=\"jazar.xhtml#y\">2</a>\
                        <span>3</span><math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mi>x</mi></math>\
                        <svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\"><style>a&gt;b{}</style><path d=\"M0 0\"/></svg>\
                        <span>4</span><details open=\"\"><summary>5</summary></details></p></p>";
        assert_eq!(set, expected);
        let address = Address::from_manifest("https://example.org/geneva", "").expect("an address");
        assert!(
            on(Medium::Ebook, page, Some(&address)).contains("href=\"https://example.org/geneva/data/a.csv\">3</a>")
        );
    }

    #[test]
    fn in_markdown_only_the_html_changes_and_no_block_of_it_breaks() {
        let chapter = "# A *b*\n\n`<button>` a<button class=\"mark\">✓</button> [c](d.md)\n\n<figure>\n<div class=\"controls\">e\n\
                       <input></div>\n<svg>f</svg>\n</figure>\n\n<details class=\"proof\">\n<summary>g</summary>\n\n```rust\nh\n```\n\n\
                       </details>\n\n<div popover>\ni\n</div>\n\nj &lt; k\n";
        let expected = "# A *b*\n\n`<button>` a<span class=\"mark\">✓</span> [c](d.md)\n\n<figure>\n<svg>f</svg>\n</figure>\n\n\
                        <details class=\"proof\" open>\n<summary>g</summary></details>\n\n\n\nj &lt; k\n";
        assert_eq!(markdown(&BOOK, chapter), expected);
    }
}
