//! Why 1 + a² − 2 a cos θ is never zero: the paragraph after Eq. (1-18).

use geneva_kinematics::{Expression, Identity, Turn, pin_slot};

/// The assumed singularity: cos θ = (1 + a²)/(2 a) makes 1 + a² − 2 a cos θ zero. Variable: a.
pub struct SingularAngle;

impl Identity<1> for SingularAngle {
    fn difference(&self, [ratio]: [Expression; 1]) -> Expression {
        let cos = (1 + ratio * ratio) / (2 * ratio);
        pin_slot::slot_radius_squared(&ratio, &Turn { cos, sin: Expression::ZERO })
    }
}

/// (1 + a²)/(2 a) ≤ 1, 1 + a² ≤ 2 a, a² − 2 a + 1 ≤ 0 and (a − 1)² ≤ 0 are one statement for a > 0.
///
/// 2 a ((1 + a²)/(2 a) − 1) = (a − 1)². Variable: a.
pub struct BoundAsSquare;

impl Identity<1> for BoundAsSquare {
    fn difference(&self, [ratio]: [Expression; 1]) -> Expression {
        let twice = 2 * ratio;
        let bound = (1 + ratio * ratio) / twice - 1;
        let rest = ratio - 1;
        twice * bound - rest * rest
    }
}

/// For a = 1 the quantity is zero on the line of centres; (1 − cos θ)² + sin² θ elsewhere. Variable: tangent of θ/2.
pub struct AtOne;

impl Identity<1> for AtOne {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let rest = 1 - crank.cos;
        let sum = rest * rest + crank.sin * crank.sin;
        pin_slot::slot_radius_squared(&Expression::ONE, &crank) - sum
    }
}

/// Without an assumption: 1 + a² − 2 a cos θ = (a − 1)² + 2 a (1 − cos θ), at least (a − 1)² > 0 for a > 1.
///
/// Variables: a and cos θ.
pub struct OffTheSingularity;

impl Identity<2> for OffTheSingularity {
    fn difference(&self, [ratio, cos]: [Expression; 2]) -> Expression {
        let rest = ratio - 1;
        let sum = rest * rest + 2 * ratio * (1 - cos);
        pin_slot::slot_radius_squared(&ratio, &Turn { cos, sin: Expression::ZERO }) - sum
    }
}
