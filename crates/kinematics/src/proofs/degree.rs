//! How high a formula's degree can be, found by running the formula itself.

use crate::scalars::field::{Field, assign_from_binary};
use num_traits::{One, Zero};
use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Upper bounds of the degrees of a rational function's numerator and denominator, in each of `V` variables.
///
/// A formula run on degree bounds gives a bound for its own result; no one has to count by hand.
#[derive(Clone, Debug, PartialEq)]
pub struct DegreeBound<const V: usize> {
    /// Degree of the numerator in each variable.
    pub numerator: [u32; V],
    /// Degree of the denominator in each variable.
    pub denominator: [u32; V],
}

impl<const V: usize> DegreeBound<V> {
    /// The bound of the variable with this index.
    pub fn variable(index: usize) -> Self {
        Self { numerator: from_fn(|v| u32::from(v == index)), denominator: [0; V] }
    }

    fn constant() -> Self {
        Self { numerator: [0; V], denominator: [0; V] }
    }
}

impl<const V: usize> Add for DegreeBound<V> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            numerator: from_fn(|v| {
                (self.numerator[v] + other.denominator[v]).max(other.numerator[v] + self.denominator[v])
            }),
            denominator: from_fn(|v| self.denominator[v] + other.denominator[v]),
        }
    }
}

impl<const V: usize> Sub for DegreeBound<V> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "a difference has the degree of a sum")]
    fn sub(self, other: Self) -> Self {
        self + other
    }
}

impl<const V: usize> Neg for DegreeBound<V> {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}

impl<const V: usize> Mul for DegreeBound<V> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "degrees add where polynomials multiply")]
    fn mul(self, other: Self) -> Self {
        Self {
            numerator: from_fn(|v| self.numerator[v] + other.numerator[v]),
            denominator: from_fn(|v| self.denominator[v] + other.denominator[v]),
        }
    }
}

impl<const V: usize> Div for DegreeBound<V> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "division is multiplication by the inverse")]
    fn div(self, other: Self) -> Self {
        self * Self { numerator: other.denominator, denominator: other.numerator }
    }
}

assign_from_binary!([const V: usize] DegreeBound<V>);

impl<const V: usize> Zero for DegreeBound<V> {
    fn zero() -> Self {
        Self::constant()
    }
    /// Never known to be zero: a bound does not know the value.
    fn is_zero(&self) -> bool {
        false
    }
}

impl<const V: usize> One for DegreeBound<V> {
    fn one() -> Self {
        Self::constant()
    }
}

impl<const V: usize> Field for DegreeBound<V> {
    fn integer(_: i64) -> Self {
        Self::constant()
    }
    /// A bound has no value: not a number.
    fn approximate(&self) -> f64 {
        f64::NAN
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_of_the_circle_has_degree_two_over_two() {
        let turn = crate::Turn::from_half_tangent(&DegreeBound::<1>::variable(0));
        assert_eq!((turn.cos.numerator, turn.cos.denominator), ([2], [2]));
        assert_eq!((turn.sin.numerator, turn.sin.denominator), ([1], [2]));
    }

    #[test]
    fn each_variable_is_counted_by_itself() {
        let (x, y) = (DegreeBound::<2>::variable(0), DegreeBound::variable(1));
        let f = (x.clone() * x.clone() - y.clone()) / (x * y);
        assert_eq!((f.numerator, f.denominator), ([2, 1], [1, 1]));
    }
}
