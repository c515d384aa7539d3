//! Mouths of the slots: sharp, chamfered, rounded, or opening on an arc.
//!
//! A mouth takes material away and leaves the rest as it was: rim, slot and locking arc stay where they are. So whatever runs
//! with sharp corners runs with any mouth; what changes is where the pin lands as it comes in, and how far the wheel turns
//! loosely while the pin is in the mouth.
//!
//! Everything is said of one side of one slot, the slot's middle on the first axis and the wall above it, with the material
//! farther up. Wall, face and rim bound there a convex piece of the wheel, so a round pin touches it in one point.
//!
//! Notation: `R` wheel radius, `h` half the width of a slot, ρ the pin's radius.

use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

type Point = Vector2<f64>;

/// Shape of the mouths of the slots.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Mouth, Play, Scale, Sizes, Wheel};
///
/// let of = |mouth| {
///     let choices = Choices { mouth, play: Some(Play::from_slot(0.05)), ..Choices::default() }; // mm
///     Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &choices)
/// };
/// let hardest = |mouth| Ok::<_, geneva_kinematics::wheel::SizesError>(of(mouth)?.knock().expect("a dwell").drifted);
/// // An arc that opens by 0.5 mm over 5 mm is softer to the pin of a wheel that has drifted than a sharp corner is.
/// assert!(hardest(Mouth::LeadIn { length: 5.0, flare: 0.5 })? < 0.6 * hardest(Mouth::Sharp)?); // over the pin's speed
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mouth {
    /// Corners where the straight walls meet the rim.
    #[default]
    Sharp,
    /// A flat face on each side.
    Chamfer {
        /// How much of each wall it takes, along the slot from the wheel radius, in millimetres.
        width: f64,
        /// Its angle to the wall, in radians, more than zero and less than a right angle.
        angle: f64,
    },
    /// An arc on each side that is tangent to wall and rim.
    Round {
        /// Its radius, in millimetres.
        radius: f64,
    },
    /// An arc on each side that is tangent to the wall and runs out at the rim.
    LeadIn {
        /// How much of each wall it takes, along the slot from the wheel radius, in millimetres.
        length: f64,
        /// How far it has left the wall's line at the wheel radius, in millimetres.
        flare: f64,
    },
}

/// The face between a wall and the rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum MouthFace {
    Flat {
        /// Direction out of the material.
        normal: Point,
        /// In millimetres.
        length: f64,
    },
    Round {
        centre: Point,
        /// In millimetres.
        radius: f64,
        /// Direction from the centre to the rim's corner, in radians; the wall's end is at a right angle below.
        end: f64,
    },
}

/// One side of a mouth, the other is its mirror image; lengths in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MouthProfile {
    /// Where the straight wall ends.
    pub wall_end: Point,
    /// What is between the wall's end and the rim; nothing if the corner is sharp.
    pub face: Option<MouthFace>,
    /// Where the rim begins.
    pub rim: Point,
}

/// What a pin rests on at a mouth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MouthPart {
    /// The straight wall before it.
    Wall,
    /// The face between wall and rim, or the corner where it begins at the wall.
    Face,
    /// The corner of face and rim.
    Corner,
}

/// Whether a direction is between straight down and another one, both in radians.
fn is_from_below(direction: f64, end: f64) -> bool {
    let turned = direction + FRAC_PI_2;
    (turned - 2.0 * PI * libm::floor(turned / (2.0 * PI))) <= end + FRAC_PI_2
}

