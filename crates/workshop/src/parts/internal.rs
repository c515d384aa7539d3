//! The parts of an internal wheel: a ring, the plate that closes it, and the driver's plate with pin and locking segment.

use super::error::MountingError;
use super::holes::{Hole, HolePurpose, bore};
use super::list::{PartList, axial_play, pin_fastener, pin_hole, place, screw_holes};
use super::mounting::{Mounting, PinMount};
use super::part::{Layer, Part, Place};
use super::walls::thin_walls;
use crate::geometry::Point;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::{Face, Loop};
use std::f64::consts::PI;

/// The parts of an internal wheel and its driver: outlines with all holes, thickness and place, in millimetres.
///
/// The driver's axis lies within the ring, so its shaft ends in the plate behind, and the wheel's is in front. Of the mounting,
/// the hub of the wheel is in the plate that closes the ring, that of the driver in its plate, and the dowels of the disc hold
/// ring and closing plate together.
///
/// ```
/// use geneva_kinematics::internal_sizes::InternalSizes;
/// use geneva_kinematics::internal_wheel::InternalWheel;
/// use geneva_kinematics::wheel::Choices;
/// use geneva_workshop::{Layer, Mounting, internal_parts, step};
///
/// let sizes = InternalSizes::new(InternalWheel::new(6)?, 50.0, &Choices::default())?; // mm
/// let list = internal_parts(&sizes, 6.0, &Mounting::default()).expect("bare parts").parts;
/// let layers: Vec<Layer> = list.iter().map(|part| part.layer).collect();
/// assert_eq!(layers, [Layer::Wheel, Layer::RingPlate, Layer::LockingSegment, Layer::Plate, Layer::Pins]);
/// assert!(step(&list).is_ok());
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// [`MountingError`] for a choice that does not fit these sizes: which part, by how much, and what to change.
pub fn internal_parts(sizes: &InternalSizes, thickness: f64, mounting: &Mounting) -> Result<PartList, MountingError> {
    if !(thickness > 0.0 && thickness.is_finite()) {
        return Err(MountingError::Thickness { part: Layer::Wheel.words(), asked: thickness });
    }
    if mounting.base.is_some() {
        return Err(MountingError::BaseOfInternal);
    }
    mounting.validate()?;
    let (outline, half_pitch) = (sizes.outline(), sizes.wheel.half_pitch_angle());
    let play = axial_play(sizes.play.slot, mounting);
    let still = Place { turn: half_pitch, at: Point::zeros(), bottom: 0.0 };
    let driver = Place { turn: PI, at: Point::new(sizes.centre_distance, 0.0), bottom: -play };
    let plain = |layer, outer: Loop, place: Place| Part {
        layer,
        outer,
        holes: Vec::new(),
        marks: vec![Point::zeros()],
        thickness,
        places: vec![place],
        engraved: Vec::new(),
        is_joined: false,
        hole_allowance: 0.0,
    };
    let is_joined = !mounting.is_stacked;

    let Face { outer, holes } = outline.ring;
    let closing = outer.clone();
    let mut ring = plain(Layer::Wheel, outer, still);
    // Its axis is in the empty middle.
    ring.marks.clear();
    let inside = |outline| Hole { purpose: HolePurpose::Inside, centre: Point::zeros(), outline, widening: None };
    ring.holes.extend(holes.into_iter().map(inside));
    let mut closed = plain(Layer::RingPlate, closing, Place { bottom: thickness, ..still });
    let shaft = [sizes.wheel_shaft, sizes.bore(sizes.wheel_shaft)];
    closed.holes.extend(bore(closed.layer.words(), shaft, mounting.wheel_fit, half_pitch)?);

    let mut segment = plain(Layer::LockingSegment, outline.segment.outer, driver);
    segment.marks.clear();
    segment.is_joined = is_joined;

    let mut plate = plain(Layer::Plate, outline.plate.outer, Place { bottom: -play - thickness, ..driver });
    let shaft = [sizes.plate_shaft, sizes.bore(sizes.plate_shaft)];
    plate.holes.extend(bore(plate.layer.words(), shaft, mounting.driver_fit, PI)?);
    let middle = Point::new(sizes.crank_radius, 0.0);
    let fastener = pin_fastener(sizes.pin_diameter, mounting.pins)?;
    plate.holes.push(Hole::fastened(pin_hole(fastener), middle, fastener, 0.0));
    plate.marks.push(middle);

    let patterns = [(mounting.wheel_hub, &mut closed), (mounting.driver_hub, &mut plate)];
    for (pattern, part) in patterns {
        pattern.map_or(Ok(()), |pattern| place(pattern, HolePurpose::Hub, &mut [part]))?;
    }
    if let Some(pattern) = mounting.disc_dowels {
        place(pattern, HolePurpose::DiscDowel, &mut [&mut ring, &mut closed])?;
    }

    let mut all = vec![ring, closed, segment, plate];
    if let Some(holes) = screw_holes(sizes.pin_diameter, mounting.pins)? {
        if let (PinMount::Screw(thread, _), false) = (mounting.pins, holes.is_empty()) {
            // What holds the bush on its screw, head or nut, is on the bush, and the plate that closes the ring is just above.
            let (screw, thread, pin) = (thread.name(), thread.diameter(), sizes.pin_diameter);
            return Err(MountingError::HeadUnderRing { screw, thread, pin, room: play });
        }
        let is_joined = is_joined && mounting.pins == PinMount::Solid;
        let through = if is_joined || !holes.is_empty() { 0.0 } else { thickness };
        let place = Place { at: driver.at - middle, bottom: driver.bottom - through, ..driver };
        all.push(Part {
            thickness: thickness + through,
            holes,
            marks: Vec::new(),
            engraved: Vec::new(),
            is_joined,
            hole_allowance: 0.0,
            ..plain(Layer::Pins, Loop::circle(Point::zeros(), sizes.pin_radius(), false), place)
        });
    }
    let thin_walls = all.iter().filter(|part| part.is_cut()).map(thin_walls).collect::<Result<Vec<_>, _>>()?.concat();
    Ok(PartList { parts: all, thin_walls })
}
