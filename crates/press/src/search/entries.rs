//! What can be found on a page: its sections, the figures that a reader moves, and claims.
//!
//! A heading begins an entry. So does a figure with controls, for a reader who searches for what a button says wants the
//! button, and so does each claim of the ledger, under its id; the printed number is among its words.

use crate::ledger_pages::lists::LETTERS;
use html5ever::tokenizer::{
    BufferQueue, EndTag, StartTag, Tag, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
};
use std::cell::RefCell;

/// What no reader searches: formulas, drawings, code, numbers that change, links to other pages.
const PASSED_OVER: [&str; 8] = ["math", "svg", "pre", "output", "nav", "footer", "script", "style"];
/// The class of a button that is a claim's mark, which has no words.
const MARK: &str = "mark";
/// What the title of a figure with controls begins with.
const LIVE: &str = "Live ";

/// What can be found.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Entry {
    pub(super) kind: EntryKind,
    /// The title of its page.
    pub(super) page: String,
    /// Its anchor; none where the page begins.
    pub(super) id: String,
    pub(super) title: String,
    pub(super) body: String,
    /// Words of tables that only say what letters stand for.
    pub(super) little: String,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum EntryKind {
    /// A section of a page.
    #[default]
    Section,
    /// A figure that a reader moves.
    Figure,
    /// A claim in a list of claims.
    Claim,
}

impl EntryKind {
    /// Its name on a shelf.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Section => "section",
            Self::Figure => "figure",
            Self::Claim => "claim",
        }
    }

    /// The one of this name.
    pub(super) fn of_name(name: &str) -> Self {
        [Self::Figure, Self::Claim].into_iter().find(|kind| kind.name() == name).unwrap_or_default()
    }
}

/// The entries of a page, in their order. What a reader moves has one of these attributes.
pub(super) fn entries(html: &str, moving: &[&str]) -> Vec<Entry> {
    let state = RefCell::new(State { moving, ..State::default() });
    let tokenizer = Tokenizer::new(Sections(state), TokenizerOpts::default());
    let queue = BufferQueue::default();
    queue.push_back(html.into());
    let _ = tokenizer.feed(&queue);
    tokenizer.end();
    let mut state = tokenizer.sink.0.into_inner();
    state.close(Entry::default());
    state.done
}

struct Sections<'a>(RefCell<State<'a>>);

#[derive(Default)]
struct State<'a> {
    moving: &'a [&'a str],
    is_in_text: bool,
    /// The element that is passed over, and how many of its name are open.
    passed: Option<(String, usize)>,
    is_in_title: bool,
    /// Whether a list of claims is open.
    is_in_claims: bool,
    /// Whether a table of letters is open.
    is_in_letters: bool,
    /// The title of the page.
    page: String,
    /// The section that goes on after a claim or a figure.
    section: Option<Entry>,
    now: Entry,
    done: Vec<Entry>,
}

impl TokenSink for Sections<'_> {
    type Handle = ();

    fn process_token(&self, token: Token, _: u64) -> TokenSinkResult<()> {
        let mut state = self.0.borrow_mut();
        match token {
            Token::TagToken(tag) if tag.kind == StartTag => state.open(&tag),
            Token::TagToken(tag) if tag.kind == EndTag => state.end(&tag.name),
            Token::CharacterTokens(text) if state.is_in_text && state.passed.is_none() => state.text().push_str(&text),
            _ => {}
        }
        TokenSinkResult::Continue
    }
}

