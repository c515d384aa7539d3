//! Every step from the loop closure of a wheel to the place of its greatest acceleration, as identities.
//!
//! Notation as in [`wheel`](crate::wheel). Where an equation is for four stations, √2 is kept exact; where it is for
//! any number, α enters by the tangent of its half, so that sin α and cos α are rational. The left sides come from
//! power series of the pin's place, the right sides are the formulas. Work::Jazar2003, Eqs. (5.25) to (5.34).

use crate::pin_slot::{pin_from_pivot, pin_path, velocity_ratio};
use crate::wheel::{acceleration_ratio, jerk_ratio, unsteady_acceleration};
use crate::{Expression, Identity, IdentityWithRoot, Jet, Turn, angular_velocity};
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

/// Loop closure, Eq. (5.25), against the pin's place: what the two equations give is where the pin is.
///
/// From the first, x = sin θ / sin φ in crank radii; from the second, k = cos θ + x cos φ. The pin at this k and θ must be
/// at x (cos φ, sin φ). Variables: tangents of θ/2 and φ/2.
pub struct LoopClosure {
    /// Whether to compare along the line of centres or across it.
    pub along: bool,
}

impl Identity<2> for LoopClosure {
    fn difference(&self, [half_theta, half_phi]: [Expression; 2]) -> Expression {
        let (theta, phi) = (Turn::from_half_tangent(&half_theta), Turn::from_half_tangent(&half_phi));
        let x = theta.sin / phi.sin;
        let ratio = theta.cos + x * phi.cos;
        let place = pin_from_pivot(&ratio, &theta) - phi.direction() * x;
        if self.along { place.x } else { place.y }
    }
}

/// cos θ + sin θ / tan φ = k, with tan φ from the pin's place. Variables: k and the tangent of θ/2.
pub struct SlotEliminated;

impl Identity<2> for SlotEliminated {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let pin = pin_from_pivot(&ratio, &crank);
        crank.cos + crank.sin * pin.x / pin.y - ratio
    }
}

/// φ̇ (1 + tan² φ) = θ̇ (k cos θ − 1) / (k − cos θ)², both factors on the left from power series.
///
/// For k = √2 the display after Eq. (5.27). Variables: tangent of θ/2, θ̇.
pub struct TangentDifferentiated;

impl IdentityWithRoot<2> for TangentDifferentiated {
    fn difference(&self, root: Expression, [half, speed]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let moving = crank.moving::<2>(speed);
        let place = pin_path(&root, &moving);
        let tangent = place.y.value() / place.x.value();
        let left = wheel_velocity(root, &moving).value() * (1 + tangent * tangent);
        let rest = root - crank.cos;
        left - speed * (root * crank.cos - 1) / (rest * rest)
    }
}

/// Eq. (5.28), four stations: φ̇ = θ̇ (√2 cos θ − 1) / (3 − 2√2 cos θ). Variables: tangent of θ/2, θ̇.
pub struct VelocityOfFour;

impl IdentityWithRoot<2> for VelocityOfFour {
    fn difference(&self, root: Expression, [half, speed]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let moving = crank.moving::<2>(speed);
        wheel_velocity(root, &moving).value() - speed * four_velocity(root, &crank)
    }
}

/// The display before Eq. (5.29), four stations, for a driver that speeds up:
/// φ̈ = θ̈ (√2 cos θ − 1)/(3 − 2√2 cos θ) − θ̇² √2 sin θ/(3 − 2√2 cos θ)². Variables: tangent of θ/2, θ̇, θ̈.
pub struct UnsteadyAccelerationOfFour;

impl IdentityWithRoot<3> for UnsteadyAccelerationOfFour {
    fn difference(&self, root: Expression, [half, speed, angular_acceleration]: [Expression; 3]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let moving = crank.speeding_up(speed, angular_acceleration);
        let printed =
            angular_acceleration * four_velocity(root, &crank) - speed * speed * four_acceleration(root, &crank);
        wheel_velocity(root, &moving).rate() - printed
    }
}

