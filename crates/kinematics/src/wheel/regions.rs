//! How far a point is from a part: positive outside, negative inside, by exact formulas.
//!
//! Both parts are mirror-symmetric about each slot or pin and repeat from one to the next. A point is folded into half a
//! pitch; nothing outside that half can be nearer than its own mirror image inside.

use super::mouth::MouthProfile;
use super::sizes::Sizes;
use crate::indexing::Indexing;
use nalgebra::Vector2;
use std::f64::consts::PI;

type Point = Vector2<f64>;

/// The wheel about its axis, the middle of one slot on the first axis; lengths in millimetres. Its bore is left out.
#[derive(Clone, Copy, Debug)]
pub(super) struct WheelRegion {
    half_pitch: f64,
    slot_end: f64,
    half_width: f64,
    mouth: MouthProfile,
    corner_angle: f64,
    tip: Point,
    tip_angle: f64,
    /// Radius of the rim, in millimetres.
    pub rim: f64,
    locking_centre: Point,
    locking_radius: f64,
}

impl WheelRegion {
    pub(super) fn new(sizes: &Sizes) -> Self {
        let at = |radius: f64, angle: f64| Point::new(radius * libm::cos(angle), radius * libm::sin(angle));
        let (half_pitch, tip_angle) = (sizes.wheel.half_pitch_angle(), sizes.tip_angle());
        Self {
            half_pitch,
            slot_end: sizes.slot_end,
            half_width: sizes.slot_width / 2.0,
            mouth: sizes.mouth_profile(),
            corner_angle: sizes.corner_angle(),
            tip: at(sizes.tip_radius, tip_angle),
            tip_angle,
            rim: sizes.tip_radius,
            locking_centre: at(sizes.centre_distance, half_pitch),
            locking_radius: sizes.locking_arc_radius,
        }
    }

    /// The corners and tips of slot `k`, and the centre of the locking arc after it.
    pub(super) fn sector(&self, k: i32) -> ([Point; 6], Point) {
        let (sin, cos) = libm::sincos(2.0 * self.half_pitch * f64::from(k));
        let turned = |p: Point| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        let mirrored = |p: Point| Point::new(p.x, -p.y);
        let [wall, rim] = self.mouth.corners();
        let points = [rim, mirrored(rim), self.tip, mirrored(self.tip), wall, mirrored(wall)];
        (points.map(turned), turned(self.locking_centre))
    }

    /// The points of the round faces of slot `k`'s mouth that are nearest to a point, and those that are farthest from one,
    /// where the faces reach so far.
    pub(super) fn on_mouth(&self, k: i32, near: &Point, far: &[Point]) -> Vec<Point> {
        let (sin, cos) = libm::sincos(2.0 * self.half_pitch * f64::from(k));
        let mut all = Vec::new();
        for side in [1.0, -1.0] {
            let back = |p: &Point| Point::new(cos * p.x + sin * p.y, side * (cos * p.y - sin * p.x));
            let feet = self.mouth.on_arc(|centre| back(near) - centre).into_iter();
            let feet = feet.chain(far.iter().filter_map(|p| self.mouth.on_arc(|centre| centre - back(p))));
            all.extend(feet.map(|p| Point::new(cos * p.x - sin * side * p.y, sin * p.x + cos * side * p.y)));
        }
        all
    }

    /// Radius of the locking arcs, in millimetres.
    pub(super) fn locking_radius(&self) -> f64 {
        self.locking_radius
    }

    /// Whether the rim is there at this angle from the middle of a slot, in radians.
    pub(super) fn has_rim_at(&self, angle: f64) -> bool {
        (self.corner_angle..=self.tip_angle).contains(&self.folded(angle))
    }

    fn folded(&self, angle: f64) -> f64 {
        let pitch = 2.0 * self.half_pitch;
        (angle - pitch * libm::round(angle / pitch)).abs()
    }

    /// Distance of a point from the wheel, in millimetres; its depth in the wheel with a minus sign.
    pub(super) fn distance(&self, point: &Point) -> f64 {
        let radius = point.norm();
        let angle = self.folded(libm::atan2(point.y, point.x));
        let (sin, cos) = libm::sincos(angle);
        self.folded_distance(&Point::new(radius * cos, radius * sin), radius, angle)
    }

