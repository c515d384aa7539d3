//! The parts of wheel and driver, each once, with all that its files need.

use super::base::base_plate;
use super::holes::{Hole, HolePurpose, bore};
use super::mounting::{Fastener, MOST_HOLES, Mounting, Pattern, PinMount, ScrewHole};
use super::walls::{MountingError, ThinWall, least_wall, thin_walls};
use crate::geometry::{Point, direction, turned};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Face, Loop, Sizes};
use std::f64::consts::PI;

/// A layer of the drawing; the pieces of one layer are cut from one sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The wheel.
    Wheel,
    /// The driver's locking disc, in the wheel's plane.
    LockingDisc,
    /// The driver's plate, behind the wheel.
    Plate,
    /// The pins, or the holes for them in the plate.
    Pins,
    /// The plate that carries both axes.
    BasePlate,
    /// Crosses at axes and pins.
    Centres,
    /// Pockets and shoulders that don't go through a part.
    Pockets,
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 7] =
        [Self::Wheel, Self::LockingDisc, Self::Plate, Self::Pins, Self::BasePlate, Self::Centres, Self::Pockets];

    /// The layer's name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wheel => "WHEEL",
            Self::LockingDisc => "LOCKING_DISC",
            Self::Plate => "DRIVER_PLATE",
            Self::Pins => "PINS",
            Self::BasePlate => "BASE_PLATE",
            Self::Centres => "CENTRES",
            Self::Pockets => "POCKETS",
        }
    }

    /// What its part is called in a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Self::Wheel => "wheel",
            Self::LockingDisc => "locking disc",
            Self::Plate => "driver plate",
            Self::Pins => "pin",
            Self::BasePlate => "base plate",
            Self::Centres => "centre marks",
            Self::Pockets => "pockets",
        }
    }
}

/// Where a part is in the assembly, in the middle of a dwell: the wheel's axis is the origin, the driver's is at (c, 0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Angle by which the part is turned about its own axis, in radians.
    pub turn: f64,
    /// Where its axis is, in millimetres.
    pub at: Point,
    /// Height of its lower face, in millimetres; that of the wheel is at 0.
    pub bottom: f64,
}

/// A part: a plate with holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What it is.
    pub layer: Layer,
    /// Its outer line, counter-clockwise, about its own axis, in millimetres.
    pub outer: Loop,
    /// Its holes.
    pub holes: Vec<Hole>,
    /// Where its axis and the middles of its pins are marked, in millimetres.
    pub marks: Vec<Point>,
    /// Its thickness, or a pin's length, in millimetres.
    pub thickness: f64,
    /// Its places in the assembly: more than one if there are several of it.
    pub places: Vec<Place>,
    /// Whether it is in one piece with the plate, where a file has solids.
    pub is_joined: bool,
}

impl Part {
    /// How many of it there are.
    pub fn quantity(&self) -> usize {
        self.places.len()
    }

    /// Its outline with the holes that go through it.
    pub fn face(&self) -> Face {
        Face { outer: self.outer.clone(), holes: self.holes.iter().map(|hole| hole.outline.clone()).collect() }
    }

    /// Its volume in cubic millimetres, less the pockets.
    pub fn volume(&self) -> f64 {
        let pocket = |hole: &Hole| {
            let wide = hole.widening.as_ref()?;
            Some((crate::geometry::area(&wide.outline) - crate::geometry::area(&hole.outline)).abs() * wide.depth)
        };
        self.face().area() * self.thickness - self.holes.iter().filter_map(pocket).sum::<f64>()
    }

    /// Whether it is cut out of a sheet.
    pub fn is_cut(&self) -> bool {
        self.layer != Layer::Pins
    }
}

/// All parts, and which of their walls are thin.
#[derive(Clone, Debug, PartialEq)]
pub struct PartList {
    /// The parts: wheel, locking disc, plate, pins, base plate.
    pub parts: Vec<Part>,
    /// Walls beside chosen holes that are thin.
    pub thin_walls: Vec<ThinWall>,
}

/// Turns of a pattern that are tried, over one of its pitches, for the thickest walls.
const TURNS: u32 = 24;

