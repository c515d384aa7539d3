//! How near ring and driver of an internal wheel come to each other over a whole turn, and how far all sizes may be wrong together.
//!
//! Notation: that of [`internal_sizes`](crate::internal_sizes). The ring is its own mirror image at the middle of each slot and of
//! each arc, and the boundary point that is nearest to a point between two such lines is between them, too. So distances from the
//! ring are those from four edges. Two parts come nearest to each other at a corner of one of them, or where the segment's outer
//! arc is farthest from the centre of a hollow arc, on the line of centres.
//!
//! Over the turn nothing is sampled away, as for the external wheel: a distance changes no faster than its two ends move.

use crate::KinematicsError;
use crate::indexing::Indexing;
use crate::internal_sizes::InternalSizes;
use crate::wheel::{Minimum, Search, SharedTolerance, TOLERANCE, make_wrong, shared_gaps};
use nalgebra::Vector2;
use std::cell::Cell;
use std::f64::consts::PI;

type Point = Vector2<f64>;

/// The tolerance over the lesser gap of slot and locking arc where that makes it finer.
const OF_GAP: f64 = 0.01;
/// The part of the engagement to either side of mid-index in which the segment may be near both arcs beside the slot.
const HALF: f64 = 0.5;
/// Slots to either side of the nearest one whose corners may be near the locking segment.
const NEAR: i32 = 2;

/// The least distance of ring and driver over a whole turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InternalClearance {
    /// The distance in millimetres; below zero where parts are in each other.
    pub distance: f64,
    /// Crank angle from mid-index at which it is reached, in radians; the same holds at its negative.
    pub crank_angle: f64,
    /// How much less, in millimetres, the distance may be somewhere than is said here.
    pub tolerance: f64,
}

impl InternalSizes {
    /// The least distance of ring and driver over a whole turn with the axes at a distance in millimetres: the wheel is turned so
    /// that the pin is in the middle of its slot, and stands still between.
    ///
    /// ```
    /// use geneva_kinematics::internal_sizes::InternalSizes;
    /// use geneva_kinematics::internal_wheel::InternalWheel;
    /// use geneva_kinematics::wheel::{Choices, Play};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
    /// let sizes = InternalSizes::new(InternalWheel::new(6)?, 50.0, &choices)?;
    /// let found = sizes.least_clearance_at(sizes.centre_distance)?;
    /// assert!((found.distance - 0.1).abs() < 1e-9); // mm: half of the play on either side of the pin
    /// assert!(sizes.least_clearance_at(sizes.centre_distance + 1.0)?.distance < 0.0); // the segment is in its arc's bottom
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::CentreDistance`] for a distance that is not finite and greater than the crank radius.
    pub fn least_clearance_at(&self, centre_distance: f64) -> Result<InternalClearance, KinematicsError> {
        InternalAssembly::new(self, centre_distance, 0.0)?.least_clearance(u32::MAX, None)
    }

    /// How far all sizes may be wrong together so that nothing touches. None where loose bores alone take all clearance.
    ///
    /// ```
    /// use geneva_kinematics::internal_sizes::InternalSizes;
    /// use geneva_kinematics::internal_wheel::InternalWheel;
    /// use geneva_kinematics::wheel::{Choices, Play};
    ///
    /// let play = Play { bore: 0.02, ..Play::from_slot(0.2) }; // mm
    /// let sizes = InternalSizes::new(InternalWheel::new(6)?, 50.0, &Choices { play: Some(play), ..Choices::default() })?;
    /// let shared = sizes.shared_tolerance().expect("the play is large enough");
    /// assert!(shared.crank > 0.0 && shared.crank < 0.02); // mm: a fifth of the gap beside the pin
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn shared_tolerance(&self) -> Option<SharedTolerance> {
        self.shared_tolerance_within(u32::MAX).ok().flatten()
    }

    /// How far all sizes may be wrong together, as [`shared_tolerance`](Self::shared_tolerance), with a limit on how many crank
    /// angles are looked at for each of the clearances that it needs.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::TooManyAngles`] where the play is so small that more crank angles are needed.
    pub fn shared_tolerance_within(&self, angles: u32) -> Result<Option<SharedTolerance>, KinematicsError> {
        shared_gaps!(self, self.locking_gap(), true).divided(|limit| self.runs_with(limit, angles))
    }

