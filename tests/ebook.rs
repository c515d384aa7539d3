//! Can the whole book be read in an ebook? Opens the file, and looks at each document in it.

use crate::book_pages::{book, pages, text, within};
use geneva_chapters::BOOK;
use geneva_press::epub;
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;

/// The texts of all files in the ebook by their paths.
fn files() -> BTreeMap<String, String> {
    let file = std::fs::File::open(book().join(epub::file(&BOOK))).expect("the ebook");
    let mut archive = zip::ZipArchive::new(file).expect("an archive");
    let mut files = BTreeMap::new();
    for at in 0..archive.len() {
        let mut file = archive.by_index(at).expect("a file");
        let mut text = String::new();
        file.read_to_string(&mut text).expect("text");
        files.insert(file.name().to_owned(), text);
    }
    files
}

fn parsed(text: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).expect("well-formed")
}

/// The elements of this name, by their names without name spaces.
fn elements<'a, 'i: 'a>(document: &'a Document<'i>, name: &'a str) -> impl Iterator<Item = Node<'a, 'i>> {
    document.descendants().filter(move |node| node.is_element() && node.tag_name().name() == name)
}

fn words(node: Node<'_, '_>) -> String {
    node.descendants().filter_map(|of| of.text().filter(|_| of.is_text())).collect()
}

#[test]
fn every_document_of_the_ebook_is_sound_and_every_link_in_it_leads_somewhere() {
    let files = files();
    let documents: BTreeMap<_, _> = files
        .iter()
        .filter(|(path, _)| path.ends_with(".xhtml"))
        .map(|(path, text)| (path.trim_start_matches("EPUB/"), parsed(text)))
        .collect();
    let mut ids = BTreeMap::new();
    for (file, document) in &documents {
        let found: Vec<_> = document.descendants().filter_map(|node| node.attribute("id")).collect();
        let different: BTreeSet<_> = found.iter().copied().collect();
        assert_eq!(found.len(), different.len(), "{file} has an id twice");
        ids.insert(*file, different);
    }
    let mut count = 0;
    for (file, document) in &documents {
        let source = &files[&format!("EPUB/{file}")];
        assert!(!source.contains("{{") && !source.contains("<script"), "{file}");
        for attribute in document.descendants().flat_map(|node| node.attributes()) {
            let (name, value) = (attribute.name(), attribute.value());
            assert!(!name.starts_with("on"), "{file}: {name}");
            if !["href", "src"].contains(&name) || value.starts_with("https://") || value.starts_with("http://") {
                continue;
            }
            let (to, id) = value.split_once('#').unwrap_or((value, ""));
            let is_there = match ids.get(to) {
                Some(ids) => id.is_empty() || ids.contains(id),
                None => id.is_empty() && files.contains_key(&format!("EPUB/{to}")),
            };
            assert!(is_there, "{file}: nothing is at {value}");
            count += 1;
        }
    }
    assert!(count > 300, "{count} links");
}

#[test]
fn every_chapter_that_is_printed_is_in_the_ebook_and_nothing_is_without_a_place() {
    let files = files();
    let package = parsed(&files["EPUB/package.opf"]);
    let manifest: BTreeMap<_, _> = elements(&package, "item")
        .map(|item| (item.attribute("id"), item.attribute("href").expect("a file")))
        .collect();
    let listed: BTreeSet<_> = manifest.values().map(|file| format!("EPUB/{file}")).collect();
    let inside: BTreeSet<_> =
        files.keys().filter(|path| path.starts_with("EPUB/") && !path.ends_with(".opf")).cloned().collect();
    assert_eq!(listed, inside);
    let spine: Vec<_> = elements(&package, "itemref").map(|of| manifest[&of.attribute("idref")].to_owned()).collect();
    let chapters = BOOK.pages.iter().filter(|page| page.is_printed).map(|page| format!("{}.xhtml", page.name));
    let expected: Vec<_> = ["title.xhtml", "nav.xhtml"].map(str::to_owned).into_iter().chain(chapters).collect();
    assert_eq!(spine, expected);
    let contents = parsed(&files["EPUB/nav.xhtml"]);
    for file in &spine[2..] {
        assert!(elements(&contents, "a").any(|link| link.attribute("href") == Some(file)), "no line leads to {file}");
    }
}

#[test]
fn a_chapter_has_the_numbers_formulas_and_drawings_of_its_page() {
    let files = files();
    for name in ["runs", "jazar"] {
        let document = parsed(&files[&format!("EPUB/{name}.xhtml")]);
        let page = &pages()[&format!("{name}.html")];
        let spaced = |text: String| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let cells: Vec<_> = within(page, "td").into_iter().map(|cell| spaced(text(cell))).collect();
        let here: Vec<_> = elements(&document, "td").map(|cell| spaced(words(cell))).collect();
        assert!(!cells.is_empty() && cells == here, "{name}: the tables differ");
        for element in ["math", "svg", "figure"] {
            let count = elements(&document, element).count();
            assert!(count > 0, "{name} has no {element}");
        }
        for drawing in elements(&document, "svg") {
            let said = drawing.children().filter(|of| of.has_tag_name(("http://www.w3.org/2000/svg", "title")));
            assert!(said.map(words).any(|title| !title.is_empty()), "a drawing in {name} has no words");
            assert!(drawing.attribute("viewBox").is_some());
        }
    }
}
