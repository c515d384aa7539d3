//! Every class of verdict, and every way in which a record can be contradicted, on made-up claims.

use super::*;
use crate::{Consequence, Origin, Slip, Work};

const PLACE: &str = "nowhere";

fn number_claim(printed: &'static str, check: Check) -> Claim {
    Claim::value(Work::Pin, "made-up", PLACE, "a number", (printed, ""), check)
}

fn form_claim(check: Check) -> Claim {
    Claim::equation(Work::Pin, "made-up", PLACE, "a form", "x = x", check)
}

const SLIP: Slip =
    Slip { id: "", reason: "", witness: "", origin: Origin::Arithmetic, consequence: Consequence::Result, changes: "" };

fn erratum(corrected: &'static str) -> Erratum {
    Erratum { corrected, slip: SLIP }
}

fn judged(claim: Claim) -> Judged {
    judge(Box::leak(Box::new(claim)))
}

fn third() -> Check {
    Check::number((Evidence::ClosedForm, || 2.0 / 3.0), (Evidence::Jet, || 2.0 / 3.0))
}

fn yes() -> Finding {
    Finding::new(true, "it does")
}

fn no() -> Finding {
    Finding::new(false, "it does not")
}

#[test]
fn a_number_that_rounds_is_reproduced() {
    assert!(judged(number_claim("0.667", third())).holds());
}

#[test]
fn a_number_cut_off_is_truncated_and_needs_an_erratum() {
    let claim = number_claim("0.666", third()).expecting(Verdict::Truncated);
    assert_eq!(judged(claim.clone()).faults, ["truncated without an erratum"]);
    assert!(judged(claim.with_erratum(erratum("0.667"))).holds());
}

#[test]
fn a_number_from_rounded_intermediates_is_told_from_a_wrong_one() {
    let check = || {
        Check::number_from_rounded((Evidence::ClosedForm, || 2.0 / 3.0), (Evidence::Jet, || 2.0 / 3.0), || 0.7 * 0.9)
    };
    let claim = number_claim("0.63", check()).expecting(Verdict::FromRounded).with_erratum(erratum("0.67"));
    assert!(judged(claim).holds());
    assert_eq!(judged(number_claim("0.62", check())).verdict, Verdict::NotReproduced);
}

#[test]
fn a_reading_is_right_within_its_resolution() {
    let check = |resolution: fn() -> f64| Check::Number {
        computed: (Evidence::ClosedForm, (|| 2.0 / 3.0) as fn() -> f64).into(),
        witness: (Evidence::Jet, (|| 2.0 / 3.0) as fn() -> f64).into(),
        from_rounded: None,
        resolution: Some(resolution),
        right: None,
    };
    assert_eq!(judged(number_claim("0.69", check(|| 0.05))).verdict, Verdict::ReadOff);
    assert_eq!(judged(number_claim("0.69", check(|| 0.01))).verdict, Verdict::NotReproduced);
}

#[test]
fn a_wrong_number_is_corrected_only_by_what_is_computed() {
    let claim = number_claim("0.76", third()).expecting(Verdict::Corrected);
    assert!(judged(claim.clone().with_erratum(erratum("0.67"))).holds());
    let wrongly = judged(claim.with_erratum(erratum("0.68")));
    assert_eq!(wrongly.verdict, Verdict::NotReproduced);
    assert!(wrongly.faults[0].starts_with("the correction is not what is computed"), "{:?}", wrongly.faults);
}

#[test]
fn an_erratum_that_starts_to_agree_fails() {
    let claim = number_claim("0.667", third()).with_erratum(erratum("0.667"));
    assert_eq!(judged(claim).faults, ["an erratum is on record, but the claim is reproduced"]);
}

#[test]
fn a_witness_that_disagrees_is_a_fault() {
    let check = Check::number((Evidence::ClosedForm, || 2.0 / 3.0), (Evidence::Jet, || 0.667));
    assert_eq!(judged(number_claim("0.667", check)).faults.len(), 1);
    // Another printed number need agree only to the printed digits.
    let check = Check::number((Evidence::ClosedForm, || 2.0 / 3.0), (Evidence::OtherPlaceInSource, || 0.667));
    assert!(judged(number_claim("0.667", check)).holds());
}

#[test]
fn characters_that_are_no_number_are_a_fault() {
    assert!(judged(number_claim("0.6.7", third())).faults[0].contains("`0.6.7`"));
}

