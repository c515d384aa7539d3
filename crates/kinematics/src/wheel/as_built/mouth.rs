//! How far a pin in a slot lets the wheel turn.
//!
//! In the slot's frame the slot's middle is the first axis. A pin whose centre is at the distance r from the wheel's axis can be
//! beside the middle by an angle whose sine is (h − ρ)/r, with h half the width and ρ the pin's radius, while a wall stops it;
//! by less where the round end stops it; and where it is outside, by so much that it is ρ away from the corner of the mouth, or
//! from the face of a mouth that is not sharp.

use super::contact::BuiltContact;
use super::parts::{BuiltArc, BuiltSlot};
use crate::Turn;
use crate::wheel::mouth::{Mouth as MouthShape, MouthPart, MouthProfile};
use nalgebra::Vector2;

/// The two corners of a slot and its sizes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mouth {
    half_width: f64,
    end: f64,
    /// Clockwise of the middle, and counter-clockwise.
    corners: [Corner; 2],
    /// The faces there; none of sharp corners.
    profiles: [Option<MouthProfile>; 2],
}

/// A corner of a slot, in the slot's frame, its angle counted from the middle.
#[derive(Clone, Copy, Debug)]
struct Corner {
    along: f64,
    radius: f64,
    angle: f64,
}

/// How far out a horn goes between a slot's wall and the locking arc beside it, in millimetres: to the rim, or to where wall and
/// arc meet. `beside` is the angle of the arc's centre from the slot's middle, in radians.
pub(super) fn horn_end(slot: &BuiltSlot, arc: &BuiltArc, beside: f64) -> f64 {
    let half = slot.width / 2.0;
    let at_rim = slot.tip_radius;
    let corner = libm::asin((half / at_rim).min(1.0));
    let cosine = (at_rim * at_rim + arc.centre * arc.centre - arc.radius * arc.radius) / (2.0 * at_rim * arc.centre);
    let opening = if cosine >= 1.0 { 0.0 } else { libm::acos(cosine.max(-1.0)) };
    if corner + opening <= beside {
        return at_rim;
    }
    let centre = Turn::from_radians(beside).direction() * arc.centre;
    let across = centre.y - half;
    let along = centre.x - (arc.radius * arc.radius - across * across).max(0.0).sqrt();
    libm::hypot(along.max(0.0), half).min(at_rim)
}

impl Mouth {
    /// The mouth of a slot between horns that go so far out, in millimetres: clockwise of its middle, and counter-clockwise.
    pub(super) fn new(slot: &BuiltSlot, horns: [f64; 2], shape: MouthShape) -> Self {
        let half_width = slot.width / 2.0;
        let corners = horns.map(|radius| {
            let along = (radius * radius - half_width * half_width).max(0.0).sqrt();
            Corner { along, radius, angle: libm::atan2(half_width, along) }
        });
        let profile = |corner: Corner| match shape {
            MouthShape::Sharp => None,
            shape => shape.profile(corner.along, half_width, corner.radius),
        };
        Self { half_width, end: slot.end, corners, profiles: corners.map(profile) }
    }

    /// Whether both sides have the shape of mouth that is asked for, and leave some of the wall.
    pub(super) fn is_complete(&self) -> bool {
        self.profiles.iter().all(|profile| profile.is_some_and(|profile| profile.wall_end.x > self.end))
    }

    /// How far from the wheel's axis the centre of a pin of this radius is as it passes the corners, in millimetres.
    pub(super) fn reach(&self, pin: f64) -> [f64; 2] {
        self.corners.map(|corner| corner.radius + pin)
    }

    /// The greatest angle of a pin's centre beside the slot's middle on one side (0 clockwise, 1 counter-clockwise), in radians,
    /// and what stops it. `distance` is how far the centre is from the wheel's axis; lengths in millimetres. None where nothing
    /// stops it; below zero where it fits nowhere.
    pub(super) fn room(&self, side: usize, distance: f64, pin: f64) -> Option<(f64, BuiltContact)> {
        let corner = self.corners[side];
        if distance > corner.radius + pin {
            return None;
        }
        let gap = self.half_width - pin;
        let along = (distance * distance - gap * gap).max(0.0).sqrt();
        if let Some(profile) = self.profiles[side].filter(|profile| along > profile.wall_end.x) {
            let (room, part) = profile.room_with_part(distance, pin, gap);
            // Where by rounding it is not reached, the corner at the rim is just touched.
            if part == MouthPart::Wall {
                return Some((libm::atan2(profile.rim.y, profile.rim.x), BuiltContact::PinAtMouth));
            }
            let is_on_face = part == MouthPart::Face;
            return Some((room, if is_on_face { BuiltContact::PinOnFace } else { BuiltContact::PinAtMouth }));
        }
        if along > corner.along {
            let cosine =
                (distance * distance + corner.radius * corner.radius - pin * pin) / (2.0 * distance * corner.radius);
            let beside = libm::acos(cosine.clamp(-1.0, 1.0));
            return Some((corner.angle - beside, BuiltContact::PinAtMouth));
        }
        let wall = libm::asin((gap / distance).clamp(-1.0, 1.0));
        if gap <= 0.0 || along >= self.end {
            let bottom = self.end - distance;
            return Some(if gap <= 0.0 && bottom > 0.0 && -bottom / distance < wall {
                (-bottom / distance, BuiltContact::PinAtBottom)
            } else {
                (wall, BuiltContact::PinOnWall)
            });
        }
        let cosine = (distance * distance + self.end * self.end - gap * gap) / (2.0 * distance * self.end);
        let room = if cosine > 1.0 { -(self.end - gap - distance) / distance } else { libm::acos(cosine) };
        Some((room, BuiltContact::PinAtBottom))
    }
}

impl Mouth {
    /// The direction, of length 1, from what a pin touches at the mouth on one side to the pin's centre, a point in the slot's frame in
    /// millimetres.
    pub(super) fn normal(&self, side: usize, centre: Vector2<f64>) -> Vector2<f64> {
        let sign = if side == 1 { 1.0 } else { -1.0 };
        match self.profiles[side] {
            Some(profile) => {
                let normal = profile.normal_towards(&Vector2::new(centre.x, sign * centre.y));
                Vector2::new(normal.x, sign * normal.y)
            }
            None => (centre - Vector2::new(self.corners[side].along, sign * self.half_width)).normalize(),
        }
    }

    /// How far the centre of a pin of this radius is from the wheel's axis, in millimetres, where it comes to the mouth or leaves it, and
    /// where it rests on the next part of it.
    pub(super) fn changes(&self, pin: f64) -> impl Iterator<Item = f64> {
        let of_faces = self.profiles.into_iter().flatten().flat_map(move |profile| profile.changes(pin));
        self.reach(pin).into_iter().chain(of_faces)
    }
}
