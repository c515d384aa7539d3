//! What the triangle and the velocity triangle of a pin in a slot say, as identities that can be proven exactly.
//!
//! Notation as in [`pin_slot`] and [`pin_vectors`]. Roots are avoided by
//! multiplying out: a length that is a root of a rational function appears squared or against its own direction.
//!
//! Most identities have the variables p = R cos φ, q = R sin φ, l and the driver's angular velocity ω. The crank pair
//! (p, q) then carries its own length R, and everything is a polynomial over r²: few points suffice for a proof.

use crate::pin_vectors::{self, PinMotion, quarter_turn};
use crate::{Expression, Field, Identity, Turn, pin_slot};
use nalgebra::Vector2;

/// Law of cosines in triangle OPB: r² = R² + l² − 2 R l cos(180° − φ), against the pin's coordinates.
///
/// Variables: R, l, and the tangent of φ/2.
pub struct LawOfCosines;

impl Identity<3> for LawOfCosines {
    fn difference(&self, [radius, distance, half]: [Expression; 3]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let pin = pin_place(radius, distance, &crank);
        let ratio = distance / radius;
        let scaled = pin_slot::slot_radius_squared(&ratio, &crank.supplement());
        pin.dot(&pin) - scaled * radius * radius
    }
}

/// Law of sines in triangle OPB: sin β / R = sin(180° − φ) / r, both sines taken from cross products of the sides.
///
/// Multiplied by R r l it says that OB × OP = BP × BO. Variables: R, l, and the tangent of φ/2.
pub struct LawOfSines;

impl Identity<3> for LawOfSines {
    fn difference(&self, [radius, distance, half]: [Expression; 3]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let axis = Vector2::new(distance, Expression::ZERO);
        let from_pivot = pin_place(radius, distance, &crank);
        let from_axis = from_pivot - axis;
        axis.perp(&from_pivot) - from_axis.perp(&(-axis))
    }
}

/// The pin slides along the slot and nowhere else: (v_P − v_P′) × OP = 0.
///
/// Variables: p, q, l, ω.
pub struct SlidesAlongTheSlot;

impl Identity<4> for SlidesAlongTheSlot {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        let (motion, _) = moving(variables);
        motion.sliding_velocity.perp(&motion.position)
    }
}

/// The pin's velocity is the sum of that of the slot's point and that along the slot: v_P = v_P′ + v_{P/S}, a component.
///
/// On the left is the velocity on the pin's circle, ω R at right angles to the crank. On the right are the closed
/// formulas of [`pin_slot`]: the follower's angular velocity times OP turned by a quarter, and r ṙ over r² times OP. In
/// crank radii, with a driver of speed one. Variables: k and the tangent of φ/2.
pub struct VelocityTriangle {
    /// Whether to compare along the line of centres or across it.
    pub first: bool,
}

impl Identity<2> for VelocityTriangle {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let Driven { place, velocity, square, turning, theta } = Driven::new(ratio, half);
        // θ shrinks at the speed of the driver, and r ṙ with it.
        let sliding = -pin_slot::sliding_product(&ratio, &theta) / square;
        let sum = quarter_turn(&place) * turning + place * sliding;
        if self.first { velocity.x - sum.x } else { velocity.y - sum.y }
    }
}

/// The slot's point runs on a circle about the follower's pivot: r v_P′ = r² ω_S, both counter-clockwise positive.
///
/// v_P′ is what the pin's velocity has across the slot, ω_S the closed formula of [`pin_slot`]. In crank radii, with a
/// driver of speed one. Variables: k and the tangent of φ/2.
pub struct SlotPointOnItsCircle;

impl Identity<2> for SlotPointOnItsCircle {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let Driven { place, velocity, square, turning, .. } = Driven::new(ratio, half);
        place.perp(&velocity) - square * turning
    }
}

/// The pin on its circle, and the follower's angular velocity by its closed formula.
struct Driven {
    /// From the follower's pivot to the pin.
    place: Vector2<Expression>,
    /// Velocity of the pin on its circle.
    velocity: Vector2<Expression>,
    /// r².
    square: Expression,
    /// Angular velocity of the follower, counter-clockwise positive.
    turning: Expression,
    /// The crank angle from the line of centres.
    theta: Turn<Expression>,
}

impl Driven {
    /// In crank radii, with a driver of speed one, for k and the tangent of φ/2.
    fn new(ratio: Expression, half: Expression) -> Self {
        let crank = Turn::from_half_tangent(&half);
        let theta = crank.supplement();
        Self {
            place: pin_place(Expression::ONE, ratio, &crank),
            velocity: quarter_turn(&crank.direction()),
            square: pin_slot::slot_radius_squared(&ratio, &theta),
            turning: -pin_slot::velocity_ratio(&ratio, &theta),
            theta,
        }
    }
}

