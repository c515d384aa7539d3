//! A subinterval: the nodes of the rule on it, and the solution with one sign of the friction at these nodes.
//!
//! With u = θ'²/E over ψ the equation of motion is du/dψ = p u + f, where with σ = S μ
//! p = 2 (ρ + σ k) k / (i + ρ² + σ k ρ) and f dψ = 2 dθ / (i + ρ² + σ k ρ). Its solution is
//! u = e^Λ (u₀ + J) with the integrating factor e^Λ, Λ = ∫ p, and the particular integral J = ∫ e^(−Λ) f. The first has no
//! closed form that would be worth its price (powers with complex exponents), the second has none.
//!
//! The nodes do not depend on inertia, friction or torque. So half an engagement is bisected once for all escapements of a
//! mechanism, and the subintervals of an engagement that ends at the exit or beyond are among these, unless they are very
//! short.

use super::circle::{Circle, CirclePoint};
use super::exponential::exponentials;
use super::quadrature::{GaussLegendre, NODES, NodalValues, dot, rule};
use geneva_kinematics::Mechanism;
use std::ops::Deref;
use std::sync::LazyLock;

/// The node mapping: how the rule's interval lies on the axis of w.
#[derive(Clone, Copy, Debug)]
pub(super) enum NodeMapping {
    /// Evenly.
    Linear,
    /// As the square of the distance from the upper end, where the motion starts from rest: there √u is linear.
    FromRest,
}

/// Where the nodes of a subinterval are, by rising w.
#[derive(Clone, Debug)]
pub(super) struct Nodes {
    /// Least w, dimensionless.
    pub low: f64,
    /// Greatest w, dimensionless.
    pub high: f64,
    pub mapping: NodeMapping,
    /// ρ at them.
    pub rho: NodalValues,
    /// k at them.
    pub k: NodalValues,
    /// ψ per unit of the rule.
    jacobian: NodalValues,
    /// θ per unit of the rule.
    pub angle: NodalValues,
}

/// The solution with one sign over a subinterval, from its lower end.
#[derive(Clone, Debug)]
pub(super) struct SubintervalSolution {
    /// e^Λ at the nodes.
    pub factor: NodalValues,
    /// J at the nodes.
    pub integral: NodalValues,
    /// e^Λ at the upper end, dimensionless.
    pub factor_end: f64,
    /// J at the upper end, dimensionless.
    pub integral_end: f64,
    /// Λ at the upper end, dimensionless.
    pub exponent: f64,
}

impl Nodes {
    pub(super) fn new(circle: &Circle, rule: &GaussLegendre, low: f64, high: f64, mapping: NodeMapping) -> Self {
        let mut nodes = Self { low, high, mapping, rho: [0.0; _], k: [0.0; _], jacobian: [0.0; _], angle: [0.0; _] };
        let half = (high - low) / 2.0;
        let (mut places, mut rates) = ([0.0; NODES], [half; NODES]);
        match mapping {
            NodeMapping::Linear => places = rule.nodes.map(|s| low + half * (1.0 + s)),
            NodeMapping::FromRest => {
                for ((place, rate), &s) in places.iter_mut().zip(&mut rates).zip(&rule.nodes) {
                    (*place, *rate) = (nodes.w_at(s), half * (1.0 - s));
                }
            }
        }
        for index in 0..NODES {
            let place = circle.place(places[index]);
            nodes.rho[index] = place.rho;
            nodes.k[index] = place.k;
            nodes.jacobian[index] = place.jacobian * rates[index];
            nodes.angle[index] = place.jacobian * rates[index] / place.angular_velocity();
        }
        nodes
    }

    /// w at s between −1 and 1, dimensionless.
    pub(super) fn w_at(&self, s: f64) -> f64 {
        match self.mapping {
            NodeMapping::Linear => self.low + (self.high - self.low) * ((1.0 + s) / 2.0),
            NodeMapping::FromRest => self.high - (self.high - self.low) * ((1.0 - s) / 2.0) * ((1.0 - s) / 2.0),
        }
    }

    /// What each node counts at w.
    pub(super) fn shares(&self, rule: &GaussLegendre, w: f64) -> NodalValues {
        let width = self.high - self.low;
        rule.shares(match self.mapping {
            NodeMapping::Linear => (w - self.low - (self.high - w)) / width,
            NodeMapping::FromRest => 1.0 - 2.0 * ((self.high - w) / width).max(0.0).sqrt(),
        })
    }

    /// dt per unit of the rule, at the nodes, where the unit of time is 1/√E, from u at them.
    pub(super) fn rates(&self, squares: &NodalValues) -> NodalValues {
        let mut rates = self.angle;
        for (rate, square) in rates.iter_mut().zip(squares) {
            *rate /= square.sqrt();
        }
        rates
    }

    /// i + ρ² + σ k ρ at the nodes.
    fn inert(&self, inertia: f64, sigma: f64) -> NodalValues {
        let mut inert = [0.0; _];
        for ((inert, rho), k) in inert.iter_mut().zip(&self.rho).zip(&self.k) {
            *inert = inertia + rho * (rho + sigma * k);
        }
        inert
    }

