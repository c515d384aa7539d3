//! What proofreading found in texts by others: the misprints, and how often the program was right, as the crate `proofread` keeps them.

use anyhow::Context;
use serde::de::DeserializeOwned;

const MISPRINTS: &str = include_str!("../../proofread/judged/misprints.csv");
const BOOKS: &str = include_str!("../../proofread/judged/book-runs.csv");
const RATES: &str = include_str!("../../proofread/judged/rates.csv");

/// Whether something is so, as the records write it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Answer {
    /// It is.
    Yes,
    /// It isn't.
    No,
}

/// What is misprinted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum MisprintKind {
    /// A number of a chain.
    Number,
    /// A statistic, a share or a total.
    Statistics,
    /// A unit or an exponent of one, beside numbers that are right.
    Unit,
}

/// A misprint in a textbook.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct Misprint {
    /// The book.
    pub book: String,
    /// The file in its sources.
    pub file: String,
    /// The line there.
    pub line: u32,
    /// The element or section that it is in.
    pub element: String,
    /// The two sides that disagree.
    pub printed: String,
    /// What the left side gives, to as many digits as are printed; empty if there is no such number.
    pub recomputed: String,
    /// What should be printed, by the reading of the judge.
    pub should: String,
    /// What is misprinted.
    pub kind: MisprintKind,
    /// Whether it comes from the same fault as one above.
    pub repeats: Answer,
}

/// A run over a textbook.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct BookRun {
    /// The book.
    pub book: String,
    /// The revision of its sources.
    pub revision: String,
    /// Chains that were checked.
    pub checked: u32,
}

/// How often something came out well, of how many.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct MeasuredRate {
    /// What was measured: `flags`, `faults`, `five` (flags of the last five contacts), `apart`, `statistics`, `hints`, `reported`, `planted` or `displayed`.
    pub measure: String,
    /// In texts of which kind; `all` for all of them.
    pub subject: String,
    /// How often.
    pub good: u32,
    /// Of how many.
    pub tried: u32,
}

fn read<T: DeserializeOwned>(record: &str) -> anyhow::Result<Vec<T>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(record.as_bytes());
    reader.deserialize().map(|row| row.context("a record of what proofreading found")).collect()
}

/// The misprints in the textbooks, book by book.
pub(crate) fn misprints() -> anyhow::Result<Vec<Misprint>> {
    read(MISPRINTS)
}

/// The runs over the textbooks.
pub(crate) fn books() -> anyhow::Result<Vec<BookRun>> {
    read(BOOKS)
}

/// Every rate that was measured at first contact.
pub(crate) fn rates() -> anyhow::Result<Vec<MeasuredRate>> {
    read(RATES)
}

/// The rate of a measure in texts of a kind.
pub(crate) fn rate(measure: &str, subject: &str) -> anyhow::Result<MeasuredRate> {
    let found = rates()?.into_iter().find(|rate| rate.measure == measure && rate.subject == subject);
    found.with_context(|| format!("no rate of `{measure}` in `{subject}` was measured"))
}

/// The 95 % interval of Wilson for a share of `all`, as fractions.
pub(crate) fn wilson(part: usize, all: usize) -> (f64, f64) {
    const Z: f64 = 1.959_963_984_540_054;
    let n = all as f64;
    if all == 0 {
        return (0.0, 1.0);
    }
    let share = part as f64 / n;
    let scale = 1.0 + Z * Z / n;
    let centre = (share + Z * Z / (2.0 * n)) / scale;
    let half = Z * (share * (1.0 - share) / n + Z * Z / (4.0 * n * n)).sqrt() / scale;
    (centre - half, centre + half)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_is_wilsons() {
        let (low, high) = wilson(15, 21);
        assert!((low - 0.500).abs() < 5e-4 && (high - 0.862).abs() < 5e-4, "{low} {high}");
        assert_eq!(wilson(0, 0), (0.0, 1.0));
    }

    #[test]
    fn each_misprint_is_in_a_book_that_was_run_and_says_what_is_meant() {
        let books = books().expect("read");
        for misprint in misprints().expect("read") {
            assert!(books.iter().any(|book| book.book == misprint.book), "{}", misprint.book);
            assert!(!misprint.should.is_empty() && !misprint.printed.is_empty(), "{} {}", misprint.file, misprint.line);
        }
    }

    #[test]
    fn no_rate_has_more_good_than_tried() {
        let rates = rates().expect("read");
        assert!(rates.len() > 10);
        for rate in rates {
            assert!(rate.good <= rate.tried && rate.tried > 0, "{} {}", rate.measure, rate.subject);
        }
    }
}
