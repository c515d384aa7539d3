//! The tables of the thesis's runs as they should have been.

use super::signed;
use crate::html::{Cells, table};
use anyhow::Context;
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::{Column, Hypothesis, Row, SixPin, rows};

/// The tables of six and three pins, printed and as they should have been.
pub fn six_pin() -> anyhow::Result<String> {
    corrected(Mechanism::SIX_PIN)
}

/// The same of four pins.
pub fn four_pin() -> anyhow::Result<String> {
    corrected(Mechanism::FOUR_PIN)
}

/// The same of three pins.
pub fn three_pin() -> anyhow::Result<String> {
    corrected(Mechanism::THREE_PIN)
}

/// The same of six pins with the inertias of the table's heading.
pub fn six_pin_as_headed() -> anyhow::Result<String> {
    of(Mechanism::SIX_PIN, Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::TRUE })
}

fn corrected(mechanism: Mechanism) -> anyhow::Result<String> {
    of(mechanism, Hypothesis::TRUE)
}

fn of(mechanism: Mechanism, hypothesis: Hypothesis) -> anyhow::Result<String> {
    let cells = rows().iter().filter(|row| row.mechanism == mechanism).map(|row| line(row, &hypothesis));
    let cells = cells.collect::<anyhow::Result<Vec<_>>>()?;
    let head = [
        "μ",
        "K",
        "peak printed",
        "peak",
        "off by %",
        "minimum printed",
        "minimum",
        "off by %",
        "period printed",
        "period",
        "mean speed",
    ];
    let name = format!("The runs with {} pins, printed and as they should have been", mechanism.pins());
    Ok(table(&name, Cells::Numbers, &head, &cells))
}

fn line(row: &Row, hypothesis: &Hypothesis) -> anyhow::Result<Vec<String>> {
    let engagement = hypothesis.engagement(row).context("a run's data make no escapement")?;
    let steady = engagement.steady_state()?;
    let off = |column, value: f64| signed(100.0 * (row.number(column) / value - 1.0), 0);
    let printed = |column| row.printed(column).to_owned();
    Ok(vec![
        printed(Column::Friction),
        printed(Column::Torque),
        printed(Column::Peak),
        format!("{:.1}", steady.peak.speed),
        off(Column::Peak, steady.peak.speed),
        printed(Column::Minimum),
        format!("{:.2}", steady.minimum.speed),
        off(Column::Minimum, steady.minimum.speed),
        printed(Column::Period),
        format!("{:.5}", steady.period),
        format!("{:.2}", steady.mean_speed),
    ])
}
