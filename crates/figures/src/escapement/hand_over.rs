//! The instant at which one pin leaves its slot and the next enters one.

use super::pose::{EscapementMargins, EscapementPose, half_angle, id, side};
use crate::number::{degrees, significant};
use crate::parts::{NEAR, WIDTH, angle, right_angle, vector};
use crate::svg::{Canvas, DASHED, DrawingKind, Label, Pixels, Placing, Shape, positions_around, positions_beside_line};
use crate::theme::{DRIVER, FOLLOWER, INK, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::Field;
use geneva_kinematics::escapement::{Configuration, Mechanism, Roots, Slot};
use nalgebra::Vector2;
use std::f64::consts::PI;

const MARGINS: EscapementMargins = EscapementMargins { side: 30.0, above: 50.0, below: 40.0 };
/// Lengths in pixels: of the velocities, of the right angle's mark, of the slot's line beyond the pin.
const VELOCITY: f64 = 78.0;
const CORNER: f64 = 20.0;
const BEYOND: f64 = 100.0;
/// Radii of the marks of the angles, over the sides there.
const MARK: f64 = 0.36;

/// The hand-over to scale: the right-angled triangle of the leaving pin, its mirror image for the entering one, and the
/// velocity of both along the centre lines of their slots.
///
/// The places are those of the exact hand-over, rounded once. Series: n, m, θ₀, φ₀, their sum, r/r, R/r, c/r, and each
/// pin's velocity, outwards along its slot and across it, over that of the pins.
pub fn hand_over(escapement: &Mechanism) -> Figure {
    let exact = escapement.hand_over();
    let angles = [escapement.engagement_half_angle(), escapement.follower_half_angle()];
    let bodies = EscapementPose::new(escapement, rounded(&exact.layout), angles, MARGINS);
    let mut canvas = Canvas::new(WIDTH, bodies.height);
    let mut placing = bodies.placing();
    canvas.faint(0.55, "", |canvas| {
        bodies.draw_driver(canvas, 1.3);
        bodies.draw_follower(canvas, 1.3);
    });
    let [leaving, entering] = [1.0, -1.0].map(|sense| bodies.on_driver(1.0, sense * bodies.theta));
    triangle(&mut canvas, &mut placing, &bodies, &leaving, &entering);
    let directions = [(leaving, 1.0, "leaves"), (entering, -1.0, "enters")];
    for (pin, outward, name) in directions {
        velocity(&mut canvas, &mut placing, &bodies, &pin, outward, name);
    }
    names(&mut canvas, &mut placing, &bodies, &leaving, escapement);

    let speeds = [&exact.leaving, &exact.entering].map(|pin| [pin.outward.approximate(), pin.across.approximate()]);
    let [theta, phi] = angles.map(f64::to_degrees);
    let (n, m) = (escapement.slots(), escapement.pins());
    let (rim, ratio) = (escapement.rim_radius(), escapement.centre_distance_ratio());
    let series = Series::of_one([
        ("slots", "1", f64::from(n)),
        ("pins", "1", f64::from(m)),
        ("theta_0", "deg", theta),
        ("phi_0", "deg", phi),
        ("sum", "deg", theta + phi),
        ("R/R", "1", 1.0),
        ("r/R", "1", rim),
        ("l/R", "1", ratio),
        ("leaving along", "1", speeds[0][0]),
        ("leaving across", "1", speeds[0][1]),
        ("entering along", "1", speeds[1][0]),
        ("entering across", "1", speeds[1][1]),
    ]);
    let words = Words::new(
        id("hand-over", escapement),
        format!("The hand-over of the escapement with {n} slots and {m} pins"),
        format!(
            "A right-angled triangle: the driver's axis B, the follower's axis O and the leaving pin P, with the right \
             angle at P. The angle at B is θ₀ = π/{m}, {}; the angle at O is φ₀ = π/{n}, \
             {}. BP is R, OP is {} R, BO is l, {} \
             R. The triangle of the entering pin is its mirror image below the line of centres. \
             The leaving pin moves straight out along its slot, the entering pin straight in along its own.",
            degrees(angles[0]),
            degrees(angles[1]),
            significant(rim, 4),
            significant(ratio, 4)
        ),
        format!(
            "The hand-over with {m} pins and {n} slots; the driver, at the left, turns counter-clockwise. The crank \
             radius to each pin is at right angles to that pin's slot, so θ₀ + φ₀ is a quarter turn. Both pins therefore \
             move along their slots, and the follower stands still for an instant."
        ),
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

/// Exact places as floating-point numbers.
fn rounded(exact: &Configuration<Roots>) -> Configuration<f64> {
    let point = |at: &Vector2<Roots>| at.map(|x| x.approximate());
    let slot = |slot: &Slot<Roots>| Slot {
        direction: point(&slot.direction),
        mouth: point(&slot.mouth),
        bottom: point(&slot.bottom),
    };
    Configuration {
        follower_axis: point(&exact.follower_axis),
        pins: exact.pins.iter().map(point).collect(),
        slots: exact.slots.iter().map(slot).collect(),
        engaged: exact.engaged.clone(),
    }
}

/// The triangle of the leaving pin, and thinly that of the entering one; pins and axes.
fn triangle(canvas: &mut Canvas, placing: &mut Placing, at: &EscapementPose, leaving: &Pixels, entering: &Pixels) {
    for (centre, colour) in [(&at.axis, DRIVER), (&at.pivot, FOLLOWER)] {
        canvas.draw(Shape::line(centre, entering).stroke(colour, 1.6).dashed("10 4").class("mirror"));
        placing.avoid(centre, entering, 1.0);
    }
    side(canvas, placing, &at.axis, &at.pivot, INK, "l");
    side(canvas, placing, &at.axis, leaving, DRIVER, "R");
    side(canvas, placing, &at.pivot, leaving, FOLLOWER, "r");
    for pin in [leaving, entering] {
        right_angle(canvas, pin, &(at.axis - pin), &(at.pivot - pin), CORNER);
        let corner = pin + ((at.axis - pin).normalize() + (at.pivot - pin).normalize()) * CORNER;
        let (middle, room) = (pin.lerp(&corner, 0.6), Vector2::new(1.0, 1.0) * (0.6 * CORNER));
        placing.take([middle - room, middle + room]);
    }
    at.draw_pins(canvas);
    at.draw_axes(canvas);
}

/// A slot's centre line beyond the rim, and the velocity of the pin along it.
fn velocity(canvas: &mut Canvas, placing: &mut Placing, at: &EscapementPose, pin: &Pixels, outward: f64, name: &str) {
    let out = (pin - at.pivot).normalize();
    // The line is long enough for an arrow from the pin outwards; that of the entering pin ends at the pin's side of it.
    canvas.draw(Shape::line(pin, &(pin + out * BEYOND)).stroke(FOLLOWER, 1.2).dashed(DASHED).class("slot-line"));
    let tip = pin + out * (outward * VELOCITY);
    placing.avoid(pin, &(pin + out * BEYOND), 1.0);
    let label = Label::symbol("v").and(&format!(": {name}")).in_colour(RELATIVE);
    let class = if outward > 0.0 { "v-leaving" } else { "v-entering" };
    vector(canvas, placing, pin, &tip, 3.0, &label, class);
}

/// Angles, sides and corners.
fn names(canvas: &mut Canvas, placing: &mut Placing, at: &EscapementPose, leaving: &Pixels, escapement: &Mechanism) {
    let (n, m) = (escapement.slots(), escapement.pins());
    let symbol = |letter: &str| Label::symbol(letter).sub("0").of_part(&format!("{letter}_0"));
    let value = |letter: &str, count| symbol(letter).and(&format!(" = {}", half_angle(count)));
    // The values in the corners: the angles have no room for them.
    let (row, right) = (20.0, Vector2::new(1.0, 0.0));
    canvas.label(&Vector2::new(0.0, row), &right, 14.0, &value("θ", m).in_colour(DRIVER));
    canvas.label(&Vector2::new(WIDTH, row), &-right, 14.0, &value("φ", n).in_colour(FOLLOWER));
    let rim = (leaving - at.pivot).norm();
    angle(canvas, placing, &at.axis, MARK * at.view.scale, (0.0, at.theta), &symbol("θ"));
    let mark = (MARK * rim).max(34.0);
    angle(canvas, placing, &at.pivot, mark, (PI, PI - at.phi), &symbol("φ"));
    let sides = [
        (&at.axis, leaving, Label::part("R").in_colour(DRIVER)),
        (&at.pivot, leaving, Label::part("r").in_colour(FOLLOWER)),
        (&at.axis, &at.pivot, Label::part("l")),
    ];
    for (from, to, label) in sides {
        placing.put(canvas, &label, positions_beside_line(from, to, &NEAR));
    }
    placing.put(canvas, &Label::words("B"), positions_around(&at.axis, PI, &NEAR));
    placing.put(canvas, &Label::words("O"), positions_around(&at.pivot, 0.0, &NEAR));
    placing.put(canvas, &Label::words("P"), positions_around(leaving, at.theta, &at.near_pin()));
}
