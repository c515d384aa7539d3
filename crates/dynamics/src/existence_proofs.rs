//! The algebra behind the map of existence, as identities.
//!
//! Notation as in [`existence`](crate::existence): h = a cos θ − 1, b = a² − 1, g = a sin θ, i = I_D / I_f.

use crate::{Pose, equation};
use geneva_kinematics::{Field, Identity, Jet, Turn};

/// R² = b − 2 h and (a sin θ)² = a² − (1 + h)², against the pose. Variables: a and the tangent of θ/2.
pub struct HalfEngagement {
    /// Whether it is about R², or about a sin θ.
    pub radius: bool,
}

impl Identity<2> for HalfEngagement {
    fn difference<S: Field>(&self, [ratio, half]: &[S; 2]) -> S {
        let pose = Pose::new(ratio, &Turn::from_half_tangent(half));
        if self.radius {
            pose.square + pose.shape + S::integer(2) * pose.lead
        } else {
            let along = S::one() + pose.lead;
            pose.cross.clone() * pose.cross - (ratio.clone() * ratio.clone() - along.clone() * along)
        }
    }
}

/// (A − D) R⁴ = i R⁴ − h (μ g − h). Variables: R², h, g, i, μ.
pub struct Margin;

impl Identity<5> for Margin {
    fn difference<S: Field>(&self, [square, h, g, inertia, friction]: &[S; 5]) -> S {
        let pose = Pose::from_square(square, h, g);
        let margin = equation::coefficient_a(&pose, inertia) - equation::coefficient_d(&pose, friction);
        let worst = h.clone() * (friction.clone() * g.clone() - h.clone());
        margin - inertia.clone() + worst / square.clone() / square.clone()
    }
}

/// (i R⁴ + h²)/h = α/h − β + γ h. Variables: i, b, h.
pub struct CriticalNumerator;

impl Identity<3> for CriticalNumerator {
    fn difference<S: Field>(&self, [i, b, h]: &[S; 3]) -> S {
        let square = b.clone() - S::integer(2) * h.clone();
        (i.clone() * square.clone() * square + h.clone() * h.clone()) / h.clone() - numerator(i, b, h)
    }
}

/// The sign that is bisected for the critical friction: the derivative of its square, with m = (1 + h)/g².
///
/// (N²/g²)' = 2 N (N' + N m)/g². Variables: i, h, and a − 1 − h.
pub struct CriticalDerivative;

impl Identity<3> for CriticalDerivative {
    fn difference<S: Field>(&self, [i, h, rest]: &[S; 3]) -> S {
        let ratio = S::one() + h.clone() + rest.clone();
        let b = ratio.clone() * ratio.clone() - S::one();
        let moving = Jet::<S, 2>::variable(h.clone());
        let series = numerator(&Jet::constant(i.clone()), &Jet::constant(b.clone()), &moving);
        let along = S::one() + h.clone();
        let cross_squared = rest.clone() * (ratio + along.clone());
        let cross_series = Jet::from_coefficients([cross_squared.clone(), -(S::integer(2) * along.clone())]);
        let left = (series.clone() * series.clone() / cross_series).rate();
        // What `critical_friction` evaluates: N' h² = 2 h h − 4 i R² h − (i R⁴ + h²).
        let square = b - S::integer(2) * h.clone();
        let whole = i.clone() * square.clone() * square.clone() + h.clone() * h.clone();
        let change = h.clone() * (S::integer(2) * h.clone() - S::integer(4) * i.clone() * square) - whole.clone();
        let decider = change * cross_squared.clone() + whole * h.clone() * along;
        left - S::integer(2) * series.value() * decider / h.clone() / h.clone() / cross_squared.clone() / cross_squared
    }
}

/// N'² − 3 N N'' = (u⁴ − 8 u² + 6 κ u − 5)/u⁴, in units of h and N in which α = γ = 1.
///
/// There N = 1/u − κ + u with u = h/√(α/γ) and κ = β/√(α γ). Variables: u, κ.
pub struct Convexity;

