//! The rates of a point given in a frame that moves: the general equations behind relative velocity and Coriolis.
//!
//! A point has the place r = R + p, with R the frame's origin and p = (x, y) measured along the frame's own axes. The
//! frame turns at ω with the angular acceleration ω̇. Dots on p are rates as seen in the frame. At the instant the
//! frame's axes are parallel to the fixed ones, which costs no generality: fixed axes may be chosen at will. The
//! origin's rates add on both sides alike and are left out.

use crate::{Expression, Identity, Jet, Turn};
use nalgebra::Vector2;

/// ṗ (fixed) = ṗ + ω × p. Variables: ω, x, y, ẋ, ẏ.
pub struct VelocityInAFrame {
    /// Whether to compare along the frame's first axis or its second.
    pub first: bool,
}

impl Identity<5> for VelocityInAFrame {
    fn difference(&self, [speed, x, y, dx, dy]: [Expression; 5]) -> Expression {
        let zero = Expression::ZERO;
        let fixed = seen(speed, zero, [x, dx, zero], [y, dy, zero]).map(|coordinate| coordinate.rate());
        if self.first { fixed.x - (dx - speed * y) } else { fixed.y - (dy + speed * x) }
    }
}

/// Reading of ω × ω × p without brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Brackets {
    /// ω × (ω × p), which is −ω² p in the plane.
    FromTheRight,
    /// (ω × ω) × p, which is zero.
    FromTheLeft,
}

/// p̈ (fixed) = p̈ + ω × ω × p + ω̇ × p + c ω × ṗ, true for brackets from the right and c = 2.
///
/// Variables: ω, ω̇, x, y, ẋ, ẏ, ẍ, ÿ.
pub struct AccelerationInAFrame {
    /// Whether to compare along the frame's first axis or its second.
    pub first: bool,
    /// Reading of the double product.
    pub brackets: Brackets,
    /// Number of times that ω × ṗ is counted.
    pub coriolis: i64,
}

impl Identity<8> for AccelerationInAFrame {
    fn difference(&self, [speed, growth, x, y, dx, dy, ddx, ddy]: [Expression; 8]) -> Expression {
        let fixed = seen(speed, growth, [x, dx, ddx], [y, dy, ddy]).map(|coordinate| coordinate.coefficient(2) * 2);
        let centripetal = match self.brackets {
            Brackets::FromTheRight => -(speed * speed),
            Brackets::FromTheLeft => Expression::ZERO,
        };
        let coriolis = self.coriolis * speed;
        if self.first {
            let terms = centripetal * x - growth * y - coriolis * dy;
            fixed.x - (ddx + terms)
        } else {
            let terms = centripetal * y + growth * x + coriolis * dx;
            fixed.y - (ddy + terms)
        }
    }
}

/// The point's place along fixed axes as a power series: its coordinates in the frame, turned with the frame.
fn seen(speed: Expression, growth: Expression, x: [Expression; 3], y: [Expression; 3]) -> Vector2<Jet<Expression, 3>> {
    let series = |[value, rate, second]: [Expression; 3]| Jet::from_coefficients([value, rate, second / 2]);
    let frame =
        Turn { cos: Expression::ONE, sin: Expression::ZERO }.moving_by(&series([Expression::ZERO, speed, growth]));
    let (x, y) = (series(x), series(y));
    Vector2::new(frame.cos * x - frame.sin * y, frame.sin * x + frame.cos * y)
}
