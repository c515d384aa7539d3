//! The figures of the steady motion, for the mechanisms and the runs of the thesis.

use super::escapement::designs;
use super::runs::{four_pins, group};
use anyhow::Context;
use geneva_dynamics::Parameters;
use geneva_figures::Figure;
use geneva_figures::runs::Group;
use geneva_figures::steady::{collapse, hand_over, map, phase};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::Hypothesis;

/// The figure of this name; `None` if it is not one of the steady motion.
pub fn by_name(name: &str) -> Option<anyhow::Result<Figure>> {
    Some(match name {
        "steady-hand-over" => example().and_then(|parameters| Ok(hand_over(&parameters)?)),
        "steady-phase" => example().and_then(|parameters| Ok(phase(&parameters)?)),
        "steady-collapse" => all().and_then(|groups| Ok(collapse(&groups)?)),
        "steady-map-four-pin" => map_of(Mechanism::FOUR_PIN),
        "steady-map-six-pin" => map_of(Mechanism::SIX_PIN),
        "steady-map-three-pin" => map_of(Mechanism::THREE_PIN),
        _ => return None,
    })
}

/// The four-pin run that brakes least: its engagements can be told apart longest.
fn example() -> anyhow::Result<Parameters> {
    let row = four_pins().min_by(|a, b| a.friction().total_cmp(&b.friction())).context("no run with four pins")?;
    Hypothesis::TRUE.parameters(row).context("the run's data make no escapement")
}

/// The map of a mechanism, with its runs.
fn map_of(mechanism: Mechanism) -> anyhow::Result<Figure> {
    Ok(map(group(mechanism)?.mechanism, &designs()?)?)
}

/// All runs, as they were.
fn all() -> anyhow::Result<Vec<Group>> {
    Mechanism::ALL.into_iter().map(group).collect()
}
