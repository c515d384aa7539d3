//! What a claim prints, looked up by the claim's id, so that the checks of one claim can refer to others.

use crate::{Claim, Decimal, claim, numeric_tokens};
use std::cell::RefCell;
use std::collections::BTreeSet;

thread_local! {
    /// The claims that this thread has looked up.
    static LOOKED_UP: RefCell<BTreeSet<&'static str>> = const { RefCell::new(BTreeSet::new()) };
}

/// Runs a route of a claim. Returns its result with the ids of the claims that it looks up by id on the way, so that a test can
/// tell what the route rests on. What an earlier run has kept for later, or looks up on another thread, is not among them.
pub fn looked_up_by<T>(route: impl FnOnce() -> T) -> (T, BTreeSet<&'static str>) {
    let before = LOOKED_UP.take();
    let found = route();
    (found, LOOKED_UP.replace(before))
}

/// The claim with this id. The ids are written in the ledger's own text, so an id that no claim has is a mistake there,
/// which must not pass for a number or a verdict. The panic ends only the claim that asks: see [`judge`](crate::judge).
pub(crate) fn named(id: &str) -> &'static Claim {
    let named = claim(id).unwrap_or_else(|| panic!("no claim has the id {id}"));
    LOOKED_UP.with_borrow_mut(|ids| ids.insert(named.id));
    named
}

/// The characters printed in the claim with this id.
pub(crate) fn characters(id: &str) -> &'static str {
    named(id).printed
}

/// The characters of a display that is cut into lines, each a claim of its own: the right ones, but these for the line
/// with the id `own`.
pub(crate) fn in_display(lines: &[&str], own: &str, tex: &str) -> String {
    let line = |id: &&str| if *id == own { tex } else { named(id).right_characters() };
    lines.iter().map(line).collect::<Vec<_>>().join(" ")
}

/// The right-hand side of the first equals sign in the claim with this id; nothing, which has no value, if there is
/// none.
pub(crate) fn right_side(id: &str) -> &'static str {
    characters(id).split_once('=').map_or("", |(_, right)| right)
}

/// The number printed in the claim with this id, with its digits; none if they make no number.
pub(crate) fn decimal(id: &str) -> Option<Decimal> {
    characters(id).parse().ok()
}

/// The number printed in the claim with this id; not a number if the characters make none.
pub(crate) fn printed(id: &str) -> f64 {
    decimal(id).map_or(f64::NAN, |decimal| decimal.to_f64())
}

/// Whether the number printed in the claim with this id is a rounding of this one.
pub(crate) fn rounds(id: &str, number: f64) -> bool {
    decimal(id).is_some_and(|decimal| decimal.is_rounding_of(number))
}

/// All integers in the characters printed in the claim with this id, in their order.
pub(crate) fn numbers(id: &str) -> Vec<u32> {
    numeric_tokens(characters(id)).iter().filter_map(|token| token.parse().ok()).collect()
}

/// The interval that the digits printed in the claim with this id leave open: half a unit of the last place either way;
/// not numbers if the characters make none.
pub(crate) fn interval(id: &str) -> [f64; 2] {
    decimal(id).map_or([f64::NAN; 2], |decimal| decimal.interval())
}
