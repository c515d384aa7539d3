//! The motion of the spherical wheel and where it is greatest, as identities.
//!
//! Notation as in [`spherical_wheel`](crate::spherical_wheel): τ = tan α, s = sin θ, w = τ² s². The left sides come from
//! power series of the pin's place seen along the wheel's axis, the right sides are the formulas.
//!
//! ```
//! use geneva_kinematics::prove;
//! use geneva_kinematics::spherical_wheel_proofs::{SphericalEntryAcceleration, SphericalJerkBound};
//!
//! assert!(prove(&SphericalEntryAcceleration).is_ok()); // sin α cos α
//! assert!(prove(&SphericalJerkBound).is_ok()); // the jerk is greatest in the middle
//! ```

use crate::spherical_wheel::{acceleration_ratio, jerk_ratio, velocity_ratio};
use crate::wheel_proofs::WheelQuantity;
use crate::{Expression, Identity, Jet, Turn};
use nalgebra::Vector2;

/// The direction in which the pin is seen along the wheel's axis, (cos α, sin α sin θ), as a series, for a driver of speed
/// one.
fn seen(alpha: &Turn<Expression>, crank: &Turn<Expression>) -> Vector2<Jet<Expression, 4>> {
    let moving = crank.moving::<4>(Expression::ONE);
    Vector2::new(Jet::constant(alpha.cos), Jet::constant(alpha.sin) * moving.sin)
}

/// A formula of [`spherical_wheel`](crate::spherical_wheel) against the power series of the pin's place.
///
/// Variables: tangents of α/2 and θ/2.
pub struct SphericalWheelFormula(
    /// The quantity.
    pub WheelQuantity,
);

impl Identity<2> for SphericalWheelFormula {
    fn difference(&self, [half_alpha, half_theta]: [Expression; 2]) -> Expression {
        let (alpha, crank) = (Turn::from_half_tangent(&half_alpha), Turn::from_half_tangent(&half_theta));
        let tangent = alpha.sin / alpha.cos;
        let formula = match self.0 {
            WheelQuantity::Tangent => tangent * crank.sin,
            WheelQuantity::Velocity => velocity_ratio(&tangent, &crank),
            WheelQuantity::Acceleration => acceleration_ratio(&tangent, &crank),
            WheelQuantity::Jerk => jerk_ratio(&tangent, &crank),
        };
        self.0.path_value(&seen(&alpha, &crank)) - formula
    }
}

/// At entry, s = −1, the acceleration ratio is sin α cos α. Variable: the tangent of α/2.
pub struct SphericalEntryAcceleration;

impl Identity<1> for SphericalEntryAcceleration {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let alpha = Turn::from_half_tangent(&half);
        let entry = Turn { cos: Expression::ZERO, sin: -Expression::ONE };
        acceleration_ratio(&(alpha.sin / alpha.cos), &entry) - alpha.sin * alpha.cos
    }
}

/// The braces of the jerk, 1 + 2 τ² − 6 (1 + τ²) w + w², at entry, w = τ²: (1 − 5 τ²)(1 + τ²).
///
/// With τ² above 1/5 they change their sign inside the engagement, and the acceleration is greatest there; with less they
/// do not, and it is greatest as the pin enters. Variable: τ.
pub struct BracesAtEntry;

impl Identity<1> for BracesAtEntry {
    fn difference(&self, [tangent]: [Expression; 1]) -> Expression {
        let square = tangent * tangent;
        braces(square, square) - (1 - 5 * square) * (1 + square)
    }
}

/// 3 (1 + τ²) − r is a root of the braces: their value there is r² − 9 (1 + τ²)² + 1 + 2 τ². Variables: τ and r.
pub struct BracesRoot;

impl Identity<2> for BracesRoot {
    fn difference(&self, [tangent, root]: [Expression; 2]) -> Expression {
        let square = tangent * tangent;
        let sum = 3 * (1 + square);
        braces(square, sum - root) - (root * root - sum * sum + 1 + 2 * square)
    }
}

/// The jerk never exceeds that in the middle, τ (1 + 2 τ²): its braces rise to 1 + 2 τ² at w = 0 and below them
/// (1 + 2 τ²)(1 + w)³ + braces = ((4 w − 3)² + 7)/8 + 2 w² + w³ + 2 τ² (2 + 3 w² + w³), a sum without a negative term.
///
/// Variables: τ and w.
pub struct SphericalJerkBound;

impl Identity<2> for SphericalJerkBound {
    fn difference(&self, [tangent, w]: [Expression; 2]) -> Expression {
        let square = tangent * tangent;
        let cube = w * w * w;
        let below = (1 + 2 * square) * (1 + w) * (1 + w) * (1 + w) + braces(square, w);
        let first = ((4 * w - 3).squared() + 7) / 8 + 2 * w * w + cube;
        below - first - 2 * square * (2 + 3 * w * w + cube)
    }
}

/// 1 + 2 τ² − 6 (1 + τ²) w + w².
fn braces(square: Expression, w: Expression) -> Expression {
    1 + 2 * square - 6 * (1 + square) * w + w * w
}
