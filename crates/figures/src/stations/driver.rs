//! The driver: a locking disc with a cut-out before each pin, and the arms that carry the pins behind the wheel.

use crate::star::Star;
use crate::svg::{Path, Sense, View, heading};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::{FRAC_PI_2, PI};

/// Radius of a pin over half the width of its slot: some play, so that both can be seen.
const PIN_IN_SLOT: f64 = 0.86;
/// Half the width of an arm over half that of a slot.
const ARM: f64 = 1.5;
/// How much of the gap between the driver's axis and the wheel's rim the bottom of the cut-out leaves to the driver.
const LEFT_IN_GAP: f64 = 2.0 / 3.0;
/// A locking disc narrower than this (radians) is none.
const NARROWEST: f64 = 1e-9;

/// Lengths of a driver in crank radii, and its angles in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct Driver {
    /// How many pins.
    pub pins: u32,
    /// Radius of a pin.
    pub pin: f64,
    /// Half the width of an arm.
    pub arm: f64,
    /// Radius of the locking disc: that of the wheel's locking arcs.
    pub locking_disc: f64,
    /// Half the angle of a cut-out: the crank angle of entry, for then the locking disc's edge is on the line of
    /// centres.
    pub half_angle: f64,
    /// From the driver's axis to the bottom of a cut-out.
    pub depth: f64,
    /// From the driver's axis to the centre of a cut-out's circle.
    pub cut_centre: f64,
    /// Radius of that circle.
    pub cut_radius: f64,
}

impl Driver {
    /// The driver of this wheel. The cut-out is a circle through three points: its bottom and both edges.
    pub(super) fn of_wheel(wheel: &Wheel, star: &Star) -> Self {
        let half_angle = wheel.engagement_half_angle();
        let locking_disc = star.locking.unwrap_or_default();
        let depth = LEFT_IN_GAP * (star.centre - star.rim);
        // The edge of the cut-out along its middle line: cos(π/2 − α) = sin α.
        let edge = locking_disc * libm::sin(wheel.half_pitch_angle());
        let cut_centre = (locking_disc * locking_disc - depth * depth) / (2.0 * (edge - depth));
        Self {
            pins: wheel.pins(),
            pin: PIN_IN_SLOT * star.half_width,
            arm: ARM * star.half_width,
            locking_disc,
            half_angle,
            depth,
            cut_centre,
            cut_radius: cut_centre - depth,
        }
    }

    /// Angle between neighbouring pins, in radians.
    pub(super) fn pitch(&self) -> f64 {
        2.0 * PI / f64::from(self.pins)
    }

    /// Directions of the pins on the page, the first at `crank` (radians, counter-clockwise).
    pub(super) fn pin_directions(&self, crank: f64) -> impl Iterator<Item = f64> {
        let pitch = self.pitch();
        (0..self.pins).map(move |k| crank + pitch * f64::from(k))
    }

    /// Outline of the locking disc about the view's origin, the first pin at `crank`.
    ///
    /// `None` where the cut-outs meet: a pin is always in a slot, and there is nothing to lock.
    pub(super) fn locking_disc_outline(&self, crank: f64, view: &View) -> Option<Path> {
        let whole = self.pitch() - 2.0 * self.half_angle;
        if whole < NARROWEST {
            return None;
        }
        let radius = self.locking_disc * view.scale;
        let at = |angle: f64| view.origin + heading(angle) * radius;
        let large = self.locking_disc * libm::cos(self.half_angle) > self.cut_centre;
        let mut path = Path::start(&at(crank - self.half_angle));
        for pin in self.pin_directions(crank) {
            let edge = pin + self.half_angle;
            path = path.arc(self.cut_radius * view.scale, large, Sense::Clockwise, &at(edge));
            path = path.arc(radius, whole > PI, Sense::CounterClockwise, &at(edge + whole));
        }
        Some(path.close())
    }

    /// Outline of all arms about the view's origin, round about the pins, the first at `crank`.
    pub(super) fn arms_outline(&self, crank: f64, view: &View) -> Path {
        let round = self.arm * view.scale;
        let at = |pin: f64, along: f64, aside: f64| {
            view.origin + (heading(pin) * along + heading(pin + FRAC_PI_2) * aside) * view.scale
        };
        let mut path = Path::start(&at(crank, 1.0, -self.arm));
        for pin in self.pin_directions(crank) {
            path = path.arc_to(round, Sense::CounterClockwise, &at(pin, 1.0, self.arm));
            if self.pins == 1 {
                path = path.line_to(&at(pin, 0.0, self.arm));
                path = path.arc_to(round, Sense::CounterClockwise, &at(pin, 0.0, -self.arm));
            } else {
                // The sides of neighbouring arms meet half-way between them.
                let corner = self.arm / libm::sin(self.pitch() / 2.0);
                path = path.line_to(&at(pin + self.pitch() / 2.0, corner, 0.0));
            }
            path = path.line_to(&at(pin + self.pitch(), 1.0, -self.arm));
        }
        path.close()
    }
}
