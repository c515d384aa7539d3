//! How near driver and wheel come to each other over a whole turn.
//!
//! At one instant distances are exact: of a point from a part by [`regions`](super::regions), of two parts by the points
//! where arcs and lines can come nearest, which are their ends and the points on the lines of centres of two arcs.
//!
//! Over the turn nothing is sampled away. A distance changes no faster than its two ends move: as the crank turns by dθ,
//! a point x of the driver by |x − B| dθ and a point y of the wheel by |φ'| |y − O| dθ, with B the driver's axis and O the
//! wheel's. So within an interval of crank angles the distance is at least that at its middle less half the interval times
//! the greatest of these speeds, of the outermost points. The ratio |φ'| falls from the line of centres to the ends of the
//! engagement, so its bound is its value at the nearer end. Intervals are halved until none can hold a distance below the
//! least that was found, less the tolerance.
//!
//! Two long stretches of constant distance need no search: the pin in its slot stays in the slot's middle, so only its
//! distance from the slot's end changes; and while the wheel stands, the locking disc turns in itself.
//!
//! With both parts rigid, the wheel is turned so that the pin is in the middle of its slot, and stands still between. How
//! far play lets it turn besides is another question ([`play`](super::play), [`dwell_play`](super::dwell_play)).

use super::mouth::Mouth;
use super::regions::{DiscRegion, WheelRegion};
use super::search::{Minimum, Search, greatest_speed_ratio};
use super::sizes::Sizes;
use crate::KinematicsError;
use crate::indexing::Indexing;
use nalgebra::Vector2;
use std::cell::Cell;
use std::f64::consts::PI;

type Point = Vector2<f64>;

/// Which parts come near each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactPair {
    /// A pin and the slot that it is in.
    PinInSlot,
    /// A pin and the wheel, while the pin is in no slot.
    PinOutside,
    /// The locking disc and the locking arc that it is in, while the wheel stands.
    LockingDisc,
    /// The locking disc with its crescents and the wheel, while the wheel turns.
    Crescent,
}

/// A least distance, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestApproach {
    /// The distance in millimetres. Below zero it is how deep the parts are in each other, by the deepest of their corners
    /// and of the points of arcs on lines of centres; where they overlap by more than a corner, they may be deeper still.
    pub distance: f64,
    /// Crank angle from the line of centres at which it is reached, in radians. The same holds at its negative, and
    /// for each pin.
    pub crank_angle: f64,
    /// Between which parts.
    pub contact: ContactPair,
}

/// The least distances of driver and wheel over a whole turn of the driver.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
/// let clearance = sizes.clearance();
/// assert!((clearance.pin_in_slot.distance - 0.1).abs() < 1e-12); // mm: half of the play on either side
/// assert!(clearance.closest_approach().distance > clearance.tolerance); // nothing touches anything over the whole turn
/// let near = sizes.clearance_at(sizes.centre_distance - 10.0)?; // with the axes 10 mm too near
/// assert!(near.closest_approach().distance < 0.0); // the parts would overlap
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// Least distance of a pin from the slot that it is in.
    pub pin_in_slot: ClosestApproach,
    /// Least distance of a pin in no slot from the wheel; none where every pin is always in a slot.
    pub pin_outside: Option<ClosestApproach>,
    /// Least distance of the locking disc from the arc that it is in; none without a disc.
    pub locking_disc: Option<ClosestApproach>,
    /// Least distance of the locking disc from the wheel during the engagement; none without a disc.
    pub crescent: Option<ClosestApproach>,
    /// How much less, in millimetres, any of these distances may be somewhere than is said here.
    pub tolerance: f64,
}

impl Clearance {
    /// The least of all distances, and where it is.
    pub fn closest_approach(&self) -> ClosestApproach {
        let others = [self.pin_outside, self.locking_disc, self.crescent];
        others.into_iter().flatten().fold(self.pin_in_slot, ClosestApproach::or)
    }
}

impl ClosestApproach {
    /// The nearer of two, the first of equals.
    fn or(self, other: Self) -> Self {
        if other.distance < self.distance { other } else { self }
    }
}

/// The tolerance over the centre distance, dimensionless, unless the play is small.
pub const TOLERANCE: f64 = 2e-6;
/// The tolerance over the lesser gap of slot and locking arc where that makes it finer, and how fine it gets at most over the
/// centre distance, dimensionless.
const OF_GAP: f64 = 0.01;
const FINEST: f64 = 1e-10;
/// The greatest distance of the axes that is looked at, over the right one.
const FARTHEST: f64 = 10.0;

