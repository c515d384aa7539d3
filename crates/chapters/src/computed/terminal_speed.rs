//! Of the chapter on the steady state: multipliers, over the rows of the thesis as the mechanisms are.

use super::{Number, most, over};
use crate::rows::{NONE, numbers};
use anyhow::Context;
use geneva_case1973::rise_times::is_steady_from_the_first_minimum;
use geneva_case1973::{Column, obeys, rows_of, series};
use geneva_documents::meyer::runs::table::rows;
use geneva_kinematics::Mechanism;

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("terminal-speed.multiplier.three-pin", || multiplier(Mechanism::THREE_PIN)),
    ("terminal-speed.multiplier.four-pin", || multiplier(Mechanism::FOUR_PIN)),
    ("terminal-speed.multiplier.six-pin", || multiplier(Mechanism::SIX_PIN)),
    ("terminal-speed.minimum", || angle("minimum_angle_deg")),
    ("terminal-speed.reversal", || angle("reversal_angle_deg")),
    ("terminal-speed.law.groups", || Ok(series(rows()).count().to_string())),
    ("terminal-speed.law.minima", || Ok(obeying(Column::Minimum, 0.5).to_string())),
    ("terminal-speed.law.periods", || Ok(obeying(Column::Period, -0.5).to_string())),
    ("terminal-speed.law.peaks", || Ok(obeying(Column::Peak, 0.5).to_string())),
    ("terminal-speed.law.rises", || Ok(obeying(Column::Rise, -0.5).to_string())),
    ("terminal-speed.first-minimum.within", || {
        let near = rows().iter().map(|row| is_steady_from_the_first_minimum(row).context(NONE));
        Ok(near.collect::<anyhow::Result<Vec<_>>>()?.into_iter().filter(|near| *near).count().to_string())
    }),
];

/// In how many groups of runs the printed numbers of a column go as this power of the torque, each to one unit.
fn obeying(column: Column, power: f64) -> usize {
    series(rows()).filter(|own| obeys(own, column, power)).count()
}

/// What an engagement leaves of a small difference at most, over the rows of a mechanism.
fn multiplier(mechanism: Mechanism) -> anyhow::Result<String> {
    Ok(format!("{:.3}", most(&numbers(rows_of(rows(), mechanism).iter(), "multiplier")?)))
}

/// The size of an angle of the steady state in degrees, from the least to the greatest over all rows.
fn angle(key: &str) -> anyhow::Result<String> {
    let angles: Vec<f64> = numbers(rows().iter(), key)?.into_iter().map(f64::abs).collect();
    Ok(over(&angles, 1)? + "°")
}
