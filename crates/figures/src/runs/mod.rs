//! Runs of an escapement, given as tables, against the motion that the equation has.
//!
//! What a table gives comes in as plain numbers; everything else is computed by `geneva-dynamics` and
//! `geneva-case1973`.

mod agreement;
mod aliasing;
mod columns;
mod deviations;
mod lags;
mod over_torque;
mod reset_angle;
mod speeds;
#[cfg(test)]
mod tests;

pub use agreement::{ComparedCells, agreement, one_agreement};
pub use aliasing::aliasing;
pub use columns::{Count, columns};
pub use deviations::deviations;
pub use lags::{LagLikelihood, lags};
pub use over_torque::over_torque;
pub use reset_angle::{Scan, reset_angle};
pub use speeds::{first_minimum, speeds};

use crate::error::FigureError;
use crate::number::extent;
use geneva_case1973::{Column, Hypothesis, Row};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// Relative error of what is computed for a drawing.
const TOLERANCE: f64 = 1e-10;

/// What a table gives for one run. In one system of units; speeds in radians per unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintedRun {
    /// Coefficient of friction.
    pub friction: f64,
    /// Torque on the driver.
    pub torque: f64,
    /// Greatest speed of the driver.
    pub peak: f64,
    /// Least speed of the driver in the steady cycle.
    pub minimum: f64,
    /// Rise time.
    pub rise: f64,
    /// Time from one peak to the next.
    pub period: f64,
}

/// The runs of one mechanism, and what they were computed with.
#[derive(Clone, Debug, PartialEq)]
pub struct MechanismRuns {
    /// Pins, slots and centre distance.
    pub mechanism: Mechanism,
    /// Moments of inertia.
    pub inertias: Inertias,
    /// Angle in radians after which the driver's angle is reset to the start of an engagement.
    pub reset: f64,
    /// The runs.
    pub runs: Vec<PrintedRun>,
}

impl MechanismRuns {
    /// The printed runs of a mechanism, with the inertias and the reset angle that a hypothesis gives them. None without rows.
    pub fn from_rows(hypothesis: &Hypothesis, rows: &[Row]) -> Option<Self> {
        let first = rows.first()?;
        let run = |row: &Row| PrintedRun {
            friction: row.friction(),
            torque: row.torque(),
            peak: row.number(Column::Peak),
            minimum: row.number(Column::Minimum),
            rise: row.number(Column::Rise),
            period: row.number(Column::Period),
        };
        Some(Self {
            mechanism: first.mechanism,
            inertias: hypothesis.parameters(first)?.inertias(),
            reset: hypothesis.angle(first),
            runs: rows.iter().map(run).collect(),
        })
    }

    /// The engagement at a friction and a torque, with this reset angle.
    pub(crate) fn engagement(&self, friction: f64, torque: f64, reset: f64) -> Result<Engagement, FigureError> {
        let parameters = Parameters::new(self.mechanism, self.inertias, torque, friction)?;
        Ok(Engagement::reset_after(&parameters, reset, TOLERANCE)?)
    }

    /// The mechanism's own reset angle, if it is another.
    pub(crate) fn own_reset(&self) -> Option<f64> {
        let own = 2.0 * self.mechanism.engagement_half_angle();
        ((own - self.reset).abs() > 1e-3 * own).then_some(own)
    }

    /// The frictions, rising.
    fn frictions(&self) -> Vec<f64> {
        let mut frictions: Vec<f64> = self.runs.iter().map(|run| run.friction).collect();
        frictions.sort_by(f64::total_cmp);
        frictions.dedup();
        frictions
    }

    /// The least and the greatest of a value.
    fn range(&self, value: fn(&PrintedRun) -> f64) -> [f64; 2] {
        extent(self.runs.iter().map(value))
    }
}
