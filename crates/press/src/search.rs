//! The search index, made anew: mdBook's own takes formulas, drawings and code for words.
//!
//! A heading begins an entry, and so does each claim of the ledger, under its id; the printed number is among its words.
//! The form of the file and the way of cutting words are those of mdBook, whose script reads it.
//!
//! A chapter explains a word and a record only repeats it, so chapters come first: the script divides what a field counts
//! by the root of its length, and the fields of records are given a greater length. Only the id of a claim, which no
//! chapter explains, keeps its weight.

use crate::book::Book;
use anyhow::{Context, ensure};
use elasticlunr::{Index, IndexBuilder};
use html5ever::tokenizer::{
    BufferQueue, EndTag, StartTag, Tag, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
};
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// What no reader searches: formulas, drawings, code, notes that repeat the ledger, links to other pages.
const PASSED_OVER: [&str; 7] = ["math", "svg", "pre", "button", "nav", "footer", "script"];
/// How many times longer the fields of a record are made.
const LENGTHENED: u64 = 1_000_000;
/// How often a word of a claim's id counts that is a word of the language, too: little, as in the fields of records.
const LITTLE: f64 = 0.001;
const OPENING: &str = "window.search = Object.assign(window.search, JSON.parse('";
const CLOSING: &str = "'));";

/// Makes the index of a book that is built in a folder anew. One without an index, which its settings may want, is left alone.
pub(crate) fn index(book: &Book, folder: &Path) -> anyhow::Result<()> {
    let Some(file) = file(folder)? else { return Ok(()) };
    let cannot = || format!("cannot read the search index {}", file.display());
    let text = fs::read_to_string(&file).with_context(cannot)?;
    let json = text.trim().strip_prefix(OPENING).and_then(|rest| rest.strip_suffix(CLOSING)).with_context(cannot)?;
    let mut whole: Value = serde_json::from_str(&unescaped(json)).with_context(cannot)?;

    let tokens = || Box::new(words as fn(&str) -> Vec<String>);
    let builder = IndexBuilder::new().add_field_with_tokenizer("title", tokens());
    let builder = builder.add_field_with_tokenizer("body", tokens()).add_field_with_tokenizer("breadcrumbs", tokens());
    let (mut index, mut urls): (Index, Vec<Value>) = (builder.build(), Vec::new());
    let (mut records, mut claims) = (Vec::new(), BTreeSet::new());
    for page in pages(folder)? {
        let name = page.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let html = fs::read_to_string(&page).with_context(|| format!("cannot read {}", page.display()))?;
        for entry in entries(&html) {
            let url = if entry.id.is_empty() { name.clone() } else { format!("{name}#{}", entry.id) };
            let place = urls.len().to_string();
            index.add_doc(&place, [entry.title.trim(), entry.body.trim(), entry.path.trim()]);
            if book.is_looked_up(name.trim_end_matches(".html")) {
                records.push(place.clone());
            }
            if entry.is_claim {
                claims.insert(place);
            }
            urls.push(url.into());
        }
    }
    ensure!(!urls.is_empty(), "no page of {} has anything to search for", folder.display());
    whole["doc_urls"] = urls.into();
    let mut index = serde_json::to_value(index)?;
    put_behind(&mut index, &records, &claims);
    whole["index"] = index;
    let json = whole.to_string().replace('\\', "\\\\").replace('\'', "\\'");
    fs::write(&file, format!("{OPENING}{json}{CLOSING}")).with_context(|| format!("cannot write {}", file.display()))
}

/// Lets what records say count for little, except the ids of claims.
fn put_behind(index: &mut Value, records: &[String], claims: &BTreeSet<String>) {
    for place in records {
        for (field, length) in index["documentStore"]["docInfo"][place].as_object_mut().into_iter().flatten() {
            // The title of a claim is its id.
            if let Some(words) = length.as_u64().filter(|_| field != "title" || !claims.contains(place)) {
                *length = (words * LENGTHENED).into();
            }
        }
    }
    lighten(&mut index["index"]["title"]["root"], String::new(), claims);
}

/// Lets the words in the titles of these entries count for little, if they are not part of an id alone. The index is a
/// tree whose branches are the letters of the words.
fn lighten(branch: &mut Value, word: String, claims: &BTreeSet<String>) {
    let is_of_an_id = word.contains('.') && word.contains(char::is_alphabetic);
    for (key, value) in branch.as_object_mut().into_iter().flatten() {
        match key.as_str() {
            "docs" if is_of_an_id => {}
            "docs" => {
                for (_, count) in
                    value.as_object_mut().into_iter().flatten().filter(|(place, _)| claims.contains(*place))
                {
                    count["tf"] = LITTLE.into();
                }
            }
            "df" => {}
            letter => lighten(value, format!("{word}{letter}"), claims),
        }
    }
}

