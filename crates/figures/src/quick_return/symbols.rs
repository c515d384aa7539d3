//! The symbols of the terms, and the rows that stand for them in a series.

use super::instant::cleared;
use crate::svg::label::Label;
use nalgebra::Vector2;

/// Velocity of a point.
pub fn v(point: &str) -> Label {
    Label::symbol("v").sub(point)
}

/// A part of the acceleration of a point: normal, n, or tangential, t.
pub fn a(part: &str, point: &str) -> Label {
    Label::symbol("a").sup(part).sub(point)
}

/// The Coriolis acceleration, 2 ω₄ × v.
pub fn coriolis() -> Label {
    Label::words("2").and_symbol("ω").sub("4").and(" × ").and_label(&v("P2P4"))
}

/// Angular velocity of a link.
pub fn omega(link: &str) -> Label {
    Label::symbol("ω").sub(link)
}

/// Angular acceleration of a link.
pub fn alpha(link: &str) -> Label {
    Label::symbol("α").sub(link)
}

/// The number of a vector in its series, its components, its magnitude and its direction in degrees.
///
/// The direction is counted counter-clockwise from O4 → O2; that of a vector that is nothing beside `scale` is zero.
pub fn row(number: usize, vector: &Vector2<f64>, scale: f64) -> [f64; 5] {
    let magnitude = libm::hypot(vector.x, vector.y);
    let direction = if cleared(magnitude, scale) == 0.0 { 0.0 } else { libm::atan2(vector.y, vector.x).to_degrees() };
    [number as f64, vector.x, vector.y, magnitude, direction]
}
