//! On which page of the book a claim's row stands. One page for all would be too heavy for a phone.

use geneva_ledger::{Work, claims};
use std::collections::HashMap;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

/// A stretch of a source, and the page that lists its claims.
pub struct Stretch {
    /// The page's file, without its ending.
    pub page: &'static str,
    /// The source.
    pub work: Work,
    /// The lines of the source's text.
    pub lines: RangeInclusive<u32>,
    /// What the stretch is.
    pub title: &'static str,
}

const ALL_LINES: RangeInclusive<u32> = 0..=u32::MAX;

/// All stretches, in the order of the sources.
pub const STRETCHES: &[Stretch] = &[
    Stretch { page: "ledger", work: Work::Pin, lines: ALL_LINES, title: "the pin in the slot" },
    Stretch { page: "ledger", work: Work::QuickReturn, lines: ALL_LINES, title: "the quick-return mechanism" },
    Stretch { page: "ledger", work: Work::Jazar2003, lines: ALL_LINES, title: "the wheel of N stations" },
    Stretch { page: "ledger-meyer", work: Work::Meyer1973, lines: 0..=262, title: "front matter and geometry" },
    Stretch { page: "ledger-meyer-friction", work: Work::Meyer1973, lines: 263..=336, title: "friction and energy" },
    Stretch { page: "ledger-meyer-motion", work: Work::Meyer1973, lines: 337..=425, title: "Lagrange’s equation" },
    Stretch { page: "ledger-meyer-study", work: Work::Meyer1973, lines: 426..=592, title: "chapter II, appendix A" },
    Stretch { page: "ledger-meyer-program", work: Work::Meyer1973, lines: 593..=775, title: "appendices B, C and D" },
    Stretch { page: "ledger-meyer-runs", work: Work::Meyer1973, lines: 776..=u32::MAX, title: "appendix E" },
];

/// The stretches of a page.
pub fn of_page(page: &str) -> impl Iterator<Item = &'static Stretch> {
    STRETCHES.iter().filter(move |stretch| stretch.page == page)
}

/// The page that lists a claim. The first one if none does, which a test excludes.
pub fn page_of(id: &str) -> &'static str {
    static PAGES: OnceLock<HashMap<&str, &str>> = OnceLock::new();
    let pages = PAGES.get_or_init(|| STRETCHES.iter().flat_map(|part| part.ids().map(|id| (id, part.page))).collect());
    pages.get(id).copied().unwrap_or(STRETCHES[0].page)
}

impl Stretch {
    /// The ids of the claims made in these lines, in the order of the ledger.
    pub fn ids(&self) -> impl Iterator<Item = &'static str> {
        let made: Vec<_> = self
            .work
            .inventory()
            .unwrap_or_default()
            .iter()
            .filter(|line| self.lines.contains(&line.number))
            .flat_map(|line| &line.entries)
            .filter_map(|entry| entry.claimed())
            .collect();
        claims().iter().map(|claim| claim.id).filter(move |id| made.contains(id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_claim_stands_on_one_page() {
        for claim in claims() {
            let pages = STRETCHES.iter().filter(|stretch| stretch.ids().any(|id| id == claim.id)).count();
            assert_eq!(pages, 1, "{}", claim.id);
        }
    }
}
