//! The characters of an equation as an identity, proven without rounding.
//!
//! What is not rational in a display is given: sine and cosine, the half powers of one base, the sign that opens bars.
//! Then it is an expression over any [`Field`], and [`geneva_kinematics::prove`] decides it for all values of the
//! letters.

use super::number::Number;
use super::tree::Function;
use super::{Display, Illegible, Moment};
use geneva_kinematics::{Field, Identity};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of a field: it has the four operations and whole powers, and no function.
#[derive(Clone, Debug, PartialEq)]
pub struct Exact<S>(pub S);

macro_rules! operations {
    ($($operation:ident $name:ident),*) => {$(
        impl<S: Field> $operation for Exact<S> {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                Self(self.0.$name(other.0))
            }
        }
    )*};
}
operations!(Add add, Sub sub, Mul mul, Div div);

impl<S: Field> Neg for Exact<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Field> Number for Exact<S> {
    fn integer(n: i64) -> Self {
        Self(S::integer(n))
    }

    fn pi() -> Option<Self> {
        None
    }

    fn size(&self) -> f64 {
        self.0.approximate().abs()
    }

    fn apply(self, _: Function) -> Option<Self> {
        None
    }

    fn power(self, exponent: f64) -> Option<Self> {
        let whole = (0..=16).find(|whole| f64::from(*whole) == exponent)?;
        Some((0..whole).fold(Self::integer(1), |product, _| product * self.clone()))
    }
}

/// What the letters of a display stand for, as functions of `V` free variables over any field.
pub trait ExactLetters<const V: usize> {
    /// The letters for these values of the variables.
    fn at<S: Field>(&self, variables: &[S; V]) -> Moment<Exact<S>>;
}

/// An equation by its characters, with what its letters stand for.
pub struct Characters<'a, L> {
    display: Display,
    letters: &'a L,
}

impl<'a, L> Characters<'a, L> {
    /// Reads an equation of two sides.
    ///
    /// # Errors
    ///
    /// If it cannot be read, if it has not two sides, or if a letter stands for nothing.
    pub fn read<const V: usize>(tex: &str, letters: &'a L) -> Result<Self, Illegible>
    where
        L: ExactLetters<V>,
    {
        let display = Display::read_line(tex)?;
        // On real numbers first: what has a value there has one on every field.
        display.difference(&letters.at(&[1.0; V]))?;
        Ok(Self { display, letters })
    }
}

impl<const V: usize, L: ExactLetters<V>> Identity<V> for Characters<'_, L> {
    fn difference<S: Field>(&self, variables: &[S; V]) -> S {
        // Whatever cannot be evaluated has been refused by `read`; it would be no identity.
        self.display.difference(&self.letters.at(variables)).map_or(S::one(), |difference| difference.0)
    }
}
