//! Which way the forces between pin and slot point, and which flank bears.

use crate::svg::{Pixels, heading};
use geneva_dynamics::forces::Flank;
use std::f64::consts::{FRAC_PI_2, PI};

/// Below this angle (radians) the pin does not slide that one could see, and friction has no arm.
const STILL: f64 = 1e-9;

/// Which way everything points on the page. Unit vectors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Senses {
    /// Along the slot, away from the follower's axis.
    pub out: Pixels,
    /// Across the slot, as the follower turns.
    pub ahead: Pixels,
    /// +1 where the pin drives the follower, −1 where the follower drives the pin, 0 if neither.
    pub normal: f64,
    /// +1 if the pin slides outwards, −1 inwards, 0 on the line of centres.
    pub sliding: f64,
    /// Whether there is friction to be drawn.
    pub rubs: bool,
}

impl Senses {
    /// The senses at these angles, for a normal force and a coefficient of friction.
    pub(super) fn new(theta: f64, phi: f64, normal: f64, friction: f64) -> Self {
        let sign = |value: f64, least: f64| if value.abs() <= least { 0.0 } else { value.signum() };
        let (normal, sliding) = (sign(normal, 0.0), sign(theta, STILL));
        let rubs = friction > 0.0 && normal != 0.0 && sliding != 0.0;
        Self { out: heading(PI - phi), ahead: heading(FRAC_PI_2 - phi), normal, sliding, rubs }
    }

    fn flank(&self) -> Flank {
        match self.normal {
            normal if normal > 0.0 => Flank::Leading,
            normal if normal < 0.0 => Flank::Trailing,
            _ => Flank::Neither,
        }
    }

    /// The flank, in words.
    pub(super) fn flank_words(&self) -> &'static str {
        match self.flank() {
            Flank::Leading => "the pin bears on the leading flank and drives the follower",
            Flank::Trailing => "the follower drives the pin, which bears on the trailing flank",
            Flank::Neither => "the pin bears on neither flank",
        }
    }

    /// A sentence on what acts on the pin.
    pub(super) fn describe(&self) -> String {
        let towards = if self.sliding > 0.0 {
            "outwards, so that the friction on it points to O"
        } else {
            "inwards, so that the friction on it points away from O"
        };
        match (self.normal == 0.0, self.rubs) {
            (true, _) => "No force acts on the pin.".to_owned(),
            (_, true) => format!("The reaction to F acts on the pin across the slot. The pin slides {towards}."),
            (_, false) => "The reaction to F acts on the pin across the slot; there is no friction.".to_owned(),
        }
    }
}
