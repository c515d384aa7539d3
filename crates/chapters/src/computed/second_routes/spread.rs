//! The spread of errors with which rounded numbers are most likely, from the density of the errors.

use geneva_case1973::likelihood::Law;
use std::f64::consts::{PI, SQRT_2};

/// The spread, in units of the last place, with which errors of these sizes are most likely.
pub(crate) fn best_spread(law: Law, units: &[f64]) -> f64 {
    let log = |spread: f64| units.iter().map(|off| chance(law, *off, spread).ln()).sum::<f64>();
    // Wide steps of a factor first, then between the neighbours of the best.
    const OCTAVES: std::ops::RangeInclusive<i32> = -8..=8;
    let rough = OCTAVES.max_by(|a, b| log(2_f64.powi(*a)).total_cmp(&log(2_f64.powi(*b)))).unwrap_or(0);
    let (mut low, mut high) = (f64::from(rough - 1), f64::from(rough + 1));
    for _ in 0..22 {
        let [left, right] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
        if log(left.exp2()) < log(right.exp2()) { low = left } else { high = right }
    }
    f64::midpoint(low, high).exp2()
}

/// The chance that an error is rounded to a number so many units away: its density summed by Simpson's rule over the unit.
fn chance(law: Law, off: f64, spread: f64) -> f64 {
    let density = |error: f64| match law {
        Law::Normal => (-(error / spread / SQRT_2).powi(2)).exp() / (spread * (2.0 * PI).sqrt()),
        Law::Exponential => (-error.abs() / spread).exp() / (2.0 * spread),
    };
    let sum = |low: f64, high: f64| {
        let halves = ((high - low) * 6.0 / spread).clamp(2.0, 300.0).ceil() as u32;
        let step = (high - low) / f64::from(2 * halves);
        let inner = (1..2 * halves).map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * density(low + step * f64::from(k)));
        step / 3.0 * (density(low) + inner.sum::<f64>() + density(high))
    };
    let (low, high) = (off - 0.5, off + 0.5);
    // The exponential density has an edge at zero.
    if low < 0.0 { sum(low, 0.0) + sum(0.0, high) } else { sum(low, high) }
}