impl Sizes {
    /// The least distances of driver and wheel over a whole turn, the parts as sized. The tolerance is [`TOLERANCE`]
    /// times the centre distance, or a hundredth of the lesser gap of slot and locking arc if that is less.
    pub fn clearance(&self) -> Clearance {
        Assembly::new(self, self.centre_distance).clearance()
    }

    /// The least distances of driver and wheel over a whole turn with the axes at another distance, in millimetres. The
    /// tolerance is that of [`clearance`](Self::clearance).
    ///
    /// # Errors
    ///
    /// [`KinematicsError::CentreDistance`] for a distance that is not finite and greater than the crank radius,
    /// [`KinematicsError::TooFarApart`] for more than ten times the right one.
    pub fn clearance_at(&self, centre_distance: f64) -> Result<Clearance, KinematicsError> {
        Ok(self.assembly_at(centre_distance)?.clearance())
    }

    /// The least distance of all over a whole turn with the axes at another distance, in millimetres, and its tolerance, as exactly
    /// as so many crank angles allow. That is found sooner than the least distance of each pair of parts: the pair that is nearest
    /// saves looking at the others. The tolerance is that of [`clearance_at`](Self::clearance_at), or 16 or 256 times as wide.
    ///
    /// # Errors
    ///
    /// The errors of [`clearance_at`](Self::clearance_at), and [`KinematicsError::TooManyAngles`] where the distances stay so
    /// nearly the same over the turn that even the widest tolerance needs more crank angles.
    pub fn least_clearance_within(
        &self,
        centre_distance: f64,
        angles: u32,
    ) -> Result<(ClosestApproach, f64), KinematicsError> {
        let wider = |times: f64| {
            let assembly = self.assembly_at(centre_distance)?;
            let tolerance = times * assembly.tolerance;
            Ok((Assembly { tolerance, ..assembly }.closest_approach_within(angles, f64::INFINITY)?, tolerance))
        };
        wider(1.0).or_else(|_| wider(16.0)).or_else(|_| wider(256.0))
    }

    /// The centre distances in millimetres between which the parts are looked at: the first is too near, the second near enough.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices::default())?;
    /// let [near, far] = sizes.centre_distances_looked_at(); // mm
    /// assert!(sizes.clearance_at(near).is_err() && sizes.clearance_at(far).is_ok());
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn centre_distances_looked_at(&self) -> [f64; 2] {
        [self.crank_radius, FARTHEST * self.centre_distance]
    }

    pub(super) fn assembly_at(&self, centre_distance: f64) -> Result<Assembly<'_>, KinematicsError> {
        let [crank_radius, most] = self.centre_distances_looked_at();
        if !(centre_distance > crank_radius && centre_distance.is_finite()) {
            return Err(KinematicsError::CentreDistance { asked: centre_distance, crank_radius });
        }
        if centre_distance > most {
            return Err(KinematicsError::TooFarApart { asked: centre_distance, most });
        }
        Ok(Assembly::new(self, centre_distance))
    }
}

/// Wheel and driver with their axes apart, in millimetres and radians.
pub(super) struct Assembly<'a> {
    sizes: &'a Sizes,
    distance: f64,
    wheel: WheelRegion,
    disc: Option<DiscRegion>,
    /// By how much the disc is turned against the first pin.
    disc_turn: f64,
    /// Half the angle between pins, half of the engagement, half the angle between slots.
    half_turn: f64,
    engaged: f64,
    half_pitch: f64,
    /// Of the slots near the driver.
    corners: Vec<Point>,
    locking_centres: Vec<Point>,
    edges: Vec<Point>,
    cuts: Vec<Point>,
    /// How much less than what is found a distance may be somewhere, in millimetres.
    pub tolerance: f64,
    /// A distance in millimetres that is enough: where no lesser one is possible, nothing is looked for.
    enough: f64,
    /// Crank angles that may still be looked at.
    angles: Cell<u32>,
}

