//! What the sources print, what we compute, and the verdict: the only crate that knows both.
//!
//! A claim is one row: a stable id, its place in the source, the printed characters, how the quantity is computed, a
//! second route that shares no code with the first, and the verdict that is expected. [`judge`] derives the verdict. A
//! claim holds if the derived verdict is the recorded one and nothing contradicts it. Everything shown anywhere (tests,
//! tables of the book, command line, JSON, CSV) is drawn from [`claims`].
//!
//! What is computed comes from the formula crates, from the study of the runs in `geneva-case1973`, or from a second route
//! beside the claim that it serves. A printed number is written here and nowhere else.

mod agreement;
mod by_id;
mod check;
mod claim;
mod dimension;
mod duals;
mod inventory;
mod inventory_file;
mod judge;
mod number_words;
mod printed;
mod slip;
mod slugs;
mod stated;
mod tolerance;
mod triangle;
mod units;
mod verdict;
mod vocabulary;
mod work;

pub mod jazar;
pub mod meyer;
pub mod pin;
pub mod quick_return;
pub mod tex;
pub mod wild;

pub use by_id::looked_up_by;
pub use check::{Check, Choice, Decision, Evidence, Finding, Number, Reading, Route, Test};
pub use claim::{Claim, Kind, Place};
pub use dimension::Dimension;
pub use inventory::{Entry, Line, Symbol, in_full, listed, number_tokens, numeric_tokens};
pub use inventory_file::{Fault, Malformed};
pub use judge::{Judged, judge};
pub use printed::{Decimal, Mark, Marked, Unreadable};
pub use slip::{Consequence, Erratum, FELT, Origin, Places, Slip, slip, slips, slips_in, slips_of};
pub use stated::{Stated, another, numbers_in};
pub use tolerance::{TOLERANCES, Tolerance};
pub use verdict::{Truth, Verdict};
pub use vocabulary::Vocabulary;
pub use work::Work;

use std::collections::HashMap;
use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::thread::{available_parallelism, scope};

/// All claims, by source and in the order of the source.
pub fn claims() -> &'static [Claim] {
    static CLAIMS: OnceLock<Vec<Claim>> = OnceLock::new();
    CLAIMS.get_or_init(|| Work::ALL.iter().flat_map(|work| work.claims()).collect())
}

/// The claim with this id.
pub fn claim(id: &str) -> Option<&'static Claim> {
    Some(&claims()[number(id)?])
}

/// The number of the claim with this id among [`claims`].
fn number(id: &str) -> Option<usize> {
    static NUMBERS: OnceLock<HashMap<&str, usize>> = OnceLock::new();
    // An id that were there twice would be the first claim's.
    let numbers = || claims().iter().enumerate().rev().map(|(number, claim)| (claim.id, number)).collect();
    NUMBERS.get_or_init(numbers).get(id).copied()
}

/// All verdicts, derived once and kept, in the order of [`claims`]. Shared out among the machine's processors.
pub fn verdicts() -> &'static [Judged] {
    static VERDICTS: OnceLock<Vec<Judged>> = OnceLock::new();
    VERDICTS.get_or_init(|| verdicts_where(|_| true).into_iter().cloned().collect())
}

/// The verdicts on the claims of a source, in their order: the others are not derived for it.
pub fn verdicts_of(work: Work) -> Vec<&'static Judged> {
    verdicts_where(|claim| claim.work == work)
}

/// The verdicts on some claims, in their order: the others are not derived for it.
fn verdicts_where(wanted: impl Fn(&Claim) -> bool) -> Vec<&'static Judged> {
    let these = claims().iter().enumerate().filter(|(_, claim)| wanted(claim));
    derived(&these.map(|(at, _)| at).collect::<Vec<_>>())
}

/// The derived verdict of the claim with this id.
pub fn verdict(id: &str) -> Option<&'static Judged> {
    Some(judged(number(id)?))
}

/// The verdicts that somebody has asked for until now, in the order of [`claims`].
pub fn judged_until_now() -> impl Iterator<Item = &'static Judged> {
    kept().iter().filter_map(OnceLock::get)
}

/// The verdict on the claim of this number, derived when it is first asked for.
fn judged(number: usize) -> &'static Judged {
    kept()[number].get_or_init(|| judge(&claims()[number]))
}

/// A place for the verdict on each claim.
fn kept() -> &'static [OnceLock<Judged>] {
    static JUDGED: OnceLock<Vec<OnceLock<Judged>>> = OnceLock::new();
    JUDGED.get_or_init(|| claims().iter().map(|_| OnceLock::new()).collect())
}

/// The verdicts on the claims of these numbers, shared out among the machine's processors.
fn derived(numbers: &[usize]) -> Vec<&'static Judged> {
    let workers = available_parallelism().map_or(1, usize::from);
    scope(|scope| {
        // Each takes every n-th claim: neighbours are often equally hard.
        let share = |worker| {
            move || {
                numbers.iter().skip(worker).step_by(workers).for_each(|number| {
                    judged(*number);
                })
            }
        };
        let running: Vec<_> = (0..workers).map(|worker| scope.spawn(share(worker))).collect();
        for worker in running {
            worker.join().unwrap_or_else(|panic| resume_unwind(panic));
        }
    });
    numbers.iter().map(|number| judged(*number)).collect()
}

/// The number that the source prints in the claim with this id, in the printed unit.
///
/// `None` if there is no such claim or if it prints no number.
pub fn printed_value(id: &str) -> Option<f64> {
    Some(claim(id)?.printed.parse::<Decimal>().ok()?.to_f64())
}
