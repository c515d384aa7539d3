//! What play, and an error of the centre distance, do while a pin is in its slot or comes to it: how far the wheel turns
//! loosely, and with what blow the pin comes in.
//!
//! In the dwell the play is another: [`DwellPlay`](super::DwellPlay).

use super::sizes::Sizes;
use crate::KinematicsError;
use crate::bisection::bisect_times;
use crate::indexing::Indexing;
use nalgebra::Vector2;

type Point = Vector2<f64>;

/// Part of the wheel that the pin meets first as it comes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryContact {
    /// The wall that it then pushes.
    DrivingWall,
    /// The other wall: the wheel is pushed back, against the locking disc.
    OtherWall,
    /// A corner of the slot's mouth, or the rim beside it.
    Mouth,
    /// The face of a mouth that is not sharp: the chamfer, rounding or arc between wall and rim.
    MouthFace,
}

/// The first contact of a pin that comes to the wheel at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinEntry {
    /// Part of the wheel that the pin meets first.
    pub contact: EntryContact,
    /// Crank angle from the line of centres at which they meet, in radians.
    pub crank_angle: f64,
    /// Speed with which pin and wheel close in on each other, across their faces, over the pin's speed, dimensionless.
    pub closing_speed: f64,
    /// Whether it is on the side of the slot that the pin then pushes, be it wall, mouth or the rim beside it.
    pub is_driving_side: bool,
    /// Angle of the line across their faces from the line across the slot, in radians: zero on a wall, a right angle where the
    /// pin runs straight against the wheel.
    pub slant: f64,
    /// Angular velocity over the driver's that the wheel must take on at once, dimensionless; negative if backwards, which
    /// the locking disc does not allow.
    pub velocity_jump: f64,
}

/// Speeds with which pin and wheel close in on each other at entry, across their faces, over the pin's speed, dimensionless.
///
/// The axes are at the right distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Knock {
    /// With the wheel in the middle of its play, dimensionless.
    pub centred: f64,
    /// The greatest with the wheel anywhere within the play that it has in the middle of the dwell, dimensionless.
    pub within: f64,
    /// The greatest with the wheel anywhere in the play that it has near the end of the dwell, forwards as far as
    /// [`DwellPlay::greatest`](super::DwellPlay), dimensionless. With sharp mouths it is the blow on the corner of a horn in
    /// the pin's way.
    pub drifted: f64,
    /// The entry in the middle of the play, whose speed is `centred`.
    pub centred_entry: PinEntry,
    /// The entry whose speed is `drifted`, or nearly so.
    pub hardest_entry: PinEntry,
}

impl PinEntry {
    /// The one that closes in faster, the first of equals.
    fn harder(self, other: Self) -> Self {
        if other.closing_speed > self.closing_speed { other } else { self }
    }
}

/// Places of the wheel within its play at which the blow is looked at, and halvings of the interval in which is the farthest
/// place at which the pin still comes to the driving wall.
const PLACES: u32 = 64;
const HALVINGS: u32 = 50;

impl Sizes {
    /// Speed with which the pin knocks at its entry, by how far the wheel has turned within its play. None without a locking
    /// disc, and if the pin meets nothing of the wheel.
    ///
    /// While the pin comes to the driving wall, the blow grows with the way that it has across the slot; it is greatest where
    /// the pin just passes the other wall. Beyond that it meets the other corner, the harder the farther the wheel has turned.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm, a gap of 0.1 mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// let knock = sizes.knock().expect("the pin meets the wheel");
    /// let cosine: f64 = 1.0 - 0.1 / 50.0; // of the crank angle past entry at which the gap is closed
    /// assert!((knock.centred - (1.0 - cosine * cosine).sqrt()).abs() < 1e-12); // over the pin's speed
    /// assert!(knock.centred <= knock.within && knock.within <= knock.drifted);
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn knock(&self) -> Option<Knock> {
        let play = self.dwell_play()?;
        let entry = |drift: f64| self.drifted_entry(0.0, drift);
        let is_driven = |drift: f64| entry(drift).is_some_and(|entry| entry.is_driving_side);
        let centred = entry(0.0)?;
        let [low, _] = bisect_times(HALVINGS, [0.0, play.greatest], is_driven);
        let most = |from: f64, to: f64| {
            let at = |k: u32| entry(from + (to - from) * f64::from(k) / f64::from(PLACES));
            let passing = Some(low).filter(|low| (from..=to).contains(low)).and_then(entry);
            (0..=PLACES).filter_map(at).chain(passing).fold(centred, PinEntry::harder)
        };
        let within = most(-play.middle, play.middle);
        let hardest = within.harder(most(0.0, play.greatest));
        Some(Knock {
            centred: centred.closing_speed,
            within: within.closing_speed,
            drifted: hardest.closing_speed,
            centred_entry: centred,
            hardest_entry: hardest,
        })
    }

