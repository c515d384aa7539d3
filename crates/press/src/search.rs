//! The search: what of a book is searched, how much it weighs, and the script that searches.
//!
//! mdBook's own index takes formulas, drawings and code for words, and its script listens to keys alone. So both give way to
//! ours; mdBook's field and list of results stay. The index is the text that a reader reads, and the script finds the words in
//! it when it has loaded it.
//!
//! A chapter explains a word and a record only repeats it, so chapters come first. A claim is found by its id all the same:
//! what a title says exactly comes before all else.

mod entries;

use crate::book::Book;
use crate::cache::Shelf;
use crate::citing;
use crate::pages::PageRole;
use crate::synonyms::Synonym;
use anyhow::{Context, ensure};
use entries::{Entry, EntryKind, entries};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The script.
const SCRIPT: &str = include_str!("../theme/search.js");
/// Of mdBook's files, by the beginnings of their names: the index and the script, which give way, and what the script uses.
const INDEX: &str = "searchindex";
const SEARCHER: &str = "searcher";
const NOT_NEEDED: [&str; 2] = ["elasticlunr", "mark"];

/// Puts the search into a book that is built in a folder. One without an index, which its settings may want, is left alone.
pub(crate) fn write(book: &Book, folder: &Path, shelf: &Shelf) -> anyhow::Result<()> {
    let files = files(folder)?;
    let named = |start: &str| files.iter().find(|file| is_script(file, start));
    let (Some(index), Some(searcher)) = (named(INDEX), named(SEARCHER)) else { return Ok(()) };
    let write =
        |file: &Path, text: String| fs::write(file, text).with_context(|| format!("cannot write {}", file.display()));
    let pages: Vec<&PathBuf> = files.iter().filter(|file| name(file).ends_with(".html")).collect();
    let json = indexed(book, &pages, shelf)?.to_string();
    write(index, format!("genevaIndex('{}');\n", json.replace('\\', "\\\\").replace('\'', "\\'")))?;
    write(searcher, SCRIPT.to_owned())?;
    for file in NOT_NEEDED.into_iter().filter_map(named) {
        fs::remove_file(file).with_context(|| format!("cannot remove {}", file.display()))?;
        let loading = format!("<script src=\"{}\"></script>", name(file));
        for page in &pages {
            let html = fs::read_to_string(page).with_context(|| format!("cannot read {}", page.display()))?;
            write(page, html.replace(&loading, ""))?;
        }
    }
    Ok(())
}

/// The index as the script reads it: the book's title; pages with theirs; entries, each with the place of its page, anchor, title, text,
/// text that counts little, and weight; synonyms.
fn indexed(book: &Book, pages: &[&PathBuf], shelf: &Shelf) -> anyhow::Result<Value> {
    let asking: Vec<&str> = book.modules.iter().map(|module| module.asking()).collect();
    let (mut titles, mut all, mut words) = (Vec::new(), Vec::new(), BTreeSet::new());
    for page in pages {
        let name = name(page);
        // The first page stands under a second name, too.
        if ["index.html", "toc.html", "404.html", "print.html"].contains(&&*name) {
            continue;
        }
        let html = fs::read_to_string(page).with_context(|| format!("cannot read {}", page.display()))?;
        let found = known_entries(&html, &asking, shelf)?;
        let Some(first) = found.first() else { continue };
        let title = first.page.clone();
        for entry in found {
            let weight = weight(book, name.trim_end_matches(".html"), &entry);
            let Entry { id, title, body, little, .. } = entry;
            words.extend([&title, &body, &little].into_iter().flat_map(|text| searched_words(text)));
            all.push(json!([titles.len(), id, title, body, little, weight]));
        }
        titles.push(json!([name, title]));
    }
    ensure!(!all.is_empty(), "no page of the book has anything to search for");
    let synonyms: Vec<Value> = known(book.synonyms, &words).into_iter().map(|of| json!([of.typed, of.meant])).collect();
    Ok(json!({ "title": book.imprint.title, "pages": titles, "entries": all, "synonyms": synonyms }))
}

/// The entries of a page, which may come from a shelf.
fn known_entries(html: &str, asking: &[&str], shelf: &Shelf) -> anyhow::Result<Vec<Entry>> {
    // Nothing outside the text is searched, nor the edition at its foot.
    let text = html.find("<main").and_then(|at| html.get(at..)).unwrap_or_default();
    let text = text.rfind("</main>").and_then(|end| text.get(..end)).unwrap_or(text);
    let text = citing::without_foot(text);
    let texts = shelf.recall("entries", &[&text], || {
        let texts = entries(&text, asking).into_iter().map(|Entry { kind, page, id, title, body, little }| {
            [kind.name().to_owned(), page, id, title, body, little]
        });
        Ok(texts.flatten().collect())
    })?;
    let mut texts = texts.into_iter();
    let entry = std::iter::from_fn(|| {
        let kind = EntryKind::of_name(&texts.next()?);
        let [page, id, title, body] = [texts.next()?, texts.next()?, texts.next()?, texts.next()?];
        Some(Entry { kind, page, id, title, body, little: texts.next()? })
    });
    Ok(entry.collect())
}

