//! The rates of a point given in a frame that moves: the general equations behind relative velocity and Coriolis.
//!
//! A point has the place r = R + p, with R the frame's origin and p = (x, y) measured along the frame's own axes. The
//! frame turns at ω with the angular acceleration ω̇. Dots on p are rates as seen in the frame. At the instant the
//! frame's axes are parallel to the fixed ones, which costs no generality: fixed axes may be chosen at will. The
//! origin's rates add on both sides alike and are left out.

use crate::{Field, Identity, Jet, Turn};
use nalgebra::Vector2;

/// ṗ (fixed) = ṗ + ω × p. Variables: ω, x, y, ẋ, ẏ.
pub struct VelocityInAFrame {
    /// Whether to compare along the frame's first axis or its second.
    pub first: bool,
}

impl Identity<5> for VelocityInAFrame {
    fn difference<S: Field>(&self, [speed, x, y, dx, dy]: &[S; 5]) -> S {
        let zero = S::zero();
        let seen = seen(speed, &zero, [x, dx, &zero], [y, dy, &zero]);
        let fixed = seen.map(|coordinate| coordinate.rate());
        if self.first {
            fixed.x.clone() - (dx.clone() - speed.clone() * y.clone())
        } else {
            fixed.y.clone() - (dy.clone() + speed.clone() * x.clone())
        }
    }
}

/// How ω × ω × p without brackets is read.
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
    /// How the double product is read.
    pub brackets: Brackets,
    /// How many times ω × ṗ is counted.
    pub coriolis: i64,
}

impl Identity<8> for AccelerationInAFrame {
    fn difference<S: Field>(&self, [speed, growth, x, y, dx, dy, ddx, ddy]: &[S; 8]) -> S {
        let seen = seen(speed, growth, [x, dx, ddx], [y, dy, ddy]);
        let fixed = seen.map(|coordinate| coordinate.coefficient(2) * S::integer(2));
        let centripetal = match self.brackets {
            Brackets::FromTheRight => -(speed.clone() * speed.clone()),
            Brackets::FromTheLeft => S::zero(),
        };
        let coriolis = S::integer(self.coriolis) * speed.clone();
        if self.first {
            let terms = centripetal * x.clone() - growth.clone() * y.clone() - coriolis * dy.clone();
            fixed.x.clone() - (ddx.clone() + terms)
        } else {
            let terms = centripetal * y.clone() + growth.clone() * x.clone() + coriolis * dx.clone();
            fixed.y.clone() - (ddy.clone() + terms)
        }
    }
}

/// The point's place along fixed axes as a power series: its coordinates in the frame, turned with the frame.
fn seen<S: Field>(speed: &S, growth: &S, x: [&S; 3], y: [&S; 3]) -> Vector2<Jet<S, 3>> {
    let two = S::integer(2);
    let series = |[value, rate, second]: [&S; 3]| {
        Jet::from_coefficients([value.clone(), rate.clone(), second.clone() / two.clone()])
    };
    let advance = Jet::from_coefficients([S::zero(), speed.clone(), growth.clone() / two.clone()]);
    let frame = Turn { cos: S::one(), sin: S::zero() }.moving_by(&advance);
    let (x, y) = (series(x), series(y));
    Vector2::new(frame.cos.clone() * x.clone() - frame.sin.clone() * y.clone(), frame.sin.clone() * x + frame.cos * y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prove;

    #[test]
    fn both_equations_hold_along_both_axes() {
        for first in [true, false] {
            assert!(prove(&VelocityInAFrame { first }).is_ok());
            let brackets = Brackets::FromTheRight;
            assert!(prove(&AccelerationInAFrame { first, brackets, coriolis: 2 }).is_ok());
        }
    }

    #[test]
    fn neither_another_factor_nor_the_other_brackets_will_do() {
        for first in [true, false] {
            for coriolis in [-2, 0, 1, 3] {
                let brackets = Brackets::FromTheRight;
                assert!(prove(&AccelerationInAFrame { first, brackets, coriolis }).is_err(), "{coriolis}");
            }
            let brackets = Brackets::FromTheLeft;
            assert!(prove(&AccelerationInAFrame { first, brackets, coriolis: 2 }).is_err());
        }
    }
}
