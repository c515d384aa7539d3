//! What drawings of mechanisms are made of: links, pins and pivots; vectors, angles and senses; dimensions and scales.

use crate::number::{degrees, format_trimmed, round_step};
use crate::svg::{
    Canvas, DASHED, Label, LabelPosition, Path, Pixels, Placing, Sense, Shape, angle_of, heading, leader,
    positions_around, positions_beside_line,
};
use crate::theme::{Colour, DRIVER, GRID, INK, PAPER};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Length of an arrow head, in pixels, for a line of width 1; it grows with half the width beyond.
const HEAD: f64 = 11.0;
/// Lines shorter than this (pixels) get no head.
const SHORTEST: f64 = 1.0;
/// Width of a drawing of a mechanism, in pixels.
pub(crate) const WIDTH: f64 = 640.0;
/// How far labels may stand from what they name, in pixels.
pub(crate) const NEAR: [f64; 6] = [8.0, 13.0, 20.0, 30.0, 44.0, 62.0];
/// Half the length of the arrow of a sense, in pixels, and from the arrow to its label.
const HALF_SENSE: f64 = 34.0;
const TO_LABEL: f64 = 7.0;

/// Draws the part of the drawing that a letter of the book stands for: a page finds it by the letter and lights it up.
/// The label that names it is a [`Label::part`].
pub(crate) fn part(canvas: &mut Canvas, letter: &str, draw: impl FnOnce(&mut Canvas)) {
    canvas.group(&format!("data-letter=\"{letter}\""), draw);
}

/// Draws the part that a label names, if it names one.
pub(crate) fn of_label(canvas: &mut Canvas, label: &Label, draw: impl FnOnce(&mut Canvas)) {
    match label.names() {
        Some(letter) => part(canvas, letter, draw),
        None => draw(canvas),
    }
}

/// A straight arrow whose tip is exactly at `to`: a shaft and a head, both of the class `name`.
///
/// The shaft's path begins at the tail, the head's at the tip.
pub(crate) fn arrow(canvas: &mut Canvas, from: &Pixels, to: &Pixels, colour: Colour, width: f64, name: &str) {
    let along = to - from;
    if along.norm() < SHORTEST {
        return;
    }
    let path = Path::start(from).line_to(&(to - along.normalize() * head_length(width) * 0.8));
    canvas.draw(Shape::path(path).stroke(colour, width).class(name));
    canvas.draw(head(to, angle_of(&along), width, colour).class(name));
}

/// A vector with its label, in the label's colour: both are kept clear of by later labels. The label stands beside the
/// vector's outer part.
pub(crate) fn vector(
    canvas: &mut Canvas,
    placing: &mut Placing,
    from: &Pixels,
    to: &Pixels,
    width: f64,
    label: &Label,
    name: &str,
) {
    of_label(canvas, label, |canvas| arrow(canvas, from, to, label.colour(), width, name));
    placing.avoid(from, to, 2.5);
    placing.put(canvas, label, positions_beside_line(&from.lerp(to, 0.45), to, &NEAR));
}

/// An arc about `centre` from one angle to another, with an arrow head at its end.
pub(crate) fn arc_arrow(
    canvas: &mut Canvas,
    centre: &Pixels,
    radius: f64,
    from: f64,
    to: f64,
    colour: Colour,
    width: f64,
) {
    let sense = Sense::from_rate(to - from);
    let covered = head_length(width) / radius * sense.sign();
    arc(canvas, centre, radius, from, to - 0.8 * covered, colour, width);
    // The head is a chord: it points along the arc's tangent at its own middle.
    let tangent = to + sense.sign() * FRAC_PI_2 - covered / 2.0;
    canvas.draw(head(&(centre + heading(to) * radius), tangent, width, colour));
}

/// An arc about `centre` from one angle to another: the mark of an angle.
pub(crate) fn arc(canvas: &mut Canvas, centre: &Pixels, radius: f64, from: f64, to: f64, colour: Colour, width: f64) {
    let end = centre + heading(to) * radius;
    let path = Path::start(&(centre + heading(from) * radius));
    canvas.draw(
        Shape::path(path.arc(radius, (to - from).abs() > PI, Sense::from_rate(to - from), &end)).stroke(colour, width),
    );
}

