//! A leaflet on falling and swinging bodies, checked: an example of another document with a book of its own.
//!
//! The leaflet is made up. It has two mistakes, of which one reaches two claims, and one number that cannot be decided.

#[cfg(not(target_family = "wasm"))]
mod book;
mod leaflet;
mod letters;
mod steps;

#[cfg(not(target_family = "wasm"))]
pub use book::BOOK;
pub use leaflet::{BODIES, IN_STEPS, LEAFLET};

use geneva_evidence::{Evidence, Ledger};

/// The leaflet with its verdicts.
pub static LEDGER: Ledger = Ledger::new(
    &[&LEAFLET],
    &[Evidence::CLOSED_FORM, Evidence::LIMIT_CASE, IN_STEPS, BODIES, Evidence::OTHER_PLACE_IN_SOURCE],
);
