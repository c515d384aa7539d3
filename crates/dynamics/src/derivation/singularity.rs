//! Why 1 + a² − 2 a cos θ is never zero: the paragraph after Eq. (1-18).

use geneva_kinematics::{Field, Identity, Turn, pin_slot};

/// The assumed singularity: cos θ = (1 + a²)/(2 a) makes 1 + a² − 2 a cos θ zero. Variable: a.
pub struct SingularAngle;

impl Identity<1> for SingularAngle {
    fn difference<S: Field>(&self, [ratio]: &[S; 1]) -> S {
        let cos = (S::one() + ratio.clone() * ratio.clone()) / (S::integer(2) * ratio.clone());
        pin_slot::slot_radius_squared(ratio, &Turn { cos, sin: S::zero() })
    }
}

/// (1 + a²)/(2 a) ≤ 1, 1 + a² ≤ 2 a, a² − 2 a + 1 ≤ 0 and (a − 1)² ≤ 0 are one statement for a > 0.
///
/// 2 a ((1 + a²)/(2 a) − 1) = (a − 1)². Variable: a.
pub struct BoundAsSquare;

impl Identity<1> for BoundAsSquare {
    fn difference<S: Field>(&self, [ratio]: &[S; 1]) -> S {
        let twice = S::integer(2) * ratio.clone();
        let bound = (S::one() + ratio.clone() * ratio.clone()) / twice.clone() - S::one();
        let rest = ratio.clone() - S::one();
        twice * bound - rest.clone() * rest
    }
}

/// For a = 1 the quantity is zero on the line of centres; (1 − cos θ)² + sin² θ elsewhere. Variable: tangent of θ/2.
pub struct AtOne;

impl Identity<1> for AtOne {
    fn difference<S: Field>(&self, [half]: &[S; 1]) -> S {
        let crank = Turn::from_half_tangent(half);
        let rest = S::one() - crank.cos.clone();
        let sum = rest.clone() * rest + crank.sin.clone() * crank.sin.clone();
        pin_slot::slot_radius_squared(&S::one(), &crank) - sum
    }
}

/// Without an assumption: 1 + a² − 2 a cos θ = (a − 1)² + 2 a (1 − cos θ), at least (a − 1)² > 0 for a > 1.
///
/// Variables: a and cos θ.
pub struct OffTheSingularity;

impl Identity<2> for OffTheSingularity {
    fn difference<S: Field>(&self, [ratio, cos]: &[S; 2]) -> S {
        let rest = ratio.clone() - S::one();
        let sum = rest.clone() * rest + S::integer(2) * ratio.clone() * (S::one() - cos.clone());
        pin_slot::slot_radius_squared(ratio, &Turn { cos: cos.clone(), sin: S::zero() }) - sum
    }
}
