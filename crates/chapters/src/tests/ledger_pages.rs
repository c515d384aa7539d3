//! What the pages of this book show of its ledger.

use crate::BOOK;
use geneva_evidence::{Document, Truth};
use geneva_press::html::GLUED;
use geneva_press::ledger_pages::findings::{how, with_minus_signs};
use geneva_press::ledger_pages::lists::letter;
use geneva_press::ledger_pages::{coverage, inline, ledger};

#[test]
fn every_character_of_a_copy_is_counted_with_its_source_and_has_an_anchor() {
    let page = coverage::page(&BOOK).expect("a page");
    let all = coverage::slips_of_documents(BOOK.ledger).count();
    assert_eq!(page.matches("<a id=\"slip-").count(), all);
    let of = |document: &&'static Document| coverage::slips_of_copy(BOOK.ledger, document);
    assert_eq!(BOOK.ledger.mirrored().iter().map(of).sum::<usize>(), all);
}

#[test]
fn every_finding_is_told_in_sentences() {
    for judged in BOOK.ledger.verdicts().iter().filter(|judged| !judged.findings.is_empty()) {
        let (id, told) = (judged.claim.id, how(judged));
        assert!(told.contains("printed") && told.contains("econd way"), "{id}: {told}");
        for log in ["fails: fails", "holds: holds", ";<br>", "[", "Some(", "..=", "-identity"] {
            assert!(!told.contains(log), "{id}: {log} in {told}");
        }
        let first = &judged.findings[0].1.how;
        assert!(told.contains(&with_minus_signs(first)), "{id}: {first} is not in {told}");
    }
}

#[test]
fn a_mark_stays_with_its_word_and_the_sign_behind_it() {
    let mark = inline::mark(&BOOK, "pin.crank-angle").expect("a claim");
    let glued_to = |before: &str, behind: &str| inline::glued(&format!("A {before}{mark}{behind}"));
    for word in ["word", "<math><mi>a</mi></math>", "<span class=\"claim\">5 mm</span>"] {
        let expected = format!("A {GLUED}{word}{mark}.</span> Then");
        assert_eq!(glued_to(word, ". Then"), expected);
        let twice = format!("A {GLUED}{word}{mark}{mark},</span> and");
        assert_eq!(glued_to(word, &format!("{mark}, and")), twice);
    }
    // What would not be closed within it, or is as wide as a line, is left alone.
    let formulas = "<span class=\"claim\"><math></math><math></math></span>";
    for (before, behind) in [("*word*", "."), ("[word](pin.md)", "."), (formulas, ".")] {
        assert_eq!(glued_to(before, behind), format!("A {before}{mark}{behind}"));
    }
    assert_eq!(inline::glued("| a cell of a table |"), "| a cell of a table |");
    let row = format!("| 5 mm{mark} |");
    assert_eq!(inline::glued(&row), row);
}

#[test]
fn every_claim_has_a_row_and_every_row_has_details() {
    let page = ledger::page(&BOOK).expect("a page");
    let [_, _, details] = ledger::files(&BOOK).expect("files");
    for judged in BOOK.ledger.verdicts() {
        let id = judged.claim.id;
        let row = format!("<li id=\"{id}\" class=\"{} {}", judged.claim.kind.slug(), judged.plain());
        assert_eq!(page.matches(&row).count(), 1, "{id}");
        assert_eq!(details.text().matches(&format!("\"{id}\":\"<dl><dt>")).count(), 1, "{id}");
    }
    assert_eq!(page.matches("<li ").count(), BOOK.ledger.verdicts().len());
}

#[test]
fn the_filter_offers_what_the_rows_have() {
    let filter = ledger::filter(&BOOK);
    for judged in BOOK.ledger.verdicts() {
        for value in [judged.claim.document.slug, judged.plain().slug(), judged.claim.kind.slug()] {
            assert!(filter.contains(&format!("<option value=\"{value}\"")), "{value}");
        }
    }
}

#[test]
fn a_row_says_in_a_line_what_was_found() {
    for judged in BOOK.ledger.verdicts() {
        let (id, found) = (judged.claim.id, ledger::finding_in_a_line(&BOOK, judged));
        let says = match judged.truth() {
            Truth::Open => found.starts_with("Open: "),
            Truth::Wrong => judged.claim.erratum.is_some() == found.starts_with("Mistake: "),
            Truth::Right => judged.computed.is_some() || !found.is_empty(),
        };
        assert!(says, "{id}: {found}");
    }
}

#[test]
fn a_letter_says_what_the_table_says_and_an_unknown_one_is_refused() {
    assert_eq!(letter(&BOOK, "meyer K").expect("a letter"), "torque of the spring");
    assert_eq!(letter(&BOOK, "pin R").expect("a letter"), "crank radius");
    for wrong in ["meyer", "meyer Kk", "mayer K"] {
        assert!(letter(&BOOK, wrong).is_err(), "{wrong}");
    }
}
