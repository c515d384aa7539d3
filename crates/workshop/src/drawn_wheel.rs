//! The sizes of a wheel and its driver from the lines and arcs of a drawing.
//!
//! The wheel's axis is the centre that most of its arcs share: its rim is there. Hollow arcs with their centres farther out than the rim are
//! locking arcs; of the others those that go half round are ends of slots, whose walls are the lines beside them. Without any, slots are
//! pairs of lines. Rounded or chamfered mouths are passed over. The disc is about the centre of the arc that goes
//! farthest round, and its other arcs are crescents. Pins are circles, about the middle of the plate's largest circle. One that is much
//! smaller than a slot is wide is the hole of a screw: the pin's diameter is then unknown.

use crate::dxf_reader::{Drawing, DrawingError};
use crate::parts::Layer;
use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel};
use geneva_kinematics::wheel::{Edge, Wheel};
use nalgebra::Vector2;
use std::f64::consts::PI;

type Point = Vector2<f64>;

/// Centres nearer to each other than this part of the drawing's size are one.
const SAME: f64 = 1e-4;

/// Which layer has which part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LayerNames {
    /// The wheel.
    pub wheel: String,
    /// The driver's locking disc.
    pub disc: String,
    /// The driver's plate.
    pub plate: String,
    /// The pins. Of circles about one centre the largest is the pin.
    pub pins: String,
}

