//! Claims of a document, two routes to each of them, and the verdicts that follow.
//!
//! A [`Claim`] is one thing that a document says in one place: a stable id, the printed characters, two routes to the
//! same result that share no code, and the verdict that is on record. [`judge`] derives the verdict. A claim agrees with its
//! record if the derived verdict is the recorded one and nothing contradicts it. A [`Document`] is the list of its claims, with
//! what is needed to read them; a [`Ledger`] is several documents with all verdicts.
//!
//! ```
//! use geneva_evidence::{Cache, Claim, Document, Evidence, Ledger, Locator, Verdict};
//!
//! /// A leaflet on falling bodies: g = 9.81 m/s², and a fall of 20 m takes 2.02 s.
//! static LEAFLET: Document = Document {
//!     slug: "leaflet",
//!     title: "leaflet",
//!     citation: "A leaflet on falling bodies",
//!     inventory: None,
//!     claims,
//!     answers: &["leaflet.time"],
//!     given: || vec!["leaflet.gravity".to_owned()],
//!     conclusions: &[],
//!     symbols: &[],
//!     units: &[("time", "s"), ("acceleration", "m/s²")],
//!     test: "",
//!     cache: Cache::new(),
//! };
//!
//! fn claims() -> Vec<Claim> {
//!     let here = Locator::new(&LEAFLET, "sentence 2");
//!     let gravity = || LEAFLET.printed_number("leaflet.gravity");
//!     vec![
//!         here.value("leaflet.gravity", "9.81", "m/s²", "acceleration of a falling body")
//!             .first_route(Evidence::CLOSED_FORM, || 9.806_65)
//!             .second_route(Evidence::LIMIT_CASE, || 9.806_65),
//!         here.value("leaflet.time", "2.02", "s", "time of a fall of 20 m")
//!             .first_route(Evidence::CLOSED_FORM, move || (2.0 * 20.0 / gravity()).sqrt())
//!             // The time at which the height fallen through is 20 m, by halving an interval.
//!             .second_route(Evidence::LIMIT_CASE, move || {
//!                 let halved = |[early, late]: [f64; 2], _| {
//!                     let time = (early + late) / 2.0;
//!                     if gravity() * time * time / 2.0 < 20.0 { [time, late] } else { [early, time] }
//!                 };
//!                 (0..60).fold([0.0, 10.0], halved)[1]
//!             }),
//!     ]
//! }
//!
//! static LEDGER: Ledger = Ledger::new(&[&LEAFLET], &[Evidence::CLOSED_FORM, Evidence::LIMIT_CASE]);
//!
//! let judged = LEDGER.verdict("leaflet.time").expect("a claim of the leaflet");
//! assert_eq!(judged.verdict, Verdict::Reproduced);
//! assert!(judged.matches_record());
//! // Would a wrong digit, a wrong route or another unit be noticed?
//! geneva_evidence::testing::check(&LEDGER);
//! ```
//!
//! This crate knows no subject: what the claims are about, which kinds of evidence a ledger uses and how exactly they must
//! agree is the ledger's own.

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
pub use coverage::{entry_numbers, line_gap, without_ellipses};
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
pub use slip::{Consequence, Erratum, FELT, Origin, Slip};
pub use stated::{Stated, another, numbers_in};
pub use told::sentences;
pub use tolerance::{ARITHMETIC, CLOSURE, DIFFERENCES, ROUTES, Tolerance};
pub use traced_slip::TracedSlip;
pub use verdict::{Truth, Verdict};
pub use vocabulary::{Vocabulary, equal_to, filled};
