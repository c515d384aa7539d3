//! An angle as the pair of its cosine and sine.

use super::field::Field;
use super::jet::Jet;
use nalgebra::Vector2;
use std::array::from_fn;

/// A direction in the plane: cosine and sine of an angle measured counter-clockwise.
///
/// As a pair, an angle needs no transcendental function: sums, half turns and motions are polynomials, and points of
/// the circle with rational cosine and sine are exact.
///
/// ```
/// use geneva_exact::{Turn, rational};
///
/// let turn = Turn::from_half_tangent(&rational(1, 2)); // the triangle of 3, 4 and 5
/// assert_eq!((turn.cos.clone(), turn.sin.clone()), (rational(3, 5), rational(4, 5)));
/// assert_eq!(turn.plus(&turn.reversed()), Turn { cos: rational(1, 1), sin: rational(0, 1) });
/// assert!((Turn::from_degrees(50.0).plus(&Turn::from_degrees(40.0)).degrees() - 90.0).abs() < 1e-13);
/// ```
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

    /// This angle with the opposite sign.
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
    #[inline]
    pub fn direction(&self) -> Vector2<S> {
        Vector2::new(self.cos.clone(), self.sin.clone())
    }

    /// The angle moving at `rate` (radians per unit of the jet's variable), as a power series from this instant on.
    ///
    /// ```
    /// use geneva_exact::{Turn, rational};
    ///
    /// // At 3 radians per unit of time the sine grows by 3 times the cosine.
    /// let turn = Turn::from_half_tangent(&rational(1, 2)); // cosine 3/5
    /// assert_eq!(turn.moving::<2>(rational(3, 1)).sin.rate(), rational(9, 5));
    /// ```
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
    #[inline]
    pub fn from_radians(radians: f64) -> Self {
        // Both at once, to the same bits as one by one: the reduction to an eighth of the circle is made for both.
        let (sin, cos) = libm::sincos(radians);
        Self { cos, sin }
    }

    /// The angle of so many degrees, by way of radians.
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
///
/// ```
/// use geneva_exact::{Jet, angular_velocity};
/// use nalgebra::Vector2;
///
/// // A point that passes the origin at a distance of 2 m with 6 m/s turns about it at 3 rad/s.
/// let position = Vector2::new(Jet::<f64, 2>::constant(2.0), Jet::from_coefficients([0.0, 6.0]));
/// assert_eq!(angular_velocity(&position).map(|of| of.value()), Some(3.0));
/// ```
pub fn angular_velocity<S: Field, const N: usize>(position: &Vector2<Jet<S, N>>) -> Option<Jet<S, N>> {
    let (x, y) = (position.x.clone(), position.y.clone());
    let square = x.clone() * x.clone() + y.clone() * y.clone();
    if square.value().is_zero() {
        return None;
    }
    Some((x.clone() * y.differentiated() - y * x.differentiated()) / square)
}
