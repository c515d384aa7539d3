//! How deep wheel and driver are in each other, by points on their outlines.
//!
//! A point of one part is in the other by the least of its distances from the lines and circles that bound it. Nothing here
//! uses an angle at which parts touch.

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Mouth;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, BuiltSlot};
use nalgebra::Vector2;
use std::f64::consts::PI;

pub(super) type Point = Vector2<f64>;

/// Spacing of the points on edges, in millimetres.
const SPACING: f64 = 0.3;

fn unit(angle: f64) -> Point {
    Point::new(angle.cos(), angle.sin())
}

fn turned(p: Point, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y)
}

/// Points of both parts in their own frames.
pub(super) struct Outlines<'a> {
    built: &'a AsBuiltWheel,
    wheel: Vec<Point>,
    disc: Vec<Point>,
    pins: Vec<Point>,
    directions: Vec<f64>,
    middles: Vec<Point>,
    /// The wheel's axis and the driver's.
    axes: [Point; 2],
}

impl<'a> Outlines<'a> {
    pub(super) fn new(built: &'a AsBuiltWheel) -> Self {
        let half_pitch = built.wheel().half_pitch_angle();
        let directions: Vec<f64> = built
            .slots()
            .iter()
            .zip(0..)
            .map(|(slot, k)| 2.0 * half_pitch * f64::from(k) + slot.direction_error)
            .collect();
        let middles = built
            .arcs()
            .iter()
            .zip(0..)
            .map(|(arc, k)| unit(half_pitch * f64::from(2 * k + 1) + arc.direction_error) * arc.centre)
            .collect();
        let axes = [Point::zeros(), Point::new(built.centre_distance, 0.0)];
        let mut all = Self { built, wheel: vec![], disc: vec![], pins: vec![], directions, middles, axes };
        all.wheel = all.wheel_points();
        let pitch = 2.0 * PI / built.pins().len() as f64;
        for (pin, k) in built.pins().iter().zip(0..) {
            let centre = unit(pitch * f64::from(k) + pin.direction_error) * pin.crank_radius;
            // Beside the end of a wall, points of a pin must be near to each other.
            let count = if built.mouth == Mouth::Sharp { 180 } else { 2880 };
            let at = |j: i32| unit(2.0 * PI * f64::from(j) / f64::from(count)) * (pin.diameter / 2.0);
            all.pins.extend((0..count).map(|j| centre + at(j)));
        }
        if let Some(disc) = built.disc_radius {
            let mut points: Vec<Point> = circle(Point::zeros(), disc);
            for (pin, k) in built.pins().iter().zip(0..) {
                let cut = pin.crescent;
                let centre = unit(pitch * f64::from(k) + cut.direction_error) * cut.centre;
                points.extend(circle(centre, cut.radius));
                points.extend(crossings(Point::zeros(), disc, centre, cut.radius));
            }
            all.disc = points.into_iter().filter(|p| all.in_disc(p) > -1e-9).collect();
        }
        all
    }

    /// The parts with their axes elsewhere; crank angles and wheel angles are still counted from the first axis.
    pub(super) fn placed(self, axes: [Point; 2]) -> Self {
        Self { axes, ..self }
    }

    fn wheel_points(&self) -> Vec<Point> {
        let (slots, arcs) = (self.built.slots(), self.built.arcs());
        let mut points = Vec::new();
        for (k, slot) in slots.iter().enumerate() {
            let half = slot.width / 2.0;
            let direction = self.directions[k];
            for side in [-1.0, 1.0] {
                let outer = (slot.tip_radius * slot.tip_radius - half * half).sqrt();
                let count = ((outer - slot.end) / SPACING) as u32 + 1;
                points.extend((0..=count).map(|j| {
                    let along = slot.end + (outer - slot.end) * f64::from(j) / f64::from(count);
                    turned(Point::new(along, side * half), direction)
                }));
                if let Some((end, along)) = chamfer(self.built, slot) {
                    let length = (0..).map(|j| SPACING * f64::from(j)).take_while(|length| *length < slot.tip_radius);
                    let face = length.map(|length| end + along * length);
                    let rim = end.dot(&along);
                    let length = (rim * rim - end.norm_squared() + slot.tip_radius.powi(2)).sqrt() - rim;
                    let face = face.chain([end + along * length]);
                    points.extend(face.map(|p| turned(Point::new(p.x, side * p.y), direction)));
                }
                // Where a wall meets the arc beside it.
                let arc = if side < 0.0 { (k + arcs.len() - 1) % arcs.len() } else { k };
                let beside = turned(self.middles[arc], -direction);
                let across = side * half - beside.y;
                let root = arcs[arc].radius.powi(2) - across * across;
                if root > 0.0 {
                    points.push(turned(Point::new(beside.x - root.sqrt(), side * half), direction));
                }
            }
            points.extend(circle(unit(direction) * slot.end, half));
        }
        for (k, arc) in arcs.iter().enumerate() {
            points.extend(circle(self.middles[k], arc.radius));
            for tip in [slots[k].tip_radius, slots[(k + 1) % slots.len()].tip_radius] {
                points.extend(crossings(Point::zeros(), tip, self.middles[k], arc.radius));
            }
        }
        let rims: Vec<Point> = slots
            .iter()
            .enumerate()
            .flat_map(|(k, slot)| {
                let tip = slot.tip_radius;
                let pitch = PI / slots.len() as f64;
                let direction = self.directions[k];
                circle(Point::zeros(), tip)
                    .into_iter()
                    .filter(move |p| turned(*p, -direction).angle(&Point::x()) < pitch)
            })
            .collect();
        points.extend(rims);
        points.into_iter().filter(|p| self.in_wheel(p) > -1e-9).collect()
    }

