//! An angle as the pair of its cosine and sine.

use super::field::Field;
use super::jet::Jet;
use nalgebra::Vector2;
use std::array::from_fn;

/// A direction in the plane: cosine and sine of an angle measured counter-clockwise.
///
/// As a pair, an angle needs no transcendental function: sums, half turns and motions are polynomials, and points of
/// the circle with rational cosine and sine are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<S> {
    /// Cosine of the angle, dimensionless.
    pub cos: S,
    /// Sine of the angle, dimensionless.
    pub sin: S,
}

impl<S: Field> Turn<S> {
    /// The angle whose half has the tangent `t`: cos = (1 − t²)/(1 + t²), sin = 2 t/(1 + t²).
    ///
    /// Rational `t` gives all rational points of the circle but the half turn.
    pub fn from_half_tangent(t: &S) -> Self {
        let square = t.clone() * t.clone();
        let scale = S::one() + square.clone();
        Self { cos: (S::one() - square) / scale.clone(), sin: S::integer(2) * t.clone() / scale }
    }

    /// The same angle with the opposite sign.
    pub fn reversed(&self) -> Self {
        Self { cos: self.cos.clone(), sin: -self.sin.clone() }
    }

    /// 180° minus this angle: what remains to the half turn.
    pub fn supplement(&self) -> Self {
        Self { cos: -self.cos.clone(), sin: self.sin.clone() }
    }

    /// The sum of this angle and `other`.
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            cos: self.cos.clone() * other.cos.clone() - self.sin.clone() * other.sin.clone(),
            sin: self.sin.clone() * other.cos.clone() + self.cos.clone() * other.sin.clone(),
        }
    }

    /// Unit vector in this direction.
    pub fn direction(&self) -> Vector2<S> {
        Vector2::new(self.cos.clone(), self.sin.clone())
    }

    /// The angle moving at `rate` (radians per unit of the jet's variable), as a power series from this instant on.
    pub fn moving<const N: usize>(&self, rate: S) -> Turn<Jet<S, N>> {
        self.moving_by(&Jet::from_coefficients(from_fn(|k| if k == 1 { rate.clone() } else { S::zero() })))
    }

    /// The angle moving at `rate` and gaining speed at `angular_acceleration` (radians per unit of the variable, and
    /// its square), as a power series from this instant on.
    pub fn speeding_up(&self, rate: S, angular_acceleration: S) -> Turn<Jet<S, 3>> {
        self.moving_by(&Jet::from_coefficients([S::zero(), rate, angular_acceleration / S::integer(2)]))
    }

    /// The angle moving by `advance`, a power series in radians whose constant part counts for nothing.
    ///
    /// From cos' = −advance' sin and sin' = advance' cos, coefficient by coefficient.
    pub fn moving_by<const N: usize>(&self, advance: &Jet<S, N>) -> Turn<Jet<S, N>> {
        let rate = advance.differentiated();
        let [mut coses, mut sines]: [[S; N]; 2] =
            [&self.cos, &self.sin].map(|start| from_fn(|k| if k == 0 { start.clone() } else { S::zero() }));
        for k in 1..N {
            let (mut cos, mut sin) = (S::zero(), S::zero());
            for (at, (c, s)) in coses.iter().zip(&sines).enumerate().take(k) {
                cos -= rate.coefficient(k - 1 - at) * s.clone();
                sin += rate.coefficient(k - 1 - at) * c.clone();
            }
            let order = S::integer(k as i64);
            (coses[k], sines[k]) = (cos / order.clone(), sin / order);
        }
        Turn { cos: Jet::from_coefficients(coses), sin: Jet::from_coefficients(sines) }
    }
}

impl Turn<f64> {
    /// The angle of `radians`; the cosine and sine come from a portable library, not from the platform's.
    pub fn from_radians(radians: f64) -> Self {
        // Both at once, to the same bits as one by one: the reduction to an eighth of the circle is made for both.
        let (sin, cos) = libm::sincos(radians);
        Self { cos, sin }
    }

    /// The angle of `degrees`.
    pub fn from_degrees(degrees: f64) -> Self {
        Self::from_radians(degrees.to_radians())
    }

