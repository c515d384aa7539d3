//! Documents of which so much differs that they are more likely misread than wrong.
//!
//! Misprints are rare: where a third of the sums of a document come out otherwise, it computes in another arithmetic, or its lines belong
//! together in another way. At the fifteenth first contact with texts of mathematics, none of the flags in such documents was real.

use crate::judge::chain_verdict::ChainVerdict;
use crate::tell::tally::CheckTally;

/// The fewest pairs that must differ.
const LEAST: usize = 6;

/// The least share of the compared pairs that must differ.
const SHARE: f64 = 0.3;

/// Findings on numbers that no single edit mends.
#[derive(Default)]
pub(crate) struct UnmendedFindings(Vec<usize>);

impl UnmendedFindings {
    pub(crate) fn record(&mut self, finding: usize) {
        self.0.push(finding);
    }

    /// The findings that count as misread, after all of a document was compared.
    pub(crate) fn of_a_misread_document(self, tally: &CheckTally) -> Vec<usize> {
        let differing = [ChainVerdict::LastDigit, ChainVerdict::Inconsistent, ChainVerdict::Dimensions];
        let differing: usize = differing.into_iter().map(|verdict| tally.pairs_with(verdict)).sum();
        let is_misread = differing >= LEAST && differing as f64 >= SHARE * tally.pairs as f64;
        if is_misread { self.0 } else { Vec::new() }
    }
}
