//! The figures of the escapement, for the mechanisms and the runs of the thesis.

use anyhow::{Context, anyhow};
use geneva_dynamics::Parameters;
use geneva_figures::Figure;
use geneva_figures::escapement::{
    Design, angles, existence, forces, hand_over, mechanism, normal_force, order, ratios,
};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::{Hypothesis, Row, rows};

/// Driver angle of the drawings of a general position, as a part of the half angle of the engagement.
const GENERAL: f64 = -0.5;

/// The figure of this name; `None` if it is not one of the escapement.
pub fn by_name(name: &str) -> Option<anyhow::Result<Figure>> {
    let at = |slots: u32| Mechanism::new(slots).context("the thesis's mechanism cannot be built");
    let drawn = |slots: u32, part: f64| {
        let escapement = at(slots)?;
        Ok(mechanism(&escapement, part * escapement.engagement_half_angle())?)
    };
    Some(match name {
        "escapement-mechanism-4" => drawn(4, GENERAL),
        "escapement-mechanism-3" => drawn(3, GENERAL),
        "escapement-mechanism-6" => drawn(6, GENERAL),
        "escapement-hand-over-4" => at(4).map(|escapement| hand_over(&escapement)),
        "escapement-angles-4" => at(4).and_then(|escapement| {
            let crank = GENERAL * escapement.engagement_half_angle();
            Ok(angles(&escapement, crank)?)
        }),
        "escapement-ratios" => Ok(ratios(&Mechanism::ALL)),
        "escapement-forces" => example().and_then(|(parameters, speed)| {
            let crank = -GENERAL * parameters.mechanism().engagement_half_angle();
            Ok(forces(&parameters, crank, speed)?)
        }),
        "escapement-normal-force" => example().and_then(|(parameters, speed)| Ok(normal_force(&parameters, speed)?)),
        "escapement-existence" => designs().map(|designs| existence(&designs)),
        "integrator-order" => Ok(order()),
        _ => return None,
    })
}

/// The first run of the four-pin mechanism, and its speed as a pin enters in the steady state.
fn example() -> anyhow::Result<(Parameters, f64)> {
    let row = rows().iter().find(|row| row.mechanism == Mechanism::FOUR_PIN).context("no run with four pins")?;
    let parameters = Hypothesis::TRUE.parameters(row).context("the run's data make no escapement")?;
    let steady = Hypothesis::TRUE.engagement(row).context("the run's data make no escapement")?.steady_state()?;
    Ok((parameters, steady.entry_speed))
}

/// The runs of the thesis as points of the map: one for each mechanism and friction, whatever the torque.
pub fn designs() -> anyhow::Result<Vec<Design>> {
    let mut designs: Vec<Design> = Vec::new();
    for row in rows() {
        let parameters = Hypothesis::TRUE.parameters(row).ok_or_else(|| anyhow!("a run's data make no escapement"))?;
        let design = Design {
            name: name(row),
            mechanism: parameters.mechanism(),
            inertia_ratio: parameters.inertias().ratio(),
            friction: parameters.friction(),
        };
        if designs.iter().all(|known| known.mechanism != design.mechanism || known.friction != design.friction) {
            designs.push(design);
        }
    }
    Ok(designs)
}

fn name(row: &Row) -> String {
    format!("{} pins", row.mechanism.pins())
}
