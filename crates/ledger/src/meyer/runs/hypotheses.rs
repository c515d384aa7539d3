//! How many of the printed cells each hypothesis about the runs explains.

use super::*;
use crate::meyer::appendix_b::DELAY_PARTS;

/// How a hypothesis does on one column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Score {
    /// The hypothesis.
    pub hypothesis: Hypothesis,
    /// The column.
    pub column: Column,
    /// Cells that the computed number rounds to.
    pub exact: usize,
    /// Cells within one unit of the last place.
    pub within_one: usize,
    /// Mean of the relative deviation.
    pub mean: f64,
    /// The largest relative deviation, with its sign.
    pub worst: f64,
    /// Log-likelihood per cell of a normal error of the printed unit and half a per cent, relative to a perfect fit.
    pub likelihood: f64,
}

/// The hypotheses that are compared, from the mechanism as it is to the runs as they were.
fn compared() -> [Hypothesis; 6] {
    let delay = interval() / f64::from(DELAY_PARTS);
    [
        Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::TRUE },
        Hypothesis::TRUE,
        Hypothesis { six_pin: SixPin::AsHeaded, reading: Reading::True, ..Hypothesis::BEST },
        Hypothesis { reading: Reading::True, ..Hypothesis::BEST },
        Hypothesis::BEST,
        Hypothesis { delay: Some(delay), ..Hypothesis::BEST },
    ]
}

/// The scores of all compared hypotheses on peak, minimum and period.
pub fn scores() -> Vec<Score> {
    compared().iter().flat_map(score).collect()
}

fn score(hypothesis: &Hypothesis) -> Vec<Score> {
    let runs: Vec<_> = rows().iter().map(|row| (row, hypothesis.run(row))).collect();
    [Column::Peak, Column::Minimum, Column::Period].map(|column| on_column(*hypothesis, column, &runs)).to_vec()
}

fn on_column(hypothesis: Hypothesis, column: Column, runs: &[(&Row, Option<Run>)]) -> Score {
    let unit = if column == Column::Period { 1e-3 } else { 1.0 };
    let mut score = Score { hypothesis, column, exact: 0, within_one: 0, mean: 0.0, worst: 0.0, likelihood: 0.0 };
    for (row, run) in runs {
        let printed = row.number(column);
        let computed = run.map_or(f64::NAN, |run| match column {
            Column::Peak => run.peak,
            Column::Minimum => run.minimum,
            _ => run.period,
        });
        let (off, relative) = (computed - printed, computed / printed - 1.0);
        score.exact += usize::from(off.abs() <= unit / 2.0);
        score.within_one += usize::from(off.abs() <= unit);
        score.mean += relative / runs.len() as f64;
        if relative.abs() > score.worst.abs() {
            score.worst = relative;
        }
        let spread = unit * unit + (0.005 * printed) * (0.005 * printed);
        score.likelihood -= off * off / spread / 2.0 / runs.len() as f64;
    }
    score
}
