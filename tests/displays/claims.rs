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

/// Misprints that make no difference: the claim, why the equation says the same, and the changes.
const SURVIVORS: &[(&str, &str, &[&str])] = &[
    (
        "quick-return.rate-conversion",
        "a fraction that is one is one turned over too",
        &["piece 16: the fraction is turned over", "piece 27: the fraction is turned over"],
    ),
    (
        "quick-return.sum-of-places-by-points",
        "the letter has the same meaning without its index",
        &["piece 1: the index is lost"],
    ),
    (
        "quick-return.sliding-normal",
        "anything over an infinite radius is zero, and zero has no sign",
        &[
            "piece 0: a minus is put before it",
            "piece 12: a minus is put before it",
            "piece 14: v_{P2/P4} becomes A_{P2/P4}^n",
            "piece 23: what is raised is lost",
            "piece 24: 2 becomes 3",
            "piece 24: 2 becomes 1",
        ],
    ),
    ("jazar.eq-5.34", "both signs are meant", &["piece 0: a minus is put before it"]),
    ("meyer.phi-0", "what is set equal is named twice", &HANDING_OVER[0]),
    ("meyer.theta-0", "what is set equal is named twice", &HANDING_OVER[1]),
    (
        "meyer.acceleration-by-quotient",
        "a constant has no rate of change",
        &[
            "piece 32: - becomes +",
            "piece 33: 1 becomes 2",
            "piece 33: 1 becomes 0",
            "piece 52: 1 becomes 2",
            "piece 52: 1 becomes 0",
            "piece 53: + becomes -",
            "piece 55: what is raised is lost",
            "piece 56: 2 becomes 3",
            "piece 56: 2 becomes 1",
        ],
    ),
    (
        "meyer.app-a.four-slots.centre-equation",
        "at half a right angle sine and cosine are equal",
        &[r"piece 7: \sin becomes \cos", r"piece 20: \sin becomes \cos"],
    ),
    (
        "meyer.app-a.four-slots.radius-equation",
        "four slots: both radii are one, both angles half a right angle",
        &[
            "piece 0: R becomes r",
            "piece 2: the fraction is turned over",
            "piece 4: r becomes R",
            "piece 4: r is lost",
            r"piece 5: \sin becomes \cos",
            r"piece 6: \theta_o becomes \phi_o",
            "piece 7: the index is lost",
            r"piece 11: \sin becomes \cos",
            r"piece 12: \phi_o becomes \theta_o",
            "piece 13: the index is lost",
            "piece 17: the fraction is turned over",
            r"piece 20: \sin becomes \cos",
            r"piece 26: \sin becomes \cos",
        ],
    ),
    ("meyer.app-a.three-slots.radius-equation", ONE_RADIUS, &LOST),
    ("meyer.app-a.six-slots.radius-equation", ONE_RADIUS, &LOST),
];

/// The angles at the hand-over have two names each in their displays.
const HANDING_OVER: [[&str; 3]; 2] = [
    [r"piece 0: \phi becomes \phi_0", r"piece 2: \phi_0 becomes \phi", "piece 3: the index is lost"],
    [r"piece 0: \theta becomes \theta_0", r"piece 2: \theta_0 becomes \theta", "piece 3: the index is lost"],
];

const ONE_RADIUS: &str = "the radius is one, and the angles are those at the hand-over";
const LOST: [&str; 3] = ["piece 4: r is lost", "piece 7: the index is lost", "piece 13: the index is lost"];

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
fn every_equation_is_read_or_has_a_neighbour() {
    let mut count: BTreeMap<Work, [usize; 3]> = BTreeMap::new();
    for claim in geneva_ledger::claims().iter().filter(|claim| claim.kind == Kind::Equation) {
        let here = || evaluated(claim, claim.right_characters()) == Ok(true);
        let way = match claim.check {
            Check::Equation { .. } if claim.check.reader().is_some() => 0,
            Check::Equation { .. } if here() => 1,
            Check::Statement { .. } => 2,
            _ => panic!("{}: nobody reads it, and it has no neighbour", claim.id),
        };
        count.entry(claim.work).or_default()[way] += 1;
    }
    println!("read by the ledger, read here, with a neighbour made by hand: {count:?}");
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
        [(Work::Pin, [6, 3]), (Work::QuickReturn, [22, 2]), (Work::Jazar2003, [27, 2]), (Work::Meyer1973, [28, 4])];
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
    let known = SURVIVORS.iter().flat_map(|(id, reason, changes)| changes.iter().map(move |of| (*id, *of, reason)));
    let is_known = |id: &str, change: &str| known.clone().any(|(known, of, _)| known == id && of == change);
    let new: Vec<_> = survivors
        .iter()
        .filter(|(id, misprint)| !is_known(id, &misprint.change))
        .map(|(id, misprint)| format!("{id}, {}: {}", misprint.change, misprint.tex))
        .collect();
    assert!(new.is_empty(), "{} misprints make no difference:\n{}", new.len(), new.join("\n"));
    for (id, change, reason) in known {
        let is_left = survivors.iter().any(|(survivor, misprint)| *survivor == id && misprint.change == change);
        assert!(is_left, "{id}, {change}: it makes a difference, though {reason}");
    }
}
