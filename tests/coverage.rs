//! Is everything in the sources a claim or an exception with a reason, and would a gap be noticed?

use geneva_ledger::{Entry, Line, Work, claim, claims, number_tokens};
use std::collections::HashMap;
use std::fs;

fn lines(work: Work) -> &'static [Line] {
    work.inventory().unwrap_or_else(|malformed| panic!("{malformed}"))
}

#[test]
fn every_number_of_every_line_is_accounted_for() {
    for work in Work::DOCUMENTS {
        for line in lines(*work) {
            let gap = line.gap().unwrap_or_default();
            assert!(line.is_accounted_for(), "{work}, line {}: {}: {gap}", line.number, line.numbers.join(" "));
        }
    }
}

#[test]
fn lines_are_in_order_and_say_something() {
    for work in Work::DOCUMENTS {
        let numbers: Vec<_> = lines(*work).iter().map(|line| line.number).collect();
        assert!(numbers.is_sorted_by(|a, b| a < b), "{work}: {numbers:?}");
        for line in lines(*work) {
            assert!(!line.entries.is_empty(), "{work}, line {} has no entry", line.number);
        }
    }
}

#[test]
fn every_claim_stands_in_its_source_once() {
    let mut places: HashMap<&str, Vec<(Work, u32)>> = HashMap::new();
    for work in Work::DOCUMENTS {
        for line in lines(*work) {
            for entry in &line.entries {
                if let Some(id) = entry.claimed() {
                    places.entry(id).or_default().push((*work, line.number));
                }
            }
        }
    }
    for claim in claims().iter().filter(|claim| claim.work.is_document()) {
        let at = places.remove(claim.id).unwrap_or_default();
        assert!(matches!(at[..], [(work, _)] if work == claim.work), "{} stands at {at:?}", claim.id);
    }
    assert!(places.is_empty(), "listed, but no claims: {places:?}");
}

#[test]
fn dots_are_filled_in_order_behind_the_claim_they_stand_in() {
    for work in Work::DOCUMENTS {
        // How many dots of each claim are behind us; a table or a broken equation goes on in later lines.
        let mut filled: HashMap<&str, usize> = HashMap::new();
        for line in lines(*work) {
            for entry in &line.entries {
                if let Some(id) = entry.claimed() {
                    filled.insert(id, 0);
                } else if let Entry::Rest(id, n) = entry {
                    let before = filled.get_mut(id).unwrap_or_else(|| panic!("line {}: no {id} yet", line.number));
                    *before += 1;
                    assert_eq!(*before, *n, "line {}: {entry:?}", line.number);
                }
            }
        }
        for (id, filled) in filled {
            let dots = claim(id).map_or(0, |claim| claim.printed.matches(r"\ldots").count());
            assert!(filled <= dots, "{id} has {dots} dots");
        }
    }
}

#[test]
fn what_is_printed_again_was_a_claim_before() {
    for work in Work::DOCUMENTS {
        for entry in lines(*work).iter().flat_map(|line| &line.entries) {
            if let Entry::Again(id) = entry {
                assert!(claim(id).is_some_and(|claim| claim.work == *work), "{work}: no claim {id} to print again");
            }
        }
    }
}

#[test]
fn a_reference_leads_to_an_equation_or_figure_of_the_source() {
    for work in Work::DOCUMENTS {
        for line in lines(*work) {
            for entry in &line.entries {
                let Entry::Label(number) = entry else { continue };
                let bears = |locator: &str| words(locator).any(|word| word == *number);
                let found = claims().iter().any(|claim| claim.work == *work && bears(claim.locator));
                assert!(found, "{work}, line {}: nothing is numbered {number}", line.number);
            }
        }
    }
}

/// The words of a locator without brackets and marks: `Eqs. (1-1) and (1-2)` names 1-1 and 1-2, and not 1.
fn words(locator: &str) -> impl Iterator<Item = &str> {
    locator.split_whitespace().map(|word| word.trim_matches(|c: char| !c.is_alphanumeric()))
}

#[test]
fn exceptions_have_reasons_and_expire() {
    for work in Work::DOCUMENTS {
        let mut ids = Vec::new();
        for entry in lines(*work).iter().flat_map(|line| &line.entries) {
            if let Entry::Exception { id, reason, .. } = entry {
                assert!(id.starts_with(&format!("{work}.")), "{id}: the id starts with the source's name");
                assert!(reason.len() > 20, "{id}: say why it is no claim");
                assert!(claim(id).is_none(), "{id} is a claim now: the exception is no longer needed, remove it");
                assert!(!ids.contains(id), "{id} stands twice");
                ids.push(id);
            }
        }
    }
}

#[test]
fn a_drawing_that_is_lost_and_a_value_that_is_given_are_claims_in_every_source() {
    for work in Work::DOCUMENTS {
        for entry in lines(*work).iter().flat_map(|line| &line.entries) {
            let Entry::Exception { id, reason, .. } = entry else { continue };
            assert!(!reason.contains("drawing"), "{id}: a drawing that the copy lacks is a claim, and open");
            assert!(!reason.contains("a datum:") && !reason.contains("is a datum,"), "{id}: what is given is a claim");
        }
    }
}

#[test]
fn a_number_that_is_dropped_or_moved_is_noticed() {
    let mut tried = 0;
    for line in Work::DOCUMENTS.iter().flat_map(|work| lines(*work)) {
        for gone in 0..line.entries.len() {
            if line.entries[gone].numbers().is_empty() {
                continue;
            }
            let mut shorter = line.clone();
            shorter.entries.remove(gone);
            assert!(!shorter.is_accounted_for(), "line {} without its entry {gone} went unnoticed", line.number);
            tried += 1;
        }
    }
    assert!(tried > 20, "only {tried} entries were tried");
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
    for (work, least) in Work::DOCUMENTS.iter().zip([3, 2, 25, 100]) {
        let words = lines(*work).iter().flat_map(|line| &line.numbers).filter(is_word).count();
        let accounted =
            lines(*work).iter().flat_map(|line| &line.entries).flat_map(Entry::numbers).filter(|n| is_word(&n)).count();
        assert!(words == accounted && words >= least, "{work}: {words} words, {accounted} accounted for");
    }
}
