//! Whether two routes agree, as a truth value and as a finding.

use crate::Finding;
use crate::tolerance::{CLOSURE, ROUTES};
use nalgebra::Vector2;

/// Whether two numbers agree as two routes must.
pub(crate) fn agrees(a: f64, b: f64) -> bool {
    ROUTES.agrees(a, b)
}

/// Whether a quantity that must be zero is, but for rounding.
pub(crate) fn vanishes(x: f64) -> bool {
    x.abs() <= CLOSURE.relative
}

/// Whether two vectors agree as two routes must.
pub(crate) fn coincide(a: &Vector2<f64>, b: &Vector2<f64>) -> bool {
    (a - b).norm() <= ROUTES.relative * a.norm().max(b.norm())
}

/// Compares two numbers as [`agrees`] does, and says both.
pub(crate) fn same(a: f64, b: f64) -> Finding {
    Finding::new(agrees(a, b), format!("{a} against {b}"))
}

/// Compares two numbers whose last bits are not the same on every machine, and says six places of both.
pub(crate) fn meets(a: f64, b: f64) -> Finding {
    Finding::new(agrees(a, b), format!("{a:.6} against {b:.6}"))
}
