//! Holes as closed lines: bores with keyway or flat, round holes, and the pockets of nuts.

use super::error::MountingError;
use super::mounting::{Fastener, Pattern, ScrewHole, ShaftFit};
use super::standards::{KEYED_SHAFTS, Keyway, Thread};
use crate::geometry::{Point, direction};
use geneva_kinematics::wheel::{Edge, Loop};
use std::f64::consts::PI;

/// What a hole is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HolePurpose {
    /// The bore of a shaft.
    Bore,
    /// The hole of a pin.
    Pin,
    /// The hole of the screw that holds a pin, in the plate and in the pin's bush.
    PinScrew,
    /// A hole of the pattern that holds a part on its hub.
    Hub,
    /// A hole of the pattern that holds locking disc and plate together.
    DiscDowel,
    /// A hole at a corner of the base plate.
    Fixing,
    /// A slot of the test piece.
    TestSlot,
    /// The inside of an internal wheel's ring, with its slots.
    Inside,
}

impl HolePurpose {
    /// What it is called in a sentence.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Bore => "the bore",
            Self::Pin => "the pin's hole",
            Self::PinScrew => "the hole of the pin's screw",
            Self::Hub => "a hole of the hub",
            Self::DiscDowel => "a dowel's hole",
            Self::Fixing => "a fixing hole",
            Self::TestSlot => "a slot of the test piece",
            Self::Inside => "the inside of the ring",
        }
    }
}

/// The wider upper or lower part of a hole: a shoulder, or the pocket of a nut.
#[derive(Clone, Debug, PartialEq)]
pub struct Widening {
    /// Its outline, clockwise, around that of the hole.
    pub outline: Loop,
    /// How deep it is, in millimetres.
    pub depth: f64,
    /// Whether it is cut from below.
    pub is_from_below: bool,
}

/// A hole through a part.
#[derive(Clone, Debug, PartialEq)]
pub struct Hole {
    /// What it is for.
    pub purpose: HolePurpose,
    /// Where its middle is, in millimetres.
    pub centre: Point,
    /// Its outline, clockwise, so that the material is on the left.
    pub outline: Loop,
    /// Where it is wider, if it is.
    pub widening: Option<Widening>,
}

impl Hole {
    /// A round hole; lengths in millimetres.
    pub(super) fn round(purpose: HolePurpose, centre: Point, diameter: f64) -> Self {
        Self { purpose, centre, outline: Loop::circle(centre, diameter / 2.0, true), widening: None }
    }

    /// The hole of a fastener; a nut trap is cut from below.
    pub(super) fn fastened(purpose: HolePurpose, centre: Point, fastener: Fastener, towards: f64) -> Self {
        let mut hole = Self::round(purpose, centre, fastener.hole());
        if let Fastener::Screw(thread, ScrewHole::NutTrap) = fastener {
            let outline = hexagon(centre, thread, towards);
            hole.widening = Some(Widening { outline, depth: thread.nut_height(), is_from_below: true });
        }
        hole
    }

    /// The hole without its wider part.
    pub(super) fn narrow(self) -> Self {
        Self { widening: None, ..self }
    }

    /// The hole's outline where it is widest.
    pub(crate) fn widest(&self) -> &Loop {
        self.widening.as_ref().map_or(&self.outline, |wide| &wide.outline)
    }

    /// Diameter of the hole if it is round, in millimetres.
    pub fn diameter(&self) -> Option<f64> {
        match self.outline.edges.as_slice() {
            [Edge::Arc { radius, .. }] => Some(2.0 * radius),
            _ => None,
        }
    }
}

/// The pocket of a nut, a corner towards an angle in radians.
fn hexagon(centre: Point, thread: Thread, towards: f64) -> Loop {
    let corner =
        |k: i32| centre + direction(towards - PI / 3.0 * f64::from(k)) * (thread.nut_width() / libm::sqrt(3.0));
    Loop { edges: (0..6).map(|k| Edge::Line { from: corner(k), to: corner(k + 1) }).collect() }
}

/// The bore for a shaft of this diameter, with its keyway or flat towards an angle in radians; none without a shaft.
pub(super) fn bore(
    part: &'static str,
    [shaft, bore]: [f64; 2],
    fit: ShaftFit,
    towards: f64,
) -> Result<Option<Hole>, MountingError> {
    if shaft <= 0.0 {
        return if fit == ShaftFit::Round {
            Ok(None)
        } else {
            Err(MountingError::NoShaft { part, what: "a keyway or a flat" })
        };
    }
    let radius = bore / 2.0;
    let round = Hole::round(HolePurpose::Bore, Point::zeros(), bore);
    let at = |x: f64, y: f64| Point::new(x, y);
    // The bore's circle the long way round, from below the opening to above it.
    let rest = |half: f64| Edge::Arc { centre: Point::zeros(), radius, start: -half, sweep: 2.0 * (half - PI) };
    let edges = match fit {
        ShaftFit::Round => return Ok(Some(round)),
        ShaftFit::Key => {
            let [least, most] = KEYED_SHAFTS;
            let key = Keyway::of_shaft(shaft).ok_or(MountingError::Keyed { part, shaft, least, most })?;
            let (half, bottom) = (key.width / 2.0, shaft / 2.0 + key.depth);
            let opening = libm::asin(half / radius);
            let edge = radius * libm::cos(opening);
            let corners = [at(edge, half), at(bottom, half), at(bottom, -half), at(edge, -half)];
            let lines = corners.windows(2).map(|pair| Edge::Line { from: pair[0], to: pair[1] });
            std::iter::once(rest(opening)).chain(lines).collect()
        }
        ShaftFit::Flat { across } => {
            if !(across > shaft / 2.0 && across < shaft) {
                return Err(MountingError::Flat { part, across, shaft });
            }
            let play = bore - shaft;
            if fit.turning_play(shaft, play).is_none() {
                return Err(MountingError::LooseFlat { part, across, shaft, play });
            }
            let flat = across - shaft / 2.0 + (radius - shaft / 2.0);
            let half = (radius * radius - flat * flat).max(0.0).sqrt();
            vec![rest(libm::atan2(half, flat)), Edge::Line { from: at(flat, half), to: at(flat, -half) }]
        }
    };
    Ok(Some(Hole { outline: Loop { edges }.transform(towards, Point::zeros()), ..round }))
}

impl Pattern {
    /// The circles around its holes and pockets, the first towards an angle in radians.
    pub(super) fn circles(&self, purpose: HolePurpose, first: f64) -> impl Iterator<Item = Hole> {
        self.holes(purpose, first).map(move |hole| {
            let across = match self.fastener {
                Fastener::Screw(thread, ScrewHole::NutTrap) => thread.nut_width() * 2.0 / libm::sqrt(3.0),
                other => other.hole(),
            };
            Hole::round(purpose, hole.centre, across)
        })
    }

    /// Its holes, the first towards an angle in radians.
    pub(super) fn holes(&self, purpose: HolePurpose, first: f64) -> impl Iterator<Item = Hole> {
        let Self { count, circle, fastener } = *self;
        (0..count).map(move |k| {
            let towards = first + 2.0 * PI * f64::from(k) / f64::from(count);
            Hole::fastened(purpose, direction(towards) * (circle / 2.0), fastener, towards)
        })
    }
}
