//! The verdict on every equation of a source hangs on its own characters: each misprint changes it.
//!
//! A claim has two routes, and each is tried on the misprint. At least one of them must refuse it or be unable to read it, and
//! in each claim there are misprints that both refuse. The few that change nothing mean the same, and a rule says why.

use super::Misprints;
use geneva_ledger::tex::{Class, Misprint, changed_part, misprints, places_changed};
use geneva_ledger::{Check, Claim, Kind, Work, judge};
use std::cell::Cell;
use std::collections::BTreeMap;

/// The equations of all sources.
fn equations() -> impl Iterator<Item = &'static Claim> {
    geneva_ledger::claims().iter().filter(|claim| claim.kind == Kind::Equation)
}

/// Why a misprint means the same; none if no rule says so.
fn means_the_same(claim: &Claim, misprint: &Misprint) -> Option<&'static str> {
    let right = claim.right_characters();
    // The claim's own witness compares what has changed with what it was.
    let Check::Equation { witness, .. } = &claim.check else { return None };
    let is_equal = |part: String| (witness.run)(&part) == Some(true);
    if changed_part(right, &misprint.tex).is_some_and(is_equal) {
        return Some("the changed part has the value that it had, wherever the equation must hold");
    }
    let without_dots = |tex: &str| tex.replace(r"\ldots", "").split_whitespace().collect::<String>();
    if right.contains(r"\ldots") && without_dots(right) == without_dots(&misprint.tex) {
        return Some("the dots are the break between two lines");
    }
    None
}

#[test]
fn every_equation_is_read_by_both_of_its_routes() {
    for claim in equations() {
        let right = claim.right_characters();
        assert_eq!(claim.read_with(right), Some([Some(true); 2]), "{}", claim.id);
        // What is said in the letters of mathematics is not what is printed, and both are read.
        if claim.erratum.is_none() && right != claim.printed {
            assert_eq!(claim.read_with(claim.printed), Some([Some(true); 2]), "{}", claim.id);
        }
    }
}

#[test]
fn every_misprint_in_a_source_is_noticed() {
    let mut misprints = Misprints::default();
    let (mut by_work, mut by_both): (BTreeMap<Work, usize>, usize) = (BTreeMap::new(), 0);
    for claim in equations() {
        let both = Cell::new(0);
        let refuted = misprints.make(claim.id, claim.right_characters(), |tex| {
            both.set(both.get() + usize::from(claim.read_with(tex) == Some([Some(false); 2])));
            claim.stands_with(tex)
        });
        assert!(both.get() > 0, "{}: of {refuted} misprints that are refuted, none is by both routes", claim.id);
        by_both += both.get();
        *by_work.entry(claim.work).or_default() += refuted;
    }
    println!("{by_work:?}");
    let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
    let mut unnoticed = Vec::new();
    for (id, misprint) in &misprints.survivors {
        let claim = geneva_ledger::claim(id).expect("a claim");
        match means_the_same(claim, misprint) {
            Some(reason) => *reasons.entry(reason).or_default() += 1,
            None => unnoticed.push(format!("{id} {}: {}", misprint.change, misprint.tex)),
        }
    }
    println!("{reasons:?}");
    assert!(unnoticed.is_empty(), "{} misprints change no verdict:\n{}", unnoticed.len(), unnoticed.join("\n"));
    assert!(Class::ALL.iter().all(|class| misprints.refuted.contains_key(class)), "{:?}", misprints.refuted);
    // The record tells the book.
    let (refuted, harmless) = (misprints.refuted.values().sum::<usize>(), misprints.survivors.len());
    is_recorded(
        "misprints.csv",
        &format!(
            "refuted,{refuted}\nrefuted-by-both,{by_both}\nunreadable,{}\nharmless,{harmless}\n",
            misprints.unreadable
        ),
    );
}

#[test]
fn a_further_misprint_in_a_wrong_equation_is_noticed() {
    // The verdict stays that the equation is wrong. But the record says in how many places it is, so only a misprint at one of these
    // places is not noticed.
    let (mut noticed, mut at_the_slip) = (0, 0);
    for claim in equations() {
        let Some(erratum) = &claim.erratum else { continue };
        let all = misprints(claim.printed);
        let elsewhere = |misprint: &&Misprint| places_changed(&misprint.tex, erratum.corrected) != erratum.places;
        let found = all.iter().filter(elsewhere).count();
        assert!(found > 0, "{}: none of {} is noticed", claim.id, all.len());
        (noticed, at_the_slip) = (noticed + found, at_the_slip + all.len() - found);
    }
    is_recorded("misprints-of-wrong.csv", &format!("noticed,{noticed}\nat-the-slip,{at_the_slip}\n"));

    let claim = geneva_ledger::claim("meyer.eq-1-17").expect("a claim");
    let (wrong, changed) = (claim.printed, claim.printed.replacen("I_D", "I_f", 1));
    assert_ne!(changed, wrong);
    let judged = judge(Box::leak(Box::new(Claim { printed: changed.leak(), ..claim.clone() })));
    assert_eq!(judged.verdict, claim.expected);
    assert!(
        judged.faults.iter().any(|fault| fault.contains("in 2 places, and one is on record")),
        "{:?}",
        judged.faults
    );
}

/// Whether a record of the book is up to date; it is written if it is not.
#[track_caller]
fn is_recorded(name: &str, record: &str) {
    let file = crate::path("book/records").join(name);
    if !std::fs::read_to_string(&file).is_ok_and(|standing| standing == record) {
        std::fs::write(&file, record).expect("written");
        panic!("{} was not up to date and is now: look at the difference and test again", file.display());
    }
}
