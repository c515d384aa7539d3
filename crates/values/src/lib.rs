//! Ties the numbers that a text prints to the values that a program computed.
//!
//! A record has an entry for each printed number: the words around it, and the key of a value that rounds to its digits.
//! [`record()`] writes entries for what is new, and [`check()`] compares. The printed digits are the tolerance, and the arithmetic
//! is exact. A check that cannot fail is none, so the neighbours of each right number are tried, too.
//!
//! ```
//! use geneva_values::{FindingKind, RecordRequest, check, record};
//! use std::fs;
//!
//! let folder = std::env::temp_dir().join(format!("values-example-{}", std::process::id()));
//! fs::create_dir_all(&folder)?;
//! fs::write(folder.join("report.md"), "The pendulum swings in 2.006 s.")?;
//! fs::write(folder.join("values.json"), r#"{"period": {"value": 2.00641, "unit": "s"}}"#)?;
//! record(&RecordRequest { named: vec![folder.clone()], ..RecordRequest::default() })?;
//! assert!(check(&folder, false)?.is_right());
//!
//! fs::write(folder.join("values.json"), r#"{"period": {"value": 2.0213, "unit": "s"}}"#)?;
//! let report = check(&folder, false)?;
//! assert_eq!(report.findings[0].kind, FindingKind::Stale);
//! assert_eq!(report.findings[0].write.as_deref(), Some("2.021"));
//! # fs::remove_dir_all(&folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Numbers are read as English writes them, with a point before the decimals. Numbers in words, in code, in comments and in the
//! definitions of macros are not read; the report counts stretches with digits that were left out.

mod alignment;
mod check;
mod comparison;
mod numbered_text;
mod numeral;
mod pages;
mod places;
mod printed_unit;
mod project;
mod proposal;
mod record_file;
mod recording;
mod report;
mod role;
mod sarif;
mod values;

pub use check::{FindingKind, NumberFinding, NumbersReport, check};
pub use numbered_text::{MOST_NUMBERS, NumberedText, PrintedNumber};
pub use pages::{TextLink, coverage_page, errata_page};
pub use project::LARGEST;
pub use record_file::{NO_VALUE, NumberEntry, RECORD_NAME, Record, Tie};
pub use recording::{RecordReport, RecordRequest, record};
pub use report::{check_json, check_text, record_text};
pub use role::Role;
pub use sarif::check_sarif;
pub use values::{ComputedValue, GREATEST_EXPONENT, MOST_DIGITS, Values};
