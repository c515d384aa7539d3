//! The marks of a technical drawing: arrows, angles, dimensions, supports.

use super::canvas::Canvas;
use super::path::{Path, Sense};
use super::shape::Shape;
use super::view::{Pixels, angle_of, heading};
use crate::theme::{GRID, INK, PAPER, Shade};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Length of an arrow head, in pixels, for a line of width 1; it grows with half the width beyond.
const HEAD: f64 = 11.0;
/// Lines shorter than this (pixels) get no head.
const SHORTEST: f64 = 1.0;

/// A straight arrow whose tip is exactly at `to`: a shaft and a head, both of the class `name`.
///
/// The shaft's path begins at the tail, the head's at the tip.
pub fn arrow(canvas: &mut Canvas, from: &Pixels, to: &Pixels, shade: Shade, width: f64, name: &str) {
    let along = to - from;
    if along.norm() < SHORTEST {
        return;
    }
    let path = Path::start(from).line_to(&(to - along.normalize() * head_length(width) * 0.8));
    canvas.draw(Shape::path(path).stroke(shade, width).class(name));
    canvas.draw(head(to, angle_of(&along), width, shade).class(name));
}

/// An arc about `centre` from one angle to another, with an arrow head at its end.
pub fn arc_arrow(canvas: &mut Canvas, centre: &Pixels, radius: f64, from: f64, to: f64, shade: Shade, width: f64) {
    let sense = Sense::of(to - from);
    let covered = head_length(width) / radius * sense.sign();
    arc(canvas, centre, radius, from, to - 0.8 * covered, shade, width);
    // The head is a chord: it points along the arc's tangent at its own middle.
    let tangent = to + sense.sign() * FRAC_PI_2 - covered / 2.0;
    canvas.draw(head(&(centre + heading(to) * radius), tangent, width, shade));
}

/// An arc about `centre` from one angle to another: the mark of an angle.
pub fn arc(canvas: &mut Canvas, centre: &Pixels, radius: f64, from: f64, to: f64, shade: Shade, width: f64) {
    let end = centre + heading(to) * radius;
    let path = Path::start(&(centre + heading(from) * radius));
    canvas.draw(Shape::path(path.arc(radius, (to - from).abs() > PI, Sense::of(to - from), &end)).stroke(shade, width));
}

/// The mark of a right angle at `corner` between two directions (offsets of any length), with sides of `size` pixels.
pub fn right_angle(canvas: &mut Canvas, corner: &Pixels, one: &Pixels, other: &Pixels, size: f64) {
    if let (Some(one), Some(other)) = (one.try_normalize(SHORTEST), other.try_normalize(SHORTEST)) {
        let (a, b) = (one * size, other * size);
        let path = Path::start(&(corner + a)).line_to(&(corner + a + b)).line_to(&(corner + b));
        canvas.draw(Shape::path(path).stroke(INK, 1.5));
    }
}

/// A dimension line beside the distance from one point to another, `offset` away from both, with extension lines.
///
/// Gives the middle of the dimension line, for its label.
pub fn dimension(canvas: &mut Canvas, from: &Pixels, to: &Pixels, offset: &Pixels) -> Pixels {
    let beyond = offset * (1.0 + 7.0 / offset.norm().max(1.0));
    for end in [from, to] {
        canvas.draw(Shape::line(end, &(end + beyond)).stroke(GRID, 1.0));
    }
    let (a, b) = (from + offset, to + offset);
    canvas.draw(Shape::line(&a, &b).stroke(INK, 1.2));
    canvas.draw(head(&b, angle_of(&(b - a)), 1.0, INK));
    canvas.draw(head(&a, angle_of(&(a - b)), 1.0, INK));
    (a + b) / 2.0
}

/// A pivot on the ground: a pin joint, and below it (`down` = 1) or above it (−1) its hatched support.
pub fn fixed_pivot(canvas: &mut Canvas, at: &Pixels, down: f64) {
    let (half, height) = (15.0, 24.0);
    let corner = |x: f64, y: f64| at + Vector2::new(x, y * down);
    let support = Path::start(at).line_to(&corner(-half, height)).line_to(&corner(half, height)).close();
    canvas.draw(Shape::path(support).stroke(INK, 1.5).fill(PAPER).with("stroke-linejoin", "round"));
    canvas.draw(Shape::line(&corner(-half - 7.0, height), &corner(half + 7.0, height)).stroke(INK, 1.8));
    for k in 0..5 {
        let x = -half - 2.0 + 9.0 * f64::from(k);
        canvas.draw(Shape::line(&corner(x, height), &corner(x - 7.0, height + 8.0)).stroke(INK, 1.1));
    }
    canvas.draw(Shape::circle(at, 5.0).stroke(INK, 2.0).fill(PAPER));
}

fn head_length(width: f64) -> f64 {
    HEAD + 2.0 * (width - 1.0)
}

fn head(tip: &Pixels, angle: f64, width: f64, shade: Shade) -> Shape {
    let (forward, aside) = (heading(angle), heading(angle + FRAC_PI_2));
    let back = tip - forward * head_length(width);
    let half = aside * head_length(width) * 0.38;
    Shape::path(Path::start(tip).line_to(&(back + half)).line_to(&(back - half)).close()).fill(shade)
}
