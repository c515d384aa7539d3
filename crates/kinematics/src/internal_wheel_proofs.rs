//! The motion of the internal wheel and where it is greatest, as identities.
//!
//! Notation as in [`internal_wheel`](crate::internal_wheel): m = sin α, c = cos θ, D = 1 + m² + 2 m c,
//! γ = (1 + m²) / (2 m). The left sides come from power series of the pin's place, the right sides are the formulas.
//!
//! ```
//! use geneva_kinematics::internal_wheel_proofs::{BracesArePositive, JerkRate};
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&BracesArePositive).is_ok()); // the acceleration falls over the whole engagement
//! assert!(prove(&JerkRate).is_ok()); // where the jerk is greatest
//! ```

use crate::internal_wheel::{acceleration_ratio, jerk_ratio, velocity_ratio};
use crate::wheel_proofs::{WheelQuantity, direction_rate};
use crate::{Expression, Identity, Jet, Turn, pin_vectors};
use nalgebra::Vector2;

/// The pin's place from the wheel's axis as a series, for a driver of speed one.
fn path(m: Expression, crank: &Turn<Expression>) -> Vector2<Jet<Expression, 5>> {
    pin_vectors::path(&Expression::ONE, &(1 / m), &crank.moving::<5>(Expression::ONE))
}

/// A formula of [`internal_wheel`](crate::internal_wheel) against the power series of the pin's place.
///
/// Variables: m and the tangent of θ/2.
pub struct InternalWheelFormula(
    /// The quantity.
    pub WheelQuantity,
);

impl Identity<2> for InternalWheelFormula {
    fn difference(&self, [m, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let formula = match self.0 {
            WheelQuantity::Tangent => m * crank.sin / (1 + m * crank.cos),
            WheelQuantity::Velocity => velocity_ratio(&m, &crank),
            WheelQuantity::Acceleration => acceleration_ratio(&m, &crank),
            WheelQuantity::Jerk => jerk_ratio(&m, &crank),
        };
        self.0.path_value(&path(m, &crank)) - formula
    }
}

/// c D + 4 m (1 − c²), the braces of the jerk: (3 m (1 − m²)(1 − c) + (1 + m)² (c + m)) / (1 + m) + 2 m (1 − c)(c + m).
///
/// For c from −m, where the pin enters, to 1 no term is negative, and not all are zero. So the acceleration falls over
/// the whole engagement and is greatest as the pin enters. Variables: m and c.
pub struct BracesArePositive;

impl Identity<2> for BracesArePositive {
    fn difference(&self, [m, c]: [Expression; 2]) -> Expression {
        let square = 1 + m * m + 2 * m * c;
        let braces = c * square + 4 * m * (1 - c * c);
        let (to_middle, from_entry) = (1 - c, c + m);
        let between = (3 * m * (1 - m * m) * to_middle + (1 + m).squared() * from_entry) / (1 + m);
        braces - between - 2 * m * to_middle * from_entry
    }
}

/// At entry, sin θ = −cos α and cos θ = −sin α, the acceleration ratio is tan α. Variable: the tangent of α/2.
pub struct InternalEntryAcceleration;

impl Identity<1> for InternalEntryAcceleration {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let alpha = Turn::from_half_tangent(&half);
        let entry = Turn { cos: -alpha.sin, sin: -alpha.cos };
        acceleration_ratio(&alpha.sin, &entry) - alpha.sin / alpha.cos
    }
}

/// The jerk's own rate is 4 m³ (1 − m²) sin θ (c² − 4 γ c + γ² − 6) / D⁴: the jerk is greatest where the quadratic changes
/// its sign, or at an end. Variables: m and the tangent of θ/2.
pub struct JerkRate;

impl Identity<2> for JerkRate {
    fn difference(&self, [m, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let (c, square) = (crank.cos, 1 + m * m + 2 * m * crank.cos);
        let gamma = (1 + m * m) / (2 * m);
        let quadratic = c * c - 4 * gamma * c + gamma * gamma - 6;
        let rate = 4 * m * m * m * (1 - m * m) * crank.sin * quadratic / square.squared().squared();
        direction_rate(&path(m, &crank)).coefficient(3) * 6 - rate
    }
}

/// (2 γ − w)² − 4 γ (2 γ − w) + γ² − 6 is w² − 3 γ² − 6: the quadratic has the root 2 γ − √(3 γ² + 6). Variables: γ and w.
pub struct JerkRoot;

impl Identity<2> for JerkRoot {
    fn difference(&self, [gamma, w]: [Expression; 2]) -> Expression {
        let c = 2 * gamma - w;
        c * c - 4 * gamma * c + gamma * gamma - 6 - (w * w - 3 * gamma * gamma - 6)
    }
}
