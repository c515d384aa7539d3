//! The thesis's runs: what explains the printed tables, what does not matter to them, and what they should have been.

use crate::html::{Cells, Table, table};
use crate::numbers::signed;
use crate::rows::engagement;
use anyhow::Context;
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::rows_of;
use geneva_ledger::meyer::runs::{
    Column, Fit, Hypothesis, Row, Score, SixPin, delays as all_delays, integrator as integrators, scores,
};

/// The hypotheses, how many cells each explains, and how likely it makes the tables.
pub fn hypotheses() -> anyhow::Result<Table> {
    let rows = (1..).zip(scores()).map(|(number, score)| {
        let mut row = vec![format!("{number}: {}", score.hypothesis.words()), score.within_one().to_string()];
        row.extend(logs(score));
        for fit in &score.fits {
            row.extend([counts(fit), signed(100.0 * fit.mean, 1), signed(100.0 * fit.worst, 1)]);
        }
        Ok(row)
    });
    let head = [
        "Hypothesis",
        "of 147",
        "ln L, normal",
        "exponential",
        "Peak",
        "mean %",
        "worst %",
        "Minimum",
        "mean %",
        "worst %",
        "Period",
        "mean %",
        "worst %",
    ];
    table("Hypotheses about the runs", Cells::NamedNumbers, &head, rows)
}

/// Delays of the sign of the friction.
pub fn delays() -> anyhow::Result<Table> {
    let rows = all_delays().iter().map(|(delay, score)| {
        let [peak, minimum, period] = &score.fits;
        let [normal, _] = peak.likelihoods;
        let mut row = vec![if *delay > 0.0 { format!("{:.3} ms", 1e3 * delay) } else { "none".to_owned() }];
        row.extend(logs(score));
        row.extend([counts(peak), signed(100.0 * peak.mean, 2), signed(100.0 * peak.worst, 1)]);
        row.extend([format!("{:.2}", normal.spread), counts(minimum), counts(period)]);
        Ok(row)
    });
    let head =
        ["Delay", "ln L, normal", "exponential", "Peak", "mean %", "worst %", "spread, rad/s", "Minimum", "Period"];
    table("Delays of the sign of the friction", Cells::NamedNumbers, &head, rows)
}

/// What changes when the integrator is told otherwise what the thesis does not tell.
pub fn integrator() -> anyhow::Result<Table> {
    let changes = integrators::changes().context("a run of the program of 1973 comes to no end")?;
    let rows = changes.iter().map(|(variant, changes)| {
        let mut row = vec![variant.name.to_owned()];
        for change in changes {
            row.extend(change.most.map(|most| format!("{:.1}", 1e6 * most)));
            row.push(change.printed_otherwise.to_string());
        }
        Ok(row)
    });
    let head = [
        "Changed",
        "peak, ppm",
        "minimum, ppm",
        "period, ppm",
        "digits",
        "lagged sign: peak, ppm",
        "minimum, ppm",
        "period, ppm",
        "digits",
    ];
    table("Parameters of the integrator that are not recorded", Cells::NamedNumbers, &head, rows)
}

/// Cells to the printed digit, and within one unit.
fn counts(fit: &Fit) -> String {
    format!("{} / {}", fit.exact, fit.within_one)
}

fn logs(score: &Score) -> [String; 2] {
    score.likelihoods().map(|log| signed(log, 1))
}

/// The runs with six pins, printed and as they should have been.
pub fn six_pin() -> anyhow::Result<Table> {
    corrected(Mechanism::SIX_PIN, &Hypothesis::IDEAL)
}

/// The same of four pins.
pub fn four_pin() -> anyhow::Result<Table> {
    corrected(Mechanism::FOUR_PIN, &Hypothesis::IDEAL)
}

/// The same of three pins.
pub fn three_pin() -> anyhow::Result<Table> {
    corrected(Mechanism::THREE_PIN, &Hypothesis::IDEAL)
}

/// The same of six pins with the inertias of the table's heading.
pub fn six_pin_as_headed() -> anyhow::Result<Table> {
    corrected(Mechanism::SIX_PIN, &Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::IDEAL })
}

fn corrected(mechanism: Mechanism, hypothesis: &Hypothesis) -> anyhow::Result<Table> {
    let cells = rows_of(mechanism).map(|row| printed_and_right(row, hypothesis));
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
    table(&name, Cells::Numbers, &head, cells)
}

fn printed_and_right(row: &Row, hypothesis: &Hypothesis) -> anyhow::Result<Vec<String>> {
    let steady = engagement(row, hypothesis)?.steady_state()?;
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
