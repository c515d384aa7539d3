//! Would a misprint in an equation that the ledger reads be noticed?
//!
//! Every equation is read somewhere: by the ledger itself, with values for every letter from vectors and Newton's laws;
//! or by the tests between the rooms, with values from the formula crates. Or it is checked like a statement, with a
//! neighbour made by hand. Which, it says itself.

use geneva_ledger::{Class, Work, claims, misprints};
use std::collections::BTreeMap;

/// Misprints that make no difference: the claim, the change, and why the equation says the same.
const SURVIVORS: &[(&str, &str, &str)] = &[
    ("meyer.virtual-work", r"piece 3: Q_\theta becomes \tau", "what is set equal is named twice"),
    ("meyer.virtual-work", r"piece 9: \tau becomes Q_\theta", "what is set equal is named twice"),
    ("meyer.generalised-torque", r"piece 0: Q_\theta becomes \tau", "what is set equal is named twice"),
    ("meyer.generalised-torque", r"piece 4: \tau becomes Q_\theta", "what is set equal is named twice"),
    ("meyer.eq-1-15", r"piece 0: \tau_1 becomes K", "what is set equal is named twice"),
    ("meyer.eq-1-15", r"piece 4: K becomes \tau_1", "what is set equal is named twice"),
    (
        "meyer.singularity.ratio",
        "piece 2: the fraction is turned over",
        "a fraction that is one is one turned over too",
    ),
    ("meyer.app-b.example.place", "piece 10: B becomes X", "B is X at the start"),
    ("meyer.app-b.s", "piece 9: F becomes S", "S has the sign of F"),
    ("meyer.app-b.s", "piece 21: F becomes S", "S has the sign of F"),
    (
        "meyer.app-d.acceleration",
        "piece 4: the index is lost",
        "the acceleration at the start is the one with the index",
    ),
];

#[test]
fn what_the_ledger_reads_holds_as_it_is_put_right_and_fails_as_it_is_printed_wrong() {
    for claim in claims() {
        let Some(reader) = claim.check.reader() else { continue };
        assert_eq!((reader.holds)(claim.right_characters()), Some(true), "{}", claim.id);
        if claim.erratum.is_some() && reader.said.is_none() {
            assert_ne!((reader.holds)(claim.printed), Some(true), "{} holds as printed", claim.id);
        }
    }
}

#[test]
fn every_misprint_in_an_equation_that_the_ledger_reads_is_noticed() {
    let (mut survivors, mut unreadable) = (Vec::new(), 0);
    let mut by_work: BTreeMap<Work, usize> = BTreeMap::new();
    let mut by_class: BTreeMap<Class, usize> = BTreeMap::new();
    for claim in claims() {
        let Some(reader) = claim.check.reader() else { continue };
        let mut refuted = 0;
        for misprint in misprints(claim.right_characters()) {
            match (reader.holds)(&misprint.tex) {
                Some(false) => {
                    refuted += 1;
                    *by_class.entry(misprint.class).or_default() += 1;
                }
                Some(true) => survivors.push((claim.id, misprint)),
                // What cannot be read any more is noticed too, but proves nothing.
                None => unreadable += 1,
            }
        }
        assert!(refuted > 0, "{}: no misprint is refuted", claim.id);
        *by_work.entry(claim.work).or_default() += refuted;
    }
    println!("refuted: {by_work:?}, {by_class:?}; {} not; {unreadable} cannot be read", survivors.len());
    let is_known = |id: &str, change: &str| SURVIVORS.iter().any(|(known, of, _)| *known == id && *of == change);
    let new: Vec<_> = survivors
        .iter()
        .filter(|(id, misprint)| !is_known(id, &misprint.change))
        .map(|(id, misprint)| format!("{id}, {}: {}", misprint.change, misprint.tex))
        .collect();
    assert!(new.is_empty(), "{} misprints make no difference:\n{}", new.len(), new.join("\n"));
    for (id, change, reason) in SURVIVORS {
        let is_left = survivors.iter().any(|(survivor, misprint)| survivor == id && misprint.change == *change);
        assert!(is_left, "{id}, {change}: it makes a difference, though {reason}");
    }
    assert!(Class::ALL.iter().all(|class| *class == Class::Root || by_class.contains_key(class)), "{by_class:?}");
}
