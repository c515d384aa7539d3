//! Derivatives without a second, hand-derived formula: truncated power series.

use super::field::{Field, assign_from_binary};
use num_traits::{One, Zero};
use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The first `N` coefficients of a power series in one variable, the k-th being the k-th derivative over k!.
///
/// Running a formula on a jet gives the formula's value and its first `N - 1` derivatives, exactly if `S` is exact.
/// `N` must be at least 1.
///
/// ```
/// use geneva_exact::Jet;
///
/// let x = Jet::<f64, 3>::variable(2.0);
/// let cube = x * x * x;
/// assert_eq!(cube.value(), 8.0);
/// assert_eq!(cube.rate(), 12.0); // 3 x²
/// assert_eq!(cube.derivative(2), Some(12.0)); // 6 x
/// assert_eq!(cube.derivative(3), None); // not carried
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<S, const N: usize>([S; N]);

impl<S: Field, const N: usize> Jet<S, N> {
    /// A quantity that does not change: `value`, all derivatives zero.
    pub fn constant(value: S) -> Self {
        Self(from_fn(|k| if k == 0 { value.clone() } else { S::zero() }))
    }

    /// The variable itself at `value`: first derivative one, all others zero.
    pub fn variable(value: S) -> Self {
        Self(from_fn(|k| match k {
            0 => value.clone(),
            1 => S::one(),
            _ => S::zero(),
        }))
    }

    /// A series from its coefficients, lowest power first.
    #[inline]
    pub fn from_coefficients(coefficients: [S; N]) -> Self {
        Self(coefficients)
    }

    /// The value, in the unit of the quantity.
    #[inline]
    pub fn value(&self) -> S {
        self.0[0].clone()
    }

    /// The `order`-th derivative, in the unit of the quantity over that power of the variable's; zero beyond the last
    /// one carried is *not* implied: `None` there.
    pub fn derivative(&self, order: usize) -> Option<S> {
        let coefficient = self.0.get(order)?;
        Some((1..=order as i64).fold(coefficient.clone(), |product, k| product * S::integer(k)))
    }

    /// The coefficient of a power, in the unit of the quantity over that power of the variable's; zero beyond those
    /// carried.
    #[inline]
    pub fn coefficient(&self, power: usize) -> S {
        self.0.get(power).cloned().unwrap_or_else(S::zero)
    }

    /// The series of the derivative. Its highest coefficient would need one order more than is carried: zero stands
    /// there, and means nothing.
    pub fn differentiated(&self) -> Self {
        Self(from_fn(|k| self.coefficient(k + 1) * S::integer(k as i64 + 1)))
    }

    /// The first derivative, in the unit of the quantity over the variable's. A jet that carries none (`N` = 1) has no
    /// rate, and does not compile.
    pub fn rate(&self) -> S {
        const { assert!(N > 1, "a jet of one coefficient carries no derivative") }
        self.coefficient(1)
    }
}

impl<S: Field, const N: usize> Add for Jet<S, N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k].clone() + other.0[k].clone()))
    }
}

impl<S: Field, const N: usize> Sub for Jet<S, N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k].clone() - other.0[k].clone()))
    }
}

impl<S: Field, const N: usize> Neg for Jet<S, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|c| -c))
    }
}

impl<S: Field, const N: usize> Mul for Jet<S, N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(from_fn(|k| (0..=k).fold(S::zero(), |sum, i| sum + self.0[i].clone() * other.0[k - i].clone())))
    }
}

impl<S: Field, const N: usize> Div for Jet<S, N> {
    type Output = Self;
    /// Long division of series: `other * quotient = self`, solved from the lowest power up.
    fn div(self, other: Self) -> Self {
        let mut quotient: [S; N] = from_fn(|_| S::zero());
        for k in 0..N {
            let known = (0..k).fold(S::zero(), |sum, i| sum + quotient[i].clone() * other.0[k - i].clone());
            quotient[k] = (self.0[k].clone() - known) / other.0[0].clone();
        }
        Self(quotient)
    }
}

assign_from_binary!([S: Field, const N: usize] Jet<S, N>);

impl<S: Field, const N: usize> Zero for Jet<S, N> {
    fn zero() -> Self {
        Self::constant(S::zero())
    }
    fn is_zero(&self) -> bool {
        self.0.iter().all(S::is_zero)
    }
}

impl<S: Field, const N: usize> One for Jet<S, N> {
    fn one() -> Self {
        Self::constant(S::one())
    }
}

impl<S: Field, const N: usize> Field for Jet<S, N> {
    fn integer(n: i64) -> Self {
        Self::constant(S::integer(n))
    }
    fn approximate(&self) -> f64 {
        self.0[0].approximate()
    }
}
