//! The triangle of the two axes and the pin, drawn on the mechanism.

use super::instant::PinState;
use crate::number::{degrees, significant, without_noise};
use crate::parts::{
    self, angle_label, arc, arc_arrow, construction, dimension, fixed_pivot, part, pin, pin_circle, sense,
};
use crate::star::{SLOT_HALF_WIDTH, Star, rim_radius};
use crate::svg::{Canvas, DrawingKind, Label, Pixels, Shape, View, heading};
use crate::theme::{DRIVER, FOLLOWER, INK, PAPER};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Width of the drawing, in pixels: narrow enough for its letters to be read on a phone.
const WIDTH: f64 = 460.0;
/// Free space around the mechanism, in pixels.
const MARGIN: f64 = 14.0;
/// Radius of the driver's disc, in crank radii.
const DISC: f64 = 1.13;
/// Radius of the mark of the slot's angle, in pixels.
const AT_PIVOT: f64 = 46.0;
/// Width of the pin's outline and of the slot's, in pixels.
const OUTLINE: f64 = 1.5;
/// Room on the far side of the line of centres for the dimension of the centre distance, in pixels.
const DIMENSION: f64 = 62.0;
/// Room for the row of the crank angle beyond it.
const ROW: f64 = 27.0;

/// The narrowest angle at the pivot that has room for its mark, in radians.
const NARROWEST: f64 = 0.25;

/// Where the corners of the triangle lie on the page, and what places the rest.
struct Layout {
    view: View,
    pivot: Pixels,
    axis: Pixels,
    pin: Pixels,
    /// Crank radius in pixels.
    crank: f64,
    /// +1 if the pin is above the line of centres, −1 below: the drawing is mirrored.
    side: f64,
    height: f64,
}

impl Layout {
    fn new(mechanism: &PinSlot, instant: &PinState) -> Self {
        let (l, r, rim) = (mechanism.centre_distance(), mechanism.crank_radius(), rim_radius(mechanism));
        let disc = DISC * r;
        let scale = (WIDTH - 2.0 * MARGIN) / (rim + l + disc);
        let reach = rim.max(disc) * scale + MARGIN;
        let height = 2.0 * reach + DIMENSION + ROW - MARGIN / 2.0;
        let side = instant.side();
        let level = if side > 0.0 { reach } else { height - reach };
        let view = View { origin: Vector2::new(MARGIN + rim * scale, level), scale };
        let axis = view.place(&Vector2::new(l, 0.0));
        Self { view, pivot: view.origin, axis, pin: view.place(&instant.position), crank: r * scale, side, height }
    }

    /// A direction of the page at so many degrees counter-clockwise, mirrored with the drawing.
    fn towards(&self, degrees: f64) -> Pixels {
        heading(self.side * degrees.to_radians())
    }
}