#[test]
fn forms_hold_fail_or_are_corrected() {
    let holds = Check::equation((Evidence::ExactIdentity, yes), (Evidence::Jet, yes));
    assert!(judged(form_claim(holds)).holds());
    let fails = Check::equation((Evidence::ExactIdentity, no), (Evidence::Jet, yes));
    assert_eq!(judged(form_claim(fails)).verdict, Verdict::NotReproduced);
    let corrected = || Check::corrected_equation((Evidence::ExactIdentity, no), yes, (Evidence::Jet, yes));
    let claim = form_claim(corrected()).expecting(Verdict::Corrected);
    assert!(judged(claim.clone().with_erratum(erratum("x = y"))).holds());
    assert!(!judged(claim).holds());
    let agreeing = Check::corrected_equation((Evidence::ExactIdentity, yes), yes, (Evidence::Jet, yes));
    assert!(!judged(form_claim(agreeing)).holds());
    let unwitnessed = Check::equation((Evidence::ExactIdentity, yes), (Evidence::Jet, no));
    assert!(!judged(form_claim(unwitnessed)).holds());
}

fn in_error(right: [(Evidence, fn() -> f64); 2]) -> Check {
    Check::number_in_error((Evidence::ClosedForm, || 1.0 / 3.0), (Evidence::Jet, || 1.0 / 3.0), right)
}

#[test]
fn a_number_that_a_slip_gives_is_told_from_a_right_one() {
    let two_thirds = || in_error([(Evidence::ClosedForm, || 2.0 / 3.0), (Evidence::Jet, || 2.0 / 3.0)]);
    let claim = number_claim("0.33", two_thirds()).expecting(Verdict::ReproducedInError);
    assert_eq!(judged(claim.clone()).faults, ["reproduced-in-error without an erratum"]);
    let found = judged(claim.affected_by(SLIP));
    assert!(found.holds(), "{:?}", found.complaints());
    assert_eq!((found.truth(), found.corrected().as_deref()), (Truth::Wrong, Some("0.67")));
    // What the slip does not give is not reproduced, whatever is right.
    assert_eq!(judged(number_claim("0.34", two_thirds())).verdict, Verdict::NotReproduced);
    // Where the right number has the same digits, the slip changes nothing.
    let same = || in_error([(Evidence::ClosedForm, || 0.334), (Evidence::Jet, || 0.334)]);
    let found = judged(number_claim("0.33", same()));
    assert!(found.holds() && found.verdict == Verdict::Reproduced, "{:?}", found.complaints());
    assert!(!judged(number_claim("0.33", same()).affected_by(SLIP)).holds());
    let apart = || in_error([(Evidence::ClosedForm, || 2.0 / 3.0), (Evidence::Jet, || 0.667)]);
    assert_eq!(judged(number_claim("0.33", apart()).affected_by(SLIP)).faults.len(), 1);
}

fn is_right(stated: Stated) -> Finding {
    stated.pick(yes(), no())
}

#[test]
fn a_statement_is_told_from_its_neighbour_by_both_routes() {
    let of = |first: fn(Stated) -> Finding, witness: fn(Stated) -> Finding| {
        judged(form_claim(Check::statement("x = 2x", (Evidence::ExactIdentity, first), (Evidence::Jet, witness))))
    };
    assert!(of(is_right, is_right).holds());
    assert_eq!(of(|_| yes(), is_right).faults, ["the first route accepts the neighbour, x = 2x"]);
    assert_eq!(of(is_right, |_| yes()).faults, ["the witness accepts the neighbour, x = 2x"]);
    assert_eq!(of(|_| no(), is_right).verdict, Verdict::NotReproduced);
    assert_eq!(of(is_right, |_| no()).faults.len(), 1);
}

#[test]
fn a_statement_is_corrected_only_if_the_printed_form_fails_by_both_routes() {
    let of = |first: fn(Stated) -> Finding, witness: fn(Stated) -> Finding| {
        let check = Check::corrected_statement((Evidence::ExactIdentity, first), (Evidence::Jet, witness));
        judged(form_claim(check).expecting(Verdict::Corrected).with_erratum(erratum("x = y")))
    };
    assert!(of(is_right, is_right).holds());
    assert_eq!(of(|_| yes(), is_right).verdict, Verdict::Reproduced);
    assert_eq!(of(|_| no(), is_right).verdict, Verdict::NotReproduced);
    assert!(!of(is_right, |_| yes()).holds() && !of(is_right, |_| no()).holds());
}

#[test]
fn a_missing_datum_is_not_reproducible() {
    let claim = form_claim(Check::Missing { reason: "not printed" });
    assert!(judged(claim.expecting(Verdict::NotReproducible)).holds());
}
