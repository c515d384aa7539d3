//! The interval of a share by trying shares: which of them the count found does not contradict.

use super::halve;

/// The ends of the 95 % interval of a share, in per cent: the least and the greatest share from which what was found is no
/// farther than the normal law lets 95 of 100 samples be.
pub(crate) fn score_interval(part: usize, all: usize) -> [f64; 2] {
    let (n, found) = (all as f64, part as f64 / all as f64);
    let quantile = normal_quantile();
    let is_allowed = |share: f64| (found - share).abs() <= quantile * (share * (1.0 - share) / n).sqrt();
    let end = |outside: f64| {
        // The share found is allowed, unless all or none were: then its own spread is zero, and it is its own end.
        100.0 * halve(60, [found, outside], is_allowed)[0]
    };
    [end(0.0), end(1.0)]
}

/// How many spreads from the mean 95 % of the normal law are.
fn normal_quantile() -> f64 {
    let [low, high] = halve(50, [1.0, 3.0], |spreads| within(spreads) < 0.95);
    f64::midpoint(low, high)
}

/// The part of the normal law within so many spreads of its mean, by Simpson's rule.
fn within(spreads: f64) -> f64 {
    const HALVES: u32 = 500;
    let step = spreads / f64::from(2 * HALVES);
    let density = |k: u32| (-(step * f64::from(k)).powi(2) / 2.0).exp() / (2.0 * std::f64::consts::PI).sqrt();
    let inner: f64 = (1..2 * HALVES).map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * density(k)).sum();
    2.0 * step / 3.0 * (density(0) + inner + density(2 * HALVES))
}
