//! Recomputes the chains of numbers that a text prints.
//!
#![doc = include_str!("../README.md")]

mod certainty;
mod check;
#[cfg(feature = "cli")]
pub mod cli;
mod decimal;
mod effort;
mod evaluate;
mod join;
mod judge;
mod named_counts;
mod order;
pub mod reader;
#[cfg(feature = "statistics")]
mod statistics;
mod tell;
mod token;
mod unit;

pub use check::{CheckOptions, CheckReport, proofread};
pub use effort::CheckEffort;
pub use evaluate::binding::NamePolicy;
pub use judge::caveat::{Caveat, DifferenceEvidence};
pub use judge::chain_shape::chain_shape;
pub use judge::chain_verdict::ChainVerdict;
pub use judge::doubt::Doubt;
pub use judge::explanation::explanation_names;
pub use judge::section::ReportSection;
pub use judge::unchecked::UncheckedKind;
pub use named_counts::NamedCounts;
pub use reader::{Definitions, TextFormat, UnreadKind, UnreadParts, UnreadableText};
#[cfg(feature = "statistics")]
pub use statistics::{StatisticsReport, find_statistics};
pub use tell::finding::ChainFinding;
pub use tell::finding_group::{FindingGroup, group_findings};
pub use tell::hint::Hint;
pub use tell::line_index::{LineColumn, LineIndex};
#[cfg(feature = "cli")]
pub use tell::sarif;
pub use tell::statistics_tally::StatisticsTally;
pub use tell::summary;
pub use tell::tally::CheckTally;
#[cfg(feature = "cli")]
pub use tell::unchecked_chain::UncheckedChain;
pub use token::Span;
pub use unit::product::unit_named;
pub use unit::{MeasurementUnit, UnitDimension};
