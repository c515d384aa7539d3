//! Between which angles the wheel is free at a crank angle, and what stops it on either side.
//!
//! A wheel and its driver go through events: in event t pin t comes into slot −t, and after it the disc dwells in the arc
//! between the slots −t and −t − 1, all counted round. Angles are counted from the middle of the event as drawn: the crank angle θ from the
//! line of centres, the wheel angle φ from where the slot's right direction is on that line. The wheel's axis is the origin, the driver's
//! is at (c, 0), and the pin at (c − a cos θ, a sin θ). Each pair of parts stops the wheel at an angle in closed form, forwards or
//! backwards, so the free angles are one interval.

use super::claw::{Claw, ClawLimit, Cut};
use super::contact::BuiltContact;
use super::mouth::{Mouth, horn_end};
use super::parts::AsBuiltWheel;
use crate::indexing::Indexing;
use std::f64::consts::PI;

/// Where the wheel is stopped on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleLimit {
    /// The wheel angle, in radians from the middle of the event as drawn.
    pub angle: f64,
    /// Which parts stop it.
    pub contact: BuiltContact,
    /// The number of the slot, or of the arc in which the disc is.
    pub part: usize,
    /// Distance of the contact, or of the pin's centre, from the wheel's axis, in millimetres.
    pub radius: f64,
    /// How deep the parts are in each other along the radius, however the wheel is turned, in millimetres; zero unless they are.
    pub overlap: f64,
}

/// The angles between which the wheel is free.
///
/// ```
/// use geneva_kinematics::wheel::as_built::{AsBuiltWheel, BuiltContact};
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm, a gap of 0.1 mm
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
/// let free = AsBuiltWheel::from(&sizes).free_angles(0, 0.0)?;
/// // On the line of centres the pin is 100 mm − 50 mm from the wheel's axis.
/// assert!((free.forward.angle - (0.1_f64 / 50.0).asin()).abs() < 1e-14); // rad
/// assert_eq!(free.forward.contact, BuiltContact::PinOnWall);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeAngles {
    /// Where the wheel is stopped backwards: the least angle.
    pub backward: AngleLimit,
    /// Where it is stopped forwards: the greatest angle.
    pub forward: AngleLimit,
}

impl FreeAngles {
    /// How far the wheel is free, in radians. Below zero the parts overlap, wherever the wheel is.
    pub fn width(&self) -> f64 {
        self.forward.angle - self.backward.angle
    }

    /// The middle of the free angles, in radians.
    pub fn middle(&self) -> f64 {
        f64::midpoint(self.forward.angle, self.backward.angle)
    }

    /// How far the wheel is free, in millimetres where the nearer of the two contacts is. Below zero it is by how much the parts
    /// overlap: along the radius where both contacts do, because no wheel angle helps there; otherwise around the wheel's axis.
    pub fn room(&self) -> f64 {
        let (width, overlaps) = (self.width(), [self.forward.overlap, self.backward.overlap]);
        if width < 0.0 && overlaps.iter().all(|overlap| *overlap > 0.0) {
            return -overlaps[0].max(overlaps[1]);
        }
        width * self.forward.radius.min(self.backward.radius)
    }

    pub(super) fn stop_forward(&mut self, limit: AngleLimit) {
        if limit.angle < self.forward.angle {
            self.forward = limit;
        }
    }

    pub(super) fn stop_backward(&mut self, limit: AngleLimit) {
        if limit.angle > self.backward.angle {
            self.backward = limit;
        }
    }
}

/// Rooms of a pin at a place: its distance from the wheel's axis, its angle from the slot's middle if the wheel is at 0, and the
/// angles with their contacts, clockwise and counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub(super) struct PinPlace {
    /// Distance from the wheel's axis, in millimetres.
    pub distance: f64,
    /// Angle from the slot's middle if the wheel is at 0, in radians.
    pub beside: f64,
    /// Angles with their contacts, clockwise and counter-clockwise, in radians.
    pub rooms: [Option<(f64, BuiltContact)>; 2],
}

/// A wheel and its driver with all that does not depend on the crank angle.
#[derive(Clone, Debug)]
pub(super) struct Assembled<'a> {
    pub built: &'a AsBuiltWheel,
    /// How far out the horns beside each slot go, clockwise and counter-clockwise, in millimetres.
    horns: Vec<[f64; 2]>,
    mouths: Vec<Mouth>,
    /// Half the opening of each pin's crescent, as an angle at the driver's axis, in radians.
    openings: Vec<f64>,
    /// The greatest angle on the disc's rim that the wheel reaches, in radians.
    reach: f64,
    /// Half the angle between slots, in radians.
    pub half_pitch: f64,
    /// The angle between pins, in radians.
    pub pin_pitch: f64,
}

