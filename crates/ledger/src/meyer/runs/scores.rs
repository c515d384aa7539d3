//! How well computed numbers explain printed ones.

use super::*;
use geneva_dynamics::likelihood::{Law, Likelihood};

/// How a set of runs does on one column of the tables. The mean and the worst are over the runs that came to an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Cells that the computed number rounds to.
    pub exact: usize,
    /// Cells within one unit of the last place.
    pub within_one: usize,
    /// Mean of printed over computed, less one.
    pub mean: f64,
    /// Printed over computed, less one, where it is farthest from zero.
    pub worst: f64,
    /// How likely the printed cells are, by each law of error.
    pub likelihoods: [Likelihood; 2],
}

/// In how many rows a column of these runs comes within one unit of the last printed place.
pub fn within_one(column: Column, runs: &[Run]) -> usize {
    rows().iter().zip(runs).filter(|(row, run)| column.is_within_one(row.number(column), run.number(column))).count()
}

impl Fit {
    /// The fit to a column, for the runs of all rows; a run that came to nothing explains nothing.
    ///
    /// In the statistical model, a printed number is the computed number plus an error of unknown spread, rounded to
    /// the unit. All hypotheses have this one parameter, so their likelihoods may be compared as they are.
    pub fn of(column: Column, runs: &[Option<Run>]) -> Self {
        let cells: Vec<_> = rows()
            .iter()
            .zip(runs)
            .filter_map(|(row, run)| Some((row.number(column), run.as_ref()?.number(column))))
            .collect();
        let units: Vec<_> = cells.iter().map(|(printed, found)| (found - printed).abs() / column.unit()).collect();
        let relative = |(printed, computed): &(f64, f64)| printed / computed - 1.0;
        let further = |worst: f64, next: f64| if next.abs() > worst.abs() { next } else { worst };
        let whole = cells.len() == rows().len();
        let impossible = Likelihood { spread: f64::INFINITY, log: f64::NEG_INFINITY };
        Self {
            // In units, a half is a half but for the rounding of the quotient.
            exact: units.iter().filter(|off| **off <= 0.5 + 1e-9).count(),
            within_one: units.iter().filter(|off| **off <= 1.0 + 1e-9).count(),
            mean: cells.iter().map(relative).sum::<f64>() / cells.len() as f64,
            worst: cells.iter().map(relative).fold(0.0, further),
            likelihoods: Law::ALL.map(|law| if whole { law.of(&units) } else { impossible }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_that_comes_to_nothing_makes_the_tables_impossible() {
        let mut runs: Vec<_> = rows().iter().map(|row| Hypothesis::WITHOUT_LAG.run(row)).collect();
        let all = Fit::of(Column::Minimum, &runs);
        runs[7] = None;
        let one_less = Fit::of(Column::Minimum, &runs);
        assert_eq!(one_less.within_one, all.within_one - 1);
        assert!(all.likelihoods[0].log.is_finite() && one_less.likelihoods[0].log == f64::NEG_INFINITY);
        assert!(one_less.mean.is_finite());
    }
}