    /// How deep a point in the wheel's frame is in the wheel; below zero outside.
    fn in_wheel(&self, p: &Point) -> f64 {
        let angle = p.y.atan2(p.x);
        let count = self.directions.len();
        let pitch = 2.0 * PI / count as f64;
        // The rim's radius changes in the middle of each arc.
        let sector = ((angle / pitch).round() as i64).rem_euclid(count as i64) as usize;
        let mut depth = self.built.slots()[sector].tip_radius - p.norm();
        for (slot, direction) in self.built.slots().iter().zip(&self.directions) {
            let at = turned(*p, -direction);
            let beside = if at.x >= slot.end { at.y.abs() } else { (at - Point::new(slot.end, 0.0)).norm() };
            depth = depth.min(beside - slot.width / 2.0);
            if let Some((end, along)) = chamfer(self.built, slot) {
                let from = Point::new(at.x, at.y.abs()) - end;
                depth = depth.min(along.perp(&from));
            }
        }
        for (arc, middle) in self.built.arcs().iter().zip(&self.middles) {
            depth = depth.min((p - middle).norm() - arc.radius);
        }
        depth
    }

    /// How deep a point in the driver's frame is in the locking disc.
    fn in_disc(&self, p: &Point) -> f64 {
        let Some(disc) = self.built.disc_radius else { return f64::NEG_INFINITY };
        let pitch = 2.0 * PI / self.built.pins().len() as f64;
        let mut depth = disc - p.norm();
        for (pin, k) in self.built.pins().iter().zip(0..) {
            let cut = pin.crescent;
            let centre = unit(pitch * f64::from(k) + cut.direction_error) * cut.centre;
            depth = depth.min((p - centre).norm() - cut.radius);
        }
        depth
    }

    fn in_pins(&self, p: &Point) -> f64 {
        let pitch = 2.0 * PI / self.built.pins().len() as f64;
        let depth = |(pin, k): (&geneva_kinematics::wheel::as_built::BuiltPin, i32)| {
            let centre = unit(pitch * f64::from(k) + pin.direction_error) * pin.crank_radius;
            pin.diameter / 2.0 - (p - centre).norm()
        };
        self.built.pins().iter().zip(0..).map(depth).fold(f64::NEG_INFINITY, f64::max)
    }

    /// How deep the parts are in each other at a crank angle and a wheel angle of an event, in millimetres; below zero they are apart
    /// by about so much.
    pub(super) fn depth(&self, event: i32, theta: f64, wheel: f64) -> f64 {
        let pins = self.built.pins().len() as f64;
        let axis = self.axes[1] - self.axes[0];
        let driver_turn = PI - theta - 2.0 * PI / pins * f64::from(event);
        let wheel_turn = wheel + 2.0 * self.built.wheel().half_pitch_angle() * f64::from(event);
        let mut deepest = f64::NEG_INFINITY;
        let reach = self.built.slots().iter().map(|slot| slot.tip_radius).fold(0.0, f64::max);
        for p in self.disc.iter().chain(&self.pins) {
            let at = axis + turned(*p, driver_turn);
            if at.norm() < reach {
                deepest = deepest.max(self.in_wheel(&turned(at, -wheel_turn)));
            }
        }
        let pin = self.built.pins().iter().map(|pin| pin.crank_radius + pin.diameter / 2.0).fold(0.0, f64::max);
        for p in &self.wheel {
            let at = turned(*p, wheel_turn) - axis;
            if at.norm() < pin {
                let at = turned(at, -driver_turn);
                deepest = deepest.max(self.in_disc(&at)).max(self.in_pins(&at));
            }
        }
        deepest
    }
}

/// Where the upper chamfer of a slot begins, and its direction, in the slot's frame; none of sharp corners.
fn chamfer(built: &AsBuiltWheel, slot: &BuiltSlot) -> Option<(Point, Point)> {
    let Mouth::Chamfer { width, angle } = built.mouth else { return None };
    let half = slot.width / 2.0;
    Some((Point::new((slot.tip_radius.powi(2) - half * half).sqrt() - width, half), unit(angle)))
}

fn circle(centre: Point, radius: f64) -> Vec<Point> {
    let count = (2.0 * PI * radius / SPACING) as u32 + 16;
    (0..count).map(|k| centre + unit(2.0 * PI * f64::from(k) / f64::from(count)) * radius).collect()
}

/// Where two circles cross.
fn crossings(one: Point, radius: f64, other: Point, other_radius: f64) -> Vec<Point> {
    let between = other - one;
    let apart = between.norm();
    let along = (apart * apart + radius * radius - other_radius * other_radius) / (2.0 * apart);
    let square = radius * radius - along * along;
    if square <= 0.0 {
        return vec![];
    }
    let (direction, across) = (between / apart, Point::new(-between.y, between.x) / apart);
    [-1.0, 1.0].map(|sign| one + direction * along + across * (sign * square.sqrt())).into()
}
