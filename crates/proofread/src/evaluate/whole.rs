//! Whole numbers that operations need, and products of them: factorials of all kinds.

use crate::evaluate::interval::Interval;
use crate::evaluate::value::{Evaluated, Obstacle, SideValue};

/// Most factors of a factorial or binomial coefficient.
pub(super) const MOST_FACTORS: f64 = 400.0;

/// Largest integer that is reckoned with exactly.
pub(super) const LARGEST: f64 = 9.0e15;

/// What floating point adds to an integer, relative to it.
pub(super) const NOISE: f64 = 1e-9;

/// The integer that a value is.
pub(super) fn integer(value: &SideValue) -> Evaluated<f64> {
    let number = value.number()?.point;
    let whole = libm::round(number);
    if value.has_unit || (number - whole).abs() > NOISE * whole.abs().max(1.0) || whole.abs() > LARGEST {
        return Err(Obstacle::Unclear("a number that is no integer where one is expected"));
    }
    Ok(whole)
}

/// The product of `count` factors, each `step` from the one before, beginning with `first`.
pub(super) fn product_of(first: f64, count: f64, step: f64) -> Evaluated<f64> {
    if !(0.0..=MOST_FACTORS).contains(&count) {
        return Err(Obstacle::TooLarge);
    }
    Ok((0..count as u32).map(|at| first + step * f64::from(at)).product())
}

/// The product of every second integer down from one: 7!! = 7 · 5 · 3 · 1.
pub(super) fn double_factorial(of: &SideValue) -> Evaluated<SideValue> {
    let n = integer(of)?;
    if n < 0.0 {
        return Err(Obstacle::Unclear("a factorial of what is no small integer"));
    }
    let value = product_of(n, libm::ceil(n / 2.0), -2.0)?;
    if value.is_finite() { Ok(computed(value, of.operations)) } else { Err(Obstacle::TooLarge) }
}

pub(super) fn computed(value: f64, operations: u32) -> SideValue {
    SideValue { operations: operations.saturating_add(1), ..SideValue::from_interval(Interval::exact(value)) }
}
