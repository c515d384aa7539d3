//! What the contestants are asked for, and how far from the truth their answers are.

use crate::rows::escapements;
use geneva_dynamics::steady::{Engagement, SteadyState};
use geneva_dynamics::{DynamicsError, Parameters};
use std::time::{Duration, Instant};

/// A run lasts so many periods of the steady state: about ten engagements, as the first ones are slower.
const PERIODS: f64 = 8.0;

/// At so many times, evenly over the run, the start not counted, the driver's speed is asked for.
pub(crate) const TIMES: usize = 64;

/// Tolerance of what is taken for the truth: the finest of the solver over the angle, which its tests hold against two
/// other routes.
pub(crate) const REFERENCE: f64 = 1e-13;

/// One escapement and the truth about it.
pub(crate) struct ReferenceRun {
    pub escapement: Parameters,
    /// Time from one line to the next.
    pub interval: f64,
    pub duration: f64,
    pub steady: SteadyState,
    /// θ' at the times.
    pub speeds: Vec<f64>,
}

impl ReferenceRun {
    fn new(escapement: Parameters) -> Result<Self, DynamicsError> {
        let engagement = Engagement::with_tolerance(&escapement, REFERENCE)?;
        let steady = engagement.steady_state()?;
        let duration = PERIODS * steady.period;
        let interval = duration / TIMES as f64;
        let lines = engagement.run(interval, duration)?;
        let speeds = lines.iter().skip(1).map(|line| line.speed).collect();
        Ok(Self { escapement, interval, duration, steady, speeds })
    }
}

/// All rows.
pub(crate) fn rows(count: usize) -> Result<Vec<ReferenceRun>, DynamicsError> {
    escapements().into_iter().take(count).map(ReferenceRun::new).collect()
}

/// What one contestant finds for one row: numbers to be held against the truth, and what they cost.
pub(crate) struct SolverAnswer {
    pub numbers: Vec<f64>,
    /// Evaluations of a right-hand side; none if the method has none.
    pub evaluations: Option<u64>,
}

/// A method at a tolerance.
pub(crate) struct Contestant {
    pub name: &'static str,
    pub tolerance: f64,
    pub solve: fn(&ReferenceRun, f64) -> Option<SolverAnswer>,
    pub truth: fn(&ReferenceRun) -> Vec<f64>,
}

/// How a contestant did.
#[derive(Clone, Copy)]
pub(crate) struct RaceScore {
    /// Rows that it finished.
    pub runs: usize,
    pub evaluations: Option<u64>,
    /// Largest relative error of a number.
    pub error: f64,
    pub time: Duration,
}

impl Contestant {
    /// Solves all rows, one after the other; the comparison with the truth is not timed.
    pub(crate) fn race(&self, rows: &[ReferenceRun]) -> RaceScore {
        let start = Instant::now();
        let answers: Vec<_> = rows.iter().map(|row| (self.solve)(row, self.tolerance)).collect();
        let time = start.elapsed();
        let mut all = RaceScore { runs: 0, evaluations: None, error: 0.0, time };
        for (row, answer) in rows.iter().zip(&answers) {
            let truth = (self.truth)(row);
            let Some(answer) = answer.as_ref().filter(|answer| answer.numbers.len() == truth.len()) else { continue };
            all.runs += 1;
            all.evaluations = answer.evaluations.map(|count| count + all.evaluations.unwrap_or(0));
            for (number, truth) in answer.numbers.iter().zip(&truth) {
                all.error = all.error.max((number / truth - 1.0).abs());
            }
        }
        all
    }
}

/// The truth about a run: the speed at the times.
pub(crate) fn speeds(row: &ReferenceRun) -> Vec<f64> {
    row.speeds.clone()
}

/// The truth about a steady state.
pub(crate) fn steady(row: &ReferenceRun) -> Vec<f64> {
    numbers(&row.steady)
}

/// The numbers of a steady state that are compared.
pub(crate) fn numbers(steady: &SteadyState) -> Vec<f64> {
    vec![steady.entry_speed, steady.peak.speed, steady.minimum.speed, steady.period]
}

/// The truth about a steady state without its extremes.
pub(crate) fn terminal(row: &ReferenceRun) -> Vec<f64> {
    vec![row.steady.entry_speed, row.steady.period]
}
