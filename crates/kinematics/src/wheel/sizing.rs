//! How sizes in millimetres follow from the numbers of stations and pins, one length and the designer's choices.

use super::Wheel;
use super::fit::Remedy::{LessDepth, LessPlay, ThinnerHorn, ThinnerPin};
use super::fit::{Remedy, ShaftOf, SizesError};
use super::sizes::{Choices, Crescent, LockingDisc, OF_CRANK_RADIUS, Play, Scale, Sizes};
use crate::error::length;
use crate::indexing::Indexing;

/// The clearance at a slot's bottom over the pin's diameter, dimensionless.
const OF_BOTTOM: f64 = 0.05;

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
    /// clearance that is negative or not finite, [`SizesError::DoesNotFit`] for parts that are in each other's way,
    /// [`SizesError::Mouth`] and [`SizesError::ChamferAngle`] for a mouth that leaves too little, and [`SizesError::Shaft`] for a
    /// shaft that is too thick.
    pub fn new(wheel: Wheel, scale: Scale, choices: &Choices) -> Result<Self, SizesError> {
        let [a, c, wheel_radius] = lengths(&wheel, scale, choices)?;
        let (pin_diameter, play) = pin_and_play(&wheel, [a, c], choices)?;
        let slot_width = pin_diameter + play.slot;
        let horn_thickness = match choices.locking_arc_radius {
            Some(asked) => {
                let horn = a - slot_width / 2.0 - length("locking arc radius", asked)?;
                fits(horn, "a locking arc runs into the slots beside it", &[ThinnerPin, LessPlay])?
            }
            None => length("horn thickness", choices.horn_thickness.unwrap_or(pin_diameter))?,
        };
        let bottom_clearance = match choices.bottom_clearance {
            Some(asked) => zero_or_more("clearance at the slot's bottom", asked)?,
            None => OF_BOTTOM * pin_diameter,
        };
        let (half, slot_end) = (slot_width / 2.0, c - a - bottom_clearance);
        let sine = libm::sin(wheel.half_pitch_angle());
        let web = 2.0 * slot_end * sine - slot_width;
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
            mouth: choices.mouth,
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
            plate_shaft_limit: 2.0 * a - pin_diameter - play.bore,
            wheel_shaft: 0.0,
            driver_shaft: 0.0,
            plate_shaft: 0.0,
        };
        sizes.check_mouth()?;
        if wheel.dwell_fraction() > SHORTEST_DWELL {
            let radius = fits(locking_arc_radius - play.locking / 2.0, "the play leaves no locking disc", &[LessPlay])?;
            let crescent = Crescent::shallowest(&sizes, radius)?;
            let left = 2.0 * (crescent.centre - crescent.radius) - play.bore;
            sizes.driver_shaft_limit = sizes.driver_shaft_limit.min(left);
            sizes.locking_disc = Some(LockingDisc { radius, crescent });
        }
        sizes.wheel_shaft = shaft(ShaftOf::Wheel, choices.wheel_shaft, sizes.wheel_shaft_limit)?;
        sizes.driver_shaft = shaft(ShaftOf::Driver, choices.driver_shaft, sizes.driver_shaft_limit)?;
        let plate = choices.plate_shaft.or(choices.driver_shaft);
        sizes.plate_shaft = shaft(ShaftOf::Plate, plate, sizes.plate_shaft_limit)?;
        Ok(sizes)
    }
}

/// The room, if there is some; otherwise what is in the way.
fn fits(room: f64, what: &'static str, remedies: &'static [Remedy]) -> Result<f64, SizesError> {
    if room > 0.0 { Ok(room) } else { Err(SizesError::DoesNotFit { what, by: -room, remedies }) }
}

/// Diameter of a pin and the plays, in millimetres, with this crank radius and centre distance: those that were chosen, or their
/// defaults.
pub(super) fn pin_and_play(wheel: &Wheel, [a, c]: [f64; 2], choices: &Choices) -> Result<(f64, Play), SizesError> {
    // a tan(α/2), without the difference of nearly equal lengths.
    let from_axis = a * libm::tan(wheel.half_pitch_angle() / 2.0);
    let pin_diameter = match choices.pin_diameter {
        Some(asked) => length("pin diameter", asked)?,
        None => default_pin(a, c, from_axis),
    };
    let play = match choices.play {
        Some(play) => fitting_play(play)?,
        None => Play::from_slot((c / 1000.0).min(pin_diameter / 20.0).min(0.1 * from_axis)),
    };
    Ok((pin_diameter, play))
}

/// How often the interval in which a crank radius is looked for is halved: to the last digit.
const HALVINGS: u32 = 64;

/// The crank radius in millimetres of a wheel that measures this much over the corners of its slots. They stand at the wheel
/// radius along a slot, half its width beside it, so the diameter grows with the crank radius.
fn crank_radius_of_rim(wheel: &Wheel, diameter: f64, choices: &Choices) -> Result<f64, SizesError> {
    let rim = length("outside diameter", diameter)? / 2.0;
    let ratio = wheel.wheel_radius_ratio();
    let (mut below, mut above) = (0.0, rim / ratio);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (below + above);
        if !(below < middle && middle < above) {
            break;
        }
        let (pin, play) = pin_and_play(wheel, [middle, middle * wheel.centre_distance_ratio()], choices)?;
        let corners = libm::hypot(ratio * middle, (pin + play.slot) / 2.0);
        if corners < rim { below = middle } else { above = middle }
    }
    fits(below, "the slots are wider than the wheel", &[ThinnerPin, LessPlay])
}

/// Crank radius, centre distance and wheel radius; the one that is given comes back as it is.
fn lengths(wheel: &Wheel, scale: Scale, choices: &Choices) -> Result<[f64; 3], SizesError> {
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
        Scale::OutsideDiameter(diameter) => {
            let a = crank_radius_of_rim(wheel, diameter, choices)?;
            [a, a * c, a * r]
        }
    };
    for (name, of) in ["crank radius", "centre distance", "wheel radius"].into_iter().zip(lengths) {
        length(name, of)?;
    }
    Ok(lengths)
}

fn default_pin(a: f64, c: f64, from_axis: f64) -> f64 {
    (OF_CRANK_RADIUS * a).min((c - a) / 1.5).min(0.9 * (a * from_axis).sqrt())
}

fn fitting_play(play: Play) -> Result<Play, SizesError> {
    for (name, asked) in [
        ("slot play", play.slot),
        ("locking play", play.locking),
        ("bore play", play.bore),
        ("play of a pin", play.pin),
    ] {
        zero_or_more(name, asked)?;
    }
    Ok(play)
}

fn zero_or_more(name: &'static str, asked: f64) -> Result<f64, SizesError> {
    if asked >= 0.0 && asked.is_finite() { Ok(asked) } else { Err(SizesError::Play { name, asked }) }
}

/// The shaft that was asked for, or none.
fn shaft(name: ShaftOf, asked: Option<f64>, most: f64) -> Result<f64, SizesError> {
    match asked {
        None => Ok(0.0),
        Some(asked) if length("shaft's diameter", asked)? < most => Ok(asked),
        Some(asked) => Err(SizesError::Shaft { name, asked, most }),
    }
}
