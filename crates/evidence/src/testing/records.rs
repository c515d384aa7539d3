//! What is on record: ids, words, errata, slips, units, symbols.

use super::{Guarded, Report};
use crate::units::expected_unit;
use crate::{Check, Claim, Evidence, Kind, judge};
use std::collections::HashSet;

/// The claims that differ from their record, each with what contradicts it.
pub fn differing_claims(guarded: Guarded) -> Report {
    let verdicts = guarded.ledger.verdicts();
    let differing = verdicts.iter().filter(|judged| !judged.matches_record());
    let faults = differing.map(|judged| format!("{}: {}", judged.claim.id, judged.complaints().join("; "))).collect();
    Report::new(verdicts.len(), faults)
}

/// What the record of a claim lacks: an id of its own in its document's name, words for what and where, a correction that changes
/// something, with reason and witness; and answers and conclusions of a document that are no claims of it.
pub fn claim_records(guarded: Guarded) -> Report {
    let (claims, mut seen, mut faults) = (guarded.ledger.claims(), HashSet::new(), Vec::new());
    let mut fault = |wrong: bool, id: &str, what: &str| {
        if wrong {
            faults.push(format!("{id}: {what}"));
        }
    };
    for claim in claims {
        fault(!seen.insert(claim.id), claim.id, "the id stands twice");
        let name = claim.id.strip_prefix(claim.document.slug).and_then(|rest| rest.strip_prefix('.'));
        let well_formed = name.is_some_and(|name| {
            !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || ".-".contains(c))
        });
        fault(!well_formed, claim.id, "an id is the document's name, a point, and lower-case words");
        let wordless = claim.meaning.is_empty() || claim.locator.is_empty() || claim.printed.is_empty();
        fault(wordless, claim.id, "it does not say what, where or which characters");
        let reasonless = matches!(claim.check, Check::Missing { reason: "" });
        fault(reasonless, claim.id, "it does not say what is missing");
        if let Some(erratum) = &claim.erratum {
            fault(erratum.corrected == claim.printed, claim.id, "the correction changes nothing");
            let alone = erratum.slip.reason.is_empty() || erratum.slip.witness.is_empty();
            fault(alone, claim.id, "the erratum does not say why or who else says so");
        }
    }
    for document in guarded.ledger.documents() {
        for id in document.answers {
            fault(document.claim(id).is_none(), id, "an answer, but no claim of its document");
        }
        for (id, shown) in document.conclusions {
            let statement = document.claim(id).is_some_and(|claim| claim.kind == Kind::Statement);
            fault(!statement || shown.is_empty(), id, "a conclusion, but no statement of its document");
        }
    }
    Report::new(claims.len(), faults)
}

/// What contradicts the consequence on record of a slip.
pub fn contradicted_slips(guarded: Guarded) -> Report {
    let slips = guarded.ledger.slips();
    Report::new(slips.len(), slips.iter().flat_map(|slip| slip.faults()).collect())
}

/// The numbers whose unit nobody would miss: with another unit they agree with their record, or nothing says what unit they have;
/// and the entries of a document's units that no number uses, unless the ledger is unfinished.
pub fn other_units(guarded: Guarded) -> Report {
    let (mut used, mut tried, mut faults) = (HashSet::new(), 0, Vec::new());
    for claim in guarded.ledger.claims().iter().filter(|claim| claim.kind == Kind::Value) {
        let Some((words, unit)) = expected_unit(claim) else {
            faults.push(format!(
                "{}: what is its unit? No words in the document's `units` begin its meaning, \"{}\"; add (\"{}\", \"{}\") there",
                claim.id,
                claim.meaning,
                claim.meaning.split(' ').next().unwrap_or_default(),
                claim.unit
            ));
            continue;
        };
        used.insert((claim.document.slug, words));
        for other in ["m", "mm", "rad", "rad/s", "1/s", "m/s", "%", ""].into_iter().filter(|other| *other != unit) {
            tried += 1;
            let judged = judge(Box::leak(Box::new(Claim { unit: other, ..Claim::clone(claim) })));
            if judged.matches_record() {
                faults.push(format!("{}: it agrees with its record in {other}", claim.id));
            }
        }
    }
    for document in guarded.ledger.documents() {
        for (words, _) in document.units {
            if guarded.is_finished() && !used.contains(&(document.slug, words)) {
                faults.push(format!("{document}: no number is \"{words}\""));
            }
        }
    }
    Report::new(tried, faults)
}

/// The symbols of ours that stand for two letters of one document.
pub fn unclear_symbols(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for document in guarded.ledger.documents() {
        for symbol in document.symbols {
            tried += 1;
            if document.symbols.iter().filter(|other| other.ours == symbol.ours).count() > 1 {
                faults.push(format!("{document}: {} stands for two things", symbol.ours));
            }
        }
    }
    Report::new(tried, faults)
}

/// The kinds of evidence that claims use and the ledger does not list, and those that it lists and no claim uses, unless the ledger is
/// unfinished.
pub fn evidence_in_use(guarded: Guarded) -> Report {
    let listed = guarded.ledger.evidence();
    let used: HashSet<_> = guarded.ledger.claims().iter().flat_map(|claim| claim.check.evidence()).collect();
    let unlisted = used
        .iter()
        .filter(|kind| !listed.contains(kind))
        .map(|kind| format!("{kind} is not listed; add it to the kinds of evidence of the ledger"));
    let is_unused = |kind: &&&Evidence| guarded.is_finished() && !used.contains(**kind);
    let unused = listed.iter().filter(is_unused).map(|kind| format!("{kind} is used by no claim"));
    Report::new(listed.len(), unlisted.chain(unused).collect())
}
