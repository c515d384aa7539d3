//! Sizes of the two parts in millimetres, from the numbers of stations and pins and one length.
//!
//! Notation: `a` crank radius, `c` centre distance, `R` wheel radius to the pin's centre at entry, ρ the pin's radius,
//! `h` half the width of a slot, `b` clearance at its bottom, α half the angle between slots.
//!
//! Every play is the difference of two widths or diameters, as in a table of fits; the gap on each side is half of it.

use super::Wheel;
use super::crescent::Crescent;
use super::fit::Remedy::{LessDepth, LessPlay, ThinnerHorn, ThinnerPin};
use super::fit::{ShaftOf, SizesError};
use crate::error::length;
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
}

/// Play: how much wider each hollow is than what runs in it; the gap on each side is half as much.
///
/// ```
/// use geneva_kinematics::wheel::Play;
///
/// let play = Play::of(0.2); // mm
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
}

/// The play of the bores over that of slot and locking arc, dimensionless.
///
/// Loose in their bores or bearings, both shafts together let the axes come nearer by the play of one of them. Slot and
/// locking arc leave half of their own play for that, and the crescents of few stations a little less.
const OF_BORES: f64 = 0.25;

/// The least diameter of a driver's shaft that the program chooses, over the pin's diameter, dimensionless.
const OF_DRIVER_SHAFT: f64 = 0.4;

/// The clearance at a slot's bottom over the pin's diameter, dimensionless.
const OF_BOTTOM: f64 = 0.05;

impl Play {
    /// This play of slot and locking arc, in millimetres, and a quarter of it of the bores: a shaft that is loose in its
    /// bore brings the axes nearer.
    pub fn of(play: f64) -> Self {
        Self { slot: play, locking: play, bore: OF_BORES * play }
    }
}

/// Choices of a designer; everything not chosen has a default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Choices {
    /// Diameter of the pins, in millimetres. By default the least of 0.3 a, ⅔ (c − a) and 0.9 √(a (c − R)): the first
    /// for strength, the second for three and four stations, whose hub is small, the third for many, whose crescents
    /// come near the driver's axis.
    pub pin_diameter: Option<f64>,
    /// The plays, in millimetres, zero or more. By default [`Play::of`] the least of a thousandth of the centre distance, a
    /// twentieth of the pin's diameter and a tenth of c − R, the way from the driver's axis to the wheel.
    pub play: Option<Play>,
    /// How much deeper a slot is than the pin and its gap need, in millimetres, zero or more. By default a twentieth of the
    /// pin's diameter: a cutter is not stopped as exactly as a slot is wide.
    pub bottom_clearance: Option<f64>,
    /// Least thickness of the wheel between a slot and a locking arc, in millimetres. By default the pin's diameter, so
    /// that without play the locking disc's radius is a − 3 ρ.
    pub horn_thickness: Option<f64>,
    /// Diameter of the wheel's shaft, in millimetres. By default half of the greatest.
    pub wheel_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plane of the wheel, in millimetres. By default half of the greatest; none,
    /// so that the shaft must end in the plate, where that would be less than two fifths of the pin's diameter: beside a
    /// bore as wide as half the room, the disc would be thinner than a fifth of the pin.
    pub driver_shaft: Option<f64>,
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
/// let choices = Choices { pin_diameter: Some(10.0), play: Some(Play::of(0.2)), ..Choices::default() };
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
    /// Radius of the wheel's rim, in millimetres: the corners of a slot stand at R along it, h beside its middle, so that
    /// the pin enters between straight walls.
    pub tip_radius: f64,
    /// Diameter of a pin, in millimetres.
    pub pin_diameter: f64,
    /// The plays.
    pub play: Play,
    /// Width of a slot, in millimetres.
    pub slot_width: f64,
    /// How much deeper a slot is than the pin and its gap need, in millimetres.
    pub bottom_clearance: f64,
    /// Distance of the centre of a slot's round end from the wheel's axis, in millimetres: c − a − b.
    pub slot_end: f64,
    /// From the wheel radius to the bottom of a slot, in millimetres: R − (c − a) + b + h.
    pub slot_depth: f64,
    /// Least thickness of the wheel between a slot and a locking arc, in millimetres; it is at the slot's corner.
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
    /// Diameter of the wheel's shaft, in millimetres.
    pub wheel_shaft: f64,
    /// Diameter of the driver's shaft in the plane of the wheel, in millimetres; zero if it ends in the plate.
    pub driver_shaft: f64,
}

