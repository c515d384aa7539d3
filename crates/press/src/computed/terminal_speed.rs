//! Of the chapter on the steady state: multipliers, over the rows of the thesis as the mechanisms are.

use super::Number;
use super::escapement::over;
use crate::rows::engagement;
use anyhow::Context;
use geneva_dynamics::steady::SteadyState;
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::rows_of;
use geneva_ledger::meyer::runs::{Column, Hypothesis, Row, rows, series};

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("terminal-speed.multiplier.three-pin", || multiplier(Mechanism::THREE_PIN)),
    ("terminal-speed.multiplier.four-pin", || multiplier(Mechanism::FOUR_PIN)),
    ("terminal-speed.multiplier.six-pin", || multiplier(Mechanism::SIX_PIN)),
    ("terminal-speed.minimum", || angle(|steady| -steady.minimum.angle)),
    ("terminal-speed.reversal", || angle(|steady| steady.reversal_angle.unwrap_or(f64::NAN))),
    ("terminal-speed.law.groups", || Ok(series().count().to_string())),
    ("terminal-speed.law.minima", || Ok(obeying(Column::Minimum, 0.5).to_string())),
    ("terminal-speed.law.periods", || Ok(obeying(Column::Period, -0.5).to_string())),
    ("terminal-speed.law.peaks", || Ok(obeying(Column::Peak, 0.5).to_string())),
    ("terminal-speed.law.rises", || Ok(obeying(Column::Rise, -0.5).to_string())),
    ("terminal-speed.first-minimum.within", || {
        let is_near = |row: &Row| -> anyhow::Result<bool> {
            let rise = engagement(row, &Hypothesis::IDEAL)?.rise(1e-6)?;
            let first = engagement(row, &Hypothesis::IDEAL)?.first_minimum()?.context("no first minimum")?;
            let (steady, unit) = (&rise.steady, Column::Minimum.unit());
            let later = rise.cycles.iter().skip(1).flat_map(|cycle| {
                let entry = cycle.entry_speed - steady.entry_speed;
                [cycle.minimum.speed - steady.minimum.speed, entry, cycle.peak.speed - steady.peak.speed]
            });
            let peak = rise.cycles.first().map_or(f64::NAN, |cycle| cycle.peak.speed - steady.peak.speed);
            Ok([first.speed - steady.minimum.speed, peak].into_iter().chain(later).all(|off| off.abs() < unit))
        };
        let near = rows().iter().map(is_near).collect::<anyhow::Result<Vec<_>>>()?;
        Ok(near.iter().filter(|near| **near).count().to_string())
    }),
];

/// In how many groups of runs the printed numbers of a column go as this power of the torque, each to one unit.
fn obeying(column: Column, power: f64) -> usize {
    let obeys = |own: &&[Row]| {
        let allowed = own.iter().fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], row| {
            let scale = if power > 0.0 { 1.0 / row.torque().sqrt() } else { row.torque().sqrt() };
            let [least, most] = [-1.0, 1.0].map(|off| (row.number(column) + off * column.unit()) * scale);
            [low.max(least), high.min(most)]
        });
        allowed[0] <= allowed[1]
    };
    series().filter(obeys).count()
}

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
