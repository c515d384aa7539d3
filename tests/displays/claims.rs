//! The equations of the sources, as the ledger prints and corrects them, hold or fail as its verdicts say.

use super::letters::{equation, states};
use super::mutants::mutants;
use super::tex::{read, read_pieces};
use super::value::holds;
use geneva_ledger::{Claim, Kind, Verdict, Work};
use std::collections::BTreeMap;

/// Equations that are left to the ledger's own routes, and why.
const OUTSIDE: &[(&str, &str)] = &[
    ("pin.sine-at-pivot", "its divisor is a rounded number"),
    ("quick-return.p-is-zero", "it says where the origin is put"),
    ("quick-return.pin-tangential", "its reason stands in words beside it"),
    ("jazar.ex-a.formula", "a number alone"),
    ("jazar.ex-d.driver-formula", "a number alone"),
    ("jazar.ex-e.driver-formula", "a number alone"),
    ("jazar.ex-e.ratio-form", "a quantity alone"),
];

/// Printed equations that cannot be evaluated as they are; their corrections can.
const ILLEGIBLE: &[(&str, &str)] = &[
    ("pin.centre-distance", "a bar where the root sign was"),
    ("pin.pin-speed-equation", "a v that is no speed"),
    ("pin.follower-speed-equation", "a v that is no speed"),
];

fn evaluated(claim: &Claim, tex: &str) -> Result<bool, String> {
    holds(&read(&equation(claim, tex))?, &states(claim))
}

/// Equations in which some misprints make no difference, and why.
const SURVIVORS: &[(&str, &str)] = &[
    ("quick-return.rate-conversion", "a fraction that is one is one turned over too"),
    ("quick-return.sum-of-places-by-points", "the letter has the same meaning without its index"),
    ("quick-return.sliding-normal", "any power over an infinite radius is zero"),
    ("meyer.phi-0", "an angle at the hand-over is the one with the index"),
    ("meyer.theta-0", "an angle at the hand-over is the one with the index"),
    ("meyer.quotient-rule", "a constant has no rate of change"),
    ("meyer.acceleration-by-quotient", "a constant has no rate of change"),
    ("meyer.app-a.three-slots.radius-equation", "an angle at the hand-over is the one with the index"),
    ("meyer.app-a.four-slots.centre-equation", "at half a right angle sine and cosine are equal"),
    ("meyer.app-a.four-slots.radius-equation", "at half a right angle sine and cosine are equal"),
    ("meyer.app-a.six-slots.radius-equation", "an angle at the hand-over is the one with the index"),
];

/// The equations of all sources that are not left out.
fn equations() -> Vec<Claim> {
    let works = [Work::Pin, Work::QuickReturn, Work::Jazar2003, Work::Meyer1973];
    let outside = |claim: &Claim| OUTSIDE.iter().any(|(id, _)| *id == claim.id);
    let claims = works.into_iter().flat_map(Work::claims);
    claims.filter(|claim| claim.kind == Kind::Equation && !outside(claim) && !is_read_by_the_ledger(claim)).collect()
}

/// Whether the ledger itself reads the claim's printed characters: it does so for the thesis's dynamics, with values for
/// every letter from vectors and Newton's laws.
fn is_read_by_the_ledger(claim: &Claim) -> bool {
    let makes = |line: &&geneva_ledger::Line| line.entries.iter().any(|entry| entry.claimed() == Some(claim.id));
    let line = claim.work.inventory().iter().find(makes).map_or(0, |line| line.number);
    claim.work == Work::Meyer1973 && ((227..540).contains(&line) || line > 592)
}

#[test]
fn equations_hold_or_fail_as_the_verdicts_say() {
    let (mut wrong, mut count) = (Vec::new(), BTreeMap::new());
    for claim in equations() {
        let printed = evaluated(&claim, claim.printed);
        let corrected = claim.erratum.as_ref().map(|erratum| evaluated(&claim, erratum.corrected));
        let illegible = ILLEGIBLE.iter().any(|(id, _)| *id == claim.id) && printed.is_err();
        let as_expected = match (claim.expected, &printed, &corrected) {
            (Verdict::Reproduced, Ok(true), None) => true,
            (Verdict::Corrected, Ok(false), Some(Ok(true))) => true,
            (Verdict::Corrected, Err(_), Some(Ok(true))) => illegible,
            _ => false,
        };
        if as_expected {
            let [right, put_right]: &mut [u32; 2] = count.entry(claim.work).or_default();
            *if corrected.is_some() { put_right } else { right } += 1;
        } else {
            wrong.push(format!("{}: `{}`: {printed:?}, corrected {corrected:?}", claim.id, claim.printed));
        }
    }
    println!("right as printed, and corrected: {count:?}; left out: {}", OUTSIDE.len());
    let way_out = "give what its letters stand for in `letters.rs`, or leave it out in `OUTSIDE` with a reason";
    assert!(wrong.is_empty(), "{}\nIf nothing is wrong: {way_out}", wrong.join("\n"));
    let least =
        [(Work::Pin, [6, 3]), (Work::QuickReturn, [21, 3]), (Work::Jazar2003, [27, 2]), (Work::Meyer1973, [28, 4])];
    for (work, [right, put_right]) in least {
        let found = count.get(&work).copied().unwrap_or_default();
        assert!(found[0] >= right && found[1] >= put_right, "{work}: {found:?}");
    }
}

#[test]
fn no_equation_is_left_out_without_need() {
    for (id, reason) in OUTSIDE {
        let claim = Work::ALL.iter().flat_map(|work| work.claims()).find(|claim| claim.id == *id);
        let claim = claim.unwrap_or_else(|| panic!("no claim {id} ({reason})"));
        assert!(evaluated(&claim, claim.printed) != Ok(true), "{id} can be evaluated");
    }
}

#[test]
fn a_misprint_in_a_source_would_be_noticed() {
    let (mut refuted, mut survivors) = (0, Vec::new());
    for claim in equations() {
        let right = claim.erratum.as_ref().map_or(claim.printed, |erratum| erratum.corrected);
        let states = states(&claim);
        for mutant in mutants(&equation(&claim, right)) {
            match read_pieces(&mutant.pieces).and_then(|display| holds(&display, &states)) {
                Ok(false) => refuted += 1,
                Ok(true) => survivors.push((claim.id, mutant.change)),
                Err(_) => {}
            }
        }
    }
    println!("{refuted} misprints refuted, {} not", survivors.len());
    for (id, change) in &survivors {
        assert!(SURVIVORS.iter().any(|(known, _)| known == id), "{id}: {change}, and it makes no difference");
    }
    for (id, reason) in SURVIVORS {
        assert!(survivors.iter().any(|(survivor, _)| survivor == id), "{id}: every misprint counts, though {reason}");
    }
    assert!(refuted >= 1400 && refuted > 19 * survivors.len(), "{refuted}");
}