/// The mark of a right angle at `corner` between two directions (offsets of any length), with sides of `size` pixels.
pub(crate) fn right_angle(canvas: &mut Canvas, corner: &Pixels, one: &Pixels, other: &Pixels, size: f64) {
    if let (Some(one), Some(other)) = (one.try_normalize(SHORTEST), other.try_normalize(SHORTEST)) {
        let (a, b) = (one * size, other * size);
        let path = Path::start(&(corner + a)).line_to(&(corner + a + b)).line_to(&(corner + b));
        canvas.draw(Shape::path(path).stroke(INK, 1.5));
    }
}

/// A dimension line beside the distance from one point to another, `offset` away from both, with extension lines.
///
/// Gives the middle of the dimension line, for its label.
pub(crate) fn dimension(canvas: &mut Canvas, from: &Pixels, to: &Pixels, offset: &Pixels) -> Pixels {
    extension_lines(canvas, from, to, offset);
    dimension_line(canvas, &(from + offset), &(to + offset))
}

/// The lines from two points to a dimension line `offset` away from both, and a little beyond.
pub(crate) fn extension_lines(canvas: &mut Canvas, from: &Pixels, to: &Pixels, offset: &Pixels) {
    let beyond = offset * (1.0 + 7.0 / offset.norm().max(1.0));
    for end in [from, to] {
        canvas.draw(Shape::line(end, &(end + beyond)).stroke(GRID, 1.0));
    }
}

/// A line with a head at each end. Gives its middle.
pub(crate) fn dimension_line(canvas: &mut Canvas, a: &Pixels, b: &Pixels) -> Pixels {
    canvas.draw(Shape::line(a, b).stroke(INK, 1.2));
    canvas.draw(head(b, angle_of(&(b - a)), 1.0, INK));
    canvas.draw(head(a, angle_of(&(a - b)), 1.0, INK));
    (a + b) / 2.0
}

/// A pivot on the ground: a pin joint, and below it (`down` = 1) or above it (−1) its hatched support.
pub(crate) fn fixed_pivot(canvas: &mut Canvas, at: &Pixels, down: f64) {
    let (half, height) = (15.0, 24.0);
    let corner = |x: f64, y: f64| at + Vector2::new(x, y * down);
    let support = Path::start(at).line_to(&corner(-half, height)).line_to(&corner(half, height)).close();
    canvas.draw(Shape::path(support).stroke(INK, 1.5).fill(PAPER).attribute("stroke-linejoin", "round"));
    canvas.draw(Shape::line(&corner(-half - 7.0, height), &corner(half + 7.0, height)).stroke(INK, 1.8));
    for k in 0..5 {
        let x = -half - 2.0 + 9.0 * f64::from(k);
        canvas.draw(Shape::line(&corner(x, height), &corner(x - 7.0, height + 8.0)).stroke(INK, 1.1));
    }
    axis(canvas, at, INK);
}

fn head_length(width: f64) -> f64 {
    HEAD + 2.0 * (width - 1.0)
}

fn head(tip: &Pixels, angle: f64, width: f64, colour: Colour) -> Shape {
    let (forward, aside) = (heading(angle), heading(angle + FRAC_PI_2));
    let back = tip - forward * head_length(width);
    let half = aside * head_length(width) * 0.38;
    Shape::path(Path::start(tip).line_to(&(back + half)).line_to(&(back - half)).close()).fill(colour)
}

/// The mark of an axis.
pub(crate) fn axis(canvas: &mut Canvas, at: &Pixels, colour: Colour) {
    canvas.draw(Shape::circle(at, 5.0).fill(PAPER).stroke(colour, 2.0));
}

/// A pin in its place.
pub(crate) fn pin(canvas: &mut Canvas, at: &Pixels, radius: f64) {
    canvas.draw(Shape::circle(at, radius).fill(PAPER).stroke(INK, 2.0).class("pin"));
}

/// The circle of a crank's pin about its axis.
pub(crate) fn pin_circle(canvas: &mut Canvas, axis: &Pixels, radius: f64) {
    canvas.draw(Shape::circle(axis, radius).stroke(DRIVER, 1.3).dashed("2 4").class("pin-circle"));
}

/// A dashed line of construction.
pub(crate) fn construction(canvas: &mut Canvas, from: &Pixels, to: &Pixels, class: &str) {
    canvas.draw(Shape::line(from, to).stroke(INK, 1.2).dashed(DASHED).class(class));
}

