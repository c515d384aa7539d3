//! Greatest values, roots and integrals over an engagement.

use crate::steady::quadrature::rule;
use geneva_kinematics::bisection::bisect;

/// An end of an interval is judged this part of it inside: on the very end some rates vanish.
const INSIDE: f64 = 1e-6;
/// Relative change on doubling the subintervals at which an integral is settled, dimensionless.
const SETTLED: f64 = 1e-13;
/// How often they are doubled at most.
const MOST_DOUBLINGS: u32 = 12;
/// Parts of an interval in each of which an extreme is looked for.
const PARTS: u32 = 32;
/// Steps of the golden section: the interval shrinks to 10⁻¹⁰ of a part.
const GOLDEN_STEPS: u32 = 48;
/// (√5 − 1)/2.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A greatest or least load, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Crank angle in radians from the middle of the engagement.
    pub angle: f64,
    /// The load there, in its own unit.
    pub value: f64,
}

/// The greatest value between two angles in radians, in its own unit, where its `rate` changes from plus to minus or at an
/// end.
pub(super) fn greatest(value: impl Fn(f64) -> f64, rate: impl Fn(f64) -> f64, from: f64, until: f64) -> Peak {
    let bound = |k: u32| bound(from, until, k);
    let of_part = |k: u32| {
        let angle = root(&rate, bound(k), bound(k + 1));
        Peak { angle, value: value(angle) }
    };
    (1..PARTS).map(of_part).fold(of_part(0), greater)
}

/// The greatest value over pieces between these angles in radians, rising, in its own unit: within each piece the value is
/// smooth. By the golden section around the greatest of equal steps.
pub(super) fn greatest_by_section(value: impl Fn(f64) -> f64, pieces: &[f64]) -> Peak {
    let peak = |angle: f64| Peak { angle, value: value(angle) };
    let first = Peak { angle: 0.0, value: f64::NEG_INFINITY };
    pieces.windows(2).fold(first, |best, ends| {
        let [from, until] = [ends[0], ends[1]];
        let at = |k: u32| bound(from, until, k);
        let (middle, top) = (0..=PARTS).map(|k| (k, peak(at(k)))).fold((0, first), |(index, best), (k, next)| {
            if next.value > best.value { (k, next) } else { (index, best) }
        });
        let (mut low, mut high) = (at(middle.saturating_sub(1)), at((middle + 1).min(PARTS)));
        for _ in 0..GOLDEN_STEPS {
            let reach = GOLDEN * (high - low);
            if value(high - reach) > value(low + reach) { high = low + reach } else { low = high - reach }
        }
        greater(greater(best, top), peak(f64::midpoint(low, high)))
    })
}

fn greater(best: Peak, next: Peak) -> Peak {
    if next.value > best.value { next } else { best }
}

/// Both ends exactly, or the last would lie outside of the engagement.
fn bound(from: f64, until: f64, k: u32) -> f64 {
    if k == PARTS { until } else { from + (until - from) / f64::from(PARTS) * f64::from(k) }
}

/// Where `rate` changes from plus to minus between two angles in radians; the first if it does not begin above zero, the
/// last if it does not end below.
pub(super) fn root(rate: impl Fn(f64) -> f64, from: f64, until: f64) -> f64 {
    let inside = INSIDE * (until - from);
    if rate(from + inside) <= 0.0 {
        return from;
    }
    if rate(until - inside) >= 0.0 {
        return until;
    }
    let [low, high] = bisect([from + inside, until - inside], |angle| rate(angle) > 0.0);
    f64::midpoint(low, high)
}

/// The integral over pieces between these angles in radians, in the unit of the values: within each piece the value is smooth.
///
/// By the Gauss-Legendre rule of sixteen nodes on subintervals that are doubled until the result changes by less than a relative
/// 10⁻¹³, or by less than rounding does at values of this size.
pub(super) fn integral(value: impl Fn(f64) -> f64, pieces: &[f64], size: f64) -> f64 {
    pieces.windows(2).map(|ends| piece(&value, ends[0], ends[1], size)).sum()
}

fn piece(value: impl Fn(f64) -> f64, from: f64, until: f64, size: f64) -> f64 {
    let (centre, reach) = (f64::midpoint(from, until), 0.5 * (until - from));
    let with = |parts: u32| {
        let half = reach / f64::from(parts);
        let part = |k: u32| {
            let middle = half * f64::from(2 * k + 1) - reach + centre;
            half * rule().integral(&rule().nodes.map(|node| value(middle + half * node)))
        };
        (0..parts).map(part).sum::<f64>()
    };
    let mut sum = with(2);
    for doubling in 2..=MOST_DOUBLINGS {
        let next = with(1 << doubling);
        let change = (next - sum).abs();
        sum = next;
        if change <= SETTLED * sum.abs().max(f64::EPSILON * reach * size) {
            break;
        }
    }
    sum
}
