//! How much of a document was checked.

use crate::judge::chain_verdict::ChainVerdict;
use crate::tell::statistics_tally::StatisticsTally;

/// How much of a document was checked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CheckTally {
    /// Bytes of the document.
    pub bytes: usize,
    /// Formulas, and lines that may be one.
    pub formulas: usize,
    /// Formulas and lines that are not read to their end, since they are too long, nest too deeply, or have macros that never end.
    pub unread: usize,
    /// Chains of equal sides with a number in them.
    pub chains: usize,
    /// Chains that arithmetic can check: those with two sides that are numbers without letters, and those that were checked though
    /// they have letters. Commands, environments and functions count as numbers, whether the program knows them or not.
    pub checkable: usize,
    /// Chains of which at least one pair of sides was compared.
    pub checked: usize,
    /// Chains that were checked, but not all of their numbers.
    pub partly: usize,
    /// Pairs of neighbouring sides that were compared.
    pub pairs: usize,
    /// Pairs with each verdict, in the order of [`ChainVerdict::ALL`].
    pub verdicts: [usize; 10],
    /// Differences that are set aside as doubts, of those that are kept.
    pub doubts: usize,
    /// Differences that are less certain, of those that are kept.
    pub less_certain: usize,
    /// Statistics and totals that were compared with what they follow from.
    pub statistics: StatisticsTally,
}

impl CheckTally {
    /// Pairs with a verdict.
    ///
    /// ```
    /// use proofread::{CheckOptions, ChainVerdict, TextFormat, proofread};
    ///
    /// let tally = proofread("$1 + 1 = 2$, $1/3 = 0.33$, $2/3 = 0.66$", TextFormat::Markdown, CheckOptions::default())?.tally;
    /// assert_eq!(tally.pairs_with(ChainVerdict::Consistent), 2);
    /// assert_eq!(tally.pairs_with(ChainVerdict::Truncated), 1);
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn pairs_with(&self, verdict: ChainVerdict) -> usize {
        self.verdicts[verdict as usize]
    }

    /// Pairs that differ in their numbers, also those that are set aside.
    pub(crate) fn differing_pairs(&self) -> usize {
        let differing = [ChainVerdict::LastDigit, ChainVerdict::Inconsistent, ChainVerdict::Dimensions];
        differing.into_iter().map(|verdict| self.pairs_with(verdict)).sum()
    }

    /// Adds the counts of another document.
    ///
    /// ```
    /// use proofread::CheckTally;
    ///
    /// let mut sum = CheckTally { chains: 2, ..CheckTally::default() };
    /// sum.add(&CheckTally { chains: 3, pairs: 4, ..CheckTally::default() });
    /// assert_eq!((sum.chains, sum.pairs), (5, 4));
    /// ```
    pub fn add(&mut self, other: &Self) {
        self.bytes += other.bytes;
        self.formulas += other.formulas;
        self.unread += other.unread;
        self.chains += other.chains;
        self.checkable += other.checkable;
        self.checked += other.checked;
        self.partly += other.partly;
        self.pairs += other.pairs;
        self.doubts += other.doubts;
        self.less_certain += other.less_certain;
        self.statistics.add(&other.statistics);
        for (mine, its) in self.verdicts.iter_mut().zip(other.verdicts) {
            *mine += its;
        }
    }
}
