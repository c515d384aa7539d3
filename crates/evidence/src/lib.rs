//! Claims of a document, two routes to each of them, and the verdicts that follow.
//!
#![doc = include_str!("../README.md")]

mod account;
pub mod agreement;
mod building;
mod check;
mod coverage;
mod dimension;
mod document;
mod inventory;
mod inventory_file;
mod judge;
mod kind_of_evidence;
mod ledger;
mod nearest;
pub mod number_format;
mod number_words;
mod own_number;
mod plain_verdict;
mod printed;
mod progress;
mod slip;
mod slugs;
mod stated;
pub mod testing;
pub mod tex;
mod told;
mod tolerance;
mod traced_slip;
mod units;
mod verdict;
mod vocabulary;

pub use account::{Account, MOST_CHARACTERS, Taken};
pub use building::{Locator, Unchecked, Unwitnessed, intern};
pub use check::{Check, ChoiceFn, DecisionFn, Finding, NumberFn, ReadingFn, Route, TestFn};
pub use coverage::{entry_numbers, line_gap, numbers_left, without_ellipses};
pub use dimension::Dimension;
pub use document::{Cache, Claim, Document, Kind, QuantityUnit, looked_up_by};
pub use inventory::{Entry, Line, Symbol, joined_or_none, number_tokens, numeric_tokens};
pub use inventory_file::{Fault, InventoryFile, Malformed};
pub use judge::{Judged, judge, judge_characters};
pub use kind_of_evidence::{Agreement, Evidence};
pub use ledger::Ledger;
pub use nearest::nearest_name;
pub use number_words::{next_number_word, number_in_word};
pub use own_number::{Backing, Form, GIVEN, IntoNumbers, Numbers, OwnNumber, RECORD, ids_with_backing};
pub use plain_verdict::PlainVerdict;
pub use printed::{Decimal, Mark, Marked, Unreadable};
pub use progress::{LedgerProgress, UnfinishedLine};
pub use slip::{Consequence, Erratum, FELT, Origin, Slip};
pub use stated::{Stated, another, numbers_in};
pub use told::sentences;
pub use tolerance::{ARITHMETIC, CLOSURE, DIFFERENCES, ROUTES, Tolerance};
pub use traced_slip::TracedSlip;
pub use verdict::{Truth, Verdict};
pub use vocabulary::{Vocabulary, equal_to, filled};