/// The tolerance in millimetres: without any gap to compare it with, the usual one.
fn tolerance(sizes: &Sizes) -> f64 {
    let gaps = [Some(sizes.slot_gap()), sizes.locking_gap()].into_iter().flatten().filter(|gap| *gap > 0.0);
    let fine = (OF_GAP * gaps.fold(f64::INFINITY, f64::min)).max(FINEST * sizes.centre_distance);
    fine.min(TOLERANCE * sizes.centre_distance)
}

/// The slots within two pitches of the line of centres; others are farther from it than any part of the driver.
fn slots_near(stations: u32) -> std::ops::RangeInclusive<i32> {
    match stations {
        3 => -1..=1,
        4 => -1..=2,
        _ => -2..=2,
    }
}

impl<'a> Assembly<'a> {
    fn new(sizes: &'a Sizes, distance: f64) -> Self {
        let (wheel, disc) = (WheelRegion::new(sizes), DiscRegion::new(sizes));
        let (corners, locking_centres): (Vec<_>, Vec<_>) =
            slots_near(sizes.wheel.stations()).map(|k| wheel.sector(k)).unzip();
        let (edges, cuts) = disc.as_ref().map(|disc| (disc.edges(), disc.cuts())).unwrap_or_default();
        Self {
            sizes,
            distance,
            wheel,
            disc,
            disc_turn: 0.0,
            half_turn: PI / f64::from(sizes.wheel.pins()),
            engaged: sizes.wheel.engagement_half_angle(),
            half_pitch: sizes.wheel.half_pitch_angle(),
            corners: corners.into_iter().flatten().collect(),
            locking_centres,
            edges,
            cuts,
            tolerance: tolerance(sizes),
            enough: f64::INFINITY,
            angles: Cell::new(u32::MAX),
        }
    }

    /// Wheel and driver with the disc turned by an angle in radians against the first pin, which is an error of either one's place.
    /// Distances are then those past mid-index; before it they are those of a disc that is turned the other way.
    pub(super) fn with_disc_turn(self, disc_turn: f64) -> Self {
        Self { disc_turn, ..self }
    }

    /// The least of all distances from so many crank angles at most, where a distance of `enough` millimetres need not be known better.
    pub(super) fn closest_approach_within(self, angles: u32, enough: f64) -> Result<ClosestApproach, KinematicsError> {
        let limited = Self { enough, angles: Cell::new(angles), ..self };
        let found = limited.closest_approach();
        if limited.angles.get() == 0 { Err(KinematicsError::TooManyAngles { limit: angles }) } else { Ok(found) }
    }

    /// The least distance of the pairs that are looked for over the turn, which are all but a pin in its slot and the disc at rest, as by
    /// [`closest_approach_within`](Self::closest_approach_within); none of a wheel that has no such pair.
    pub(super) fn searched_approach_within(
        self,
        angles: u32,
        enough: f64,
    ) -> Result<Option<ClosestApproach>, KinematicsError> {
        let limited = Self { enough, angles: Cell::new(angles), ..self };
        let pins = limited.pins_outside(None);
        let found = limited.disc.as_ref().map_or(pins, |disc| Some(limited.crescent(disc, pins)));
        if limited.angles.get() == 0 { Err(KinematicsError::TooManyAngles { limit: angles }) } else { Ok(found) }
    }

    fn clearance(&self) -> Clearance {
        Clearance {
            pin_in_slot: self.pin_in_slot(),
            pin_outside: self.pins_outside(None),
            locking_disc: self.locking_disc(),
            crescent: self.disc.as_ref().map(|disc| self.crescent(disc, None)),
            tolerance: self.tolerance,
        }
    }

    /// The least of all distances.
    pub(super) fn closest_approach(&self) -> ClosestApproach {
        let known = self.locking_disc().map_or(self.pin_in_slot(), |disc| self.pin_in_slot().or(disc));
        let known = self.pins_outside(Some(known)).map_or(known, |pins| known.or(pins));
        self.disc.as_ref().map_or(known, |disc| known.or(self.crescent(disc, Some(known))))
    }

    /// The crank angles, in radians, of the indexing or of the dwell, whichever has this one, and whether it is the dwell.
    pub(super) fn phase(&self, theta: f64) -> (f64, f64, bool) {
        let is_at_rest = theta >= self.engaged && self.half_turn > self.engaged;
        let (from, to) =
            if is_at_rest { (self.engaged, self.half_turn) } else { (0.0, self.engaged.min(self.half_turn)) };
        (from, to, is_at_rest)
    }