/// The parts of a wheel and its driver: outlines with all holes, thickness and place.
///
/// Without a choice there are no holes but those of pins; axes and pins are marked. Drawings of outlines have nothing of the
/// thickness. Patterns of holes are turned to where their walls are thickest.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Layer, Mounting, parts};
///
/// let sizes = Sizes::new(Wheel::with_pins(6, 2)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let list = parts(&sizes, 6.0, &Mounting::default()).expect("bare parts");
/// let layers: Vec<Layer> = list.parts.iter().map(|part| part.layer).collect();
/// assert_eq!(layers, [Layer::Wheel, Layer::LockingDisc, Layer::Plate, Layer::Pins]);
/// assert_eq!(list.parts[3].quantity(), 2);
/// assert!(list.thin_walls.is_empty());
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// [`MountingError`] for a choice that does not fit these sizes: which part, by how much, and what to change.
pub fn parts(sizes: &Sizes, thickness: f64, mounting: &Mounting) -> Result<PartList, MountingError> {
    if !(thickness > 0.0 && thickness.is_finite()) {
        return Err(MountingError::Thickness { part: Layer::Wheel.words(), asked: thickness });
    }
    for (what, pattern) in [
        ("the wheel's hub", mounting.wheel_hub),
        ("the driver's hub", mounting.driver_hub),
        ("the dowels of the disc", mounting.disc_dowels),
    ] {
        pattern.map_or(Ok(()), |pattern| pattern.validate(what))?;
    }
    let (outline, pins) = (sizes.outline(), sizes.wheel.pins());
    let (half_pitch, between) = (sizes.wheel.half_pitch_angle(), PI / f64::from(pins));
    let driver = Place { turn: PI - between, at: Point::new(sizes.centre_distance, 0.0), bottom: 0.0 };
    let play = axial_play(sizes);
    let plain = |layer, face: Face, places| Part {
        layer,
        outer: face.outer,
        holes: Vec::new(),
        marks: vec![Point::zeros()],
        thickness,
        places,
        is_joined: false,
    };

    let mut wheel =
        plain(Layer::Wheel, outline.wheel, vec![Place { turn: half_pitch, at: Point::zeros(), bottom: 0.0 }]);
    let bores = [[sizes.wheel_shaft, sizes.wheel_bore()], [sizes.driver_shaft, sizes.driver_bore()]];
    wheel.holes.extend(bore(Layer::Wheel.words(), bores[0], mounting.wheel_fit, half_pitch)?);

    let is_joined = !mounting.disc_is_apart();
    let mut disc = outline.disc.map(|face| {
        let mut disc = plain(Layer::LockingDisc, face, vec![Place { bottom: -play, ..driver }]);
        disc.is_joined = is_joined;
        // In one piece with the plate it begins there; else it is of the wheel's sheet.
        disc.thickness += if is_joined { play } else { 0.0 };
        disc
    });
    if let Some(disc) = disc.as_mut().filter(|_| sizes.driver_shaft > 0.0) {
        disc.holes.extend(bore(Layer::LockingDisc.words(), bores[1], mounting.driver_fit, between)?);
    }

    let mut plate = plain(Layer::Plate, outline.plate, vec![Place { bottom: -play - thickness, ..driver }]);
    plate.holes.extend(bore(
        Layer::Plate.words(),
        [sizes.plate_shaft, sizes.plate_bore()],
        mounting.driver_fit,
        between,
    )?);
    let directions = (0..pins).map(|k| 2.0 * between * f64::from(k));
    let middles: Vec<(f64, Point)> = directions.map(|angle| (angle, direction(angle) * sizes.crank_radius)).collect();
    let fastener = pin_fastener(sizes, mounting.pins)?;
    plate.holes.extend(middles.iter().map(|(angle, at)| Hole::fastened(HolePurpose::Pin, *at, fastener, *angle)));
    plate.marks.extend(middles.iter().map(|(_, at)| *at));

    if let Some(pattern) = mounting.wheel_hub {
        place(pattern, HolePurpose::Hub, &mut [&mut wheel])?;
    }
    for (pattern, purpose) in [(mounting.driver_hub, HolePurpose::Hub), (mounting.disc_dowels, HolePurpose::DiscDowel)]
    {
        let Some(pattern) = pattern else { continue };
        match disc.as_mut() {
            Some(disc) => place(pattern, purpose, &mut [&mut plate, disc])?,
            None => place(pattern, purpose, &mut [&mut plate])?,
        }
    }

    let mut all = vec![wheel];
    all.extend(disc);
    all.push(plate);
    if !matches!(mounting.pins, PinMount::Screw(..)) {
        all.push(pin(sizes, thickness, mounting, &middles, driver));
    }
    let top = -2.0 * play - thickness;
    all.extend(mounting.base.map(|base| base_plate(sizes, base, thickness, top)).transpose()?);
    let thin_walls = all.iter().map(thin_walls).collect::<Result<Vec<_>, _>>()?.concat();
    Ok(PartList { parts: all, thin_walls })
}

