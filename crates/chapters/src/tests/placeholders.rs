//! What takes the place of keys in the chapters of this book.

use crate::BOOK;
use geneva_press::book::Expansion::{Bare, Dated};
use geneva_press::edition::Edition;
use geneva_press::placeholders::{ChapterContext, expand, keys, page_items};
use geneva_press::readings::reading;
use geneva_press::{fences, maths};

static EDITION: Edition = Edition::without_commit(BOOK.imprint.version);
const PAGE: ChapterContext<'_> =
    ChapterContext { book: &BOOK, name: "pin", number: "1.", edition: &EDITION, written: "" };

fn expanded(chapter: &str) -> anyhow::Result<String> {
    Ok(expand(chapter, PAGE, &page_items(chapter, PAGE))?.0)
}

#[test]
fn every_key_is_drawn_or_asks_for_its_argument() {
    for key in keys(&BOOK) {
        let bare = expanded(&format!("{{{{{}}}}}", key.name));
        assert_eq!(bare.is_ok(), matches!(key.expansion, Bare(_) | Dated(_)), "{}: {bare:?}", key.name);
    }
}

#[test]
fn an_unknown_id_is_named_with_its_line_and_a_neighbour() {
    let error = expanded("one\n\n{{computed:pin.radiuss}}").expect_err("no such claim").to_string();
    assert!(error.starts_with("line 3:") && error.contains("pin.radiuss") && error.contains("pin.radius`"), "{error}");
}

#[test]
fn a_misspelt_argument_of_any_key_is_answered_with_the_nearest_name() {
    for (placeholder, nearest) in [
        ("{{ask:wurked.rpm}}", "worked"),
        ("{{ask:worked.rpn}}", "rpm"),
        ("{{question:wurked}}", "worked"),
        ("{{computed:rowss}}", "rows"),
        ("{{table:joint}}", "joints"),
        ("{{figure:wheel-chioce}}", "wheel-choice"),
        ("{{picture:wheel-chioce}}", "wheel-choice"),
        ("{{live:weel}}", "wheel"),
        ("{{cite:jonson}}", "johnson"),
        ("{{claim:pin.radiuss}}", "pin.radius"),
        ("{{erratum:pin.radiuss}}", "pin.radius"),
        ("{{compare:jasar}}", "jazar"),
        ("{{count:jasar}}", "jazar"),
        ("{{citation:jasar}}", "jazar"),
        ("{{symbols:jasar}}", "jazar"),
        ("{{letter:meyer Kk}}", "K"),
        ("{{slips:resuld}}", "result"),
        ("{{open:rises}}", "rise-times"),
        ("{{open-count:rises}}", "rise-times"),
        ("{{records:erata}}", "errata"),
        ("{{cite-claim:pin.radiuss}}", "pin.radius"),
        ("{{figure:wheel-choice}} {{ref:wheel-chioce}}", "wheel-choice"),
    ] {
        let error = expanded(&format!("one\n\n{placeholder}\n")).expect_err(placeholder).to_string();
        let is_named = error.starts_with("line 3: ") && error.contains(&format!("the nearest is `{nearest}`"));
        assert!(is_named, "{placeholder}: {error}");
    }
}

#[test]
fn an_error_has_the_line_that_its_author_wrote() {
    let written = "one\n\n$$\na\n= b\n$$\n\n```rust\n// A program.\nf();\n```\n\n{{computed:pin.radiuss}}\n";
    let chapter = fences::fold(&maths::render(written).expect("a formula"));
    let error = expand(&chapter, ChapterContext { written, ..PAGE }, &[]).err().expect("no such claim").to_string();
    assert!(error.starts_with("line 13: "), "{error}");
}

#[test]
fn figures_and_tables_are_numbered_where_they_stand() {
    let chapter = "see {{ref:pin-velocity}}\n\n{{figure:pin-position}}\n\n{{wheels:3 4; Two wheels}}\n\n{{figure:pin-velocity}}\n";
    let page = expanded(chapter).expect("all are drawn");
    assert!(page.contains("<a href=\"#fig-pin-velocity\">Figure\u{a0}1.2</a>"), "{page}");
    assert!(page.contains("Figure\u{a0}1.1") && page.contains("Table\u{a0}1.1"));
    assert!(expanded("{{ref:pin-position}}").is_err());
    let other = ChapterContext { name: "other", number: "2.", ..PAGE };
    let other = expand("{{ref:wheels}}", other, &page_items(chapter, PAGE));
    assert_eq!(other.expect("known").0, "<a href=\"pin.html#table-wheels\">Table\u{a0}1.1</a>");
}

#[test]
fn a_mark_has_one_note_on_its_page() {
    let page = expanded("at rest{{verdict:pin.standstill}} twice{{verdict:pin.standstill}}").expect("a claim");
    assert_eq!(page.matches("popovertarget=\"note-pin.standstill\"").count(), 2);
    assert_eq!(page.matches("id=\"note-pin.standstill\"").count(), 1);
}

fn lines(chapter: &str) -> String {
    reading(chapter, PAGE, &page_items(chapter, PAGE)).expect("all are known")
}

#[test]
fn a_placeholder_has_its_words_and_what_is_read_there() {
    let chapter = "A sentence.\nOf the pin that we draw here the radius is {{printed:pin.radius}} and {{ref:pin-velocity}}.\n\n{{figure:pin-velocity}}\n";
    let read = lines(chapter);
    let radius = BOOK.ledger.claim("pin.radius").expect("a claim").printed;
    assert!(
        read.starts_with(&format!("pin that we draw here the radius is {{{{printed:pin.radius}}}} → {radius}")),
        "{read}"
    );
    assert!(read.contains("\nand {{ref:pin-velocity}} → Figure 1.1\n{{figure:pin-velocity}}\n"), "{read}");
}

#[test]
fn a_table_has_its_caption_and_a_line_for_each_row() {
    let read = lines("{{wheels:3 4; Two wheels}}\n");
    let rows: Vec<_> = read.lines().collect();
    assert!(
        rows.len() == 5
            && rows[..2] == ["{{wheels:3 4}}", "    Two wheels."]
            && rows.iter().any(|row| row.starts_with("    N = 3 |")),
        "{read}"
    );
}
