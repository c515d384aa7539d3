//! Guards that any ledger needs: would a wrong digit, sign, route or line be noticed?
//!
//! A check that cannot fail is not a check. Each guard spoils the ledger in one way, at every place where that can be done, and
//! reports each place at which nothing was noticed; or it reports what contradicts itself on record. [`check`] runs them all.
//!
//! ```no_run
//! # static LEDGER: geneva_evidence::Ledger = geneva_evidence::Ledger::new(&[], &[]);
//! #[test]
//! fn the_ledger_stands() {
//!     geneva_evidence::testing::check(&LEDGER);
//! }
//! ```

mod equations;
mod inventory;
mod records;
mod reliance;
mod spoiling;

pub use equations::{MisprintRecord, equation_misprints, equations_read, further_misprints};
pub use inventory::{broken_lines, dropped_entries, misplaced_entries, rewritten_inventories, unaccounted_numbers};
pub use records::{claim_records, contradicted_slips, differing_claims, evidence_in_use, other_units, unclear_symbols};
pub use reliance::{Reliance, circular_claims, own_digits_read, reliance, shared_results};
pub use spoiling::{
    endless_characters, other_numbers_in_sentences, spoilt_formulas, statement_neighbours, stopped_checks,
    wrong_digits, wrong_routes,
};

use crate::{Ledger, UnfinishedLine};
use std::cmp::Ordering;

/// A ledger to be guarded, with what is known to be an exception in it.
#[derive(Clone, Copy)]
pub struct Guarded {
    /// The ledger.
    pub ledger: &'static Ledger,
    /// Sentences that stay true with another number in them: the id of the claim, and why. An exception that is not needed any
    /// more is reported.
    pub free_numbers: &'static [(&'static str, &'static str)],
    /// Lines of its documents that are not yet accounted for; zero for a finished ledger.
    pub lines_to_do: usize,
}

/// What a guard found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// In how many places something was tried or looked at.
    pub tried: usize,
    /// What was not noticed there, or contradicts itself, a line each; empty if all is well.
    pub faults: Vec<String>,
}

/// A guard: what it asks for, and how it looks.
pub type Guard = (&'static str, fn(Guarded) -> Report);

/// All guards.
pub const GUARDS: &[Guard] = &[
    ("every claim agrees with its record", differing_claims),
    ("what is on record of a claim is complete", claim_records),
    ("what is on record of a slip is not contradicted by its places", contradicted_slips),
    ("another unit of a number is noticed", other_units),
    ("each of our symbols stands for one thing in a document", unclear_symbols),
    ("the kinds of evidence listed are those that are used", evidence_in_use),
    ("a statement has a neighbour", statement_neighbours),
    ("a wrong digit in a number is noticed", wrong_digits),
    ("another number in a sentence is noticed", other_numbers_in_sentences),
    ("a wrong route is noticed", wrong_routes),
    ("a formula that cannot be evaluated is a fault of its own claim", spoilt_formulas),
    ("no characters end the program", endless_characters),
    ("a check that stops is a fault of its own claim", stopped_checks),
    ("both routes of an equation read it", equations_read),
    ("a misprint in an equation is noticed", |guarded| equation_misprints(guarded).report),
    ("a further misprint in a wrong equation is noticed", |guarded| further_misprints(guarded).report),
    ("no claims rest on nothing but each other", circular_claims),
    ("what is computed does not look at the digits it is compared with", own_digits_read),
    ("the routes of a number share no printed result", shared_results),
    ("an inventory can be read and says something in each line", broken_lines),
    ("every number of every line is accounted for", unaccounted_numbers),
    ("a number that is dropped from an inventory is noticed", dropped_entries),
    ("every claim stands in its document once, and entries refer to claims", misplaced_entries),
    ("an inventory is written as it is read", rewritten_inventories),
];

impl Guarded {
    /// A ledger without exceptions.
    pub const fn new(ledger: &'static Ledger) -> Self {
        Self { ledger, free_numbers: &[], lines_to_do: 0 }
    }

    /// Whether every line is to be accounted for.
    pub fn is_finished(&self) -> bool {
        self.lines_to_do == 0
    }
}

impl Report {
    /// A report of these faults in so many places.
    pub(crate) fn new(tried: usize, faults: Vec<String>) -> Self {
        Self { tried, faults }
    }

    /// Panics with the faults, if there are any, or if fewer places than these were tried: a guard that finds nothing to spoil
    /// shows nothing.
    #[track_caller]
    pub fn expect(&self, least: usize) {
        let shown = self.faults.iter().take(40).map(String::as_str).collect::<Vec<_>>().join("\n");
        assert!(self.faults.is_empty(), "{} of {} tried:\n{shown}", self.faults.len(), self.tried);
        assert!(self.tried >= least, "only {} were tried, which should be at least {least}", self.tried);
    }
}

/// Runs all guards on a ledger without exceptions.
///
/// # Panics
/// If a guard finds a fault; the message has all faults of all guards.
#[track_caller]
pub fn check(ledger: &'static Ledger) {
    check_guarded(Guarded::new(ledger));
}

/// Runs all guards on a ledger that is still being written, of which so many lines are not yet accounted for. At zero it is the same
/// as [`check`].
///
/// The number can only fall: if more lines are to do than it says, one has lost an entry, and if fewer are, it must follow.
///
/// # Panics
/// If a guard finds a fault, and if the lines to do are not as many; the message has all faults and the number to write.
#[track_caller]
pub fn check_unfinished(ledger: &'static Ledger, lines_to_do: usize) {
    check_guarded(Guarded { lines_to_do, ..Guarded::new(ledger) });
}

/// What differs from the record in how many lines are to do, in words.
fn lines_differing(guarded: Guarded) -> Option<String> {
    // What cannot be read is a fault of another guard.
    let lines = guarded.ledger.unfinished_lines().ok()?;
    let (found, recorded) = (lines.len(), guarded.lines_to_do);
    let numbers = |line: &UnfinishedLine| format!("{}, {line}", line.document);
    let listed = lines.iter().map(numbers).collect::<Vec<_>>().join("\n  ");
    match found.cmp(&recorded) {
        _ if guarded.is_finished() => None,
        Ordering::Equal => None,
        Ordering::Less => Some(format!(
            "{found} lines are still to be accounted for, and {recorded} are on record; write {found} there, so that none is lost \
             again"
        )),
        Ordering::Greater => Some(format!(
            "{found} lines are still to be accounted for, and only {recorded} are on record; account for them, or write {found} \
             there if the document has grown:\n  {listed}"
        )),
    }
}

/// Runs all guards on a ledger with exceptions.
///
/// # Panics
/// As [`check_unfinished`].
#[track_caller]
pub fn check_guarded(guarded: Guarded) {
    let mut all = Vec::new();
    for (asks, guard) in GUARDS {
        all.extend(guard(guarded).faults.iter().map(|fault| format!("{asks}: {fault}")));
    }
    all.extend(lines_differing(guarded));
    let plural = if all.len() == 1 { "" } else { "s" };
    assert!(all.is_empty(), "{} fault{plural}:\n{}", all.len(), all.join("\n"));
}
