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
