//! Square roots without rounding: numbers a + b √D.

use super::field::{Field, assign_from_binary};
use num_traits::{One, Zero};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `a + b √D` over the field `S`, in which `D` must not be a square already.
///
/// Nested, it holds several roots: `Surd<Surd<Rational, 2>, 3>` has √2, √3 and √6.
///
/// ```
/// use geneva_exact::{Rational, Surd, rational};
///
/// let root = Surd::<Rational, 2>::root();
/// let one = Surd::from_plain(rational(1, 1));
/// assert_eq!((one.clone() + root.clone()) * (one.clone() - root.clone()), -one); // 1 − 2, exactly
/// assert_eq!(root.clone() * root, Surd::from_plain(rational(2, 1)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Surd<S, const D: u32> {
    /// The part without the root, in the number's own unit.
    pub plain: S,
    /// What stands before the root, in the number's own unit.
    pub rooted: S,
}

impl<S: Field, const D: u32> Surd<S, D> {
    /// The root √D itself.
    pub fn root() -> Self {
        Self { plain: S::zero(), rooted: S::one() }
    }

    /// The number `plain`, which has no part with the root.
    pub fn from_plain(plain: S) -> Self {
        Self { plain, rooted: S::zero() }
    }

    fn radicand() -> S {
        S::integer(i64::from(D))
    }
}

impl<S: Field, const D: u32> Add for Surd<S, D> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { plain: self.plain + other.plain, rooted: self.rooted + other.rooted }
    }
}

impl<S: Field, const D: u32> Sub for Surd<S, D> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { plain: self.plain - other.plain, rooted: self.rooted - other.rooted }
    }
}

impl<S: Field, const D: u32> Neg for Surd<S, D> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { plain: -self.plain, rooted: -self.rooted }
    }
}

impl<S: Field, const D: u32> Mul for Surd<S, D> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b, c, d) = (self.plain, self.rooted, other.plain, other.rooted);
        Self { plain: a.clone() * c.clone() + Self::radicand() * b.clone() * d.clone(), rooted: a * d + b * c }
    }
}

impl<S: Field, const D: u32> Div for Surd<S, D> {
    type Output = Self;
    /// By the conjugate: the norm a² − D b² is zero only for zero, √D not being in `S`.
    #[allow(clippy::suspicious_arithmetic_impl, reason = "division is multiplication by the conjugate over the norm")]
    fn div(self, other: Self) -> Self {
        let (a, b) = (other.plain, other.rooted);
        let norm = a.clone() * a.clone() - Self::radicand() * b.clone() * b.clone();
        let product = self * Self { plain: a, rooted: -b };
        Self { plain: product.plain / norm.clone(), rooted: product.rooted / norm }
    }
}

assign_from_binary!([S: Field, const D: u32] Surd<S, D>);

impl<S: Field, const D: u32> Zero for Surd<S, D> {
    fn zero() -> Self {
        Self::from_plain(S::zero())
    }
    fn is_zero(&self) -> bool {
        self.plain.is_zero() && self.rooted.is_zero()
    }
}

impl<S: Field, const D: u32> One for Surd<S, D> {
    fn one() -> Self {
        Self::from_plain(S::one())
    }
}

impl<S: Field, const D: u32> Field for Surd<S, D> {
    fn integer(n: i64) -> Self {
        Self::from_plain(S::integer(n))
    }
    fn approximate(&self) -> f64 {
        self.plain.approximate() + self.rooted.approximate() * f64::from(D).sqrt()
    }
}
