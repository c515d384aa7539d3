//! How far the wheel turns loosely while it dwells.
//!
//! Notation: `c` centre distance, `z` radius of the locking disc, β crank angle from the line of centres at which a pin
//! enters and leaves, τ crank angle still to go until the next pin enters, r a distance from the wheel's axis.
//!
//! The wheel can turn forwards (as it does in the index) until one of three things stops it:
//!
//! - **The disc.** Seen from the line of centres, the disc's circle reaches into the wheel up to the angle ψ at which it
//!   crosses the rim. On the side that stops the wheel forwards it is whole up to the angle τ, where the opening of the next
//!   pin begins. So the disc stops the wheel with its point at the lesser of ψ and τ: with the locking arc's tip while τ > ψ,
//!   with the edge of its opening later. A point of the disc at the angle τ is at r² = c² + z² − 2 c z cos τ from the wheel's
//!   axis, in the direction atan2(z sin τ, c − z cos τ); the locking arc of the radius A has there the half angle
//!   arccos((c² + r² − A²) / (2 c r)). Their difference is the play: about the gap over c sin τ, which grows as τ falls.
//! - **The pin that comes**, by the horn on its other side. A mouth that is not sharp leaves the wheel room there even after
//!   the pin has entered, until the pin no longer comes nearer to that side: the play is looked at up to there.
//! - **The pin that went**, by the wall that it pushed.
//!
//! Backwards it is the mirror image: the same at the crank angle as far past the pin's leaving.

use super::mouth::Mouth;
use super::sizes::Sizes;
use crate::bisection::try_bisect_times;
use crate::indexing::Indexing;

/// How far the wheel turns loosely in the dwell.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// let with_play = |play: f64| { // in mm
///     let choices = Choices { play: Some(Play::from_slot(play)), ..Choices::default() };
///     Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)
/// };
/// let loose = with_play(0.2)?.dwell_play().expect("one pin leaves a dwell");
/// assert!(0.0 < loose.middle && loose.middle <= loose.greatest); // rad to either side
/// let tight = with_play(0.0)?.dwell_play().expect("one pin leaves a dwell");
/// assert!(tight.middle < 1e-7); // rad: without play the wheel cannot turn
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DwellPlay {
    /// Angle to either side in the middle of the dwell, in radians.
    pub middle: f64,
    /// Part of the dwell, in its middle, in which the angle to either side is no greater than `middle`, dimensionless. Zero
    /// where an opening of the disc is within the locking arc all the time: then the play grows from the middle on.
    pub held: f64,
    /// Greatest angle to one side, in radians: forwards before a pin enters, backwards as long after one has left.
    pub greatest: f64,
    /// Crank angle that is still to go until the pin enters where the play forwards is greatest, in radians. Below zero, the
    /// pin is so far past its entry and in a mouth that is not sharp.
    pub until_entry: f64,
    /// Whether a wheel that has turned forwards so far can be out of the way of the pin: the pin then meets the rim beside
    /// the slot, and the machine jams or loses an index.
    pub can_miss: bool,
}

/// Halvings of the dwell in which the greatest play is looked for.
const STEPS: u32 = 80;

impl Sizes {
    /// How far the wheel turns loosely in the dwell. None without a locking disc; zero without play.
    ///
    /// Rigid parts, as sized, with their axes at the right distance and shafts without play in their bearings.
    pub fn dwell_play(&self) -> Option<DwellPlay> {
        let whole = self.dwell_angle()?;
        let (tip, middle) = (self.disc_reach()?, self.forward_play(whole / 2.0)?);
        // The play forwards grows with τ as far as the pin that comes is what limits it, and falls with τ elsewhere.
        let by_coming = |between: f64| {
            let others = self.disc_limit(between).ok_or(())?.min(self.leaving_limit(whole - between));
            Ok::<_, ()>(self.coming_limit(between) < others)
        };
        let first = -self.closing_mouth();
        let [low, high] = match by_coming(first).ok()? {
            true => try_bisect_times(STEPS, [first, whole], by_coming).ok()?,
            // So wide is the mouth that the disc is what limits the play until the pin no longer comes nearer to that side.
            false => [first, first],
        };
        let greatest = self.forward_play(high)?.max(self.forward_play(low)?);
        let outside = self.until_beside();
        let can_miss = outside < whole && self.disc_limit(outside)? >= self.corner_angle() + self.pin_place(outside).1;
        let held = if 2.0 * tip < whole { 1.0 - 2.0 * tip / whole } else { 0.0 };
        Some(DwellPlay { middle, held, greatest, until_entry: high, can_miss })
    }

