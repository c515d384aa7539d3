//! Can a reader find a claim? In a browser: the page of all claims and its filter, and addresses of earlier editions.

use crate::book_pages::{book, moved};
use crate::browser::devtools::{Browser, Medium};
use geneva_documents::LEDGER;
use geneva_documents::{JAZAR, MEYER};
use geneva_evidence::{Kind, Truth, Verdict};
use serde_json::{Value, json};

fn opened(address: &str) -> Option<Browser> {
    let mut browser = Browser::start()?;
    browser.show(1280, Medium::Light);
    browser.open(&format!("file://{}/{address}", book().display()));
    Some(browser)
}

/// The value of an expression as soon as it is neither null nor false.
fn when_there(browser: &mut Browser, expression: &str) -> Value {
    browser.evaluate(&format!("until(() => {expression})"))
}

/// Sets fields of the filter: how many rows are shown then, and what the form says.
fn filtered(browser: &mut Browser, fields: &[(&str, &str)]) -> (usize, String) {
    let set = json!(fields);
    let answer = browser.evaluate(&format!(
        "(() => {{
            const form = document.querySelector('form.filter');
            form.reset();
            for (const [name, value] of {set}) {{ form.elements[name].value = value; }}
            form.dispatchEvent(new Event('input', {{ bubbles: true }}));
            const shown = [...document.querySelectorAll('.claims > li')].filter(row => row.checkVisibility()).length;
            return {{ shown, says: form.querySelector('output').value }};
        }})()"
    ));
    let shown = answer["shown"].as_u64().expect("a number") as usize;
    (shown, answer["says"].as_str().expect("words").to_owned())
}

#[test]
fn the_filter_shows_the_claims_that_have_all_that_is_asked_for() {
    let Some(mut browser) = opened("ledger.html") else { return };
    let all = LEDGER.verdicts().len();
    let count = |of: fn(&geneva_evidence::Judged) -> bool| LEDGER.verdicts().iter().filter(|judged| of(judged)).count();
    let cases: [(&[(&str, &str)], usize); 9] = [
        (&[], all),
        (&[("source", "jazar")], count(|judged| judged.claim.document == &JAZAR)),
        (&[("source", "documents")], count(|judged| judged.claim.document.is_mirrored())),
        (&[("verdict", "open")], count(|judged| judged.truth() == Truth::Open)),
        (&[("verdict", "wrong-in-copy")], count(geneva_evidence::Judged::is_miscopied)),
        (&[("verdict", "right-as-read")], count(|judged| judged.verdict == Verdict::ReadOff)),
        (&[("kind", "equation")], count(|judged| judged.claim.kind == Kind::Equation)),
        (
            &[("kind", "value"), ("verdict", "wrong"), ("source", "meyer")],
            count(|judged| {
                let claim = judged.claim;
                let is_wrong = judged.truth() == Truth::Wrong && !judged.is_miscopied();
                claim.kind == Kind::Value && is_wrong && claim.document == &MEYER
            }),
        ),
        // A word of an id, in capitals, and one of what it says.
        (&[("words", "PIN.SLOT-POINT-SPEED  point")], 1),
    ];
    for (fields, expected) in cases {
        let (shown, says) = filtered(&mut browser, fields);
        assert_eq!(shown, expected, "{fields:?}");
        let words = if shown == all { format!("All {all} claims") } else { format!("{shown} of {all} claims") };
        assert_eq!(says.split(':').next(), Some(&*words), "{fields:?}");
    }
    let (shown, _) = filtered(&mut browser, &[("words", "no such words")]);
    let headings =
        browser.evaluate("[...document.querySelectorAll('main h2')].filter(of => of.checkVisibility()).length");
    assert_eq!((shown, headings), (0, json!(0)));
}

#[test]
fn a_filter_is_set_by_keyboard_and_kept_in_the_address() {
    let Some(mut browser) = opened("ledger.html") else { return };
    browser.evaluate("document.querySelector('form.filter input').focus()");
    browser.command("Input.insertText", json!({ "text": "rise" }));
    let shown = "[...document.querySelectorAll('.claims > li')].filter(row => row.checkVisibility()).length";
    let some = browser.evaluate(shown).as_u64().expect("a number");
    assert!(some > 0 && (some as usize) < LEDGER.verdicts().len(), "{some}");
    let address = browser.evaluate("location.href").as_str().expect("an address").to_owned();
    assert!(address.ends_with("#words=rise"), "{address}");
    browser.open("about:blank");
    browser.open(&address);
    assert_eq!(browser.evaluate(shown), some);
    // From one claim to its details: the summary takes the focus and opens at the Enter key.
    browser.evaluate("document.querySelector('.claims > li:not([hidden]) summary').focus()");
    browser.command(
        "Input.dispatchKeyEvent",
        json!({ "type": "keyDown", "key": "Enter", "text": "\r", "windowsVirtualKeyCode": 13 }),
    );
    let opened = "document.querySelector('.claims details[open] dl')?.closest('li').matches('li:not([hidden])')";
    assert_eq!(when_there(&mut browser, opened), true);
}

