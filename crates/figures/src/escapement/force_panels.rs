//! The three panels of the forces.

use super::force_senses::Senses;
use super::pose::EscapementPose;
use crate::parts::{NEAR, WIDTH, angle, arrow, axis, draw_number, right_angle, sense, vector};
use crate::svg::{
    Canvas, DASHED, Label, Path, Pixels, Placing, Shape, View, angle_of, heading, positions_around,
    positions_beside_line,
};
use crate::theme::{CORIOLIS, Colour, DRIVER, FILL, FOLLOWER, INK, PAPER, RELATIVE};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// The colours of the normal force and of the friction.
const NORMAL: Colour = RELATIVE;
const FRICTION: Colour = CORIOLIS;
/// Lengths of their arrows in pixels.
const LONG: f64 = 84.0;
/// The follower by itself: radius of its rim in pixels.
const RIM: f64 = 104.0;
/// The contact: half the width of the slot, radius of the pin, half the length of the flanks, thickness of the walls.
const HALF_SLOT: f64 = 33.0;
const PIN: f64 = 28.0;
const FLANK: f64 = 104.0;
const WALL: f64 = 32.0;
/// The friction is drawn so far beside the flank, so that both can be seen.
const BESIDE: f64 = 6.0;

/// The number of a panel and its title, at a corner.
fn title(canvas: &mut Canvas, corner: &Pixels, number: usize, words: &str) {
    let at = corner + Vector2::new(20.0, 24.0);
    draw_number(canvas, &at, number);
    canvas.label(&(at + Vector2::new(22.0, 0.0)), &Vector2::new(1.0, 0.0), 0.0, &Label::words(words).bare());
}

fn normal_label() -> Label {
    Label::part("F").in_colour(NORMAL)
}

fn friction_label() -> Label {
    Label::symbol("μ").and("\u{2009}|").and_symbol("F").and("|").in_colour(FRICTION)
}

/// Panel 1: driver and pin with the forces on the pin; the arm of the friction; the driving torque.
pub(super) fn pin_and_driver(canvas: &mut Canvas, at: &EscapementPose, senses: &Senses) {
    let mut placing = at.placing();
    canvas.faint(0.5, "", |canvas| at.draw_follower(canvas, 1.3));
    at.draw_driver(canvas, 1.6);
    at.draw_line_of_centres(canvas);
    let pin = at.pin();
    let foot = at.on_follower(at.star.centre * libm::cos(at.phi), at.phi);
    let end = foot + senses.out * 30.0;
    canvas.draw(Shape::line(&at.pivot, &end).stroke(FOLLOWER, 1.4).dashed("10 4").class("slot-line"));
    canvas.draw(Shape::line(&at.axis, &pin).stroke(DRIVER, 3.0).class("crank").attribute("data-letter", "R"));
    placing.avoid(&at.pivot, &end, 1.5);
    placing.avoid(&at.axis, &pin, 2.0);
    let has_arm = (foot - at.axis).norm() > 8.0;
    if has_arm {
        canvas.draw(Shape::line(&at.axis, &foot).stroke(FRICTION, 2.2).class("arm"));
        right_angle(canvas, &foot, &(at.axis - foot), &(at.pivot - foot), 11.0);
        placing.avoid(&at.axis, &foot, 2.0);
    }
    at.draw_pins(canvas);
    at.draw_axes(canvas);
    let mark = (0.5 * (pin - at.pivot).norm()).max(30.0);
    angle(canvas, &mut placing, &at.pivot, mark, (PI, PI - at.phi), &Label::part("φ"));
    if senses.normal != 0.0 {
        let (to, label) = (pin - senses.ahead * (senses.normal * LONG), normal_label().and(" on the pin"));
        vector(canvas, &mut placing, &pin, &to, 4.0, &label, "normal-on-pin");
    }
    if senses.rubs {
        let to = pin - senses.out * (senses.sliding * LONG);
        vector(canvas, &mut placing, &pin, &to, 4.0, &friction_label(), "friction-on-pin");
    }
    if has_arm {
        let label = Label::symbol("l").and(" sin ").and_symbol("φ").in_colour(FRICTION);
        placing.put(canvas, &label, positions_beside_line(&at.axis, &foot, &NEAR));
    }
    let radius = at.disc() + 14.0;
    sense(canvas, &at.axis, radius, PI, 1.0, &Label::symbol("K").in_colour(DRIVER));
    placing.put(canvas, &Label::words("B"), positions_around(&at.axis, PI, &NEAR));
    placing.put(canvas, &Label::words("O"), positions_around(&at.pivot, -0.9, &NEAR));
    title(canvas, &Pixels::zeros(), 1, "The driver, with the forces on its pin");
}

