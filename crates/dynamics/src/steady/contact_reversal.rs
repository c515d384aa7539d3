//! The contact reversal past the line of centres: where the pin goes over to the trailing flank, and friction changes its
//! sign.
//!
//! The sign is that of A C u + D (E − B u) = μ k (i ρ' u + ρ E). Before the line of centres k < 0 < ρ', so it is minus
//! all the way. From the line of centres on k > 0 > ρ', and it is plus while u < Q with Q = ρ/(i k (1 + 2 ρ)), u over E.
//! Q falls from +∞ to zero at the exit ([`SwitchingFunctionFalls`](super::proofs::SwitchingFunctionFalls)). Where u = Q the follower turns
//! without force, φ'' = 0, so that ρ θ' is level there and u grows as ρ falls. So there is exactly one switch, and past
//! the exit, where ρ < 0, the sign stays minus.

use super::engagement::Engagement;
use super::quadrature::NodalValues;
use super::subinterval::{NodeMapping, Nodes, SubintervalSolution};

/// A step of Newton's method, over the subinterval, from which on u is taken on nodes of its own.
pub(super) const COARSE: f64 = 1e-4;

/// The least step after which no other is needed.
const FINE: f64 = 1e-6;

/// Most steps, halvings included.
pub(super) const STEPS: u32 = 100;

/// Where the pin goes from the leading to the trailing flank, and the sign of the friction from plus to minus.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContactReversal {
    /// Number of the subinterval.
    pub subinterval: usize,
    /// w, dimensionless.
    pub at: f64,
}

/// A subinterval divided at the contact reversal, but for a step of [`Engagement::fine`].
///
/// At the switch both signs have the same slope, so that what the motion errs by is of the order of the step's square.
#[derive(Clone, Debug)]
pub(super) struct Split {
    pub reversal: ContactReversal,
    /// u where it is divided, dimensionless.
    pub square: f64,
    /// With the plus sign up to there, with the minus sign from there on.
    pub parts: Box<[SplitPart; 2]>,
}

/// A part of a subinterval on nodes of its own, with the sign that it has.
#[derive(Clone, Debug)]
pub(super) struct SplitPart {
    pub nodes: Nodes,
    pub solution: SubintervalSolution,
}

/// What Newton's method ends with.
#[derive(Clone, Copy, Debug)]
pub(super) struct LocatedReversal {
    /// w of the switch, dimensionless.
    pub reversal: f64,
    /// w of the last place that was asked for, dimensionless.
    pub at: f64,
    /// u there, dimensionless.
    pub square: f64,
}

impl Engagement {
    /// A step of Newton's method, over the subinterval, after which no other is needed: what is left is of the order of
    /// its square.
    pub(super) fn fine(&self) -> f64 {
        FINE.max(self.tolerance().sqrt() / 32.0)
    }

    /// p with the plus sign less p with the minus sign, per unit of w.
    pub(super) fn gap_at(&self, w: f64) -> f64 {
        let place = self.circle.place(w);
        let (square, across) = (place.rho * place.rho, self.friction * place.k * place.rho);
        let both = (self.inertia + square + across) * (self.inertia + square - across);
        4.0 * self.friction * self.inertia * (place.k * place.k) * place.jacobian / both
    }

    /// From low to high, with σ = S μ.
    pub(super) fn part(&self, low: f64, high: f64, sigma: f64) -> SplitPart {
        let nodes = self.nodes(low, high, NodeMapping::Linear);
        let solution = self.solution(&nodes, sigma);
        SplitPart { nodes, solution }
    }

    /// The switching function ρ − i k (1 + 2 ρ) u, positive before the contact reversal.
    pub(super) fn switching_function(&self, w: f64, square: f64) -> f64 {
        let place = self.circle.place(w);
        place.rho - self.inertia * place.k * place.angular_velocity() * square
    }

    /// The switch in a subinterval, with u there from what the subinterval's nodes count, and better from w.
    ///
    /// Both must have the slope of the equation of motion at the switch; they need not have it elsewhere. `ends` is the
    /// excess at the subinterval's ends: the search starts where the straight line is zero.
    pub(super) fn reversal_within(
        &self,
        nodes: &Nodes,
        ends: [f64; 2],
        coarse: impl Fn(&NodalValues) -> f64,
        mut fine: impl FnMut(f64) -> f64,
    ) -> LocatedReversal {
        let (mut low, mut high) = (nodes.low, nodes.high);
        let (width, part, enough) = (high - low, ends[0] / (ends[0] - ends[1]), self.fine());
        // Newton's method, kept between the ends: a step that leaves them is replaced by a halving.
        let (mut w, mut refining) = (low + width * if part > 0.0 && part < 1.0 { part } else { 0.5 }, false);
        for _ in 0..STEPS {
            let square = if refining { fine(w) } else { coarse(&nodes.shares(self.rule, w)) };
            let (excess, slope) = self.switching_function_with_slope(w, square);
            let next = w - excess / slope;
            let moved = next - w;
            if refining && libm::fabs(moved) <= enough * width {
                return LocatedReversal { reversal: next.clamp(nodes.low, nodes.high), at: w, square };
            }
            if !refining {
                *(if excess > 0.0 { &mut low } else { &mut high }) = w;
            }
            let inside = next >= low && next <= high;
            refining |= inside && libm::fabs(moved) <= COARSE * width;
            w = if inside || refining { next.clamp(nodes.low, nodes.high) } else { low + (high - low) / 2.0 };
        }
        LocatedReversal { reversal: w, at: w, square: fine(w) }
    }

    /// The excess, and its slope by w at the switch.
    fn switching_function_with_slope(&self, w: f64, square: f64) -> (f64, f64) {
        let place = self.circle.place(w);
        let (rho, k, angular_velocity) = (place.rho, place.k, place.angular_velocity());
        // Where the bars have the plus sign; at the switch either sign gives the same.
        let both = rho + self.friction * k;
        let factor = (2.0 / angular_velocity + 2.0 * both * k * square) / (self.inertia + rho * both);
        let change =
            ((rho - self.circle.centre) * angular_velocity - 2.0 * k * k) * square + k * angular_velocity * factor;
        let excess = rho - self.inertia * k * angular_velocity * square;
        (excess, (-k - self.inertia * change) * place.jacobian)
    }
}
