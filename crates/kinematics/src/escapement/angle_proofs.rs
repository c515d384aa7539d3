//! From the general position, figure 5 of the source, to tan φ and sin φ, as identities.
//!
//! The pin is where two lines meet: the slot's from the follower's axis at the angle φ, and the crank's from the driver's
//! axis at the angle θ. Crossing them gives r and R from c, θ and φ, without a law of sines or cosines; every line of the
//! source is then compared with these lengths. Meyer 1973, from the display before Eq. (1-4) to Eq. (1-6), Eq. (1-11)
//! and the displays of R after Eq. (1-12).

use super::Form;
use crate::{Expression, Identity, Turn};
use nalgebra::Vector2;

/// One line of the derivation. Variables: c and the tangents of θ/2 and φ/2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngleStep {
    /// r cos θ + R cos φ = c. Meyer 1973, first display before Eq. (1-4).
    Projection,
    /// cos φ = (c − r cos θ) / R. Meyer 1973, second display before Eq. (1-4).
    Cosine,
    /// cos φ = (a r − r cos θ) / R, with a = c / r. Meyer 1973, Eq. (1-4).
    CosineByRatio,
    /// R / sin θ = r / sin φ. Meyer 1973, display before Eq. (1-5).
    LawOfSines,
    /// R = r sin θ / sin φ. Meyer 1973, Eq. (1-5).
    SlotRadius,
    /// cos φ = (r sin φ / (r sin θ)) (a − cos θ). Meyer 1973, display after Eq. (1-5).
    ///
    /// Printed with r sin θ over itself, a fraction that is one: the angle above the line should be φ.
    CosineSubstituted(Form),
    /// cos φ / sin φ = (a − cos θ) / sin θ. Meyer 1973, display before Eq. (1-6), left equality.
    Cotangent,
    /// (a − cos θ) / sin θ = 1 / tan φ, tan φ being the pin's y over x. The same display, right equality.
    InverseTangent,
    /// tan φ = sin θ / (a − cos θ). Meyer 1973, Eq. (1-6).
    Tangent,
    /// sin φ = sin θ / √(1 + a² − 2 a cos θ), squared. Meyer 1973, Eq. (1-11).
    ///
    /// The signs agree because the pin, seen from either axis, is on the same side of the line of centres.
    Sine,
    /// R = r sin θ / (sin θ / √(1 + a² − 2 a cos θ)), squared. Meyer 1973, first display of R after Eq. (1-12).
    SlotRadiusBySine,
    /// R = r √(1 + a² − 2 a cos θ), squared. Meyer 1973, second display of R after Eq. (1-12).
    SlotRadiusByRoot,
}

impl AngleStep {
    /// All lines in the order of the source, the one with the slip in both forms.
    pub const ALL: [Self; 13] = [
        Self::Projection,
        Self::Cosine,
        Self::CosineByRatio,
        Self::LawOfSines,
        Self::SlotRadius,
        Self::CosineSubstituted(Form::Printed),
        Self::CosineSubstituted(Form::Corrected),
        Self::Cotangent,
        Self::InverseTangent,
        Self::Tangent,
        Self::Sine,
        Self::SlotRadiusBySine,
        Self::SlotRadiusByRoot,
    ];
}

/// Where the crank's line and the slot's line meet; lengths over c.
struct Crossing {
    /// r, from the driver's axis to the pin.
    crank_radius: Expression,
    /// R, from the follower's axis to the pin.
    slot_radius: Expression,
    /// The pin from the follower's axis, first coordinate along the line of centres.
    pin: Vector2<Expression>,
}

impl Crossing {
    /// R u = e + r d with u along the slot, d along the crank, e along the line of centres; each length by crossing
    /// the equation with the direction of the other.
    fn new(crank: &Turn<Expression>, slot: &Turn<Expression>) -> Self {
        let axis = Vector2::new(Expression::ONE, Expression::ZERO);
        let (along_slot, along_crank) = (slot.direction(), crank.supplement().direction());
        let opening = along_slot.perp(&along_crank);
        let slot_radius = axis.perp(&along_crank) / opening;
        let crank_radius = axis.perp(&along_slot) / opening;
        Self { pin: along_slot * slot_radius, crank_radius, slot_radius }
    }
}

impl Identity<3> for AngleStep {
    fn difference(&self, [distance, half_theta, half_phi]: [Expression; 3]) -> Expression {
        let (theta, phi) = (Turn::from_half_tangent(&half_theta), Turn::from_half_tangent(&half_phi));
        let Crossing { crank_radius, slot_radius, pin } = Crossing::new(&theta, &phi);
        let (c, a) = (distance, 1 / crank_radius);
        let (r, slot_radius) = (crank_radius * c, slot_radius * c);
        let rest = a - theta.cos;
        let under_root = 1 + a.squared() - 2 * a * theta.cos;
        match self {
            Self::Projection => r * theta.cos + slot_radius * phi.cos - c,
            Self::Cosine => phi.cos - (c - r * theta.cos) / slot_radius,
            Self::CosineByRatio => phi.cos - (a * r - r * theta.cos) / slot_radius,
            Self::LawOfSines => slot_radius / theta.sin - r / phi.sin,
            Self::SlotRadius => slot_radius - r * theta.sin / phi.sin,
            Self::CosineSubstituted(form) => {
                let above = form.pick(theta.sin, phi.sin);
                phi.cos - r * above / (r * theta.sin) * rest
            }
            Self::Cotangent => phi.cos / phi.sin - rest / theta.sin,
            Self::InverseTangent => rest / theta.sin - 1 / (pin.y / pin.x),
            Self::Tangent => phi.sin / phi.cos - theta.sin / rest,
            Self::Sine => phi.sin.squared() - theta.sin.squared() / under_root,
            Self::SlotRadiusBySine => {
                let sine_squared = theta.sin.squared() / under_root;
                slot_radius.squared() - (r * theta.sin).squared() / sine_squared
            }
            Self::SlotRadiusByRoot => slot_radius.squared() - r.squared() * under_root,
        }
    }
}
