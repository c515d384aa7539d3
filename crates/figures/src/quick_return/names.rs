//! The angles, senses, names and values of the mechanism.

use super::bodies::other_branch;
use super::instant::{Instant, written};
use super::links::{LEVER, Layout, WIDTH, length, wrapped};
use super::symbols::{alpha, omega};
use crate::number::{degrees, round_step};
use crate::svg::canvas::Canvas;
use crate::svg::label::Label;
use crate::svg::marks::{arc, arc_arrow};
use crate::svg::path::Sense;
use crate::svg::placing::{Place, Placing, around, beside_line, leader};
use crate::svg::shape::Shape;
use crate::svg::view::{Pixels, heading};
use crate::theme::{DRIVER, FOLLOWER, GRID, INK};
use geneva_kinematics::quick_return::{Drive, QuickReturn};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Room for the values below the mechanism, its lines and where its columns begin, in pixels.
pub const VALUES: f64 = 3.0 * LINE + 8.0;
const LINE: f64 = 28.0;
const COLUMNS: [f64; 3] = [30.0, 225.0, 410.0];
/// From a body to the arrow of its sense, in pixels, and half the arrow's length.
const TO_ARROW: f64 = 15.0;
const HALF_ARROW: f64 = 30.0;
/// The narrowest angle with a mark, in radians.
const NARROWEST: f64 = 0.05;
/// How far labels may stand from what they name, in pixels.
const NEAR: [f64; 6] = [8.0, 13.0, 20.0, 30.0, 44.0, 62.0];

/// Angles, senses and names, the most bound to their places first.
pub fn names(
    canvas: &mut Canvas,
    placing: &mut Placing,
    at: &Layout,
    linkage: &QuickReturn,
    instant: &Instant,
    drive: &Drive<f64>,
) {
    let (phi, psi) = (instant.crank_angle, instant.lever_angle);
    let distance = (at.pin - at.pivot).norm();
    let at_pivot = (0.42 * at.view.place(&Vector2::zeros()).metric_distance(&at.axis)).min(0.7 * distance).max(40.0);
    let at_pin = (0.3 * at.crank.min(distance)).clamp(24.0, 44.0);
    let swept = wrapped(phi - psi);
    mark(canvas, placing, &at.pin, at_pin, (psi + PI, psi + PI + swept), false, ("β", instant.angle_at_pin));
    mark(canvas, placing, &at.pivot, at_pivot, (0.0, psi), false, ("ψ", psi));
    mark(canvas, placing, &at.axis, (0.42 * at.crank).min(58.0), (0.0, phi), true, ("φ", phi));

    let omega_4 = instant.lever_speed(drive);
    let aside = if linkage.strokes().swing_limit.is_some() { -0.85 * at.side } else { psi - FRAC_PI_2 };
    for (centre, radius, middle, rate, symbol, shade) in [
        (&at.axis, at.crank + TO_ARROW, aside, drive.speed, omega("2").shade(DRIVER), DRIVER),
        (&at.pivot, at.lever + LEVER + TO_ARROW, psi, omega_4, omega("4").shade(FOLLOWER), FOLLOWER),
    ] {
        // At rest there is no sense.
        if rate != 0.0 {
            let half = HALF_ARROW / radius * Sense::of(rate).sign();
            arc_arrow(canvas, centre, radius, middle - half, middle + half, shade, 2.5);
            placing.avoid_arc(centre, radius, middle - half, middle + half, 2.0);
            placing.put(canvas, &symbol, around(&(centre + heading(middle) * radius), middle, &NEAR));
        }
    }
    let outwards = psi + FRAC_PI_2 * at.side;
    let pin = Label::words("P").sub("2").and(", P").sub("4");
    placing.put(canvas, &pin, around(&at.pin, outwards, &[12.0, 18.0, 26.0, 36.0, 50.0]));
    for (point, name) in [(&at.pivot, "4"), (&at.axis, "2")] {
        let label = Label::words("O").sub(name);
        placing.put(canvas, &label, around(point, -at.side * 0.5, &[14.0, 20.0, 28.0, 38.0]));
    }
    if let Some(ghost) = other_branch(at, linkage, instant) {
        let places =
            beside_line(&at.axis, &ghost, &NEAR).into_iter().chain(around(&ghost, -FRAC_PI_2 * at.side, &NEAR));
        if let Some(place) = placing.put(canvas, &Label::words("other branch").shade(DRIVER), places) {
            leader(canvas, &place);
        }
    }
    if let Some(limit) = linkage.strokes().swing_limit {
        for angle in [limit, -limit] {
            let from = at.pivot.lerp(&at.tip(angle), 0.3);
            let label = Label::words(&format!("end of swing {}", degrees(angle))).shade(FOLLOWER);
            placing.put(canvas, &label, beside_line(&from, &at.tip(angle), &NEAR));
        }
    }
}

