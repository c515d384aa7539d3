//! Can the whole book be printed? Looks at its one document, and has a browser print it.

use crate::book_pages::{Piece, book, pages, text, within};
use crate::browser::devtools::{Browser, Medium};
use geneva_chapters::BOOK;
use geneva_press::pages::PagePlace;
use geneva_press::print::{FILE, numbers};
use serde_json::json;
use std::collections::HashSet;

/// How many sheets of A4 the book may fill.
const SHEETS: std::ops::RangeInclusive<usize> = 100..=230;
/// What a sheet of A4 leaves between the margins, in pixels of 1/96 inch: width, and height.
const BETWEEN_MARGINS: [u32; 2] = [673, 986];

/// The values of an attribute in the document.
fn values<'a>(document: &'a [Piece], name: &'a str) -> impl Iterator<Item = &'a str> {
    document.iter().filter_map(move |piece| match piece {
        Piece::Start { attributes, .. } => attributes.get(name).map(String::as_str),
        _ => None,
    })
}

#[test]
fn every_chapter_is_in_the_document_and_in_its_contents() {
    let document = &pages()[FILE];
    let ids: HashSet<_> = values(document, "id").collect();
    let contents: Vec<_> = values(document, "data-page-of").collect();
    let read = BOOK.pages.iter().filter(|page| page.place != PagePlace::Behind).map(|page| page.name);
    for name in read.chain(["mimic"]) {
        assert!(ids.contains(name) && contents.contains(&name), "{name} is not there");
    }
    for name in ["ledger", "coverage"] {
        assert!(!ids.contains(name) && !contents.contains(&name), "{name} is there");
    }
    // Each section of a chapter's own page has a line.
    for (name, page) in pages().iter().filter(|(name, _)| contents.contains(&name.trim_end_matches(".html"))) {
        for heading in within(page, "h2") {
            let Some(Piece::Start { attributes, .. }) = heading.first() else { continue };
            let Some(id) = attributes.get("id") else { continue };
            let id = format!("{}--{id}", name.trim_end_matches(".html"));
            assert!(ids.contains(&*id) && contents.contains(&&*id), "{id} has no line in the contents");
        }
    }
    // Nothing is folded, and nothing is left to be pressed.
    let is =
        |element: &str| document.iter().any(|of| matches!(of, Piece::Start { element: name, .. } if name == element));
    assert!(is("details") && !is("button") && !is("input") && !is("script"));
    let closed = |of: &&Piece| matches!(of, Piece::Start { element, attributes } if element == "details" && !attributes.contains_key("open"));
    assert_eq!(document.iter().filter(closed).count(), 0);
}

#[test]
fn every_figure_and_table_of_a_chapter_is_in_the_document_whole() {
    let captions = |page: &[Piece]| within(page, "figcaption").into_iter().map(text).collect::<Vec<_>>();
    let printed = captions(&pages()[FILE]);
    let mut count = 0;
    for (name, page) in pages() {
        let place = BOOK.pages.iter().find(|page| format!("{}.html", page.name) == *name).map(|page| page.place);
        if place.is_none_or(|place| place == PagePlace::Behind) {
            continue;
        }
        for caption in captions(page) {
            // Behind it is the link to its numbers.
            let (said, _) = caption.split_once("Data (CSV)").expect("a link to the numbers");
            assert!(printed.iter().any(|of| of.trim() == said.trim()), "{name}: {said}");
            count += 1;
        }
    }
    assert!(count > 80, "{count} figures and tables");
}

#[test]
fn a_browser_prints_it_with_the_numbers_of_the_pages_and_cuts_no_figure() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(BETWEEN_MARGINS[0], Medium::Paper);
    browser.open(&format!("file://{}/{FILE}", book().display()));

    // A figure that is higher than a page would be cut.
    let tall = format!(
        "[...document.querySelectorAll('main .fig')].filter(of => of.getBoundingClientRect().height > {}).map(of => of.id)",
        BETWEEN_MARGINS[1]
    );
    assert_eq!(browser.evaluate(&tall), json!([]), "these figures are higher than a page");
    let broken =
        "[...document.querySelectorAll('main .fig')].filter(of => getComputedStyle(of).breakInside !== 'avoid').length";
    assert_eq!(browser.evaluate(broken), json!(0), "figures that may be cut");
    let wide = "[...document.querySelectorAll('main :is(figure, table, p, math, pre, svg)')].filter(of => of.checkVisibility() && \
                of.getBoundingClientRect().right > innerWidth + 1).map(of => of.id || of.textContent.slice(0, 60))";
    assert_eq!(browser.evaluate(wide), json!([]), "these reach over the margin");

    // The file without numbers in its contents tells them.
    let file = browser.print();
    let places = numbers::places(&file).expect("the places of the contents");
    for id in values(&pages()[FILE], "data-page-of") {
        assert!(places.contains_key(id), "{id} is on no page");
    }
    let count = numbers::pages(&file).expect("pages");
    assert!(SHEETS.contains(&count), "{count} sheets");
    let chapters: Vec<_> = BOOK.pages.iter().filter_map(|page| places.get(page.name)).collect();
    assert!(chapters.is_sorted() && chapters.len() > 20, "chapters are not in their order: {chapters:?}");

    // With them nothing has another height or another font, so nothing moves to another page. To print it again would say the
    // same in seven times as long.
    let heights = "[...document.querySelectorAll('body, body *')].map(of => of.getBoundingClientRect().height).join()";
    let before = browser.evaluate(heights);
    let strange = browser.evaluate(&format!(
        "{{ const places = {}; [...document.querySelectorAll('[data-page-of]')].filter(of => {{ of.textContent = \
         places[of.dataset.pageOf]; return getComputedStyle(of).font !== getComputedStyle(of.parentElement).font }}).length }}",
        json!(places)
    ));
    assert_eq!(strange, json!(0), "numbers in a font of their own");
    assert!(browser.evaluate(heights) == before, "the numbers move the pages");

    // Every font is in the file: one that is not has a descriptor without a program.
    let text = String::from_utf8_lossy(&file);
    let fonts = text.matches("/Type /FontDescriptor").count();
    let inside =
        ["/FontFile2 ", "/FontFile3 ", "/FontFile "].map(|key| text.matches(key).count()).iter().sum::<usize>();
    let drawn = text.matches("/Subtype /Type3").count();
    assert!(fonts > 0 && inside + drawn >= fonts, "{fonts} fonts, {inside} of them inside and {drawn} drawn");
    assert!(text.contains("/Outlines "), "no outline");
}
