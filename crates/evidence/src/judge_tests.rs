//! Every class of verdict, and every way in which a record can be contradicted, on made-up claims.

use super::*;
use crate::{Cache, Consequence, Document, Locator, Origin, Slip};

/// A document of no claims.
static MADE_UP: Document = Document {
    slug: "made-up",
    title: "made-up",
    citation: "A document of which the claims are made up",
    inventory: None,
    claims: Vec::new,
    answers: &[],
    given: Vec::new,
    conclusions: &[],
    symbols: &[],
    units: &[],
    test: "",
    cache: Cache::new(),
};

const NOWHERE: Locator = Locator::new(&MADE_UP, "nowhere");

/// A number of which both routes give this.
fn number(printed: &'static str, routes: [f64; 2]) -> Claim {
    let [first, second] = routes;
    NOWHERE
        .value("made-up", printed, "", "a number")
        .first_route(Evidence::CLOSED_FORM, move || first)
        .second_route(Evidence::JET, move || second)
}

/// Two thirds, printed so.
fn third(printed: &'static str) -> Claim {
    number(printed, [2.0 / 3.0; 2])
}

/// An equation that holds as printed, if the first of `decided` says so, and as corrected, if the second does.
fn form(decided: [bool; 2], witnessed: bool) -> Claim {
    let decide = move |tex: &str| Finding::new(decided[usize::from(tex != PRINTED)], "it is made up");
    let claim = NOWHERE.equation("made-up", PRINTED, "a form").evaluated(Evidence::EXACT_IDENTITY, decide);
    claim.read(Evidence::JET, move |tex| Some(witnessed && (tex != PRINTED || decided[0])))
}

/// The characters of a form.
const PRINTED: &str = "x = x";

const SLIP: Slip =
    Slip { id: "", reason: "", witness: "", origin: Origin::Arithmetic, consequence: Consequence::Result, changes: "" };

fn judged(claim: Claim) -> Judged {
    judge(Box::leak(Box::new(claim)))
}

fn yes() -> Finding {
    Finding::new(true, "it does")
}

fn no() -> Finding {
    Finding::new(false, "it does not")
}

#[test]
fn a_number_that_rounds_is_reproduced() {
    assert!(judged(third("0.667")).matches_record());
}

#[test]
fn a_number_cut_off_is_truncated_and_needs_an_erratum() {
    let claim = || third("0.666");
    assert_eq!(judged(claim().expecting(Verdict::Truncated)).faults, ["wrong without an erratum"]);
    let found = judged(claim().corrected("0.667", SLIP).expecting(Verdict::Truncated));
    assert!(found.matches_record() && found.truth() == Truth::Wrong, "{:?}", found.complaints());
}

#[test]
fn a_number_from_rounded_intermediates_is_told_from_a_wrong_one() {
    let claim = |printed| third(printed).rounded(|| 0.7 * 0.9);
    let found = judged(claim("0.63").corrected("0.67", SLIP).expecting(Verdict::FromRounded));
    assert!(found.matches_record() && found.truth() == Truth::Wrong, "{:?}", found.complaints());
    assert_eq!(judged(claim("0.62")).verdict, Verdict::NotReproduced);
}

#[test]
fn a_reading_is_right_within_its_resolution() {
    assert_eq!(judged(third("0.69").with_resolution(|| 0.05)).verdict, Verdict::ReadOff);
    assert_eq!(judged(third("0.69").with_resolution(|| 0.01)).verdict, Verdict::NotReproduced);
}

#[test]
fn a_wrong_number_is_corrected_only_by_what_is_computed() {
    assert!(judged(third("0.76").corrected("0.67", SLIP)).matches_record());
    let wrongly = judged(third("0.76").corrected("0.68", SLIP));
    assert_eq!(wrongly.verdict, Verdict::NotReproduced);
    assert!(wrongly.faults[0].starts_with("the correction is not what is computed"), "{:?}", wrongly.faults);
}

#[test]
fn an_erratum_that_starts_to_agree_fails() {
    let claim = third("0.667").corrected("0.667", SLIP).expecting(Verdict::Reproduced);
    assert_eq!(judged(claim).faults, ["an erratum is on record, but the claim is right"]);
}

#[test]
fn a_witness_that_disagrees_is_a_fault() {
    assert_eq!(judged(number("0.667", [2.0 / 3.0, 0.667])).faults.len(), 1);
    // Another printed number need agree only to the printed digits.
    let claim = NOWHERE.value("made-up", "0.667", "", "a number").first_route(Evidence::CLOSED_FORM, || 2.0 / 3.0);
    assert!(judged(claim.second_route(Evidence::OTHER_PLACE_IN_SOURCE, || 0.667)).matches_record());
}

#[test]
fn characters_that_are_no_number_are_a_fault() {
    assert!(judged(third("0.6.7")).faults[0].contains("`0.6.7`"));
}

