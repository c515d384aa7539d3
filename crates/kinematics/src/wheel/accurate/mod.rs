//! The motion of a wheel in `f64`, right to about one unit in the last place.
//!
//! The formulas that proofs run on ([`velocity_ratio`](crate::pin_slot::velocity_ratio) and its sisters) lose digits
//! in `f64`: near entry in cos θ − sin α, for few stations in 1 + k² − 2 k cos θ, and everywhere in an α that is
//! itself rounded. Here are the same functions in other words, with what depends on the number of stations worked
//! out beforehand to 100 bits. No step calls the platform's mathematics or asks for a fused multiply-add.
//!
//! **Velocity**, the one that must be fast. With ε = (π/2 − α) − |θ|, the crank angle from the nearer end of the
//! engagement, and a = tan α,
//!
//! velocity = y / (cot α − 2 y), y = sin ε − a vers ε.
//!
//! Nothing cancels as ε goes to zero. With ε = x + r, x the angle of a [`TableNode`] of half-angle tangent t, and both
//! sides times 1 + t²,
//!
//! (1 + t²) y = 2t − 2 a t² + (1 − t² − 2 a t) sin r − (2t + (1 − t²) a) vers r.
//!
//! 2t and the first 26 binary places of 2a times t² subtract without rounding, and the rounding of adding r is kept.
//! The terms in sin r and vers r are below 2⁻⁸·⁸ for all N; their roundings together stay below 2⁻⁵⁸·⁷. The division
//! makes the most of that where its two sides are smallest, for three stations on the line of centres: 0.8 units in
//! the last place if every rounding pulled the same way, 0.2 for four stations. The rounding of the quotient adds half
//! a unit (one, where the correction after it leads below a power of two), the correction 0.3 at most, the last sum
//! half a unit. On the grid of the example `accuracy` the worst is 1.5 units.
//!
//! **The others** are not hurried and are evaluated in [`Double`], with sines to 2⁻⁶⁴: with s = sin |θ|,
//! v = vers θ, m = sin α and D = (1 − m)² + 2 m v, in which nothing cancels,
//!
//! - acceleration = −m cos² α s / D²,
//! - jerk = −2 m² cos² α (cos θ − cos θₚ)(cos θ + 2 / cos θₚ) / D³: its bracket by the two roots, with θₚ the angle of
//!   the greatest deceleration, and the first difference as 2 sin((θₚ + θ)/2) sin((θₚ − θ)/2),
//! - angle = atan2(m s, 1 − m + m v), by one Newton step from the `f64` value.
//!
//! Their error before the one rounding to `f64` is below 2⁻⁵⁷: half a unit in the last place, and next to nothing
//! more.

mod double;
mod table;

use double::ordered_sum;
pub(super) use double::{Double, fraction_of_pi};
use table::{TableNode, series, sine_versine};

/// What the motion of a wheel needs of its number of stations, α = π/N.
#[derive(Clone, Copy, Debug)]
pub(super) struct WheelConstants {
    /// π/2 − α, the crank angle of entry and exit.
    pub entry: Double,
    /// α.
    pub half_pitch_angle: Double,
    /// sin α.
    pub sine: Double,
    /// cos α.
    pub cosine: Double,
    /// 1 − sin α.
    pub rest: Double,
    /// γ = (1 + sin² α) / (2 sin α).
    pub gamma: Double,
    /// Crank angle θₚ at which the deceleration is greatest.
    pub peak: Double,
    /// cos θₚ.
    peak_cosine: Double,
    /// tan α.
    tangent: f64,
    // 2 tan α and cot α / 2, each as a head and a tail that do not lie side by side: where they do, the compiler loads
    // them as a pair, and its packing and unpacking costs the velocity a tenth of its speed.
    twice_tangent_head: f64,
    half_cotangent_tail: f64,
    twice_tangent_tail: f64,
    half_cotangent_head: f64,
}

/// Binary places of the head of 2 tan α: with the 26 of t² they fill an `f64` below 2.
const TWO_TO_26: f64 = 67_108_864.0;
/// Binary places of the head of cot α / 2, which is below 2⁸: with the 27 bits of 1 + t² they fill an `f64`.
const TWO_TO_18: f64 = 262_144.0;

