//! The figures of the runs of the thesis: its tables as plain numbers, against the motion that the equation has.

use anyhow::Context;
use geneva_dynamics::Inertias;
use geneva_figures::Figure;
use geneva_figures::runs::{
    Deviation, Deviations, Group, Run, aliasing, deviations, first_minimum, over_torque, speeds,
};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::{
    Column, Constants, Fold, Hypothesis, Reading, Row, Run as Computed, Score, SixPin, interval, rows, scores,
};
use geneva_ledger::printed_value;

/// The figure of this name; `None` if it is not one of the runs.
pub fn by_name(name: &str) -> Option<anyhow::Result<Figure>> {
    let torque = |mechanism| Ok(over_torque(&group(mechanism)?)?);
    Some(match name {
        "runs-four-pin" => torque(Mechanism::FOUR_PIN),
        "runs-six-pin" => torque(Mechanism::SIX_PIN),
        "runs-three-pin" => torque(Mechanism::THREE_PIN),
        "runs-hypotheses" => hypotheses().map(|hypotheses| deviations(&hypotheses)),
        "runs-aliasing" => swinging(),
        "runs-speeds" => drawn(),
        _ => return None,
    })
}

/// The four-pin run with the least friction and, of those, the strongest spring.
fn swinging() -> anyhow::Result<Figure> {
    let easier = |a: &&Row, b: &&Row| a.friction().total_cmp(&b.friction()).then(b.torque().total_cmp(&a.torque()));
    let row = four_pins().min_by(easier).context("no run with four pins")?;
    let engagement = Hypothesis::BEST.engagement(row).context("the run's data make no escapement")?;
    let duration = printed_value("meyer.listing.run-length").context("no length of the runs")?;
    Ok(aliasing(&engagement, interval(), duration)?)
}

/// Half a unit of the last digit of the rise time that is printed of Fig. 8.
const HALF_UNIT: f64 = 0.5e-3;

/// Fig. 8: the first of the four-pin rows whose first minimum rounds to the printed rise time of the figure.
fn drawn() -> anyhow::Result<Figure> {
    let printed = printed_value("meyer.fig-8.rise").context("no rise time of Fig. 8")?;
    let mut fitting = Vec::new();
    for row in four_pins() {
        let engagement = Hypothesis::BEST.engagement(row).context("the run's data make no escapement")?;
        if (first_minimum(&engagement)?.time - printed).abs() <= HALF_UNIT {
            fitting.push((row, engagement));
        }
    }
    let named = |row: &Row| format!("μ = {}, K = {}", row.printed(Column::Friction), row.printed(Column::Torque));
    let (row, engagement) = fitting.first().context("no run has the printed rise time")?;
    let others: Vec<String> = fitting.iter().skip(1).map(|(row, _)| named(row)).collect();
    let fits = if others.is_empty() { String::new() } else { format!(" So does that of {}.", others.join(" and of ")) };
    let words =
        format!("Four pins, {}: its first minimum rounds to the rise time printed of Fig. 8.{fits}", named(row));
    Ok(speeds(engagement, &words)?)
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
        mechanism: mechanism,
        inertias: Inertias::new(driver, follower)?,
        fold: Hypothesis::BEST.angle(mechanism),
        runs: runs.collect(),
    })
}

/// The runs with four pins.
pub fn four_pins() -> impl Iterator<Item = &'static Row> {
    rows().iter().filter(|row| row.mechanism == Mechanism::FOUR_PIN)
}

/// What each of the compared hypotheses makes of the rows.
fn hypotheses() -> anyhow::Result<Vec<Deviations>> {
    scores().iter().map(deviations_of).collect()
}

fn deviations_of(score: &Score) -> anyhow::Result<Deviations> {
    let of = |(row, run): (&Row, &Option<Computed>)| -> anyhow::Result<Deviation> {
        let run = run.context("a run's data make no escapement")?;
        let off = |column| run.number(column) / row.number(column) - 1.0;
        Ok(Deviation {
            mechanism: row.mechanism,
            peak: off(Column::Peak),
            minimum: off(Column::Minimum),
            period: off(Column::Period),
        })
    };
    Ok(Deviations {
        name: words(&score.hypothesis),
        runs: rows().iter().zip(&score.runs).map(of).collect::<anyhow::Result<_>>()?,
    })
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
    let constants = if hypothesis.constants == Constants::AsListed { ", listed π" } else { "" };
    let sign = if hypothesis.delay.is_some() { ", old sign" } else { "" };
    format!("{fold}, {inertias}, {reading}{constants}{sign}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawings;

    #[test]
    fn figures_of_many_runs_stay_light() {
        let names = drawings::NAMES.iter().filter(|name| name.starts_with("runs-") || name.starts_with("steady-"));
        let figures: Vec<Figure> = names.map(|name| drawings::by_name(name).expect("a figure")).collect();
        assert_eq!(figures.len(), 12);
        for figure in figures {
            assert!(figure.svg.len() < 40_000, "{}: {} bytes", figure.id, figure.svg.len());
        }
    }

    #[test]
    fn every_row_is_in_its_group_and_under_every_hypothesis() {
        let groups = Mechanism::ALL.map(|mechanism| group(mechanism).expect("a group"));
        assert_eq!(groups.iter().map(|group| group.runs.len()).sum::<usize>(), rows().len());
        let compared = hypotheses().expect("hypotheses");
        assert_eq!(compared.len(), scores().len());
        assert!(compared.iter().all(|one| one.runs.len() == rows().len()));
        // The scores of the ledger and the marks of the drawing are of the same deviations.
        for (score, one) in scores().iter().zip(&compared) {
            let further = |worst: f64, off: f64| if off.abs() > worst.abs() { off } else { worst };
            let worst = one.runs.iter().map(|run| run.peak).fold(0.0, further);
            let score = score.on(Column::Peak).expect("a fit").worst;
            assert!((worst - score).abs() < 1e-12, "{}: {worst} and {score}", one.name);
        }
    }

    #[test]
    fn the_run_of_fig_8_is_one_that_has_its_rise_time() {
        let figure = drawn().expect("a figure");
        let printed = printed_value("meyer.fig-8.rise").expect("a number");
        let row = four_pins().find(|row| {
            let engagement = Hypothesis::BEST.engagement(row).expect("an escapement");
            (first_minimum(&engagement).expect("a minimum").time - printed).abs() <= HALF_UNIT
        });
        let row = row.expect("a run");
        assert!(figure.caption.contains(&format!(
            "μ = {}, K = {}",
            row.printed(Column::Friction),
            row.printed(Column::Torque)
        )));
        assert!(figure.caption.contains("So does that of"), "the ledger knows of two");
    }
}
