//! The book builder: turns a [`Book`] into pages.
//!
//! It knows Markdown, mathematics and mdBook, claims and verdicts; what a book is about, it takes from the book. A chapter's
//! formulas become markup, its placeholders give way to what the ledger, the tables and the figures have to say, and the
//! renderer of mdBook makes the page. Nothing here prints a line, and nothing derives a formula.

// A book as a value.
pub mod book;
pub mod imprint;
pub mod page_items;
pub mod pages;

// The pages of a book in a folder.
pub mod address;
pub mod building;
mod cache;
pub mod citing;
pub mod edition;
pub mod epub;
mod fingerprints;
mod libraries;
mod minify;
mod modules;
mod phone_tables;
mod policy;
pub mod print;
pub mod search;
mod spoken;
mod still;
pub mod synonyms;
mod verify;
mod xhtml;

// A chapter.
mod braces;
mod chapter_tests;
mod feed;
pub mod fences;
pub mod maths;
mod nowrap_options;
mod nowrap_units;
pub mod placeholders;
mod preprocessor;
pub mod readings;

// Data.
pub mod changelog;
pub mod codecheck;
pub mod data;
pub mod field_list;
pub mod fields;
pub mod record_files;
pub mod records;
pub mod ro_crate;
pub mod schema;

// What stands for a placeholder.
pub mod ledger_pages;
pub mod works;

// What these need.
mod base64;
pub mod chain;
pub mod formula;
pub mod html;
pub mod lookup;
pub mod numbers;
#[cfg(test)]
mod samples;
mod seven_bits;
pub mod table;

pub use book::Book;
pub use building::{build, build_afresh, test};
pub use ledger_pages::own_numbers::computed as computed_number;
pub use preprocessor::Press;
pub use readings::readings;