/// Panel 2: the pin in the slot, enlarged.
pub(super) fn contact(canvas: &mut Canvas, senses: &Senses, top: f64, height: f64) {
    let corner = Vector2::new(0.0, top);
    title(canvas, &corner, 2, "The contact, enlarged");
    let centre = corner + Vector2::new(WIDTH / 4.0, height / 2.0 + 20.0);
    let mut placing =
        Placing::new(corner + Vector2::new(8.0, 44.0), corner + Vector2::new(WIDTH / 2.0 - 8.0, height - 8.0));
    let at = |along: f64, across: f64| centre + senses.out * along + senses.ahead * across;
    for side in [1.0, -1.0] {
        let [near, far] = [side * HALF_SLOT, side * (HALF_SLOT + WALL)];
        let wall = Path::start(&at(-FLANK, near)).line_to(&at(FLANK, near)).line_to(&at(FLANK, far));
        canvas.draw(Shape::path(wall.line_to(&at(-FLANK, far)).close()).fill(FILL).class("wall"));
        let bears = side == senses.normal;
        let flank = Shape::line(&at(-FLANK, near), &at(FLANK, near)).stroke(FOLLOWER, if bears { 5.0 } else { 1.8 });
        canvas.draw(flank.class(if bears { "bearing-flank" } else { "flank" }));
        placing.avoid(&at(-FLANK, near), &at(FLANK, near), 1.5);
    }
    canvas.draw(Shape::line(&at(-FLANK, 0.0), &at(FLANK, 0.0)).stroke(FOLLOWER, 1.2).dashed(DASHED));
    placing.avoid(&at(-FLANK, 0.0), &at(FLANK, 0.0), 0.8);
    let pin = at(0.0, senses.normal * (HALF_SLOT - PIN));
    canvas.draw(Shape::circle(&pin, PIN).fill(PAPER).stroke(INK, 2.2).class("enlarged-pin"));
    placing.take([pin - Vector2::new(PIN, PIN), pin + Vector2::new(PIN, PIN)]);
    let touch = at(0.0, senses.normal * HALF_SLOT);
    if senses.normal != 0.0 {
        let to = touch - senses.ahead * (senses.normal * (LONG + 16.0));
        vector(canvas, &mut placing, &touch, &to, 4.0, &normal_label(), "normal-at-contact");
    }
    if senses.rubs {
        let from = touch - senses.ahead * (senses.normal * BESIDE);
        let to = from - senses.out * (senses.sliding * LONG);
        vector(canvas, &mut placing, &from, &to, 4.0, &friction_label(), "friction-at-contact");
    }
    for (side, words) in [(1.0, "leading"), (-1.0, "trailing")] {
        let [from, to] = [-FLANK, FLANK].map(|along| at(along, side * (HALF_SLOT + WALL)));
        let places = positions_beside_line(&from, &to, &[8.0, 14.0, 22.0])
            .into_iter()
            .filter(|place| place.towards.dot(&senses.ahead) * side > 0.0);
        placing.put(canvas, &Label::words(words).in_colour(FOLLOWER), places);
    }
    if senses.sliding != 0.0 {
        // Beside the pin, away from the friction.
        let from = at(senses.sliding * (PIN + 10.0), -senses.normal * 12.0);
        let to = from + senses.out * (senses.sliding * 44.0);
        arrow(canvas, &from, &to, INK, 2.0, "sliding");
        placing.avoid(&from, &to, 1.5);
        placing.put(canvas, &Label::words("slides"), positions_around(&to, angle_of(&(to - from)), &NEAR));
    }
    placing.put(canvas, &Label::words("to O"), positions_around(&at(-FLANK, 0.0), angle_of(&-senses.out), &NEAR));
}

/// Panel 3: the follower by itself.
pub(super) fn follower(canvas: &mut Canvas, at: &EscapementPose, senses: &Senses, top: f64, height: f64) {
    let corner = Vector2::new(WIDTH / 2.0, top);
    title(canvas, &corner, 3, "The follower by itself");
    let scale = RIM / at.star.rim;
    let pivot = corner + Vector2::new(WIDTH / 2.0 - RIM - 46.0, height / 2.0 + 16.0);
    let view = View { origin: pivot, scale };
    canvas.draw(at.star.body(PI - at.phi, &view, 2.0).class("free-follower"));
    let mut placing =
        Placing::new(corner + Vector2::new(4.0, 44.0), corner + Vector2::new(WIDTH / 2.0 - 6.0, height - 6.0));
    let distance = (at.layout.pins[0] - at.layout.follower_axis).norm() * scale;
    let pin = pivot + senses.out * distance;
    canvas.draw(Shape::line(&pivot, &pin).stroke(INK, 2.2).class("arm-r").attribute("data-letter", "r"));
    placing.avoid(&pivot, &pin, 2.0);
    for k in 0..at.star.slots {
        let towards = heading(PI - at.phi + 2.0 * PI / f64::from(at.star.slots) * f64::from(k));
        placing.avoid(&pivot, &(pivot + towards * RIM), 0.6);
    }
    if senses.normal != 0.0 {
        let from = pin + senses.ahead * (senses.normal * at.star.half_width * scale);
        vector(
            canvas,
            &mut placing,
            &from,
            &(from + senses.ahead * (senses.normal * LONG)),
            4.0,
            &normal_label(),
            "normal-on-follower",
        );
        right_angle(canvas, &pin, &-senses.out, &(senses.ahead * senses.normal), 11.0);
        let radius = RIM + 14.0;
        sense(canvas, &pivot, radius, 0.0, -senses.normal, &Label::rate("φ", 2).in_colour(FOLLOWER));
    }
    axis(canvas, &pivot, FOLLOWER);
    placing.put(canvas, &Label::part("r"), positions_beside_line(&pivot, &pin, &NEAR));
    placing.put(canvas, &Label::words("O"), positions_around(&pivot, 0.0, &NEAR));
}