/// Goes to an address that leads on, and waits until the browser is at the end.
#[track_caller]
fn follow(browser: &mut Browser, from: &str, to: &str) {
    browser.command("Page.navigate", json!({ "url": format!("file://{}/{from}", book().display()) }));
    browser.arrive(&format!("/{to}"));
}

#[test]
fn an_address_of_a_claim_opens_its_row_with_all_that_is_known_of_it() {
    let Some(mut browser) = opened("pin.html") else { return };
    let judged = LEDGER.verdict("jazar.eq-5.29").expect("a claim");
    let (id, slip) = (judged.claim.id, &judged.claim.erratum.as_ref().expect("a mistake").slip);
    for page in ["ledger.html", "ledger-jazar.html"] {
        follow(&mut browser, &format!("{page}#{id}"), &format!("ledger.html#{id}"));
        // By now another page may be on its way.
        browser.open(&format!("file://{}/ledger.html?{page}#{id}", book().display()));
        let text =
            when_there(&mut browser, &format!("document.getElementById('{id}')?.querySelector('dl')?.textContent"));
        let text = text.as_str().unwrap_or_else(|| panic!("{page}: nothing is shown"));
        for part in [slip.reason, slip.witness, &judged.findings[0].1.how] {
            assert!(text.contains(part), "{page}: {part} is not in {text}");
        }
    }
}

#[test]
fn a_link_to_a_fold_opens_it() {
    let Some(mut browser) = opened("terminal-speed.html#erratum-meyer.shape") else { return };
    let is_open = |id: &str| format!("document.getElementById('{id}')?.open");
    assert_eq!(when_there(&mut browser, &is_open("erratum-meyer.shape")), true);
    let tests = is_open("the-tests-behind-this-chapter");
    assert_eq!(browser.evaluate(&tests), false);
    browser.evaluate("location.hash = 'the-tests-behind-this-chapter'");
    assert_eq!(when_there(&mut browser, &tests), true);
}

/// How far below its upper edge a window may have the row to which an address leads, in pixels: the bar is above it.
const AT_THE_TOP: f64 = 100.0;

#[test]
fn the_row_of_a_claim_is_brought_to_the_top_of_a_phone_and_of_a_wide_window() {
    let Some(mut browser) = opened("pin.html") else { return };
    let every = LEDGER.verdicts().len() / 7;
    for width in [390, 1280] {
        browser.show(width, Medium::Dark);
        for judged in LEDGER.verdicts().iter().skip(every / 2).step_by(every) {
            let id = judged.claim.id;
            browser.open("about:blank");
            browser.open(&format!("file://{}/ledger.html#{id}", book().display()));
            let top = format!("document.getElementById('{id}').getBoundingClientRect().top");
            let at_the_top = format!("{top} >= 0 && {top} < {AT_THE_TOP}");
            assert_eq!(when_there(&mut browser, &at_the_top), true, "{id}, {width} px: {}", browser.evaluate(&top));
        }
    }
}

#[test]
fn every_address_of_an_earlier_edition_leads_on_without_scripts_too() {
    let Some(mut browser) = opened("pin.html") else { return };
    for run in [true, false] {
        browser.run_scripts(run);
        // A part of a page needs scripts.
        for (from, to) in moved().iter().filter(|(from, _)| run || !from.contains('#')) {
            follow(&mut browser, from, to);
        }
    }
    browser.run_scripts(true);
}

#[test]
fn the_list_of_the_data_has_every_file_once_and_each_says_what_it_is() {
    let folder = book().join("data");
    let list = std::fs::read_to_string(folder.join("ro-crate-metadata.json")).expect("the list");
    let list: Value = serde_json::from_str(&list).expect("JSON");
    let entities = list["@graph"].as_array().expect("entities");
    let root = entities.iter().find(|of| of["@id"] == "./").expect("the whole");
    let ids = |of: &Value| of["@id"].as_str().expect("a name").to_owned();
    let parts: Vec<String> = root["hasPart"].as_array().expect("parts").iter().map(ids).collect();
    let files: Vec<String> = entities.iter().filter(|of| of["@type"] == "File").map(ids).collect();
    assert_eq!(parts, files);
    let names = std::fs::read_dir(&folder).expect("data").map(|entry| entry.expect("a file").file_name());
    let data = names.filter_map(|name| name.into_string().ok()).filter(|name| {
        [".csv", ".json", ".atom", ".cff"].iter().any(|end| name.ends_with(end)) && !name.contains("-metadata.json")
    });
    let mut data: Vec<String> = data.collect();
    data.sort_unstable();
    assert_eq!(parts, data);
    // What is behind a figure or a table says so.
    let of_pages = ["copies.csv", "coverage.csv", "works.csv", "fields.csv"];
    for of in entities.iter().filter(|of| ids(of).ends_with(".csv") && !of_pages.contains(&ids(of).as_str())) {
        assert!(of["description"].as_str().is_some_and(|words| words.len() > 20), "{}: no caption", ids(of));
    }
}
