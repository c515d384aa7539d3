//! Recomputes the chains of numbers that a text prints.
//!
#![doc = include_str!("../README.md")]

mod atom;
mod binding;
mod bracket_symbols;
mod chain;
mod check;
#[cfg(feature = "cli")]
pub mod cli;
mod cursor;
mod doubt;
mod effort;
mod equals_conventions;
mod equation_columns;
mod evaluate;
mod evaluation_bar;
mod explanation;
mod exponent;
mod finding;
mod function;
mod hint;
mod interval;
mod joined_operations;
mod line_index;
mod matrix_sides;
mod named_counts;
mod notation;
mod numeral;
mod operation;
mod other_arithmetic;
mod printed;
pub mod reader;
mod reading;
#[cfg(feature = "cli")]
pub mod sarif;
mod split_units;
#[cfg(feature = "statistics")]
mod statistics;
mod statistics_tally;
mod step_rounding;
mod substitution;
pub mod summary;
mod surroundings;
mod token;
mod token_joining;
mod unchecked;
#[cfg(feature = "cli")]
mod unchecked_chain;
mod unit;
mod unit_product;
mod units_after;
mod unrounded;
mod value;
mod verdict;

pub use binding::NamePolicy;
pub use check::{CheckOptions, CheckReport, CheckTally, proofread};
pub use doubt::Doubt;
pub use effort::CheckEffort;
pub use explanation::explanation_names;
pub use finding::{ChainFinding, ReportSection};
pub use hint::Hint;
pub use line_index::{LineColumn, LineIndex};
pub use named_counts::NamedCounts;
pub use reader::{Definitions, TextFormat, UnreadKind, UnreadParts, UnreadableText};
#[cfg(feature = "statistics")]
pub use statistics::{StatisticsReport, find_statistics};
pub use statistics_tally::StatisticsTally;
pub use token::Span;
pub use unchecked::UncheckedKind;
#[cfg(feature = "cli")]
pub use unchecked_chain::UncheckedChain;
pub use unit::{MeasurementUnit, UnitDimension};
pub use unit_product::unit_named;
pub use verdict::ChainVerdict;
