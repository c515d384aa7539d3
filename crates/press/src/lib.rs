//! The book builder: turns chapters into pages.
//!
//! It knows Markdown, mathematics and mdBook, and what stands on which page. A chapter's formulas become markup, its
//! placeholders give way to what the ledger and the figures have to say, and the renderer of mdBook makes the page.
//! Nothing here prints a line, and nothing derives a formula: a table or a figure calls the solvers for what it shows.

// The book.
pub mod address;
pub mod building;
mod cards;
pub mod citing;
pub mod edition;
mod fingerprints;
mod libraries;
mod minify;
pub mod pages;
mod policy;
pub mod print;
pub mod readme;
mod search;

// A chapter.
mod braces;
mod chapter_tests;
pub mod fences;
mod formula;
pub mod maths;
mod options;
pub mod placeholders;
mod preprocessor;

// Data.
mod data;
pub mod fields;
pub mod records;

// What stands for a placeholder.
pub mod asked;
pub mod bibliography;
pub mod computed;
pub mod figures;
mod ledger_pages;
pub mod live;
pub mod proofread;
mod tables;

// What these need.
mod base64;
mod found;
mod html;
mod lookup;
mod measurements;
mod numbers;
mod rows;
mod units;

pub use preprocessor::Geneva;
