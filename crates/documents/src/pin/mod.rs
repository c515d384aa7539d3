//! The textbook problem: angular velocity of a four-slot wheel and velocity of the pin in its slot.
//!
//! The claims follow the order of the source, with a file for each stage: what is given, the position triangle, the
//! velocity triangle. The instant itself, from the printed values, is [`PinProblem`]. How the lost drawing can have shown it
//! is in a file of its own.

pub(crate) mod continuation;
mod directions;
mod given;
mod letters;
mod placement;
mod position;
mod signs;
mod symbols;
mod velocity;

pub(crate) use placement::{Arrow, Placement, heading};
pub(crate) use signs::turns;
pub use symbols::SYMBOLS;

use crate::duals::{Crank, path, turned};
use geneva_evidence::agreement::vanishes;
use geneva_evidence::{
    Cache, Claim, Consequence, Decimal, Dimension, Document, Evidence, Finding, InventoryFile, Locator, Origin, Slip,
    Stated, Verdict,
};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::{PinSlot, velocity_ratio};
use geneva_kinematics::pin_triangle::{self, TriangleSolution};
use geneva_kinematics::pin_vectors::{self, PinMotion};
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;

/// A textbook problem: the velocity of a pin in a four-slot Geneva wheel.
pub static PIN: Document = Document {
    slug: "pin",
    title: "textbook problem",
    citation: "Sample problem of an engineering-dynamics textbook with its worked solution: angular velocity of a \
        four-slot Geneva wheel and velocity of the pin in its slot. Copy without title, author or year.",
    inventory: Some(InventoryFile {
        path: "crates/documents/sources/pin.inventory",
        text: include_str!("../../sources/pin.inventory"),
    }),
    claims,
    answers: ANSWERS,
    given: Vec::new,
    conclusions: &[],
    symbols: SYMBOLS,
    units: &[
        ("angular velocity of the driver", "rad/s"),
        ("angular speed of the wheel", "rad/s"),
        ("speed of the", "mm/s"),
        ("angle", "°"),
        ("square of OP, in squared crank radii", "R^{2}"),
        ("OP in crank radii", "R"),
        ("distance", "mm"),
        ("crank radius", "mm"),
    ],
    test: "cargo test -p geneva-documents --test verdicts pin_stands",
    cache: Cache::new(),
};

/// A place in this source.
const fn at(locator: &'static str) -> Locator {
    Locator::new(&PIN, locator)
}

/// What the problem asks for: the wheel's angular velocity, and the pin's velocity in the slot.
pub const ANSWERS: &[&str] = &["pin.follower-speed", "pin.sliding-speed", "pin.sliding-velocity-direction"];

/// The mechanism at the printed instant.
#[derive(Clone, Debug, PartialEq)]
pub struct PinProblem {
    /// Crank and slot, lengths in the printed unit.
    pub mechanism: PinSlot,
    /// Crank angle from the direction O → B, counter-clockwise.
    pub crank: Turn<f64>,
    /// Angular velocity of the driver in rad/s, counter-clockwise positive.
    pub driver_speed: f64,
}

impl PinProblem {
    /// Builds the instant from the printed values: the four-station wheel, scaled to the printed crank radius. The crank's
    /// angle is counted counter-clockwise, as the page that continues the problem lets us conclude.
    pub fn printed() -> Result<Self, KinematicsError> {
        Self::placed(placement::drawn())
    }

    /// The printed values in a placement of the mechanism: a mirror image counts the crank's angle clockwise, and the
    /// driver turns as before.
    pub(crate) fn placed(placement: Placement) -> Result<Self, KinematicsError> {
        let wheel = Wheel::new(4)?;
        let crank = Turn::from_degrees(PIN.printed_number("pin.crank-angle"));
        Ok(Self {
            mechanism: wheel.pin_and_slot(PIN.printed_number("pin.crank-radius"))?,
            crank: if placement.mirrored { crank.reversed() } else { crank },
            driver_speed: PIN.printed_number("pin.driver-speed"),
        })
    }

    /// Solves by the source's own route, the laws of cosines and sines.
    pub fn by_triangle(&self) -> TriangleSolution {
        pin_triangle::solve(&self.mechanism, &self.crank.supplement(), self.driver_speed)
    }

    /// Solves by a second route, which differentiates the pin's position.
    ///
    /// `None` if the pin is on the follower's pivot, which a [`PinSlot`] excludes.
    pub fn by_vectors(&self) -> Option<PinMotion<f64>> {
        let (radius, distance) = (self.mechanism.crank_radius(), self.mechanism.centre_distance());
        pin_vectors::solve(&radius, &distance, &self.crank, &self.driver_speed)
    }

    /// Sets up a third route, with dual numbers, for the witnesses.
    fn by_duals(&self) -> Crank {
        Crank {
            ground: self.mechanism.centre_distance(),
            radius: self.mechanism.crank_radius(),
            angle: self.crank.radians(),
            speed: self.driver_speed,
            acceleration: 0.0,
        }
    }

    /// The driver's axis B; the origin is the follower's pivot O.
    fn axis(&self) -> Vector2<f64> {
        Vector2::new(self.mechanism.centre_distance(), 0.0)
    }
}

/// All claims of the problem, in the order of the source.
pub fn claims() -> Vec<Claim> {
    [given::claims(), position::claims(), velocity::claims()].concat()
}

/// A quantity of the triangle at the printed instant, whose sides and angles its mirror image has too.
fn triangle(quantity: fn(&TriangleSolution) -> f64) -> f64 {
    PinProblem::placed(placement::BY_THE_PAGE).map_or(f64::NAN, |instant| quantity(&instant.by_triangle()))
}

/// A quantity of the vectors at the printed instant.
fn vectors(quantity: fn(&PinMotion<f64>) -> f64) -> f64 {
    PinProblem::printed().ok().and_then(|instant| instant.by_vectors()).map_or(f64::NAN, |motion| quantity(&motion))
}

/// The finding at the printed instant, from the mechanism and its motion by vectors.
fn at_the_instant(find: impl Fn(&PinProblem, &PinMotion<f64>) -> Finding) -> Finding {
    let found = PinProblem::printed().ok().and_then(|instant| Some(find(&instant, &instant.by_vectors()?)));
    found.unwrap_or_else(|| Finding::new(false, "there is no such position"))
}

/// The finding at the printed instant, from the pin's position by dual numbers.
fn from_duals(find: impl Fn(&Crank) -> Finding) -> Finding {
    let found = PinProblem::printed().map(|instant| find(&instant.by_duals()));
    found.unwrap_or_else(|_| Finding::new(false, "there is no such position"))
}

/// The sine of an angle in degrees.
fn sine(degrees: f64) -> f64 {
    Turn::from_degrees(degrees).sin
}
