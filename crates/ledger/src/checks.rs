//! Small pieces that the sources' checks are made of.

use crate::{Decimal, Finding, claim, printed_value};

/// The number printed in the claim with this id; not a number if there is none, which no verdict survives.
pub(crate) fn printed(id: &str) -> f64 {
    printed_value(id).unwrap_or(f64::NAN)
}

/// The number printed in the claim with this id, with its digits.
pub(crate) fn decimal(id: &str) -> Option<Decimal> {
    claim(id)?.printed.parse().ok()
}

/// Whether the number printed in the claim with this id is a rounding of this one.
pub(crate) fn rounds(id: &str, number: f64) -> bool {
    decimal(id).is_some_and(|decimal| decimal.is_rounding_of(number))
}

/// Whether two numbers agree as two routes must.
pub(crate) fn agrees(a: f64, b: f64) -> bool {
    crate::tolerance::ROUTES.agrees(a, b)
}

/// Whether a quantity that must be zero is, but for rounding.
pub(crate) fn vanishes(x: f64) -> bool {
    x.abs() <= crate::tolerance::CLOSURE.relative
}

/// The same as [`agrees`] as a finding, which says both.
pub(crate) fn same(a: f64, b: f64) -> Finding {
    Finding::new(agrees(a, b), format!("{a} against {b}"))
}
