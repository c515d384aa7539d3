//! The press: turns chapters into pages.
//!
//! It knows Markdown, mathematics and mdBook. A chapter passes through the rooms in this order: its formulas
//! become markup, what the ledger and the figures have to say is drawn in, and the renderer of mdBook makes the
//! page. Nothing here computes a number or prints a line.

// A chapter.
pub mod drawing_in;
pub mod drawings;
pub mod fences;
mod formula;
mod html;
mod ledger_pages;
pub mod maths;
mod preprocessor;
mod records;
mod tables;

pub use preprocessor::Geneva;

// The book.
pub mod building;
mod lean;
mod libraries;
