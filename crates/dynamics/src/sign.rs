//! A sign that stands for an absolute value: |x| is x with the plus sign or x with the minus sign.

use geneva_kinematics::Field;

/// Plus or minus one.
///
/// ```
/// use geneva_dynamics::Sign;
///
/// let torque: f64 = -3.0; // N m
/// assert_eq!(Sign::from_number(torque).apply(torque), torque.abs());
/// assert_eq!(Sign::Minus.times(Sign::Minus), Sign::Plus);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sign {
    /// +1.
    Plus,
    /// −1.
    Minus,
}

impl Sign {
    /// Both signs.
    pub const BOTH: [Self; 2] = [Self::Plus, Self::Minus];

    /// `value` with this sign before it, in its own unit.
    #[inline]
    pub fn apply<S: Field>(self, value: S) -> S {
        match self {
            Self::Plus => value,
            Self::Minus => -value,
        }
    }

    /// The sign of a number; plus for zero and for what is not a number.
    #[inline]
    pub fn from_number(number: f64) -> Self {
        if number < 0.0 { Self::Minus } else { Self::Plus }
    }

    /// Product of two signs.
    pub fn times(self, other: Self) -> Self {
        if self == other { Self::Plus } else { Self::Minus }
    }
}
