//! The characters of an equation as an identity, proven without rounding.
//!
//! What is not rational in a display is given: sine and cosine, the half powers of one base, the sign that opens bars.
//! Then it is an [`Expression`], which has a value on any field, and [`geneva_kinematics::prove`] decides it for all
//! values of the letters.

use super::number::Number;
use super::tree::Function;
use super::{Display, Illegible, Moment};
use geneva_kinematics::{Expression, Field, Identity};

/// An expression has the four operations and whole powers, and no function.
impl Number for Expression {
    fn integer(n: i64) -> Self {
        <Self as Field>::integer(n)
    }

    fn pi() -> Option<Self> {
        None
    }

    fn size(&self) -> f64 {
        self.approximate()
    }

    fn apply(self, _: Function) -> Option<Self> {
        None
    }

    fn power(self, exponent: f64) -> Option<Self> {
        let whole = (0..=16).find(|whole| f64::from(*whole) == exponent)?;
        Some((0..whole).fold(Self::ONE, |product, _| product * self))
    }
}

/// An equation by its characters: left side minus right side, in the variables that its letters are made of.
pub struct Characters(Expression);

impl Characters {
    /// Reads an equation of two sides.
    ///
    /// # Errors
    ///
    /// If it cannot be read, if it has not two sides, or if a letter stands for nothing.
    pub fn read(tex: &str, letters: &Moment<Expression>) -> Result<Self, Illegible> {
        Display::read_line(tex)?.difference(letters).map(Self)
    }
}

impl<const V: usize> Identity<V> for Characters {
    fn difference(&self, _: [Expression; V]) -> Expression {
        self.0
    }
}
