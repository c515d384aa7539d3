//! Does a reader who goes from the first page to a page that can be moved or filtered find the same numbers there? In a
//! browser: what such a page shows before its reader has moved anything, or has asked for what the first page names.

use crate::book_pages::book;
use crate::browser::devtools::{Browser, Medium};
use serde_json::{Value, json};

/// The text of the first page, and the rows of its table of verdicts.
const FIRST_PAGE: &str = "[document.querySelector('main').textContent.replace(/\\s+/g, ' '), \
     Object.fromEntries([...document.querySelectorAll('main tr:has(td + td)')].map(row => \
     [...row.cells].map(cell => cell.textContent.trim())))]";

fn open(browser: &mut Browser, page: &str) {
    browser.open(&format!("file://{}/{page}", book().display()));
}

/// The number in the page's table in the row that begins with these words.
fn in_table(table: &Value, row: &str) -> u64 {
    let rows = table.as_object().expect("rows");
    let found = rows.iter().find(|(words, _)| words.starts_with(row)).map(|(_, count)| count);
    let count = found.and_then(Value::as_str).unwrap_or_else(|| panic!("no row “{row}” in {table}"));
    count.parse().unwrap_or_else(|_| panic!("“{row}”: {count} is no count"))
}

#[test]
fn the_figure_of_the_mistake_begins_with_the_count_of_the_first_page() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "index.html");
    let text = browser.evaluate(FIRST_PAGE)[0].as_str().expect("text").to_owned();
    open(&mut browser, "mistake.html");
    let shown = browser.evaluate("document.querySelector('[data-live=mistake] output[name=agree]').value");
    let (agree, all) = shown.as_str().and_then(|shown| shown.split_once(" of ")).expect("a count of all");
    let words = format!("reproduces {agree} of the {all} printed speeds and periods to within one unit");
    assert!(text.contains(&words), "the figure begins with {shown}, but the first page doesn't say “{words}”");
}

#[test]
fn the_filter_of_all_claims_counts_as_the_first_page_does() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "index.html");
    let first_page = browser.evaluate(FIRST_PAGE);
    let table = &first_page[1];
    let wrong = in_table(table, "wrong, and") + in_table(table, "wrong, but");
    let words = format!("{wrong} are wrong");
    assert!(first_page[0].as_str().is_some_and(|text| text.contains(&words)), "the first page doesn't say “{words}”");
    open(&mut browser, "ledger.html");
    // The choices say the counts before anything is chosen.
    let choices =
        browser.evaluate("[...document.querySelectorAll('form.filter [name=verdict] option')].map(of => of.text)");
    for (words, expected) in [
        ("right or right as read", in_table(table, "right, or right as read")),
        ("wrong", wrong),
        ("wrong in our copy", in_table(table, "wrong in our copy")),
        ("open", in_table(table, "open")),
    ] {
        let choice = format!("{words} ({expected} in the four documents)");
        assert!(choices.as_array().is_some_and(|all| all.contains(&json!(choice))), "no “{choice}” in {choices}");
    }
    for (verdict, expected) in [
        ("", in_table(table, "all")),
        ("right", in_table(table, "right, or right as read")),
        ("wrong", wrong),
        ("wrong-in-copy", in_table(table, "wrong in our copy")),
        ("open", in_table(table, "open")),
    ] {
        let says = browser.evaluate(&format!(
            "(() => {{ const form = document.querySelector('form.filter'); form.elements.verdict.value = {}; \
             form.dispatchEvent(new Event('input', {{ bubbles: true }})); return form.querySelector('output').value }})()",
            json!(verdict)
        ));
        let says = says.as_str().expect("words");
        // Where there are some elsewhere, too, those of the four documents stand apart.
        let (all, apart) = says.split_once(": ").map_or((says, None), |(all, apart)| (all, Some(apart)));
        let words = format!("{expected} {}", if apart.is_some() { "in the four documents, " } else { "of " });
        let is_said = apart.unwrap_or(all).starts_with(&words);
        assert!(is_said, "“{verdict}”: the filter says “{says}”, the first page {expected}");
    }
}
