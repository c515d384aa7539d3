//! Do the rendered pages hold together? Builds the book and looks at what a reader would get.

use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{BufferQueue, StartTag, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use tempfile::TempDir;

/// What a page may weigh with everything that it loads, and a figure on it, in bytes; and what moves figures, which comes on
/// top where there are some.
const HEAVIEST_PAGE: usize = 392_000 + TEXT_FACE;
/// The face of the text, which a browser loads once for all pages and keeps (`fonts.rs`).
const TEXT_FACE: usize = 57_500;
/// The page of all claims is ten pages in one. It is looked up in and not read through, it weighs about 60 kilobytes when a
/// server packs it, and a browser lays out only the rows on the screen. What a reader asks for comes on top.
const HEAVIEST_LEDGER: usize = 746_000 + TEXT_FACE;
/// The whole book in one, for those who print it.
const HEAVIEST_TO_PRINT: usize = 1_800_000 + TEXT_FACE;
const HEAVIEST_DETAILS: usize = 708_000;
/// Controls and their style, and the modules of which a page loads one. The data of the still figures are not loaded by a page.
const MOVER: [&str; 2] = ["data/live.js", "data/live.css"];
const MODULES: [&str; 2] = ["data/live-module.js", "data/live-design-module.js"];
const HEAVIEST_MOVER: usize = 330_000;
/// The module that comes with the first file that a reader takes away.
const HEAVIEST_FILES: usize = 505_000;
const HEAVIEST_FIGURE: usize = 46_000;

/// The book, built once for all tests of this program. If it does not build, one test says why.
#[track_caller]
pub(crate) fn book() -> &'static Path {
    static BOOK: OnceLock<Option<(TempDir, PathBuf)>> = OnceLock::new();
    let mut reason = None;
    let book = BOOK.get_or_init(|| built(true).map_err(|why| reason = Some(why)).ok());
    match (book, reason) {
        (Some((_, out)), _) => out,
        (None, Some(reason)) => panic!("the book does not build: {reason}"),
        (None, None) => panic!("the book does not build: another test says why"),
    }
}

/// The book in a folder of its own, from scratch, or with what an earlier build of this program has kept.
fn built(from_scratch: bool) -> Result<(TempDir, PathBuf), String> {
    let folder = TempDir::new().expect("a folder");
    let out = folder.path().join("book");
    let build = if from_scratch { geneva_press::build_afresh } else { geneva_press::build };
    build(&geneva_chapters::BOOK, &crate::path("."), &out).map_err(|error| format!("{error:#}"))?;
    Ok((folder, out))
}

/// All files of a book by their path in it.
pub(crate) type Files = BTreeMap<String, Vec<u8>>;

/// The files of the book, read once for all tests of this program.
pub(crate) fn files() -> &'static Files {
    static FILES: OnceLock<Files> = OnceLock::new();
    FILES.get_or_init(|| contents(book()))
}

/// All files of a built book.
fn contents(out: &Path) -> Files {
    let mut files = BTreeMap::new();
    let mut folders = vec![out.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(out).expect("inside").to_string_lossy().replace('\\', "/");
                files.insert(name, std::fs::read(&path).expect("readable"));
            }
        }
    }
    files
}

/// What a page is made of, in its order.
pub(crate) enum Piece {
    Start { element: String, attributes: HashMap<String, String> },
    End(String),
    Text(String),
}

#[derive(Default)]
struct Pieces(RefCell<Vec<Piece>>);

impl TokenSink for Pieces {
    type Handle = ();

    fn process_token(&self, token: Token, _: u64) -> TokenSinkResult<()> {
        let mut pieces = self.0.borrow_mut();
        match token {
            Token::TagToken(tag) if tag.kind == StartTag => {
                let attributes = tag.attrs.iter().map(|of| (of.name.local.to_string(), of.value.to_string())).collect();
                pieces.push(Piece::Start { element: tag.name.to_string(), attributes });
                match &*tag.name {
                    "script" => return TokenSinkResult::RawData(RawKind::ScriptData),
                    // A browser with scripts passes over what is for one without.
                    "style" | "noscript" => return TokenSinkResult::RawData(RawKind::Rawtext),
                    _ => {}
                }
            }
            Token::TagToken(tag) => pieces.push(Piece::End(tag.name.to_string())),
            Token::CharacterTokens(text) => pieces.push(Piece::Text(text.to_string())),
            _ => {}
        }
        TokenSinkResult::Continue
    }
}

