//! How high a formula's degree can be, found by running the formula itself.

use super::expression::Expression;
use crate::scalars::field::{Field, assign_from_binary};
use num_traits::{One, Zero};
use std::array::from_fn;
use std::collections::BTreeMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What was divided by: each divisor with its power and the degrees of its own numerator.
type Divisors<const V: usize> = BTreeMap<Expression, (u32, [u32; V])>;

/// Upper bound of the degree, in each of `V` variables, of a rational function's numerator over a known denominator.
///
/// A formula run on degree bounds gives a bound for its own result; no one has to count by hand. The bound remembers
/// what was divided by, expression by expression. So fractions over the same divisor are added over that divisor, and
/// a divisor cancels when it is multiplied by; the bound stays low, and it stays a bound.
#[derive(Clone, Debug, PartialEq)]
pub struct DegreeBound<const V: usize> {
    expression: Expression,
    numerator: [u32; V],
    divisors: Divisors<V>,
}

impl<const V: usize> DegreeBound<V> {
    /// The bound of the variable with this index.
    pub fn variable(index: usize) -> Self {
        let numerator = from_fn(|v| u32::from(v == index));
        Self { expression: Expression::variable(index), numerator, divisors: BTreeMap::new() }
    }

    /// The bound of a root that stands in an identity: a constant, but not one of the whole numbers.
    pub fn root() -> Self {
        Self { expression: Expression::root(), numerator: [0; V], divisors: BTreeMap::new() }
    }

    /// Degree of the numerator in each variable, at most.
    pub fn numerator(&self) -> [u32; V] {
        self.numerator
    }

    /// Degree of the denominator in each variable, at most.
    pub fn denominator(&self) -> [u32; V] {
        self.divisors.values().fold([0; V], |sum, (power, degrees)| from_fn(|v| sum[v] + power * degrees[v]))
    }

    fn constant(n: i64) -> Self {
        Self { expression: Expression::integer(n), numerator: [0; V], divisors: BTreeMap::new() }
    }

    /// Both numerators over the least common denominator, and that denominator.
    fn over_common(&self, other: &Self) -> ([u32; V], [u32; V], Divisors<V>) {
        let mut common = self.divisors.clone();
        for (divisor, (power, degrees)) in &other.divisors {
            let entry = common.entry(*divisor).or_insert((0, *degrees));
            entry.0 = entry.0.max(*power);
        }
        let raised = |bound: &Self| {
            common.iter().fold(bound.numerator, |sum, (divisor, (power, degrees))| {
                let missing = power - bound.divisors.get(divisor).map_or(0, |(power, _)| *power);
                from_fn(|v| sum[v] + missing * degrees[v])
            })
        };
        (raised(self), raised(other), common)
    }
}

impl<const V: usize> Add for DegreeBound<V> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let (a, b, divisors) = self.over_common(&other);
        let expression = self.expression.plus(other.expression);
        Self { expression, numerator: from_fn(|v| a[v].max(b[v])), divisors }
    }
}

impl<const V: usize> Sub for DegreeBound<V> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const V: usize> Neg for DegreeBound<V> {
    type Output = Self;
    fn neg(self) -> Self {
        if self.is_zero() { self } else { Self { expression: self.expression.negated(), ..self } }
    }
}

impl<const V: usize> Mul for DegreeBound<V> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_one() {
            return self;
        }
        if other.is_zero() || self.is_one() {
            return other;
        }
        let mut divisors = self.divisors;
        for (divisor, (power, degrees)) in other.divisors {
            divisors.entry(divisor).or_insert((0, degrees)).0 += power;
        }
        let mut product = Self {
            expression: self.expression.times(other.expression),
            numerator: from_fn(|v| self.numerator[v] + other.numerator[v]),
            divisors,
        };
        // A factor that was divided by cancels, if its own numerator is all of it.
        for factor in [self.expression, other.expression] {
            if let Some((power, degrees)) = product.divisors.get_mut(&factor) {
                let degrees = *degrees;
                *power -= 1;
                if *power == 0 {
                    product.divisors.remove(&factor);
                }
                product.numerator = from_fn(|v| product.numerator[v] - degrees[v]);
            }
        }
        product
    }
}

