//! Telling: what a report says about what was found, what was not checked and where.

mod edit;
pub(crate) mod finding;
pub(crate) mod finding_group;
pub(crate) mod hint;
pub(crate) mod line_index;
mod number_form;
mod recomputed;
mod replacement;
#[cfg(feature = "cli")]
pub mod sarif;
pub(crate) mod statistics_tally;
pub mod summary;
pub(crate) mod tally;
#[cfg(feature = "cli")]
pub(crate) mod unchecked_chain;
