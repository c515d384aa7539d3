//! Which numbers in words and which lost drawings of the sources are claims. The guards of the inventories are those of any ledger.

use geneva_documents::LEDGER;
use geneva_evidence::Document;
use geneva_evidence::{Entry, Line, entry_numbers, number_tokens};
use std::fs;

fn lines(work: &'static Document) -> &'static [Line] {
    work.lines().unwrap_or_else(|malformed| panic!("{malformed}"))
}

#[test]
fn a_drawing_that_is_lost_and_a_value_that_is_given_are_claims_in_every_source() {
    for work in LEDGER.mirrored() {
        for entry in lines(work).iter().flat_map(|line| &line.entries) {
            let Entry::Exception { id, reason, .. } = entry else { continue };
            assert!(!reason.contains("drawing"), "{id}: a drawing that the copy lacks is a claim, and open");
            assert!(!reason.contains("a datum:") && !reason.contains("is a datum,"), "{id}: what is given is a claim");
        }
    }
}

#[test]
fn the_page_on_coverage_names_words_that_count_as_numbers_and_words_that_do_not() {
    let page = fs::read_to_string(crate::path("book/src/coverage.md")).expect("the page");
    let paragraph =
        page.split("\n\n").find(|paragraph| paragraph.starts_with("As numbers in words")).expect("the words");
    let (count, do_not) = paragraph.split_once("We don't").expect("the words that don't");
    let named = |text: &str| text.split('*').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    let (counted, others) = (named(count), named(do_not));
    for word in &counted {
        assert_eq!(number_tokens(word), [word.as_str()], "the page counts {word}");
    }
    for word in &others {
        assert!(number_tokens(word).is_empty(), "the page doesn't count {word}");
    }
    assert!(counted.len() > 8 && others.len() > 2, "{counted:?} and {others:?}");
}

#[test]
fn the_sources_have_numbers_in_words_and_a_claim_or_an_exception_accounts_for_each() {
    let is_word = |number: &&String| number.starts_with(char::is_alphabetic);
    for (work, least) in LEDGER.mirrored().iter().zip([3, 2, 25, 100]) {
        let words = lines(work).iter().flat_map(|line| &line.numbers).filter(is_word).count();
        let accounted = lines(work)
            .iter()
            .flat_map(|line| &line.entries)
            .flat_map(|entry| entry_numbers(work, entry))
            .filter(|n| is_word(&n))
            .count();
        assert!(words == accounted && words >= least, "{work}: {words} words, {accounted} accounted for");
    }
}