fn pieces(html: &str) -> Vec<Piece> {
    let tokenizer = Tokenizer::new(Pieces::default(), TokenizerOpts::default());
    let queue = BufferQueue::default();
    queue.push_back(html.into());
    let _ = tokenizer.feed(&queue);
    tokenizer.end();
    tokenizer.sink.0.into_inner()
}

/// Addresses of earlier editions, and where each leads.
pub(crate) fn moved() -> &'static BTreeMap<String, String> {
    static MOVED: OnceLock<BTreeMap<String, String>> = OnceLock::new();
    MOVED.get_or_init(|| {
        let settings = std::fs::read_to_string(crate::path("book/book.toml")).expect("the book's settings");
        let settings: toml::Table = settings.parse().expect("TOML");
        let moved = settings["output"]["html"]["redirect"].as_table().expect("a table");
        let address = |text: &toml::Value| text.as_str().expect("an address").to_owned();
        moved.iter().map(|(from, to)| (from.trim_start_matches('/').to_owned(), address(to))).collect()
    })
}

fn is_page(name: &str) -> bool {
    name.ends_with(".html") && name != "toc.html" && !moved().contains_key(name)
}

/// The names of all pages of the book that are read on a screen: all but the one that is printed.
pub(crate) fn names() -> Vec<String> {
    files().keys().filter(|name| is_page(name) && *name != geneva_press::print::FILE).cloned().collect()
}

/// The pages of the book by name, taken apart once for all tests of this program.
pub(crate) fn pages() -> &'static BTreeMap<String, Vec<Piece>> {
    static PAGES: OnceLock<BTreeMap<String, Vec<Piece>>> = OnceLock::new();
    PAGES.get_or_init(|| {
        let pages = files().iter().filter(|(name, _)| is_page(name));
        pages.map(|(name, bytes)| (name.clone(), pieces(std::str::from_utf8(bytes).expect("UTF-8")))).collect()
    })
}

/// The values of an attribute, of these elements or, if none is named, of all.
fn attribute(page: &[Piece], elements: &[&str], name: &str) -> Vec<String> {
    let value = |piece: &Piece| match piece {
        Piece::Start { element, attributes } if elements.is_empty() || elements.contains(&element.as_str()) => {
            attributes.get(name).cloned()
        }
        _ => None,
    };
    page.iter().filter_map(value).collect()
}

pub(crate) fn ids(page: &[Piece]) -> Vec<String> {
    attribute(page, &[], "id")
}

/// What stands in each element of this name; none of them holds another.
pub(crate) fn within<'a>(page: &'a [Piece], name: &str) -> Vec<&'a [Piece]> {
    let starts =
        page.iter().enumerate().filter(|(_, of)| matches!(of, Piece::Start { element, .. } if element == name));
    let inside = starts.map(|(at, _)| {
        let length = page[at..].iter().position(|of| matches!(of, Piece::End(element) if element == name));
        &page[at..at + length.expect("an end")]
    });
    inside.collect()
}

pub(crate) fn text(pieces: &[Piece]) -> String {
    pieces.iter().filter_map(|piece| if let Piece::Text(text) = piece { Some(text.as_str()) } else { None }).collect()
}

#[test]
fn links_and_fragments_lead_somewhere() {
    let files = files();
    let ids: BTreeMap<_, HashSet<_>> =
        pages().iter().map(|(name, page)| (name.as_str(), ids(page).into_iter().collect())).collect();
    for (name, page) in pages() {
        for link in attribute(page, &["a"], "href") {
            if link.starts_with("http") {
                continue;
            }
            let (file, fragment) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() { name.as_str() } else { file };
            if files.contains_key(target) && !target.ends_with(".html") {
                continue;
            }
            let there = ids.get(target).unwrap_or_else(|| panic!("{name}: no page {target}"));
            let found = fragment.is_empty() || there.contains(fragment);
            assert!(found, "{name}: {target} has no #{fragment}");
        }
    }
}

#[test]
fn ids_are_unique_on_a_page() {
    for (name, page) in pages() {
        let mut seen = HashSet::new();
        for id in ids(page) {
            assert!(seen.insert(id.clone()), "{name}: #{id} stands twice");
        }
    }
}

