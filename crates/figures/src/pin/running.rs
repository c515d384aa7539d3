//! The mechanism with the velocity triangle at its pin, for a crank that a reader turns.

use super::instant::PinState;
use crate::number::{degrees, significant, without_noise};
use crate::parts::{arrow, construction, fixed_pivot, pin, pin_circle, sense, sides};
use crate::star::{SLOT_HALF_WIDTH, Star, rim_radius};
use crate::svg::{Canvas, DrawingKind, Label, Pixels, Placing, View, heading, positions_around, positions_beside_line};
use crate::theme::{DRIVER, FOLLOWER, INK, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Width of the drawing, in pixels: narrow enough for its letters to be read on a phone.
const WIDTH: f64 = 480.0;
/// Free space around the mechanism, in pixels.
const MARGIN: f64 = 10.0;
/// Length of the pin's velocity, in crank radii.
const VELOCITY: f64 = 0.95;
/// Width of the pin's outline and of the slot's, in pixels.
const OUTLINE: f64 = 1.5;
/// Angle beyond the engagement that is the rounding of its end, in radians.
const AT_THE_END: f64 = 1e-10;
/// A vector of fewer pixels is not drawn.
const SHORTEST: f64 = 1.0;
/// How far labels may be from what they name, in pixels.
const NEAR: [f64; 4] = [8.0, 14.0, 22.0, 32.0];

/// The mechanism at a crank angle, with the triangle of its axes and the pin, and the three velocities drawn at the pin.
///
/// O is the wheel's axis (left), B the driver's (right), P the pin; the wheel is drawn with the slots that its centre distance
/// suits. Outside of the engagement the wheel rests, and only the pin's velocity is drawn. `crank` is counter-clockwise from the direction O → B; `driver_speed` the driver's angular velocity in radians per
/// second, counter-clockwise positive; `speed_unit` the unit of the speeds that follow. The pin's velocity has the same length at
/// every angle. Series: θ, the three speeds, γ and φ, as for the [velocity triangle](super::velocity_triangle).
pub fn velocities_at_the_pin(mechanism: &PinSlot, crank: &Turn<f64>, driver_speed: f64, speed_unit: &str) -> Figure {
    let instant = PinState::new(mechanism, crank, driver_speed);
    let half_angle = mechanism.engagement_half_angle();
    let theta = instant.crank_angle - PI;
    let is_engaged = theta.abs() <= half_angle + AT_THE_END;
    // Beyond it, the wheel rests as the pin left it.
    let rest = (PI / 2.0 - half_angle).copysign(-theta);
    let wheel_angle = if is_engaged { instant.slot_angle } else { rest };
    let (l, r) = (mechanism.centre_distance(), mechanism.crank_radius());
    let rim = rim_radius(mechanism);
    let reach = r * libm::hypot(1.0, VELOCITY);
    let scale = (WIDTH - 2.0 * MARGIN) / (rim + l + reach);
    let half = rim.max(reach) * scale + MARGIN;
    let view = View { origin: Vector2::new(MARGIN + rim * scale, half), scale };
    let (pivot, axis) = (view.origin, view.place(&Vector2::new(l, 0.0)));
    let at = view.place(&instant.position);

    let mut canvas = Canvas::new(WIDTH, 2.0 * half);
    let mut placing = Placing::new(Vector2::zeros(), Vector2::new(WIDTH, 2.0 * half));
    pin_circle(&mut canvas, &axis, r * scale);
    let wheel = Star::of_pin_slot(mechanism).body(wheel_angle, &view, OUTLINE);
    canvas.draw(wheel.attribute("stroke-opacity", "0.6").class("follower"));
    construction(&mut canvas, &axis, &(axis + Vector2::new(reach * scale, 0.0)), "line-of-centres");
    sides(&mut canvas, [(&pivot, &axis, INK, "l"), (&axis, &at, DRIVER, "R")]);
    if is_engaged {
        sides(&mut canvas, [(&pivot, &at, FOLLOWER, "r")]);
    }
    for (from, to) in [(&pivot, &axis), (&axis, &at), (&pivot, &at)] {
        placing.avoid(from, to, 1.0);
    }
    fixed_pivot(&mut canvas, &pivot, 1.0);
    fixed_pivot(&mut canvas, &axis, 1.0);
    pin(&mut canvas, &at, SLOT_HALF_WIDTH * scale * r - OUTLINE / 2.0 - 1.0);
    let turning = if is_engaged { without_noise(instant.speed_ratio, 1.0) * driver_speed.signum() } else { 0.0 };
    sense(&mut canvas, &axis, 0.42 * r * scale, -0.9, driver_speed, &Label::rate("θ", 1).in_colour(DRIVER));
    sense(&mut canvas, &pivot, 0.42 * rim * scale, PI, turning, &Label::rate("φ", 1).in_colour(FOLLOWER));
    vectors(&mut canvas, &mut placing, &instant, &view, is_engaged);
    placing.put(&mut canvas, &Label::words("P"), positions_around(&at, 1.0, &[14.0, 20.0, 28.0]));
    canvas.label(&pivot, &heading(-2.2), 16.0, &Label::words("O"));
    canvas.label(&axis, &heading(-0.5), 18.0, &Label::words("B"));

    words(&instant, speed_unit, is_engaged).figure(canvas, DrawingKind::Mechanism, series(&instant, speed_unit))
}

/// The pin's velocity, and the two parts of it end to end, with their names.
fn vectors(canvas: &mut Canvas, placing: &mut Placing, instant: &PinState, view: &View, is_engaged: bool) {
    let speed = instant.pin_velocity.norm();
    let radius = (instant.position.norm() / instant.radius_ratio) * VELOCITY;
    // As long at every angle: a length of the mechanism in place of a speed.
    let shown = |velocity: Vector2<f64>| velocity * (radius / speed);
    let (start, tip) = (instant.position, instant.position + shown(instant.pin_velocity));
    let corner = instant.position + shown(instant.slot_point_velocity);
    let placed: Vec<(Pixels, Pixels, Label)> = [
        (start, tip, "P", DRIVER, 3.4, "v-pin"),
        (start, corner, "P′", FOLLOWER, 2.8, "v-slot-point"),
        (corner, tip, "P/S", RELATIVE, 2.8, "v-sliding"),
    ]
    .into_iter()
    .take(if is_engaged { 3 } else { 1 })
    .filter_map(|(from, to, index, colour, width, name)| {
        let (from, to) = (view.place(&from), view.place(&to));
        ((to - from).norm() >= SHORTEST).then(|| {
            arrow(canvas, &from, &to, colour, width, name);
            placing.avoid(&from, &to, 1.5);
            (from, to, Label::symbol("v").sub(index).in_colour(colour))
        })
    })
    .collect();
    for (from, to, label) in placed {
        let beside = positions_beside_line(&from, &to, &NEAR).into_iter().chain(positions_around(&to, 0.0, &NEAR));
        placing.put(canvas, &label, beside);
    }
}

fn series(instant: &PinState, speed_unit: &str) -> Series {
    let speeds = instant.speeds();
    Series::of_one([
        ("theta", "deg", (instant.crank_angle - PI).to_degrees()),
        ("v_P", speed_unit, speeds[0]),
        ("v_P'", speed_unit, speeds[1]),
        ("v_P/S", speed_unit, speeds[2]),
        ("gamma", "deg", instant.velocity_angle().to_degrees()),
        ("phi", "deg", -instant.slot_angle.to_degrees()),
    ])
}

fn words(instant: &PinState, speed_unit: &str, is_engaged: bool) -> Words {
    let theta = degrees(instant.crank_angle - PI);
    if !is_engaged {
        return Words::new(
            "live-pin",
            format!("A wheel at rest at a crank angle of {theta}, with the pin outside of its slots"),
            "The wheel's axis O on the left, the driver's axis B on the right, and the pin P on its circle, outside of the wheel's \
             slots. One arrow at the pin: its velocity.",
            format!(
                "The mechanism at θ = {theta}, to scale. The pin is outside of the slots, and the wheel stands still."
            ),
        );
    }
    let [pin, across, along] = instant.speeds().map(|speed| format!("{} {speed_unit}", significant(speed, 4)));
    Words::new(
        "live-pin",
        format!("A pin in the slot of a wheel at a crank angle of {theta}, and its velocities"),
        format!(
            "The wheel's axis O on the left, the driver's axis B on the right, and the pin P in a slot of the wheel. Three arrows \
             at the pin: its velocity, {pin}, and end to end the two parts of it, the velocity of the wheel's point under the pin, \
             {across}, across the slot, and the sliding velocity, {along}, along the slot."
        ),
        format!(
            "The mechanism at θ = {theta}, to scale. The pin's velocity is the sum of two: across the slot, where it turns the \
             wheel, and along the slot."
        ),
    )
}