/// The sides of a triangle, each from one point to another, in a colour, by the letter of its length.
pub(crate) fn sides<const N: usize>(canvas: &mut Canvas, sides: [(&Pixels, &Pixels, Colour, &str); N]) {
    for (from, to, colour, letter) in sides {
        let side = Shape::line(from, to).stroke(colour, 3.0).attribute("stroke-linecap", "round");
        canvas.draw(side.class(&format!("side-{letter}")).attribute("data-letter", letter));
    }
}

/// The outline of a link with round ends.
pub(crate) fn link(from: &Pixels, to: &Pixels, half_width: f64) -> Path {
    let along = to - from;
    let angle = if along.norm() > 0.0 { angle_of(&along) } else { 0.0 };
    let aside = heading(angle + FRAC_PI_2) * half_width;
    Path::start(&(from + aside))
        .arc_to(half_width, Sense::CounterClockwise, &(from - aside))
        .line_to(&(to - aside))
        .arc_to(half_width, Sense::CounterClockwise, &(to + aside))
        .close()
}

/// Which way a body turns: an arrow about its axis, at an angle, and its symbol beyond it. `sense` is that of the
/// rate; at rest there is none.
pub(crate) fn sense(canvas: &mut Canvas, axis: &Pixels, radius: f64, middle: f64, sense: f64, label: &Label) {
    if sense != 0.0 {
        let half = HALF_SENSE / radius * sense.signum();
        of_label(canvas, label, |canvas| {
            arc_arrow(canvas, axis, radius, middle - half, middle + half, label.colour(), 2.5);
        });
        canvas.label(&(axis + heading(middle) * radius), &heading(middle), TO_LABEL, label);
    }
}

/// Places for the label of an angle between two directions, along its arc.
pub(crate) fn along_arc(corner: &Pixels, radius: f64, (from, to): (f64, f64), distances: &[f64]) -> Vec<LabelPosition> {
    let at = |share: f64, distance: f64| {
        let towards = heading(from + share * (to - from));
        LabelPosition { point: corner + towards * radius, towards, distance }
    };
    let shares = [0.5, 0.35, 0.65, 0.2, 0.8].into_iter();
    shares.flat_map(|share| distances.iter().map(move |distance| at(share, *distance))).collect()
}

/// The mark of an angle at a corner, with its label within or beyond; nothing if it is too narrow.
pub(crate) fn angle(
    canvas: &mut Canvas,
    placing: &mut Placing,
    corner: &Pixels,
    radius: f64,
    (from, to): (f64, f64),
    label: &Label,
) {
    if (to - from).abs() * radius < 3.0 {
        return;
    }
    of_label(canvas, label, |canvas| arc(canvas, corner, radius, from, to, INK, 1.6));
    placing.avoid_arc(corner, radius, from, to, 1.5);
    let middle = (from + to) / 2.0;
    let elsewhere = positions_around(&(corner + heading(middle) * radius), middle, &NEAR);
    let places = along_arc(corner, radius, (from, to), &NEAR).into_iter().chain(elsewhere);
    if let Some(place) = placing.put(canvas, label, places) {
        leader(canvas, &place);
    }
}

/// A symbol with its angle, which is given in radians.
pub(crate) fn angle_label(symbol: &str, radians: f64) -> Label {
    Label::symbol(symbol).and(&format!(" = {}", degrees(radians)))
}

/// A bar of a round value of at least so many pixels, from `start` to the right or, if `leftwards`, to the left: with
/// its value, unit and further words at its end.
pub(crate) fn scale_bar(canvas: &mut Canvas, start: &Pixels, scale: f64, leftwards: bool, unit: &str) {
    let value = round_step(60.0 / scale);
    let side = if leftwards { -1.0 } else { 1.0 };
    let end = start + Vector2::new(side * value * scale, 0.0);
    canvas.draw(Shape::line(start, &end).stroke(INK, 2.0).class("scale-bar"));
    for at in [start, &end] {
        let tick = Vector2::new(0.0, 6.0);
        canvas.draw(Shape::line(&(at - tick), &(at + tick)).stroke(INK, 2.0));
    }
    let label = Label::words(&format!("{} {unit}", format_trimmed(value, 6)));
    canvas.label(&end, &Vector2::new(side, 0.0), 14.0, &label);
}

/// The number of a step or a part of a drawing, in a circle.
pub(crate) fn draw_number(canvas: &mut Canvas, at: &Pixels, number: usize) {
    canvas.draw(Shape::circle(at, 14.0).stroke(INK, 1.5));
    canvas.label(at, &Pixels::zeros(), 0.0, &Label::words(&number.to_string()).bare());
}
