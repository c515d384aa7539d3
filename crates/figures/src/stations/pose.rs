//! Wheel and driver in one position, and where they lie on the page.

use super::driver::Driver;
use crate::star::Star;
use crate::svg::{Canvas, Pixels, Shape, View, heading};
use crate::theme::{DRIVER, FOLLOWER, INK, PAPER};
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Radius of the mark of an axis: in pixels, and at most this much of what the driver has there.
const AXIS: f64 = 5.0;
const AXIS_IN_DRIVER: f64 = 0.8;

/// Free space around the mechanism, in pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct WheelMargins {
    pub left: f64,
    pub right: f64,
    pub above: f64,
    pub below: f64,
}

/// Wheel and driver in one position, and where they lie on the page: the wheel's axis at the left, the driver's at the right.
#[derive(Clone, Copy, Debug)]
pub(super) struct WheelPose {
    pub star: Star,
    pub driver: Driver,
    /// The plane about the wheel's axis, in crank radii.
    pub view: View,
    /// The wheel's axis O on the page.
    pub pivot: Pixels,
    /// The driver's axis B on the page.
    pub axis: Pixels,
    /// Height that the mechanism and its margins take, in pixels.
    pub height: f64,
}

impl WheelPose {
    /// The mechanism as large as it can be in a column of this width.
    pub(super) fn new(wheel: &Wheel, width: f64, margins: WheelMargins) -> Self {
        let star = Star::of_wheel(wheel);
        let driver = Driver::of_wheel(wheel, &star);
        let reach = 1.0 + driver.arm;
        let scale = (width - margins.left - margins.right) / (star.rim + star.centre + reach);
        let half = star.rim.max(reach) * scale;
        let pivot = Vector2::new(margins.left + star.rim * scale, margins.above + half);
        let view = View { origin: pivot, scale };
        let height = margins.above + margins.below + 2.0 * half;
        Self { star, driver, view, pivot, axis: view.place(&Vector2::new(star.centre, 0.0)), height }
    }

    /// The mechanism as large as it can be in the middle of this room.
    pub(super) fn fitting(wheel: &Wheel, room: Pixels, margins: WheelMargins) -> Self {
        let wide = Self::new(wheel, room.x, margins);
        let above = margins.above + margins.below;
        let share = ((room.y - above) / (wide.height - above)).min(1.0);
        let beside = margins.left + margins.right;
        let breadth = beside + share * (room.x - beside);
        let bodies = Self::new(wheel, breadth, margins);
        bodies.translate(&(Vector2::new(room.x - breadth, room.y - bodies.height) / 2.0))
    }

    /// Moves the bodies to another place of the page.
    pub(super) fn translate(&self, by: &Pixels) -> Self {
        let view = View { origin: self.view.origin + by, ..self.view };
        Self { view, pivot: self.pivot + by, axis: self.axis + by, ..*self }
    }

    /// Direction on the page of a crank angle θ: clockwise from B → O, both in radians.
    pub(super) fn crank_direction(theta: f64) -> f64 {
        PI - theta
    }

    /// Where a pin at θ lies on the page.
    pub(super) fn pin(&self, theta: f64) -> Pixels {
        self.axis + heading(Self::crank_direction(theta)) * self.view.scale
    }

    /// A place in polar coordinates about the wheel's axis: crank radii, and radians counter-clockwise from O → B.
    pub(super) fn on_wheel(&self, radius: f64, angle: f64) -> Pixels {
        self.pivot + heading(angle) * (radius * self.view.scale)
    }

    /// The arms, which turn behind the wheel, about this point of the page.
    pub(super) fn draw_arms(&self, canvas: &mut Canvas, about: &Pixels, theta: f64) {
        let view = View { origin: *about, ..self.view };
        let arms = self.driver.arms_outline(Self::crank_direction(theta), &view);
        let arms = Shape::path(arms).tint(DRIVER, 0.12).stroke(DRIVER, 1.3);
        canvas.draw(arms.attribute("stroke-opacity", "0.75").class("arms"));
    }

    /// The wheel about this point of the page, one slot at φ.
    pub(super) fn draw_wheel(&self, canvas: &mut Canvas, about: &Pixels, phi: f64, width: f64) {
        let view = View { origin: *about, ..self.view };
        canvas.draw(self.star.body(phi, &view, width).class("wheel"));
        canvas.draw(Shape::circle(about, self.dot()).fill(PAPER).stroke(FOLLOWER, width));
    }

    /// The locking disc and the pins, in the plane of the wheel, about this point of the page.
    pub(super) fn draw_locking_disc(&self, canvas: &mut Canvas, about: &Pixels, theta: f64, width: f64) {
        let (view, crank) = (View { origin: *about, ..self.view }, Self::crank_direction(theta));
        if let Some(outline) = self.driver.locking_disc_outline(crank, &view) {
            let locking_disc = Shape::path(outline).tint(DRIVER, 0.22).stroke(DRIVER, width);
            canvas.draw(locking_disc.attribute("stroke-linejoin", "round").class("locking-disc"));
        }
        for pin in self.driver.pin_directions(crank) {
            let at = about + heading(pin) * view.scale;
            canvas.draw(Shape::circle(&at, self.driver.pin * view.scale).fill(PAPER).stroke(INK, width).class("pin"));
        }
        canvas.draw(Shape::circle(about, self.dot()).fill(PAPER).stroke(DRIVER, width));
    }

    /// All of it at crank angle θ and wheel angle φ.
    pub(super) fn draw(&self, canvas: &mut Canvas, theta: f64, phi: f64, width: f64) {
        self.draw_arms(canvas, &self.axis, theta);
        self.draw_wheel(canvas, &self.pivot, phi, width);
        self.draw_locking_disc(canvas, &self.axis, theta, width);
    }

    /// Radius of the mark of an axis in pixels: within the driver even where its cut-out is deepest.
    fn dot(&self) -> f64 {
        AXIS.min(AXIS_IN_DRIVER * self.driver.depth * self.view.scale)
    }
}

/// A count with its noun: "1 pin", "3 pins".
pub(super) fn count_noun(count: u32, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}
