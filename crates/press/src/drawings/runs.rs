//! The figures of the runs of the thesis: its tables as plain numbers, against the motion that the equation has.

use anyhow::Context;
use geneva_dynamics::{Inertias, Slots};
use geneva_figures::Figure;
use geneva_figures::runs::{Deviation, Deviations, Group, Run, deviations, over_torque};
use geneva_ledger::meyer::runs::{Column, Fold, Hypothesis, Mechanism, Reading, Row, SixPin, rows, scores};

/// The figure of this name; `None` if it is not one of the runs.
pub fn by_name(name: &str) -> Option<anyhow::Result<Figure>> {
    let torque = |mechanism| Ok(over_torque(&group(mechanism)?)?);
    Some(match name {
        "runs-four-pin" => torque(Mechanism::FourPin),
        "runs-six-pin" => torque(Mechanism::SixPin),
        "runs-three-pin" => torque(Mechanism::ThreePin),
        "runs-hypotheses" => hypotheses().map(|hypotheses| deviations(&hypotheses)),
        _ => return None,
    })
}

/// A mechanism's rows, with the fold and the inertias that explain the tables.
pub fn group(mechanism: Mechanism) -> anyhow::Result<Group> {
    let [driver, follower] = Hypothesis::BEST.inertias(mechanism);
    let runs = rows().iter().filter(|row| row.mechanism == mechanism).map(|row| Run {
        friction: row.friction(),
        torque: row.torque(),
        peak: row.number(Column::Peak),
        minimum: row.number(Column::Minimum),
        rise: row.number(Column::Rise),
        period: row.number(Column::Period),
    });
    Ok(Group {
        slots: slots(mechanism)?,
        inertias: Inertias::new(driver, follower)?,
        fold: Hypothesis::BEST.angle(mechanism),
        runs: runs.collect(),
    })
}

fn slots(mechanism: Mechanism) -> anyhow::Result<Slots> {
    Slots::ALL.into_iter().find(|slots| slots.pins() == mechanism.pins()).context("no mechanism with so many pins")
}

/// What each of the compared hypotheses makes of the rows.
fn hypotheses() -> anyhow::Result<Vec<Deviations>> {
    let mut compared: Vec<Hypothesis> = scores().into_iter().map(|score| score.hypothesis).collect();
    compared.dedup();
    compared.iter().map(of_hypothesis).collect()
}

fn of_hypothesis(hypothesis: &Hypothesis) -> anyhow::Result<Deviations> {
    let of = |row: &Row| -> anyhow::Result<Deviation> {
        let run = hypothesis.run(row).context("a run's data make no escapement")?;
        let off = |value: f64, column| value / row.number(column) - 1.0;
        Ok(Deviation {
            slots: slots(row.mechanism)?,
            peak: off(run.peak, Column::Peak),
            minimum: off(run.minimum, Column::Minimum),
            period: off(run.period, Column::Period),
        })
    };
    Ok(Deviations { name: words(hypothesis), runs: rows().iter().map(of).collect::<anyhow::Result<_>>()? })
}

/// A hypothesis in one short line.
fn words(hypothesis: &Hypothesis) -> String {
    let fold = match hypothesis.fold {
        Fold::OfTheMechanism => "back after 360°/m",
        Fold::OneForAll => "back after 90°",
    };
    let inertias = match hypothesis.six_pin {
        SixPin::AsHeaded => "inertias as headed",
        SixPin::AsDrawn => "as in Fig. 11",
    };
    let reading = match hypothesis.reading {
        Reading::True => "true peaks",
        Reading::OnTheGrid => "printed peaks",
    };
    let sign = if hypothesis.delay.is_some() { ", old sign" } else { "" };
    format!("{fold}, {inertias}, {reading}{sign}")
}