#[test]
fn forms_hold_fail_or_are_corrected() {
    assert!(judged(form([true; 2], true)).matches_record());
    assert_eq!(judged(form([false; 2], true)).verdict, Verdict::NotReproduced);
    assert!(judged(form([false, true], true).corrected("x = y", SLIP)).matches_record());
    assert!(!judged(form([false, true], true).expecting(Verdict::Corrected)).matches_record());
    assert!(!judged(form([true; 2], true).corrected("x = y", SLIP)).matches_record());
    assert!(!judged(form([true; 2], false)).matches_record());
    assert!(!judged(form([false, true], false).corrected("x = y", SLIP)).matches_record());
}

#[test]
fn what_is_said_in_other_letters_does_not_hide_what_is_printed() {
    let claim = |printed: bool| {
        let claim = NOWHERE.equation("made-up", "X X", "a form").evaluated(Evidence::EXACT_IDENTITY, |_| yes());
        claim.read(Evidence::JET, move |tex| Some(printed || tex == PRINTED)).in_other_letters(PRINTED)
    };
    assert!(judged(claim(true)).matches_record() && !judged(claim(false)).matches_record());
}

#[test]
#[should_panic(expected = "made-up: its check has no place for a neighbour")]
fn a_part_in_the_wrong_place_is_not_lost_in_silence() {
    let _ = third("0.667").but_not("0.668");
}

#[test]
fn a_number_that_a_slip_gives_is_told_from_a_right_one() {
    let claim = |printed, right: [f64; 2]| {
        number(printed, [1.0 / 3.0; 2]).right(Evidence::CLOSED_FORM, move || right[0], Evidence::JET, move || right[1])
    };
    let two_thirds = [2.0 / 3.0; 2];
    let found = judged(claim("0.33", two_thirds).expecting(Verdict::ReproducedInError));
    assert_eq!(found.faults, ["wrong without an erratum"]);
    let found = judged(claim("0.33", two_thirds).in_error(SLIP));
    assert!(found.matches_record(), "{:?}", found.complaints());
    assert_eq!((found.truth(), found.corrected().as_deref()), (Truth::Wrong, Some("0.67")));
    // What the slip does not give is wrong by itself, since the right number is known.
    assert_eq!(judged(claim("0.34", two_thirds)).faults, ["wrong without an erratum"]);
    let found = judged(claim("0.34", two_thirds).expecting(Verdict::Corrected).affected_by(SLIP));
    assert!(found.matches_record(), "{:?}", found.complaints());
    assert_eq!(found.corrected().as_deref(), Some("0.67"));
    // Where the right number has the same digits, the slip changes nothing.
    let found = judged(claim("0.33", [0.334; 2]));
    assert!(found.matches_record() && found.verdict == Verdict::Reproduced, "{:?}", found.complaints());
    assert!(!judged(claim("0.33", [0.334; 2]).affected_by(SLIP)).matches_record());
    assert_eq!(judged(claim("0.33", [2.0 / 3.0, 0.667]).affected_by(SLIP)).faults.len(), 1);
}

fn is_right(stated: Stated) -> Finding {
    stated.pick(yes(), no())
}

fn statement(first: fn(Stated) -> Finding, witness: fn(Stated) -> Finding) -> Claim {
    NOWHERE
        .statement("made-up", "x = x", "a form")
        .first_route(Evidence::EXACT_IDENTITY, first)
        .second_route(Evidence::JET, witness)
}

#[test]
fn a_statement_is_told_from_its_neighbour_by_both_routes() {
    let of = |first, witness| judged(statement(first, witness).but_not("x = 2x"));
    assert!(of(is_right, is_right).matches_record());
    assert_eq!(of(|_| yes(), is_right).faults, ["the first route accepts the neighbour, x = 2x"]);
    assert_eq!(of(is_right, |_| yes()).faults, ["the witness accepts the neighbour, x = 2x"]);
    assert_eq!(of(|_| no(), is_right).verdict, Verdict::NotReproduced);
    assert_eq!(of(is_right, |_| no()).faults.len(), 1);
}

#[test]
fn a_statement_is_corrected_only_if_the_printed_form_fails_by_both_routes() {
    let of = |first, witness| judged(statement(first, witness).corrected("x = y", SLIP));
    assert!(of(is_right, is_right).matches_record());
    assert_eq!(of(|_| yes(), is_right).verdict, Verdict::Reproduced);
    assert_eq!(of(|_| no(), is_right).verdict, Verdict::NotReproduced);
    assert!(!of(is_right, |_| yes()).matches_record() && !of(is_right, |_| no()).matches_record());
}

#[test]
fn a_missing_datum_is_not_reproducible() {
    assert!(judged(NOWHERE.equation("made-up", "x = x", "a form").missing("not printed")).matches_record());
}
