//! The mechanism in motion: one large drawing that moves, and the steps of a cycle side by side.

use super::cycle::{Key, keys};
use super::pose::{WheelMargins, WheelPose, count_noun};
use crate::number::{degrees, format_trimmed};
use crate::parts::WIDTH;
use crate::svg::{Canvas, DrawingKind, Label, Pixels, Shape, heading};
use crate::theme::{DRIVER, FOLLOWER, GRID};
use crate::{Figure, Series, Words, moving};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::f64::consts::PI;

const LARGE: WheelMargins = WheelMargins { left: 70.0, right: 70.0, above: 10.0, below: 24.0 };
/// Frames in a row, and the space about each.
const COLUMNS: usize = 3;
const SMALL: WheelMargins = WheelMargins { left: 10.0, right: 10.0, above: 58.0, below: 10.0 };
/// Seconds that the driver takes for a turn.
const TURN: f64 = 6.0;
/// Where the large drawing stands when it does not move: this part of the way from the line of centres to entry.
const AT_REST: f64 = 0.5;

/// One frame: what it is called, and the angles in it.
struct Frame {
    name: &'static str,
    theta: f64,
    phi: f64,
}

/// The mechanism over one cycle: steps of the advance and the dwell, numbered, and above them one drawing that moves.
///
/// The motion is made of CSS key frames within the SVG, whose names begin with the figure's id; straight lines between
/// them keep to 0.05° of the wheel's angle. It needs no script, rests while the pointer is on it, and stands still on
/// paper and for readers who want less motion. Series: the key frames, as shares of the cycle from the middle of a
/// dwell to the middle of the next, with θ and φ in degrees.
pub fn motion(wheel: &Wheel) -> Figure {
    let (name, keys) = ("wheel-motion", keys(wheel));
    let large = WheelPose::new(wheel, WIDTH, LARGE);
    let small = WheelPose::new(wheel, WIDTH / COLUMNS as f64, SMALL);
    let frames = frames(wheel);
    let rows = frames.len().div_ceil(COLUMNS);
    let mut canvas = Canvas::new(WIDTH, large.height + small.height * rows as f64);
    canvas.draw_markup(style(name, wheel, &keys));
    draw_moving(&mut canvas, &large, wheel, name);
    for (k, frame) in frames.iter().enumerate() {
        let corner = Vector2::new((k % COLUMNS) as f64 / COLUMNS as f64 * WIDTH, (k / COLUMNS) as f64 * small.height);
        still(&mut canvas, &small, &(corner + Vector2::new(0.0, large.height)), k + 1, frame);
    }

    let steps: Vec<String> =
        frames.iter().enumerate().map(|(k, at)| format!("{} {}, at {}", k + 1, at.name, degrees(at.theta))).collect();
    let words = Words::new(
        name,
        format!("One cycle of a wheel with {} stations and {}", wheel.stations(), count_noun(wheel.pins(), "pin")),
        format!(
            "The mechanism as it turns, the driver clockwise and the wheel counter-clockwise, and its steps: {}. A dot \
             marks the same arm of the wheel in each.",
            steps.join("; ")
        ),
        format!(
            "Animated: one cycle of a wheel with {}, the driver at constant speed. To stop the upper drawing, \
             tick the box or rest the pointer on it. If your system asks for reduced motion, the drawing stands still. Below, the same cycle in {} positions, \
             each with its crank angle θ.",
            count_noun(wheel.stations(), "station"),
            frames.len()
        ),
    );
    words.figure(canvas, DrawingKind::Mechanism, series(&keys))
}

/// The mechanism as it turns, alone: a drawing that moves, as the upper one of [`motion`] does.
///
/// Series: as of [`motion`].
pub fn turning(wheel: &Wheel) -> Figure {
    let (name, keys) = ("wheel-turning", keys(wheel));
    let large = WheelPose::new(wheel, WIDTH, LARGE);
    let mut canvas = Canvas::new(WIDTH, large.height);
    canvas.draw_markup(style(name, wheel, &keys));
    draw_moving(&mut canvas, &large, wheel, name);
    let words = Words::new(
        name,
        format!("A Geneva wheel with {} slots, turning", wheel.stations()),
        "A driver turns evenly and carries a pin. The pin enters a slot of the star wheel, turns the wheel by one station and \
         leaves; then the wheel stands still, held by the driver's locking disc, until the pin comes round again.",
        "The driver turns at constant speed. The wheel turns in steps and stands still in between.",
    );
    words.figure(canvas, DrawingKind::Mechanism, series(&keys))
}

/// The key frames: share of the cycle, both angles in degrees.
fn series(keys: &[Key]) -> Series {
    let row = |key: &Key| [key.share, key.theta.to_degrees(), key.phi.to_degrees()];
    Series::new([("cycle", "1"), ("theta", "deg"), ("phi", "deg")], keys.iter().map(row))
}

/// Entry, line of centres, exit, the places half-way between them, and the middle of the dwell if there is one.
fn frames(wheel: &Wheel) -> Vec<Frame> {
    let half = wheel.engagement_half_angle();
    let at = |name, theta| Frame { name, theta, phi: wheel.engaged(theta).map_or(0.0, |motion| motion.angle) };
    let mut frames = vec![
        at("entry", -half),
        at("speeding up", -half / 2.0),
        at("fastest", 0.0),
        at("slowing down", half / 2.0),
        at("exit", half),
    ];
    if wheel.dwell_fraction() > 1e-9 {
        frames.push(Frame { name: "dwell", theta: PI / f64::from(wheel.pins()), phi: wheel.half_pitch_angle() });
    }
    frames
}

