//! The numbers that a formula is evaluated on: real ones, and complex ones for an angle whose cosine is greater than one.

use super::tree::Function;
use nalgebra::Complex;
use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Numbers with the operations of the displays, as far as they have them.
pub trait Number:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self> + 'static
{
    /// A whole number.
    fn integer(n: i64) -> Self;

    /// π, if it is one of these numbers.
    fn pi() -> Option<Self>;

    /// Its size; not finite if it is no number.
    fn size(&self) -> f64;

    /// A function of it.
    fn apply(self, function: Function) -> Option<Self>;

    /// Raised to a power.
    fn power(self, exponent: f64) -> Option<Self>;
}

impl Number for f64 {
    fn integer(n: i64) -> Self {
        n as f64
    }

    fn pi() -> Option<Self> {
        Some(PI)
    }

    fn size(&self) -> f64 {
        self.abs()
    }

    fn apply(self, function: Function) -> Option<Self> {
        Some(match function {
            Function::Degrees => self.to_radians(),
            Function::Size => self.abs(),
            Function::Root => self.sqrt(),
            Function::Sine => libm::sin(self),
            Function::Cosine => libm::cos(self),
            Function::Tangent => libm::tan(self),
            Function::Secant => 1.0 / libm::cos(self),
            Function::ArcSine => libm::asin(self),
            Function::ArcCosine => libm::acos(self),
            Function::ArcTangent => libm::atan(self),
            Function::Minus | Function::PlusMinus | Function::Rate(_) => return None,
        })
    }

    fn power(self, exponent: f64) -> Option<Self> {
        Some(libm::pow(self, exponent))
    }
}

impl Number for Complex<f64> {
    fn integer(n: i64) -> Self {
        Self::new(n as f64, 0.0)
    }

    fn pi() -> Option<Self> {
        Some(Self::new(PI, 0.0))
    }

    fn size(&self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    fn apply(self, function: Function) -> Option<Self> {
        let sine = |of: Self| Self::new(libm::sin(of.re) * libm::cosh(of.im), libm::cos(of.re) * libm::sinh(of.im));
        let quarter = Self::new(PI / 2.0, 0.0);
        Some(match function {
            Function::Size => Self::new(self.size(), 0.0),
            Function::Root => self.power(0.5)?,
            Function::Sine => sine(self),
            Function::Cosine => sine(quarter - self),
            Function::Tangent => sine(self) / sine(quarter - self),
            Function::ArcSine => quarter - self.apply(Function::ArcCosine)?,
            // The angle φ with cos φ + i sin φ = e^(iφ).
            Function::ArcCosine => {
                let sine = (Self::integer(1) - self * self).power(0.5)?;
                -Self::i() * logarithm(self + Self::i() * sine)
            }
            _ => return None,
        })
    }

    fn power(self, exponent: f64) -> Option<Self> {
        let power = logarithm(self) * exponent;
        let turned = Self::new(libm::cos(power.im), libm::sin(power.im)) * libm::exp(power.re);
        Some(if self.size() == 0.0 { self } else { turned })
    }
}

fn logarithm(number: Complex<f64>) -> Complex<f64> {
    Complex::new(libm::log(number.size()), libm::atan2(number.im, number.re))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_and_its_cosine_belong_together_also_beyond_one() {
        let real = |number| Complex::new(number, 0.0);
        for number in [real(0.25), real(1.0), real(1.25), real(-0.5), Complex::new(0.5, -2.0)] {
            for [arc, back] in [[Function::ArcCosine, Function::Cosine], [Function::ArcSine, Function::Sine]] {
                let there = number.apply(arc).and_then(|angle| angle.apply(back)).unwrap();
                assert!((there - number).size() < 1e-12, "{number}: {there}");
            }
        }
        let angle = real(1.25).apply(Function::ArcCosine).unwrap();
        assert!((angle - Complex::new(0.0, libm::log(2.0))).size() < 1e-12);
    }
}
