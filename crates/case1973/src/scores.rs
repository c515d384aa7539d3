//! How well each hypothesis about the runs explains the printed cells.

use crate::hypothesis::{Constants, Hypothesis, Lag, PeakReading, Reset, SixPin};
use crate::likelihood::{Law, Likelihood};
use crate::{Column, EXPLAINED, Row, Run};
use geneva_kinematics::Mechanism;

/// How a set of runs does on one column of the tables. The mean and the worst are over the runs that came to an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnFit {
    /// Cells that the computed number rounds to.
    pub exact: usize,
    /// Cells within one unit of the last place.
    pub within_one: usize,
    /// Mean of printed over computed, less one; dimensionless.
    pub mean: f64,
    /// Printed over computed, less one, where it is farthest from zero; dimensionless.
    pub worst: f64,
    /// How likely the printed cells are, by each law of error.
    pub likelihoods: [Likelihood; 2],
}

impl ColumnFit {
    /// How well computed numbers explain the printed ones of a column, row by row; a run that came to nothing explains
    /// nothing.
    ///
    /// In the statistical model, a printed number is the computed number plus an error of unknown spread, rounded to
    /// the unit. All hypotheses have this one parameter, so their likelihoods may be compared as they are.
    fn new(column: Column, rows: &[Row], computed: &[Option<f64>]) -> Self {
        let cells: Vec<_> =
            rows.iter().zip(computed).filter_map(|(row, found)| Some((row.number(column), (*found)?))).collect();
        let units: Vec<_> = cells.iter().map(|(printed, found)| (found - printed).abs() / column.unit()).collect();
        let relative = |(printed, computed): &(f64, f64)| printed / computed - 1.0;
        let further = |worst: f64, next: f64| if next.abs() > worst.abs() { next } else { worst };
        let whole = cells.len() == rows.len();
        let impossible = Likelihood { spread: f64::INFINITY, log: f64::NEG_INFINITY };
        Self {
            // In units, a half is a half but for the rounding of the quotient.
            exact: units.iter().filter(|off| **off <= 0.5 + 1e-9).count(),
            within_one: units.iter().filter(|off| **off <= 1.0 + 1e-9).count(),
            mean: cells.iter().map(relative).sum::<f64>() / cells.len() as f64,
            worst: cells.iter().map(relative).fold(0.0, further),
            likelihoods: Law::ALL.map(|law| if whole { law.maximum_likelihood(&units) } else { impossible }),
        }
    }
}

/// How a hypothesis does.
#[derive(Clone, Debug, PartialEq)]
pub struct Score<'a> {
    /// The hypothesis.
    pub hypothesis: Hypothesis,
    /// The printed rows.
    pub rows: &'a [Row],
    /// Peak, minimum and period of the runs of the hypothesis, row by row, each in its own unit; none where a run came to no
    /// end.
    pub results: Vec<Option<[f64; 3]>>,
    /// The hypothesis's fit to peak, minimum and period.
    pub fits: [ColumnFit; 3],
}

impl<'a> Score<'a> {
    /// The score of a hypothesis.
    pub fn new(hypothesis: Hypothesis, rows: &'a [Row]) -> Self {
        Self::from_results(hypothesis, rows, rows.iter().map(|row| hypothesis.results(row)).collect())
    }

    /// The score of a hypothesis whose runs have been made, row by row.
    pub fn from_results(hypothesis: Hypothesis, rows: &'a [Row], results: Vec<Option<[f64; 3]>>) -> Self {
        let fits = [0, 1, 2].map(|at| {
            let computed: Vec<_> = results.iter().map(|of| of.map(|numbers| numbers[at])).collect();
            ColumnFit::new(EXPLAINED[at], rows, &computed)
        });
        Self { hypothesis, rows, results, fits }
    }