    /// The angle in radians, in (−π, π].
    pub fn radians(&self) -> f64 {
        libm::atan2(self.sin, self.cos)
    }

    /// The angle in degrees, in (−180°, 180°].
    pub fn degrees(&self) -> f64 {
        self.radians().to_degrees()
    }
}

/// Angular velocity of the direction of `position`, in radians per unit of the jet's variable, as a series.
///
/// `None` where the position is the origin and has no direction. It is the derivative of the polar angle,
/// (x y' − y x') / (x² + y²): rational, so no inverse tangent is differentiated. The series has one order less than
/// the position: its highest coefficient means nothing.
pub fn angular_velocity<S: Field, const N: usize>(position: &Vector2<Jet<S, N>>) -> Option<Jet<S, N>> {
    let (x, y) = (position.x.clone(), position.y.clone());
    let square = x.clone() * x.clone() + y.clone() * y.clone();
    if square.value().is_zero() {
        return None;
    }
    Some((x.clone() * y.differentiated() - y * x.differentiated()) / square)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rational, rational};

    #[test]
    fn rational_points_lie_on_the_circle_and_add() {
        let a = Turn::from_half_tangent(&rational(1, 2));
        let b = Turn::from_half_tangent(&rational(-2, 7));
        for turn in [a.clone(), b.clone(), a.plus(&b), a.supplement(), b.reversed()] {
            assert_eq!(turn.cos.clone() * turn.cos + turn.sin.clone() * turn.sin, rational(1, 1));
        }
        assert_eq!(a.plus(&a.reversed()), Turn { cos: rational(1, 1), sin: rational(0, 1) });
    }

    #[test]
    fn a_moving_angle_stays_on_the_circle_to_every_order_carried() {
        let turn = Turn::<Rational>::from_half_tangent(&rational(3, 5)).moving::<6>(rational(7, 3));
        let norm = turn.cos.clone() * turn.cos + turn.sin.clone() * turn.sin;
        assert_eq!(norm, Jet::integer(1));
    }

    #[test]
    fn a_direction_turns_at_its_own_rate_and_the_origin_has_none() {
        let position = Turn::from_half_tangent(&rational(1, 3)).moving::<2>(rational(5, 2)).direction();
        let turning = angular_velocity(&position).expect("off the origin");
        assert_eq!(turning.value(), rational(5, 2));
        let origin = Vector2::<Jet<Rational, 2>>::zeros();
        assert_eq!(angular_velocity(&origin), None);
    }

    #[test]
    fn a_steady_motion_is_the_special_case_of_any() {
        let start = Turn::<Rational>::from_half_tangent(&rational(1, 7));
        let advance = Jet::from_coefficients([rational(9, 1), rational(2, 1), rational(3, 2), rational(0, 1)]);
        let moving = start.moving_by(&advance);
        // cos'' = −advance'' sin − advance'² cos.
        let second = -(rational(3, 1) * start.sin.clone()) - rational(4, 1) * start.cos.clone();
        assert_eq!(moving.cos.derivative(2), Some(second));
        assert_eq!(start.moving::<3>(rational(2, 1)).sin.rate(), rational(2, 1) * start.cos);
    }

    #[test]
    fn degrees_go_through_and_back() {
        for degrees in [-179.0, -45.0, 0.0, 30.0, 150.0, 180.0] {
            approx::assert_relative_eq!(Turn::from_degrees(degrees).degrees(), degrees, max_relative = 1e-15);
        }
    }

    #[test]
    fn cosine_and_sine_at_once_have_the_bits_of_each() {
        let steps = (-200_000..=200_000).map(|k| f64::from(k) * 1.7e-4);
        let powers = (-60..=60).flat_map(|k| [0.7, 0.9, 1.1, 1.3].map(|x: f64| x * f64::powi(2.0, k)));
        for angle in steps.chain(powers).chain([0.0, -0.0]) {
            let turn = Turn::from_radians(angle);
            let apart = [libm::cos(angle), libm::sin(angle)];
            assert_eq!([turn.cos, turn.sin].map(f64::to_bits), apart.map(f64::to_bits), "{angle}");
        }
    }
}
