//! What a letter may stand for: a real number, or a complex one for an angle whose cosine is greater than one.

use nalgebra::Complex;
use std::f64::consts::PI;
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
        libm::hypot(self.re, self.im)
    }

    fn power(self, exponent: Self) -> Self {
        if self.size() == 0.0 { self } else { exponential(exponent * logarithm(self)) }
    }

    fn sine(self) -> Self {
        Self::new(libm::sin(self.re) * libm::cosh(self.im), libm::cos(self.re) * libm::sinh(self.im))
    }

    fn cosine(self) -> Self {
        Self::new(libm::cos(self.re) * libm::cosh(self.im), -libm::sin(self.re) * libm::sinh(self.im))
    }

    fn arc_sine(self) -> Self {
        Self::real(PI / 2.0) - self.arc_cosine()
    }

    fn arc_cosine(self) -> Self {
        // The angle φ with cos φ + i sin φ = e^(iφ).
        let sine = (Self::real(1.0) - self * self).power(Self::real(0.5));
        -Self::i() * logarithm(self + Self::i() * sine)
    }
}

fn logarithm(number: Complex<f64>) -> Complex<f64> {
    Complex::new(libm::log(number.size()), libm::atan2(number.im, number.re))
}

fn exponential(number: Complex<f64>) -> Complex<f64> {
    Complex::new(libm::cos(number.im), libm::sin(number.im)) * libm::exp(number.re)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_and_its_cosine_belong_together_also_beyond_one() {
        for number in [0.25, 1.0, 1.25, -0.5].map(Complex::real).into_iter().chain([Complex::new(0.5, -2.0)]) {
            for there in [number.arc_cosine().cosine(), number.arc_sine().sine(), number.power(Complex::real(1.0))] {
                assert!((there - number).size() < 1e-12, "{number}: {there}");
            }
        }
        assert!((Complex::real(1.25).arc_cosine() - Complex::new(0.0, libm::log(2.0))).size() < 1e-12);
    }
}