/// The mark of an angle about a point, with an arrow head if it is counted in one sense, and its label: with the value
/// if it has room within the angle.
fn mark(
    canvas: &mut Canvas,
    placing: &mut Placing,
    centre: &Pixels,
    radius: f64,
    (from, to): (f64, f64),
    counted: bool,
    (symbol, angle): (&str, f64),
) {
    if (to - from).abs() < NARROWEST {
        return;
    }
    if counted && (to - from).abs() * radius > 24.0 {
        arc_arrow(canvas, centre, radius, from, to, INK, 1.5);
    } else {
        arc(canvas, centre, radius, from, to, INK, 1.5);
    }
    placing.avoid_arc(centre, radius, from, to, 1.0);
    let places = |distances: &[f64]| -> Vec<Place> {
        let at = |share: f64, distance: f64| {
            let towards = heading(from + share * (to - from));
            Place { point: centre + towards * radius, towards, distance }
        };
        let shares = [0.5, 0.35, 0.65, 0.2, 0.8].into_iter();
        shares.flat_map(|share| distances.iter().map(move |distance| at(share, *distance))).collect()
    };
    let whole = value(symbol, angle);
    if placing.has_room(&whole, places(&NEAR[..3])) {
        placing.put(canvas, &whole, places(&NEAR[..3]));
    } else {
        let middle = (from + to) / 2.0;
        let elsewhere = around(&(centre + heading(middle) * radius), middle, &NEAR);
        placing.put(canvas, &Label::symbol(symbol), places(&NEAR).into_iter().chain(elsewhere));
    }
}

/// A symbol with its angle, which is given in radians.
fn value(symbol: &str, radians: f64) -> Label {
    Label::symbol(symbol).and(&format!(" = {}", degrees(radians)))
}

/// A bar of a round length, in the upper left corner.
pub fn scale_bar(canvas: &mut Canvas, at: &Layout, unit: &str) {
    let value = round_step(70.0 / at.view.scale);
    let start = Vector2::new(COLUMNS[0], 24.0);
    let end = start + Vector2::new(value * at.view.scale, 0.0);
    canvas.draw(Shape::line(&start, &end).stroke(INK, 2.0).class("scale-bar"));
    for at in [start, end] {
        let tick = Vector2::new(0.0, 6.0);
        canvas.draw(Shape::line(&(at - tick), &(at + tick)).stroke(INK, 2.0));
    }
    canvas.label(&end, &Vector2::new(1.0, 0.0), 14.0, &Label::words(&length(value, unit)));
}

/// Lengths, angles, and the motion of the two links, in columns below.
pub fn values(canvas: &mut Canvas, linkage: &QuickReturn, instant: &Instant, drive: &Drive<f64>, unit: &str, top: f64) {
    let rule = [COLUMNS[0], WIDTH - COLUMNS[0]].map(|x| Vector2::new(x, top));
    canvas.draw(Shape::line(&rule[0], &rule[1]).stroke(GRID, 1.2));
    let columns = [
        [
            Label::symbol("l").and(&format!(" = {}", length(linkage.ground(), unit))),
            Label::symbol("R").and(&format!(" = {}", length(linkage.crank(), unit))).shade(DRIVER),
            Label::symbol("r").and(&format!(" = {}", written(instant.pin_distance, unit))).shade(FOLLOWER),
        ],
        [value("φ", instant.crank_angle), value("ψ", instant.lever_angle), value("β", instant.angle_at_pin)],
        [
            omega("2").and(&format!(" = {}", written(drive.speed, "rad/s"))).shade(DRIVER),
            omega("4").and(&format!(" = {}", written(instant.lever_speed(drive), "rad/s"))).shade(FOLLOWER),
            alpha("4").and(&format!(" = {}", written(instant.lever_acceleration(drive), "rad/s²"))).shade(FOLLOWER),
        ],
    ];
    for (x, labels) in COLUMNS.into_iter().zip(columns) {
        for (k, label) in labels.into_iter().enumerate() {
            let at = Vector2::new(x, top + LINE * (k as f64 + 0.7));
            canvas.label(&at, &Vector2::new(1.0, 0.0), 0.0, &label.bare());
        }
    }
}
