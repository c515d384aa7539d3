//! How many of the printed cells each hypothesis about the runs explains.

use super::*;
use std::sync::OnceLock;

/// The columns that a hypothesis is to explain.
pub const EXPLAINED: [Column; 3] = [Column::Peak, Column::Minimum, Column::Period];

/// How a hypothesis does.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// The hypothesis.
    pub hypothesis: Hypothesis,
    /// The runs of the hypothesis, row by row; none where the program came to no end.
    pub runs: Vec<Option<Run>>,
    /// The hypothesis's fit to peak, minimum and period.
    pub fits: [Fit; 3],
}

impl Score {
    /// The score of a hypothesis.
    pub fn of(hypothesis: Hypothesis) -> Self {
        let runs: Vec<_> = rows().iter().map(|row| hypothesis.run(row)).collect();
        Self { hypothesis, fits: EXPLAINED.map(|column| Fit::of(column, &runs)), runs }
    }

    /// The fit to a column; none for a column that is not to be explained.
    pub fn on(&self, column: Column) -> Option<&Fit> {
        self.fits.iter().zip(EXPLAINED).find(|(_, of)| *of == column).map(|(fit, _)| fit)
    }

    /// The logarithm of the likelihood of all three columns, by each law of error.
    pub fn likelihoods(&self) -> [f64; 2] {
        [0, 1].map(|law| self.fits.iter().map(|fit| fit.likelihoods[law].log).sum())
    }

    /// Cells of 147 within one unit of the last place.
    pub fn within_one(&self) -> usize {
        self.fits.iter().map(|fit| fit.within_one).sum()
    }
}

/// The hypotheses that are compared: all choices of reset angle, inertias and reading, from the mechanism as it is to
/// the runs but for the program's own faults; then with its constants, and all that is in the listing.
fn compared() -> Vec<Hypothesis> {
    let mut all = Vec::new();
    for reset in [Reset::OfTheMechanism, Reset::QuarterTurn] {
        for six_pin in [SixPin::AsHeaded, SixPin::AsDrawn] {
            for reading in [Reading::True, Reading::OnTheGrid] {
                all.push(Hypothesis { reset, six_pin, reading, ..Hypothesis::WITHOUT_LAG });
            }
        }
    }
    all.push(Hypothesis { constants: Constants::AsListed, ..Hypothesis::WITHOUT_LAG });
    all.push(Hypothesis::as_run());
    all
}

/// The scores of all compared hypotheses.
pub fn scores() -> &'static [Score] {
    static SCORES: OnceLock<Vec<Score>> = OnceLock::new();
    SCORES.get_or_init(|| compared().into_iter().map(Score::of).collect())
}

/// The best hypothesis with the sign chosen by the acceleration of so long ago, in s, and its score: none for the exact
/// sign, then parts of the print interval up to all of it.
pub fn delays() -> &'static [(f64, Score)] {
    static SCORES: OnceLock<Vec<(f64, Score)>> = OnceLock::new();
    SCORES.get_or_init(|| {
        let of = |part: f64| {
            let delay = (part > 0.0).then_some(interval() * part);
            let constants = Constants::AsListed;
            (interval() * part, Score::of(Hypothesis { delay, constants, ..Hypothesis::WITHOUT_LAG }))
        };
        PARTS.map(of).to_vec()
    })
}

/// Delays, in print intervals.
const PARTS: [f64; 8] = [0.0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0];