    /// Whether a whole turn is clear with all errors at these limits, in both senses of crank radius, of the axes and of the
    /// segment's place on its plate, which may be off along its rim by as much as the crank radius. A pin that is off its place along
    /// its circle is as good as a segment that is.
    fn runs_with(&self, limit: &SharedTolerance, angles: u32) -> Result<bool, KinematicsError> {
        // A slot that is off its place turns the arcs with it.
        let motion = RingMotion::Turned(self.mouth_radius * limit.direction);
        for error in [-self.play.bore - limit.nearer, self.play.bore + limit.farther] {
            for sense in [-1.0, 1.0] {
                let wrong = self.with_errors(limit, sense);
                for side in [-1.0, 1.0] {
                    let askew = side * (limit.crank / wrong.segment_radii[0] + self.play.pin / self.crank_radius);
                    match wrong.is_clear(self.centre_distance + error, askew, motion, angles) {
                        Ok(true) => {}
                        Ok(false) | Err(KinematicsError::CentreDistance { .. }) => return Ok(false),
                        Err(error) => return Err(error),
                    }
                }
            }
        }
        Ok(true)
    }

    /// Whether nothing touches over a whole turn with the axes at this distance, the segment's middle off the line through axis and pin
    /// by an angle in radians, and the ring turned and pushed aside; lengths in millimetres. At most so many crank angles are looked at.
    ///
    /// # Errors
    ///
    /// [`KinematicsError`] for axes at an impossible distance, and where more angles are needed.
    pub(crate) fn is_clear(
        &self,
        centre_distance: f64,
        segment_error: f64,
        motion: RingMotion,
        angles: u32,
    ) -> Result<bool, KinematicsError> {
        let [outer, inner] = self.segment_radii;
        let is_ring = self.slot_width > 0.0 && self.slot_end > self.wheel_radius && self.locking_arc_radius > 0.0;
        if !(is_ring && outer > inner && inner > 0.0) {
            return Ok(false);
        }
        let assembly = InternalAssembly::new(self, centre_distance, segment_error)?;
        let found = assembly.least_clearance(angles, Some(motion))?;
        Ok(found.distance >= found.tolerance)
    }

    /// The sizes with all errors at these limits but those of the axes, of the slot's direction and of the segment's place, the
    /// crank longer or shorter by its sense of 1 or −1.
    fn with_errors(&self, limit: &SharedTolerance, sense: f64) -> Self {
        let mut wrong = *self;
        wrong.segment_radii[0] += limit.locking;
        make_wrong!(wrong, limit, sense);
        wrong.slot_end -= limit.slot_end;
        wrong.mouth_radius = libm::hypot(self.wheel_radius, wrong.slot_width / 2.0);
        wrong
    }
}

/// How a ring moves that is not as its sizes alone would have it.
#[derive(Clone, Copy, Debug)]
pub(crate) enum RingMotion {
    /// It is turned out of the place that the pin would give it, by up to this at its inner rim, in millimetres, as long as the pin is in
    /// a slot.
    Turned(f64),
    /// It meets a pin that would come in beside the middle of a slot.
    Met(MetPin),
}

/// How a ring meets a pin that comes in beside the middle of a slot.
///
/// Because the slot is off its direction: the ring stands as the arc before the slot has it, and the deeper the pin is, the more it turns,
/// so that the pin stays as far beside the middle. Because axes or crank are off: by a share of that the ring is pushed aside in the dwell,
/// and the rest, with which the pin comes in beside the middle, has faded at mid-index. All is likewise as the pin leaves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MetPin {
    /// How far slots are off their directions at most, from those of the arcs beside them, in millimetres at the ring's inner rim.
    pub off: f64,
    /// The share by which the ring is pushed to where the pin comes in, from 0 to 1, dimensionless.
    pub pushed: f64,
}

