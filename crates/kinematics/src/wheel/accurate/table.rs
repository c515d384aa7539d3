//! Sines and versed sines, from a table of nodes about 1/256 apart and short series between them.
//!
//! The versed sine 1 − cos stands for the cosine: it keeps its digits where the angle is small. The nodes are not
//! evenly spaced: the tangent t of half a node's angle is an integer multiple of 2⁻¹³, so that 1 + t² times its sine 2t,
//! its cosine 1 − t² and its versed sine 2t² are exact in `f64`, and a formula that can do without the factor needs
//! no table of sines.

use super::double::{Double, ordered_sum};

/// An angle whose half has a short tangent.
#[derive(Clone, Copy)]
pub(super) struct TableNode {
    /// The angle in radians, to 2⁻⁸⁶.
    pub angle: Double,
    /// 2t, twice the tangent of its half, dimensionless.
    pub twice_tangent: f64,
    /// t², dimensionless.
    pub square: f64,
}

const NODES_PER_RADIAN: f64 = 256.0;
/// Enough for a quarter turn, and a power of two, so that no index needs a check.
const NODES: usize = 512;
const TANGENTS_PER_ONE: f64 = 8192.0;
/// 3 · 2⁵¹: adding it rounds to an integer, which then stands in the low bits of the sum.
const WHOLE: f64 = 6_755_399_441_055_744.0;

static TABLE: [TableNode; NODES] = {
    let mut nodes = [TableNode { angle: Double::from(0.0), twice_tangent: 0.0, square: 0.0 }; NODES];
    let mut k = 1;
    while k < NODES {
        nodes[k] = TableNode::near(k as f64 / NODES_PER_RADIAN);
        k += 1;
    }
    nodes
};

impl TableNode {
    /// The node nearest to an angle.
    const fn near(angle: f64) -> Self {
        let (sine, versine) = series(Double::from(angle));
        let tangent = (versine.over(sine).hi * TANGENTS_PER_ONE + WHOLE - WHOLE) / TANGENTS_PER_ONE;
        let (twice, square) = (2.0 * tangent, tangent * tangent);
        // The sine of how far the node is ahead of the angle, below 2⁻¹³, and the angle of that sine.
        let across = Double::from(twice).minus(versine.times(Double::from(twice)));
        let ahead = across.minus(sine.times(Double::from(1.0 - square))).over(Double::from(1.0 + square));
        let second = ahead.hi * ahead.hi;
        let more = ahead.hi * second * (1.0 / 6.0 + second * (3.0 / 40.0 + second * (5.0 / 112.0)));
        let angle = Double::from(angle).plus(ahead).plus(Double::from(more));
        Self { angle, twice_tangent: twice, square }
    }

    /// The node nearest to an angle between −2⁻¹⁰ and a quarter turn, and the angle less the node's, at most 2⁻⁸·⁹.
    ///
    /// The second part of the angle may be as great as the first, as it is at the very ends of an engagement.
    #[inline]
    pub(super) fn nearest(angle: Double) -> (&'static Self, Double) {
        let whole = angle.hi * NODES_PER_RADIAN + WHOLE;
        let node = &TABLE[whole.to_bits() as usize % NODES];
        (node, ordered_sum(angle.hi - node.angle.hi, angle.lo - node.angle.lo))
    }
}

/// Sine and versed sine of an angle between 0 and 2, by their power series, to about 100 bits.
pub(super) const fn series(angle: Double) -> (Double, Double) {
    let square = angle.times(angle).negate();
    let (mut sine, mut versine) = (Double::from(0.0), Double::from(0.0));
    let (mut odd, mut even) = (angle, square.half().negate());
    let mut order = 1.0;
    while odd.hi > 1e-34 || odd.hi < -1e-34 {
        (sine, versine) = (sine.plus(odd), versine.plus(even));
        odd = odd.times(square).over(Double::from((order + 1.0) * (order + 2.0)));
        even = even.times(square).over(Double::from((order + 2.0) * (order + 3.0)));
        order += 2.0;
    }
    (sine, versine)
}

/// Sine and versed sine of an angle of at most a quarter turn: the sine to 2⁻⁶⁴ of itself, the versed sine to 2⁻⁶² of
/// the sine.
///
/// With r the angle less the node's, the series leave out r⁹/9! and r⁸/8!, below 2⁻⁸⁶; what counts is the rounding of
/// r³/6 and of r²/2.
pub(super) fn sine_versine(angle: Double) -> (Double, Double) {
    if angle.hi < 0.0 {
        let (sine, versine) = sine_versine(angle.negate());
        return (sine.negate(), versine);
    }
    let (node, Double { hi: rest, lo: low }) = TableNode::nearest(angle);
    let square = rest * rest;
    let more = low - rest * square * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0)));
    let sine = Double::from(rest).plus(Double::from(more));
    let versine = rest * low + square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0)));
    let versine = Double::from(versine);
    // The node's sine, cosine and versed sine, all times 1 + t².
    let (node_sine, square) = (Double::from(node.twice_tangent), Double::from(node.square));
    let (node_cosine, scale) = (Double::ONE.minus(square), Double::ONE.plus(square));
    let sum_sine = node_sine.plus(node_cosine.times(sine)).minus(node_sine.times(versine));
    let sum_versine = square.twice().plus(node_sine.times(sine)).plus(node_cosine.times(versine));
    (sum_sine.over(scale), sum_versine.over(scale))
}