/// The index that mdBook has written.
fn file(book: &Path) -> anyhow::Result<Option<PathBuf>> {
    let named = |path: &PathBuf| {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        name.starts_with("searchindex") && name.ends_with(".js")
    };
    Ok(files(book)?.into_iter().find(named))
}

/// The pages, each once: the first one stands under a second name, too.
fn pages(book: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let is_page = |path: &PathBuf| {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        name.ends_with(".html") && !["index.html", "toc.html", "404.html", "print.html"].contains(&name.as_str())
    };
    Ok(files(book)?.into_iter().filter(is_page).collect())
}

fn files(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let mut files = entries.map(|entry| Ok(entry?.path())).collect::<std::io::Result<Vec<_>>>()?;
    files.sort();
    Ok(files)
}

/// The JSON in a string of JavaScript.
fn unescaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut characters = text.chars();
    while let Some(c) = characters.next() {
        out.extend(if c == '\\' { characters.next() } else { Some(c) });
    }
    out
}

/// Words as mdBook cuts them.
fn words(text: &str) -> Vec<String> {
    let longest = 80;
    let all = text.split(|c: char| c.is_whitespace() || c == '-').filter(|word| !word.is_empty());
    all.map(str::to_lowercase).filter(|word| word.len() <= longest).collect()
}

/// What can be found: a section of a page, or a claim.
#[derive(Clone, Debug, Default, PartialEq)]
struct Entry {
    id: String,
    title: String,
    body: String,
    /// The headings above it.
    path: String,
    is_claim: bool,
}

/// The entries of a page, in their order.
fn entries(html: &str) -> Vec<Entry> {
    let tokenizer = Tokenizer::new(Sections::default(), TokenizerOpts::default());
    let queue = BufferQueue::default();
    queue.push_back(html.into());
    let _ = tokenizer.feed(&queue);
    tokenizer.end();
    let mut state = tokenizer.sink.0.into_inner();
    state.close(Entry::default());
    state.done
}

#[derive(Default)]
struct Sections(RefCell<State>);

#[derive(Default)]
struct State {
    is_in_text: bool,
    /// The element that is passed over, and how many of its name are open.
    passed: Option<(String, usize)>,
    is_in_title: bool,
    /// Whether a list of claims is open.
    is_in_claims: bool,
    /// The title of the page.
    page: String,
    /// The section that goes on after a claim.
    section: Option<Entry>,
    now: Entry,
    done: Vec<Entry>,
}

impl TokenSink for Sections {
    type Handle = ();

    fn process_token(&self, token: Token, _: u64) -> TokenSinkResult<()> {
        let mut state = self.0.borrow_mut();
        match token {
            Token::TagToken(tag) if tag.kind == StartTag => state.open(&tag),
            Token::TagToken(tag) if tag.kind == EndTag => state.end(&tag.name),
            Token::CharacterTokens(text) if state.is_in_text && state.passed.is_none() => {
                if state.is_in_title {
                    state.now.title.push_str(&text)
                } else {
                    state.now.body.push_str(&text)
                }
            }
            _ => {}
        }
        TokenSinkResult::Continue
    }
}

