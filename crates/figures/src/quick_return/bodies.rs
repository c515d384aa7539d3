//! The parts of the mechanism in their places.

use super::instant::Instant;
use super::links::{CRANK, LEVER, Layout, rounded};
use crate::svg::canvas::Canvas;
use crate::svg::marks::fixed_pivot;
use crate::svg::placing::Placing;
use crate::svg::shape::{DASHED, Shape};
use crate::svg::view::{Pixels, heading};
use crate::theme::{DRIVER, FILL, FOLLOWER, INK, PAPER};
use geneva_kinematics::quick_return::{Branch, QuickReturn};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// The other branch's pin is shown if it is so many pixels away.
const APART: f64 = 14.0;

/// Circle, ends of the swing, other branch, lever, crank, pivots.
pub fn bodies(canvas: &mut Canvas, placing: &mut Placing, at: &Layout, linkage: &QuickReturn, instant: &Instant) {
    let beyond = at.axis + Vector2::new(at.crank + 22.0, 0.0);
    canvas.draw(Shape::line(&at.pivot, &beyond).stroke(INK, 1.2).dashed(DASHED).class("line-of-centres"));
    canvas.draw(Shape::circle(&at.axis, at.crank).stroke(DRIVER, 1.3).dashed("2 4").class("pin-circle"));
    placing.avoid(&at.pivot, &beyond, 0.7);
    placing.avoid_arc(&at.axis, at.crank, 0.0, 2.0 * PI, 0.25);
    if let Some(limit) = linkage.strokes().swing_limit {
        for angle in [limit, -limit] {
            let line = Shape::line(&at.pivot, &at.tip(angle)).stroke(FOLLOWER, 1.2).with("stroke-opacity", "0.7");
            canvas.draw(line.dashed("10 4").class("swing-end"));
            placing.avoid(&at.pivot, &at.tip(angle), 0.5);
        }
    }
    if let Some(ghost) = other_branch(at, linkage, instant) {
        canvas.group("class=\"other-branch\" opacity=\"0.5\"", |canvas| {
            canvas.draw(Shape::line(&at.axis, &ghost).stroke(DRIVER, 2.0).dashed("5 4"));
            canvas.draw(Shape::circle(&ghost, 6.0).stroke(DRIVER, 2.0).fill(PAPER));
        });
        placing.avoid(&at.axis, &ghost, 0.8);
    }
    let tip = at.tip(instant.lever_angle);
    let lever = Shape::path(rounded(&at.pivot, &tip, LEVER)).fill(PAPER);
    canvas.draw(lever.class("lever-paper"));
    let lever = Shape::path(rounded(&at.pivot, &tip, LEVER)).stroke(FOLLOWER, 2.0).fill(FILL);
    canvas.draw(lever.class("lever"));
    canvas.draw(Shape::path(at.slot(instant.lever_angle)).stroke(FOLLOWER, 1.3).fill(PAPER).class("slot"));
    for offset in [-0.7, 0.0, 0.7] {
        let aside = heading(instant.lever_angle + FRAC_PI_2) * (offset * LEVER);
        placing.avoid(&(at.pivot + aside), &(tip + aside), 2.0);
    }
    for pivot in [&at.pivot, &at.axis] {
        fixed_pivot(canvas, pivot, at.side);
        let (top, foot) = if at.side > 0.0 { (-6.0, 33.0) } else { (-33.0, 6.0) };
        placing.take([pivot + Vector2::new(-24.0, top), pivot + Vector2::new(24.0, foot)]);
    }
    let crank = Shape::path(rounded(&at.axis, &at.pin, CRANK)).fill(DRIVER).with("fill-opacity", "0.22");
    canvas.draw(crank.stroke(DRIVER, 2.0).class("crank"));
    placing.avoid(&at.axis, &at.pin, 2.0);
    canvas.draw(Shape::circle(&at.axis, 5.0).stroke(INK, 2.0).fill(PAPER));
    canvas.draw(Shape::circle(&at.pin, 6.0).stroke(INK, 2.0).fill(PAPER).class("pin"));
    placing.take([at.pin - Vector2::new(7.0, 7.0), at.pin + Vector2::new(7.0, 7.0)]);
}

/// Where the pin would be on the other branch at this lever angle, if that is another place.
pub fn other_branch(at: &Layout, linkage: &QuickReturn, instant: &Instant) -> Option<Pixels> {
    let far = instant.angle_at_pin <= FRAC_PI_2;
    let other = if far { Branch::Near } else { Branch::Far };
    // The lever's pivot inside the circle: one place only.
    if linkage.ratio() <= 1.0 {
        return None;
    }
    let position = linkage.at_lever_degrees(instant.lever_angle.to_degrees(), other).ok()?;
    let pin = at.view.place(&(instant.along * position.pin_distance));
    ((pin - at.pin).norm() > APART).then_some(pin)
}
