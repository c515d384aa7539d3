//! Sizes of the two parts in millimetres.
//!
//! Notation: `a` crank radius, `c` centre distance, `R` wheel radius to the pin's centre at entry, ρ the pin's radius,
//! `h` half the width of a slot, `b` clearance at its bottom, α half the angle between slots.
//!
//! Every play is the difference of two widths or diameters, as in a table of fits; the gap on each side is half of it.

use super::Wheel;
use super::mouth::{Mouth, MouthProfile};
use crate::indexing::Indexing;

/// The length that is given; it turns a wheel's ratios into millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Distance of the pin's centre from the driver's axis, in millimetres.
    CrankRadius(f64),
    /// Distance between the two axes, in millimetres.
    CentreDistance(f64),
    /// Distance of the pin's centre from the wheel's axis as it enters, in millimetres.
    WheelRadius(f64),
    /// Diameter of the wheel over the corners of its slots, in millimetres.
    OutsideDiameter(f64),
}

/// Play: how much wider each hollow is than what runs in it; the gap on each side is half as much.
///
/// ```
/// use geneva_kinematics::wheel::Play;
///
/// let play = Play::from_slot(0.2); // mm
/// assert_eq!((play.slot, play.locking, play.bore), (0.2, 0.2, 0.05));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Play {
    /// Width of a slot less the pin's diameter, in millimetres.
    pub slot: f64,
    /// Diameter of the locking arcs less that of the locking disc, in millimetres.
    pub locking: f64,
    /// Diameter of a bore less that of its shaft, in millimetres.
    pub bore: f64,
    /// How far a pin may be off its place on the driver in any direction, in millimetres: that of a screw, or of a bush on one, as far
    /// as their clearance holes let it. Zero for a pin that is pressed in, or in one piece with the plate.
    pub pin: f64,
}

/// The play of the bores over that of slot and locking arc, dimensionless.
///
/// Loose in their bores or bearings, both shafts together let the axes come nearer by the play of one of them. Slot and
/// locking arc leave half of their own play for that, and the crescents of few stations a little less.
const OF_BORES: f64 = 0.25;

impl Play {
    /// This play of slot and locking arc, in millimetres, and a quarter of it of the bores: a shaft that is loose in its
    /// bore brings the axes nearer. Pins are in their place.
    pub fn from_slot(play: f64) -> Self {
        Self { slot: play, locking: play, bore: OF_BORES * play, pin: 0.0 }
    }
}

/// Choices of a designer; everything not chosen has a default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Choices {
    /// Diameter of the pins, in millimetres. By default the least of 0.3 a, ⅔ (c − a) and 0.9 √(a (c − R)): the first
    /// for strength, the second for three and four stations, whose hub is small, the third for many, whose crescents
    /// come near the driver's axis.
    pub pin_diameter: Option<f64>,
    /// The plays, in millimetres, zero or more. By default [`Play::from_slot`] the least of a thousandth of the centre distance, a
    /// twentieth of the pin's diameter and a tenth of c − R, the way from the driver's axis to the wheel.
    pub play: Option<Play>,
    /// How much deeper a slot is than the pin and its gap need, in millimetres, zero or more. By default a twentieth of the
    /// pin's diameter: a cutter is not stopped as exactly as a slot is wide.
    pub bottom_clearance: Option<f64>,
    /// Least thickness of the wheel between a slot and a locking arc, in millimetres. By default the pin's diameter, so
    /// that without play the locking disc's radius is a − 3 ρ.
    pub horn_thickness: Option<f64>,
    /// Radius of the locking arcs, in millimetres, which then gives the horn's thickness.
    pub locking_arc_radius: Option<f64>,
    /// Diameter of the wheel's shaft, in millimetres. By default there is none, and the wheel has no bore.
    pub wheel_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plane of the wheel, in millimetres. By default there is none, and the locking disc
    /// has no bore.
    pub driver_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plate, in millimetres. By default as in the plane of the wheel. A shaft that ends
    /// in the plate can be thicker than one that has to pass crescent and rim.
    pub plate_shaft: Option<f64>,
    /// Shape of the mouths of the slots. By default their corners are sharp.
    pub mouth: Mouth,
}

/// An arc that is cut out of the locking disc; its centre lies on the line from the driver's axis through the pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crescent {
    /// Distance of its centre from the driver's axis, in millimetres.
    pub centre: f64,
    /// Its radius, in millimetres.
    pub radius: f64,
    /// Half the angle of its opening as seen from the driver's axis, in radians.
    pub half_angle: f64,
}

