//! The whole mechanism to scale, locked.

use super::pose::{WheelMargins, WheelPose, count_noun};
use crate::number::significant;
use crate::parts::{WIDTH, pin_circle, sense};
use crate::svg::{Canvas, DrawingKind, Label, Pixels, Shape, heading};
use crate::theme::{DRIVER, FOLLOWER, INK};
use crate::{Figure, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

const MARGINS: WheelMargins = WheelMargins { left: 50.0, right: 50.0, above: 44.0, below: 44.0 };
/// From the outermost of a body to the arrow of its sense, in pixels.
const TO_ARROW: f64 = 16.0;
/// A crank of so few pixels has no room about it for names.
const SMALL: f64 = 70.0;
/// A face this far across (pixels) has room for its name.
const WIDEST_NAME: f64 = 85.0;

/// Wheel and driver at rest between two advances, to scale.
///
/// The driver turns clockwise, the wheel counter-clockwise. The crank angle is chosen so that the locking disc fills
/// the wheel's locking arc, if the driver has a locking disc that long. The locking disc's radius is free: it is such
/// that the wall between a slot and a locking arc is as thick as the slot is wide. Series: N, pins, and the sizes in
/// crank radii: centre distance, wheel, least slot length, locking arcs; then α, θ and φ as drawn.
pub fn mechanism(wheel: &Wheel) -> Figure {
    let bodies = WheelPose::new(wheel, WIDTH, MARGINS);
    let (theta, phi) = (-locked_crank(&bodies), -wheel.half_pitch_angle());
    let mut canvas = Canvas::new(WIDTH, bodies.height);
    pin_circle(&mut canvas, &bodies.axis, bodies.view.scale);
    bodies.draw(&mut canvas, theta, phi, 2.0);
    senses(&mut canvas, &bodies);
    names(&mut canvas, &bodies, wheel, theta);

    let (l, rim, locking_disc) = (bodies.star.centre, bodies.star.rim, bodies.driver.locking_disc);
    let series = Series::of_one([
        ("N", "1", f64::from(wheel.stations())),
        ("pins", "1", f64::from(wheel.pins())),
        ("l/r", "1", l),
        ("wheel/r", "1", rim),
        ("slot/r", "1", wheel.slot_length_ratio()),
        ("locking disc/r", "1", locking_disc),
        ("alpha", "deg", wheel.half_pitch_angle().to_degrees()),
        ("theta", "deg", theta.to_degrees()),
        ("phi", "deg", phi.to_degrees()),
    ]);
    let locks = if locks_fully(&bodies) { "The locking disc fills the locking arc that faces it. " } else { "" };
    let (stations, pins) = (wheel.stations(), count_noun(wheel.pins(), "pin"));
    let words = Words::new(
        "wheel-mechanism",
        format!("Geneva mechanism with {stations} stations and {pins}, locked"),
        format!(
            "At the left a star wheel with {stations} slots and a hollow locking arc between each two; at the right, \
             at a distance of {} crank radii, the driver: a round locking disc with a cut-out before each pin, and \
             {pins} on an arm that turns behind the wheel. {locks}The wheel's radius is {} crank radii, the locking \
             disc's {}. The driver turns clockwise, the wheel counter-clockwise.",
            significant(l, 4),
            significant(rim, 4),
            significant(locking_disc, 4)
        ),
        "The mechanism to scale, while the wheel is locked. The locking disc fills a hollow of the wheel, a locking arc, until \
         the pin reaches the next slot.",
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

/// How far before the line of centres the next pin is: half-way through the part of the dwell in which the locking disc
/// fills the locking arc; in the middle of the dwell if it never does.
fn locked_crank(bodies: &WheelPose) -> f64 {
    let middle = bodies.driver.pitch() / 2.0;
    if locks_fully(bodies) {
        (bodies.driver.half_angle + bodies.star.locking_half_angle() + middle) / 2.0
    } else {
        middle
    }
}

/// Whether the locking disc ever fills a whole locking arc.
fn locks_fully(bodies: &WheelPose) -> bool {
    bodies.driver.half_angle + bodies.star.locking_half_angle() < bodies.driver.pitch() / 2.0
}

/// Which way the two turn: arrows outside both, and their angles.
fn senses(canvas: &mut Canvas, at: &WheelPose) {
    let scale = at.view.scale;
    let [phi, theta] = [("φ", FOLLOWER), ("θ", DRIVER)].map(|(letter, colour)| Label::symbol(letter).in_colour(colour));
    sense(canvas, &at.pivot, at.star.rim * scale + TO_ARROW, PI, 1.0, &phi);
    // Clear of the name of a single pin at the lower right.
    let raised = if at.driver.pins == 1 { 29.0 / scale } else { 0.0 };
    sense(canvas, &at.axis, (1.0 + at.driver.arm) * scale + TO_ARROW, raised, -1.0, &theta);
}

/// Names of the parts, where there is room for them.
fn names(canvas: &mut Canvas, at: &WheelPose, wheel: &Wheel, theta: f64) {
    let (star, driver, scale) = (&at.star, &at.driver, at.view.scale);
    let (step, up) = (2.0 * wheel.half_pitch_angle(), Vector2::new(0.0, -1.0));
    // The slot and the locking arc nearest to where their names have room.
    let slot = nearest(step / 2.0, step, 0.72 * PI);
    let middle = at.on_wheel((star.bottom + star.rim) / 2.0, slot);
    let level = libm::sin(slot).abs() < 0.3;
    let end = if level { middle - up * 0.46 * scale } else { at.on_wheel(star.rim + 16.0 / scale, slot) };
    leader(canvas, &middle, &end, &(end - middle), "slot");
    let notch = nearest(0.0, step, FRAC_PI_2);
    let locking = at.on_wheel(star.centre - driver.locking_disc, notch);
    leader(canvas, &locking, &at.on_wheel(star.rim + 2.0 / scale, notch), &up, "locking arc");

    // Below the circle where it is too small to keep the name above it clear of the wheel and the arrow.
    let outwards = if driver.pins == 1 && scale < SMALL { -up } else { up };
    let edge = at.axis + outwards * (1.0 + driver.arm) * scale;
    canvas.label(&edge, &outwards, 9.0, &Label::words("crank circle").in_colour(DRIVER));
    // The pin nearest to the lower right, where nothing else is.
    let crank = WheelPose::crank_direction(theta);
    let pin = nearest(crank, driver.pitch(), -1.05);
    let below = at.axis + heading(pin) * scale - up * driver.arm * scale;
    canvas.label(&below, &-up, 9.0, &Label::words("pin"));
    if driver.pins == 1 && driver.locking_disc * scale > WIDEST_NAME {
        let face = at.axis - heading(crank) * (0.45 * driver.locking_disc * scale);
        canvas.label(&face, &Pixels::zeros(), 0.0, &Label::words("locking disc").bare());
    }
    if wheel.stations() > 3 {
        let lobe = nearest(0.0, step, -FRAC_PI_2);
        let face = at.on_wheel(0.6 * (star.centre - driver.locking_disc), lobe);
        canvas.label(&face, &Pixels::zeros(), 0.0, &Label::words("wheel").bare());
    }
}

/// The angle nearest to `wanted` among `first` and those any number of `step` away.
fn nearest(first: f64, step: f64, wanted: f64) -> f64 {
    first + libm::round((wanted - first) / step) * step
}

/// A line from a part to its name, which stands beyond the line's end in the direction of `towards`.
fn leader(canvas: &mut Canvas, part: &Pixels, end: &Pixels, towards: &Pixels, name: &str) {
    canvas.draw(Shape::line(part, end).stroke(INK, 1.0));
    canvas.draw(Shape::circle(part, 2.5).fill(INK));
    canvas.label(end, towards, 8.0, &Label::words(name));
}
