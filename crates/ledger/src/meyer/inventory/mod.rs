//! The project line by line.

mod appendices;
mod front;
mod geometry;

use crate::{Entry, Line};
use std::sync::LazyLock;

/// All lines of the source's text that say something, in order; headings alone are left out.
pub fn inventory() -> &'static [Line] {
    static LINES: LazyLock<Vec<Line>> = LazyLock::new(|| {
        [front::LINES, geometry::LINES, appendices::APPENDIX_A, appendices::APPENDIX_C, appendices::END].concat()
    });
    &LINES
}

/// An exception with its id, numbers and reason.
const fn exception(id: &'static str, numbers: &'static str, reason: &'static str) -> Entry {
    Entry::Exception { id, numbers, reason }
}

const fn line(number: u32, fingerprint: u64, entries: &'static [Entry]) -> Line {
    Line { number, fingerprint, entries }
}

/// The fingerprint of a line without numbers.
const NONE: u64 = 0xcbf2_9ce4_8422_2325;
