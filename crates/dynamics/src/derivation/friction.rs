//! The torque of friction: its moment arm, and the displays from there to Eq. (1-12).

use crate::Sign;
use geneva_kinematics::{Expression, Identity, Turn, pin_slot};

/// The triangle of the two axes and the pin from its two angles: R = sin θ / sin φ and a = cos θ + R cos φ.
struct Triangle {
    theta: Turn<Expression>,
    phi: Turn<Expression>,
    radius: Expression,
    ratio: Expression,
}

impl Triangle {
    fn new(half_theta: Expression, half_phi: Expression) -> Self {
        let (theta, phi) = (Turn::from_half_tangent(&half_theta), Turn::from_half_tangent(&half_phi));
        let radius = theta.sin / phi.sin;
        let ratio = theta.cos + radius * phi.cos;
        Self { theta, phi, radius, ratio }
    }

    /// R dR/dθ at a fixed centre distance, from the pin's place.
    fn sliding(&self) -> Expression {
        let place = pin_slot::pin_path(&self.ratio, &self.theta.moving::<2>(Expression::ONE));
        (place.x * place.x + place.y * place.y).rate() / 2
    }
}

/// The moment arm h = c sin φ of the friction is dR/dθ, which is what virtual work asks for. Text at τ₂ = h μ N.
///
/// Multiplied by R. Variables: tangents of θ/2 and φ/2.
pub struct MomentArm;

impl Identity<2> for MomentArm {
    fn difference(&self, [half_theta, half_phi]: [Expression; 2]) -> Expression {
        let triangle = Triangle::new(half_theta, half_phi);
        triangle.sliding() - triangle.radius * triangle.ratio * triangle.phi.sin
    }
}

/// Eq. (1-11), sin φ = sin θ / (1 + a² − 2 a cos θ)^½, squared; both sines are positive together.
///
/// Variables: tangents of θ/2 and φ/2.
pub struct SineOfFollower;

impl Identity<2> for SineOfFollower {
    fn difference(&self, [half_theta, half_phi]: [Expression; 2]) -> Expression {
        let triangle = Triangle::new(half_theta, half_phi);
        let square = pin_slot::slot_radius_squared(&triangle.ratio, &triangle.theta);
        triangle.phi.sin.squared() * square - triangle.theta.sin.squared()
    }
}

/// A display of the friction's torque, in the order of the print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrictionLine {
    /// τ₂ = h μ N = c sin φ μ N, without bars or sign: the size of the torque, where N sin φ is positive.
    Arm,
    /// τ₂ = −|c sin φ μ N|.
    Opposing,
    /// τ₂ = −μ c |N sin φ|.
    Outside,
    /// τ₂ = −a r μ |N sin φ|.
    CrankRadii,
    /// Eq. (1-12), τ₂ = −a r μ |N sin θ / (1 + a² − 2 a cos θ)^½|; the half power is R, by [`SlotRadius`].
    Root,
}

impl FrictionLine {
    /// All lines.
    pub const ALL: [Self; 5] = [Self::Arm, Self::Opposing, Self::Outside, Self::CrankRadii, Self::Root];
}

/// The displays from τ₂ = h μ N to Eq. (1-12) against the work of sliding, −μ |N dR/dθ|.
///
/// Variables: tangents of θ/2 and φ/2, N, μ.
pub struct FrictionTorque {
    /// Which display.
    pub line: FrictionLine,
    /// Sign of N sin φ, which opens the bars.
    pub contact: Sign,
}

impl Identity<4> for FrictionTorque {
    fn difference(&self, [half_theta, half_phi, n, mu]: [Expression; 4]) -> Expression {
        let triangle = Triangle::new(half_theta, half_phi);
        let lost = mu * self.contact.of(n * triangle.sliding()) / triangle.radius;
        // In crank radii r = 1 and c = a.
        let (c, sine) = (triangle.ratio, triangle.phi.sin);
        let printed = match self.line {
            FrictionLine::Arm => -(c * sine * mu * n),
            FrictionLine::Opposing => -self.contact.of(c * sine * mu * n),
            FrictionLine::Outside | FrictionLine::CrankRadii => -(mu * c * self.contact.of(n * sine)),
            FrictionLine::Root => -(c * mu * self.contact.of(n * triangle.theta.sin / triangle.radius)),
        };
        printed + lost
    }
}

/// R = r sin θ / sin φ = r sin θ / ((sin θ) / (1 + a² − 2 a cos θ)^½), squared.
///
/// The right side squared is 1 + a² − 2 a cos θ, the left (sin θ / sin φ)². Variables: tangents of θ/2 and φ/2.
pub struct SlotRadiusBySines;

impl Identity<2> for SlotRadiusBySines {
    fn difference(&self, [half_theta, half_phi]: [Expression; 2]) -> Expression {
        let triangle = Triangle::new(half_theta, half_phi);
        triangle.radius.squared() - pin_slot::slot_radius_squared(&triangle.ratio, &triangle.theta)
    }
}

/// R = r (1 + a² − 2 a cos θ)^½, squared, against the pin's place. Variables: a and the tangent of θ/2.
pub struct SlotRadius;

impl Identity<2> for SlotRadius {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let place = pin_slot::pin_from_pivot(&ratio, &crank);
        place.x * place.x + place.y * place.y - pin_slot::slot_radius_squared(&ratio, &crank)
    }
}
