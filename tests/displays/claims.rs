//! The verdict on every equation of a source hangs on its own characters: each misprint changes it.
//!
//! A claim has two routes, and each is tried on the misprint. One of them at least must refuse it or be unable to read it.

use super::Misprints;
use geneva_ledger::tex::Class;
use geneva_ledger::{Check, Claim, Finding, Kind, Work};
use std::collections::BTreeMap;

/// The equations of all sources.
fn equations() -> impl Iterator<Item = &'static Claim> {
    geneva_ledger::claims().iter().filter(|claim| claim.kind == Kind::Equation)
}

/// Whether a claim would stand with other characters in the place of the right ones; none if a route cannot read them and
/// none refuses them.
fn stands(claim: &Claim, tex: &str) -> Option<bool> {
    let Check::Equation { decide, reader, .. } = &claim.check else { return Some(true) };
    let first = decide.as_ref().map_or(Some(true), |decide| {
        let Finding { holds, evaluated, .. } = decide(tex);
        evaluated.then_some(holds)
    });
    let second = match reader {
        Some(reader) if first != Some(false) => (reader.holds)(tex),
        _ => first,
    };
    match (first, second) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

#[test]
fn every_equation_is_read_by_its_own_claim() {
    let mut count: BTreeMap<Work, [usize; 3]> = BTreeMap::new();
    for claim in equations() {
        let Check::Equation { decide, reader, .. } = &claim.check else {
            panic!("{}: neither route reads its characters", claim.id)
        };
        let routes = usize::from(decide.is_some()) + usize::from(reader.is_some());
        count.entry(claim.work).or_default()[routes] += 1;
    }
    println!("read by no route, by one, by both: {count:?}");
    assert!(count.values().all(|count| count[0] == 0), "{count:?}");
}

#[test]
fn every_misprint_in_a_source_is_noticed() {
    let mut misprints = Misprints::default();
    let mut by_work: BTreeMap<Work, usize> = BTreeMap::new();
    for claim in equations() {
        let refuted = misprints.make(claim.id, claim.right_characters(), |tex| stands(claim, tex));
        if refuted == 0 { println!("{}: no misprint is refuted", claim.id); }
        *by_work.entry(claim.work).or_default() += refuted;
    }
    println!("{by_work:?}");
    misprints.are_noticed_but_for(&[]);
    assert!(Class::ALL.iter().all(|class| misprints.refuted.contains_key(class)), "{:?}", misprints.refuted);
}