/// The slot's point has what the pin's velocity has across the slot: r² v_P′ = r² v_P − (v_P · OP) OP, first component.
///
/// Variables: p, q, l, ω.
pub struct SlotPointMovesAcross;

impl Identity<4> for SlotPointMovesAcross {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        let (motion, square) = moving(variables);
        let along = motion.pin_velocity.dot(&motion.position) * motion.position.x;
        square * (motion.slot_point_velocity.x - motion.pin_velocity.x) + along
    }
}

/// Speed of the pin on its circle: v_P² = R² ω². Variables: p, q, l, ω.
pub struct PinSpeed;

impl Identity<4> for PinSpeed {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        let [p, q, _, driver] = variables;
        let (motion, _) = moving(variables);
        motion.pin_velocity.dot(&motion.pin_velocity) - (p * p + q * q) * driver * driver
    }
}

/// v_P′ = r ω_S = v_P sin γ with γ = 90° − β − θ, multiplied by r: the component of v_P across the slot, towards the
/// driver.
///
/// sin γ = cos β cos θ − sin β sin θ; r cos β and r sin β are the pin's coordinates, R cos θ = −p and R sin θ = q.
/// Variables: p, q, l, ω.
pub struct SlotPointSpeed;

impl Identity<4> for SlotPointSpeed {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        let [p, q, _, driver] = variables;
        let (motion, square) = moving(variables);
        let sine = -(motion.position.x * p) - motion.position.y * q;
        // r v_P′ = r² ω_S, and ω_S is against the driver's sense.
        -(motion.follower_speed * square) - driver * sine
    }
}

/// v_{P/S} = v_P cos γ with γ = 90° − β − θ, multiplied by r: the component of v_P along the slot, to the pivot.
///
/// Variables: p, q, l, ω.
pub struct SlidingSpeed;

impl Identity<4> for SlidingSpeed {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        let [p, q, _, driver] = variables;
        let (motion, _) = moving(variables);
        let cosine = motion.position.x * q - motion.position.y * p;
        -motion.sliding_velocity.dot(&motion.position) - driver * cosine
    }
}

/// The velocity ratio of [`pin_slot`] is the one that differentiating the pin's place gives.
///
/// In crank radii, with a driver of speed one. Variables: k and the tangent of φ/2.
pub struct VelocityRatio;

impl Identity<2> for VelocityRatio {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let formula = pin_slot::velocity_ratio(&ratio, &crank.supplement());
        solved(ratio, &crank, Expression::ONE).follower_speed + formula
    }
}

/// Standstill of a four-slot follower as the pin enters: the condition on k = l / R, multiplied out.
///
/// The slots of four are 90° apart, so the pin enters and leaves at β = ±45°: k − cos θ = sin θ. The follower stands
/// still if k cos θ = 1. With cos θ = 1/k and sin θ = k − 1/k the pin is on its circle, cos² + sin² = 1, exactly if
/// (k² − 1)(k² − 2) = 0. Variable: k.
pub struct StandstillOfFourSlots;

impl Identity<1> for StandstillOfFourSlots {
    fn difference(&self, [ratio]: [Expression; 1]) -> Expression {
        let square = ratio * ratio;
        let product = (square - 1) * (square - 2);
        square * four_slot_entry_misfit(&ratio) - product
    }
}

/// How far the pin is off its circle if it is at β = 45° and the follower stands still: cos² θ + sin² θ − 1,
/// dimensionless.
///
/// Zero for the ratios k = l / R at which a four-slot follower is at rest as the pin enters; k must not be zero.
pub fn four_slot_entry_misfit<S: Field>(ratio: &S) -> S {
    let cos = S::one() / ratio.clone();
    let sin = ratio.clone() - cos.clone();
    cos.clone() * cos + sin.clone() * sin - S::one()
}

fn pin_place(radius: Expression, distance: Expression, crank: &Turn<Expression>) -> Vector2<Expression> {
    crank.direction() * radius + Vector2::new(distance, Expression::ZERO)
}

/// The pin's motion. A proof stops with a panic, as at any pole, if the pin is on the pivot.
fn solved(distance: Expression, crank: &Turn<Expression>, driver: Expression) -> PinMotion<Expression> {
    pin_vectors::solve(&Expression::ONE, &distance, crank, &driver).expect("the pin is off the pivot")
}

/// The motion at p, q, l, ω, and r².
fn moving([p, q, distance, driver]: [Expression; 4]) -> (PinMotion<Expression>, Expression) {
    let motion = solved(distance, &Turn { cos: p, sin: q }, driver);
    let square = motion.position.dot(&motion.position);
    (motion, square)
}
