//! The velocity triangle of the pin in the slot.

use super::instant::PinState;
use crate::number::{degrees, significant};
use crate::parts::{angle_label, arc, arrow, link, part, right_angle, scale_bar};
use crate::svg::{Canvas, DASHED, DrawingKind, Label, Pixels, Shape, View, angle_of, heading};
use crate::theme::{DRIVER, FILL, FOLLOWER, GRID, INK, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Width of the drawing, in pixels: narrow enough for its letters to be read on a phone.
const WIDTH: f64 = 484.0;
/// The largest the triangle may be: width and height in pixels. Labels stand beside it.
const ROOM: Pixels = Vector2::new(250.0, 350.0);
/// Free space above and below the triangle, in pixels.
const MARGIN: f64 = 50.0;
/// How far the triangle stands to the left of the middle, twice, in pixels: the labels at its right are longer.
const ASIDE: f64 = 56.0;
/// Half the width of the slot, and how far it goes on beyond the arrow in it, in pixels.
const SLOT: f64 = 12.0;
const BEYOND: f64 = 24.0;

/// Radii of the two marks of the slot's angle, in pixels: at the common tip and at the common tail.
const AT_TIP: f64 = 84.0;
const AT_TAIL: f64 = 58.0;
/// The narrowest angle that has room for its mark, in radians.
const NARROWEST: f64 = 0.2;

/// The triangle's corners on the page: common tail, end of the slot point's velocity, common tip.
struct Layout {
    view: View,
    tail: Pixels,
    corner: Pixels,
    tip: Pixels,
    height: f64,
}

impl Layout {
    fn new(instant: &PinState) -> Self {
        let corners = [Vector2::zeros(), instant.slot_point_velocity, instant.pin_velocity];
        let view = View::fitting(corners, ROOM, Pixels::zeros());
        let heights = corners.map(|corner| corner.y * view.scale);
        let size = heights.iter().fold(0.0, |a: f64, b| a.max(*b)) - heights.iter().fold(0.0, |a: f64, b| a.min(*b));
        let height = size.max(0.3 * WIDTH) + 2.0 * MARGIN;
        let view = View { origin: view.origin + Vector2::new(WIDTH - ASIDE, height) / 2.0, ..view };
        let [tail, corner, tip] = corners.map(|corner| view.place(&corner));
        Self { view, tail, corner, tip, height }
    }

    /// The direction away from the triangle, across the side between two corners.
    fn outwards(&self, from: &Pixels, to: &Pixels) -> Pixels {
        let along = to - from;
        let across = Vector2::new(-along.y, along.x);
        let inside = (self.tail + self.corner + self.tip) / 3.0 - from;
        if across.dot(&inside) > 0.0 { -across } else { across }
    }
}

/// The velocity triangle of the pin at a crank angle, to scale: the pin's velocity is that of the slot under it plus
/// that along the slot.
///
/// `crank` is counter-clockwise from the direction O → B; `driver_speed` the driver's angular velocity in radians
/// per time, counter-clockwise positive; `speed_unit` the unit of the speeds that follow. Series: θ, the three
/// speeds, γ (acute, between the pin's velocity and the slot) and φ (of the slot, from the line of centres).
pub fn velocity_triangle(mechanism: &PinSlot, crank: &Turn<f64>, driver_speed: f64, speed_unit: &str) -> Figure {
    let instant = PinState::new(mechanism, crank, driver_speed);
    let layout = Layout::new(&instant);
    let mut canvas = Canvas::new(WIDTH, layout.height);
    directions(&mut canvas, &layout, &instant);
    vectors(&mut canvas, &layout, &instant, speed_unit);
    // In the upper corner away from the triangle's tail.
    let at_right = layout.tip.x > layout.tail.x;
    let start = Vector2::new(if at_right { WIDTH - 24.0 } else { 24.0 }, 34.0);
    scale_bar(&mut canvas, &start, layout.view.scale, at_right, speed_unit);

    let speeds = instant.speeds();
    let [theta, gamma, phi] =
        [instant.crank_angle - PI, instant.velocity_angle(), -instant.slot_angle].map(f64::to_degrees);
    let series = Series::of_one([
        ("theta", "deg", theta),
        ("v_P", speed_unit, speeds[0]),
        ("v_P'", speed_unit, speeds[1]),
        ("v_P/S", speed_unit, speeds[2]),
        ("gamma", "deg", gamma),
        ("phi", "deg", phi),
    ]);
    let (theta, gamma) = (degrees(instant.crank_angle - PI), degrees(instant.velocity_angle()));
    let [pin, across, along] = speeds.map(|speed| format!("{} {speed_unit}", significant(speed, 4)));
    let words = Words::new(
        "pin-velocity",
        format!("Velocity triangle of the pin at a crank angle of {theta}"),
        format!(
            "A right-angled triangle of arrows, to scale. The pin's velocity, {pin}, is the hypotenuse; it is the sum \
             of the velocity of the slot's point under the pin, {across}, and of the pin's velocity along the slot, \
             {along}. The angle between the pin's velocity and the slot is {gamma}."
        ),
        format!(
            "The velocity triangle at θ = {theta}, to scale. The pin's velocity is the sum of two velocities: the \
             velocity of the wheel's point under the pin, across the slot, and the pin's sliding velocity, along the \
             slot."
        ),
    );
    words.figure(canvas, DrawingKind::Diagram, series)
}

/// Reference directions and the angles from them.
fn directions(canvas: &mut Canvas, at: &Layout, instant: &PinState) {
    let along = at.corner - at.tip;
    if let Some(direction) = along.try_normalize(1e-9) {
        let ends = (at.tip - direction * BEYOND, at.corner + direction * BEYOND);
        let slot = Shape::path(link(&ends.0, &ends.1, SLOT)).fill(FILL).stroke(FOLLOWER, 1.0);
        canvas.draw(slot.attribute("stroke-opacity", "0.5").class("slot"));
        canvas.label(&(ends.0 - direction * SLOT), &-direction, 6.0, &Label::words("slot").in_colour(FOLLOWER));
        let horizontal = if direction.x < 0.0 { PI } else { 0.0 };
        if along.norm() > 2.0 * AT_TIP {
            angle_from(canvas, &at.tip, horizontal, angle_of(&along), AT_TIP, true);
        }
    }
    let across = at.corner - at.tail;
    if across.norm() > AT_TAIL {
        let vertical = if across.y > 0.0 { -FRAC_PI_2 } else { FRAC_PI_2 };
        angle_from(canvas, &at.tail, vertical, angle_of(&across), AT_TAIL, false);
    }
    right_angle(canvas, &at.corner, &(at.tail - at.corner), &(at.tip - at.corner), 15.0);
    // γ is narrow: its arc leads out across the pin's velocity to the label.
    let (slot, pin) = (angle_of(&along), angle_of(&(at.tail - at.tip)));
    let turn = wrapped(pin - slot);
    let radius = 0.36 * (at.tail - at.tip).norm();
    let out = pin + turn.signum() * 20.0 / radius.max(20.0);
    part(canvas, "γ", |canvas| arc(canvas, &at.tip, radius, out - wrapped(out - slot), out, INK, 1.5));
    let end = at.tip + heading(out) * radius;
    canvas.label(&end, &at.outwards(&at.tail, &at.tip), 6.0, &angle_label("γ", instant.velocity_angle()).of_part("γ"));
}

/// A reference direction at `corner`, and the angle from it to another, drawn as an arc of so many pixels.
fn angle_from(canvas: &mut Canvas, corner: &Pixels, reference: f64, angle: f64, radius: f64, with_value: bool) {
    let turn = wrapped(angle - reference);
    if turn.abs() < NARROWEST {
        return;
    }
    canvas.draw(Shape::line(corner, &(corner + heading(reference) * (radius + 40.0))).stroke(GRID, 1.3).dashed(DASHED));
    part(canvas, "φ", |canvas| arc(canvas, corner, radius, reference, reference + turn, INK, 1.5));
    let middle = heading(reference + turn / 2.0);
    let label = if with_value {
        Label::words("|").and_symbol("φ").and(&format!("| = {}", degrees(turn.abs())))
    } else {
        Label::words("|").and_symbol("φ").and("|")
    };
    canvas.label(&(corner + middle * radius), &middle, 8.0, &label.of_part("φ"));
}

/// The three arrows with their symbols and magnitudes.
fn vectors(canvas: &mut Canvas, at: &Layout, instant: &PinState, unit: &str) {
    let magnitude = |index: &str, speed: f64| {
        Label::symbol("v")
            .sub(index)
            .of_part(&format!("v_{index}"))
            .and(&format!(" = {} {unit}", significant(speed, 4)))
    };
    let [pin, slot_point, sliding] = instant.speeds();
    part(canvas, "v_P", |canvas| arrow(canvas, &at.tail, &at.tip, DRIVER, 3.5, "v-pin"));
    part(canvas, "v_P′", |canvas| arrow(canvas, &at.tail, &at.corner, FOLLOWER, 3.5, "v-slot-point"));
    part(canvas, "v_P/S", |canvas| arrow(canvas, &at.corner, &at.tip, RELATIVE, 3.5, "v-sliding"));
    for (from, to, share, label) in [
        (&at.tail, &at.tip, 0.36, magnitude("P", pin).in_colour(DRIVER)),
        (&at.tail, &at.corner, 0.5, magnitude("P′", slot_point).in_colour(FOLLOWER)),
        (&at.corner, &at.tip, 0.5, magnitude("P/S", sliding).in_colour(RELATIVE)),
    ] {
        canvas.label(&from.lerp(to, share), &at.outwards(from, to), 14.0, &label);
    }
}

/// An angle in radians, brought into (−π, π].
fn wrapped(angle: f64) -> f64 {
    Turn::from_radians(angle).radians()
}