impl State<'_> {
    /// Where the text goes that is read now.
    fn text(&mut self) -> &mut String {
        match (self.is_in_title, self.is_in_letters) {
            (true, _) => &mut self.now.title,
            (_, true) => &mut self.now.little,
            _ => &mut self.now.body,
        }
    }

    fn open(&mut self, tag: &Tag) {
        let attribute = |name: &str| tag.attrs.iter().find(|of| &*of.name.local == name).map(|of| of.value.to_string());
        let has_class = |class: &str| attribute("class").is_some_and(|all| all.split(' ').any(|of| of == class));
        let name: &str = &tag.name;
        if let Some((passed, depth)) = &mut self.passed {
            *depth += usize::from(passed == name && !tag.self_closing);
        } else if name == "main" {
            self.is_in_text = true;
        } else if self.is_in_text
            && (PASSED_OVER.contains(&name)
                || attribute("popover").is_some()
                || name == "button" && has_class(MARK)
                // How a claim was checked, at length.
                || name == "details" && self.now.kind == EntryKind::Claim)
        {
            self.passed = Some((name.to_owned(), 1));
        } else if self.is_in_text {
            match (name, attribute("id")) {
                ("h1" | "h2" | "h3", Some(id)) => {
                    let id = if name == "h1" { String::new() } else { id };
                    self.section = None;
                    self.close(Entry { id, ..Entry::default() });
                    self.is_in_title = true;
                }
                ("ul", None) => self.is_in_claims = has_class("claims"),
                // A claim's row, which begins with its id.
                ("li", Some(id)) if self.is_in_claims => self.begin_within(id, EntryKind::Claim),
                ("code", None) if self.now.kind == EntryKind::Claim && self.now.title.is_empty() => {
                    self.is_in_title = true;
                }
                ("figure", Some(id)) if self.moving.iter().any(|of| attribute(of).is_some()) => {
                    self.begin_within(id, EntryKind::Figure);
                }
                ("figcaption", _) if self.now.kind == EntryKind::Figure => {
                    self.now.title = LIVE.to_owned();
                    self.is_in_title = true;
                }
                ("small", _) if self.now.kind == EntryKind::Figure => {
                    self.is_in_title = false;
                    self.now.body.push(' ');
                }
                ("div", _) if attribute("aria-label").is_some_and(|label| label.starts_with(LETTERS)) => {
                    self.is_in_letters = true;
                }
                // Words of neighbouring cells and paragraphs are not one.
                _ => self.text().push(' '),
            }
        }
    }

    fn end(&mut self, name: &str) {
        if let Some((passed, depth)) = &mut self.passed {
            *depth -= usize::from(passed == name);
            if *depth == 0 {
                self.passed = None;
            }
            return;
        }
        match name {
            "main" => self.is_in_text = false,
            "h1" | "h2" | "h3" | "code" | "figcaption" if self.is_in_title => {
                self.is_in_title = false;
                if name == "h1" {
                    self.page = joined(&self.now.title);
                }
            }
            "table" => self.is_in_letters = false,
            // What stands behind a button is no part of its word.
            "button" | "label" | "option" => self.text().push(' '),
            "ul" => self.is_in_claims = false,
            "li" if self.now.kind == EntryKind::Claim => self.end_within(),
            "figure" if self.now.kind == EntryKind::Figure => {
                self.shorten_title();
                self.end_within();
            }
            _ => {}
        }
    }

    /// Begins an entry after which the section goes on.
    fn begin_within(&mut self, id: String, kind: EntryKind) {
        let section = Entry { body: String::new(), little: String::new(), ..self.now.clone() };
        self.close(Entry { id, kind, ..Entry::default() });
        self.section = Some(section);
    }

    fn end_within(&mut self) {
        if let Some(section) = self.section.take() {
            self.close(section);
        }
    }

    /// Of a caption, the number and the first sentence are the title, and the rest is text.
    fn shorten_title(&mut self) {
        let caption = joined(&self.now.title);
        let number = caption.find(". ").map_or(0, |at| at + 2);
        let end = caption[number..].find(". ").map_or(caption.len(), |at| number + at + 1);
        self.now.body.push_str(&caption[end..]);
        self.now.title = caption[..end].trim_end_matches('.').to_owned();
    }

    /// Ends the entry that is being read and begins another. A section without words is none.
    fn close(&mut self, next: Entry) {
        let mut entry = std::mem::replace(&mut self.now, next);
        [entry.title, entry.body, entry.little] = [&entry.title, &entry.body, &entry.little].map(|text| joined(text));
        if !entry.body.is_empty() || !entry.little.is_empty() {
            entry.page.clone_from(&self.page);
            self.done.push(entry);
        }
    }
}

/// A text with one space between words.
fn joined(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_and_claims_are_found_and_formulas_are_not() {
        let html = "<title>no</title><main><h1 id=\"t\"><a>Wheel</a></h1><p>a <math><mi>q</mi></math> b<button class=\"mark \
                    verdict-x\">✓</button></p><h2 id=\"s\">Part</h2><p>c<svg><g><text>no</text></g></svg></p><ul \
                    class=\"claims\"><li id=\"pin.x\"><code>pin.x</code> <p>36.5</p><details>no</details></li></ul><p>d \
                    <code>e</code></p><ul><li>f</li></ul><div popover><div>no</div></div></main>";
        let found = entries(html, &[]);
        let told: Vec<_> = found.iter().map(|at| (at.kind, &*at.id, &*at.title, &*at.body)).collect();
        let expected = [
            (EntryKind::Section, "", "Wheel", "a b"),
            (EntryKind::Section, "s", "Part", "c"),
            (EntryKind::Claim, "pin.x", "pin.x", "36.5"),
            (EntryKind::Section, "s", "Part", "d e f"),
        ];
        assert_eq!(told, expected);
        assert!(found.iter().all(|entry| entry.page == "Wheel"));
    }

    #[test]
    fn a_figure_with_controls_is_found_by_what_its_controls_say() {
        let html = "<main><h1 id=\"t\">Wheel</h1><p>a</p><figure class=\"fig\" data-live=\"w\" id=\"fig-w\"><form><label>pins \
                    <input></label><button data-file=\"dxf\">Drawing</button><output>3</output></form><figcaption><strong>Figure \
                    1.2.</strong> <span>Of 0.5 mm. More.</span> <small>Data</small></figcaption></figure><p>b</p><figure \
                    id=\"fig-s\"><figcaption>c</figcaption></figure></main>";
        let found = entries(html, &["data-live"]);
        let told: Vec<_> = found.iter().map(|at| (&*at.id, &*at.title, &*at.body)).collect();
        let live = ("fig-w", "Live Figure 1.2. Of 0.5 mm", "pins Drawing Data More.");
        assert_eq!(told, [("", "Wheel", "a"), live, ("", "Wheel", "b c")]);
    }

    #[test]
    fn words_of_a_table_of_letters_are_kept_apart() {
        let html = "<main><h1 id=\"t\">Wheel</h1><h2 id=\"letters\">Letters</h2><div role=\"region\" \
                    aria-label=\"Letters\"><table><tr><td>crank</td></tr></table></div><p>after</p></main>";
        let found = entries(html, &[]);
        assert_eq!(found.iter().map(|at| (&*at.body, &*at.little)).collect::<Vec<_>>(), [("after", "crank")]);
    }
}