impl Identity<2> for Convexity {
    fn difference<S: Field>(&self, [u, kappa]: &[S; 2]) -> S {
        let x = Jet::<S, 3>::variable(u.clone());
        let n = Jet::integer(1) / x.clone() - Jet::constant(kappa.clone()) + x;
        let (value, first) = (n.value(), n.rate());
        let second = S::integer(2) * n.coefficient(2);
        let u2 = u.clone() * u.clone();
        let u4 = u2.clone() * u2.clone();
        let quartic = u4.clone() - S::integer(8) * u2 + S::integer(6) * kappa.clone() * u.clone() - S::integer(5);
        first.clone() * first - S::integer(3) * value * second - quartic / u4
    }
}

/// β² = 4 α γ · 4 i/(4 i + 1), so κ² = 16 i/(4 i + 1) < 4. Variables: i, b.
pub struct KappaBelowTwo;

impl Identity<2> for KappaBelowTwo {
    fn difference<S: Field>(&self, [i, b]: &[S; 2]) -> S {
        let (alpha, beta, gamma) = constants(i, b);
        let part = S::integer(16) * i.clone() / (S::integer(4) * i.clone() + S::one());
        beta.clone() * beta - part * alpha * gamma
    }
}

/// u⁴ − 8 u² + 12 u − 5 = (u − 1)² (u² + 2 u − 5). Variable: u.
pub struct ConvexityFactors;

impl Identity<1> for ConvexityFactors {
    fn difference<S: Field>(&self, [u]: &[S; 1]) -> S {
        let u2 = u.clone() * u.clone();
        let quartic = u2.clone() * u2.clone() - S::integer(8) * u2.clone() + S::integer(12) * u.clone() - S::integer(5);
        let rest = u.clone() - S::one();
        quartic - rest.clone() * rest * (u2 + S::integer(2) * u.clone() - S::integer(5))
    }
}

/// The sign that is bisected for the least margin: the rate of W = h (μ g − h)/R⁴ with θ.
///
/// R⁶ dW/dθ = −μ ((g² − h² − h) R² + 4 g² h) + 2 h g (R² + 2 h). Variables: R², h, g, μ.
pub struct MarginDerivative;

impl Identity<4> for MarginDerivative {
    fn difference<S: Field>(&self, [square, h, g, friction]: &[S; 4]) -> S {
        let moving = Pose::from_square(square, h, g).moving_by(&Jet::<S, 2>::variable(S::zero()));
        let reach = Jet::constant(friction.clone()) * moving.cross - moving.lead.clone();
        let worst = moving.lead * reach / moving.square.clone() / moving.square;
        let g2 = g.clone() * g.clone();
        let bracket =
            (g2.clone() - h.clone() * h.clone() - h.clone()) * square.clone() + S::integer(4) * g2 * h.clone();
        let geometry = S::integer(2) * h.clone() * g.clone() * (square.clone() + S::integer(2) * h.clone());
        worst.rate() + (friction.clone() * bracket - geometry) / square.clone() / square.clone() / square.clone()
    }
}

fn constants<S: Field>(i: &S, b: &S) -> (S, S, S) {
    let four = S::integer(4) * i.clone();
    (i.clone() * b.clone() * b.clone(), four.clone() * b.clone(), four + S::one())
}

/// α/h − β + γ h.
fn numerator<S: Field>(i: &S, b: &S, h: &S) -> S {
    let (alpha, beta, gamma) = constants(i, b);
    alpha / h.clone() - beta + gamma * h.clone()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proving::holds;

    #[test]
    fn the_algebra_of_existence_is_proven() {
        holds("R² in h", &HalfEngagement { radius: true });
        holds("a sin θ in h", &HalfEngagement { radius: false });
        holds("margin", &Margin);
        holds("critical numerator", &CriticalNumerator);
        holds("critical derivative", &CriticalDerivative);
        holds("convexity", &Convexity);
        holds("κ below two", &KappaBelowTwo);
        holds("factors", &ConvexityFactors);
        holds("margin derivative", &MarginDerivative);
    }
}