/// A dwell shorter than this part of a turn is none: it is rounding.
const SHORTEST_DWELL: f64 = 1e-9;

impl Sizes {
    /// The sizes of a wheel from one length and the designer's choices.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Remedy, Scale, Sizes, SizesError, Wheel};
    ///
    /// let thick = Choices { pin_diameter: Some(60.0), ..Choices::default() }; // mm, on a crank of 50 mm
    /// let refused = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &thick);
    /// assert!(matches!(refused, Err(SizesError::DoesNotFit { remedies, .. }) if remedies.contains(&Remedy::ThinnerPin)));
    /// # Ok::<(), SizesError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SizesError::Kinematics`] for a length that is not positive and finite, [`SizesError::Play`] for a play or a
    /// clearance that is negative or not finite, [`SizesError::DoesNotFit`] for parts that are in each other's way, and
    /// [`SizesError::Shaft`] for a shaft that is too thick.
    pub fn new(wheel: Wheel, scale: Scale, choices: &Choices) -> Result<Self, SizesError> {
        let [a, c, wheel_radius] = lengths(&wheel, scale)?;
        // a tan(α/2), without the difference of nearly equal lengths.
        let from_axis = a * libm::tan(wheel.half_pitch_angle() / 2.0);
        let pin_diameter = match choices.pin_diameter {
            Some(asked) => length("pin diameter", asked)?,
            None => default_pin(a, c, from_axis),
        };
        let play = match choices.play {
            Some(play) => fitting_play(play)?,
            None => Play::of((c / 1000.0).min(pin_diameter / 20.0).min(0.1 * from_axis)),
        };
        let horn_thickness = length("horn thickness", choices.horn_thickness.unwrap_or(pin_diameter))?;
        let slot_width = pin_diameter + play.slot;
        let bottom_clearance = match choices.bottom_clearance {
            Some(asked) => zero_or_more("clearance at the slot's bottom", asked)?,
            None => OF_BOTTOM * pin_diameter,
        };
        let (half, slot_end) = (slot_width / 2.0, c - a - bottom_clearance);
        let sine = libm::sin(wheel.half_pitch_angle());
        let web = 2.0 * slot_end * sine - slot_width;
        let fits = |room: f64, what, remedies| {
            if room > 0.0 { Ok(room) } else { Err(SizesError::DoesNotFit { what, by: -room, remedies }) }
        };
        fits(web, "the ends of two neighbouring slots run into each other", &[ThinnerPin, LessPlay, LessDepth])?;
        let locking_arc_radius = a - half - horn_thickness;
        let tip_radius = libm::hypot(wheel_radius, half);
        fits(locking_arc_radius + tip_radius - c, "the locking arcs miss the wheel", &[ThinnerPin, ThinnerHorn])?;
        let passing = c - a - pin_diameter / 2.0;
        let plate_radius = a + pin_diameter / 2.0 + (pin_diameter / 2.0).min(passing / 2.0);
        let mut sizes = Self {
            wheel,
            crank_radius: a,
            centre_distance: c,
            wheel_radius,
            tip_radius,
            pin_diameter,
            play,
            slot_width,
            bottom_clearance,
            slot_end,
            slot_depth: wheel_radius - slot_end + half,
            horn_thickness,
            web,
            locking_arc_radius,
            locking_disc: None,
            plate_radius,
            wheel_shaft_limit: 2.0 * (slot_end - half).min(c - plate_radius) - play.bore,
            driver_shaft_limit: 2.0 * (c - tip_radius) - play.bore,
            wheel_shaft: 0.0,
            driver_shaft: 0.0,
        };
        if wheel.dwell_fraction() > SHORTEST_DWELL {
            let radius = fits(locking_arc_radius - play.locking / 2.0, "the play leaves no locking disc", &[LessPlay])?;
            let crescent = Crescent::of(&sizes, radius)?;
            let left = 2.0 * (crescent.centre - crescent.radius) - play.bore;
            sizes.driver_shaft_limit = sizes.driver_shaft_limit.min(left);
            sizes.locking_disc = Some(LockingDisc { radius, crescent });
        }
        sizes.wheel_shaft = shaft(ShaftOf::Wheel, choices.wheel_shaft, sizes.wheel_shaft_limit, 0.0)?;
        sizes.driver_shaft =
            shaft(ShaftOf::Driver, choices.driver_shaft, sizes.driver_shaft_limit, OF_DRIVER_SHAFT * pin_diameter)?;
        Ok(sizes)
    }

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
    /// let choices = Choices { play: Some(Play::of(0.2)), ..Choices::default() }; // mm
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