    /// The solution with the friction σ = S μ.
    pub(super) fn solution(&self, rule: &GaussLegendre, inertia: f64, sigma: f64) -> SubintervalSolution {
        let (mut rate, mut force) = ([0.0; _], self.inert(inertia, sigma));
        for index in 0..rate.len() {
            let (rho, k) = (self.rho[index], self.k[index]);
            let scale = 2.0 / force[index];
            rate[index] = scale * (rho + sigma * k) * k * self.jacobian[index];
            force[index] = scale * self.angle[index];
        }
        let (exponents, exponent) = rule.cumulative(&rate);
        let factor = exponentials(&exponents);
        let [factor_end] = exponentials(&[exponent]);
        for (force, factor) in force.iter_mut().zip(&factor) {
            *force /= factor;
        }
        let (integral, integral_end) = rule.cumulative(&force);
        SubintervalSolution { factor, integral, factor_end, integral_end, exponent }
    }

    /// p with the plus sign less p with the minus sign, per unit of the rule: 4 μ i k²/(A₊ A₋) without cancellation.
    pub(super) fn gap(&self, inertia: f64, friction: f64) -> NodalValues {
        let (plus, minus) = (self.inert(inertia, friction), self.inert(inertia, -friction));
        let mut gap = [0.0; _];
        for (index, gap) in gap.iter_mut().enumerate() {
            let k = self.k[index];
            *gap = (4.0 * friction * inertia) * (k * k) * self.jacobian[index] / (plus[index] * minus[index]);
        }
        gap
    }
}

impl SubintervalSolution {
    /// The square's change over a subinterval: u at the nodes and at the end, from u at the start, dimensionless.
    pub(super) fn motion(&self, mirrored: bool, start: f64) -> (NodalValues, f64) {
        if mirrored {
            (self.squares_of_approach(start), self.approach(start))
        } else {
            (self.squares_up(start), self.up(start))
        }
    }

    /// u at the upper end, from u at the lower, dimensionless.
    pub(super) fn up(&self, square: f64) -> f64 {
        self.factor_end * (square + self.integral_end)
    }

    /// u at the lower end, from u at the upper, dimensionless, for the mirror image: the approach to the line of
    /// centres.
    pub(super) fn approach(&self, square: f64) -> f64 {
        square / self.factor_end + self.integral_end
    }

    /// u at the nodes, from u at the lower end.
    fn squares_up(&self, square: f64) -> NodalValues {
        let mut squares = [0.0; _];
        for ((value, factor), integral) in squares.iter_mut().zip(&self.factor).zip(&self.integral) {
            *value = factor * (square + integral);
        }
        squares
    }

    /// u at the nodes for the mirror image, from u at the upper end.
    fn squares_of_approach(&self, square: f64) -> NodalValues {
        let start = square / self.factor_end;
        let mut squares = [0.0; _];
        for ((value, factor), integral) in squares.iter_mut().zip(&self.factor).zip(&self.integral) {
            *value = factor * (start + (self.integral_end - integral));
        }
        squares
    }

    /// e^Λ and J between the nodes, dimensionless.
    pub(super) fn interpolate(&self, shares: &NodalValues) -> (f64, f64) {
        (dot(shares, &self.factor), dot(shares, &self.integral))
    }
}

/// How often half an engagement is bisected: then there are 31 subintervals.
const LEVELS: u32 = 5;

/// A subinterval of the half engagement from the line of centres to the exit, for all escapements of a mechanism.
#[derive(Debug)]
pub(super) struct SharedSubinterval {
    /// At the lower end, in the middle, at the upper end.
    pub places: [CirclePoint; 3],
    pub nodes: Nodes,
}

/// By mechanism, then the whole first, then its two halves, then their halves.
static BISECTED: LazyLock<[Vec<SharedSubinterval>; 3]> = LazyLock::new(|| {
    Mechanism::ALL.map(|mechanism| {
        let circle = Circle::lookup(mechanism);
        let mut ends = vec![(0.0, circle.exit)];
        for number in 0..(1 << (LEVELS - 1)) - 1 {
            let (low, high) = ends[number];
            let middle = middle(low, high);
            ends.extend([(low, middle), (middle, high)]);
        }
        let shared = |(low, high): (f64, f64)| SharedSubinterval {
            places: [low, middle(low, high), high].map(|w| circle.place(w)),
            nodes: Nodes::new(&circle, rule(), low, high, NodeMapping::Linear),
        };
        ends.into_iter().map(shared).collect()
    })
});

/// Between two w.
pub(super) fn middle(low: f64, high: f64) -> f64 {
    low + (high - low) / 2.0
}

/// The bisection tree of a mechanism. The halves of the subinterval with number k have the numbers 2 k + 1 and 2 k + 2.
pub(super) fn bisection_tree(mechanism: Mechanism) -> &'static [SharedSubinterval] {
    &BISECTED[mechanism.index()]
}

/// Nodes of something else, or its own.
#[derive(Clone, Debug)]
pub(super) enum NodesOf<'a> {
    Shared(&'a Nodes),
    Own(Box<Nodes>),
}

impl Deref for NodesOf<'_> {
    type Target = Nodes;

    fn deref(&self) -> &Nodes {
        match self {
            Self::Shared(nodes) => nodes,
            Self::Own(nodes) => nodes,
        }
    }
}
