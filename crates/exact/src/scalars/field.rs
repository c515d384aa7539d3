//! What a formula may ask of its numbers: the four operations, nothing else.

use dashu_ratio::{RBig, Relaxed};
use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_traits::{One, Zero};
use std::ops::Neg;

/// A field: numbers with the four operations, fit for nalgebra's vectors.
///
/// No order, no roots and no transcendental functions: whoever needs those says so by asking for `f64`.
///
/// ```
/// use geneva_exact::{Field, rational};
///
/// /// What is left of a ratio when one is taken away.
/// fn excess<S: Field>(ratio: &S) -> S {
///     ratio.clone() - S::one()
/// }
/// assert_eq!(excess(&2.5), 1.5);
/// assert_eq!(excess(&rational(4, 3)), rational(1, 3)); // without rounding
/// ```
pub trait Field:
    Scalar + Zero + One + ClosedAddAssign + ClosedSubAssign + ClosedMulAssign + ClosedDivAssign + Neg<Output = Self>
{
    /// The integer `n` as a number of this field.
    fn integer(n: i64) -> Self;

    /// The nearest `f64`, for display and for comparison with floating-point routes.
    fn approximate(&self) -> f64;
}

impl Field for f64 {
    #[inline]
    fn integer(n: i64) -> Self {
        n as f64
    }

    #[inline]
    fn approximate(&self) -> f64 {
        *self
    }
}

impl Field for RBig {
    fn integer(n: i64) -> Self {
        RBig::from(n)
    }

    fn approximate(&self) -> f64 {
        self.to_f64().value()
    }
}

/// Fractions that are not reduced at every step: the same numbers as [`RBig`], faster where little is computed.
impl Field for Relaxed {
    fn integer(n: i64) -> Self {
        Relaxed::from(n)
    }

    fn approximate(&self) -> f64 {
        self.to_f64().value()
    }
}

/// The exact fraction `numerator / denominator`; `denominator` must not be zero.
///
/// ```
/// use geneva_exact::{Field, rational};
///
/// assert_eq!(rational(1, 3) + rational(1, 6), rational(1, 2));
/// assert_eq!(rational(2, -4).approximate(), -0.5);
/// ```
pub fn rational(numerator: i64, denominator: i64) -> RBig {
    RBig::from(numerator) / RBig::from(denominator)
}

/// Writes `a += b` and its three sisters from `a + b` and its own, for a type that is a field.
macro_rules! assign_from_binary {
    ([$($generics:tt)*] $type:ty) => {
        impl<$($generics)*> std::ops::AddAssign for $type {
            fn add_assign(&mut self, other: Self) {
                *self = self.clone() + other;
            }
        }
        impl<$($generics)*> std::ops::SubAssign for $type {
            fn sub_assign(&mut self, other: Self) {
                *self = self.clone() - other;
            }
        }
        impl<$($generics)*> std::ops::MulAssign for $type {
            fn mul_assign(&mut self, other: Self) {
                *self = self.clone() * other;
            }
        }
        impl<$($generics)*> std::ops::DivAssign for $type {
            fn div_assign(&mut self, other: Self) {
                *self = self.clone() / other;
            }
        }
    };
}
pub(crate) use assign_from_binary;
