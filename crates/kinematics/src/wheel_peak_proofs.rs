//! From the derivative of the wheel's acceleration to the angle of its peak, as identities.
//!
//! Notation: s = sin α, c = cos θ, γ = (1 + s²)/(2 s), w = √(γ² + 8), which enters only by its square.
//! Work::Jazar2003, example (e), Eqs. (5.33) and (5.34).

use crate::{Expression, Identity, Turn};

/// (1 + s² − 2 s cos θ) cos θ − 4 s sin² θ, the braces of the derivative, are the printed condition
/// (1 + s²) cos θ − 2 s cos² θ − 4 s sin² θ. Variables: s and the tangent of θ/2.
pub struct Condition;

impl Identity<2> for Condition {
    fn difference(&self, [sine, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let c = crank.cos;
        let one_and_square = 1 + sine * sine;
        let sines = 4 * sine * crank.sin * crank.sin;
        let braces = (one_and_square - 2 * sine * c) * c - sines;
        braces - (one_and_square * c - 2 * sine * c * c - sines)
    }
}

/// sin² θ = 1 − cos² θ. Variable: the tangent of θ/2.
pub struct Pythagoras;

impl Identity<1> for Pythagoras {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        crank.sin * crank.sin - (1 - crank.cos * crank.cos)
    }
}

/// The condition with sin² θ replaced is 2 s (c² + γ c − 2). Variables: s and c.
pub struct Quadratic;

impl Identity<2> for Quadratic {
    fn difference(&self, [s, c]: [Expression; 2]) -> Expression {
        let condition = (1 + s * s) * c - 2 * s * c * c - 4 * s * (1 - c * c);
        condition - 2 * s * quadratic(c, gamma(s))
    }
}

/// (−γ ± w)/2 solves c² + γ c − 2 = 0: four times the left side is w² − γ² − 8. Variables: γ and w.
pub struct Roots {
    /// Whether w has the plus sign.
    pub plus: bool,
}

impl Identity<2> for Roots {
    fn difference(&self, [gamma, root]: [Expression; 2]) -> Expression {
        let signed = if self.plus { root } else { -root };
        let cosine = (signed - gamma) / 2;
        let excess = root * root - gamma * gamma - 8;
        4 * quadratic(cosine, gamma) - excess
    }
}

/// At c = 1 the quadratic is γ − 1 = (1 − s)²/(2 s), which is positive: its root lies below one. Variable: s.
pub struct BelowOne;

impl Identity<1> for BelowOne {
    fn difference(&self, [sine]: [Expression; 1]) -> Expression {
        let rest = 1 - sine;
        quadratic(Expression::ONE, gamma(sine)) - rest * rest / (2 * sine)
    }
}

/// At c = sin α, where the pin enters, the quadratic is −3 (1 − s²)/2, which is negative: its root lies inside the
/// engagement. Variable: s.
pub struct InsideTheEngagement;

impl Identity<1> for InsideTheEngagement {
    fn difference(&self, [sine]: [Expression; 1]) -> Expression {
        let square = 1 - sine * sine;
        quadratic(sine, gamma(sine)) + 3 * square / 2
    }
}

/// c² + γ c − 2.
fn quadratic(cosine: Expression, gamma: Expression) -> Expression {
    cosine * cosine + gamma * cosine - 2
}

/// (1 + s²)/(2 s).
fn gamma(sine: Expression) -> Expression {
    (1 + sine * sine) / (2 * sine)
}