/// The triangle O P B at a crank angle, to scale, on the follower and the pin's circle.
///
/// O is the follower's pivot (left), B the driver's axis (right), P the pin. `crank` is counter-clockwise from the
/// direction O → B, meant to be within the engagement. Lengths are labelled in crank radii R, so no unit is needed;
/// the driver is shown turning counter-clockwise. Series: θ, l/R, r/R, φ, the pin's coordinates in crank radii.
pub fn position_triangle(mechanism: &PinSlot, crank: &Turn<f64>) -> Figure {
    let instant = PinState::new(mechanism, crank, 1.0);
    let layout = Layout::new(mechanism, &instant);
    let mut canvas = Canvas::new(WIDTH, layout.height);
    bodies(&mut canvas, &layout, mechanism, &instant);
    angles(&mut canvas, &layout, &instant);
    sides(&mut canvas, &layout, mechanism, &instant);
    senses(&mut canvas, &layout, &instant);

    let ratio = mechanism.ratio();
    let position = instant.position / mechanism.crank_radius();
    let series = Series::of_one([
        ("theta", "deg", (instant.crank_angle - PI).to_degrees()),
        ("l/R", "1", ratio),
        ("r/R", "1", instant.radius_ratio),
        ("phi", "deg", -instant.slot_angle.to_degrees()),
        ("x_P/R", "1", position.x),
        ("y_P/R", "1", position.y),
    ]);
    let (theta, slot) = (degrees(instant.crank_angle - PI), degrees(instant.slot_angle));
    let from_extension = degrees(instant.crank_angle);
    let (l, r) = (significant(ratio, 4), significant(instant.radius_ratio, 4));
    let words = Words::new(
        "pin-position",
        format!("The triangle of the two axes and the pin at a crank angle of {theta}"),
        format!(
            "The follower's pivot O on the left, the driver's axis B on the right at a distance of {l} crank radii, and \
             the pin P on the crank circle about B, at an angle of {from_extension} from the extension of OB beyond B. \
             P lies in a slot of the follower: OP is {r} crank radii long and makes an angle of {slot} with OB."
        ),
        format!(
            "The wheel S turns about O. The driver D turns about B and carries the pin P. The drawing is to scale. The crank \
             BP is at {from_extension} from the extension of OB, so its angle from the line of centres is θ = {theta}. One \
             slot lies along OP."
        ),
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

/// The driver's disc, the follower with its slots over it and the pin's circle, in the background.
fn bodies(canvas: &mut Canvas, at: &Layout, mechanism: &PinSlot, instant: &PinState) {
    canvas.draw(Shape::circle(&at.axis, DISC * at.crank).stroke(DRIVER, 1.5).class("driver"));
    let follower = Star::of_pin_slot(mechanism);
    canvas.draw(Shape::path(follower.outline(instant.slot_angle, &at.view)).fill(PAPER).class("follower-paper"));
    let body = follower.body(instant.slot_angle, &at.view, OUTLINE);
    canvas.draw(body.attribute("stroke-opacity", "0.6").class("follower"));
    pin_circle(canvas, &at.axis, at.crank);
    construction(canvas, &at.axis, &(at.axis + Vector2::new(DISC * at.crank, 0.0)), "line-of-centres");
}

/// The three sides with their lengths, and the corners.
fn sides(canvas: &mut Canvas, at: &Layout, mechanism: &PinSlot, instant: &PinState) {
    let beyond = 0.55 * DIMENSION + ROW;
    let row = if at.side > 0.0 { at.height - beyond } else { beyond };
    let drop = Vector2::new(0.0, row - at.pivot.y);
    let middle = dimension(canvas, &at.pivot, &at.axis, &drop);
    let triangle =
        [(&at.pivot, &at.axis, INK, "l"), (&at.axis, &at.pin, DRIVER, "R"), (&at.pivot, &at.pin, FOLLOWER, "r")];
    parts::sides(canvas, triangle);
    fixed_pivot(canvas, &at.pivot, at.side);
    fixed_pivot(canvas, &at.axis, at.side);
    // As wide as the slot: the two outlines touch.
    pin(canvas, &at.pin, SLOT_HALF_WIDTH * at.crank - OUTLINE / 2.0 - 1.0);

    let length =
        |letter: &str, ratio: f64| Label::part(letter).and(&format!(" = {} ", significant(ratio, 4))).and_symbol("R");
    // The lengths and the angles that have no room at their places stand in the dimension's row and beyond it.
    let (right, level) = (Vector2::new(1.0, 0.0), middle + Vector2::new(0.0, -14.0));
    canvas.label(&level, &Pixels::zeros(), 0.0, &length("l", mechanism.ratio()));
    let r = length("r", instant.radius_ratio).in_colour(FOLLOWER);
    canvas.label(&Vector2::new(WIDTH, level.y), &-right, MARGIN, &r);
    canvas.label(&Vector2::new(0.0, level.y), &right, MARGIN, &angle_label("φ", -instant.slot_angle).of_part("φ"));
    let beyond = Vector2::new(0.0, level.y + at.side * ROW);
    canvas.label(&beyond, &right, MARGIN, &angle_label("θ", instant.crank_angle - PI).of_part("θ"));
    let across = heading(instant.slot_angle + at.side * PI / 2.0);
    canvas.label(&at.pivot.lerp(&at.pin, 0.4), &across, 16.0, &Label::part("r").in_colour(FOLLOWER));
    let across = heading(instant.crank_angle - at.side * PI / 2.0);
    canvas.label(&at.axis.lerp(&at.pin, 0.5), &across, 14.0, &Label::part("R").in_colour(DRIVER));
    canvas.label(&at.pivot, &at.towards(200.0), 16.0, &Label::words("O"));
    canvas.label(&at.axis, &at.towards(-20.0), 20.0, &Label::words("B"));
    canvas.label(&at.pin, &at.towards(135.0), 16.0, &Label::words("P"));
}

/// The angles at O and at B.
fn angles(canvas: &mut Canvas, at: &Layout, instant: &PinState) {
    let (slot, crank) = (instant.slot_angle, instant.crank_angle);
    let half_turn = at.side * PI;
    let crank = if at.side > 0.0 { crank } else { crank - 2.0 * PI };
    if slot.abs() > NARROWEST {
        part(canvas, "φ", |canvas| arc(canvas, &at.pivot, AT_PIVOT, 0.0, slot, INK, 1.5));
        let middle = heading(slot / 2.0);
        canvas.label(&(at.pivot + middle * AT_PIVOT), &middle, 6.0, &Label::part("φ"));
    }
    arc_arrow(canvas, &at.axis, 40.0, 0.0, crank, INK, 1.5);
    let middle = at.towards(58.0);
    canvas.label(&(at.axis + middle * 40.0), &middle, 10.0, &Label::words(&degrees(instant.crank_angle)));
    // θ is too narrow for its label: the arc leads out of the triangle to it.
    let out = half_turn + at.side * 0.3;
    part(canvas, "θ", |canvas| arc(canvas, &at.axis, 58.0, crank, out, INK, 1.5));
    canvas.label(&(at.axis + heading(out) * 58.0), &at.towards(-80.0), 18.0, &Label::part("θ"));
}

/// The names of the two bodies and which way they turn, for a driver turning counter-clockwise.
fn senses(canvas: &mut Canvas, at: &Layout, instant: &PinState) {
    let [driver, follower] = [("D", "θ", DRIVER), ("S", "φ", FOLLOWER)].map(|(name, letter, colour)| {
        (Label::words(name).in_colour(colour), Label::rate(letter, 1).of_part(&format!("{letter}'")).in_colour(colour))
    });
    let face = at.axis + at.towards(72.0) * 0.78 * at.crank;
    canvas.label(&face, &Pixels::zeros(), 0.0, &driver.0);
    let lobe = at.pivot + heading(instant.slot_angle + at.side * PI / 4.0) * 0.54 * at.crank;
    canvas.label(&lobe, &Pixels::zeros(), 0.0, &follower.0);

    sense(canvas, &at.axis, 0.74 * at.crank, -at.side * 0.72, 1.0, &driver.1);
    // At entry and exit the follower stands still and has no sense.
    sense(canvas, &at.pivot, 58.0, PI, without_noise(instant.speed_ratio, 1.0), &follower.1);
}