impl<'a> Assembled<'a> {
    pub(super) fn new(built: &'a AsBuiltWheel) -> Self {
        let wheel = built.wheel();
        let (slots, arcs) = (built.slots(), built.arcs());
        let (count, half_pitch) = (slots.len(), wheel.half_pitch_angle());
        let horns: Vec<[f64; 2]> = slots
            .iter()
            .enumerate()
            .map(|(k, slot)| {
                let (before, after) = (&arcs[(k + count - 1) % count], &arcs[k]);
                let turned = |error: f64| half_pitch + error;
                [
                    horn_end(slot, before, turned(slot.direction_error - before.direction_error)),
                    horn_end(slot, after, turned(after.direction_error - slot.direction_error)),
                ]
            })
            .collect();
        let mouths = slots.iter().zip(&horns).map(|(slot, horns)| Mouth::new(slot, *horns, built.mouth)).collect();
        let (c, disc) = (built.centre_distance, built.disc_radius.unwrap_or_default());
        let opening = |q: f64, radius: f64| {
            let cosine = (disc * disc + q * q - radius * radius) / (2.0 * disc * q);
            libm::acos(cosine.clamp(-1.0, 1.0))
        };
        let openings = match built.disc_radius {
            Some(_) => built.pins().iter().map(|pin| opening(pin.crescent.centre, pin.crescent.radius)).collect(),
            None => vec![0.0; built.pins().len()],
        };
        let rim = slots.iter().map(|slot| slot.tip_radius).fold(0.0, f64::max);
        let cosine = (c * c + disc * disc - rim * rim) / (2.0 * c * disc);
        let reach = if disc > 0.0 { libm::acos(cosine.clamp(-1.0, 1.0)) } else { 0.0 };
        let pin_pitch = 2.0 * PI / built.pins().len() as f64;
        Self { built, horns, mouths, openings, reach, half_pitch, pin_pitch }
    }

    /// The number of the slot into which the pin of an event comes.
    pub(super) fn slot_of(&self, event: i64) -> usize {
        (-event).rem_euclid(self.built.slots().len() as i64) as usize
    }

    /// The number of the arc in which the disc dwells after an event.
    pub(super) fn arc_of(&self, event: i64) -> usize {
        (-event - 1).rem_euclid(self.built.slots().len() as i64) as usize
    }

    /// The number of the pin of an event.
    pub(super) fn pin_of(&self, event: i64) -> usize {
        event.rem_euclid(self.built.pins().len() as i64) as usize
    }

    pub(super) fn mouth(&self, slot: usize) -> &Mouth {
        &self.mouths[slot]
    }

    pub(super) fn mouths(&self) -> impl Iterator<Item = &Mouth> {
        self.mouths.iter()
    }

    /// Crank angle of a pin from the line of centres, in an event so many later, in radians.
    fn crank(&self, later: i64, theta: f64) -> f64 {
        theta - later as f64 * self.pin_pitch
    }

    /// The pin of an event at the crank angle of the event, and the rooms that its slot leaves it.
    pub(super) fn pin_place(&self, event: i64, theta: f64) -> PinPlace {
        let (slot, pin) = (self.slot_of(event), self.built.pins()[self.pin_of(event)]);
        let (sin, cos) = libm::sincos(theta - pin.direction_error);
        let (x, y) = (self.built.centre_distance - pin.crank_radius * cos, pin.crank_radius * sin);
        let distance = libm::hypot(x, y);
        let mouth = &self.mouths[slot];
        let radius = pin.diameter / 2.0;
        let rooms = [0, 1].map(|side| mouth.room(side, distance, radius));
        let beside = if rooms == [None, None] { 0.0 } else { libm::atan2(y, x) };
        PinPlace { distance, beside: beside - self.built.slots()[slot].direction_error, rooms }
    }

    /// The angles that the pins leave the wheel at a crank angle of an event.
    pub(super) fn stop_by_pins(&self, event: i64, theta: f64, free: &mut FreeAngles) {
        // The same pin comes again after a turn.
        for later in [-1, 0, 1].into_iter().filter(|later| self.crank(*later, theta).abs() < PI) {
            let place = self.pin_place(event + later, self.crank(later, theta));
            let slot = self.slot_of(event + later);
            let beside = place.beside + 2.0 * self.half_pitch * later as f64;
            let limit = |sign: f64, (room, contact): (f64, BuiltContact)| {
                let is_deep = contact == BuiltContact::PinAtBottom && room < 0.0;
                let overlap = if is_deep { -room * place.distance } else { 0.0 };
                AngleLimit { angle: beside + sign * room, contact, part: slot, radius: place.distance, overlap }
            };
            let [clockwise, counter] = place.rooms;
            if let Some(room) = clockwise {
                free.stop_forward(limit(1.0, room));
            }
            if let Some(room) = counter {
                free.stop_backward(limit(-1.0, room));
            }
        }
    }

