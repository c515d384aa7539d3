//! Dimensions of quantities, for equations whose letters are in doubt.

use std::fmt;
use std::ops::{Div, Mul};

/// Exponents of length and time; angles have no dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    /// Exponent of length.
    pub length: i32,
    /// Exponent of time.
    pub time: i32,
}

impl Dimension {
    /// A length.
    pub const LENGTH: Self = Self { length: 1, time: 0 };
    /// A speed: length over time.
    pub const SPEED: Self = Self { length: 1, time: -1 };
    /// An angular speed: one over time.
    pub const ANGULAR_SPEED: Self = Self { length: 0, time: -1 };
}

impl Mul for Dimension {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { length: self.length + other.length, time: self.time + other.time }
    }
}

impl Div for Dimension {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self { length: self.length - other.length, time: self.time - other.time }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "L^{} T^{}", self.length, self.time)
    }
}

#[cfg(test)]
mod tests {
    use super::Dimension as D;

    #[test]
    fn a_speed_is_a_length_times_an_angular_speed() {
        assert_eq!(D::LENGTH * D::ANGULAR_SPEED, D::SPEED);
        assert_eq!(D::SPEED / D::LENGTH, D::ANGULAR_SPEED);
        assert_ne!(D::LENGTH * D::SPEED, D::SPEED);
    }
}
