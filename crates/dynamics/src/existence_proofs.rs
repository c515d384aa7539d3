//! The algebra behind the map of existence, as identities.
//!
//! Notation as in [`existence`](crate::existence): h = a cos θ − 1, b = a² − 1, g = a sin θ, i = I_D / I_f.
//!
//! ```
//! use geneva_dynamics::existence_proofs::{ConvexityFactors, KappaBelowTwo};
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&KappaBelowTwo).is_ok() && prove(&ConvexityFactors).is_ok());
//! ```

use crate::{Pose, equation};
use geneva_kinematics::{Expression, Field, Identity, Jet, Turn};

/// R² = b − 2 h and (a sin θ)² = a² − (1 + h)², against the pose. Variables: a and the tangent of θ/2.
pub struct HalfEngagement {
    /// Whether it is about R², or about a sin θ.
    pub radius: bool,
}

impl Identity<2> for HalfEngagement {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let pose = Pose::new(&ratio, &Turn::from_half_tangent(&half));
        if self.radius {
            pose.radius_squared + pose.one_minus_k_squared + 2 * pose.numerator
        } else {
            let along = 1 + pose.numerator;
            pose.k_sin_theta * pose.k_sin_theta - (ratio * ratio - along * along)
        }
    }
}

/// (A − D) R⁴ = i R⁴ − h (μ g − h). Variables: R², h, g, i, μ.
pub struct Margin;

impl Identity<5> for Margin {
    fn difference(&self, [square, h, g, inertia, friction]: [Expression; 5]) -> Expression {
        let pose = Pose::from_square(&square, &h, &g);
        let margin = equation::coefficient_a(&pose, &inertia) - equation::coefficient_d(&pose, &friction);
        let worst = h * (friction * g - h);
        margin - inertia + worst / square / square
    }
}

/// (i R⁴ + h²)/h = α/h − β + γ h. Variables: i, b, h.
pub struct CriticalNumerator;

impl Identity<3> for CriticalNumerator {
    fn difference(&self, [i, b, h]: [Expression; 3]) -> Expression {
        let square = b - 2 * h;
        (i * square * square + h * h) / h - numerator(i, b, h)
    }
}

/// The sign that is bisected for the critical friction: the derivative of its square, with m = (1 + h)/g².
///
/// (N²/g²)' = 2 N (N' + N m)/g². Variables: i, h, and a − 1 − h.
pub struct CriticalDerivative;

impl Identity<3> for CriticalDerivative {
    fn difference(&self, [i, h, rest]: [Expression; 3]) -> Expression {
        let ratio = 1 + h + rest;
        let b = ratio * ratio - 1;
        let series = numerator(Jet::constant(i), Jet::constant(b), Jet::<_, 2>::variable(h));
        let along = 1 + h;
        let cross_squared = rest * (ratio + along);
        let cross_series = Jet::from_coefficients([cross_squared, -(2 * along)]);
        let left = (series * series / cross_series).rate();
        // What `critical_friction` evaluates: N' h² = 2 h h − 4 i R² h − (i R⁴ + h²).
        let square = b - 2 * h;
        let whole = i * square * square + h * h;
        let change = h * (2 * h - 4 * i * square) - whole;
        let switching_function = change * cross_squared + whole * h * along;
        left - 2 * series.value() * switching_function / h / h / cross_squared / cross_squared
    }
}

/// N'² − 3 N N'' = (u⁴ − 8 u² + 6 κ u − 5)/u⁴, in units of h and N in which α = γ = 1.
///
/// There N = 1/u − κ + u with u = h/√(α/γ) and κ = β/√(α γ). Variables: u, κ.
pub struct Convexity;

impl Identity<2> for Convexity {
    fn difference(&self, [u, kappa]: [Expression; 2]) -> Expression {
        let x = Jet::<_, 3>::variable(u);
        let n = Jet::integer(1) / x - Jet::constant(kappa) + x;
        let (value, first) = (n.value(), n.rate());
        let second = 2 * n.coefficient(2);
        let u2 = u * u;
        let u4 = u2 * u2;
        let quartic = u4 - 8 * u2 + 6 * kappa * u - 5;
        first * first - 3 * value * second - quartic / u4
    }
}

/// β² = 4 α γ · 4 i/(4 i + 1), so κ² = 16 i/(4 i + 1) < 4. Variables: i, b.
pub struct KappaBelowTwo;

impl Identity<2> for KappaBelowTwo {
    fn difference(&self, [i, b]: [Expression; 2]) -> Expression {
        let (alpha, beta, gamma) = constants(i, b);
        let part = 16 * i / (4 * i + 1);
        beta * beta - part * alpha * gamma
    }
}

/// u⁴ − 8 u² + 12 u − 5 = (u − 1)² (u² + 2 u − 5). Variable: u.
pub struct ConvexityFactors;

impl Identity<1> for ConvexityFactors {
    fn difference(&self, [u]: [Expression; 1]) -> Expression {
        let u2 = u * u;
        let quartic = u2 * u2 - 8 * u2 + 12 * u - 5;
        let rest = u - 1;
        quartic - rest * rest * (u2 + 2 * u - 5)
    }
}

/// The sign that is bisected for the least margin: the rate of W = h (μ g − h)/R⁴ with θ.
///
/// R⁶ dW/dθ = −μ ((g² − h² − h) R² + 4 g² h) + 2 h g (R² + 2 h). Variables: R², h, g, μ.
pub struct MarginDerivative;

impl Identity<4> for MarginDerivative {
    fn difference(&self, [square, h, g, friction]: [Expression; 4]) -> Expression {
        let moving = Pose::from_square(&square, &h, &g).moving_by(&Jet::<_, 2>::variable(Expression::ZERO));
        let reach = Jet::constant(friction) * moving.k_sin_theta - moving.numerator;
        let worst = moving.numerator * reach / moving.radius_squared / moving.radius_squared;
        let g2 = g * g;
        let bracket = (g2 - h * h - h) * square + 4 * g2 * h;
        let geometry = 2 * h * g * (square + 2 * h);
        worst.rate() + (friction * bracket - geometry) / square / square / square
    }
}

/// α, β and γ.
fn constants<S: Field + Copy>(i: S, b: S) -> (S, S, S) {
    let four = S::integer(4) * i;
    (i * b * b, four * b, four + S::one())
}

/// α/h − β + γ h.
fn numerator<S: Field + Copy>(i: S, b: S, h: S) -> S {
    let (alpha, beta, gamma) = constants(i, b);
    alpha / h - beta + gamma * h
}