    /// The crescent of an event's pin at the crank angle of the event, mirrored on the line of centres if the sign is −1.
    fn cut(&self, event: i64, theta: f64, sign: f64) -> Cut {
        let crescent = self.built.pins()[self.pin_of(event)].crescent;
        let (sin, cos) = libm::sincos(theta - crescent.direction_error);
        let c = self.built.centre_distance;
        let (x, y) = (c - crescent.centre * cos, crescent.centre * sin);
        let distance = libm::hypot(x, y);
        let share = (distance - crescent.radius) / distance;
        let disc = self.built.disc_radius.unwrap_or_default();
        let is_closed = share > 0.0 && libm::hypot(share * x - c, share * y) < disc;
        Cut { distance, angle: sign * libm::atan2(y, x), radius: crescent.radius, is_closed }
    }

    /// The angles that the locking disc leaves the wheel at a crank angle of an event.
    pub(super) fn stop_by_disc(&self, event: i64, theta: f64, free: &mut FreeAngles) {
        let Some(disc) = self.built.disc_radius else { return };
        for later in -2..=1 {
            let (upper_pin, lower_pin) = (event + later, event + later + 1);
            let (at_upper, at_lower) = (self.crank(later, theta), self.crank(later + 1, theta));
            let edge = |event, angle, sign| {
                let pin = self.pin_of(event);
                angle - self.built.pins()[pin].crescent.direction_error + sign * self.openings[pin]
            };
            let (low, high) = (edge(lower_pin, at_lower, 1.0), edge(upper_pin, at_upper, -1.0));
            if low >= high || low >= self.reach || high <= -self.reach {
                continue;
            }
            let arc = self.arc_of(event + later);
            let sizes = &self.built.arcs()[arc];
            let middle = sizes.direction_error - self.half_pitch * (2 * later + 1) as f64;
            let claw = |sign: f64| {
                let (ends, cut, horn) = if sign > 0.0 {
                    let horn = self.horns[self.slot_of(upper_pin)][0];
                    ([low, high], self.cut(upper_pin, at_upper, sign), horn)
                } else {
                    let horn = self.horns[self.slot_of(lower_pin)][1];
                    ([-high, -low], self.cut(lower_pin, at_lower, sign), horn)
                };
                Claw { axes: self.built.centre_distance, disc, ends, cut, arc: [sizes.radius, sizes.centre], horn }
                    .limit()
            };
            let limit = |sign: f64, of: ClawLimit| {
                let angle = sign * of.angle - middle;
                AngleLimit { angle, contact: of.contact, part: arc, radius: of.radius, overlap: of.overlap }
            };
            if let Some(least) = claw(1.0) {
                free.stop_backward(limit(1.0, least));
            }
            if let Some(least) = claw(-1.0) {
                free.stop_forward(limit(-1.0, least));
            }
        }
    }

    /// Free for a whole pitch to either side.
    pub(super) fn unstopped(&self, event: i64) -> FreeAngles {
        let limit = |sign: f64| AngleLimit {
            angle: sign * 2.0 * self.half_pitch,
            contact: BuiltContact::Nothing,
            part: self.slot_of(event),
            radius: self.built.centre_distance,
            overlap: 0.0,
        };
        FreeAngles { backward: limit(-1.0), forward: limit(1.0) }
    }

    pub(super) fn free(&self, event: i64, theta: f64) -> FreeAngles {
        let mut free = self.unstopped(event);
        self.stop_by_pins(event, theta, &mut free);
        self.stop_by_disc(event, theta, &mut free);
        free
    }

    /// Crank angles of an event, in order, at which a part comes within reach of another or leaves it, the first and the last
    /// included, in radians.
    pub(super) fn changes(&self, event: i64) -> Vec<f64> {
        let half = self.pin_pitch / 2.0;
        let mut changes = vec![-half, half, 0.0];
        let c = self.built.centre_distance;
        for later in [-1, 0, 1] {
            let shift = later as f64 * self.pin_pitch;
            let number = self.pin_of(event + later);
            let pin = self.built.pins()[number];
            let a = pin.crank_radius;
            for reach in self.mouths[self.slot_of(event + later)].changes(pin.diameter / 2.0) {
                let cosine = (a * a + c * c - reach * reach) / (2.0 * a * c);
                if cosine.abs() < 1.0 {
                    let angle = libm::acos(cosine);
                    changes.extend([angle, -angle].map(|angle| angle + shift + pin.direction_error));
                }
            }
            if self.built.disc_radius.is_some() {
                let opening = self.openings[number];
                for reach in [0.0, self.reach, -self.reach] {
                    let at = reach + shift + pin.crescent.direction_error;
                    changes.extend([at + opening, at - opening]);
                }
            }
        }
        changes.retain(|angle| angle.abs() <= half);
        changes.sort_by(f64::total_cmp);
        changes.dedup();
        changes
    }
}

impl AsBuiltWheel {
    /// Between which angles the wheel is free at a crank angle of an event, in radians from the line of centres.
    ///
    /// In event t pin t comes into slot −t, both counted round; it goes from half the angle between pins before to half of it after.
    ///
    /// # Errors
    ///
    /// The errors of [`check`](Self::check).
    pub fn free_angles(&self, event: i64, crank_angle: f64) -> Result<FreeAngles, super::BuiltError> {
        self.check()?;
        Ok(Assembled::new(self).free(event, crank_angle))
    }
}