/// The driver's locking disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LockingDisc {
    /// Radius of the disc, in millimetres.
    pub radius: f64,
    /// The arc that is cut out of the disc before each pin.
    pub crescent: Crescent,
}

/// Sizes of a wheel and its driver, in millimetres.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// // Six stations with the axes 100 mm apart, a pin of 10 mm and a play of 0.2 mm.
/// let choices = Choices { pin_diameter: Some(10.0), play: Some(Play::from_slot(0.2)), ..Choices::default() };
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CentreDistance(100.0), &choices)?;
/// assert!((sizes.crank_radius - 50.0).abs() < 1e-12); // mm: 100 sin 30°
/// assert!((sizes.wheel_radius - 50.0 * 3_f64.sqrt()).abs() < 1e-12); // mm: 100 cos 30°
/// assert!((sizes.slot_width - (10.0 + 0.2)).abs() < 1e-12); // mm
/// assert!(sizes.warnings().is_empty());
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sizes {
    /// The numbers of stations and pins.
    pub wheel: Wheel,
    /// Distance of a pin's centre from the driver's axis, in millimetres.
    pub crank_radius: f64,
    /// Distance between the axes, in millimetres: a / sin α.
    pub centre_distance: f64,
    /// Distance of the pin's centre from the wheel's axis as it enters, in millimetres: c cos α.
    pub wheel_radius: f64,
    /// Radius of the wheel's rim, in millimetres: the corners of a slot with sharp mouths stand at R along it, h beside its
    /// middle, so that the pin enters between straight walls.
    pub tip_radius: f64,
    /// Diameter of a pin, in millimetres.
    pub pin_diameter: f64,
    /// The plays.
    pub play: Play,
    /// Width of a slot between its straight walls, in millimetres.
    pub slot_width: f64,
    /// Shape of the mouths of the slots.
    pub mouth: Mouth,
    /// How much deeper a slot is than the pin and its gap need, in millimetres.
    pub bottom_clearance: f64,
    /// Distance of the centre of a slot's round end from the wheel's axis, in millimetres: c − a − b.
    pub slot_end: f64,
    /// From the wheel radius to the bottom of a slot, in millimetres: R − (c − a) + b + h.
    pub slot_depth: f64,
    /// Least thickness of the wheel between a straight wall of a slot, as far as the wheel radius, and a locking arc, in
    /// millimetres. Where a mouth takes the corner away, [`mouth_horn`](Self::mouth_horn) is what is left there.
    pub horn_thickness: f64,
    /// Least thickness of the wheel between two neighbouring slots, in millimetres; it is between their ends.
    pub web: f64,
    /// Radius of the wheel's locking arcs, in millimetres.
    pub locking_arc_radius: f64,
    /// The locking disc; none where the pins take turns without a dwell.
    pub locking_disc: Option<LockingDisc>,
    /// Radius of the round plate behind the wheel that carries disc and pins, in millimetres.
    pub plate_radius: f64,
    /// Greatest diameter of the wheel's shaft, in millimetres: it must leave the slots' ends, and the driver's plate
    /// must pass it.
    pub wheel_shaft_limit: f64,
    /// Greatest diameter of the driver's shaft in the plane of the wheel, in millimetres: the wheel's rim must pass it,
    /// and the crescent must leave it.
    pub driver_shaft_limit: f64,
    /// Greatest diameter of the driver's shaft in the plate, in millimetres: the pins must leave it.
    pub plate_shaft_limit: f64,
    /// Diameter of the wheel's shaft, in millimetres; zero without one.
    pub wheel_shaft: f64,
    /// Diameter of the driver's shaft in the plane of the wheel, in millimetres; zero without one there.
    pub driver_shaft: f64,
    /// Diameter of the driver's shaft in the plate, in millimetres; zero without one.
    pub plate_shaft: f64,
}

/// Diameter of a pin that nothing makes thinner, in crank radii.
pub(super) const OF_CRANK_RADIUS: f64 = 0.3;

impl Sizes {
    /// Radius of a pin, in millimetres: half its diameter.
    pub fn pin_radius(&self) -> f64 {
        self.pin_diameter / 2.0
    }

