//! How much work a text makes, counted in steps: a measure that depends on the text alone, so that a test can hold it to a bound.
//!
//! A step is a token that is made, copied, shown or evaluated, or a character that a macro adds or that is looked at around a
//! formula. The steps of a thread are counted together: what takes them need not be passed a counter.

use std::cell::Cell;

/// What proofreading a document took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CheckEffort {
    /// Steps: tokens made, copied, shown or evaluated, and characters that macros add or that are looked at around formulas.
    pub steps: u64,
    /// Tokens that were evaluated in the search for hints.
    pub hints: usize,
}

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// Counts steps.
pub(crate) fn count_steps(steps: usize) {
    STEPS.with(|all| all.set(all.get().saturating_add(steps as u64)));
}

/// The steps of this thread so far.
pub(crate) fn steps() -> u64 {
    STEPS.get()
}