/// The synonyms that lead to words of these pages; a book of a few chapters has no use for the others.
fn known<'a>(synonyms: &'a [Synonym], words: &BTreeSet<String>) -> Vec<&'a Synonym> {
    let is_known = |of: &str| searched_words(of).all(|word| words.contains(&word));
    synonyms.iter().filter(|synonym| synonym.meant.iter().all(|of| is_known(of))).collect()
}

/// How much what an entry says counts, beside a section of a chapter.
fn weight(book: &Book, page: &str, entry: &Entry) -> f64 {
    match entry.kind {
        EntryKind::Claim => 0.1,
        _ if book.page_of_role(PageRole::Glossary) == Some(page) => 0.4,
        _ if book.is_looked_up(page) => 0.15,
        EntryKind::Section | EntryKind::Figure => 1.0,
    }
}

/// The words of a text as the script cuts it, but for accents.
fn searched_words(text: &str) -> impl Iterator<Item = String> {
    text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_lowercase)
}

fn name(file: &Path) -> String {
    file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Whether this is the script with this name, with or without a fingerprint.
fn is_script(file: &Path, start: &str) -> bool {
    let name = name(file);
    name.ends_with(".js") && name.strip_prefix(start).is_some_and(|rest| rest.starts_with(['-', '.']))
}

fn files(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let mut files = entries.map(|entry| Ok(entry?.path())).collect::<std::io::Result<Vec<_>>>()?;
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;
    use tempfile::TempDir;

    /// A folder as mdBook leaves it, with these pages.
    fn built(pages: &[(&str, &str)]) -> TempDir {
        let folder = TempDir::new().expect("a folder");
        let scripts = [
            ("searchindex-0a0a0a0a.js", "its index"),
            ("searcher-0b0b0b0b.js", "its script"),
            ("elasticlunr-0c0c0c0c.min.js", ""),
            ("mark-0d0d0d0d.min.js", ""),
        ];
        for (name, text) in scripts.iter().chain(pages) {
            fs::write(folder.path().join(name), text).expect("written");
        }
        folder
    }

    #[test]
    fn the_books_index_and_script_take_the_place_of_mdbooks() {
        let page = "<script src=\"elasticlunr-0c0c0c0c.min.js\"></script><script src=\"mark-0d0d0d0d.min.js\"></script>\
                    <script src=\"searcher-0b0b0b0b.js\"></script><main><h1 id=\"f\">First</h1><p>it's “a\\b”</p></main>";
        let folder = built(&[("preface.html", page), ("index.html", page), ("ledger.html", page)]);
        write(&BOOK, folder.path(), &Shelf::empty()).expect("written");
        let names: Vec<_> = files(folder.path()).expect("files").iter().map(|file| name(file)).collect();
        assert_eq!(
            names,
            ["index.html", "ledger.html", "preface.html", "searcher-0b0b0b0b.js", "searchindex-0a0a0a0a.js"]
        );
        let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("read");
        assert!(read("preface.html").starts_with("<script src=\"searcher-0b0b0b0b.js\"></script><main>"));
        assert_eq!(read("searcher-0b0b0b0b.js"), SCRIPT);
        assert_eq!(
            read("searchindex-0a0a0a0a.js"),
            "genevaIndex('{\"entries\":[[0,\"\",\"First\",\"it\\'s “a\\\\\\\\b”\",\"\",0.15],[1,\"\",\"First\",\"it\\'s \
             “a\\\\\\\\b”\",\"\",1.0]],\"pages\":[[\"ledger.html\",\"First\"],[\"preface.html\",\"First\"]],\"synonyms\":[],\"title\":\"A sample\"}');\n"
        );
    }

    #[test]
    fn a_synonym_that_leads_nowhere_is_left_out() {
        let synonyms = [Synonym { typed: "calculator", meant: &["wheel", "Live figure"] }];
        let words = |all: &[&str]| all.iter().map(|word| (*word).to_owned()).collect::<BTreeSet<_>>();
        assert_eq!(known(&synonyms, &words(&["wheel", "live", "calculator"])).len(), 0);
        assert_eq!(known(&synonyms, &words(&["wheel", "live", "figure"])).len(), 1);
    }
}