    /// How far the wheel turns loosely forwards and backwards, in radians, at a crank angle in radians that is still to go
    /// until the next pin enters, from zero to the whole dwell. None without a locking disc and for other angles.
    pub fn dwell_play_at(&self, until_entry: f64) -> Option<[f64; 2]> {
        let whole = self.dwell_angle().filter(|whole| (0.0..=*whole).contains(&until_entry))?;
        Some([self.forward_play(until_entry)?, self.forward_play(whole - until_entry)?])
    }

    /// By what angle one slot may be off its place between the locking arcs, to either side, so that the pin still comes in
    /// and out, in radians: how far the whole disc lets the wheel turn, and the play of the pin in the mouth. None without a
    /// locking disc. Told as of sharp corners: another mouth leaves more room.
    pub fn slot_direction_tolerance(&self) -> Option<f64> {
        let in_mouth = libm::asin((self.slot_gap() / self.wheel_radius).min(1.0));
        Some(self.disc_limit(self.dwell_angle()?)?.max(0.0) + in_mouth)
    }

    /// By how much a crank may be too long, in millimetres, so that the pin still comes in and reaches its deepest place.
    /// Beyond that it sticks: on the wall that it does not push, as it enters, with the wheel turned back as far as the disc
    /// lets it; or on the slot's bottom. None without a locking disc. Told as of sharp corners: another mouth leaves more room.
    pub fn crank_radius_tolerance(&self) -> Option<f64> {
        let half = self.disc_limit(self.dwell_angle()?)?.max(0.0) / 2.0;
        let turned = self.wheel.half_pitch_angle() + half;
        // c (sin(α + δ) − sin α), in which nothing cancels.
        let given_way = 2.0 * self.centre_distance * libm::cos(turned) * libm::sin(half);
        Some((self.slot_gap() + given_way).min(self.bottom_gap()))
    }

    /// Angle by which the driver turns during one dwell, in radians. None without a locking disc.
    pub fn dwell_angle(&self) -> Option<f64> {
        let pins = f64::from(self.wheel.pins());
        self.locking_disc.map(|_| 2.0 * std::f64::consts::PI * self.wheel.dwell_fraction() / pins)
    }

    fn forward_play(&self, until_entry: f64) -> Option<f64> {
        let left = self.dwell_angle()? - until_entry;
        let pins = self.coming_limit(until_entry).min(self.leaving_limit(left));
        Some(self.disc_limit(until_entry)?.min(pins).max(0.0))
    }

