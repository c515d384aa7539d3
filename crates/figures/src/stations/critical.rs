//! The geometry of entry: the right angle at the pin, from which all sizes follow.

use super::pose::{WheelMargins, WheelPose};
use crate::number::{degrees, significant};
use crate::parts::{self, WIDTH, arc, dimension, part, pin_circle, right_angle};
use crate::svg::{Canvas, DASHED, DrawingKind, Label, Pixels, Shape, heading};
use crate::theme::{DRIVER, FOLLOWER, INK};
use crate::{Figure, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::f64::consts::PI;

const MARGINS: WheelMargins = WheelMargins { left: 30.0, right: 30.0, above: 80.0, below: 44.0 };
/// From the top of the page to the dimension of the centre distance, in pixels.
const DIMENSION: f64 = 50.0;

/// A crank of so few pixels has no room beside it for the name of an angle.
const SMALL: f64 = 80.0;

/// The triangle of the two axes and the pin as the pin enters, to scale: crank and slot stand at right angles.
///
/// Lengths are labelled in crank radii: centre distance 1 / sin α, the wheel's radius 1 / tan α, crank 1; angles: α at
/// the wheel's axis, π/2 − α at the driver's, 2α between two slots. Series: N, α, π/2 − α, the three lengths.
pub fn critical_geometry(wheel: &Wheel) -> Figure {
    let bodies = WheelPose::new(wheel, WIDTH, MARGINS);
    let (alpha, theta) = (wheel.half_pitch_angle(), wheel.engagement_half_angle());
    let pin = bodies.pin(-theta);
    let mut canvas = Canvas::new(WIDTH, bodies.height);
    let scale = bodies.view.scale;
    canvas.faint(0.5, "", |canvas| bodies.draw_wheel(canvas, &bodies.pivot, alpha, 1.3));
    let rim = Shape::circle(&bodies.pivot, bodies.star.rim * scale).stroke(FOLLOWER, 1.3).dashed("2 4");
    canvas.draw(rim.class("rim"));
    pin_circle(&mut canvas, &bodies.axis, scale);
    triangle(&mut canvas, &bodies, alpha, &pin);
    angles(&mut canvas, &bodies, alpha, theta, &pin);
    lengths(&mut canvas, &bodies, alpha, theta, &pin);

    let (l, radius) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
    let series = Series::of_one([
        ("N", "1", f64::from(wheel.stations())),
        ("alpha", "deg", alpha.to_degrees()),
        ("pi/2-alpha", "deg", theta.to_degrees()),
        ("l/r", "1", l),
        ("wheel/r", "1", radius),
        ("crank/r", "1", 1.0),
    ]);
    let words = Words::new(
        "wheel-critical",
        format!("Geometry of a wheel with {} stations as the pin enters", wheel.stations()),
        format!(
            "A right-angled triangle of the wheel's axis O, the driver's axis B and the pin P, with the right angle at P. The \
             angle at O is α, {}; the angle at B is π/2 − α, {}. With a crank of length 1 the centre distance OB is 1 / sin α, \
             {}, and the wheel's radius OP is 1 / tan α, {}. Neighbouring slots make an angle of 2α.",
            degrees(alpha),
            degrees(theta),
            significant(l, 4),
            significant(radius, 4)
        ),
        "The moment of entry. The slot is tangent to the crank circle, so the triangle has a right angle at the pin. In crank \
         radii, the centre distance is 1 / sin α and the wheel's radius 1 / tan α.",
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

fn triangle(canvas: &mut Canvas, at: &WheelPose, alpha: f64, pin: &Pixels) {
    let next = at.on_wheel(at.star.rim + 14.0 / at.view.scale, alpha);
    canvas.draw(Shape::line(&at.pivot, &next).stroke(FOLLOWER, 1.5).dashed(DASHED).class("next-slot"));
    let sides = [(&at.pivot, &at.axis, INK, "l"), (&at.axis, pin, DRIVER, "R"), (&at.pivot, pin, FOLLOWER, "r")];
    parts::sides(canvas, sides);
    for (centre, colour) in [(&at.pivot, FOLLOWER), (&at.axis, DRIVER)] {
        parts::axis(canvas, centre, colour);
    }
    parts::pin(canvas, pin, at.driver.pin * at.view.scale);
}

fn angles(canvas: &mut Canvas, at: &WheelPose, alpha: f64, theta: f64, pin: &Pixels) {
    let scale = at.view.scale;
    let side = 0.1 * scale + at.driver.pin * scale;
    right_angle(canvas, pin, &(at.pivot - pin), &(at.axis - pin), side);
    let (near, far) = (0.3 * at.star.rim * scale, 0.5 * at.star.rim * scale);
    part(canvas, "α", |canvas| arc(canvas, &at.pivot, near, -alpha, 0.0, INK, 1.5));
    arc(canvas, &at.pivot, far, -alpha, alpha, INK, 1.5);
    // Beyond the arcs, or across the slots' lines where those are too close together.
    let narrow = alpha * near < 24.0;
    let (one, both) = if narrow { (-alpha - 26.0 / near, alpha + 20.0 / far) } else { (-alpha / 2.0, alpha / 2.0) };
    let beyond = if narrow { 0.0 } else { 8.0 };
    let label = Label::part("α");
    canvas.label(&(at.pivot + heading(one) * near), &heading(one), beyond, &label);
    let label = Label::words("2").and_symbol("α");
    canvas.label(&(at.pivot + heading(both) * far), &heading(both), beyond, &label);
    let radius = 0.23 * scale;
    part(canvas, "θ", |canvas| arc(canvas, &at.axis, radius, PI, PI + theta, INK, 1.5));
    let label = Label::words("π/2\u{2009}−\u{2009}").and_symbol("α");
    if scale > SMALL {
        let middle = heading(PI + 0.6 * theta);
        canvas.label(&(at.axis + middle * radius), &middle, 7.0, &label);
    } else {
        let down = Vector2::new(0.0, 1.0);
        canvas.label(&(at.axis + down * scale), &down, 34.0, &label.and(" at B"));
    }
}

fn lengths(canvas: &mut Canvas, at: &WheelPose, alpha: f64, theta: f64, pin: &Pixels) {
    let up = Vector2::new(0.0, DIMENSION - at.pivot.y);
    let middle = dimension(canvas, &at.pivot, &at.axis, &up);
    canvas.label(&middle, &Vector2::new(0.0, -1.0), 18.0, &Label::words("1 / sin ").and_symbol("α"));
    let radius = Label::words("1 / tan ").and_symbol("α").in_colour(FOLLOWER);
    canvas.label(&at.pivot.lerp(pin, 0.62), &heading(-alpha - PI / 2.0), 16.0, &radius);
    let crank = Label::words("1").in_colour(DRIVER);
    canvas.label(&at.axis.lerp(pin, 0.5), &heading(PI + theta + PI / 2.0), 16.0, &crank);
    canvas.label(&at.pivot, &heading(2.6), 16.0, &Label::words("O"));
    canvas.label(&at.axis, &heading(0.4), 16.0, &Label::words("B"));
    let below = if at.view.scale <= SMALL { -0.8 * PI } else { -PI / 2.0 };
    canvas.label(pin, &heading(below), 8.0 + at.driver.arm * at.view.scale, &Label::words("P"));
}
