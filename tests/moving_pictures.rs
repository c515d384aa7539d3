//! Do the drawings that move by themselves move, and can a reader stop each of them? In a browser: by keyboard alone, for a
//! reader who wants less motion, and on paper.

use crate::book_pages::{book, files};
use crate::browser::devtools::{Browser, Medium};
use serde_json::{Value, json};

/// What finds the moving drawings of the open page, in `all`: everything that is folded is opened, and `moves` says of each
/// whether its style has set anything going.
const FIND: &str = "document.querySelectorAll('details').forEach(of => of.open = true); \
     const all = [...document.querySelectorAll('main svg:has(style)')].filter(of => of.textContent.includes('@keyframes')); \
     const of = svg => svg.getAnimations({ subtree: true }); \
     const states = () => all.map(svg => [...new Set(of(svg).map(of => of.playState))].join());";

/// The pages with drawings that move by themselves, each with how many it has.
fn moving() -> Vec<(&'static str, usize)> {
    let pages = files().iter().filter(|(name, _)| name.ends_with(".html") && *name != geneva_press::print::FILE);
    let count = |text: &[u8]| String::from_utf8_lossy(text).split("<svg").filter(|of| of.contains("<style>")).count();
    pages.map(|(name, text)| (name.as_str(), count(text))).filter(|(_, count)| *count > 0).collect()
}

fn open(browser: &mut Browser, page: &str) {
    browser.open(&format!("file://{}/{page}", book().display()));
}

/// Has the open page shown on this medium to a reader who wants less motion or doesn't mind.
fn want(browser: &mut Browser, media: &str, motion: &str) {
    let features = json!([{ "name": "prefers-reduced-motion", "value": motion }]);
    browser.command("Emulation.setEmulatedMedia", json!({ "media": media, "features": features }));
}

fn evaluate(browser: &mut Browser, expression: &str) -> Value {
    browser.evaluate(&format!("(async () => {{ {FIND} {expression} }})()"))
}

/// Presses the space bar.
fn press_space(browser: &mut Browser) {
    for (kind, text) in [("keyDown", " "), ("keyUp", "")] {
        let event = json!({ "type": kind, "key": " ", "code": "Space", "text": text, "windowsVirtualKeyCode": 32 });
        browser.command("Input.dispatchKeyEvent", event);
    }
}

#[test]
fn the_first_page_and_two_chapters_have_drawings_that_move_by_themselves() {
    assert_eq!(moving(), [("index.html", 1), ("jazar.html", 1), ("preface.html", 1), ("timer.html", 2)]);
}

#[test]
fn every_such_drawing_moves_on_a_screen_and_stands_still_for_who_wants_less_motion_and_on_paper() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(1280, Medium::Light);
    for (page, count) in moving() {
        open(&mut browser, page);
        let boxes = "all.map(svg => svg.parentElement.querySelectorAll(':scope > .pause').length)";
        assert_eq!(evaluate(&mut browser, &format!("return {boxes}")), json!(vec![1; count]), "{page}");
        want(&mut browser, "screen", "no-preference");
        // Something in each drawing comes to be elsewhere, from frame to frame.
        let goes_on = "const places = svg => [...svg.querySelectorAll('g, path')].map(of => getComputedStyle(of).transform).join(); \
                       const first = all.map(places), frame = () => new Promise(requestAnimationFrame); \
                       for (const [k, svg] of all.entries()) { while (places(svg) === first[k]) { await frame() } } \
                       return states()";
        assert_eq!(evaluate(&mut browser, goes_on), json!(vec!["running"; count]), "{page}");
        for (media, motion) in [("screen", "reduce"), ("print", "no-preference")] {
            want(&mut browser, media, motion);
            let still =
                "return [states(), all.map(svg => svg.parentElement.querySelector('.pause').checkVisibility())]";
            let expected = json!([vec![""; count], vec![false; count]]);
            assert_eq!(evaluate(&mut browser, still), expected, "{page}, {media}, {motion}");
        }
    }
}

#[test]
fn a_reader_with_a_keyboard_stops_each_drawing_by_itself_and_sets_it_going_again() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(390, Medium::Light);
    for (page, count) in moving() {
        open(&mut browser, page);
        want(&mut browser, "screen", "no-preference");
        for k in 0..count {
            // From the last thing before the drawing that takes the focus, one press of the Tab key leads to the box.
            let before = "const boxes = [...document.querySelectorAll('main :is(a[href], button, input, select, summary)')] \
                          .filter(of => of.checkVisibility()); \
                          const box = all[K].parentElement.querySelector('.pause input'); boxes[boxes.indexOf(box) - 1].focus(); \
                          const { width, height } = box.getBoundingClientRect(); return width >= 24 && height >= 24";
            let is_large = evaluate(&mut browser, &before.replace('K', &k.to_string()));
            assert_eq!(is_large, json!(true), "{page}: the box is too small for a finger");
            browser.press("Tab", 9);
            let focused = "return [document.activeElement.matches('.pause > input'), document.activeElement.labels[0].textContent.trim()]";
            assert_eq!(evaluate(&mut browser, focused), json!([true, "Pause"]), "{page}");
            let expected = |this: &'static str| {
                let states: Vec<_> = (0..count).map(|one| if one == k { this } else { "running" }).collect();
                json!(states)
            };
            for state in ["paused", "running"] {
                press_space(&mut browser);
                assert_eq!(evaluate(&mut browser, "return states()"), expected(state), "{page}");
            }
        }
    }
}
