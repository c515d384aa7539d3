//! Whether two routes agree, as a truth value and as a finding.

use crate::Finding;
use crate::tolerance::{CLOSURE, ROUTES};
use nalgebra::Vector2;
use std::fmt::Display;

/// Whether two numbers agree as two routes must.
pub fn agrees(a: f64, b: f64) -> bool {
    ROUTES.agrees(a, b)
}

/// Whether a quantity that must be zero is, but for rounding.
pub fn vanishes(x: f64) -> bool {
    x.abs() <= CLOSURE.relative
}

/// Whether two vectors agree as two routes must.
pub fn coincide(a: &Vector2<f64>, b: &Vector2<f64>) -> bool {
    (a - b).norm() <= ROUTES.relative * a.norm().max(b.norm())
}

/// The least and the greatest of some numbers; infinite if there are none.
pub fn range(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    numbers.into_iter().fold(ends, |[low, high], number| [low.min(number), high.max(number)])
}

/// Compares two numbers as [`agrees`] does, and says both.
pub fn same(a: f64, b: f64) -> Finding {
    Finding::new(agrees(a, b), pair("number", &short(a), &short(b)))
}

/// A number to ten digits, which routes that agree have in common.
pub fn short(number: f64) -> String {
    format!("{number:.9e}").parse().map_or_else(|_| number.to_string(), |number: f64| number.to_string())
}

/// Two results that were compared, in words: of two that look alike one is said.
pub fn pair(what: &str, a: &str, b: &str) -> String {
    let compared = format!("{what}s that must be equal");
    if a == b {
        format!("the two {compared} are both {a}")
    } else {
        format!("of the two {compared}, one is {a} and the other {b}")
    }
}

/// Items with commas between them and *and* before the last; of none, "none".
pub fn joined<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    match &items[..] {
        [] => "none".to_owned(),
        [only] => only.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

/// Numbers as [`joined`], with three places each.
pub fn joined_numbers(numbers: &[f64]) -> String {
    // Rounded to zero, a number has no sign.
    let tidy = |number: &f64| format!("{number:.3}").replace("-0.000", "0.000");
    joined(numbers.iter().map(tidy))
}
