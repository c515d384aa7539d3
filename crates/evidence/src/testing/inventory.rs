//! The inventories of the documents that are mirrored line by line.

use super::{Guarded, Report};
use crate::coverage::{entry_numbers, line_gap, numbers_left};
use crate::{Document, Entry, Line};
use std::collections::HashMap;

/// The documents with their lines; those whose inventory cannot be read are reported by [`broken_lines`].
fn lines(guarded: Guarded) -> impl Iterator<Item = (&'static Document, &'static Line)> {
    guarded
        .ledger
        .mirrored()
        .iter()
        .flat_map(|document| document.lines().unwrap_or_default().iter().map(move |line| (*document, line)))
}

/// The inventories that cannot be read, and their lines out of order or without an entry.
pub fn broken_lines(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for document in guarded.ledger.mirrored() {
        let lines = match document.lines() {
            Ok(lines) => lines,
            Err(malformed) => {
                faults.push(malformed.to_string());
                continue;
            }
        };
        if !lines.is_sorted_by(|a, b| a.number < b.number) {
            faults.push(format!("{document}: its lines are not in order"));
        }
        let empty = lines.iter().filter(|line| line.entries.is_empty() && guarded.is_finished());
        faults.extend(empty.map(|line| format!("{document}, line {}: no entry", line.number)));
        tried += lines.len();
    }
    Report::new(tried, faults)
}

/// The lines whose entries do not account for exactly their numbers. While a ledger is unfinished, they may leave numbers over, which
/// are counted elsewhere.
pub fn unaccounted_numbers(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for (document, line) in lines(guarded) {
        tried += 1;
        let gap = if guarded.is_finished() { line_gap(document, line) } else { numbers_left(document, line).err() };
        faults.extend(gap.map(|gap| format!("{document}, line {}: {}: {gap}", line.number, line.numbers.join(" "))));
    }
    Report::new(tried, faults)
}

/// The entries with numbers that can be dropped without a gap.
pub fn dropped_entries(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for (document, line) in lines(guarded) {
        for (dropped, entry) in line.entries.iter().enumerate() {
            if entry_numbers(document, entry).is_empty() {
                continue;
            }
            tried += 1;
            let mut shorter = line.clone();
            shorter.entries.remove(dropped);
            if line_gap(document, &shorter).is_none() {
                faults.push(format!("{document}, line {}: without `{entry}` nothing is noticed", line.number));
            }
        }
    }
    Report::new(tried, faults)
}

/// A reason that is no longer than this, in bytes, says nothing.
const LEAST_REASON: usize = 20;

/// The claims that stand in no line of their document or in two, and the entries that refer to nothing: to no claim, to dots that are
/// not there or come later, to an equation or figure that no locator names; exceptions without a reason or that are claims.
pub fn misplaced_entries(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for document in guarded.ledger.mirrored() {
        let lines = document.lines().unwrap_or_default();
        let (mut made, mut filled): (HashMap<&str, usize>, HashMap<&str, usize>) = Default::default();
        let mut exceptions: Vec<&str> = Vec::new();
        for (line, entry) in lines.iter().flat_map(|line| line.entries.iter().map(move |entry| (line, entry))) {
            tried += 1;
            let mut fault = |wrong: bool, what: &str| {
                if wrong {
                    faults.push(format!("{document}, line {}, `{entry}`: {what}", line.number));
                }
            };
            match entry {
                Entry::Claim(id) | Entry::Reading(id) => {
                    *made.entry(id).or_default() += 1;
                    // A table or a broken equation goes on in later lines.
                    filled.insert(id, 0);
                    fault(document.claim(id).is_none(), "no claim has the id");
                }
                Entry::Rest(id, dots) => {
                    let before = filled.get_mut(id);
                    let next = before.is_some_and(|before| {
                        *before += 1;
                        *before == *dots
                    });
                    let there = document.claim(id).map_or(0, |claim| claim.printed.matches(r"\ldots").count());
                    fault(!next || *dots > there, "these dots do not come next");
                }
                Entry::Again(id) => fault(document.claim(id).is_none(), "no claim to print again"),
                Entry::Label(number) => {
                    let bears = |locator: &str| locator_words(locator).any(|word| word == *number);
                    let named = document.claims().iter().any(|claim| bears(claim.locator));
                    fault(!named, "nothing is numbered so");
                }
                Entry::Exception { id, reason, .. } => {
                    fault(
                        reason.len() <= LEAST_REASON,
                        "its reason is too short: say in a sentence why there is nothing to check",
                    );
                    fault(document.claim(id).is_some(), "it is a claim now: remove the exception");
                    fault(exceptions.contains(id), "it stands twice");
                    exceptions.push(id);
                }
            }
        }
        for claim in document.claims() {
            match made.get(claim.id) {
                Some(1) => {}
                Some(times) => faults.push(format!("{} stands in {times} lines", claim.id)),
                None => faults.push(format!("{} stands in no line", claim.id)),
            }
        }
    }
    Report::new(tried, faults)
}

/// The words of a locator without brackets and marks: `Eqs. (1-1) and (1-2)` names 1-1 and 1-2, and not 1.
fn locator_words(locator: &str) -> impl Iterator<Item = &str> {
    locator.split_whitespace().map(|word| word.trim_matches(|c: char| !c.is_alphanumeric()))
}

/// The inventories that would be written otherwise from a copy with the same numbers.
pub fn rewritten_inventories(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for document in guarded.ledger.mirrored() {
        tried += 1;
        let lines = document.lines().unwrap_or_default();
        let last = lines.last().map_or(0, |line| line.number);
        let numbers = |at: u32| lines.iter().find(|line| line.number == at).map(|line| line.numbers.join(" "));
        let copy: String = (1..=last).map(|at| format!("Words and {}.\r\n", numbers(at).unwrap_or_default())).collect();
        if document.inventory.is_some_and(|file| document.inventory_for(&copy) != file.text) {
            faults.push(format!("{document} is written otherwise"));
        }
    }
    Report::new(tried, faults)
}
