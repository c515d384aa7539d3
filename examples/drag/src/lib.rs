//! A section of a physics textbook on drag and terminal speed, checked: an example of a document that we did not write.

#[cfg(not(target_family = "wasm"))]
mod book;
mod claims;
#[cfg(not(target_family = "wasm"))]
mod editions;
mod kinds;
mod letters;
mod reader;
mod section;
mod steps;

#[cfg(not(target_family = "wasm"))]
pub use book::BOOK;
pub use kinds::{BALANCE, ENERGY, IN_STEPS, UNITS};
pub use section::SECTION;

use geneva_evidence::{Evidence, Ledger};

/// The section with its verdicts.
pub static LEDGER: Ledger = Ledger::new(
    &[&SECTION],
    &[
        Evidence::CLOSED_FORM,
        Evidence::LIMIT_CASE,
        Evidence::VECTORS,
        Evidence::DIMENSION,
        IN_STEPS,
        BALANCE,
        ENERGY,
        UNITS,
        Evidence::OTHER_PLACE_IN_SOURCE,
    ],
);
