//! What stays clear of what: slots, rim, axes, and the pins that are in no slot.
//!
//! The follower is taken as a disc out to its rim, with slots cut in from there, and the pins as thin. Then nothing
//! collides: a pin is inside the rim only while it is in its slot ([`RimExcess`]). A pin of some thickness needs its
//! slot opened a little at the mouth ([`ApproachCoefficient`]).

use super::{EscapementError, Mechanism};
use crate::pin_slot::{pin_from_pivot, pin_path};
use crate::{Expression, Identity, Jet, Turn};
use nalgebra::Vector2;

impl Mechanism {
    /// Least length of a slot, from the rim to the pin's place nearest to the follower's axis, in crank radii:
    /// cot(π/n) − (a − 1).
    ///
    /// ```
    /// use geneva_kinematics::Mechanism;
    /// use std::f64::consts::FRAC_PI_2;
    ///
    /// let (mechanism, root) = (Mechanism::FOUR_PIN, 2_f64.sqrt()); // a = √2 and cot 45° = 1, in crank radii
    /// assert!((mechanism.slot_length() - (2.0 - root)).abs() < 1e-15);
    /// assert!((mechanism.rim_arc() - FRAC_PI_2).abs() < 1e-15); // a quarter of a circle of radius one
    /// assert!((mechanism.web() - (2.0 - root)).abs() < 1e-15);
    /// assert!((mechanism.shaft_limit() - (root - 1.0)).abs() < 1e-15); // a − 1: from the axis to the rim
    /// ```
    pub fn slot_length(&self) -> f64 {
        self.wheel().slot_length_ratio()
    }

    /// Arc of the rim between the centre lines of two neighbouring mouths, in crank radii: (2π/n) cot(π/n). Slots of
    /// width w leave w less.
    pub fn rim_arc(&self) -> f64 {
        self.follower_pitch_angle() * self.rim_radius()
    }

    /// Distance between the ends of two neighbouring slots, in crank radii: 2 (a − 1) sin(π/n) = 2 (1 − sin(π/n)). It
    /// is above zero, so the slots do not run into each other.
    pub fn web(&self) -> f64 {
        2.0 - 2.0 / self.centre_distance_ratio()
    }

    /// Greatest radius of a driver's shaft in the plane of the follower, in crank radii: a − cot(π/n) = tan(π/(2n)). So
    /// near the rim comes to the driver's axis.
    pub fn shaft_limit(&self) -> f64 {
        libm::tan(0.5 * self.follower_half_angle())
    }

    /// Distance outside the rim, in crank radii, of the nearest pin that is in no slot, while the first pin is at this
    /// driver angle in radians.
    ///
    /// Never negative but for rounding; it goes to zero as the next pin comes to its slot.
    ///
    /// ```
    /// use geneva_kinematics::Mechanism;
    ///
    /// // While a pin is on the line of centres the next one is a quarter of a turn on: √(1 + a²) = √3 from the follower's axis.
    /// let clearance = Mechanism::FOUR_PIN.idle_clearance(0.0)?;
    /// assert!((clearance - (3_f64.sqrt() - 1.0)).abs() < 1e-15); // crank radii outside the rim
    /// # Ok::<(), geneva_kinematics::EscapementError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`EscapementError::Wheel`] as for [`layout`](Self::layout).
    pub fn idle_clearance(&self, crank: f64) -> Result<f64, EscapementError> {
        let layout = self.layout(crank)?;
        let idle = (0..layout.pins.len()).filter(|index| layout.engaged.iter().all(|(pin, _)| pin != index));
        let distance = |pin: usize| (layout.pins[pin] - layout.follower_axis).norm();
        Ok(idle.map(distance).fold(f64::INFINITY, f64::min) - self.rim_radius())
    }
}

/// R² − cot²(π/n) = 2 (1 − a cos θ): a pin is outside the rim exactly where a cos θ is below one, that is, out of its
/// engagement.
///
/// R² is the square of the pin's place. For any angle π/n, whole n or not. Variables: tangents of π/(2n) and θ/2.
pub struct RimExcess;

impl Identity<2> for RimExcess {
    fn difference(&self, [half_slot, half_theta]: [Expression; 2]) -> Expression {
        let (slot, theta) = (Turn::from_half_tangent(&half_slot), Turn::from_half_tangent(&half_theta));
        let (ratio, rim) = (1 / slot.sin, slot.cos / slot.sin);
        let pin = pin_from_pivot(&ratio, &theta);
        pin.dot(&pin) - rim * rim - 2 * (1 - ratio * theta.cos)
    }
}

/// Approach of a pin to its slot: at the driver angle δ before the hand-over it is beside the slot's centre line by
/// r δ² + …, and outside the rim by r δ + ….
///
/// So the pin comes in from one side, and the edge of the mouth there must be cut back by about ρ²/r for a pin of
/// radius ρ; on leaving, by symmetry, the other edge. Each coefficient is compared with the series of the pin's place
/// seen from the slot, whose direction the leaving pin gives. Beside is told by the tangent of the angle between the
/// two, times the radius of the rim. For any angle π/n with θ₀ = π/2 − π/n. Variable: tangent of π/(2n).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ApproachCoefficient {
    /// Beside the centre line, the part without δ: 0.
    BesideConstant,
    /// Beside, the part in δ: 0.
    BesideLinear,
    /// Beside, the part in δ²: 1.
    BesideQuadratic,
    /// R², the part without δ: cot²(π/n), the rim.
    OutsideConstant,
    /// R², the part in δ: 2 cot(π/n), so that R grows with δ itself.
    OutsideLinear,
}

impl ApproachCoefficient {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::BesideConstant, Self::BesideLinear, Self::BesideQuadratic, Self::OutsideConstant, Self::OutsideLinear];
}

impl Identity<1> for ApproachCoefficient {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let slot = Turn::from_half_tangent(&half);
        let (ratio, rim) = (1 / slot.sin, slot.cos / slot.sin);
        let end = Turn { cos: slot.sin, sin: slot.cos };
        // Both pins are δ before their places at the hand-over; seen from the follower, the slot of the entering one
        // is 2π/n before the direction of the leaving one.
        let before = |end: Turn<Expression>| pin_path(&ratio, &end.moving::<3>(-Expression::ONE));
        let (leaving, entering) = (before(end), before(end.reversed()));
        let back = slot.plus(&slot).reversed();
        let (cos, sin) = (Jet::constant(back.cos), Jet::constant(back.sin));
        let along = Vector2::new(leaving.x * cos - leaving.y * sin, leaving.x * sin + leaving.y * cos);
        let beside = along.perp(&entering) / along.dot(&entering) * Jet::constant(rim);
        let outside = entering.dot(&entering);
        match self {
            Self::BesideConstant => beside.value(),
            Self::BesideLinear => beside.rate(),
            Self::BesideQuadratic => beside.coefficient(2) - 1,
            Self::OutsideConstant => outside.value() - rim * rim,
            Self::OutsideLinear => outside.rate() - 2 * rim,
        }
    }
}
