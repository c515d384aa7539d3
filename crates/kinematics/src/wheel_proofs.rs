//! The formulas of a wheel's motion as identities: the left sides come from power series of the pin's place, the right sides
//! are the formulas. Notation as in [`wheel`](crate::wheel).
//!
//! ```
//! use geneva_kinematics::prove;
//! use geneva_kinematics::wheel_proofs::{WheelFormula, WheelQuantity};
//!
//! // Angle, velocity, acceleration and jerk, for every ratio of lengths and every crank angle.
//! for quantity in WheelQuantity::ALL {
//!     assert!(prove(&WheelFormula(quantity)).is_ok());
//! }
//! ```

use crate::pin_slot::{pin_path, velocity_ratio};
use crate::wheel::{acceleration_ratio, jerk_ratio, unsteady_acceleration};
use crate::{Expression, Identity, Jet, Turn, angular_velocity};
use nalgebra::Vector2;

/// Angular velocity of a wheel as a series, from the pin's. A proof stops with a panic, as at any pole, if the pin is on
/// the axis.
pub(crate) fn direction_rate<const N: usize>(path: &Vector2<Jet<Expression, N>>) -> Jet<Expression, N> {
    angular_velocity(path).expect("the pin is off the wheel's axis")
}

/// Angular velocity of the external wheel as a series.
pub(crate) fn wheel_velocity<const N: usize>(
    ratio: Expression,
    crank: &Turn<Jet<Expression, N>>,
) -> Jet<Expression, N> {
    direction_rate(&pin_path(&ratio, crank))
}

/// Quantity of a wheel's motion in an identity for any number of stations; equations are of the external wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WheelQuantity {
    /// tan φ, from Eq. (5.30).
    Tangent,
    /// φ̇ / θ̇, Eq. (5.31).
    Velocity,
    /// φ̈ / θ̇², Eq. (5.32).
    Acceleration,
    /// Its derivative over θ̇³, example (e).
    Jerk,
}

impl WheelQuantity {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Tangent, Self::Velocity, Self::Acceleration, Self::Jerk];

    /// The quantity from the power series of the pin's place, seen from the wheel, for a driver of speed one.
    pub(crate) fn path_value<const N: usize>(self, path: &Vector2<Jet<Expression, N>>) -> Expression {
        let velocity = direction_rate(path);
        match self {
            Self::Tangent => path.y.value() / path.x.value(),
            Self::Velocity => velocity.value(),
            Self::Acceleration => velocity.rate(),
            Self::Jerk => velocity.coefficient(2) * 2,
        }
    }

    /// The quantity of the external wheel at a crank angle.
    fn place_value(self, ratio: Expression, crank: &Turn<Expression>) -> Expression {
        self.path_value(&pin_path(&ratio, &crank.moving::<4>(Expression::ONE)))
    }
}

/// The formulas of [`wheel`](crate::wheel) in k against the same power series. Variables: k, tangent of θ/2.
pub struct WheelFormula(
    /// The quantity.
    pub WheelQuantity,
);

impl Identity<2> for WheelFormula {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let formula = match self.0 {
            WheelQuantity::Tangent => crank.sin / (ratio - crank.cos),
            WheelQuantity::Velocity => velocity_ratio(&ratio, &crank),
            WheelQuantity::Acceleration => acceleration_ratio(&ratio, &crank),
            WheelQuantity::Jerk => jerk_ratio(&ratio, &crank),
        };
        self.0.place_value(ratio, &crank) - formula
    }
}

/// The acceleration is an odd function of the crank angle: f(θ) + f(−θ) = 0. Variables: k, tangent of θ/2.
pub struct OddAcceleration;

impl Identity<2> for OddAcceleration {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        acceleration_ratio(&ratio, &crank) + acceleration_ratio(&ratio, &crank.reversed())
    }
}

/// The acceleration for a driver that speeds up, any N, against power series. Variables: k, tangent of θ/2, θ̇, θ̈.
pub struct UnsteadyAcceleration;

impl Identity<4> for UnsteadyAcceleration {
    fn difference(&self, [ratio, half, speed, angular_acceleration]: [Expression; 4]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let moving = crank.speeding_up(speed, angular_acceleration);
        wheel_velocity(ratio, &moving).rate() - unsteady_acceleration(&ratio, &crank, &speed, &angular_acceleration)
    }
}