/// Ring and driver with their axes apart, in millimetres and radians.
struct InternalAssembly<'a> {
    sizes: &'a InternalSizes,
    distance: f64,
    /// By how much the segment's middle is off the line through axis and pin, in radians.
    askew: f64,
    half_pitch: f64,
    engaged: f64,
    /// Corner of a slot and tip of a horn, each with its mirror image, in the frame of a slot.
    corners: [Point; 4],
    /// Middle of the locking arc beside the slot.
    arc: Point,
    /// Half the angle of a locking arc, seen from its centre.
    arc_half: f64,
}

impl<'a> InternalAssembly<'a> {
    fn new(sizes: &'a InternalSizes, distance: f64, askew: f64) -> Result<Self, KinematicsError> {
        if !(distance > sizes.crank_radius && distance.is_finite()) {
            return Err(KinematicsError::CentreDistance { asked: distance, crank_radius: sizes.crank_radius });
        }
        let half_pitch = sizes.wheel.half_pitch_angle();
        let [seen, arc_half] = sizes.locking_ends();
        let half = sizes.slot_width / 2.0;
        let tip = direction(half_pitch - seen) * sizes.mouth_radius;
        let corner = Point::new(sizes.wheel_radius, half);
        let below = |p: Point| Point::new(p.x, -p.y);
        Ok(Self {
            sizes,
            distance,
            askew,
            half_pitch,
            engaged: sizes.wheel.engagement_half_angle(),
            corners: [corner, tip, below(corner), below(tip)],
            arc: direction(half_pitch) * sizes.centre_distance,
            arc_half,
        })
    }

    fn tolerance(&self) -> f64 {
        let gaps = [self.sizes.slot_gap(), self.sizes.locking_gap()].into_iter().filter(|gap| *gap > 0.0);
        (OF_GAP * gaps.fold(f64::INFINITY, f64::min)).min(TOLERANCE * self.sizes.centre_distance)
    }

    /// The least of all distances, of the segment during the engagement less what it moves in the ring as that is turned. Where the ring
    /// is turned, one that is greater than nothing need not be known better.
    fn least_clearance(&self, angles: u32, motion: Option<RingMotion>) -> Result<InternalClearance, KinematicsError> {
        let (sizes, tolerance) = (self.sizes, self.tolerance());
        let at = |value, place| Minimum { value, place };
        let deepest = self.ring_distance(Point::new(self.distance + sizes.crank_radius, 0.0)) - sizes.pin_radius();
        let rim = sizes.mouth_radius;
        let entering = self.pin(self.engaged);
        let beside_slot = libm::atan2(entering.y, entering.x) - self.half_pitch;
        let MetPin { off: slot_off, pushed } = match motion {
            Some(RingMotion::Met(met)) => met,
            _ => MetPin { off: 0.0, pushed: 0.0 },
        };
        let is_met = matches!(motion, Some(RingMotion::Met(_)));
        // What the ring is pushed to meet the pin, and what is left of it.
        let [aside, left] = if is_met { [pushed, 1.0 - pushed].map(|share| share * beside_slot) } else { [0.0; 2] };
        let beside = (sizes.slot_width - sizes.pin_diameter) / 2.0 - left.abs() * rim;
        // The segment turns in its arc, which goes on as a circle within the hollow; off its centre it is nearer by as much.
        let off = (direction(aside) * sizes.centre_distance - Point::new(self.distance, 0.0)).norm();
        let locked = sizes.locking_arc_radius - sizes.segment_radii[0] - off;
        let still = [at(beside, 0.0), at(locked, PI)];
        let least = still.into_iter().fold(at(deepest, 0.0), |a, b| if b.value < a.value { b } else { a });

        let places = Cell::new(angles);
        let search = Search { tolerance, enough: if motion.is_some() { 0.0 } else { f64::INFINITY }, places: &places };
        let (sine, cosine) = libm::sincos(self.half_pitch + aside);
        let at_rest = |theta: f64| {
            let p = self.pin(theta);
            self.ring_distance(Point::new(p.x * cosine + p.y * sine, p.y * cosine - p.x * sine)) - sizes.pin_radius()
        };
        let found = search.minimize(self.engaged, PI, Some(least), at_rest, |_, _| sizes.crank_radius);
        let ratio = sizes.crank_radius / self.distance;
        let outer = sizes.segment_radii[0];
        // The velocity ratio is greatest at mid-index, where it is m/(1 + m).
        let rate = outer + ratio / (1.0 + ratio) * (self.distance + outer);
        // How fast the pin's depth changes over the rim, and so what the ring is turned for it.
        let deeper = sizes.crank_radius / rim;
        let far = self.distance + outer;
        let rate =
            rate + slot_off / rim * (deeper * far + 2.0 * outer) + left.abs() * (deeper + 1.0 / self.engaged) * far;
        let parts: &[(f64, f64)] = if is_met { &[(-1.0, -HALF), (-HALF, HALF), (HALF, 1.0)] } else { &[(-1.0, 1.0)] };
        let found = parts.iter().fold(found, |found, &(from, to)| {
            // Without an error of its place, the segment is its own mirror image.
            let from = if self.askew == 0.0 { f64::max(from, 0.0) } else { from };
            if to <= from {
                return found;
            }
            let is_inmost = to == HALF;
            let engaged = |theta: f64| {
                self.closest_at(theta, left) - motion.map_or(0.0, |motion| self.lost_at(theta, motion, is_inmost))
            };
            search.minimize(from * self.engaged, to * self.engaged, Some(found), engaged, |_, _| rate)
        });
        if places.get() == 0 {
            return Err(KinematicsError::TooManyAngles { limit: angles });
        }
        Ok(InternalClearance { distance: found.value, crank_angle: found.place, tolerance })
    }