impl Default for LayerNames {
    /// The layers of our own files.
    fn default() -> Self {
        let name = |layer: Layer| layer.name().to_owned();
        Self {
            wheel: name(Layer::Wheel),
            disc: name(Layer::LockingDisc),
            plate: name(Layer::Plate),
            pins: name(Layer::Pins),
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct DrawnArc {
    centre: Point,
    radius: f64,
    sweep: f64,
    /// Where it begins, where its middle is, and where it ends.
    points: [Point; 3],
}

impl DrawnArc {
    /// Whether its middle is nearer to a point than both its ends: it is hollow as seen from there.
    fn is_hollow_from(&self, axis: Point) -> bool {
        let [start, middle, end] = self.points.map(|point| (point - axis).norm());
        middle < start.min(end)
    }
}

/// A slot of a drawing, its directions in radians.
#[derive(Clone, Copy, Debug)]
struct DrawnSlot {
    direction: f64,
    end: f64,
    width: f64,
}

/// A circle smaller than this part of a slot's width is no pin but the hole of a screw: our choice.
const LEAST_PIN: f64 = 0.7;

/// A wall that ends no farther from the mouth's corner than this part of the slot's width has a sharp corner: our choice.
const SHARP: f64 = 0.01;

/// What a drawing says of a wheel.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Drawing, LayerNames, Mounting, PartLayout, dxf, parts};
///
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let list = parts(&sizes, 5.0, &Mounting::default())?; // thickness in mm
/// let drawn = Drawing::read(&dxf(&list.parts, PartLayout::Assembled))?.measure(&LayerNames::default(), 0.01)?;
/// assert!(drawn.screw_hole.is_none() && !drawn.has_mouths);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnWheel {
    /// The sizes, each with its uncertainty.
    pub measured: MeasuredWheel,
    /// Diameter, in millimetres, of the circles in the pins' places where these are holes of screws and no pins: the pins' diameter is
    /// then not measured.
    pub screw_hole: Option<f64>,
    /// Whether the mouths of slots are chamfered, rounded or widened. The sizes have sharp corners instead.
    pub has_mouths: bool,
}

/// The end of a slot goes round by at least so much, in radians; a rounded corner by less.
const LEAST_END: f64 = 0.75 * PI;

impl Drawing {
    fn on<'a>(&'a self, layer: &'a str) -> impl Iterator<Item = &'a Edge> {
        self.edges.iter().filter(move |drawn| drawn.layer.eq_ignore_ascii_case(layer)).map(|drawn| &drawn.edge)
    }

    fn arcs(&self, layer: &str) -> Vec<DrawnArc> {
        let arc = |edge: &Edge| match *edge {
            Edge::Arc { centre, radius, start, sweep } => {
                let at = |share: f64| {
                    let (sin, cos) = libm::sincos(start + share * sweep);
                    centre + Point::new(cos, sin) * radius
                };
                Some(DrawnArc { centre, radius, sweep: sweep.abs(), points: [0.0, 0.5, 1.0].map(at) })
            }
            Edge::Line { .. } => None,
        };
        self.on(layer).filter_map(arc).collect()
    }

    /// What the drawing says of a wheel's sizes, each with a standard uncertainty in millimetres.
    ///
    /// The centre distance is known only where the driver is drawn in its place. Slots are numbered counter-clockwise; the first is the one
    /// nearest to the direction of the drawing's first axis, to the right, and of two about as near the one counter-clockwise. An arc has
    /// the number of the slot clockwise of it.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    /// use geneva_workshop::{Drawing, LayerNames, Mounting, PartLayout, dxf, parts};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
    /// let list = parts(&sizes, 5.0, &Mounting::default())?; // thickness in mm
    /// let drawing = Drawing::read(&dxf(&list.parts, PartLayout::Assembled))?;
    /// let nearest = drawing.measure(&LayerNames::default(), 0.01)?.measured.nearest()?;
    /// assert!(nearest.culprit.is_none() && (nearest.crank_radius - 50.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`DrawingError::Missing`] for a layer without the wheel's rim or slots, [`DrawingError::Internal`] for a drawing of an internal wheel by
    /// this program, and [`DrawingError::Sizes`] for what no wheel has.
    pub fn measure(&self, layers: &LayerNames, uncertainty: f64) -> Result<DrawnWheel, DrawingError> {
        let missing = |layer: &str, missing| DrawingError::Missing { layer: layer.to_owned(), missing };
        let of_ring = [Layer::LockingSegment, Layer::RingPlate].map(Layer::name);
        if let Some(layer) = of_ring.into_iter().find(|layer| self.on(layer).next().is_some()) {
            return Err(DrawingError::Internal { layer });
        }
        let arcs = self.arcs(&layers.wheel);
        let size = arcs.iter().map(|arc| arc.radius).fold(0.0, f64::max);
        let axis = shared_centre(&arcs, size, |_| 1.0).ok_or_else(|| missing(&layers.wheel, "there is no arc"))?;
        let about_axis = |arc: &&DrawnArc| (arc.centre - axis).norm() < SAME * size;
        let rim = arcs.iter().filter(about_axis).map(|arc| arc.radius).fold(0.0, f64::max);
        let direction = |arc: &DrawnArc| {
            let from = arc.centre - axis;
            libm::atan2(from.y, from.x)
        };
        let others = arcs.iter().filter(|arc| !about_axis(arc));
        let is_locking = |arc: &DrawnArc| (arc.centre - axis).norm() >= rim && arc.is_hollow_from(axis);
        let locking: Vec<&DrawnArc> = others.clone().filter(|arc| is_locking(arc)).collect();
        let ends = others.filter(|arc| (arc.centre - axis).norm() < rim && arc.sweep > LEAST_END && !is_circle(arc));
        let ends: Vec<&DrawnArc> = ends.collect();
        let within = (3.0 * uncertainty).max(SAME * size);
        ends.iter().try_for_each(|end| self.straight_walls(&layers.wheel, axis, end, within))?;
        let mut slots: Vec<DrawnSlot> = ends
            .into_iter()
            .map(|arc| DrawnSlot {
                direction: direction(arc),
                end: (arc.centre - axis).norm(),
                width: self.width(&layers.wheel, axis, arc),
            })
            .collect();
        if slots.is_empty() {
            slots = self.square_slots(&layers.wheel, axis, rim);
        }
        number_from_the_right(&mut slots);
        let plate = self.arcs(&layers.plate).into_iter().filter(is_circle);
        let driver = plate.max_by(|one, other| one.radius.total_cmp(&other.radius)).map(|circle| circle.centre);
        let pins = self.pins(&layers.pins, driver, SAME * size);
        let wheel = Wheel::with_pins(slots.len() as u32, pins.len().max(1) as u32)
            .map_err(|error| DrawingError::Sizes(format!("slots on layer {}: {error}", layers.wheel)))?;
        let mut measured = MeasuredWheel::new(wheel);
        let mut add = |size, value, uncertainty| {
            measured.add(size, value, uncertainty).map_err(|error| DrawingError::Sizes(error.to_string()))
        };
        let pitch = 2.0 * PI / slots.len() as f64;
        // Where slot 0 would be if all slots and arcs were right.
        let offs: Vec<f64> = slots.iter().enumerate().map(|(k, slot)| slot.direction - pitch * k as f64).collect();
        let near = median(&offs);
        let place = |arc: &DrawnArc| libm::round((direction(arc) - near) / pitch - 0.5);
        let of_arcs = locking.iter().map(|arc| direction(arc) - pitch * (place(arc) + 0.5));
        let base = median(&offs.iter().copied().chain(of_arcs).collect::<Vec<_>>());
        add(MeasuredSize::TipRadius, rim, uncertainty)?;
        for (k, (slot, off)) in slots.iter().zip(&offs).enumerate() {
            add(MeasuredSize::SlotWidth(Some(k)), slot.width, uncertainty)?;
            add(MeasuredSize::SlotEnd(Some(k)), slot.end, uncertainty)?;
            add(MeasuredSize::SlotDirection(k), off - base, uncertainty / rim)?;
        }
        for arc in &locking {
            let number = (place(arc) as i64).rem_euclid(slots.len() as i64) as usize;
            add(MeasuredSize::ArcRadius(Some(number)), arc.radius, uncertainty)?;
            add(MeasuredSize::ArcCentre(Some(number)), (arc.centre - axis).norm(), uncertainty)?;
        }
        let mut screw_hole = None;
        if let Some(driver) = driver.filter(|_| !pins.is_empty()) {
            let mean = |of: fn(&DrawnArc, Point) -> f64| {
                pins.iter().map(|pin| of(pin, driver)).sum::<f64>() / pins.len() as f64
            };
            add(MeasuredSize::CrankRadius, mean(|pin, driver| (pin.centre - driver).norm()), uncertainty)?;
            let diameter = 2.0 * mean(|pin, _| pin.radius);
            if diameter < LEAST_PIN * median(&slots.iter().map(|slot| slot.width).collect::<Vec<_>>()) {
                screw_hole = Some(diameter);
            } else {
                add(MeasuredSize::PinDiameter, diameter, uncertainty)?;
            }
        }
        let disc = self.arcs(&layers.disc);
        if let Some(middle) = shared_centre(&disc, size, |arc| if is_circle(arc) { 0.0 } else { arc.sweep }) {
            let (about, cuts): (Vec<DrawnArc>, Vec<DrawnArc>) =
                disc.into_iter().partition(|arc| (arc.centre - middle).norm() < SAME * size);
            add(MeasuredSize::DiscRadius, about.iter().map(|arc| arc.radius).fold(0.0, f64::max), uncertainty)?;
            if let Some(cut) = cuts.iter().find(|arc| !is_circle(arc)) {
                add(MeasuredSize::CrescentCentre, (cut.centre - middle).norm(), uncertainty)?;
                add(MeasuredSize::CrescentRadius, cut.radius, uncertainty)?;
            }
            if let Some(driver) = driver.filter(|driver| (driver - middle).norm() < SAME * size) {
                add(MeasuredSize::CentreDistance, (driver - axis).norm(), uncertainty)?;
            }
        }
        let has_mouths = slots.iter().any(|slot| !self.has_sharp_mouth(&layers.wheel, axis, rim, slot));
        Ok(DrawnWheel { measured, screw_hole, has_mouths })
    }

    /// The pins: of circles about one centre the largest, and none about the driver's axis.
    fn pins(&self, layer: &str, driver: Option<Point>, same: f64) -> Vec<DrawnArc> {
        let mut pins: Vec<DrawnArc> = Vec::new();
        let is_pin = |circle: &DrawnArc| driver.is_none_or(|driver| (circle.centre - driver).norm() >= same);
        for circle in self.arcs(layer).into_iter().filter(is_circle).filter(is_pin) {
            match pins.iter_mut().find(|pin| (pin.centre - circle.centre).norm() < same) {
                Some(pin) => pin.radius = pin.radius.max(circle.radius),
                None => pins.push(circle),
            }
        }
        pins
    }

    /// Whether both walls of a slot go out to the rim.
    fn has_sharp_mouth(&self, layer: &str, axis: Point, rim: f64, slot: &DrawnSlot) -> bool {
        let (sin, cos) = libm::sincos(slot.direction);
        let (along, half) = (Point::new(cos, sin), slot.width / 2.0);
        let mouth = along * (rim * rim - half * half).max(0.0).sqrt();
        let near = SHARP * slot.width;
        [-half, half].into_iter().all(|beside| {
            let corner = axis + mouth + Point::new(-along.y, along.x) * beside;
            self.on(layer).any(|edge| match *edge {
                Edge::Line { from, to } => {
                    let is_wall = along.perp(&(to - from).normalize()).abs() < 0.05;
                    is_wall && (from - corner).norm().min((to - corner).norm()) < near
                }
                Edge::Arc { .. } => false,
            })
        })
    }

    /// Slots between two lines that point away from the axis, with square ends. The end told is that of a round one that stops the
    /// pin at the same depth.
    fn square_slots(&self, layer: &str, axis: Point, rim: f64) -> Vec<DrawnSlot> {
        let walls: Vec<(Point, f64, f64)> = self
            .on(layer)
            .filter_map(|edge| {
                let Edge::Line { from, to } = *edge else { return None };
                let (from, to) = (from - axis, to - axis);
                let (inner, outer) = if from.norm() < to.norm() { (from, to) } else { (to, from) };
                let along = (outer - inner).normalize();
                let is_wall = (outer - inner).norm() > 0.1 * rim && along.perp(&inner).abs() < 0.5 * inner.dot(&along);
                is_wall.then(|| (along, along.perp(&inner), inner.dot(&along)))
            })
            .collect();
        // A wall may be drawn in pieces.
        let mut whole: Vec<(Point, f64, f64)> = Vec::new();
        for (along, across, foot) in walls {
            let is_piece =
                |of: &&mut (Point, f64, f64)| of.0.dot(&along) > 1.0 - 1e-6 && (of.1 - across).abs() < 1e-3 * rim;
            match whole.iter_mut().find(is_piece) {
                Some(other) => other.2 = other.2.min(foot),
                None => whole.push((along, across, foot)),
            }
        }
        let walls = whole;
        let opposite = |(along, across, foot): &(Point, f64, f64)| {
            let beside = walls.iter().filter(|(of, other, _)| of.dot(along) > 0.999 && *other > *across);
            let nearest = beside.min_by(|one, other| one.1.total_cmp(&other.1))?;
            let middle = (along + nearest.0).normalize();
            let (width, centre) = (nearest.1 - across, f64::midpoint(nearest.1, *across));
            let direction = libm::atan2(middle.y, middle.x) + libm::asin((centre / rim).clamp(-1.0, 1.0));
            Some(DrawnSlot { direction, end: f64::midpoint(*foot, nearest.2) + width / 2.0, width })
        };
        walls.iter().filter_map(opposite).collect()
    }

    /// Finds the walls of a slot with a round end: from each end of the arc a line goes on outwards, in the direction of the slot. What is
    /// drawn otherwise is no slot whose sizes tell where a pin sticks.
    fn straight_walls(&self, layer: &str, axis: Point, end: &DrawnArc, within: f64) -> Result<(), DrawingError> {
        let along = (end.centre - axis).normalize();
        let fault = |what: String| {
            let degrees = libm::atan2(along.y, along.x).to_degrees();
            DrawingError::Sizes(format!(
                "layer {layer}: of the slot at {degrees:.2}° (from the first axis, seen from the wheel's), {what}"
            ))
        };
        for start in [end.points[0], end.points[2]] {
            let goes_on = self.on(layer).find_map(|edge| match *edge {
                Edge::Line { from, to } if (from - start).norm() < within => Some(to - start),
                Edge::Line { from, to } if (to - start).norm() < within => Some(from - start),
                _ => None,
            });
            let Some(wall) = goes_on.filter(|wall| wall.dot(&along) > 0.0) else {
                return Err(fault(format!(
                    "no wall goes on outwards from the end of its arc at ({:.3}, {:.3}); join them, or say which layer has the wheel",
                    start.x, start.y
                )));
            };
            let off = along.perp(&wall);
            if off.abs() > within {
                return Err(fault(format!(
                    "a wall is {:.3} mm nearer to or farther from the slot's line at its outer end than at its inner one; a check takes \
                     walls that are parallel within {within:.3} mm",
                    off.abs()
                )));
            }
        }
        Ok(())
    }

    /// Width of a slot between the lines beside its end; twice the end's radius where there are none.
    fn width(&self, layer: &str, axis: Point, end: &DrawnArc) -> f64 {
        let along = (end.centre - axis).normalize();
        let mut walls = [None::<f64>; 2];
        for edge in self.on(layer) {
            let Edge::Line { from, to } = edge else { continue };
            let direction = (to - from).normalize();
            let middle = (from + to) / 2.0 - end.centre;
            let across = along.perp(&middle);
            let is_wall =
                along.perp(&direction).abs() < 0.05 && middle.dot(&along) > 0.0 && across.abs() < 2.0 * end.radius;
            if is_wall {
                let wall = &mut walls[usize::from(across > 0.0)];
                *wall = Some(wall.map_or(across.abs(), |other| other.min(across.abs())));
            }
        }
        if let [Some(one), Some(other)] = walls { one + other } else { 2.0 * end.radius }
    }
}

/// Two slots about as far from the right, one on each side: the one counter-clockwise is the first, within this part of a pitch. Our
/// choice.
const ABOUT_AS_FAR: f64 = 0.05;

/// Sorts slots counter-clockwise, the first being the one that should be nearest to the direction of the first axis, and counts their
/// directions on from there. What counts is where all slots together say that they should be, so a slot that is a little out of its
/// place does not change the numbers.
fn number_from_the_right(slots: &mut [DrawnSlot]) {
    let pitch = 2.0 * PI / slots.len().max(1) as f64;
    slots.sort_by(|one, other| one.direction.total_cmp(&other.direction));
    let offs: Vec<f64> = slots.iter().enumerate().map(|(k, slot)| slot.direction - pitch * k as f64).collect();
    let base = median(&offs);
    let first = base + pitch * libm::floor(0.5 + ABOUT_AS_FAR - base / pitch);
    let before = first - pitch / 2.0;
    for slot in slots.iter_mut() {
        slot.direction = before + (slot.direction - before).rem_euclid(2.0 * PI);
    }
    slots.sort_by(|one, other| one.direction.total_cmp(&other.direction));
}

fn is_circle(arc: &DrawnArc) -> bool {
    arc.sweep > 1.999 * PI
}

/// The centre that arcs of the greatest weight share.
fn shared_centre(arcs: &[DrawnArc], size: f64, weight: impl Fn(&DrawnArc) -> f64) -> Option<Point> {
    let sharing = |of: &DrawnArc| {
        let near = arcs.iter().filter(|arc| (arc.centre - of.centre).norm() < SAME * size);
        near.map(&weight).sum::<f64>()
    };
    arcs.iter().max_by(|one, other| sharing(one).total_cmp(&sharing(other))).map(|arc| arc.centre)
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or_default()
}