    /// The distance of these two parts at this crank angle in radians, in millimetres, as the search for the least one sees it.
    pub(super) fn distance_at(&self, contact: ContactPair, theta: f64, is_at_rest: bool) -> f64 {
        let pins = self.sizes.pin_directions().skip(1).chain(is_at_rest.then_some(0.0));
        match (contact, &self.disc) {
            (ContactPair::PinInSlot, _) => self.pin_in_slot().distance,
            (ContactPair::PinOutside, _) => {
                pins.map(|pin| self.pin_distance(pin, theta, is_at_rest, None)).fold(f64::INFINITY, f64::min)
            }
            (ContactPair::LockingDisc, _) => self.locking_disc().map_or(f64::INFINITY, |disc| disc.distance),
            (ContactPair::Crescent, disc) => {
                disc.as_ref().map_or(f64::INFINITY, |disc| self.disc_distance(disc, theta))
            }
        }
    }

    /// The pin is on the slot's middle line all the time and nearest to the slot's end on the line of centres.
    fn pin_in_slot(&self) -> ClosestApproach {
        let deepest = Point::new(self.distance - self.sizes.crank_radius, 0.0);
        let distance = self.wheel.distance(&deepest) - self.sizes.pin_radius();
        ClosestApproach { distance, crank_angle: 0.0, contact: ContactPair::PinInSlot }
    }

    fn locking_disc(&self) -> Option<ClosestApproach> {
        self.disc.as_ref().map(|disc| ClosestApproach {
            distance: self.wheel.distance(&self.driver_axis_at_rest()) - disc.radius,
            crank_angle: self.half_turn,
            contact: ContactPair::LockingDisc,
        })
    }

    /// The least distance of all pins while they are in no slot, or what is known to be less.
    fn pins_outside(&self, known: Option<ClosestApproach>) -> Option<ClosestApproach> {
        let at_rest = self.half_turn > self.engaged * (1.0 + 1e-12);
        let end = self.engaged.min(self.half_turn);
        let resting = if at_rest { Some(self.pin_outside(0.0, end, self.half_turn, known)) } else { known };
        self.sizes.pin_directions().skip(1).fold(resting, |known, pin| {
            let indexing = self.pin_outside(pin, 0.0, end, known);
            Some(if at_rest { self.pin_outside(pin, end, self.half_turn, Some(indexing)) } else { indexing })
        })
    }

    /// The driver's axis from the wheel while it stands, half a pitch past the slot that the pin left.
    fn driver_axis_at_rest(&self) -> Point {
        Point::new(libm::cos(self.half_pitch), -libm::sin(self.half_pitch)) * self.distance
    }

    /// Sine and cosine of the wheel's angle: that of the pin's direction while it is in the slot.
    fn wheel_turn(&self, theta: f64) -> (f64, f64) {
        if theta > self.engaged {
            return libm::sincos(self.half_pitch);
        }
        let (sin, cos) = libm::sincos(theta);
        let (x, y) = (self.distance - self.sizes.crank_radius * cos, self.sizes.crank_radius * sin);
        let r = (x * x + y * y).sqrt();
        (y / r, x / r)
    }

    /// The greatest speed ratio of the wheel between two crank angles, the first the smaller, none below zero.
    fn speed_ratio(&self, from: f64, to: f64) -> f64 {
        if from >= self.engaged {
            return 0.0;
        }
        greatest_speed_ratio(self.distance / self.sizes.crank_radius, from, to)
    }

    /// The least distance of a pin in no slot, so far ahead of the first, between two crank angles of the first.
    fn pin_outside(&self, ahead: f64, from: f64, to: f64, known: Option<ClosestApproach>) -> ClosestApproach {
        // An interval of the dwell begins as the pin leaves its slot: there the wheel has come to rest.
        let distance = |theta: f64| self.pin_distance(ahead, theta, from >= self.engaged, known);
        let speed = |from: f64, to: f64| self.sizes.crank_radius + self.speed_ratio(from, to) * self.wheel.rim;
        self.search(ContactPair::PinOutside, from, to, known, distance, speed)
    }

