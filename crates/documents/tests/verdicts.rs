//! Does every claim still have its recorded verdict, and would a change be noticed?

use geneva_documents::{JAZAR, LEDGER, MEYER, PIN, QUICK_RETURN, WILD};
use geneva_evidence::testing::{self, Guarded};
use geneva_evidence::{Document, Finding};

#[path = "verdicts/kinds.rs"]
mod kinds;
#[path = "verdicts/slips.rs"]
mod slips;

/// The ledger, and what is an exception in it.
const GUARDED: Guarded = Guarded { ledger: &LEDGER, free_numbers: FREE_NUMBERS, lines_to_do: 0 };

/// Sentences with a number that may be another, and why.
const FREE_NUMBERS: &[(&str, &str)] = &[
    ("meyer.steel", "steels differ by more than its last digit, as its reading says"),
    ("meyer.conclusion.the-three", "other pairs of pins and slots work as well, as the correction beside it says"),
    ("wild.openscad.cut", "sizes that somebody chose: wheels of other sizes clear the disc as well"),
    ("wild.cosmo.cut", "clearances that somebody chose: with larger ones the wheel clears the disc as well"),
];

#[test]
fn every_claim_stands_as_recorded() {
    testing::differing_claims(GUARDED).expect(900);
}

/// The claims of one document, for who changes it: the others are not judged.
#[track_caller]
fn stands(document: &Document) {
    let verdicts = LEDGER.verdicts_of(document);
    let wrong = verdicts.iter().filter(|judged| !judged.matches_record());
    let wrong: Vec<_> =
        wrong.map(|judged| format!("{}: {}", judged.claim.id, judged.complaints().join("; "))).collect();
    assert!(!verdicts.is_empty() && wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn pin_stands() {
    stands(&PIN);
}

#[test]
fn quick_return_stands() {
    stands(&QUICK_RETURN);
}

#[test]
fn jazar_stands() {
    stands(&JAZAR);
}

#[test]
fn meyer_stands() {
    stands(&MEYER);
}

#[test]
fn wild_stands() {
    stands(&WILD);
}

#[test]
fn every_document_names_the_test_of_its_claims() {
    let own = include_str!("verdicts.rs");
    for document in LEDGER.documents() {
        let name = document.test.strip_prefix("cargo test -p geneva-documents --test verdicts ");
        let name = name.unwrap_or_else(|| panic!("{}: {}", document.slug, document.test));
        let constant = document.slug.to_uppercase().replace('-', "_");
        let test = format!("fn {name}() {{\n    stands(&{constant});\n}}\n");
        assert!(own.contains(&test), "{}: no test `{name}` of it", document.slug);
    }
}

#[test]
fn what_is_on_record_is_complete_and_does_not_contradict_itself() {
    testing::claim_records(GUARDED).expect(900);
    testing::contradicted_slips(GUARDED).expect(50);
    testing::other_units(GUARDED).expect(1000);
    testing::unclear_symbols(GUARDED).expect(50);
    testing::evidence_in_use(GUARDED).expect(11);
    testing::statement_neighbours(GUARDED).expect(250);
    testing::stopped_checks(GUARDED).expect(5);
}

#[test]
fn every_line_of_the_sources_is_accounted_for_and_a_gap_is_noticed() {
    testing::broken_lines(GUARDED).expect(200);
    testing::unaccounted_numbers(GUARDED).expect(200);
    testing::misplaced_entries(GUARDED).expect(800);
    testing::dropped_entries(GUARDED).expect(500);
    testing::rewritten_inventories(GUARDED).expect(4);
}

#[test]
fn a_wrong_digit_in_a_number_is_noticed() {
    testing::wrong_digits(GUARDED).expect(500);
}

#[test]
fn a_wrong_number_in_a_sentence_is_noticed() {
    testing::other_numbers_in_sentences(GUARDED).expect(150);
}

#[test]
fn a_wrong_route_is_noticed() {
    testing::wrong_routes(GUARDED).expect(1500);
}

#[test]
fn a_formula_that_cannot_be_evaluated_is_a_fault_of_its_own_claim_and_ends_nothing() {
    testing::spoilt_formulas(GUARDED).expect(300);
}

#[test]
fn no_characters_end_the_program() {
    testing::endless_characters(GUARDED).expect(2000);
}

#[test]
fn every_equation_is_read_by_both_of_its_routes() {
    testing::equations_read(GUARDED).expect(150);
}

#[test]
fn no_claims_rest_on_nothing_but_each_other() {
    testing::circular_claims(GUARDED).expect(700);
}

#[test]
fn what_is_computed_does_not_look_at_the_number_that_it_is_compared_with() {
    testing::own_digits_read(GUARDED).expect(600);
}

#[test]
fn the_routes_of_a_value_share_no_printed_result() {
    testing::shared_results(GUARDED).expect(200);
}

#[test]
fn a_misspelt_id_names_the_nearest_and_never_becomes_a_number() {
    let stopped = std::panic::catch_unwind(|| PIN.printed_number("pin.crank-radios"));
    let message = *stopped.expect_err("no such claim").downcast::<String>().expect("a message");
    assert_eq!(message, "no claim has the id pin.crank-radios; the nearest is pin.crank-radius");
    let stopped = std::panic::catch_unwind(|| PIN.printed_number("pin.pin-speed-equation"));
    let message = *stopped.expect_err("no number").downcast::<String>().expect("a message");
    assert!(message.starts_with("pin.pin-speed-equation: `"), "{message}");
}

#[test]
fn what_holds_for_all_cases_says_for_how_many_and_none_is_not_enough() {
    let even = |numbers: &[u32]| {
        let finding = Finding::for_all(numbers, |n| n % 2 == 0, |count, all| format!("{count} of {all}"));
        (finding.holds, finding.how)
    };
    assert_eq!(even(&[2, 4]), (true, "2 of 2".to_owned()));
    assert_eq!(even(&[2, 3, 4]), (false, "2 of 3".to_owned()));
    assert_eq!(even(&[]), (false, "0 of 0".to_owned()));
}
