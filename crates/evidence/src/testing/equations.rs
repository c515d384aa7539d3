//! Equations: each misprint of each one changes its verdict.
//!
//! A claim has two routes, and each is tried on the misprint. At least one of them must refuse it or be unable to read it, and
//! in each claim there are misprints that both refuse. The few that change nothing mean the same, and a rule says why.

use super::{Guarded, Report};
use crate::tex::{Class, Misprint, changed_part, misprints, places_changed};
use crate::{Check, Claim, Kind};
use std::collections::BTreeMap;

/// What became of the misprints that were made by rule.
#[derive(Clone, Debug, Default)]
pub struct MisprintRecord {
    /// The misprints made, and what was not noticed.
    pub report: Report,
    /// How many were refuted, by class.
    pub refuted: BTreeMap<Class, usize>,
    /// How many of these were refuted by both routes.
    pub refuted_by_both: usize,
    /// How many could not be read any more: they are noticed too, but prove nothing.
    pub unreadable: usize,
    /// How many say the same as the right characters, by the rule that says why.
    pub harmless: BTreeMap<&'static str, usize>,
}

fn equations(guarded: Guarded) -> impl Iterator<Item = &'static Claim> {
    guarded.ledger.claims().iter().copied().filter(|claim| matches!(claim.check, Check::Equation { .. }))
}

/// The equations that a route of theirs does not read and accept in their right form.
pub fn equations_read(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for claim in guarded.ledger.claims().iter().filter(|claim| claim.kind == Kind::Equation) {
        tried += 1;
        let right = claim.right_characters();
        let mut accepts = claim.read_with(right) == Some([Some(true); 2]);
        // What is said in the letters of mathematics is not what is printed, and both are read.
        if claim.erratum.is_none() && right != claim.printed {
            accepts &= claim.read_with(claim.printed) == Some([Some(true); 2]);
        }
        if !accepts && !matches!(claim.check, Check::Missing { .. }) {
            faults.push(format!("{}: {:?}", claim.id, claim.read_with(right)));
        }
    }
    Report::new(tried, faults)
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

/// Makes every misprint of every equation; not noticed are those that both routes accept and that do not say the same by a rule.
pub fn equation_misprints(guarded: Guarded) -> MisprintRecord {
    let mut record = MisprintRecord::default();
    for claim in equations(guarded) {
        let (mut refuted, mut by_both) = (0, 0);
        for misprint in misprints(claim.right_characters()) {
            record.report.tried += 1;
            by_both += usize::from(claim.read_with(&misprint.tex) == Some([Some(false); 2]));
            match claim.stands_with(&misprint.tex) {
                Some(false) => {
                    refuted += 1;
                    *record.refuted.entry(misprint.class).or_default() += 1;
                }
                None => record.unreadable += 1,
                Some(true) => match means_the_same(claim, &misprint) {
                    Some(reason) => *record.harmless.entry(reason).or_default() += 1,
                    None => record.report.faults.push(format!("{} {}: {}", claim.id, misprint.change, misprint.tex)),
                },
            }
        }
        if by_both == 0 {
            record.report.faults.push(format!("{}: of {refuted} refuted, none is refuted by both routes", claim.id));
        }
        record.refuted_by_both += by_both;
    }
    record
}

/// Makes every misprint of every equation that is wrong as printed. The verdict stays that it is wrong; but the record says in how
/// many places it is, so only a misprint at one of these places is not noticed (`unreadable` counts those). An equation of
/// which no misprint is noticed is a fault.
pub fn further_misprints(guarded: Guarded) -> MisprintRecord {
    let mut record = MisprintRecord::default();
    for claim in equations(guarded) {
        let Some(erratum) = &claim.erratum else { continue };
        let all = misprints(claim.printed);
        let elsewhere = |misprint: &&Misprint| places_changed(&misprint.tex, erratum.corrected) != erratum.places;
        let mut noticed = 0;
        for misprint in all.iter().filter(elsewhere) {
            noticed += 1;
            *record.refuted.entry(misprint.class).or_default() += 1;
        }
        if noticed == 0 {
            record.report.faults.push(format!("{}: none of {} is noticed", claim.id, all.len()));
        }
        record.report.tried += all.len();
        record.unreadable += all.len() - noticed;
    }
    record
}