    fn bore(&self, shaft: f64) -> f64 {
        if shaft > 0.0 { shaft + self.play.bore } else { 0.0 }
    }

    /// Least thickness of the wheel between a slot's end and the bore, in millimetres; to the axis, without a bore.
    pub fn bore_web(&self) -> f64 {
        self.slot_end - (self.slot_width + self.wheel_bore()) / 2.0
    }

    /// Angle of a slot's corners from its middle, seen from the wheel's axis, in radians.
    pub(super) fn corner_angle(&self) -> f64 {
        libm::atan2(self.slot_width / 2.0, self.wheel_radius)
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

/// Crank radius, centre distance and wheel radius; the one that is given comes back as it is.
fn lengths(wheel: &Wheel, scale: Scale) -> Result<[f64; 3], SizesError> {
    let (c, r) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
    let lengths = match scale {
        Scale::CrankRadius(a) => {
            let a = length("crank radius", a)?;
            [a, a * c, a * r]
        }
        Scale::CentreDistance(distance) => {
            let distance = length("centre distance", distance)?;
            [distance / c, distance, distance / c * r]
        }
        Scale::WheelRadius(radius) => {
            let radius = length("wheel radius", radius)?;
            [radius / r, radius / r * c, radius]
        }
    };
    for (name, of) in ["crank radius", "centre distance", "wheel radius"].into_iter().zip(lengths) {
        length(name, of)?;
    }
    Ok(lengths)
}

/// Diameter of a pin that nothing makes thinner, in crank radii.
const OF_CRANK_RADIUS: f64 = 0.3;

fn default_pin(a: f64, c: f64, from_axis: f64) -> f64 {
    (OF_CRANK_RADIUS * a).min((c - a) / 1.5).min(0.9 * (a * from_axis).sqrt())
}

fn fitting_play(play: Play) -> Result<Play, SizesError> {
    for (name, asked) in [("slot play", play.slot), ("locking play", play.locking), ("bore play", play.bore)] {
        zero_or_more(name, asked)?;
    }
    Ok(play)
}

fn zero_or_more(name: &'static str, asked: f64) -> Result<f64, SizesError> {
    if asked >= 0.0 && asked.is_finite() { Ok(asked) } else { Err(SizesError::Play { name, asked }) }
}

/// The shaft that was asked for, or half of the greatest, or none if that is too thin to be of use.
fn shaft(name: ShaftOf, asked: Option<f64>, most: f64, least: f64) -> Result<f64, SizesError> {
    match asked {
        None => Ok(Some(most / 2.0).filter(|half| *half > least).unwrap_or_default()),
        Some(asked) if length("shaft's diameter", asked)? < most => Ok(asked),
        Some(asked) => Err(SizesError::Shaft { name, asked, most }),
    }
}
