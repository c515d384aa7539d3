//! Is the margin of a wide window used for what it is there for, and left alone where there is none?

use super::devtools::{Browser, Medium};
use super::{WIDE, address};
use serde_json::json;

/// What tells whether two boxes lie over each other.
const BOXES: &str = "const box = of => of.getBoundingClientRect(); const meet = (a, b) => Math.min(a.right, b.right) - \
     Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1";

fn open(browser: &mut Browser, width: u32, page: &str) {
    browser.show(width, Medium::Light);
    browser.open(&format!("{}/{page}.html", address(crate::book_pages::book())));
}

#[test]
fn the_sections_of_a_page_stand_beside_its_text_and_give_way_to_what_is_wider() {
    let Some(mut browser) = Browser::start() else { return };
    for width in [WIDE, 1920] {
        for page in ["pin", "runs", "making", "never-printed"] {
            open(&mut browser, width, page);
            let listed = "[...document.querySelectorAll('.sections a')].map(of => of.hash)";
            let headings = "[...document.querySelectorAll('main > h2[id]')].map(of => `#${of.id}`)";
            assert_eq!(browser.evaluate(listed), browser.evaluate(headings), "{page} at {width}");
            // From the first screen to the last, the list is hidden or covers nothing of the text.
            let covering = browser.evaluate(&format!(
                "(async () => {{ {BOXES}; const list = document.querySelector('.sections'), found = []; let seen = 0; \
                 const frame = () => new Promise(requestAnimationFrame); \
                 for (let at = 0; at < document.documentElement.scrollHeight; at += innerHeight / 2) {{ \
                 scrollTo({{ top: at, behavior: 'instant' }}); await frame(); await frame(); \
                 if (!list.checkVisibility({{ visibilityProperty: true }})) {{ continue }} seen += 1; \
                 for (const of of document.querySelectorAll('main :is(p, li, svg, td, pre, figcaption, h2)')) {{ \
                 if (of.checkVisibility() && meet(box(of), box(list))) {{ found.push(`${{at}}: ${{of.localName}}`) }} }} }} \
                 return [seen > 2, found] }})()"
            ));
            assert_eq!(covering, json!([true, []]), "{page} at {width}");
        }
    }
    open(&mut browser, WIDE - 1, "pin");
    assert_eq!(browser.evaluate("document.querySelector('.sections').checkVisibility()"), json!(false));
}

#[test]
fn a_note_and_a_caption_of_a_wide_window_are_beside_the_text() {
    let Some(mut browser) = Browser::start() else { return };
    open(&mut browser, WIDE, "runs");
    let beside = browser.evaluate(&format!(
        "(() => {{ {BOXES}; const mark = document.querySelector('main > p .mark'), text = box(mark.closest('p')); \
         mark.scrollIntoView({{ block: 'center', behavior: 'instant' }}); mark.click(); \
         const note = box(document.querySelector('.note:popover-open')); \
         const figure = document.querySelector('main > .fig:not(.live, .long)'), caption = box(figure.querySelector('figcaption')); \
         return [note.left >= text.right - 4, note.top <= box(mark).bottom && note.bottom >= box(mark).top && note.top >= 0 && note.bottom <= innerHeight, caption.left >= \
         box(figure.querySelector('svg')).right] }})()"
    ));
    assert_eq!(beside, json!([true, true, true]));
}
