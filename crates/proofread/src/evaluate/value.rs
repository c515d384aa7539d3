//! The value of a side: an interval or the components of a vector, with a dimension and what is known of its origin.

use crate::evaluate::interval::Interval;
use crate::unit::UnitDimension;

/// Why a side could not be evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Obstacle {
    /// A letter with no value.
    Letter(String),
    /// A word that is no unit.
    Word(String),
    /// Something whose meaning is not known, in words.
    Unclear(&'static str),
    /// Terms of different dimensions, or with a unit and without one, are added.
    MixedSum,
    /// It has no value, as a root of a negative number has none among the real ones, in words.
    NoValue(&'static str),
    /// There is no number.
    NoNumber,
    /// It is nested or long beyond what is read.
    TooLarge,
}

impl std::fmt::Display for Obstacle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Letter(name) => write!(f, "the letter {name} has no value"),
            Self::Word(word) => write!(f, "`{word}` is no known unit"),
            Self::Unclear(what) | Self::NoValue(what) => f.write_str(what),
            Self::MixedSum => f.write_str("terms of different units are added"),
            Self::NoNumber => f.write_str("there is no number"),
            Self::TooLarge => f.write_str("it is too long or nested too deeply"),
        }
    }
}

/// Why a quotient has no value.
pub(crate) const DIVIDES_BY_ZERO: &str = "it divides by zero";

/// Why a root has no value among the real numbers.
pub(crate) const NEGATIVE_ROOT: &str = "it takes a root of a negative number";

/// A value, or why there is none.
pub(crate) type Evaluated<T> = Result<T, Obstacle>;

/// A scalar at 0, and components along i, j and k at 1 to 3.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Parts(pub [Option<Interval>; 4]);

impl Parts {
    pub(crate) fn scalar(of: Interval) -> Self {
        Self([Some(of), None, None, None])
    }

    pub(crate) fn is_vector(&self) -> bool {
        self.0[1..].iter().any(Option::is_some)
    }

    pub(crate) fn map(&self, change: impl Fn(Interval) -> Interval) -> Self {
        Self(self.0.map(|part| part.map(&change)))
    }

    /// The components of both, side by side, where either has one.
    pub(crate) fn pairs(&self, other: &Self) -> impl Iterator<Item = (Interval, Interval)> {
        let (mine, its) = (self.0, other.0);
        mine.into_iter()
            .zip(its)
            .filter(|(a, b)| a.is_some() || b.is_some())
            .map(|(a, b)| (a.unwrap_or_default(), b.unwrap_or_default()))
    }

    fn add(&mut self, at: usize, what: Interval) {
        self.0[at] = Some(self.0[at].map_or(what, |so_far| so_far + what));
    }
}

/// Where a value without operations comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Literal {
    /// It is computed.
    #[default]
    No,
    /// A number, with or without a unit.
    Number,
    /// A unit alone.
    Unit,
}

/// How an angle says that it is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AngleUnit {
    Degrees,
    Radians,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SideValue {
    pub parts: Parts,
    pub dimension: UnitDimension,
    pub has_unit: bool,
    pub angle: Option<AngleUnit>,
    pub operations: u32,
    pub bound: bool,
    pub literal: Literal,
    /// Whether its components are those of a tuple, an interval or a column.
    pub is_tuple: bool,
    /// How many base units of the SI one unit of the printed number is.
    pub factor: f64,
}

impl SideValue {
    pub(crate) fn from_interval(interval: Interval) -> Self {
        Self { parts: Parts::scalar(interval), factor: 1.0, ..Self::default() }
    }

    /// The one number that it is.
    pub(crate) fn number(&self) -> Evaluated<Interval> {
        if self.parts.is_vector() {
            return Err(Obstacle::Unclear("a vector that stands where a number is needed"));
        }
        Ok(self.parts.0[0].unwrap_or_default())
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.parts.0.iter().flatten().all(|part| part.is_zero())
    }

    pub(crate) fn is_zero_at_point(&self) -> bool {
        self.parts.0.iter().flatten().all(|part| part.point == 0.0)
    }

    /// Whether it is printed as one number and not computed.
    pub(crate) fn is_literal(&self) -> bool {
        self.operations == 0
    }

    /// Whether one of two values has a unit and the other one has none, so that it was left out there. Angles have one without a sign.
    pub(crate) fn is_one_a_quantity(values: &[Self; 2]) -> bool {
        values[0].has_unit != values[1].has_unit
            && values.iter().all(|value| value.angle.is_none() && !value.parts.is_vector())
    }

