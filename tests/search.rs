//! Does the search lead where a reader wants to go? In a browser, with the page's own script: what five kinds of readers type,
//! and the words that come without a key, by pasting, dictating or a keyboard on the screen.

use crate::book_pages::book;
use crate::browser::devtools::{Browser, Medium};
use geneva_documents::LEDGER;
use serde_json::{Value, json};

/// How many results are seen at once.
const SEEN: usize = 3;

/// What is typed, and the pages or sections of which one must be among the first results. These are the searches of a review.
const REVIEWED: &[(&str, &[&str])] = &[
    ("pin velocity", &["pin.html#split", "pin.html#step-4-how-fast-the-pin-is"]),
    ("coriolis", &["quick-return.html#step-5-the-coriolis-acceleration"]),
    ("6 stations", &["jazar.html", "making.html#fig-wheel-dimensions"]),
    ("tolerance", &["making.html#tolerances"]),
    ("dwell time", &["making.html#a-wheel-with-a-given-dwell"]),
    ("indexing time", &["making.html#a-wheel-for-a-table", "making.html#a-wheel-with-a-given-dwell"]),
    ("cite", &["about.html#how-to-cite"]),
    ("rise time", &["runs.html#the-rise-times"]),
    ("maltese cross", &["jazar.html", "making.html", "preface.html"]),
    ("quick return ratio", &["quick-return.html"]),
    ("verge escapement", &["timer.html"]),
    ("locking disc size", &["making.html#crescent"]),
    ("how accurate is the clock", &["timer.html"]),
    ("dxf", &["making.html#a-wheel-for-a-table", "making.html#fig-wheel-dimensions"]),
    ("download dxf", &["making.html#fig-wheel-dimensions"]),
    ("calculator", &["making.html#fig-wheel-dimensions"]),
    ("geneva calculator", &["making.html#fig-wheel-dimensions"]),
    ("re-run", &["method.html#check-it-yourself", "preface.html#check-it-yourself"]),
    ("how to use this book", &["preface.html#where-to-start"]),
    ("angular acceleration of lever", &["quick-return.html"]),
    ("formula for acceleration", &["jazar.html"]),
];

/// What others would type.
const TYPED: &[(&str, &[&str])] = &[
    // A student.
    ("velocity diagram", &["quick-return.html#step-2-the-velocity-diagram"]),
    ("direction of coriolis acceleration", &["quick-return.html"]),
    ("why is the centre distance root 2", &["pin.html#centre-distance"]),
    ("check my homework", &["pin.html#your-numbers", "quick-return.html#your-numbers"]),
    // A maker.
    ("3d print", &["making.html"]),
    ("backlash", &["making.html#backlash"]),
    ("pin diameter", &["making.html#pin-slot-and-play"]),
    ("motor torque", &["making.html#loads"]),
    ("wear of the slot", &["making.html"]),
    ("worn wheel", &["making.html#replace-a-worn-wheel"]),
    ("keyway", &["making.html#mounting"]),
    // A horologist.
    ("isochronism", &["timer.html", "glossary.html#clocks-and-timers"]),
    ("beats per second", &["timer.html", "escapement.html", "terminal-speed.html"]),
    ("balance spring", &["timer.html"]),
    ("bearing friction", &["joints.html"]),
    // A researcher.
    ("bibtex", &["about.html#how-to-cite"]),
    ("raw data csv", &["about.html#the-data"]),
    ("likelihood", &["runs.html#likelihood"]),
    ("poincaré map", &["terminal-speed.html", "glossary.html#the-motion"]),
    // A sceptic.
    ("how often were you wrong", &["method.html#how-often-we-were-wrong"]),
    ("what is a verdict", &["method.html#what-a-verdict-means"]),
    ("the mistake in the program", &["program.html#the-angle-that-is-reset", "mistake.html"]),
];

/// Shows a page with the search open and its index there.
fn searching(browser: &mut Browser, page: &str) {
    browser.open(&format!("file://{}/{page}", book().display()));
    browser.press("/", 191);
    browser.evaluate("until(() => document.activeElement.id === 'mdbook-searchbar')");
}

/// Puts words into the field as a keyboard on the screen does: no key is pressed.
fn insert(browser: &mut Browser, words: &str) {
    browser.evaluate("document.getElementById('mdbook-searchbar').select()");
    browser.command("Input.insertText", json!({ "text": words }));
}

/// Where the results of these words lead, the first ones first.
fn results(browser: &mut Browser, words: &str) -> Vec<String> {
    insert(browser, words);
    let said = json!(format!("“{words}”"));
    let found = browser.evaluate(&format!(
        "until(() => document.getElementById('mdbook-searchresults-header').textContent.includes({said}) && \
         [...document.querySelectorAll('#mdbook-searchresults a')].map(link => link.pathname.split('/').pop() + link.hash))"
    ));
    found.as_array().into_iter().flatten().filter_map(Value::as_str).map(str::to_owned).collect()
}

