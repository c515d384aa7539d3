//! Recomputes the chains of numbers that a text prints.
//!
#![doc = include_str!("../README.md")]

mod atom;
mod binding;
mod chain;
mod check;
#[cfg(feature = "cli")]
pub mod cli;
mod columns;
mod cursor;
mod customs;
mod doubt;
mod effort;
mod evaluate;
mod explanation;
mod exponent;
mod finding;
mod function;
mod hint;
mod interval;
mod join;
mod notation;
mod numeral;
mod pieces;
mod place;
mod printed;
pub mod reader;
mod reading;
mod substitution;
pub mod summary;
mod surroundings;
mod token;
mod unit;
mod units_after;
mod unrounded;
mod value;
mod verdict;

pub use binding::Follow;
pub use check::{Options, Report, Tally, proofread};
pub use doubt::Doubt;
pub use effort::Effort;
pub use explanation::explanation_names;
pub use finding::{Finding, List};
pub use hint::Hint;
pub use place::{Lines, Place};
pub use reader::{Definitions, Format, Unreadable};
pub use token::Span;
pub use verdict::Verdict;
