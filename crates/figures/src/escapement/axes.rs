//! What the plots have in common: how the three mechanisms are told apart, and axes in round steps.

use crate::number::{power_of_ten, round_step, significant, trimmed, with_minus_sign};
use crate::plot::{Axis, Scale};
use crate::svg::canvas::Canvas;
use crate::svg::path::Path;
use crate::svg::placing::Place;
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{DRIVER, FOLLOWER, PAPER, RELATIVE, Shade};
use nalgebra::Vector2;

/// How far beyond the greatest value an upright axis goes at least.
const HEADROOM: f64 = 1.04;

/// Colour and dashes of the curve of a mechanism with so many slots.
pub fn style(slots: u32) -> (Shade, Option<[u32; 2]>) {
    match slots {
        3 => (FOLLOWER, None),
        4 => (DRIVER, Some([12, 5])),
        _ => (RELATIVE, Some([3, 5])),
    }
}

/// The mark of a mechanism with so many slots: a filled circle, a square, a diamond.
pub fn mark(canvas: &mut Canvas, at: &Pixels, slots: u32) {
    let shade = style(slots).0;
    let corners = |places: [(f64, f64); 4], size: f64| {
        let [a, b, c, d] = places.map(|(x, y)| at + Vector2::new(x, y) * size);
        Shape::path(Path::start(&a).line_to(&b).line_to(&c).line_to(&d).close())
    };
    let shape = match slots {
        3 => Shape::circle(at, 5.5),
        4 => corners([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)], 5.0),
        _ => corners([(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)], 7.0),
    };
    canvas.draw(shape.fill(shade).stroke(PAPER, 1.5).class("point"));
}

/// A number to three significant digits, with a power of ten if it is very small or large.
pub fn short(value: f64) -> String {
    let digits = match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e6).contains(&size) => significant(value, 3),
        size => {
            let scientific = format!("{value:.2e}");
            format!("{}·{}", scientific.split_once('e').map_or("", |(mantissa, _)| mantissa), power_of_ten(size))
        }
    };
    with_minus_sign(&digits)
}

/// An axis in at least so many round steps that holds zero and both values.
pub fn upright(least: f64, greatest: f64, steps: f64) -> Axis {
    let size = HEADROOM * (greatest - least);
    let step = round_step(size / steps);
    let low = libm::floor(HEADROOM * least / step + 1e-9).min(0.0) as i32;
    let high = (libm::ceil(HEADROOM * greatest / step - 1e-9) as i32).max(low + 1);
    stepped(step, low, high)
}

/// An axis in at least so many round steps that holds both values, and zero only if it must.
pub fn spanning(least: f64, greatest: f64, steps: f64) -> Axis {
    let step = round_step((greatest - least) / steps);
    let low = libm::floor(least / step + 1e-9) as i32;
    let high = (libm::ceil(greatest / step - 1e-9) as i32).max(low + 1);
    stepped(step, low, high)
}

/// An axis from one multiple of a step to another, with a mark at each.
fn stepped(step: f64, low: i32, high: i32) -> Axis {
    let digits = trimmed(step, 6);
    Axis {
        range: step * f64::from(low)..step * f64::from(high),
        marks: (low..=high).map(|k| step * f64::from(k)).collect(),
        decimals: digits.split_once('.').map_or(0, |(_, after)| after.len()),
        scale: Scale::Even,
    }
}

/// Whole powers of ten that hold all values of the range, with a mark at each so many.
pub fn decades(least: f64, greatest: f64, each: usize) -> Axis {
    let power = |k: i32| format!("1e{k}").parse::<f64>().unwrap_or(1.0);
    let low = (-20..20).rev().find(|k| power(*k) <= least).unwrap_or(-20);
    let high = (low + 1..21).find(|k| power(*k) >= greatest).unwrap_or(20);
    let marks = (low..=high).rev().step_by(each).map(power).collect();
    Axis { range: power(low)..power(high), marks, decimals: 0, scale: Scale::Decades }
}

/// The same axis without marks: for a side of the frame that is not read.
pub fn blank(axis: &Axis) -> Axis {
    Axis { marks: Vec::new(), ..axis.clone() }
}

/// Places along a curve, to all sides of its points.
pub fn along(points: &[Pixels], distances: &[f64]) -> Vec<Place> {
    let directions =
        [(1.0, 0.6), (-1.0, -0.6), (1.0, -0.6), (-1.0, 0.6), (1.0, 0.0), (-1.0, 0.0), (0.0, -1.0), (0.0, 1.0)];
    let places = |point: &Pixels| {
        let point = *point;
        directions.into_iter().flat_map(move |(x, y)| {
            distances.iter().map(move |distance| Place { point, towards: Vector2::new(x, y), distance: *distance })
        })
    };
    points.iter().flat_map(places).collect()
}