    /// The gap on each side of a pin that is in the middle of its slot, in millimetres.
    pub fn slot_gap(&self) -> f64 {
        self.play.slot / 2.0
    }

    /// Diameter in millimetres of the pins that the wheel would have if the hub, the horns and the disc left them room.
    pub fn unhindered_pin(&self) -> f64 {
        OF_CRANK_RADIUS * self.crank_radius
    }

    /// Distance of a pin's centre from the wheel's axis where it is deepest in its slot, in millimetres: c − a.
    pub fn deepest(&self) -> f64 {
        self.centre_distance - self.crank_radius
    }

    /// Between pin and bottom of the slot where the pin is deepest, in millimetres. By so much may the slot's end be too far
    /// out; a crank that is too long, and axes that are too near, take of it as well.
    pub fn bottom_gap(&self) -> f64 {
        self.slot_gap() + self.bottom_clearance
    }

    /// Between the locking disc and the middle of the locking arc in the dwell, in millimetres. As much may the disc's radius
    /// be too long, and the locking arc's radius and the centre distance, together, too short. None without a disc.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// assert!(sizes.locking_gap().is_some_and(|gap| (gap - 0.1).abs() < 1e-12)); // half of the play, in mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn locking_gap(&self) -> Option<f64> {
        self.locking_disc.map(|disc| self.locking_arc_radius - disc.radius)
    }

    /// Diameter of the wheel's bore, in millimetres; zero without a shaft.
    pub fn wheel_bore(&self) -> f64 {
        self.bore(self.wheel_shaft)
    }

    /// Diameter of the driver's bore in the plane of the wheel, in millimetres; zero without a shaft there.
    pub fn driver_bore(&self) -> f64 {
        self.bore(self.driver_shaft)
    }

    /// Diameter of the bore of the driver's plate, in millimetres; zero without a shaft.
    pub fn plate_bore(&self) -> f64 {
        self.bore(self.plate_shaft)
    }

    fn bore(&self, shaft: f64) -> f64 {
        if shaft > 0.0 { shaft + self.play.bore } else { 0.0 }
    }

    /// Least thickness of the wheel between a slot's end and the bore, in millimetres; to the axis, without a bore.
    pub fn bore_web(&self) -> f64 {
        self.slot_end - (self.slot_width + self.wheel_bore()) / 2.0
    }

    /// One side of the mouth of a slot; the sharp one in place of a shape that does not fit.
    pub(super) fn mouth_profile(&self) -> MouthProfile {
        let of = |mouth: Mouth| mouth.profile(self.wheel_radius, self.slot_width / 2.0, self.tip_radius);
        let corner = nalgebra::Vector2::new(self.wheel_radius, self.slot_width / 2.0);
        of(self.mouth).unwrap_or(MouthProfile { wall_end: corner, face: None, rim: corner })
    }

    /// How much of each wall of a slot its mouth takes, along the slot from the wheel radius, in millimetres; zero if the
    /// corners are sharp.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Mouth, Scale, Sizes, Wheel};
    ///
    /// let mouth = Mouth::LeadIn { length: 4.0, flare: 0.4 }; // mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices { mouth, ..Choices::default() })?;
    /// assert!((sizes.mouth_length() - 4.0).abs() < 1e-12); // mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn mouth_length(&self) -> f64 {
        self.wheel_radius - self.mouth_profile().wall_end.x
    }

    /// Angle of the rim's ends beside a slot from the slot's middle, seen from the wheel's axis, in radians.
    pub(super) fn corner_angle(&self) -> f64 {
        let corner = self.mouth_profile().rim;
        libm::atan2(corner.y, corner.x)
    }

    /// Angle of the ends of a locking arc from its middle, seen from the wheel's axis, in radians.
    pub(super) fn locking_end_angle(&self) -> f64 {
        let (c, rim, arc) = (self.centre_distance, self.tip_radius, self.locking_arc_radius);
        // By half the angle, whose sine loses no digits: sin²(x/2) = (arc² − (c − rim)²) / (4 c rim).
        let square = (arc - (c - rim)) * (arc + (c - rim)) / (4.0 * c * rim);
        2.0 * libm::asin(square.max(0.0).sqrt().min(1.0))
    }

    /// Angle of the ends of a locking arc from the slot beside them, seen from the wheel's axis, in radians.
    pub(super) fn tip_angle(&self) -> f64 {
        self.wheel.half_pitch_angle() - self.locking_end_angle()
    }
}
