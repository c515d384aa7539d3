//! The general position: the triangle of the two axes and the pin.

use super::pose::{EscapementMargins, EscapementPose, id, side};
use crate::number::{degrees, significant, without_noise};
use crate::parts::{NEAR, WIDTH, angle, right_angle};
use crate::svg::{Canvas, DASHED, DrawingKind, Label, Pixels, Placing, Shape, positions_around, positions_beside_line};
use crate::theme::{DRIVER, FOLLOWER, INK};
use crate::{Figure, FigureError, Series, Words};
use geneva_kinematics::Mechanism;
use nalgebra::Vector2;
use std::f64::consts::PI;

const MARGINS: EscapementMargins = EscapementMargins { side: 46.0, above: 26.0, below: 26.0 };
/// Radii of the marks of the angles, over the sides there.
const MARK: f64 = 0.4;
/// A pin so many pixels from the line of centres has room for the height of the triangle.
const TALL: f64 = 34.0;

/// The triangle B P O at a driver angle (θ in radians, within ±π/m), to scale, with its height r sin θ = R sin φ.
///
/// Series: θ, φ, c/r, R/r, and the pin's coordinates in crank radii: along B → O and across it.
///
/// # Errors
///
/// [`FigureError::Escapement`] if the angle is beyond ±π/m or not finite.
pub fn angles(escapement: &Mechanism, crank: f64) -> Result<Figure, FigureError> {
    let bodies = EscapementPose::at_driver_angle(escapement, crank, MARGINS)?;
    let mut canvas = Canvas::new(WIDTH, bodies.height);
    let mut placing = bodies.placing();
    canvas.faint(0.55, "", |canvas| {
        bodies.draw_driver(canvas, 1.3);
        bodies.draw_follower(canvas, 1.3);
    });
    let pin = bodies.pin();
    triangle(&mut canvas, &mut placing, &bodies, &pin);
    names(&mut canvas, &mut placing, &bodies, &pin);
    bodies.draw_senses(&mut canvas);

    let ratio = escapement.centre_distance_ratio();
    let place = bodies.layout.pins[0];
    let distance = (place - bodies.layout.follower_axis).norm();
    let series = Series::of_one([
        ("theta", "deg", crank.to_degrees()),
        ("phi", "deg", bodies.phi.to_degrees()),
        ("l/R", "1", ratio),
        ("r/R", "1", distance),
        ("x_P/R", "1", place.x),
        ("y_P/R", "1", place.y),
    ]);
    let (theta, phi) = (degrees(crank), degrees(without_noise(bodies.phi, 1.0)));
    let words = Words::new(
        id("angles", escapement),
        format!(
            "The angles of the escapement with {} slots and {} pins at θ = {theta}",
            escapement.slots(),
            escapement.pins()
        ),
        format!(
            "The driver's axis B at the left, the follower's axis O at the right, {} crank radii away, and the pin P in \
             a slot of the follower. BP is R; OP is r, {} R; BO is l. The driver angle θ at B is {theta}, the follower \
             angle φ at O {phi}. The distance of P from the line of centres is both R sin θ and r sin φ.",
            significant(ratio, 4),
            significant(distance, 4)
        ),
        format!(
            "A general position of the escapement with {} pins and {} slots, to scale at θ = {theta}. Both angles are \
             negative before the line of centres, and both give the distance of the pin from that line: R sin θ = r \
             sin φ. The foot of the perpendicular from the pin divides l into R cos θ and r cos φ.",
            escapement.pins(),
            escapement.slots()
        ),
    );
    Ok(words.figure(canvas, DrawingKind::Mechanism, series))
}

/// Sides, height, pins and axes.
fn triangle(canvas: &mut Canvas, placing: &mut Placing, at: &EscapementPose, pin: &Pixels) {
    let foot = Vector2::new(pin.x, at.axis.y);
    let height = (pin - foot).norm();
    if height > TALL {
        canvas.draw(Shape::line(&foot, pin).stroke(INK, 1.5).dashed(DASHED).class("height"));
        right_angle(canvas, &foot, &(pin - foot), &(at.axis - foot), 11.0);
        placing.avoid(&foot, pin, 1.5);
    }
    side(canvas, placing, &at.axis, &at.pivot, INK, "l");
    side(canvas, placing, &at.axis, pin, DRIVER, "R");
    side(canvas, placing, &at.pivot, pin, FOLLOWER, "r");
    at.draw_pins(canvas);
    at.draw_axes(canvas);
}

/// Angles, sides and corners.
fn names(canvas: &mut Canvas, placing: &mut Placing, at: &EscapementPose, pin: &Pixels) {
    let reach = (pin - at.pivot).norm();
    angle(canvas, placing, &at.axis, MARK * at.view.scale, (0.0, at.theta), &Label::part("θ"));
    let mark = (MARK * reach).max(22.0);
    angle(canvas, placing, &at.pivot, mark, (PI, PI - at.phi), &Label::part("φ"));
    let sides =
        [(&at.axis, pin, Label::part("R").in_colour(DRIVER)), (&at.pivot, pin, Label::part("r").in_colour(FOLLOWER))];
    for (from, to, label) in sides {
        placing.put(canvas, &label, positions_beside_line(from, to, &NEAR));
    }
    // Away from the pin, where the angles are not.
    let places = positions_beside_line(&at.axis, &at.pivot, &NEAR).into_iter();
    let away = places.filter(|place| place.towards.y * (pin.y - at.axis.y) <= 0.0);
    placing.put(canvas, &Label::part("l"), away);
    placing.put(canvas, &Label::words("B"), positions_around(&at.axis, PI, &NEAR));
    placing.put(canvas, &Label::words("O"), positions_around(&at.pivot, 0.0, &NEAR));
    placing.put(canvas, &Label::words("P"), positions_around(pin, at.theta, &at.near_pin()));
}
