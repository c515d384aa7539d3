//! The figures of the chapter on the timer's accuracy.

use crate::computed::timer::{SET, STEEL_ON_BRASS};
use crate::rows::{NONE, example, number};
use crate::tables::timer::PARTS;
use anyhow::Context;
use geneva_case1973::{Column, Hypothesis, rows_of};
use geneva_documents::meyer::runs::table::rows;
use geneva_figures::Figure;
use geneva_figures::timer::{self, Tested};
use geneva_kinematics::Mechanism;
use geneva_press::numbers::fixed;

/// The mechanisms with the frictions of their runs.
fn tested() -> anyhow::Result<Vec<Tested>> {
    Mechanism::ALL.into_iter().map(|mechanism| Tested::from_rows(rows_of(rows(), mechanism)).context(NONE)).collect()
}

/// Hours a day over the friction, beside handbook values of steel on brass.
pub(super) fn friction() -> anyhow::Result<Figure> {
    Ok(timer::friction(&tested()?, SET, &STEEL_ON_BRASS)?)
}

/// Minutes a day for one per cent of each quantity.
pub(super) fn sensitivity() -> anyhow::Result<Figure> {
    Ok(timer::sensitivity(&tested()?)?)
}

/// The greatest accelerations and forces.
pub(super) fn strongest() -> anyhow::Result<Figure> {
    Ok(timer::strongest(&tested()?)?)
}

/// How long four pins take to settle, with lighter followers.
pub(super) fn settling() -> anyhow::Result<Figure> {
    let row = example()?;
    let run = format!(
        "four pins, μ = {}, K = {} in lb, driver's inertia {} · 10⁻⁶ in lb s²",
        row.printed(Column::Friction),
        row.printed(Column::Torque),
        fixed(1e6 * number(row, "driver_inertia")?, 0)
    );
    Ok(timer::settling(&Hypothesis::IDEAL.parameters(row).context(NONE)?, &PARTS, &run)?)
}
