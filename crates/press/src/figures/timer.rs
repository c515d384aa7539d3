//! The figures of the chapter on the timer's accuracy.

use crate::computed::timer::{SET, STEEL_ON_BRASS};
use crate::numbers::fixed;
use crate::rows::{example, parameters};
use crate::tables::timer::settled;
use anyhow::Context;
use geneva_figures::Figure;
use geneva_figures::timer::{self, Tested};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::Column;
use geneva_ledger::meyer::runs::choice::weakest;

/// The mechanisms with the frictions of their runs.
fn tested() -> anyhow::Result<Vec<Tested>> {
    let of = |mechanism| {
        let mut rows = weakest().filter(|row| row.mechanism == mechanism).peekable();
        let parameters = parameters(rows.peek().context("no run of a mechanism")?)?;
        let mut frictions: Vec<f64> = rows.map(|row| row.friction()).collect();
        frictions.sort_by(f64::total_cmp);
        Ok(Tested { parameters, frictions })
    };
    Mechanism::ALL.into_iter().map(of).collect()
}

/// Hours a day over the friction, beside handbook values of steel on brass.
pub fn friction() -> anyhow::Result<Figure> {
    Ok(timer::friction(&tested()?, SET, &STEEL_ON_BRASS)?)
}

/// Minutes a day for one per cent of each quantity.
pub fn sensitivity() -> anyhow::Result<Figure> {
    Ok(timer::sensitivity(&tested()?)?)
}

/// The greatest accelerations and forces.
pub fn strongest() -> anyhow::Result<Figure> {
    Ok(timer::strongest(&tested()?)?)
}

/// How long four pins take to settle, with lighter followers.
pub fn settling() -> anyhow::Result<Figure> {
    let row = example()?;
    let run = format!(
        "four pins, μ = {}, K = {} in lb, driver's inertia {} · 10⁻⁶ in lb s²",
        row.printed(Column::Friction),
        row.printed(Column::Torque),
        fixed(1e6 * parameters(row)?.inertias().driver(), 0)
    );
    Ok(timer::settling(&settled()?, &run)?)
}