/// Eq. (5.29), four stations, steady driver: φ̈ = ∓ θ̇² √2 sin θ/(3 − 2√2 cos θ)². Variables: tangent of θ/2, θ̇.
pub struct AccelerationOfFour {
    /// Whether the right side has the minus sign.
    pub negative: bool,
}

impl IdentityWithRoot<2> for AccelerationOfFour {
    fn difference(&self, root: Expression, [half, speed]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let moving = crank.moving::<3>(speed);
        let size = speed * speed * four_acceleration(root, &crank);
        let formula = if self.negative { -size } else { size };
        wheel_velocity(root, &moving).rate() - formula
    }
}

fn four_velocity(root: Expression, crank: &Turn<Expression>) -> Expression {
    let product = root * crank.cos;
    (product - 1) / (3 - 2 * product)
}

fn four_acceleration(root: Expression, crank: &Turn<Expression>) -> Expression {
    let square = 3 - 2 * root * crank.cos;
    root * crank.sin / (square * square)
}

/// Quantity of a wheel's motion in an identity for any number of stations; equations are of the external wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// tan φ, from Eq. (5.30).
    Tangent,
    /// φ̇ / θ̇, Eq. (5.31).
    Velocity,
    /// φ̈ / θ̇², Eq. (5.32).
    Acceleration,
    /// Its derivative over θ̇³, example (e).
    Jerk,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Tangent, Self::Velocity, Self::Acceleration, Self::Jerk];

    /// The quantity from the power series of the pin's place, seen from the wheel, for a driver of speed one.
    pub(crate) fn of_the_path<const N: usize>(self, path: &Vector2<Jet<Expression, N>>) -> Expression {
        let velocity = direction_rate(path);
        match self {
            Self::Tangent => path.y.value() / path.x.value(),
            Self::Velocity => velocity.value(),
            Self::Acceleration => velocity.rate(),
            Self::Jerk => velocity.coefficient(2) * 2,
        }
    }

    /// The quantity of the external wheel at a crank angle.
    fn of_the_place(self, ratio: Expression, crank: &Turn<Expression>) -> Expression {
        self.of_the_path(&pin_path(&ratio, &crank.moving::<4>(Expression::ONE)))
    }
}

/// A printed formula in sin α and cos α against the power series of the pin's place, with k = 1 / sin α.
///
/// Variables: tangents of α/2 and θ/2.
pub struct Printed(
    /// The quantity.
    pub Quantity,
);

impl Identity<2> for Printed {
    fn difference(&self, [half_alpha, half_theta]: [Expression; 2]) -> Expression {
        let (alpha, crank) = (Turn::from_half_tangent(&half_alpha), Turn::from_half_tangent(&half_theta));
        let (sin, cos) = (alpha.sin, alpha.cos);
        let square = 1 + sin * sin - 2 * sin * crank.cos;
        let found = self.0.of_the_place(1 / sin, &crank);
        match self.0 {
            Quantity::Tangent => found - sin * crank.sin / (1 - sin * crank.cos),
            Quantity::Velocity => found - sin * (crank.cos - sin) / square,
            Quantity::Acceleration => found + sin * cos * cos * crank.sin / (square * square),
            Quantity::Jerk => {
                let braces = square * crank.cos - 4 * sin * crank.sin * crank.sin;
                found - -(sin * cos * cos * braces) / (square * square * square)
            }
        }
    }
}

/// The formulas of [`wheel`](crate::wheel) in k against the same power series. Variables: k, tangent of θ/2.
pub struct Implemented(
    /// The quantity.
    pub Quantity,
);

impl Identity<2> for Implemented {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let formula = match self.0 {
            Quantity::Tangent => crank.sin / (ratio - crank.cos),
            Quantity::Velocity => velocity_ratio(&ratio, &crank),
            Quantity::Acceleration => acceleration_ratio(&ratio, &crank),
            Quantity::Jerk => jerk_ratio(&ratio, &crank),
        };
        self.0.of_the_place(ratio, &crank) - formula
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
