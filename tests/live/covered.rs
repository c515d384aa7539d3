//! Does a drawing that stays in view while the controls scroll by hide what a reader has scrolled to, or a control wherever
//! the reader scrolls?

use super::{PAGES, browser, of, open};
use crate::browser::devtools::{Browser, Medium};
use serde_json::{Value, json};

/// The places of scrolling at which another element is where the caption is, with that element's class.
const COVERED: &str = "(async () => { const found = []; const caption = f.querySelector('figcaption'); \
     for (const from of [700, 500, 300, 150]) { scrollTo({ top: caption.getBoundingClientRect().top + scrollY - from, behavior: \
     'instant' }); await new Promise(requestAnimationFrame); const { left, right, top, bottom } = caption.getBoundingClientRect(); \
     for (const x of [left + 8, left + (right - left) / 4, (left + right) / 2]) { const hit = document.elementFromPoint(x, (top + bottom) / 2); \
     if (hit && !caption.contains(hit) && !hit.contains(caption)) { found.push(`${from}: ${hit.className || hit.localName}`) } } } \
     return found })()";

#[test]
fn a_drawing_that_stays_leaves_its_caption_in_sight() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Light);
    for (name, page) in PAGES {
        open(&mut browser, page, "");
        let covered = of(&mut browser, name, &format!("await {COVERED}"));
        assert_eq!(covered, json!([]), "{name}");
    }
}

/// Pixels of scrolling over which a control must be within reach.
const REACH: u32 = 88;

/// The fields, buttons and links of a figure whose middle is hit over less scrolling than that, with the pixels over which it is.
const OUT_OF_REACH: &str = "(async () => { const found = []; for (const of of g.querySelectorAll('input, select, button, a')) { \
     const inside = of.closest('details'); inside && g.querySelectorAll('details').forEach(fold => fold.open = fold === inside); \
     of.scrollIntoView({ block: 'nearest', behavior: 'instant' }); const { top, height } = of.getBoundingClientRect(), middle = top + scrollY + height / 2; let reach = 0; \
     for (let at = Math.max(0, middle - innerHeight); at < middle; at += 8) { scrollTo({ top: at, behavior: 'instant' }); \
     const { left, right, top, bottom } = of.getBoundingClientRect(); const hit = document.elementFromPoint((left + right) / 2, \
     (top + bottom) / 2); if (hit && of.contains(hit)) { reach += 8 } } \
     if (reach < least) { found.push(`${of.name || of.dataset.box || of.textContent}: ${reach}`) } } return found })()";

#[test]
fn every_control_can_be_reached_on_a_low_screen() {
    let Some(mut browser) = browser() else { return };
    // Phones upright, with a browser's bars and with a keyboard; a phone on its side; a low window with controls beside the drawing.
    for window in [[390, 664], [390, 560], [375, 553], [390, 400], [844, 390], [1024, 600]] {
        browser.show_in(window, Medium::Light);
        for (name, page) in PAGES {
            open(&mut browser, page, "");
            let hidden =
                of(&mut browser, name, &format!("(() => {{ const least = {REACH}; return {OUT_OF_REACH} }})()"));
            assert_eq!(hidden, json!([]), "{name} at {window:?}");
        }
    }
}

/// A picture of what is before a figure, as far as it is in sight.
fn picture(browser: &mut Browser, name: &str) -> Value {
    let place = of(
        browser,
        name,
        "(() => { const { left, right, top, bottom } = f.previousElementSibling.getBoundingClientRect(); return [left, Math.max(top, \
         80), right - left, bottom - Math.max(top, 80)] })()",
    );
    let clip = json!({ "x": place[0], "y": place[1], "width": place[2], "height": place[3], "scale": 1 });
    browser.command("Page.captureScreenshot", json!({ "format": "png", "clip": clip }))["data"].clone()
}

#[test]
fn nothing_of_a_figure_is_painted_over_what_is_before_it() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Dark);
    for (name, page) in PAGES {
        open(&mut browser, page, "");
        of(&mut browser, name, "scrollTo({ top: f.getBoundingClientRect().top + scrollY - 400, behavior: 'instant' })");
        let with = picture(&mut browser, name);
        of(&mut browser, name, "f.style.visibility = 'hidden'");
        assert!(with.as_str().is_some_and(|data| data.len() > 100), "{name}: no picture");
        assert!(with == picture(&mut browser, name), "{name} is painted over what is before it");
    }
}
