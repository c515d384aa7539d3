//! How likely the tables are, by the densities of the errors: the second route to `likelihood` and `weighing`.
//!
//! The chance of a printed number is its density summed over the unit that is rounded to it, and the best spread is sought
//! by steps that become smaller.

use crate::likelihood::Law;
use crate::weighing::{Others, Weighing};
use crate::{Column, Hypothesis, Score};
use geneva_kinematics::Mechanism;
use std::f64::consts::PI;

/// The errors that have one spread: those of a column, in one table or in all.
type Errors = ((Column, Option<Mechanism>), Vec<f64>);

/// The logarithm of the likelihood of the tables under a hypothesis, each spread as it suits the hypothesis best;
/// dimensionless. None if a run came to no end.
pub fn log_likelihood(weighing: &Weighing, score: &Score, law: Law) -> Option<f64> {
    let mut errors: Vec<Errors> = Vec::new();
    let (mut at, mut before) = (0, None);
    for (place, (row, results)) in score.rows.iter().zip(&score.results).enumerate() {
        let group = (row.mechanism, row.printed(Column::Friction));
        at = if before == Some(group) { at + 1 } else { 0 };
        before = Some(group);
        let is_last =
            score.rows.get(place + 1).is_none_or(|next| (next.mechanism, next.printed(Column::Friction)) != group);
        let counts = |only: usize| at == only || (is_last && at < only);
        if !weighing.only.is_none_or(counts) {
            continue;
        }
        for (column, computed) in [Column::Peak, Column::Minimum, Column::Period].into_iter().zip((*results)?) {
            let off = row.misfit(column, computed).abs();
            let own = (column, weighing.by_table.then_some(row.mechanism));
            match errors.iter_mut().find(|(of, _)| *of == own) {
                Some((_, errors)) => errors.push(off),
                None => errors.push((own, vec![off])),
            }
        }
    }
    Some(errors.iter().map(|(_, units)| greatest(law, units, weighing.least_spread)).sum())
}

/// By how much the logarithm for [`Hypothesis::WITHOUT_LAG`] is above that of each of the others among the compared ones, by
/// the law for which it is least; dimensionless. None if a hypothesis is missing or a run came to no end.
pub fn least_margin(weighing: &Weighing, compared: &[Score], others: Others) -> Option<f64> {
    let mut least = f64::INFINITY;
    for law in Law::ALL {
        let (mut own, mut best) = (None, f64::NEG_INFINITY);
        for score in compared {
            if score.hypothesis == Hypothesis::WITHOUT_LAG {
                own = log_likelihood(weighing, score, law);
            } else if others.include(&score.hypothesis) {
                best = best.max(log_likelihood(weighing, score, law)?);
            }
        }
        least = least.min(own? - best);
    }
    Some(least)
}

/// The chance that an error with this spread is rounded to a number so many units away: its density summed by Simpson's
/// rule, from the lower end of the unit to the upper one.
fn chance(law: Law, off: f64, spread: f64) -> f64 {
    let density = |error: f64| match law {
        Law::Normal => libm::exp(-error * error / (2.0 * spread * spread)) / (spread * (2.0 * PI).sqrt()),
        Law::Exponential => libm::exp(-error.abs() / spread) / (2.0 * spread),
    };
    let simpson = |low: f64, high: f64| {
        let halves = (8.0 / spread).clamp(4.0, 600.0).ceil();
        let step = (high - low) / (2.0 * halves);
        let inner = (1..2 * halves as u32).map(|k| {
            let weight = if k % 2 == 1 { 4.0 } else { 2.0 };
            weight * density(low + step * f64::from(k))
        });
        step / 3.0 * (density(low) + inner.sum::<f64>() + density(high))
    };
    let (low, high) = (off - 0.5, off + 0.5);
    // The exponential density has an edge at zero.
    if low < 0.0 { simpson(low, 0.0) + simpson(0.0, high) } else { simpson(low, high) }
}

/// The greatest logarithm of the likelihood of some errors over all spreads, sought by ever smaller steps up and down.
fn greatest(law: Law, units: &[f64], least: f64) -> f64 {
    let at = |spread: f64| units.iter().map(|off| libm::log(chance(law, *off, spread))).sum::<f64>();
    let first: f64 = units.iter().sum::<f64>() / units.len() as f64 + 0.1;
    let (mut spread, mut factor) = (first.max(least), 2.0);
    let mut best = at(spread);
    while factor > 1.01 {
        let next = [spread * factor, (spread / factor).max(least)].map(|spread| (at(spread), spread));
        match next.into_iter().find(|(log, _)| *log > best) {
            Some((log, better)) => (best, spread) = (log, better),
            None => factor = factor.sqrt(),
        }
    }
    best
}