#[test]
fn what_a_reader_wants_is_among_the_first_results() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(390, Medium::Light);
    searching(&mut browser, "pin.html");
    let mut missed = Vec::new();
    for (words, wanted) in REVIEWED.iter().chain(TYPED) {
        let found = results(&mut browser, words);
        let first = &found[..SEEN.min(found.len())];
        // A page stands for all its sections.
        let leads =
            |to: &String| wanted.iter().any(|of| to == of || !of.contains('#') && to.starts_with(&format!("{of}#")));
        if !first.iter().any(leads) {
            missed.push(format!("{words}: {first:?} instead of {wanted:?}"));
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn a_claim_is_found_by_its_id_and_a_chapter_before_the_records() {
    // A number that the handout prints, and its chapter shows.
    let number = LEDGER.claim("jazar.ex-e.ratio").expect("a claim").printed.trim_start_matches('±');
    let expected = [
        ("pin.slot-point-speed", "ledger.html#pin.slot-point-speed"),
        ("jazar.eq-5.29", "ledger.html#jazar.eq-5.29"),
        ("meyer.always-engaged", "ledger.html#meyer.always-engaged"),
        ("motor", "making.html"),
        ("law of cosines", "pin.html"),
        ("moment of inertia of a disc", "making.html"),
        ("RMS torque", "making.html"),
        ("contact stress", "making.html"),
        (number, "jazar.html"),
    ];
    let Some(mut browser) = Browser::start() else { return };
    browser.show(1280, Medium::Light);
    searching(&mut browser, "pin.html");
    for (words, wanted) in expected {
        let found = results(&mut browser, words);
        let first = found.first().unwrap_or_else(|| panic!("{words}: nothing is found"));
        assert!(first == wanted || first.starts_with(&format!("{wanted}#")), "{words}: {first}");
    }
}

#[test]
fn words_that_are_mistyped_or_unknown_are_answered() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(390, Medium::Light);
    searching(&mut browser, "pin.html");
    let found = results(&mut browser, "corriolis");
    assert!(found.first().is_some_and(|first| first.starts_with("quick-return.html")), "{found:?}");
    assert_eq!(results(&mut browser, "xyzzyx <qqq>"), Vec::<String>::new());
    let said = browser.evaluate("document.getElementById('mdbook-searchresults-header').textContent");
    assert_eq!(said, json!("Nothing in the book for “xyzzyx <qqq>”."));
}

#[test]
fn the_search_is_used_by_keyboard_alone_and_the_way_back_leads_to_the_results() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(390, Medium::Light);
    let scripts = "[...document.scripts].filter(({ src }) => src.includes('searchindex')).length";
    browser.open(&format!("file://{}/pin.html", book().display()));
    assert_eq!(browser.evaluate(scripts), json!(0), "the index loads before anyone searches");
    browser.press("s", 83);
    let at = "[document.activeElement.id, document.activeElement.localName]";
    assert_eq!(browser.evaluate(at)[0], json!("mdbook-searchbar"));
    assert_eq!(browser.evaluate(scripts), json!(1));
    let found = results(&mut browser, "tolerance");
    assert!(found.len() > 2, "{found:?}");
    // Down to the second result, up to the field, and closed.
    let place = "[...document.querySelectorAll('#mdbook-searchresults a')].indexOf(document.activeElement)";
    for (key, number, expected) in [("ArrowDown", 40, 0), ("ArrowDown", 40, 1), ("ArrowUp", 38, 0), ("ArrowUp", 38, -1)]
    {
        browser.press(key, number);
        assert_eq!(browser.evaluate(place), json!(expected), "{key}");
    }
    assert_eq!(browser.evaluate(at)[0], json!("mdbook-searchbar"));
    browser.press("Escape", 27);
    let state = "[document.activeElement.id, document.getElementById('mdbook-search-wrapper').checkVisibility()]";
    assert_eq!(browser.evaluate(state), json!(["mdbook-search-toggle", false]));
    // A result's page shows what was searched for, and the way back leads to the results.
    browser.press("s", 83);
    results(&mut browser, "tolerance");
    browser.press("ArrowDown", 40);
    let first = browser.evaluate("document.activeElement.href");
    let first = first.as_str().expect("an address").to_owned();
    let enter = json!({ "type": "keyDown", "key": "Enter", "text": "\r", "windowsVirtualKeyCode": 13 });
    browser.command("Input.dispatchKeyEvent", enter);
    browser.arrive(first.rsplit('/').next().unwrap_or_default());
    browser.evaluate("until(() => document.readyState === 'complete' && CSS.highlights.get('searched')?.size > 0)");
    browser.evaluate("{ requestAnimationFrame(() => history.back()) }");
    browser.arrive("?search=tolerance");
    browser.evaluate("until(() => document.querySelectorAll('#mdbook-searchresults a').length > 2)");
}

#[test]
fn every_synonym_leads_to_words_of_the_book() {
    let files = crate::book_pages::files();
    let index = files.iter().find(|(name, _)| name.starts_with("searchindex")).expect("an index").1;
    let index = String::from_utf8_lossy(index);
    for synonym in geneva_chapters::BOOK.synonyms {
        assert!(
            index.contains(&format!("[\"{}\",", synonym.typed)),
            "`{}` leads to a word that no page has",
            synonym.typed
        );
    }
}