    /// The fit to a column; none for a column that is not to be explained.
    pub fn fit(&self, column: Column) -> Option<&ColumnFit> {
        self.fits.iter().zip(EXPLAINED).find(|(_, of)| *of == column).map(|(fit, _)| fit)
    }

    /// The logarithm of the likelihood of all three columns, by each law of error; dimensionless.
    pub fn likelihoods(&self) -> [f64; 2] {
        [0, 1].map(|law| self.fits.iter().map(|fit| fit.likelihoods[law].log).sum())
    }

    /// Cells within one unit of the last place.
    pub fn within_one(&self) -> usize {
        self.fits.iter().map(|fit| fit.within_one).sum()
    }

    /// Cells of these mechanisms within one unit of the last place.
    pub fn within_one_of(&self, mechanisms: &[Mechanism]) -> usize {
        let own = self.rows.iter().zip(&self.results).filter(|(row, _)| mechanisms.contains(&row.mechanism));
        own.filter_map(|(row, results)| Some(row.explained_by(results.as_ref()?))).sum()
    }

    /// The printed cells and the computed numbers, row by row; not a number where a run came to no end.
    pub fn cells(&self) -> impl Iterator<Item = ComparedCell> + '_ {
        self.rows.iter().zip(&self.results).flat_map(|(row, results)| {
            let computed = results.unwrap_or([f64::NAN; 3]);
            [0, 1, 2].map(|at| ComparedCell {
                mechanism: row.mechanism,
                printed: row.number(EXPLAINED[at]) / EXPLAINED[at].unit(),
                computed: computed[at] / EXPLAINED[at].unit(),
            })
        })
    }
}

/// One printed number and the computed one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedCell {
    /// The mechanism whose table contains the number.
    pub mechanism: Mechanism,
    /// As printed, in units of the last printed place.
    pub printed: f64,
    /// As computed, in units of the last printed place.
    pub computed: f64,
}

impl ComparedCell {
    /// Whether the two are no more than a unit apart.
    pub fn is_within_one(&self) -> bool {
        (self.printed - self.computed).abs() <= 1.0 + 1e-9
    }
}

/// In how many rows a column of these runs comes within one unit of the last printed place.
pub fn within_one(column: Column, rows: &[Row], runs: &[Run]) -> usize {
    rows.iter().zip(runs).filter(|(row, run)| column.is_within_one(row.number(column), run.number(column))).count()
}

/// The hypotheses that are compared: all choices of reset angle, inertias and reading, from the mechanism as it is to
/// the runs but for the program's own faults; then with its constants, and all that is in the listing.
pub fn compared_hypotheses() -> Vec<Hypothesis> {
    let mut all = Vec::new();
    for reset in [Reset::OfTheMechanism, Reset::QuarterTurn] {
        for six_pin in [SixPin::AsHeaded, SixPin::AsDrawn] {
            for reading in [PeakReading::True, PeakReading::OnTheGrid] {
                all.push(Hypothesis { reset, six_pin, reading, ..Hypothesis::WITHOUT_LAG });
            }
        }
    }
    all.push(Hypothesis { constants: Constants::AsListed, ..Hypothesis::WITHOUT_LAG });
    all.push(Hypothesis::AS_RUN);
    all
}

/// Delays, in print intervals.
const PARTS: [f64; 8] = [0.0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0];

/// The program with the sign chosen by the acceleration of so long ago, in s, and its score: none for the exact sign,
/// then parts of the print interval up to all of it.
pub fn delays(rows: &[Row]) -> Vec<(f64, Score<'_>)> {
    let interval = rows.first().map_or(f64::NAN, |row| row.given.listing.interval);
    let of = |part: f64| {
        let lag = if part > 0.0 { Lag::Of(interval * part) } else { Lag::None };
        let hypothesis = Hypothesis { constants: Constants::AsListed, lag, ..Hypothesis::WITHOUT_LAG };
        (interval * part, Score::new(hypothesis, rows))
    };
    PARTS.map(of).to_vec()
}
