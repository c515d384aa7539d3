//! The project line by line.

mod appendices;
mod appendix_b;
mod appendix_d;
mod derivation;
mod front;
mod geometry;
mod program;
mod study;

use crate::{Entry, Line};
use std::sync::LazyLock;

/// All lines of the source's text that say something, in order; headings alone are left out.
pub fn inventory() -> &'static [Line] {
    static LINES: LazyLock<Vec<Line>> = LazyLock::new(|| {
        let mut lines = [
            front::LINES,
            geometry::LINES,
            derivation::LINES,
            derivation::INERTIA,
            study::ABSTRACT,
            study::PARAMETERS,
            study::FIGURES,
            study::CONCLUSIONS,
            study::HEADINGS,
            appendices::APPENDIX_A,
            appendix_b::TEXT,
            program::LINES,
            appendix_b::AFTER,
            appendices::APPENDIX_C,
            appendix_d::LINES,
            appendices::END,
        ]
        .concat();
        lines.extend(super::runs::lines());
        lines.sort_by_key(|line| line.number);
        lines
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
