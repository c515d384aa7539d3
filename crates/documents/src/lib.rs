//! What the four sources and some pages elsewhere print, and two routes to each claim: the only crate that knows both.
//!
//! Each document has a folder: its claims in the order of the source, and the [`Document`] with what is needed to read them.
//! [`LEDGER`] is all of them with their verdicts. Everything shown anywhere (tests, tables of the book, command line, JSON,
//! CSV) is drawn from it.
//!
//! What is computed comes from the formula crates, from the study of the runs in `geneva-case1973`, or from a second route
//! beside the claim that it serves. A printed number is written here and nowhere else. A folder uses nothing of another, but
//! what is shared by all; only `wild`, where a page continues the textbook problem, uses `pin`.

mod duals;
pub mod evidence;
mod triangle;

pub mod jazar;
pub mod meyer;
pub mod pin;
pub mod quick_return;
pub mod wild;

pub use jazar::JAZAR;
pub use meyer::MEYER;
pub use pin::PIN;
pub use quick_return::QUICK_RETURN;
pub use wild::WILD;

use geneva_evidence::{Document, Ledger};

/// The documents, in the order of the book, and all verdicts on them.
pub static LEDGER: Ledger = Ledger::new(DOCUMENTS, evidence::EVIDENCE);

/// The four documents and the statements elsewhere.
const DOCUMENTS: &[&Document] = &[&PIN, &QUICK_RETURN, &JAZAR, &MEYER, &WILD];
