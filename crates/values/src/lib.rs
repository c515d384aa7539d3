//! Ties the numbers that a text prints to the values that a program computed.

mod check;
mod comparison;
mod numbered_text;
mod numeral;
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
pub use project::LARGEST;
pub use record_file::{NO_VALUE, NumberEntry, RECORD_NAME, Record, Tie};
pub use recording::{RecordReport, RecordRequest, record};
pub use report::{check_json, check_text, record_text};
pub use role::Role;
pub use sarif::check_sarif;
pub use values::{ComputedValue, GREATEST_EXPONENT, MOST_DIGITS, Values};