/// The play between wheel and plate along the axes, in millimetres: that of the slots.
pub(crate) fn axial_play(sizes: &Sizes) -> f64 {
    sizes.play.slot
}

/// A pin: a dowel through the plate, or what stands on the plate in one piece with it.
fn pin(sizes: &Sizes, thickness: f64, mounting: &Mounting, middles: &[(f64, Point)], driver: Place) -> Part {
    let is_joined = mounting.pins == PinMount::Solid && !mounting.disc_is_apart();
    let play = axial_play(sizes);
    let through = if is_joined { 0.0 } else { thickness };
    let places = middles.iter().map(|(_, middle)| Place {
        at: driver.at + turned(*middle, driver.turn),
        bottom: -play - through,
        ..driver
    });
    Part {
        layer: Layer::Pins,
        outer: Loop::circle(Point::zeros(), sizes.pin_radius(), false),
        holes: Vec::new(),
        marks: Vec::new(),
        thickness: thickness + play + through,
        places: places.collect(),
        is_joined,
    }
}

/// What goes through the pins' holes in the plate.
fn pin_fastener(sizes: &Sizes, pins: PinMount) -> Result<Fastener, MountingError> {
    match pins {
        PinMount::Solid | PinMount::Dowel => Ok(Fastener::Dowel(sizes.pin_diameter)),
        PinMount::Screw(thread, _) if thread.diameter() > sizes.pin_diameter => {
            Err(MountingError::ThickScrew { screw: thread.name(), pin: sizes.pin_diameter })
        }
        PinMount::Screw(thread, hole) => Ok(Fastener::Screw(thread, hole)),
    }
}

impl Pattern {
    fn validate(&self, what: &'static str) -> Result<(), MountingError> {
        let refuse = |asked, range| Err(MountingError::Pattern { what, asked, range });
        if !(2..=MOST_HOLES).contains(&self.count) {
            return refuse(f64::from(self.count), "from 2 to 12 holes");
        }
        if !(self.circle > 0.0 && self.circle.is_finite()) {
            return refuse(self.circle, "a circle's diameter in mm, above zero and finite");
        }
        match self.fastener {
            Fastener::Dowel(diameter) if !(diameter > 0.0 && diameter.is_finite()) => {
                refuse(diameter, "a dowel's diameter in mm, above zero and finite")
            }
            _ => Ok(()),
        }
    }
}

/// Puts a pattern into all of these parts, turned to where its thinnest wall is thickest.
fn place(pattern: Pattern, purpose: HolePurpose, parts: &mut [&mut Part]) -> Result<(), MountingError> {
    let pitch = 2.0 * PI / f64::from(pattern.count);
    let least = |first: f64| {
        let holes = || pattern.holes(purpose, first);
        let of = |part: &&mut Part| {
            holes().filter_map(|hole| Some(least_wall(part, &hole)?.1)).fold(f64::INFINITY, f64::min)
        };
        parts.iter().map(of).fold(f64::INFINITY, f64::min)
    };
    let turns = (0..TURNS).map(|k| pitch * f64::from(k) / f64::from(TURNS));
    let first = turns.map(|first| (first, least(first))).fold((0.0, f64::NEG_INFINITY), |best, next| {
        // Of walls that differ by rounding the first is taken.
        if next.1 > best.1 + 1e-9 { next } else { best }
    });
    for (k, part) in parts.iter_mut().enumerate() {
        for hole in pattern.holes(purpose, first.0) {
            // A nut's pocket is in the lowest part; above it the screw passes, also where the lowest is tapped.
            let above = match pattern.fastener {
                Fastener::Screw(thread, ScrewHole::Tapped) if !part.is_joined => {
                    Hole::round(purpose, hole.centre, thread.clearance_hole())
                }
                _ => hole.clone().narrow(),
            };
            part.holes.push(if k == 0 { hole } else { above });
        }
    }
    Ok(())
}