    /// The distance of a pin in no slot, or a lesser one where it is farther away than what is known.
    fn pin_distance(&self, ahead: f64, theta: f64, is_at_rest: bool, known: Option<ClosestApproach>) -> f64 {
        let (a, rho) = (self.sizes.crank_radius, self.sizes.pin_radius());
        let (sin, cos) = libm::sincos(theta + ahead);
        let (x, y) = (self.distance - a * cos, a * sin);
        let outside = (x * x + y * y).sqrt() - self.wheel.rim - rho;
        if known.is_some_and(|known| outside > known.distance) {
            return outside;
        }
        let (s, c) = if is_at_rest { libm::sincos(self.half_pitch) } else { self.wheel_turn(theta) };
        self.wheel.distance(&Point::new(x * c + y * s, y * c - x * s)) - rho
    }

    /// The least distance of the locking disc from the wheel during the engagement, or what is known to be less.
    fn crescent(&self, disc: &DiscRegion, known: Option<ClosestApproach>) -> ClosestApproach {
        let distance = |theta: f64| self.disc_distance(disc, theta);
        let speed = |from: f64, to: f64| disc.radius + self.speed_ratio(from, to) * self.wheel.rim;
        self.search(ContactPair::Crescent, 0.0, self.engaged, known, distance, speed)
    }

    /// The distance of the locking disc from the wheel at one crank angle.
    fn disc_distance(&self, disc: &DiscRegion, theta: f64) -> f64 {
        let (sin, cos) = libm::sincos(theta + self.disc_turn);
        let (s, c) = self.wheel_turn(theta);
        // From the driver's plane to the wheel's and back: the driver is turned by π − θ, the wheel by φ.
        let on_page = |p: &Point| Point::new(self.distance - p.x * cos - p.y * sin, p.x * sin - p.y * cos);
        let on_wheel = |p: &Point| {
            let p = on_page(p);
            Point::new(p.x * c + p.y * s, p.y * c - p.x * s)
        };
        let on_driver = |p: &Point| {
            let (x, y) = (p.x * c - p.y * s - self.distance, p.x * s + p.y * c);
            Point::new(y * sin - x * cos, -x * sin - y * cos)
        };
        let mut least = f64::INFINITY;
        for edge in self.edges.iter().map(on_wheel) {
            if edge.norm() - self.wheel.rim < least {
                least = least.min(self.wheel.distance(&edge));
            }
        }
        let mut near = |p: &Point| {
            let p = on_driver(p);
            let reach = disc.radius + least;
            if reach > 0.0 && p.norm_squared() < reach * reach {
                least = least.min(disc.distance(&p));
            }
        };
        self.corners.iter().for_each(&mut near);
        // Points of the locking arcs on the lines of centres with the disc and with its cuts, and of the rim on the line
        // of the axes.
        let axis = Point::new(self.distance * c, -self.distance * s);
        let radius = self.wheel.locking_radius();
        for centre in &self.locking_centres {
            let mut on_arc = |direction: Point| {
                let length = direction.norm();
                let at = centre + direction * (radius / length);
                if length > 0.0 && at.norm_squared() <= self.wheel.rim * self.wheel.rim {
                    near(&at);
                }
            };
            on_arc(axis - centre);
            self.cuts.iter().for_each(|cut| on_arc(centre - on_wheel(cut)));
        }
        if self.sizes.mouth != Mouth::Sharp {
            let cuts: Vec<Point> = self.cuts.iter().map(on_wheel).collect();
            for k in slots_near(self.sizes.wheel.stations()) {
                self.wheel.on_mouth(k, &axis, &cuts).iter().for_each(&mut near);
            }
        }
        if self.wheel.has_rim_at(libm::atan2(s, c)) {
            near(&Point::new(self.wheel.rim * c, -self.wheel.rim * s));
        }
        least
    }

    /// The least value of a function of the crank angle that changes no faster than `speed` says between two angles; a value
    /// below the tolerance will do where `enough` is one, and any where no angles are left.
    fn search(
        &self,
        contact: ContactPair,
        from: f64,
        to: f64,
        known: Option<ClosestApproach>,
        distance: impl Fn(f64) -> f64,
        speed: impl Fn(f64, f64) -> f64,
    ) -> ClosestApproach {
        let search = Search { tolerance: self.tolerance, enough: self.enough, places: &self.angles };
        let known = known.map(|known| Minimum { value: known.distance, place: known.crank_angle });
        let Minimum { value, place } = search.minimize(from, to, known, distance, speed);
        ClosestApproach { distance: value, crank_angle: place, contact }
    }
}