/// The rules that move the large drawing, in one element: only on a screen, and only if motion is welcome.
///
/// The wheel advances within each cycle; about it, a second turn goes on by one station from cycle to cycle.
fn style(name: &str, wheel: &Wheel, keys: &[Key]) -> String {
    let cycle = TURN / f64::from(wheel.pins());
    let key = |key: &Key| {
        let (share, angle) = (format_trimmed(100.0 * key.share, 3), format_trimmed(-key.phi.to_degrees(), 2));
        format!("{share}%{{transform:rotate({angle}deg)}}")
    };
    let indexing: String = keys.iter().map(key).collect();
    let start = format_trimmed(-180.0 / f64::from(wheel.pins()), 4);
    let end = format_trimmed(360.0 - 180.0 / f64::from(wheel.pins()), 4);
    let (cycle, turn) = (format_trimmed(cycle, 6), format_trimmed(TURN, 6));
    let (stations, round) =
        (wheel.stations(), format_trimmed(TURN / f64::from(wheel.pins()) * f64::from(wheel.stations()), 6));
    let key_frames = format!(
        "@keyframes {name}-wheel{{{indexing}}}@keyframes {name}-round{{to{{transform:rotate(-360deg)}}}}@keyframes \
         {name}-driver{{from{{transform:rotate({start}deg)}}to{{transform:rotate({end}deg)}}}}"
    );
    let rules = format!(
        ".{name}-wheel{{animation:{name}-wheel {cycle}s linear infinite}}.{name}-round{{animation:{name}-round {round}s \
         steps({stations}) infinite}}.{name}-driver{{animation:{name}-driver {turn}s linear infinite}}"
    );
    moving::style(name, &key_frames, &rules)
}

/// The large drawing: each body about its own axis, turned by an attribute where the style does not move it.
fn draw_moving(canvas: &mut Canvas, at: &WheelPose, wheel: &Wheel, name: &str) {
    let theta = -AT_REST * wheel.engagement_half_angle();
    let phi = wheel.engaged(theta).map_or(0.0, |motion| motion.angle);
    let about = |point: &Pixels| {
        format!("transform=\"translate({} {})\"", format_trimmed(point.x, 2), format_trimmed(point.y, 2))
    };
    let turned = |body: &str, angle: f64| {
        format!("class=\"{name}-{body}\" transform=\"rotate({})\"", format_trimmed(angle.to_degrees(), 2))
    };
    let origin = Pixels::zeros();
    moving::on_field(canvas, name, &Vector2::new(WIDTH, at.height), |canvas| {
        canvas.draw(Shape::circle(&at.axis, at.view.scale).stroke(DRIVER, 1.3).dashed("2 4"));
        canvas.group(&about(&at.axis), |canvas| {
            canvas.group(&turned("driver", theta), |canvas| at.draw_arms(canvas, &origin, 0.0));
        });
        canvas.group(&about(&at.pivot), |canvas| {
            canvas.group(&format!("class=\"{name}-round\""), |canvas| {
                canvas.group(&turned("wheel", -phi), |canvas| {
                    at.draw_wheel(canvas, &origin, 0.0, 2.0);
                    dot(canvas, at, &origin, 0.0);
                });
            });
        });
        canvas.group(&about(&at.axis), |canvas| {
            canvas.group(&turned("driver", theta), |canvas| at.draw_locking_disc(canvas, &origin, 0.0, 2.0));
        });
    });
}

/// One step, with its number, its name and its crank angle.
fn still(canvas: &mut Canvas, at: &WheelPose, corner: &Pixels, number: usize, frame: &Frame) {
    let at = at.translate(corner);
    canvas.draw(Shape::circle(&at.axis, at.view.scale).stroke(GRID, 1.0));
    at.draw(canvas, frame.theta, frame.phi, 1.3);
    dot(canvas, &at, &at.pivot, frame.phi);
    let middle = corner + Vector2::new(WIDTH / COLUMNS as f64 / 2.0, 14.0);
    let name = Label::words(&format!("{number} {}", frame.name));
    canvas.label(&middle, &Pixels::zeros(), 0.0, &name.bare());
    let angle = Label::symbol("θ").and(&format!(" = {}", degrees(frame.theta)));
    canvas.label(&(middle + Vector2::new(0.0, 24.0)), &Pixels::zeros(), 0.0, &angle.bare());
}

/// A dot on the arm of the wheel before the slot at `phi`, by which its turning can be followed.
fn dot(canvas: &mut Canvas, at: &WheelPose, pivot: &Pixels, phi: f64) {
    let (star, arm) = (&at.star, phi + PI / f64::from(at.star.slots));
    let radius = 0.72 * (star.centre - at.driver.locking_disc);
    let place = pivot + heading(arm) * (radius * at.view.scale);
    canvas.draw(Shape::circle(&place, (0.06 * at.view.scale).max(2.0)).fill(FOLLOWER).class("dot"));
}
