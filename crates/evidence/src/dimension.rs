//! Dimensions of quantities, for equations whose letters are in doubt.

use std::fmt;
use std::ops::{Div, Mul};

/// Exponents of length, time and force; angles have no dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    /// Exponent of length.
    pub length: i32,
    /// Exponent of time.
    pub time: i32,
    /// Exponent of force.
    pub force: i32,
}

impl Dimension {
    /// A pure number.
    pub const NONE: Self = Self { length: 0, time: 0, force: 0 };
    /// A force.
    pub const FORCE: Self = Self { length: 0, time: 0, force: 1 };
    /// A time.
    pub const TIME: Self = Self { length: 0, time: 1, force: 0 };
    /// A length.
    pub const LENGTH: Self = Self { length: 1, time: 0, force: 0 };
    /// A speed: length over time.
    pub const SPEED: Self = Self { length: 1, time: -1, force: 0 };
    /// An angular speed: one over time.
    pub const ANGULAR_SPEED: Self = Self { length: 0, time: -1, force: 0 };
    /// An angular acceleration: one over the square of time.
    pub const ANGULAR_ACCELERATION: Self = Self { length: 0, time: -2, force: 0 };
}

impl Mul for Dimension {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { length: self.length + other.length, time: self.time + other.time, force: self.force + other.force }
    }
}

impl Div for Dimension {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self { length: self.length - other.length, time: self.time - other.time, force: self.force - other.force }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let power = |name: &str, exponent: i32| match exponent.unsigned_abs() {
            0 => None,
            1 => Some(name.to_owned()),
            n => Some(format!("{name}^{n}")),
        };
        let parts = [("force", self.force), ("length", self.length), ("time", self.time)];
        let side = |above: bool| -> Vec<String> {
            parts.iter().filter(|(_, e)| (*e > 0) == above).filter_map(|(name, e)| power(name, *e)).collect()
        };
        match (side(true).join(" "), side(false).join(" ")) {
            (above, below) if above.is_empty() && below.is_empty() => f.write_str("a pure number"),
            (above, below) if below.is_empty() => f.write_str(&above),
            (above, below) if above.is_empty() => write!(f, "1/{below}"),
            (above, below) => write!(f, "{above}/{below}"),
        }
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

    #[test]
    fn dimensions_are_written_as_they_are_said() {
        let written = [D::NONE, D::SPEED, D::ANGULAR_ACCELERATION, D::LENGTH * D::SPEED, D::FORCE * D::LENGTH];
        let expected = ["a pure number", "length/time", "1/time^2", "length^2/time", "force length"];
        assert_eq!(written.map(|d| d.to_string()), expected);
    }
}