    /// Angle at the driver's axis from the line of centres, in radians, at which the disc's circle crosses the rim. None without a
    /// locking disc.
    ///
    /// A wheel that is turned through its play in the middle of the dwell rests on the disc there, with the end of a locking arc.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
    /// let (reach, disc) = (sizes.disc_reach().expect("a disc"), sizes.locking_disc.expect("a disc"));
    /// let (x, y) = (sizes.centre_distance - disc.radius * reach.cos(), disc.radius * reach.sin()); // mm, from the wheel's axis
    /// assert!((x.hypot(y) - sizes.tip_radius).abs() < 1e-9); // mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn disc_reach(&self) -> Option<f64> {
        let (c, rim, z) = (self.centre_distance, self.tip_radius, self.locking_disc?.radius);
        // By half the angle: sin²(x/2) = (rim² − (c − z)²) / (4 c z).
        let square = (rim - (c - z)) * (rim + (c - z)) / (4.0 * c * z);
        Some(2.0 * libm::asin(square.max(0.0).sqrt().min(1.0)))
    }

    /// How far the disc lets the wheel turn forwards.
    fn disc_limit(&self, until_entry: f64) -> Option<f64> {
        let (c, arc, z) = (self.centre_distance, self.locking_arc_radius, self.locking_disc?.radius);
        let at = until_entry.min(self.disc_reach()?);
        let half = libm::sin(at / 2.0);
        let r = ((c - z) * (c - z) + 4.0 * c * z * half * half).sqrt();
        let square = (arc - (c - r)) * (arc + (c - r)) / (4.0 * c * r);
        let opening = 2.0 * libm::asin(square.max(0.0).sqrt().min(1.0));
        Some(opening - libm::atan2(z * libm::sin(at), c - z * libm::cos(at)))
    }

    /// Distance of a pin from the wheel's axis, in millimetres, and its angle beside the slot's middle, in radians, before it
    /// enters; after it has left, on the other side.
    fn pin_place(&self, away: f64) -> (f64, f64) {
        let half = libm::sin(away / 2.0);
        let (x, y) = (self.wheel_radius + self.crank_radius * libm::sin(away), self.crank_radius * 2.0 * half * half);
        (libm::hypot(x, y), libm::atan2(y, x))
    }

    /// Crank angle from entry, in radians, beyond which a pin passes the rim.
    fn until_beside(&self) -> f64 {
        let (a, c, reach) = (self.crank_radius, self.centre_distance, self.tip_radius + self.pin_radius());
        let sine = ((c - reach) * (c + reach) + a * a) / (2.0 * a * c);
        self.wheel.half_pitch_angle() - libm::asin(sine.clamp(-1.0, 1.0))
    }

    /// Crank angle past the entry, in radians, up to which the pin comes nearer to the side of the mouth that it does not
    /// push; zero for a sharp mouth, whose walls it runs along from the first.
    fn closing_mouth(&self) -> f64 {
        if self.mouth == Mouth::Sharp {
            return 0.0;
        }
        // The room falls towards the walls, and the pin moves away from that side ever faster.
        let [mut from, mut to] = [0.0, self.mouth_angle()];
        for _ in 0..STEPS {
            let third = (to - from) / 3.0;
            if self.coming_limit(-from - third) < self.coming_limit(third - to) { to -= third } else { from += third }
        }
        f64::midpoint(from, to)
    }

    /// Crank angle past the entry, in radians, at which the pin's centre comes to the ends of the slot's straight walls; zero
    /// if the mouth is sharp. Until there, and as long before the pin leaves, the wheel turns more loosely than between
    /// walls.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Mouth, Scale, Sizes, Wheel};
    ///
    /// let mouth = Mouth::LeadIn { length: 5.0, flare: 0.5 }; // mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices { mouth, ..Choices::default() })?;
    /// assert!((sizes.mouth_angle() - (5.0_f64 / 25.0).asin()).abs() < 1e-12); // rad
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn mouth_angle(&self) -> f64 {
        libm::asin((self.mouth_length() / self.crank_radius).clamp(0.0, 1.0))
    }

    /// The greatest angle from the slot's middle, in radians, of a pin's centre at this distance from the wheel's axis.
    pub(super) fn room_in_mouth(&self, r: f64) -> f64 {
        self.mouth_profile().room(r, self.pin_radius(), self.slot_gap())
    }

    /// How far the pin that comes lets the wheel turn forwards.
    fn coming_limit(&self, until_entry: f64) -> f64 {
        if until_entry >= self.until_beside() {
            return f64::INFINITY;
        }
        let (r, beside) = self.pin_place(until_entry);
        self.room_in_mouth(r) + beside
    }

    /// How far the pin that went lets the wheel turn forwards.
    fn leaving_limit(&self, since: f64) -> f64 {
        if since >= self.until_beside() {
            return f64::INFINITY;
        }
        let (r, beside) = self.pin_place(since);
        self.room_in_mouth(r) - beside
    }
}
