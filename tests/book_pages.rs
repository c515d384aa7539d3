//! Do the rendered pages hold together? Builds the book and looks at what a reader would get.

use scraper::{Html, Selector};
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use tempfile::TempDir;

/// What a page may weigh with everything that it loads, in bytes.
const HEAVIEST: usize = 300_000;

/// The book, built once for all tests of this file.
fn book() -> &'static Path {
    static BOOK: OnceLock<(TempDir, PathBuf)> = OnceLock::new();
    &BOOK.get_or_init(built).1
}

fn built() -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("a folder");
    let out = folder.path().join("book");
    geneva_press::building::build(&crate::path("."), &out, geneva_press::Geneva).expect("the book builds");
    (folder, out)
}

/// All files of a built book by their path in it.
fn contents(out: &Path) -> BTreeMap<String, Vec<u8>> {
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

fn pages() -> Vec<(String, Html)> {
    let files = contents(book());
    let pages = files.into_iter().filter(|(name, _)| name.ends_with(".html") && name != "toc.html");
    pages.map(|(name, bytes)| (name, Html::parse_document(&String::from_utf8(bytes).expect("UTF-8")))).collect()
}

/// The values of an attribute over all elements that have it.
fn attribute(page: &Html, selector: &str, name: &str) -> Vec<String> {
    let selector = Selector::parse(selector).expect("a selector");
    page.select(&selector).filter_map(|element| element.attr(name)).map(str::to_owned).collect()
}

fn ids(page: &Html) -> Vec<String> {
    attribute(page, "[id]", "id")
}

#[test]
fn links_and_fragments_lead_somewhere() {
    let pages: BTreeMap<_, _> = pages().into_iter().collect();
    for (name, page) in &pages {
        for link in attribute(page, "a[href]", "href") {
            if link.starts_with("http") {
                continue;
            }
            let (file, fragment) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() { name.as_str() } else { file };
            let there = pages.get(target).unwrap_or_else(|| panic!("{name}: no page {target}"));
            let found = fragment.is_empty() || ids(there).iter().any(|id| id == fragment);
            assert!(found, "{name}: {target} has no #{fragment}");
        }
    }
}

#[test]
fn ids_are_unique_on_a_page() {
    for (name, page) in pages() {
        let mut seen = HashSet::new();
        for id in ids(&page) {
            assert!(seen.insert(id.clone()), "{name}: #{id} stands twice");
        }
    }
}

#[test]
fn no_placeholder_is_left() {
    for (name, page) in pages() {
        let main = Selector::parse("main").expect("a selector");
        let text: String = page.select(&main).flat_map(|main| main.text()).collect();
        assert!(
            !text.contains("{{"),
            "{name}: {}",
            &text[text.find("{{").unwrap_or(0)..].chars().take(60).collect::<String>()
        );
    }
}

/// What a page loads by itself: style, scripts, pictures, fonts named in its style.
fn loaded(page: &Html, files: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let mut names = attribute(page, "link[rel=stylesheet][href], link[rel~=icon][href]", "href");
    names.extend(attribute(page, "script[src]", "src"));
    names.extend(attribute(page, "img[src], image[href], use[href], iframe[src], video[src], audio[src]", "src"));
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
    let files = contents(book());
    for (name, page) in pages() {
        for file in loaded(&page, &files) {
            assert!(!file.contains("://") && !file.starts_with("//"), "{name} loads {file}");
            assert!(files.contains_key(&file), "{name} loads {file}, which is not in the book");
        }
    }
}

#[test]
fn a_page_is_not_too_heavy() {
    // With every font that its style names, though a browser loads only those that the page uses.
    let files = contents(book());
    for (name, page) in pages() {
        let weight: usize =
            files[&name].len() + loaded(&page, &files).iter().map(|file| files[file].len()).sum::<usize>();
        assert!(weight < HEAVIEST, "{name} weighs {weight} bytes; {HEAVIEST} are allowed");
    }
}

#[test]
fn two_builds_give_the_same_bytes() {
    let (_folder, again) = built();
    let (first, second) = (contents(book()), contents(&again));
    assert_eq!(first.keys().collect::<Vec<_>>(), second.keys().collect::<Vec<_>>());
    for (name, bytes) in &first {
        assert!(*bytes == second[name], "{name} differs between two builds");
    }
}

#[test]
fn figures_have_a_number_a_caption_and_words_for_those_who_do_not_see_them() {
    let mut shown = 0;
    for (name, page) in pages() {
        for figure in page.select(&Selector::parse("figure.fig").expect("a selector")) {
            let part = |selector: &str| {
                let selector = Selector::parse(selector).expect("a selector");
                figure.select(&selector).next().map(|element| element.text().collect::<String>()).unwrap_or_default()
            };
            assert!(part("figcaption").starts_with("Figure ") && part("figcaption").len() > 20, "{name}");
            assert!(part("svg > title").len() > 5 && part("svg > desc").len() > 40, "{name}: {}", part("svg > desc"));
            shown += 1;
        }
    }
    assert_eq!(shown, geneva_press::drawings::NAMES.len());
}

#[test]
fn formulas_are_there_without_scripts() {
    let files = contents(book());
    let pin = String::from_utf8_lossy(&files["pin.html"]).into_owned();
    assert!(pin.matches("<math").count() > 30, "formulas are MathML");
    assert!(!pin.contains('$'), "a formula is left as it was typed");
    for script in files.keys().filter(|name| name.ends_with(".js")) {
        let text = String::from_utf8_lossy(&files[script]).to_lowercase();
        assert!(!text.contains("mathjax") && !text.contains("katex"), "{script} is loaded for formulas");
    }
}