    /// Makes a bare number of the value, as it is written.
    pub(crate) fn drop_unit(&mut self) {
        (self.has_unit, self.dimension, self.factor) = (false, UnitDimension::NONE, 1.0);
    }

    pub(crate) fn negate(self) -> Self {
        Self { parts: self.parts.map(|part| -part), ..self }
    }

    fn combined(&self, other: &Self, operations: u32) -> Self {
        Self {
            parts: Parts::default(),
            dimension: self.dimension,
            has_unit: self.has_unit || other.has_unit,
            angle: self.angle.or(other.angle),
            operations: (self.operations + other.operations).saturating_add(operations),
            bound: self.bound || other.bound,
            literal: Literal::No,
            is_tuple: self.is_tuple || other.is_tuple,
            factor: 1.0,
        }
    }

    /// The tuple of two or three numbers.
    pub(crate) fn from_components(values: &[Self]) -> Evaluated<Self> {
        let Some(first) = values.first().filter(|_| values.len() <= 3) else {
            return Err(Obstacle::Unclear("a list of more than three numbers"));
        };
        let mut tuple = Self { parts: Parts::default(), is_tuple: true, ..first.clone() };
        for (at, value) in values.iter().enumerate() {
            let zero = value.is_zero() && !value.has_unit;
            if value.dimension != first.dimension && !zero {
                return Err(Obstacle::MixedSum);
            }
            tuple.parts.0[at + 1] = Some(value.number()?);
            tuple.has_unit |= value.has_unit;
            if at > 0 {
                tuple.operations = tuple.operations.saturating_add(value.operations);
            }
            if value.literal != Literal::Number {
                tuple.literal = Literal::No;
            }
        }
        Ok(tuple)
    }

    /// The sum; `loosely` adds whatever the units are.
    pub(crate) fn sum(&self, other: &Self, loosely: bool) -> Evaluated<Self> {
        if self.dimension != other.dimension && !loosely && !self.is_zero() && !other.is_zero() {
            return Err(Obstacle::MixedSum);
        }
        if self.is_tuple != other.is_tuple {
            return Err(Obstacle::Unclear("a number added to a list"));
        }
        let parts = &mut Parts::default();
        for (at, (mine, its)) in self.parts.0.iter().zip(other.parts.0).enumerate() {
            mine.iter().copied().chain(its).for_each(|part| parts.add(at, part));
        }
        let alike = self.parts.0.iter().zip(other.parts.0).any(|(mine, its)| mine.is_some() && its.is_some());
        let mut sum = self.combined(other, u32::from(alike));
        sum.parts = *parts;
        let takes_its = (self.is_zero() && !other.dimension.is_none()) || !self.has_unit;
        sum.dimension = if takes_its { other.dimension } else { self.dimension };
        if !alike {
            sum.factor = self.factor;
        }
        Ok(sum)
    }

    /// The product; `sign` tells a dot product of vectors from a cross product, and `counts` whether it is an operation.
    pub(crate) fn product(&self, other: &Self, sign: Option<char>, counts: bool) -> Evaluated<Self> {
        let mut product = self.combined(other, u32::from(counts));
        product.dimension = self.dimension.with_factor(other.dimension, 1.0);
        let both = self.parts.is_vector() && other.parts.is_vector();
        if both && sign.is_none() {
            return Err(Obstacle::Unclear("a product of vectors without a sign"));
        }
        // It may be one of complex numbers, of sets or of whatever the text defines.
        let is_pair = |of: &Self| of.is_tuple && of.parts.0[1..].iter().flatten().count() == 2;
        if sign == Some('×') && is_pair(self) && is_pair(other) {
            return Err(Obstacle::Unclear("a product of pairs"));
        }
        for (a, mine) in self.parts.0.iter().enumerate() {
            for (b, its) in other.parts.0.iter().enumerate() {
                let (Some(mine), Some(its)) = (*mine, *its) else { continue };
                let part = mine * its;
                match (a, b) {
                    (0, at) | (at, 0) => product.parts.add(at, part),
                    (a, b) if sign == Some('·') && a == b => product.parts.add(0, part),
                    (a, b) if sign == Some('×') && a != b => {
                        let cyclic = a % 3 + 1 == b;
                        product.parts.add(6 - a - b, if cyclic { part } else { -part });
                    }
                    _ => {}
                }
            }
        }
        if both && product.parts == Parts::default() {
            product.parts = Parts::scalar(Interval::exact(0.0));
        }
        product.is_tuple &= product.parts.is_vector();
        Ok(product)
    }