impl WheelConstants {
    /// For so many stations, at least 3.
    pub(super) fn new(stations: u32) -> Self {
        let (entry, half_pitch_angle) = (fraction_of_pi(stations - 2, 2 * stations), fraction_of_pi(1, stations));
        let (sine, versine) = series(half_pitch_angle);
        // The cosine of entry is the sine of α: its versed sine is 1 − sin α with every digit.
        let (cosine, rest) = (Double::ONE.minus(versine), series(entry).1);
        let tangent = sine.over(cosine);
        let gamma = Double::ONE.plus(sine.times(sine)).over(sine.twice());
        // The roots of c² + γ c − 2, one of each sign; the positive one from their product.
        let root = gamma.times(gamma).plus(Double::from(8.0)).root();
        let peak_cosine = Double::from(4.0).over(gamma.plus(root));
        let near = Double::from(libm::acos(peak_cosine.hi));
        let (near_sine, near_versine) = series(near);
        let peak = near.plus(Double::ONE.minus(near_versine).minus(peak_cosine).over(near_sine));
        let (twice_tangent_head, twice_tangent_tail) = tangent.twice().split(TWO_TO_26);
        let (half_cotangent_head, half_cotangent_tail) = cosine.over(sine.twice()).split(TWO_TO_18);
        Self {
            entry,
            half_pitch_angle,
            sine,
            cosine,
            rest,
            gamma,
            peak,
            peak_cosine,
            tangent: tangent.hi,
            twice_tangent_head,
            half_cotangent_tail,
            twice_tangent_tail,
            half_cotangent_head,
        }
    }

    /// Velocity ratio at a crank angle from 0 to the entry's `f64`.
    #[inline]
    pub(super) fn velocity(&self, crank: Double) -> f64 {
        let ahead = self.entry.hi - crank.hi;
        let ahead_low = ((self.entry.hi - ahead) - crank.hi) + (self.entry.lo - crank.lo);
        let (node, Double { hi: rest, lo: low }) = TableNode::nearest(Double { hi: ahead, lo: ahead_low });
        let (twice, square) = (node.twice_tangent, node.square);
        let scale = 1.0 + square;
        let second = rest * rest;
        let more = low - rest * second * (1.0 / 6.0 - second * (1.0 / 120.0));
        let versine = second * (0.5 - second * (1.0 / 24.0));

        let at_node = twice - square * self.twice_tangent_head;
        let first = ordered_sum(at_node, rest);
        let low = first.lo + more
            - square * self.twice_tangent_tail
            - (square + twice * self.tangent) * (rest + more)
            - (twice + (1.0 - square) * self.tangent) * versine;

        let below = ordered_sum(self.half_cotangent_head * scale, -first.hi);
        let below_low = below.lo + (self.half_cotangent_tail * scale - low);
        let quotient = first.hi / below.hi;
        0.5 * (quotient + (low - quotient * below_low) / (below.hi + below_low))
    }

    /// Wheel angle, size of the (negative) acceleration ratio, and jerk ratio, at a crank angle from 0 to the entry's.
    pub(super) fn angle_acceleration_jerk(&self, crank: Double) -> (f64, f64, f64) {
        let (m, cosine) = (self.sine, self.cosine);
        let (sine, versine) = sine_versine(crank);
        let square = self.rest.times(self.rest).plus(m.times(versine).twice());
        let shape = m.times(cosine.times(cosine));
        let acceleration = shape.times(sine).over(square.times(square));

        let (sum, difference) = (self.peak.plus(crank).half(), self.peak.minus(crank).half());
        let above = sine_versine(sum).0.times(sine_versine(difference).0).twice();
        let bracket = above.times(Double::ONE.minus(versine).plus(Double::from(2.0).over(self.peak_cosine)));
        let cube = square.times(square).times(square);
        let jerk = shape.times(m).times(bracket).twice().over(cube);

        let (x, y) = (self.rest.plus(m.times(versine)), m.times(sine));
        let near = Double::from(libm::atan2(y.hi, x.hi));
        let (near_sine, near_versine) = sine_versine(near);
        let past = y.minus(y.times(near_versine).plus(x.times(near_sine)));
        let along = x.minus(x.times(near_versine)).plus(y.times(near_sine));
        (near.plus(past.over(along)).hi, acceleration.hi, -jerk.hi)
    }
}