impl Mouth {
    /// One side of the mouth of a slot of half this width whose walls would end at this wheel radius, under a rim of this
    /// radius. None for a mouth that never comes to the rim.
    pub(super) fn profile(&self, wheel_radius: f64, half: f64, rim: f64) -> Option<MouthProfile> {
        let sharp = Point::new(wheel_radius, half);
        let arc = |centre: Point, radius: f64, at: Point| MouthProfile {
            wall_end: Point::new(centre.x, half),
            face: Some(MouthFace::Round { centre, radius, end: libm::atan2(at.y - centre.y, at.x - centre.x) }),
            rim: at,
        };
        match *self {
            Self::Sharp => Some(MouthProfile { wall_end: sharp, face: None, rim: sharp }),
            Self::Chamfer { width, angle } => {
                let (sin, cos) = libm::sincos(angle);
                let wall_end = Point::new(wheel_radius - width, half);
                let along = wall_end.x * cos + wall_end.y * sin;
                let root = along * along + (rim - wall_end.norm()) * (rim + wall_end.norm());
                let length = root.max(0.0).sqrt() - along;
                let face = Some(MouthFace::Flat { normal: Point::new(sin, -cos), length });
                let rim = wall_end + Point::new(cos, sin) * length;
                Some(MouthProfile { wall_end, face, rim }).filter(|_| length > 0.0)
            }
            Self::Round { radius } => {
                let (from_axis, up) = (rim - radius, half + radius);
                let along = ((from_axis - up) * (from_axis + up)).max(0.0).sqrt();
                let centre = Point::new(along, up);
                (from_axis > up).then(|| arc(centre, radius, centre * (rim / from_axis)))
            }
            Self::LeadIn { length, flare } => {
                let radius = (length * length + flare * flare) / (2.0 * flare);
                let centre = Point::new(wheel_radius - length, half + radius);
                let from_axis = centre.norm();
                let cosine = (rim * rim + (from_axis - radius) * (from_axis + radius)) / (2.0 * rim * from_axis);
                let angle = libm::atan2(centre.y, centre.x) - libm::acos(cosine.clamp(-1.0, 1.0));
                let at = Point::new(libm::cos(angle), libm::sin(angle)) * rim;
                (cosine.abs() <= 1.0).then(|| arc(centre, radius, at))
            }
        }
    }
}

impl MouthProfile {
    /// Corners of wall and face and of face and rim; of a sharp mouth the one corner twice.
    pub(super) fn corners(&self) -> [Point; 2] {
        [self.wall_end, self.rim]
    }

    /// Whether a point under the rim and beyond the wall's end is in the mouth and not in the material.
    pub(super) fn is_open(&self, p: &Point) -> bool {
        let from_end = p - self.wall_end;
        from_end.x > 0.0
            && match self.face {
                None => false,
                Some(MouthFace::Flat { normal, .. }) => from_end.dot(&normal) > 0.0,
                Some(MouthFace::Round { centre, radius, end }) => {
                    let from = p - centre;
                    from.norm() > radius && is_from_below(libm::atan2(from.y, from.x), end)
                }
            }
    }

    /// Distance of a point from the face, in millimetres; from its corners where they are nearer than all of its inside.
    pub(super) fn distance(&self, p: &Point) -> f64 {
        let [wall, rim] = self.corners().map(|corner| (p - corner).norm());
        let foot = match self.face {
            None => None,
            Some(MouthFace::Flat { normal, length }) => {
                let from = p - self.wall_end;
                let along = -from.perp(&normal);
                (0.0..=length).contains(&along).then(|| from.dot(&normal).abs())
            }
            Some(MouthFace::Round { centre, radius, end }) => {
                let from = p - centre;
                is_from_below(libm::atan2(from.y, from.x), end).then(|| (from.norm() - radius).abs())
            }
        };
        foot.unwrap_or(f64::INFINITY).min(wall).min(rim)
    }

    /// The point of a round face on the line from its centre in this direction, if the face reaches so far.
    pub(super) fn on_arc(&self, towards: impl Fn(&Point) -> Point) -> Option<Point> {
        let Some(MouthFace::Round { centre, radius, end }) = self.face else { return None };
        let direction = towards(&centre);
        let length = direction.norm();
        let is_on_face = length > 0.0 && is_from_below(libm::atan2(direction.y, direction.x), end);
        is_on_face.then(|| centre + direction * (radius / length))
    }

    /// The angle at which a pin of the radius `rho` first touches the face, and the direction across their faces towards the
    /// pin. The pin's centre is at the axis less `a` (sin τ, ± cos τ), τ the angle and the sign that of `a`, which turns
    /// with τ. None if it does not touch the face, or touches a corner of it.
    pub(super) fn first_on_face(&self, axis: &Point, a: f64, rho: f64) -> Option<(f64, Point)> {
        let pin = |tau: f64| axis - Point::new(a.abs() * libm::sin(tau), a * libm::cos(tau));
        let side = 1.0_f64.copysign(a);
        let entering = |along: &Point, reach: f64| {
            let tau = libm::atan2(along.x, side * along.y) - libm::acos(reach);
            (reach.abs() <= 1.0).then(|| tau - 2.0 * PI * libm::round(tau / (2.0 * PI)))
        };
        match self.face? {
            MouthFace::Flat { normal, length } => {
                let beyond = (axis - self.wall_end).dot(&normal) - rho;
                let tau = entering(&normal, beyond / a.abs())?;
                let along = -(pin(tau) - self.wall_end).perp(&normal);
                (0.0..=length).contains(&along).then_some((tau, normal))
            }
            MouthFace::Round { centre, radius, end } => {
                let (from, reach) = (axis - centre, radius + rho);
                let distance = from.norm();
                // By the difference of the squares, in which a long radius loses no digits.
                let beyond = (distance - reach) * (distance + reach) + a * a;
                let tau = entering(&from, beyond / (2.0 * a.abs() * distance))?;
                let normal = (pin(tau) - centre) / reach;
                is_from_below(libm::atan2(normal.y, normal.x), end).then_some((tau, normal))
            }
        }
    }

