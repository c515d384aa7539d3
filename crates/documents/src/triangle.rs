//! The triangle of the two axes and the pin, exactly, as the vocabularies use it.
//!
//! Two lines cross: the slot's from the follower's axis at the angle φ, and the crank's from the driver's axis at the angle
//! θ, both from the line of centres. Where they cross is the pin. No law of cosines or sines is needed for it.

use geneva_kinematics::{Expression, Turn};
use nalgebra::Vector2;

/// The triangle by its centre distance and the angles at the two axes.
pub(crate) struct Triangle {
    /// Distance of the axes.
    pub distance: Expression,
    /// Distance of the pin from the driver's axis.
    pub crank_radius: Expression,
    /// Distance of the pin from the follower's axis.
    pub slot_radius: Expression,
    /// Angle at the driver's axis.
    pub theta: Turn<Expression>,
    /// Angle at the follower's axis.
    pub phi: Turn<Expression>,
}

impl Triangle {
    /// With r u = e + R d for u along the slot, d along the crank and e from axis to axis, each length comes from the cross
    /// product of the equation with the direction of the other.
    pub(crate) fn new(distance: Expression, theta: Turn<Expression>, phi: Turn<Expression>) -> Self {
        let axis = Vector2::new(distance, Expression::ZERO);
        let (along_slot, along_crank) = (phi.direction(), theta.supplement().direction());
        let opening = along_slot.perp(&along_crank);
        let slot_radius = axis.perp(&along_crank) / opening;
        let crank_radius = axis.perp(&along_slot) / opening;
        Self { distance, crank_radius, slot_radius, theta, phi }
    }

    /// Takes the angles by the tangents of their halves.
    pub(crate) fn by_halves(distance: Expression, halves: [Expression; 2]) -> Self {
        let [theta, phi] = halves.map(|half| Turn::from_half_tangent(&half));
        Self::new(distance, theta, phi)
    }
}

/// The cosine and the sine of an angle, as a moment takes them.
pub(crate) fn angle(turn: &Turn<Expression>) -> [Expression; 2] {
    [turn.cos, turn.sin]
}