impl<const V: usize> Div for DegreeBound<V> {
    type Output = Self;
    /// Over the other's numerator, which becomes a divisor; times the other's divisors.
    fn div(self, other: Self) -> Self {
        if self.is_zero() || other.is_one() {
            return self;
        }
        let mut divisors = self.divisors;
        let mut numerator = self.numerator;
        for (divisor, (power, degrees)) in &other.divisors {
            // What both are divided by cancels; the rest of it multiplies the numerator.
            let shared = divisors.get(divisor).map_or(0, |(mine, _)| *mine.min(power));
            if let Some(entry) = divisors.get_mut(divisor) {
                entry.0 -= shared;
            }
            numerator = from_fn(|v| numerator[v] + (power - shared) * degrees[v]);
        }
        divisors.retain(|_, (power, _)| *power > 0);
        divisors.entry(other.expression).or_insert((0, other.numerator)).0 += 1;
        Self { expression: self.expression.over(other.expression), numerator, divisors }
    }
}

assign_from_binary!([const V: usize] DegreeBound<V>);

impl<const V: usize> Zero for DegreeBound<V> {
    fn zero() -> Self {
        Self::constant(0)
    }
    /// Only the constant zero is known to be zero: a bound does not know values.
    fn is_zero(&self) -> bool {
        self.expression == Expression::integer(0)
    }
}

impl<const V: usize> One for DegreeBound<V> {
    fn one() -> Self {
        Self::constant(1)
    }
}

impl<const V: usize> Field for DegreeBound<V> {
    fn integer(n: i64) -> Self {
        Self::constant(n)
    }
    /// A bound has no value: not a number.
    fn approximate(&self) -> f64 {
        f64::NAN
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Turn;

    type One1 = DegreeBound<1>;

    #[test]
    fn a_point_of_the_circle_has_degree_two_over_two() {
        let turn = Turn::from_half_tangent(&One1::variable(0));
        assert_eq!((turn.cos.numerator(), turn.cos.denominator()), ([2], [2]));
        assert_eq!((turn.sin.numerator(), turn.sin.denominator()), ([1], [2]));
    }

    #[test]
    fn fractions_over_one_divisor_keep_it() {
        let turn = Turn::from_half_tangent(&One1::variable(0));
        let sum = turn.cos.clone() + turn.sin.clone();
        assert_eq!((sum.numerator(), sum.denominator()), ([2], [2]));
        let product = turn.cos.clone() * turn.sin + turn.cos;
        assert_eq!((product.numerator(), product.denominator()), ([4], [4]));
    }

    #[test]
    fn a_divisor_that_is_multiplied_by_cancels() {
        let x = One1::variable(0);
        let divisor = x.clone() * x.clone() + One1::one();
        let back = x.clone() / divisor.clone() * divisor.clone();
        assert_eq!((back.numerator(), back.denominator()), ([1], [0]));
        let quotient = (x.clone() / divisor.clone()) / (One1::one() / divisor);
        assert_eq!((quotient.numerator(), quotient.denominator()), ([1], [0]));
    }

    #[test]
    fn each_variable_is_counted_by_itself() {
        let (x, y) = (DegreeBound::<2>::variable(0), DegreeBound::variable(1));
        let f = (x.clone() * x.clone() - y.clone()) / (x * y);
        assert_eq!((f.numerator(), f.denominator()), ([2, 1], [1, 1]));
    }

    #[test]
    fn nothing_is_lost_by_adding_zero_or_multiplying_by_one() {
        let x = One1::variable(0);
        let y = One1::one() / x.clone();
        assert_eq!(y.clone() + One1::zero(), y);
        assert_eq!(One1::one() * y.clone(), y);
        assert!((y * One1::zero()).is_zero());
    }
}