    /// How far points of the segment move in the ring at most as that is turned, at a crank angle of the engagement, in millimetres. About
    /// mid-index the segment is between two arcs, each of which may be off by as much from the slot, and else near one alone.
    fn lost_at(&self, theta: f64, motion: RingMotion, is_inmost: bool) -> f64 {
        match motion {
            RingMotion::Turned(lost) => lost,
            RingMotion::Met(MetPin { off, .. }) => {
                let rim = self.sizes.mouth_radius;
                let beside = (rim / self.pin(theta).norm()).min(1.0);
                let turned = if is_inmost { 1.0 + beside } else { 1.0 - beside };
                // Of the segment, the end is farthest from the wheel's axis that is nearest to the line of centres beyond the driver's.
                let aim = (self.engaged - theta.abs() - self.askew.abs()).max(0.0);
                let far = |radius: f64| (direction(aim) * radius + Point::new(self.distance, 0.0)).norm();
                off / rim * turned * self.sizes.segment_radii.map(far).into_iter().fold(0.0, f64::max)
            }
        }
    }

    /// The pin's centre from the wheel's axis.
    fn pin(&self, theta: f64) -> Point {
        direction(theta) * self.sizes.crank_radius + Point::new(self.distance, 0.0)
    }

    /// The distance of a point of the hollow from the ring, below zero for a point in the ring; the wheel is turned so that a slot
    /// is on the first axis.
    fn ring_distance(&self, p: Point) -> f64 {
        let sizes = self.sizes;
        let (pitch, angle) = (2.0 * self.half_pitch, libm::atan2(p.y, p.x));
        let beside = (angle - pitch * libm::round(angle / pitch)).abs();
        let (p, far) = (direction(beside) * p.norm(), p.norm());
        let half = sizes.slot_width / 2.0;
        let [corner, tip, ..] = self.corners;
        // Wall and round end of the slot.
        let along = p.x.clamp(corner.x, sizes.slot_end);
        let wall = (p - Point::new(along, half)).norm();
        let end = p - Point::new(sizes.slot_end, 0.0);
        let bottom = if end.x >= 0.0 { (end.norm() - half).abs() } else { f64::INFINITY };
        // Rim between the slot's corner and the horn's tip.
        let on_rim = (libm::atan2(corner.y, corner.x)..=libm::atan2(tip.y, tip.x)).contains(&beside);
        let rim = if on_rim { (far - sizes.mouth_radius).abs() } else { f64::INFINITY };
        // Locking arc.
        let from_arc = p - self.arc;
        let away = libm::atan2(from_arc.perp(&self.arc), from_arc.dot(&self.arc)).abs();
        let arc =
            if away <= self.arc_half { (from_arc.norm() - sizes.locking_arc_radius).abs() } else { (p - tip).norm() };
        let in_slot = p.y < half && (p.x <= sizes.slot_end || end.norm() < half);
        let is_free = far < sizes.mouth_radius || in_slot || from_arc.norm() < sizes.locking_arc_radius;
        let least = wall.min(bottom).min(rim).min(arc);
        if is_free { least } else { -least }
    }