    fn folded_distance(&self, p: &Point, radius: f64, angle: f64) -> f64 {
        let from_end = Point::new(p.x - self.slot_end, p.y);
        let to_slot = if from_end.x < 0.0 { from_end.norm() } else { p.y } - self.half_width;
        let from_locking = p - self.locking_centre;
        let to_locking = from_locking.norm() - self.locking_radius;
        let is_outside = radius > self.rim || to_slot < 0.0 || to_locking < 0.0 || self.mouth.is_open(p);

        let mut least = self.mouth.distance(p).min((p - self.tip).norm());
        if p.x <= self.mouth.wall_end.x {
            least = least.min(to_slot.abs());
        }
        if (self.corner_angle..=self.tip_angle).contains(&angle) {
            least = least.min((radius - self.rim).abs());
        }
        // The locking arc's point nearest to p, if the arc reaches so far.
        let part = self.locking_radius / (to_locking + self.locking_radius);
        let foot = self.locking_centre + from_locking * part;
        if foot.norm_squared() <= self.rim * self.rim || from_locking.norm_squared() == 0.0 {
            least = least.min(to_locking.abs());
        }
        if is_outside { least } else { -least }
    }
}

/// The locking disc about its axis, one pin on the first axis; lengths in millimetres. Its bore is left out.
#[derive(Clone, Debug)]
pub(super) struct DiscRegion {
    /// Its radius, in millimetres.
    pub radius: f64,
    half_angle: f64,
    cut_centre: f64,
    cut_radius: f64,
    edge: Point,
    pins: Vec<Point>,
}

impl DiscRegion {
    /// The disc, if there is one.
    pub(super) fn new(sizes: &Sizes) -> Option<Self> {
        let disc = sizes.locking_disc?;
        let (sin, cos) = libm::sincos(disc.crescent.half_angle);
        let pin = |angle| Point::new(libm::cos(angle), libm::sin(angle));
        Some(Self {
            radius: disc.radius,
            half_angle: disc.crescent.half_angle,
            cut_centre: disc.crescent.centre,
            cut_radius: disc.crescent.radius,
            edge: Point::new(cos, sin) * disc.radius,
            pins: sizes.pin_directions().map(pin).collect(),
        })
    }

    /// The edges of all openings.
    pub(super) fn edges(&self) -> Vec<Point> {
        let turned = |pin: &Point, x: f64, y: f64| Point::new(pin.x * x - pin.y * y, pin.y * x + pin.x * y);
        let both = |pin| [1.0, -1.0].map(|side| turned(pin, self.edge.x, side * self.edge.y));
        self.pins.iter().flat_map(both).collect()
    }

    /// The centres of all cuts.
    pub(super) fn cuts(&self) -> Vec<Point> {
        self.pins.iter().map(|pin| pin * self.cut_centre).collect()
    }

    /// Distance of a point from the disc, in millimetres; its depth in the disc with a minus sign.
    pub(super) fn distance(&self, point: &Point) -> f64 {
        let along = |pin: &Point| Point::new(pin.dot(point), pin.perp(point).abs());
        let folded = self.pins.iter().map(along).max_by(|a, b| a.x.total_cmp(&b.x));
        let Some(p) = folded else { return f64::INFINITY };
        let radius = p.norm();
        let from_cut = p - Point::new(self.cut_centre, 0.0);
        let into_cut = self.cut_radius - from_cut.norm();
        let beyond = radius - self.radius;
        if beyond <= 0.0 && into_cut <= 0.0 {
            return beyond.max(into_cut);
        }
        if beyond > 0.0 && libm::atan2(p.y, p.x) >= self.half_angle.min(PI) {
            return beyond;
        }
        let to_edge = (p - self.edge).norm();
        if into_cut <= 0.0 {
            return to_edge;
        }
        // The cut's point nearest to p, if it is on the disc.
        let foot = Point::new(self.cut_centre, 0.0) + from_cut * (self.cut_radius / (self.cut_radius - into_cut));
        if foot.norm() <= self.radius { into_cut.min(to_edge) } else { to_edge }
    }
}
