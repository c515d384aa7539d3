//! The parts of wheel and driver, each once, with all that its files need.

use super::base::base_plate;
use super::error::MountingError;
use super::holes::{Hole, HolePurpose, bore};
use super::looseness::SAME;
use super::mounting::{Fastener, MOST_HOLES, Mounting, Pattern, PinMount, ScrewHole};
use super::part::{Layer, Part, Place};
use super::walls::{ThinWall, least_wall, thin_walls};
use crate::geometry::{Point, direction, turned};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Face, Loop, Sizes};
use std::f64::consts::PI;

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
    mounting.validate()?;
    let (outline, pins) = (sizes.outline(), sizes.wheel.pins());
    let (half_pitch, between) = (sizes.wheel.half_pitch_angle(), PI / f64::from(pins));
    let driver = Place { turn: PI - between, at: Point::new(sizes.centre_distance, 0.0), bottom: 0.0 };
    let play = axial_play(sizes.play.slot, mounting);
    let plain = |layer, face: Face, places| Part {
        layer,
        outer: face.outer,
        holes: Vec::new(),
        marks: vec![Point::zeros()],
        thickness,
        places,
        engraved: Vec::new(),
        is_joined: false,
        hole_allowance: 0.0,
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
    let fastener = pin_fastener(sizes.pin_diameter, mounting.pins)?;
    plate.holes.extend(middles.iter().map(|(angle, at)| Hole::fastened(pin_hole(fastener), *at, fastener, *angle)));
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
    all.extend(pin(sizes, thickness, mounting, &middles, driver)?);
    let top = -2.0 * play - thickness;
    all.extend(mounting.base.map(|base| base_plate(sizes, base, thickness, top)).transpose()?);
    let thin_walls = all.iter().filter(|part| part.is_cut()).map(thin_walls).collect::<Result<Vec<_>, _>>()?.concat();
    Ok(PartList { parts: all, thin_walls })
}

/// The gap between wheel and plate along the axes, in millimetres: what is chosen, or the play of the slots.
pub(crate) fn axial_play(slot_play: f64, mounting: &Mounting) -> f64 {
    mounting.axial_play.unwrap_or(slot_play)
}

/// A pin: a dowel through the plate, what stands on the plate in one piece with it, or a bush on a screw; none where the screw
/// itself is the pin.
fn pin(
    sizes: &Sizes,
    thickness: f64,
    mounting: &Mounting,
    middles: &[(f64, Point)],
    driver: Place,
) -> Result<Option<Part>, MountingError> {
    let Some(holes) = screw_holes(sizes.pin_diameter, mounting.pins)? else { return Ok(None) };
    let is_joined = mounting.pins == PinMount::Solid && !mounting.disc_is_apart();
    let play = axial_play(sizes.play.slot, mounting);
    let through = if is_joined || !holes.is_empty() { 0.0 } else { thickness };
    // The head of a bush's screw runs as far above the wheel as the plate is below it.
    let above = if holes.is_empty() { 0.0 } else { play };
    let places = middles.iter().map(|(_, middle)| Place {
        at: driver.at + turned(*middle, driver.turn),
        bottom: -play - through,
        ..driver
    });
    Ok(Some(Part {
        layer: Layer::Pins,
        outer: Loop::circle(Point::zeros(), sizes.pin_radius(), false),
        holes,
        marks: Vec::new(),
        thickness: thickness + play + through + above,
        places: places.collect(),
        engraved: Vec::new(),
        is_joined,
        hole_allowance: 0.0,
    }))
}

/// What a hole in the plate for this fastener of a pin is for.
pub(super) fn pin_hole(fastener: Fastener) -> HolePurpose {
    match fastener {
        Fastener::Dowel(_) => HolePurpose::Pin,
        Fastener::Screw(..) => HolePurpose::PinScrew,
    }
}

/// The hole through a pin: that of a bush on a screw, which passes; none where the screw itself is the pin.
pub(super) fn screw_holes(pin: f64, pins: PinMount) -> Result<Option<Vec<Hole>>, MountingError> {
    let PinMount::Screw(thread, _) = pins else { return Ok(Some(Vec::new())) };
    if (pin - thread.diameter()).abs() < SAME {
        return Ok(None);
    }
    let (inner, least) = (thread.clearance_hole(), thread.least_bush());
    if pin < least {
        return Err(MountingError::ThinBush { screw: thread.name(), pin, least });
    }
    Ok(Some(vec![Hole::round(HolePurpose::PinScrew, Point::zeros(), inner)]))
}

/// What goes through the pins' holes in the plate.
pub(super) fn pin_fastener(pin: f64, pins: PinMount) -> Result<Fastener, MountingError> {
    match pins {
        PinMount::Solid | PinMount::Dowel => Ok(Fastener::Dowel(pin)),
        PinMount::Screw(thread, _) if thread.diameter() > pin => {
            Err(MountingError::ThickScrew { screw: thread.name(), pin })
        }
        PinMount::Screw(thread, hole) => Ok(Fastener::Screw(thread, hole)),
    }
}

impl Mounting {
    /// Refuses patterns whose numbers make no holes.
    pub(super) fn validate(&self) -> Result<(), MountingError> {
        let patterns = [
            ("the wheel's hub", self.wheel_hub),
            ("the driver's hub", self.driver_hub),
            ("the dowels of the disc", self.disc_dowels),
        ];
        if let Some(asked) = self.axial_play.filter(|play| !(*play >= 0.0 && play.is_finite())) {
            return Err(MountingError::Pattern { what: "axial play in mm", asked, range: "zero or more and finite" });
        }
        patterns.into_iter().try_for_each(|(what, pattern)| pattern.map_or(Ok(()), |pattern| pattern.validate(what)))
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
pub(super) fn place(pattern: Pattern, purpose: HolePurpose, parts: &mut [&mut Part]) -> Result<(), MountingError> {
    let pitch = 2.0 * PI / f64::from(pattern.count);
    let least = |first: f64| {
        let holes = || pattern.circles(purpose, first);
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