    /// The greatest angle from the slot's middle, in radians, of the centre of a pin of this radius that is at this distance
    /// from the wheel's axis, with a gap to the straight wall of half the play.
    pub(super) fn room(&self, r: f64, rho: f64, gap: f64) -> f64 {
        self.room_with_part(r, rho, gap).0
    }

    /// The [room](Self::room), and what ends it.
    pub(super) fn room_with_part(&self, r: f64, rho: f64, gap: f64) -> (f64, MouthPart) {
        let wall = libm::asin((gap / r).clamp(-1.0, 1.0));
        if r * libm::cos(wall) <= self.wall_end.x {
            return (wall, MouthPart::Wall);
        }
        // Of a circle of this radius about a point that the pin must not enter: the law of cosines.
        let beside = |centre: &Point, reach: f64| {
            let from_axis = libm::hypot(centre.x, centre.y);
            let cosine = (r * r + from_axis * from_axis - reach * reach) / (2.0 * r * from_axis);
            (cosine < 1.0).then(|| libm::atan2(centre.y, centre.x) - libm::acos(cosine.max(-1.0)))
        };
        let at = |angle: f64| Point::new(libm::cos(angle), libm::sin(angle)) * r;
        let face = match self.face {
            None => None,
            Some(MouthFace::Flat { normal, length }) => {
                let sine = (self.wall_end.dot(&normal) + rho) / r;
                let angle = libm::atan2(normal.x, -normal.y) - libm::asin(sine.clamp(-1.0, 1.0));
                let along = -(at(angle) - self.wall_end).perp(&normal);
                (sine.abs() <= 1.0 && (0.0..=length).contains(&along)).then_some(angle)
            }
            Some(MouthFace::Round { centre, radius, end }) => beside(&centre, radius + rho).filter(|angle| {
                let from = at(*angle) - centre;
                is_from_below(libm::atan2(from.y, from.x), end)
            }),
        };
        // The corner between wall and face is part of what the pin is to land on; the one at the rim is not.
        let corners = self.corners().into_iter().zip([MouthPart::Face, MouthPart::Corner]);
        let corners = corners.filter_map(|(corner, part)| Some((beside(&corner, rho)?, part)));
        let all = corners.chain(face.map(|angle| (angle, MouthPart::Face)));
        all.reduce(|one, other| if other.0 <= one.0 { other } else { one }).unwrap_or((wall, MouthPart::Wall))
    }

    /// The direction out of the material, of length 1, at the point of face and corners that is nearest to a point outside.
    pub(super) fn normal_towards(&self, p: &Point) -> Point {
        let corner = |corner: Point| (p - corner, (p - corner).norm());
        let [wall, rim] = self.corners().map(corner);
        let (from, apart) = if wall.1 < rim.1 { wall } else { rim };
        let of_face = match self.face {
            None => None,
            Some(MouthFace::Flat { normal, length }) => {
                let along = -(p - self.wall_end).perp(&normal);
                (0.0..=length).contains(&along).then_some(normal)
            }
            Some(MouthFace::Round { centre, end, .. }) => {
                let from = p - centre;
                is_from_below(libm::atan2(from.y, from.x), end).then(|| from / from.norm())
            }
        };
        of_face.unwrap_or(from / apart)
    }

    /// How far the centre of a pin of this radius is from the wheel's axis, in millimetres, where what it rests on changes: from wall to
    /// mouth, and from one part of the mouth to the next.
    pub(super) fn changes(&self, rho: f64) -> [f64; 3] {
        let off = |from: Point, normal: Point| (from + normal * rho).norm();
        let wall = off(self.wall_end, Point::new(0.0, -1.0));
        let [first, last] = match self.face {
            None => [wall; 2],
            Some(MouthFace::Flat { normal, .. }) => [off(self.wall_end, normal), off(self.rim, normal)],
            Some(MouthFace::Round { centre, radius, .. }) => [wall, off(self.rim, (self.rim - centre) / radius)],
        };
        [wall, first, last]
    }
}
