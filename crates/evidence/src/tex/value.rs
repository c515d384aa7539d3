//! What a formula can come to: a number, or a vector.

use super::Illegible;
use super::number::Number;
use nalgebra::Vector2;

/// A number, or a vector of space.
#[derive(Clone, Debug, PartialEq)]
pub enum Value<N = f64> {
    /// A number.
    Number(N),
    /// A vector by its coordinates, the third out of the plane of the drawing.
    Vector([N; 3]),
}

impl<N: Number> Value<N> {
    /// An angular velocity or acceleration: a vector out of the plane.
    pub fn turning(rate: N) -> Self {
        Self::Vector([N::integer(0), N::integer(0), rate])
    }
}

impl<N: Number> From<N> for Value<N> {
    fn from(number: N) -> Self {
        Self::Number(number)
    }
}

/// A vector of the plane.
impl<N: Number> From<Vector2<N>> for Value<N> {
    fn from(vector: Vector2<N>) -> Self {
        let [[x, y]] = vector.data.0;
        Self::Vector([x, y, N::integer(0)])
    }
}

impl<N: Number> Value<N> {
    pub(super) fn number(self) -> Result<N, Illegible> {
        match self {
            Self::Number(number) => Ok(number),
            Self::Vector(_) => Err(Illegible("a vector where a number should be".to_owned())),
        }
    }

    pub(super) fn size(&self) -> f64 {
        match self {
            Self::Number(number) => number.size(),
            Self::Vector(parts) => parts.iter().map(|part| part.size() * part.size()).sum::<f64>().sqrt(),
        }
    }

    pub(super) fn times(self, factor: N) -> Self {
        match self {
            Self::Number(number) => Self::Number(number * factor),
            Self::Vector(vector) => Self::Vector(vector.map(|part| part * factor.clone())),
        }
    }

    pub(super) fn plus(self, other: Self) -> Result<Self, Illegible> {
        match (self, other) {
            (Self::Number(one), Self::Number(other)) => Ok(Self::Number(one + other)),
            (Self::Vector([a, b, c]), Self::Vector([x, y, z])) => Ok(Self::Vector([a + x, b + y, c + z])),
            // Nothing is nothing of either kind.
            (vector, Self::Number(zero)) | (Self::Number(zero), vector) if zero.size() == 0.0 => Ok(vector),
            _ => Err(Illegible("a number added to a vector".to_owned())),
        }
    }
}
