//! Where the quadratic for the peak of a wheel's acceleration has its root, as identities.
//!
//! Notation: s = sin α, c = cos θ, γ = (1 + s²)/(2 s). JAZAR, example (e), Eqs. (5.33) and (5.34).
//!
//! ```
//! use geneva_kinematics::prove;
//! use geneva_kinematics::wheel_peak_proofs::{BelowOne, InsideTheEngagement};
//!
//! assert!(prove(&BelowOne).is_ok() && prove(&InsideTheEngagement).is_ok());
//! ```

use crate::{Expression, Identity};

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
