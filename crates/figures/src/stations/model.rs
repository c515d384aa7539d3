//! The triangle of the two axes and the pin, with the angles and their positive senses.

use super::pose::{WheelMargins, WheelPose};
use crate::number::{degrees, significant, without_noise};
use crate::parts::{self, WIDTH, arc_arrow, construction, dimension, fixed_pivot, part, pin_circle};
use crate::svg::{Canvas, DrawingKind, Label, Pixels, heading};
use crate::theme::{DRIVER, FOLLOWER, INK};
use crate::{Figure, FigureError, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::{pin_from_pivot, slot_radius_squared};
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::f64::consts::PI;

const MARGINS: WheelMargins = WheelMargins { left: 26.0, right: 30.0, above: 26.0, below: 80.0 };
/// From the lowest of the bodies to the dimension of the centre distance, in pixels.
const DIMENSION: f64 = 46.0;
/// Radii of the marks of the angles, over the crank radius and over the pin's distance from the wheel's axis.
const MARK: f64 = 0.46;
/// A label takes about so many pixels each way.
const BEYOND: f64 = 26.0;
/// An angle narrower than this (radians) has no room for its mark.
const NARROWEST: f64 = 0.05;

/// The triangle O P B at crank angle `crank` (θ, radians from the line of centres, within the engagement), to scale.
///
/// Sides: crank radius R, pin's distance r from the wheel's axis, centre distance l. θ is counted clockwise
/// from B → O and φ counter-clockwise from O → B. Series: θ, φ, r/R and l/R.
pub fn model(wheel: &Wheel, crank: f64) -> Result<Figure, FigureError> {
    let phi = wheel.engaged(crank)?.angle;
    let (ratio, turn) = (wheel.centre_distance_ratio(), Turn::from_radians(crank));
    let pin = pin_from_pivot(&ratio, &turn);
    let x = slot_radius_squared(&ratio, &turn).sqrt();
    let bodies = WheelPose::new(wheel, WIDTH, MARGINS);
    let mut canvas = Canvas::new(WIDTH, bodies.height);
    canvas.faint(0.6, "", |canvas| bodies.draw_wheel(canvas, &bodies.pivot, phi, 1.3));
    pin_circle(&mut canvas, &bodies.axis, bodies.view.scale);
    triangle(&mut canvas, &bodies, &bodies.view.place(&pin));
    angles(&mut canvas, &bodies, crank, phi, x);
    sides(&mut canvas, &bodies, crank, phi, &bodies.view.place(&pin));

    let (theta, phi) = (crank.to_degrees(), phi.to_degrees());
    let series = Series::of_one([("theta", "deg", theta), ("phi", "deg", phi), ("r/R", "1", x), ("l/R", "1", ratio)]);
    let words = Words::new(
        "wheel-model",
        format!("The triangle of the two axes and the pin for {} stations", wheel.stations()),
        format!(
            "The wheel's axis O at the left, the driver's axis B at the right, {} crank radii away, and the pin P in a \
             slot of the wheel. BP is the crank R; OP is r, {} crank radii. The crank angle θ at B, {}, is counted \
             clockwise from BO; the wheel's angle φ at O, {}, counter-clockwise from OB.",
            significant(ratio, 4),
            significant(x, 4),
            degrees(crank),
            degrees(without_noise(phi.to_radians(), 1.0))
        ),
        format!(
            "The model: crank R, distance r of the pin from the wheel's axis, angles θ and φ with opposite positive \
             senses, drawn to scale at θ = {}.",
            degrees(crank)
        ),
    );
    Ok(words.figure(canvas, DrawingKind::Mechanism, series))
}

fn triangle(canvas: &mut Canvas, at: &WheelPose, pin: &Pixels) {
    let triangle = [(&at.pivot, &at.axis, INK, "l"), (&at.axis, pin, DRIVER, "R"), (&at.pivot, pin, FOLLOWER, "r")];
    parts::sides(canvas, triangle);
    construction(canvas, &at.axis, &(at.axis + Vector2::new(at.view.scale + 14.0, 0.0)), "line-of-centres");
    fixed_pivot(canvas, &at.pivot, 1.0);
    fixed_pivot(canvas, &at.axis, 1.0);
    parts::pin(canvas, pin, at.driver.pin * at.view.scale);
}

fn angles(canvas: &mut Canvas, at: &WheelPose, theta: f64, phi: f64, x: f64) {
    for (centre, radius, from, turn, letter) in
        [(&at.pivot, MARK * x * at.view.scale, 0.0, phi, "φ"), (&at.axis, MARK * at.view.scale, PI, -theta, "θ")]
    {
        if turn.abs() > NARROWEST {
            part(canvas, letter, |canvas| arc_arrow(canvas, centre, radius, from, from + turn, INK, 1.6));
        }
        let middle = heading(from + turn / 2.0);
        // Inside the arc, beyond it, or across the line of centres, as there is room.
        let (point, towards, distance) = if turn.abs() * radius > 42.0 {
            (centre + middle * radius, -middle, 12.0)
        } else if turn.abs() * (radius + BEYOND) > BEYOND {
            (centre + middle * radius, middle, 10.0)
        } else {
            (centre + heading(from) * radius.max(44.0), Vector2::new(0.0, if theta < 0.0 { -1.0 } else { 1.0 }), 18.0)
        };
        canvas.label(&point, &towards, distance, &Label::part(letter));
    }
}

fn sides(canvas: &mut Canvas, at: &WheelPose, theta: f64, phi: f64, pin: &Pixels) {
    let down = Vector2::new(0.0, at.height - DIMENSION - at.pivot.y);
    let middle = dimension(canvas, &at.pivot, &at.axis, &down);
    let side = if theta < 0.0 { -1.0 } else { 1.0 };
    let length = Label::part("l");
    canvas.label(&middle, &Vector2::new(0.0, 1.0), 18.0, &length);
    let across = heading(phi + side * PI / 2.0);
    canvas.label(&at.pivot.lerp(pin, 0.55), &across, 14.0, &Label::part("r").in_colour(FOLLOWER));
    let across = heading(PI - theta - side * PI / 2.0);
    canvas.label(&at.axis.lerp(pin, 0.55), &across, 14.0, &Label::part("R").in_colour(DRIVER));
    canvas.label(&at.pivot, &heading(2.6), 16.0, &Label::words("O"));
    canvas.label(&at.axis, &heading(0.6), 16.0, &Label::words("B"));
    canvas.label(pin, &heading(side * PI / 2.0), 8.0 + at.driver.arm * at.view.scale, &Label::words("P"));
}
