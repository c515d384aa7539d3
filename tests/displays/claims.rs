//! The equations of the sources, as the ledger prints and corrects them, hold or fail as its verdicts say.
//!
//! Those that the ledger reads itself, and those that are checked like statements, say so and are not read here.

use super::letters::{equation, states};
use super::tex::read;
use super::value::holds;
use geneva_ledger::{Check, Claim, Kind, Verdict, Work, misprints};
use std::collections::BTreeMap;

/// Printed equations that cannot be evaluated as they are; their corrections can.
const ILLEGIBLE: &[(&str, &str)] = &[
    ("pin.centre-distance", "a bar where the root sign was"),
    ("pin.pin-speed-equation", "a v that is no speed"),
    ("pin.follower-speed-equation", "a v that is no speed"),
];

fn evaluated(claim: &Claim, tex: &str) -> Result<bool, String> {
    holds(&read(&equation(claim, tex))?, &states(claim))
}

/// Misprints that make no difference: the claim, the change, and why the equation says the same.
const SURVIVORS: &[(&str, &str, &str)] = &[];

/// The equations of all sources that are read here: all but those that the ledger reads, or that have a neighbour.
fn equations() -> Vec<&'static Claim> {
    let elsewhere = |claim: &Claim| claim.check.reader().is_some() || matches!(claim.check, Check::Statement { .. });
    Work::ALL
        .iter()
        .flat_map(|work| geneva_ledger::claims().iter().filter(|claim| claim.work == *work))
        .filter(|claim| claim.kind == Kind::Equation && !elsewhere(claim))
        .collect()
}

#[test]
fn equations_hold_or_fail_as_the_verdicts_say() {
    let (mut wrong, mut count) = (Vec::new(), BTreeMap::new());
    for claim in equations() {
        let printed = evaluated(claim, claim.printed);
        let corrected = claim.erratum.as_ref().map(|erratum| evaluated(claim, erratum.corrected));
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
    println!("right as printed, and corrected: {count:?}");
    let way_out = "give what its letters stand for in `letters.rs`, or check it like a statement, with a neighbour";
    assert!(wrong.is_empty(), "{}\nIf nothing is wrong: {way_out}", wrong.join("\n"));
    let least =
        [(Work::Pin, [6, 3]), (Work::QuickReturn, [21, 3]), (Work::Jazar2003, [27, 2]), (Work::Meyer1973, [28, 4])];
    for (work, [right, put_right]) in least {
        let found = count.get(&work).copied().unwrap_or_default();
        assert!(found[0] >= right && found[1] >= put_right, "{work}: {found:?}");
    }
}

#[test]
fn every_misprint_in_a_source_is_noticed() {
    let (mut survivors, mut unreadable) = (Vec::new(), 0);
    let mut by_work: BTreeMap<Work, usize> = BTreeMap::new();
    for claim in equations() {
        let states = states(claim);
        let mut refuted = 0;
        for misprint in misprints(&equation(claim, claim.right_characters())) {
            match read(&misprint.tex).and_then(|display| holds(&display, &states)) {
                Ok(false) => refuted += 1,
                Ok(true) => survivors.push((claim.id, misprint)),
                // What cannot be read any more is noticed too, but proves nothing.
                Err(_) => unreadable += 1,
            }
        }
        assert!(refuted > 0, "{}: no misprint is refuted", claim.id);
        *by_work.entry(claim.work).or_default() += refuted;
    }
    println!("refuted: {by_work:?}; {} not; {unreadable} cannot be read", survivors.len());
    let is_known = |id: &str, change: &str| SURVIVORS.iter().any(|(known, of, _)| *known == id && *of == change);
    let new: Vec<_> = survivors
        .iter()
        .filter(|(id, misprint)| !is_known(id, &misprint.change))
        .map(|(id, misprint)| format!("(\"{id}\", \"{}\", \"\"), // {}", misprint.change, misprint.tex))
        .collect();
    assert!(new.is_empty(), "{} misprints make no difference:\n{}", new.len(), new.join("\n"));
    for (id, change, reason) in SURVIVORS {
        let is_left = survivors.iter().any(|(survivor, misprint)| survivor == id && misprint.change == *change);
        assert!(is_left, "{id}, {change}: it makes a difference, though {reason}");
    }
}
