//! By how much one hypothesis makes the tables likelier than others, and whether that depends on how the errors are taken.

use crate::likelihood::{LEAST_SPREAD, Law};
use crate::scores::Score;
use crate::{EXPLAINED, Hypothesis, PeakReading, Row, series};
use geneva_kinematics::Mechanism;

/// How the errors of the printed numbers are taken, and which rows count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weighing {
    /// Whether the errors of a column have a spread of their own in each table, or one in all three.
    pub by_table: bool,
    /// The least spread, in units of the last printed place.
    pub least_spread: f64,
    /// Of the rows with one mechanism and one friction the one that counts, from the weakest spring on; none if all do.
    ///
    /// If there are not so many rows, the last one counts.
    pub only: Option<usize>,
}

/// The hypotheses against which [`Hypothesis::WITHOUT_LAG`] is weighed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Others {
    /// With any other reset angle.
    AnotherReset,
    /// With any other combination of reset angle and inertias.
    AnotherResetOrInertias,
    /// With the true peaks, and nothing else changed.
    TruePeaks,
}

impl Others {
    /// Whether a hypothesis is one of them.
    pub fn include(self, other: &Hypothesis) -> bool {
        let own = Hypothesis::WITHOUT_LAG;
        match self {
            Self::AnotherReset => other.reset != own.reset,
            Self::AnotherResetOrInertias => (other.reset, other.six_pin) != (own.reset, own.six_pin),
            Self::TruePeaks => *other == Hypothesis { reading: PeakReading::True, ..own },
        }
    }
}

/// The margins of all rows against the others, dimensionless: by each weighing with each law. None if [`Hypothesis::WITHOUT_LAG`] is not
/// among the compared ones.
pub fn margins(compared: &[Score], others: Others) -> Option<Vec<f64>> {
    all_margins([Weighing::BY_COLUMN, Weighing::BY_TABLE, Weighing::COARSE], compared, others)
}

/// The margins, dimensionless, against the others if only one row for each mechanism and friction counts, by each choice of rows with
/// each law. None if [`Hypothesis::WITHOUT_LAG`] is not among the compared ones.
pub fn margins_by_one_row_of_each(compared: &[Score], others: Others) -> Option<Vec<f64>> {
    all_margins(Weighing::one_row_of_each(compared.first()?.rows), compared, others)
}

fn all_margins(ways: impl IntoIterator<Item = Weighing>, compared: &[Score], others: Others) -> Option<Vec<f64>> {
    let of = |weighing: Weighing| Law::ALL.map(|law| weighing.margin(compared, law, others));
    ways.into_iter().flat_map(of).collect()
}

impl Weighing {
    /// One spread for each column.
    pub const BY_COLUMN: Self = Self { by_table: false, least_spread: LEAST_SPREAD, only: None };

    /// A spread for each column of each table.
    pub const BY_TABLE: Self = Self { by_table: true, ..Self::BY_COLUMN };

    /// A spread for each column of each table, none below half a unit, which is what the rounding of a number hides.
    pub const COARSE: Self = Self { least_spread: 0.5, ..Self::BY_TABLE };

    /// The coarse weighing with one row for each mechanism and friction: the weakest spring's, the next one's and so on.
    ///
    /// Rows with one mechanism and one friction follow from each other by the law of similarity, so their errors are not
    /// independent of each other.
    pub fn one_row_of_each(rows: &[Row]) -> impl Iterator<Item = Self> {
        let most = series(rows).map(<[Row]>::len).max().unwrap_or(0);
        (0..most).map(|only| Self { only: Some(only), ..Self::COARSE })
    }

    /// The logarithm of the likelihood of the tables under a hypothesis, each spread as it suits the hypothesis best;
    /// dimensionless.
    ///
    /// Negative infinity if a run came to no end.
    pub fn log_likelihood(&self, score: &Score, law: Law) -> f64 {
        let of = |units: Option<Vec<f64>>| {
            let units = units?;
            let best = law.maximum_likelihood(&units);
            // The likelihood falls to either side of the best spread.
            Some(if best.spread < self.least_spread { law.log_likelihood(&units, self.least_spread) } else { best.log })
        };
        self.errors(score).map(of).sum::<Option<f64>>().unwrap_or(f64::NEG_INFINITY)
    }

    /// By how much the logarithm for [`Hypothesis::WITHOUT_LAG`] is above the greatest for any of the others among the
    /// compared ones; dimensionless. None if it is not among them.
    pub fn margin(&self, compared: &[Score], law: Law, others: Others) -> Option<f64> {
        let one = compared.iter().find(|score| score.hypothesis == Hypothesis::WITHOUT_LAG)?;
        let own = self.log_likelihood(one, law);
        let others = compared.iter().filter(|other| others.include(&other.hypothesis));
        Some(others.map(|other| own - self.log_likelihood(other, law)).fold(f64::INFINITY, f64::min))
    }

    /// The errors that have one spread, in units of the last printed place; none if a run came to no end.
    fn errors(&self, score: &Score) -> impl Iterator<Item = Option<Vec<f64>>> {
        let (only, mut results) = (self.only, score.results.iter());
        let mut counting = Vec::new();
        for own in series(score.rows) {
            let chosen = only.map(|only| only.min(own.len() - 1));
            let of_rows = own.iter().zip(results.by_ref()).enumerate();
            counting.extend(of_rows.filter(|(at, _)| chosen.is_none_or(|only| only == *at)).map(|(_, of)| of));
        }
        let tables: Vec<&[Mechanism]> =
            if self.by_table { Mechanism::ALL.chunks(1).collect() } else { vec![&Mechanism::ALL] };
        let together = tables.into_iter().flat_map(|table| [0, 1, 2].map(|at| (table, at)));
        let of = move |(table, at): (&[Mechanism], usize)| {
            let off = |(row, results): &(&Row, &Option<[f64; 3]>)| {
                let column = EXPLAINED[at];
                Some((row.number(column) - results.as_ref()?[at]).abs() / column.unit())
            };
            counting.iter().filter(|(row, _)| table.contains(&row.mechanism)).map(off).collect()
        };
        together.map(of)
    }
}
