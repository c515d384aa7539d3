//! What the equation of motion divides by is never zero, and what it comes to where it starts.
//!
//! Meyer 1973, the paragraph after Eq. (1-18), and Appendix D.
//!
//! ```
//! use geneva_dynamics::singularity::OffTheSingularity;
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&OffTheSingularity).is_ok()); // R² is at least (a − 1)², for every a and θ
//! ```

use crate::{Pose, equation};
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

/// At entry, where a cos θ = 1, D = 0 and A = I_D/I_f: the driver starts with θ'' = K/I_D whatever the friction.
///
/// Multiplied out. Variables: a sin θ, I_D, I_f, μ, K.
pub struct StartAtEntry;

impl Identity<5> for StartAtEntry {
    fn difference(&self, [cross, driver, follower, friction, torque]: [Expression; 5]) -> Expression {
        // R² = h² + g² with h = 0.
        let pose = Pose::from_square(&(cross * cross), &Expression::ZERO, &cross);
        let inertia = driver / follower;
        let a = equation::coefficient_a(&pose, &inertia);
        let d = equation::coefficient_d(&pose, &friction);
        torque / follower / (a + d) - torque / driver
    }
}
