//! Of the chapter on the escapement: what came of it, in a few numbers, over all rows of the thesis as the mechanisms are.

use super::{Number, over};
use crate::rows::numbers;
use geneva_documents::meyer::runs::table::rows;

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("escapement.engagements", || over(&numbers(rows().iter(), "entry_speed_rise_engagements")?, 0)),
    ("escapement.hand-overs", || over(&numbers(rows().iter(), "hand_over_rate")?, 0)),
    ("escapement.friction-a-day", || minutes("friction_rate_s_a_day")),
    ("escapement.torque-a-day", || minutes("torque_rate_s_a_day")),
];

/// Minutes a day that one per cent of a quantity makes, over all rows.
fn minutes(rate: &str) -> anyhow::Result<String> {
    let minutes: Vec<f64> = numbers(rows().iter(), rate)?.iter().map(|rate| rate.abs() / 60.0).collect();
    Ok(over(&minutes, 1)? + " minutes")
}
