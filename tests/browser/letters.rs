//! Does a letter of a formula light up what it stands for? Touches each letter of each page by the mouse, and the row of letters
//! below a drawing by keyboard.

use super::devtools::{Browser, Medium};
use super::{WIDE, address};
use geneva_figures::notation::NOTATION;
use serde_json::{Value, json};

/// Pages with a drawing of the triangle: there its lengths and angles light up.
const PAGES: [&str; 5] = ["pin", "jazar", "quick-return", "escapement", "glossary"];
const OF_THE_TRIANGLE: [&str; 5] = ["R", "r", "l", "θ", "φ"];

/// Where the mouse rests when no part of the page is touched.
const AWAY: [i32; 2] = [-10, -10];

fn strings(value: &Value) -> Vec<String> {
    value.as_array().into_iter().flatten().filter_map(|of| of.as_str().map(str::to_owned)).collect()
}

/// The mouse in the middle of what stands at `letter` in the page's list of these. The page scrolls only where it has to: what it
/// shows then is painted anew.
fn point(browser: &mut Browser, number: usize) {
    let place = browser.evaluate(&format!(
        "{{ const of = firsts[{number}], at = of.getBoundingClientRect(); if (at.top < 100 || at.bottom > innerHeight - 100) {{ \
         of.scrollIntoView({{ block: 'center', behavior: 'instant' }}) }} const box = of.getBoundingClientRect(); [box.left + \
         box.width / 2, box.top + box.height / 2] }}"
    ));
    browser.command("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": place[0], "y": place[1] }));
}

/// What is lit: the letters of the parts, the number of their drawings, and whether that is the nearest one that has the letter.
const LIT: &str = "(letter => { const lit = [...document.querySelectorAll('svg .lit')]; const middle = of => { const box = \
     of.getBoundingClientRect(); return box.top + box.height / 2 }; const away = of => Math.abs(middle(of) - middle(letter)); \
     const name = letter.dataset.letter; const all_having = [...document.querySelectorAll('main .fig svg')].filter(svg => \
     [...svg.querySelectorAll('[data-letter]')].some(of => of.dataset.letter === name)); const having = \
     all_having.filter(svg => svg.checkVisibility()); \
     const own = having.sort((one, other) => away(one) - away(other))[0]; const all = own && \
     [...own.querySelectorAll('[data-letter]')].filter(of => of.dataset.letter === name); return { name, lit: lit.map(of => \
     of.dataset.letter), wrong: lit.filter(of => of.ownerSVGElement !== own).length, missing: (all || []).filter(of => \
     !of.matches('.lit')).length, shapes: own ? lit.filter(of => of.localName !== 'text').length : Math.min(all_having.length, 1) } })";

/// Touches each letter of the open page: at which letters something is wrong, and what.
pub(super) fn touch(browser: &mut Browser, page: &str) -> Vec<(String, String)> {
    let mut wrong = Vec::new();
    // The first and the last place of each letter that is on the screen.
    let count = browser.evaluate(
        "globalThis.firsts = [...Map.groupBy([...document.querySelectorAll('main math [data-letter]')].filter(of => \
         of.checkVisibility()), of => of.dataset.letter).values()].flatMap(all => [all[0], all.at(-1)]); firsts.length",
    );
    let mut names = Vec::new();
    for number in 0..count.as_u64().expect("a number") as usize {
        point(browser, number);
        let lit = browser.evaluate(&format!("{LIT}(firsts[{number}])"));
        let name = lit["name"].as_str().expect("a letter").to_owned();
        let is_own = strings(&lit["lit"]).iter().all(|of| *of == name);
        if !is_own || [&lit["wrong"], &lit["missing"]] != [&json!(0), &json!(0)] {
            wrong.push((name.clone(), format!("lights something else than its parts in the nearest drawing: {lit}")));
        }
        if lit["shapes"].as_u64() < Some(1) {
            wrong.push((name.clone(), format!("lights nothing but words: {lit}")));
        }
        names.push(name);
    }
    for at in [[2, 2], AWAY] {
        browser.command("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": at[0], "y": at[1] }));
        if browser.evaluate("document.querySelectorAll('.lit').length") != json!(0) {
            wrong.push(("page".to_owned(), "a letter stays lit".to_owned()));
        }
    }
    if PAGES.iter().any(|name| page.strip_suffix(".html") == Some(*name)) {
        let missing = OF_THE_TRIANGLE.into_iter().filter(|letter| !names.iter().any(|name| name == letter));
        wrong.extend(missing.map(|letter| (letter.to_owned(), "no part of a drawing is named by it".to_owned())));
    }
    wrong
}

#[test]
fn touching_a_letter_lights_its_part_in_the_nearest_drawing_and_no_other() {
    super::assert_none_of_the_book("letter");
}

#[test]
fn a_button_opens_the_row_of_letters_which_is_one_stop_of_the_tab_key_and_arrows_go_along_it() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(WIDE, Medium::Light);
    browser.open(&format!("{}/pin.html", address(crate::book_pages::book())));
    let known =
        browser.evaluate("[...document.querySelectorAll('#fig-pin-position .letters input')].map(of => of.value)");
    let known = strings(&known);
    let parts: Vec<&str> = NOTATION.iter().map(|letter| letter.part).filter(|part| !part.is_empty()).collect();
    assert!(known[0].is_empty() && known[1..].iter().all(|letter| parts.contains(&letter.as_str())), "{known:?}");
    // The stop before the button, which opens the row, and then as many as there are stops in it.
    browser.evaluate("{ const at = document.querySelector('#fig-pin-position svg'); at.tabIndex = 0; at.focus() }");
    let focused = "[document.activeElement.type ?? '', document.activeElement.value ?? '']";
    browser.press("Tab", 9);
    assert_eq!(browser.evaluate("document.activeElement.matches('.letters > summary')"), json!(true));
    let is_shown = "document.querySelector('#fig-pin-position .letters input').checkVisibility()";
    assert_eq!(browser.evaluate(is_shown), json!(false));
    browser.command(
        "Input.dispatchKeyEvent",
        json!({ "type": "keyDown", "key": "Enter", "text": "\r", "windowsVirtualKeyCode": 13 }),
    );
    assert_eq!(browser.evaluate(is_shown), json!(true));
    browser.press("Tab", 9);
    assert_eq!(browser.evaluate(focused), json!(["radio", ""]));
    browser.press("ArrowRight", 39);
    assert_eq!(browser.evaluate(focused), json!(["radio", known[1]]));
    let lit = "[...new Set([...document.querySelectorAll('svg .lit')].map(of => of.dataset.letter))]";
    assert_eq!(browser.evaluate(lit), json!([known[1]]));
    browser.press("Tab", 9);
    assert_ne!(browser.evaluate("document.activeElement.type ?? ''"), json!("radio"), "a stop for each letter");
    assert_eq!(browser.evaluate(lit), json!([known[1]]), "what was chosen stays");
    // A tap on the letter in the text takes the choice back, another chooses it.
    let tap = format!(
        "{{ [...document.querySelectorAll('.problem math [data-letter]')].find(of => of.dataset.letter === {}).dispatchEvent(new \
         MouseEvent('click', {{ bubbles: true }})); [document.querySelector('#fig-pin-position .letters :checked').value, \
         document.querySelectorAll('svg .lit').length > 0] }}",
        json!("R")
    );
    assert_eq!(browser.evaluate(&tap), json!(["R", true]));
    assert_eq!(browser.evaluate(&tap), json!(["", false]));
}