#[test]
fn no_line_of_a_paragraph_has_become_a_list() {
    // A line that begins with a number and a full stop is the first item of a list to Markdown.
    for (name, page) in pages().iter().filter(|(name, _)| *name != "toc.html") {
        let mut items: Vec<usize> = Vec::new();
        for piece in page {
            match piece {
                Piece::Start { element, attributes } if element == "ol" && !attributes.contains_key("class") => {
                    assert!(!attributes.contains_key("start"), "{name}: a list begins with {attributes:?}");
                    items.push(0);
                }
                Piece::Start { element, .. } if ["ol", "ul"].contains(&element.as_str()) => items.push(2),
                Piece::Start { element, .. } if element == "li" => {
                    if let Some(count) = items.last_mut() {
                        *count += 1;
                    }
                }
                Piece::End(element) if ["ol", "ul"].contains(&element.as_str()) => {
                    let count = items.pop();
                    assert!(count.is_none_or(|count| count > 1), "{name}: a numbered list has one item");
                }
                _ => {}
            }
        }
    }
}

#[test]
fn no_placeholder_is_left_and_no_number_is_none() {
    for (name, page) in pages() {
        let text: String = within(page, "main").into_iter().map(text).collect();
        for wrong in ["{{", "NaN"] {
            let at = text.find(wrong).map(|at| text[at..].chars().take(60).collect::<String>());
            assert_eq!(at, None, "{name}");
        }
    }
}

/// What a page loads by itself: style, scripts, pictures, fonts named in its style.
fn loaded(page: &[Piece], files: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let linked = page.iter().filter_map(|piece| match piece {
        Piece::Start { element, attributes } if element == "link" => {
            let is_loaded = |kind: &str| ["stylesheet", "icon"].contains(&kind);
            attributes.get("href").filter(|_| attributes.get("rel").is_some_and(|of| of.split(' ').any(is_loaded)))
        }
        _ => None,
    });
    let mut names: Vec<_> = linked.cloned().collect();
    names.extend(attribute(page, &["script", "img", "image", "use", "iframe", "video", "audio"], "src"));
    let styles: Vec<_> = names.iter().filter(|name| name.ends_with(".css")).cloned().collect();
    for style in styles {
        let text = String::from_utf8_lossy(files.get(&style).map_or(&[][..], Vec::as_slice)).into_owned();
        for url in text.split("url(").skip(1).filter_map(|rest| rest.split(')').next()) {
            let url = url.trim_matches(['"', '\'']);
            if !url.starts_with("data:") {
                let folder = style.rsplit_once('/').map_or("", |(folder, _)| folder);
                names.push(joined(folder, url));
            }
        }
    }
    names.sort();
    names.dedup();
    names
}

