//! What a letter may stand for: a real number, or a complex one for an angle whose cosine is greater than one.

use nalgebra::Complex;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Numbers with the functions that the displays need.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self> + 'static
{
    /// A real number.
    fn real(number: f64) -> Self;
    /// Its size; not finite if it is no number.
    fn size(self) -> f64;
    /// Raised to a power.
    fn power(self, exponent: Self) -> Self;
    /// Its sine.
    fn sine(self) -> Self;
    /// Its cosine.
    fn cosine(self) -> Self;
    /// The angle with this sine.
    fn arc_sine(self) -> Self;
    /// The angle with this cosine.
    fn arc_cosine(self) -> Self;
}

impl Number for f64 {
    fn real(number: f64) -> Self {
        number
    }

    fn size(self) -> f64 {
        self.abs()
    }

    fn power(self, exponent: Self) -> Self {
        libm::pow(self, exponent)
    }

    fn sine(self) -> Self {
        libm::sin(self)
    }

    fn cosine(self) -> Self {
        libm::cos(self)
    }

    fn arc_sine(self) -> Self {
        libm::asin(self)
    }

    fn arc_cosine(self) -> Self {
        libm::acos(self)
    }
}

impl Number for Complex<f64> {
    fn real(number: f64) -> Self {
        Self::new(number, 0.0)
    }

    fn size(self) -> f64 {
        self.norm()
    }

    fn power(self, exponent: Self) -> Self {
        self.powc(exponent)
    }

    fn sine(self) -> Self {
        self.sin()
    }

    fn cosine(self) -> Self {
        self.cos()
    }

    fn arc_sine(self) -> Self {
        self.asin()
    }

    fn arc_cosine(self) -> Self {
        self.acos()
    }
}
