//! Of the chapter on the escapement: what came of it, in a few numbers, over all rows of the thesis as the mechanisms are.

use super::Number;
use crate::rows::{engagement, parameters};
use anyhow::Context;
use geneva_dynamics::timer::Sensitivities;
use geneva_ledger::meyer::runs::{Hypothesis, rows};

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("escapement.engagements", engagements),
    ("escapement.hand-overs", hand_overs),
    ("escapement.friction-a-day", || Ok(format!("{} minutes", a_day(|powers| powers.friction)?))),
    ("escapement.torque-a-day", || Ok(format!("{} minutes", a_day(|powers| powers.torque)?))),
];

/// From the least to the greatest of some numbers, with so many decimals.
pub(super) fn over(values: impl Iterator<Item = anyhow::Result<f64>>, decimals: usize) -> anyhow::Result<String> {
    let values = values.collect::<Result<Vec<_>, _>>()?;
    let [least, greatest] =
        [f64::min, f64::max].map(|pick| values.iter().copied().reduce(pick).map(|end| format!("{end:.decimals$}")));
    let (least, greatest) = least.zip(greatest).context("there are no rows")?;
    Ok(if least == greatest { least } else { format!("{least} to {greatest}") })
}

/// How near to the steady speed counts as steady.
const SETTLED: f64 = 0.01;

/// Engagements from rest until the next pin enters within one per cent of the steady speed, over all rows.
fn engagements() -> anyhow::Result<String> {
    let counts = rows().iter().map(|row| {
        let (count, _) = engagement(row, &Hypothesis::IDEAL)?.engagements_to_settle(SETTLED)?;
        Ok(count as f64)
    });
    over(counts, 0)
}

/// Hand-overs a second in the steady state, over all rows.
fn hand_overs() -> anyhow::Result<String> {
    over(rows().iter().map(|row| Ok(1.0 / engagement(row, &Hypothesis::IDEAL)?.steady_state()?.period)), 0)
}

/// Minutes a day that one per cent of a quantity makes, by its power in the mean speed, over all rows.
fn a_day(power: fn(&Sensitivities) -> f64) -> anyhow::Result<String> {
    const MINUTES: f64 = 24.0 * 60.0;
    over(rows().iter().map(|row| Ok(0.01 * MINUTES * power(&Sensitivities::new(&parameters(row)?)?).abs())), 1)
}
