//! How many statistics and totals of a text were compared.

/// How many statistics of a text were compared with what they follow from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StatisticsTally {
    /// p-values beside their test statistics.
    pub tests: usize,
    /// Confidence intervals beside what they are made of.
    pub intervals: usize,
    /// Shares in per cent beside their parts.
    pub shares: usize,
    /// Totals in tables beside their parts.
    pub totals: usize,
}

impl StatisticsTally {
    /// Adds the counts of another text.
    ///
    /// ```
    /// use proofread::StatisticsTally;
    ///
    /// let mut sum = StatisticsTally { tests: 2, ..StatisticsTally::default() };
    /// sum.add(&StatisticsTally { tests: 1, totals: 3, ..StatisticsTally::default() });
    /// assert_eq!((sum.tests, sum.totals, sum.count()), (3, 3, 6));
    /// ```
    pub fn add(&mut self, other: &Self) {
        self.tests += other.tests;
        self.intervals += other.intervals;
        self.shares += other.shares;
        self.totals += other.totals;
    }

    /// How many were compared, of all kinds.
    pub fn count(&self) -> usize {
        self.tests + self.intervals + self.shares + self.totals
    }
}