impl State {
    fn open(&mut self, tag: &Tag) {
        let attribute = |name: &str| tag.attrs.iter().find(|of| &*of.name.local == name).map(|of| of.value.to_string());
        let name: &str = &tag.name;
        if let Some((passed, depth)) = &mut self.passed {
            *depth += usize::from(passed == name && !tag.self_closing);
        } else if name == "main" {
            self.is_in_text = true;
        } else if self.is_in_text
            && (PASSED_OVER.contains(&name)
                || attribute("popover").is_some()
                // How a claim was checked, at length.
                || name == "details" && self.section.is_some())
        {
            self.passed = Some((name.to_owned(), 1));
        } else if self.is_in_text {
            let id = attribute("id");
            match (name, id) {
                ("h1" | "h2" | "h3", Some(id)) => {
                    let (heading, path) = (name, if name == "h1" { String::new() } else { self.page.clone() });
                    self.section = None;
                    self.close(Entry {
                        id: if heading == "h1" { String::new() } else { id },
                        path,
                        ..Entry::default()
                    });
                    self.is_in_title = true;
                }
                ("ul", None) => self.is_in_claims = attribute("class").is_some_and(|of| of == "claims"),
                // A claim's row, which begins with its id.
                ("li", Some(id)) if self.is_in_claims => {
                    let path = self.page.clone();
                    let section = self.now.clone();
                    self.close(Entry { id, path, is_claim: true, ..Entry::default() });
                    self.section = Some(Entry { body: String::new(), ..section });
                }
                ("code", None) if self.now.is_claim && self.now.title.is_empty() => self.is_in_title = true,
                // Words of neighbouring cells and paragraphs are not one.
                _ => self.now.body.push(' '),
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
            "h1" | "h2" | "h3" | "code" if self.is_in_title => {
                self.is_in_title = false;
                if name == "h1" {
                    self.page = self.now.title.clone();
                }
            }
            "ul" => self.is_in_claims = false,
            "li" => {
                if let Some(section) = self.section.take() {
                    self.close(section);
                }
            }
            _ => {}
        }
    }

    /// Ends the entry that is being read and begins another. A section without words is none.
    fn close(&mut self, next: Entry) {
        let mut entry = std::mem::replace(&mut self.now, next);
        entry.path =
            if entry.path.is_empty() { entry.title.clone() } else { format!("{} » {}", entry.path, entry.title) };
        entry.body = entry.body.split_whitespace().collect::<Vec<_>>().join(" ");
        if !entry.body.is_empty() {
            self.done.push(entry);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_and_claims_are_found_and_formulas_are_not() {
        let html = "<title>no</title><main><h1 id=\"t\"><a>Wheel</a></h1><p>a <math><mi>q</mi></math> b</p>\
                    <h2 id=\"s\">Part</h2><p>c<svg><g><text>no</text></g></svg></p><ul class=\"claims\"><li id=\"pin.x\">\
                    <code>pin.x</code> <p>36.5</p></li></ul><p>d <code>e</code></p><ul><li>f</li></ul><div popover><div>no</div>\
                    </div></main>";
        let found = entries(html);
        let told: Vec<_> = found.iter().map(|at| (at.id.as_str(), at.title.as_str(), at.body.as_str())).collect();
        let expected = [("", "Wheel", "a b"), ("s", "Part", "c"), ("pin.x", "pin.x", "36.5"), ("s", "Part", "d e f")];
        assert_eq!(told, expected);
        assert_eq!(found[2].path, "Wheel » pin.x");
        assert_eq!(found.iter().map(|at| at.is_claim).collect::<Vec<_>>(), [false, false, true, false]);
    }

    #[test]
    fn records_count_for_little_except_the_ids_of_claims() {
        let words = |word: &str, tf: f64| {
            let docs = serde_json::json!({ "0": { "tf": tf }, "1": { "tf": tf }, "2": { "tf": tf } });
            // Letter by letter, the last one first.
            let leaf = serde_json::json!({ "docs": docs, "df": 3 });
            word.chars()
                .rev()
                .fold(leaf, |branch, letter| serde_json::json!({ "docs": {}, "df": 0, letter.to_string(): branch }))
        };
        let lengths = serde_json::json!({ "title": 3, "body": 5, "breadcrumbs": 7 });
        for (word, of_claims) in [("slot", LITTLE), ("5.3", LITTLE), ("pin.slot", 2.0)] {
            let mut index = serde_json::json!({
                "documentStore": { "docInfo": { "0": lengths, "1": lengths, "2": lengths } },
                "index": { "title": { "root": words(word, 2.0) } },
            });
            // A chapter, a record, a claim.
            put_behind(&mut index, &["1".to_owned(), "2".to_owned()], &BTreeSet::from(["2".to_owned()]));
            let info = &index["documentStore"]["docInfo"];
            assert_eq!(info["0"], lengths);
            assert_eq!((&info["1"]["title"], &info["1"]["body"]), (&(3 * LENGTHENED).into(), &(5 * LENGTHENED).into()));
            assert_eq!((&info["2"]["title"], &info["2"]["body"]), (&3.into(), &(5 * LENGTHENED).into()));
            let end = word.chars().fold(&index["index"]["title"]["root"], |branch, letter| &branch[letter.to_string()]);
            let counts = ["0", "1", "2"].map(|place| end["docs"][place]["tf"].as_f64());
            assert_eq!(counts, [Some(2.0), Some(2.0), Some(of_claims)], "{word}");
        }
    }

    #[test]
    fn a_string_of_javascript_is_read_back() {
        let json = "{\"a\":\"it's \\\\ so\"}";
        let written = json.replace('\\', "\\\\").replace('\'', "\\'");
        assert_eq!(unescaped(&written), json);
    }
}