    /// Backlash of the wheel to either side before a wall of the slot meets the pin, at a crank angle of the
    /// engagement in radians; in radians.
    ///
    /// The gap over the pin's distance from the wheel's axis: between straight walls it is greatest on the line of centres.
    /// In a mouth that is not sharp there is more room.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm, a gap of 0.1 mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// // On the line of centres the pin is 100 mm − 50 mm from the wheel's axis.
    /// assert!((sizes.index_backlash(0.0)? - (0.1_f64 / 50.0).asin()).abs() < 1e-15); // rad
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] beyond the ends, and for what is not finite.
    pub fn index_backlash(&self, crank_angle: f64) -> Result<f64, KinematicsError> {
        self.wheel.engaged(crank_angle)?;
        let (a, c) = (self.crank_radius, self.centre_distance);
        let half = libm::sin(crank_angle / 2.0);
        // r² = (c − a)² + 4 a c sin²(θ/2).
        let r = ((c - a) * (c - a) + 4.0 * a * c * half * half).sqrt();
        Ok(self.room_in_mouth(r))
    }

    /// Entry of a pin into the wheel at rest if the axes are farther apart than they should be, in millimetres, or nearer
    /// (below zero). The wheel is in the middle of its play. `None` if the pin does not meet a slot, its mouth or the rim
    /// beside it.
    ///
    /// In the slot's own frame the pin's centre is at (c' cos α − a sin τ, c' sin α − a cos τ), τ the crank angle from the
    /// nominal entry. Each face is met at an angle τ in closed form; the first counts. Play alone makes a blow: a pin
    /// that is a gap g away from the wall meets it at cos τ = 1 − g/a.
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::{Choices, EntryContact, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm, a gap of 0.1 mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// let entry = sizes.entry(0.0).expect("the pin comes to its slot");
    /// assert_eq!(entry.contact, EntryContact::DrivingWall);
    /// let past_entry = entry.crank_angle + sizes.wheel.engagement_half_angle(); // rad
    /// assert!((past_entry.cos() - (1.0 - 0.1 / 50.0)).abs() < 1e-12);
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn entry(&self, centre_error: f64) -> Option<PinEntry> {
        self.drifted_entry(centre_error, 0.0)
    }

    /// Entry of a pin into a wheel that has turned forwards by an angle in radians from the middle of its play, or backwards
    /// (below zero), the axes by so many millimetres too far apart. `None` if the pin meets nothing of it.
    ///
    /// In the slot's frame the driver's axis is then at c (cos(α − δ), sin(α − δ)), and the crank angle counts from δ less.
    pub fn drifted_entry(&self, centre_error: f64, drift: f64) -> Option<PinEntry> {
        let (a, rho, gap) = (self.crank_radius, self.pin_radius(), self.slot_gap());
        let (sin, cos) = libm::sincos(self.wheel.half_pitch_angle());
        let (drift_sin, drift_cos) = libm::sincos(drift);
        let centre = self.centre_distance + centre_error;
        if !(centre > a && centre.is_finite() && drift.is_finite()) {
            return None;
        }
        // c' sin(α − δ) − a, in which nothing cancels.
        let half = libm::sin(drift / 2.0);
        let beyond = centre_error * sin * drift_cos - centre * cos * drift_sin - 2.0 * a * half * half;
        let axis = Point::new(centre * (cos * drift_cos + sin * drift_sin), a + beyond);
        let pin = |tau: f64| axis - Point::new(libm::sin(tau), libm::cos(tau)) * a;
        let mouth = self.mouth_profile();

        let mut met: Vec<(f64, EntryContact, Point, bool)> = Vec::new();
        // Walls: a (1 − cos τ) = ±gap − beyond, as it goes out to one wall or comes in to the other.
        let sine_of_half = |height: f64| (height / (2.0 * a)).sqrt();
        if (0.0..=2.0 * a).contains(&(gap - beyond)) {
            let tau = 2.0 * libm::asin(sine_of_half(gap - beyond));
            met.push((tau, EntryContact::DrivingWall, Point::new(0.0, -1.0), true));
        }
        if (0.0..=2.0 * a).contains(&(-gap - beyond)) {
            let tau = -2.0 * libm::asin(sine_of_half(-gap - beyond));
            met.push((tau, EntryContact::OtherWall, Point::new(0.0, 1.0), false));
        }
        met.retain(|(tau, ..)| pin(*tau).x <= mouth.wall_end.x);
        let mirrored = |p: Point| Point::new(p.x, -p.y);
        for corner in mouth.corners().into_iter().flat_map(|corner| [corner, mirrored(corner)]) {
            let from = axis - corner;
            let reach = (from.norm_squared() + a * a - rho * rho) / (2.0 * a * from.norm());
            if reach <= 1.0 {
                let tau = libm::atan2(from.x, from.y) - libm::acos(reach);
                let normal = (pin(tau) - corner) / rho;
                if normal.x >= 0.0 {
                    met.push((tau, EntryContact::Mouth, normal, corner.y > 0.0));
                }
            }
        }
        for side in [1.0, -1.0] {
            let on_side = |p: Point| Point::new(p.x, side * p.y);
            if let Some((tau, normal)) = mouth.first_on_face(&on_side(axis), a * side, rho) {
                met.push((tau, EntryContact::MouthFace, on_side(normal), side > 0.0));
            }
        }
        let rim = self.tip_radius + rho;
        let sine = (centre * centre + a * a - rim * rim) / (2.0 * a * centre);
        if sine.abs() <= 1.0 {
            let tau = libm::asin(sine) - self.wheel.half_pitch_angle() + drift;
            let at = pin(tau);
            let angle = libm::atan2(at.y, at.x).abs();
            if (self.corner_angle()..=self.tip_angle()).contains(&angle) {
                met.push((tau, EntryContact::Mouth, at / rim, at.y > 0.0));
            }
        }
        let (tau, contact, normal, is_driving_side) = met.into_iter().min_by(|one, other| one.0.total_cmp(&other.0))?;
        let velocity = Point::new(-libm::cos(tau), libm::sin(tau));
        let closing_speed = -velocity.dot(&normal);
        let touching = pin(tau) - normal * rho;
        Some(PinEntry {
            contact,
            crank_angle: tau - drift - self.wheel.engagement_half_angle(),
            closing_speed,
            is_driving_side,
            slant: libm::asin(normal.x.clamp(-1.0, 1.0)).abs(),
            velocity_jump: -a * closing_speed / touching.perp(&normal),
        })
    }
}