/// A relative address from a folder of the book.
fn joined(folder: &str, url: &str) -> String {
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in url.split('/') {
        match part {
            ".." => drop(parts.pop()),
            "." => {}
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[test]
fn a_page_loads_nothing_from_elsewhere_and_what_it_loads_is_there() {
    let files = files();
    for (name, page) in pages() {
        for file in loaded(page, files) {
            assert!(!file.contains("://") && !file.starts_with("//"), "{name} loads {file}");
            assert!(files.contains_key(&file), "{name} loads {file}, which is not in the book");
        }
    }
}

#[test]
fn a_page_is_not_too_heavy() {
    // With every font that its style names, though a browser loads only those that the page uses.
    let files = files();
    for (name, page) in pages() {
        let read = loaded(page, files).into_iter().filter(|file| !file.starts_with("data/live"));
        let weight = files[name].len() + read.map(|file| files[&file].len()).sum::<usize>();
        let heaviest = match name.as_str() {
            "ledger.html" => HEAVIEST_LEDGER,
            geneva_press::print::FILE => HEAVIEST_TO_PRINT,
            _ => HEAVIEST_PAGE,
        };
        assert!(weight < heaviest, "{name} weighs {weight} bytes; {heaviest} are allowed");
        for figure in String::from_utf8_lossy(&files[name]).split("<figure").skip(1) {
            let weight = figure.find("</figure>").unwrap_or(figure.len());
            assert!(weight < HEAVIEST_FIGURE, "a figure of {weight} bytes on {name}; {HEAVIEST_FIGURE} are allowed");
        }
    }
}

#[test]
fn every_table_of_numbers_has_a_named_column_for_each_cell_and_says_what_it_is() {
    let mut tables = 0;
    let data = |path: &'static String| path.strip_prefix("data/").filter(|name| name.ends_with(".csv"));
    for (path, table) in files() {
        let Some(name) = data(path) else { continue };
        // A row with more or fewer cells than the first one is an error.
        let mut reader = csv::Reader::from_reader(table.as_slice());
        let names: Vec<_> = reader.headers().expect("names").iter().map(str::to_owned).collect();
        assert!(names.iter().all(|column| !column.is_empty()), "{name}: a column without a name in {names:?}");
        for row in reader.records() {
            assert!(row.is_ok(), "{name}: {}", row.expect_err("an error"));
        }
        // The records are described in a list among them.
        if ["copies.csv", "coverage.csv", "fields.csv", "works.csv"].contains(&name) {
            continue;
        }
        let beside = files().get(&format!("{path}-metadata.json")).expect("beside it");
        let said: serde_json::Value = serde_json::from_slice(beside).expect("JSON");
        assert_eq!(said["url"], name);
        let title = said["dc:title"].as_str().expect("a title");
        assert!(title.starts_with("Figure") || title.starts_with("Table"), "{title}");
        tables += 1;
    }
    assert!(tables > 80, "{tables} tables");
}

#[test]
fn what_moves_figures_is_not_too_heavy() {
    if !crate::live::moves() {
        return;
    }
    let files = files();
    let controls: usize = MOVER.iter().map(|name| files[*name].len()).sum();
    for module in MODULES {
        let weight = controls + files[module].len();
        assert!((100_000..HEAVIEST_MOVER).contains(&weight), "{module}: {weight} bytes; {HEAVIEST_MOVER} are allowed");
    }
    let weight = files["data/live-files-module.js"].len();
    assert!((100_000..HEAVIEST_FILES).contains(&weight), "{weight} bytes for files; {HEAVIEST_FILES} are allowed");
}

#[test]
fn what_is_known_of_the_claims_is_loaded_when_it_is_asked_for_and_not_too_heavy() {
    let files = files();
    let details = "data/ledger-details.js";
    for (name, page) in pages() {
        assert!(!loaded(page, files).contains(&details.to_owned()), "{name} loads {details} by itself");
    }
    let weight = files[details].len();
    assert!((100_000..HEAVIEST_DETAILS).contains(&weight), "{weight} bytes; {HEAVIEST_DETAILS} are allowed");
}

#[test]
fn two_builds_give_the_same_bytes_and_so_does_one_from_what_they_have_kept() {
    let first = files();
    for number in ["second", "third"] {
        let (_folder, again) = built(false).expect("the book builds");
        let other = contents(&again);
        assert_eq!(first.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>(), "{number}");
        for (name, bytes) in first {
            assert!(*bytes == other[name], "{name} of the {number} build differs from that of a build from scratch");
        }
    }
}

#[test]
fn figures_have_a_number_a_caption_and_words_for_those_who_do_not_see_them() {
    let mut shown = HashSet::new();
    for (name, page) in pages() {
        for figure in within(page, "figure") {
            let caption = within(figure, "figcaption").into_iter().next().map(text).unwrap_or_default();
            assert!(caption.starts_with("Figure\u{a0}") || caption.starts_with("Table\u{a0}"), "{name}: {caption}");
            assert!(caption.len() > 25, "{name}: {caption}");
        }
        // Figures, and pictures without number.
        for drawing in within(page, "svg").into_iter().filter(|svg| !within(svg, "desc").is_empty()) {
            let part = |element: &str| within(drawing, element).into_iter().next().map(text).unwrap_or_default();
            assert!(part("title").len() > 5 && part("desc").len() > 40, "{name}: {}", part("desc"));
            shown.insert(part("title"));
        }
    }
    assert_eq!(shown.len(), geneva_chapters::figures::FIGURES.len());
}

#[test]
fn a_figure_that_moves_says_what_it_is_and_reads_out_one_number() {
    let mut moving = 0;
    for (name, page) in pages() {
        for figure in within(page, "figure") {
            let Some(Piece::Start { attributes, .. }) = figure.first() else { continue };
            if !attributes.contains_key("data-live") {
                continue;
            }
            moving += 1;
            let label = attributes.get("aria-label").map_or("", String::as_str);
            assert!(label.starts_with("Live Figure "), "{name}: {label}");
            let spoken = attribute(figure, &["output"], "aria-live");
            let (first, others) = spoken.split_first().expect("a number");
            assert!(first == "polite" && others.iter().all(|of| of == "off"), "{name}: {spoken:?}");
            // How a turning mechanism stands is told besides.
            let turning = usize::from(figure.iter().any(|piece| {
                matches!(piece, Piece::Start { attributes, .. }
                if attributes.get("class").is_some_and(|class| class == "turned"))
            }));
            assert_eq!(
                attribute(figure, &[], "aria-live").len(),
                spoken.len() + turning,
                "{name}: more than numbers are read out"
            );
            // A slider says its unit, as its box does.
            let inputs = |kind: &str| -> Vec<String> {
                let of_kind = figure.iter().filter_map(|piece| match piece {
                    Piece::Start { element, attributes }
                        if element == "input" && attributes.get("type").is_some_and(|of| of == kind) =>
                    {
                        Some(attributes.get("aria-label").cloned().unwrap_or_default())
                    }
                    _ => None,
                });
                of_kind.collect()
            };
            assert!(!inputs("range").is_empty() && inputs("range").iter().all(|label| !label.is_empty()), "{name}");
            let numbers = inputs("number");
            assert!(inputs("range").iter().all(|label| numbers.contains(label)), "{name}");
            assert!(numbers.iter().all(|label| !label.is_empty()), "{name}");
        }
    }
    assert!(moving > 4, "{moving} figures move");
}

#[test]
fn the_pages_lead_from_one_to_the_next_in_the_order_of_the_book() {
    let pages = pages();
    let order: Vec<_> = geneva_chapters::BOOK.pages.iter().map(|page| format!("{}.html", page.name)).collect();
    for (at, name) in order.iter().enumerate() {
        let leads = |rel: &str| {
            let links = pages[name].iter().filter_map(|piece| match piece {
                Piece::Start { element, attributes } if element == "a" => Some(attributes),
                _ => None,
            });
            // mdBook's own have titles for an arrow.
            let mut ours = links.filter(|of| of.get("rel").is_some_and(|of| of == rel) && !of.contains_key("title"));
            ours.next().map(|of| of["href"].clone())
        };
        assert_eq!(leads("prev").as_ref(), at.checked_sub(1).map(|before| &order[before]), "{name}");
        assert_eq!(leads("next").as_ref(), order.get(at + 1), "{name}");
    }
}

#[test]
fn code_is_as_it_is_typed() {
    for (name, page) in pages() {
        for code in within(page, "code").into_iter().map(text) {
            let made = ["–", "—", "“", "”", "‘", "’"].into_iter().find(|sign| code.contains(sign));
            assert_eq!(made, None, "{name}: `{code}` has a sign that no keyboard has");
        }
    }
}

#[test]
fn formulas_are_there_without_scripts() {
    let files = files();
    let pin = String::from_utf8_lossy(&files["pin.html"]).into_owned();
    assert!(pin.matches("<math").count() > 30, "formulas are MathML");
    assert!(!pin.contains('$'), "a formula is left as it was typed");
    for script in files.keys().filter(|name| name.ends_with(".js")) {
        let text = String::from_utf8_lossy(&files[script]).to_lowercase();
        // What is packed says nothing in letters.
        let is_packed = text.len() > 300_000;
        assert!(is_packed || !text.contains("mathjax") && !text.contains("katex"), "{script} is loaded for formulas");
    }
}

/// A browser keeps a file of such a name for as long as it likes, and takes it for the same file in another edition.
#[test]
fn a_file_whose_name_has_a_fingerprint_is_named_by_its_content() {
    use sha2::{Digest, Sha256};
    let fingerprint = |name: &str| {
        let (stem, _) = name.rsplit('/').next()?.split_once('.')?;
        let digits = stem.rsplit_once('-')?.1;
        (digits.len() == 8 && digits.bytes().all(|digit| digit.is_ascii_hexdigit())).then(|| digits.to_owned())
    };
    let named: Vec<_> = files().iter().filter_map(|(name, bytes)| Some((name, fingerprint(name)?, bytes))).collect();
    assert!(named.len() > 10, "only {} files have a fingerprint", named.len());
    for (name, digits, bytes) in named {
        let hash: String = Sha256::digest(bytes).iter().take(4).map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(digits, hash, "{name} is named by another content");
    }
}
