//! Of the chapter on the steady state: multipliers, over the rows of the thesis as the mechanisms are.

use super::Number;
use super::escapement::over;
use crate::rows::engagement;
use geneva_dynamics::steady::SteadyState;
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::rows_of;
use geneva_ledger::meyer::runs::{Hypothesis, Row, rows};

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("terminal-speed.multiplier.three-pin", || multiplier(Mechanism::THREE_PIN)),
    ("terminal-speed.multiplier.four-pin", || multiplier(Mechanism::FOUR_PIN)),
    ("terminal-speed.multiplier.six-pin", || multiplier(Mechanism::SIX_PIN)),
    ("terminal-speed.minimum", || angle(|steady| -steady.minimum.angle)),
    ("terminal-speed.reversal", || angle(|steady| steady.switch_angle.unwrap_or(f64::NAN))),
];

/// The steady state of a row.
fn steady(row: &Row) -> anyhow::Result<SteadyState> {
    Ok(engagement(row, &Hypothesis::IDEAL)?.steady_state()?)
}

/// What an engagement leaves of a small difference at most, over the rows of a mechanism.
fn multiplier(mechanism: Mechanism) -> anyhow::Result<String> {
    let multipliers = rows_of(mechanism).map(|row| Ok(steady(row)?.multiplier)).collect::<anyhow::Result<Vec<_>>>()?;
    Ok(format!("{:.3}", multipliers.into_iter().fold(0.0, f64::max)))
}

/// An angle of the steady state in degrees, from the least to the greatest over all rows.
fn angle(of: fn(&SteadyState) -> f64) -> anyhow::Result<String> {
    Ok(format!("{}°", over(rows().iter().map(|row| Ok(of(&steady(row)?).to_degrees())), 1)?))
}
