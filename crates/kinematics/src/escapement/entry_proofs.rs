//! The geometry at the instant of hand-over, figure 4 of the source, as identities.
//!
//! The slot's centre line leaves the follower's axis at the angle φ₀ from the line of centres. A pin that moves along
//! it stands at the foot of the perpendicular from the driver's axis: that is the large right triangle. The left sides
//! come from this foot; angles enter by the tangent of their half, so all is rational. Lengths that are roots appear
//! squared. Meyer 1973, from the display of φ₀ to Eq. (1-3), and appendix A.

use super::Form;
use crate::wheel_proofs::wheel_velocity;
use crate::{Expression, Identity, Turn};
use nalgebra::Vector2;

/// φ₀ = ½ (2π/n) = π/n, and θ₀ = ½ (2π/m) = π/m: 2n such angles make a whole turn of 2π.
///
/// Meyer 1973, the two displays before Eq. (1-1). Variables: π as a letter, and n (or m).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HalfAngle {
    /// ½ (2π/n).
    Halved,
    /// π/n.
    Simplified,
}

impl Identity<2> for HalfAngle {
    fn difference(&self, [pi, count]: [Expression; 2]) -> Expression {
        let turn = 2 * pi;
        let half = match self {
            Self::Halved => (turn / count) / 2,
            Self::Simplified => pi / count,
        };
        2 * count * half - turn
    }
}

/// The large right triangle of figure 4. Variables: c and the tangent of φ₀/2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryTriangle {
    /// r = c sin φ₀, squared; with φ₀ = π/n also r = c sin(π/n). Meyer 1973, display before Eq. (1-1).
    PinCircle,
    /// c = a r with a = 1 / sin φ₀, squared. Meyer 1973, Eqs. (1-1) and (1-2).
    CentreDistance,
    /// With that a, and θ₀ = π/2 − φ₀, the follower stands still: its angular velocity from the pin's power series is
    /// zero. Meyer 1973, Eq. (1-2) and the condition on the pin's velocity before figure 4.
    Standstill,
    /// θ₀ + φ₀ + π/2 = π. Meyer 1973, first line of Eq. (1-3).
    ///
    /// θ₀ is the direction of the pin from the driver's axis. The difference is the square of the distance between
    /// the points of a circle of radius r at the two angles: zero only if cosine and sine agree.
    HalfTurn,
    /// θ₀ + φ₀ = π/2, in the same way. Meyer 1973, second line of Eq. (1-3).
    QuarterTurn,
    /// R = r sin θ₀ / sin φ₀ at the hand-over, squared. Meyer 1973, appendix A, three times.
    SlotRadius,
    /// R = r cot φ₀, squared: what that comes to.
    RimRadius,
    /// c = 1 / sin φ₀ in the unit that appendix A announces, squared.
    ///
    /// Printed "Let R = 1", where R is the pin's distance from the follower; all that follows has r = 1. For four slots
    /// the two are the same.
    AppendixUnit(Form),
}

/// The triangle for centre distance c and slot angle φ₀.
struct Foot {
    /// The pin from the follower's axis; first coordinate along the line of centres.
    from_follower: Vector2<Expression>,
    /// The pin from the driver's axis, first coordinate towards the follower: r (cos θ₀, sin θ₀).
    from_driver: Vector2<Expression>,
}

impl Foot {
    fn new(distance: Expression, slot: &Turn<Expression>) -> Self {
        let direction = slot.direction();
        let axis = Vector2::new(distance, Expression::ZERO);
        let from_follower = direction * axis.dot(&direction);
        let from_driver = Vector2::new(distance - from_follower.x, from_follower.y);
        Self { from_follower, from_driver }
    }
}

impl Identity<2> for EntryTriangle {
    fn difference(&self, [distance, half]: [Expression; 2]) -> Expression {
        let slot = Turn::from_half_tangent(&half);
        let foot = Foot::new(distance, &slot);
        let norm = |vector: Vector2<Expression>| vector.dot(&vector);
        let (pin_circle, rim) = (norm(foot.from_driver), norm(foot.from_follower));
        let ratio = 1 / slot.sin;
        // r by the display, for the angles: its square is the foot's by `PinCircle`.
        let radius = distance * slot.sin;
        let driver = Turn { cos: foot.from_driver.x, sin: foot.from_driver.y };
        match self {
            Self::PinCircle => pin_circle - radius.squared(),
            Self::CentreDistance => distance.squared() - ratio.squared() * pin_circle,
            Self::Standstill => {
                let crank = Turn { cos: slot.sin, sin: slot.cos };
                wheel_velocity(ratio, &crank.moving::<2>(Expression::ONE)).value()
            }
            Self::HalfTurn => {
                let quarter = Turn { cos: Expression::ZERO, sin: Expression::ONE };
                let sum = driver.plus(&slot).plus(&quarter);
                norm(sum.direction() - Vector2::new(-radius, Expression::ZERO))
            }
            Self::QuarterTurn => norm(driver.plus(&slot).direction() - Vector2::new(Expression::ZERO, radius)),
            Self::SlotRadius => rim - (driver.sin / slot.sin).squared(),
            Self::RimRadius => rim - (radius * slot.cos / slot.sin).squared(),
            Self::AppendixUnit(form) => {
                let unit = form.pick(rim, pin_circle);
                distance.squared() / unit - ratio.squared()
            }
        }
    }
}

/// Numbers of pins and slots. Variables: m − 2 and n − 2, because n = 2 is a pole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PinsAndSlots {
    /// π/m + π/n = π/2 over π, with m by the fourth line; m − 2 counts for nothing. Meyer 1973, third line of Eq. (1-3).
    AngleSum,
    /// m = 2n / (n − 2) is the third line multiplied out:
    /// (1/m + 1/n − 1/2) 2mn / (n − 2) = −(m − 2n / (n − 2)). Meyer 1973, fourth line of Eq. (1-3).
    Pins,
    /// (m − 2)(n − 2) − 4 = 2mn (1/2 − 1/m − 1/n): the third line asks for two integers whose product is 4.
    Factors,
    /// m − 2 = 4 / (n − 2), m by the fourth line: above zero for every n, and as small as one likes only as n grows
    /// without end. Meyer 1973, remark after the table of Eq. (1-3).
    NeverTwo,
}

impl Identity<2> for PinsAndSlots {
    fn difference(&self, [pins_less_two, slots_less_two]: [Expression; 2]) -> Expression {
        let (m, n) = (pins_less_two + 2, slots_less_two + 2);
        let by_formula = 2 * n / slots_less_two;
        let sum = |m: Expression| 1 / m + 1 / n - Expression::ONE / 2;
        let twice_product = 2 * m * n;
        match self {
            Self::AngleSum => sum(by_formula),
            Self::Pins => sum(m) * twice_product / slots_less_two + m - by_formula,
            Self::Factors => pins_less_two * slots_less_two - 4 + twice_product * sum(m),
            Self::NeverTwo => by_formula - 2 - 4 / slots_less_two,
        }
    }
}