    pub(crate) fn quotient(&self, other: &Self) -> Evaluated<Self> {
        let below = other.number()?;
        if below.is_zero() && !self.is_zero_at_point() {
            return Err(Obstacle::NoValue(DIVIDES_BY_ZERO));
        }
        let below = below.inverse().ok_or(Obstacle::Unclear("a division by what may be zero"))?;
        let mut quotient = self.combined(other, 1);
        quotient.dimension = self.dimension.with_factor(other.dimension, -1.0);
        quotient.parts = self.parts.map(|part| part * below);
        Ok(quotient)
    }

    pub(crate) fn power(&self, exponent: Interval) -> Evaluated<Self> {
        let base = self.number()?;
        let is_exact = base.low == base.high && exponent.low == exponent.high;
        // A root with an odd index has a negative value there.
        let odd_root =
            (base.high < 0.0 && exponent.point.fract() != 0.0).then(|| odd_fraction(exponent.point)).flatten();
        let raised = match odd_root {
            Some(numerator) => (-base).power(exponent).map(|root| if numerator % 2 == 0 { root } else { -root }),
            None if is_exact && base.point < 0.0 && exponent.point.fract().abs() > 1e-3 => {
                return Err(Obstacle::NoValue(NEGATIVE_ROOT));
            }
            None => base.power(exponent),
        };
        let raised = raised.ok_or(Obstacle::Unclear("a power that is no number"))?;
        Ok(Self {
            parts: Parts::scalar(raised),
            dimension: self.dimension.power(exponent.point),
            operations: self.operations + 1,
            literal: Literal::No,
            factor: 1.0,
            ..self.clone()
        })
    }

    /// The factorial of a small integer.
    pub(crate) fn factorial(&self) -> Evaluated<Self> {
        let n = self.number()?.point;
        if n.fract() != 0.0 || !(0.0..=170.0).contains(&n) || self.has_unit {
            return Err(Obstacle::Unclear("a factorial of what is no small integer"));
        }
        let product = (1..=n as u32).map(f64::from).product();
        Ok(Self { operations: self.operations + 1, ..Self::from_interval(Interval::exact(product)) })
    }

    /// Its number times a factor, as if by a unit.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self { parts: self.parts.map(|part| part.scaled(factor)), factor: self.factor * factor, ..self.clone() }
    }

    /// Whether all components of both meet if widened by `width`.
    pub(crate) fn meets(&self, other: &Self, width: f64) -> bool {
        self.parts.pairs(&other.parts).all(|(a, b)| a.meets(b, width))
    }

    /// The greatest difference of the points, relative to the larger one, dimensionless.
    pub(crate) fn difference(&self, other: &Self) -> f64 {
        let relative =
            |(a, b): (Interval, Interval)| (a.point - b.point).abs() / a.point.abs().max(b.point.abs()).max(1e-300);
        self.parts.pairs(&other.parts).map(relative).fold(0.0, f64::max)
    }
}

/// The numerator of an exponent that is a fraction with a small odd denominator.
fn odd_fraction(exponent: f64) -> Option<i64> {
    let denominators = (3..100).step_by(2).map(f64::from);
    let numerator = |denominator: f64| {
        let numerator = exponent * denominator;
        ((numerator - libm::round(numerator)).abs() < 1e-12 * denominator).then(|| libm::round(numerator) as i64)
    };
    { denominators }.find_map(numerator)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(i: f64, j: f64, k: f64) -> SideValue {
        let parts = Parts([None, Some(Interval::exact(i)), Some(Interval::exact(j)), Some(Interval::exact(k))]);
        SideValue { parts, ..SideValue::from_interval(Interval::exact(0.0)) }
    }

    #[test]
    fn cross_and_dot_products_have_their_signs() {
        let (x, y) = (vector(1.0, 2.0, 3.0), vector(4.0, 5.0, 6.0));
        let dot = x.product(&y, Some('·'), true).expect("a product");
        assert_eq!(dot.number().expect("a number").point, 32.0);
        let cross = x.product(&y, Some('×'), true).expect("a product");
        assert_eq!(cross.parts.0.map(|part| part.map(|of| of.point)), [None, Some(-3.0), Some(6.0), Some(-3.0)]);
        assert!(x.product(&y, None, true).is_err());
    }
}
