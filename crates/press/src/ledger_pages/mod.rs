//! What the ledger shows in the book: words in a line, tables, whole pages.

pub mod compare;
pub mod coverage;
pub mod errata;
pub mod findings;
pub mod inline;
pub mod ledger;
pub mod lists;
pub mod open;
pub mod own_numbers;
pub mod records;