    /// The distance of a point from the locking segment, below zero for a point in it; the pin is on the first axis.
    fn segment_distance(&self, p: Point) -> f64 {
        let [outer, inner] = self.sizes.segment_radii;
        let half = self.sizes.segment_half_angle();
        // From the segment's middle, opposite to the pin, as if that were on the first axis.
        let beside = libm::atan2(p.y, p.x) - PI - self.askew;
        let beside = (beside - 2.0 * PI * libm::round(beside / (2.0 * PI))).abs();
        let far = p.norm();
        let across = (far - outer).max(inner - far);
        let from_end = direction(beside - half) * far;
        if beside <= half {
            return if across > 0.0 { across } else { across.max(from_end.y) };
        }
        (from_end - Point::new(from_end.x.clamp(inner, outer), 0.0)).norm()
    }

    /// The distance of the locking segment from the ring at a crank angle of the engagement, if the pin came in beside the middle of its
    /// slot by an angle `left`.
    fn closest_at(&self, theta: f64, left: f64) -> f64 {
        let sizes = self.sizes;
        let ([outer, inner], half) = (sizes.segment_radii, sizes.segment_half_angle());
        let pin = self.pin(theta);
        let beside = left * theta / self.engaged * sizes.mouth_radius / pin.norm();
        let along = direction(libm::atan2(pin.y, pin.x) - beside);
        let axis = Point::new(self.distance, 0.0);
        // From the page to the wheel, whose slot is at the pin.
        let on_wheel = |p: Point| Point::new(p.dot(&along), along.perp(&p));
        let on_page = |p: Point| along * p.x + Point::new(-along.y, along.x) * p.y;
        let middle = theta + PI + self.askew;
        let mut least = f64::INFINITY;
        for radius in [outer, inner] {
            for angle in [middle - half, middle + half] {
                least = least.min(self.ring_distance(on_wheel(axis + direction(angle) * radius)));
            }
        }
        // Where the outer arc is farthest from the centre of a hollow arc.
        let mut farthest = |centre: Point| {
            let away = axis - centre;
            let aim = libm::atan2(away.y, away.x) - middle;
            let is_on = (aim - 2.0 * PI * libm::round(aim / (2.0 * PI))).abs() <= half;
            if is_on && away.norm() > 0.0 {
                least = least.min(self.ring_distance(on_wheel(axis + away.normalize() * outer)));
            }
        };
        farthest(Point::zeros());
        let pitch = 2.0 * self.half_pitch;
        let nearest = -libm::round(libm::atan2(along.y, along.x) / pitch);
        let turned = |p: Point, k: i32| {
            let by = direction(pitch * (nearest + f64::from(k)));
            Point::new(by.x * p.x - by.y * p.y, by.y * p.x + by.x * p.y)
        };
        (-NEAR..NEAR).for_each(|k| farthest(on_page(turned(self.arc, k))));
        let to_driver = |p: Point| {
            let (from_axis, by) = (on_page(p) - axis, direction(theta));
            Point::new(from_axis.dot(&by), by.perp(&from_axis))
        };
        for k in -NEAR..=NEAR {
            for corner in self.corners {
                least = least.min(self.segment_distance(to_driver(turned(corner, k))));
            }
        }
        least
    }
}

/// The unit vector at an angle in radians.
fn direction(angle: f64) -> Point {
    let (sine, cosine) = libm::sincos(angle);
    Point::new(cosine, sine)
}
