//! Sizes of a wheel and its driver as they were made, each part with its own.
//!
//! The wheel's slots are numbered counter-clockwise, the middle of slot 0 on the first axis; arc k is between slots k and
//! k + 1. The driver's pins are numbered counter-clockwise too, pin 0 on its first axis. Directions are given as errors: how
//! far a part is counter-clockwise of where it should be.

use super::errors::BuiltError;
use crate::indexing::Indexing;
use crate::wheel::{Mouth, Sizes, Wheel};

/// A slot as it was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BuiltSlot {
    /// Its width, in millimetres.
    pub width: f64,
    /// Distance of the centre of its round end from the wheel's axis, in millimetres.
    pub end: f64,
    /// How far its middle is counter-clockwise of its right direction, in radians.
    pub direction_error: f64,
    /// Radius of the wheel's rim beside its mouth, in millimetres: how far out its corners are.
    pub tip_radius: f64,
}

/// A locking arc as it was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BuiltArc {
    /// Its radius, in millimetres.
    pub radius: f64,
    /// Distance of its centre from the wheel's axis, in millimetres.
    pub centre: f64,
    /// How far its centre is counter-clockwise of its right direction, in radians.
    pub direction_error: f64,
}

/// The cut in the locking disc before a pin, as it was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BuiltCrescent {
    /// Distance of its centre from the driver's axis, in millimetres.
    pub centre: f64,
    /// Its radius, in millimetres.
    pub radius: f64,
    /// How far its centre is counter-clockwise of its right direction, in radians.
    pub direction_error: f64,
}

/// A pin as it was made, with the cut before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BuiltPin {
    /// Distance of its centre from the driver's axis, in millimetres.
    pub crank_radius: f64,
    /// Its diameter, in millimetres.
    pub diameter: f64,
    /// How far it is counter-clockwise of its right direction, in radians.
    pub direction_error: f64,
    /// The cut in the locking disc; of no use without a disc.
    pub crescent: BuiltCrescent,
}

/// An external wheel and its driver as they were made.
///
/// ```
/// use geneva_kinematics::wheel::as_built::AsBuiltWheel;
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
/// let mut built = AsBuiltWheel::from(&sizes);
/// assert!(built.turn()?.jam.is_none()); // as drawn, the wheel turns
/// built.slots_mut()[2].width -= 0.3; // mm: one slot is narrower than the pin
/// assert!(built.turn()?.jam.is_some_and(|jam| jam.slot == 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AsBuiltWheel {
    /// The numbers of stations and pins.
    pub(super) wheel: Wheel,
    /// Distance between the axes, in millimetres.
    pub centre_distance: f64,
    /// Radius of the locking disc, in millimetres; none without a disc.
    pub disc_radius: Option<f64>,
    /// Shape of the mouths of all slots.
    pub mouth: Mouth,
    slots: Vec<BuiltSlot>,
    arcs: Vec<BuiltArc>,
    pins: Vec<BuiltPin>,
}

impl From<&Sizes> for AsBuiltWheel {
    /// The wheel that is made exactly as it was drawn, but with sharp corners at the mouths of its slots: whatever turns with
    /// these turns with any [`Mouth`], and its blows are softer. Set [`mouth`](Self::mouth) for another one.
    fn from(sizes: &Sizes) -> Self {
        let slot = BuiltSlot {
            width: sizes.slot_width,
            end: sizes.slot_end,
            direction_error: 0.0,
            tip_radius: sizes.tip_radius,
        };
        let arc = BuiltArc { radius: sizes.locking_arc_radius, centre: sizes.centre_distance, direction_error: 0.0 };
        let cut = sizes.locking_disc.map(|disc| disc.crescent);
        let crescent = BuiltCrescent {
            centre: cut.map_or(sizes.crank_radius, |cut| cut.centre),
            radius: cut.map_or(sizes.crank_radius, |cut| cut.radius),
            direction_error: 0.0,
        };
        let pin =
            BuiltPin { crank_radius: sizes.crank_radius, diameter: sizes.pin_diameter, direction_error: 0.0, crescent };
        let disc = sizes.locking_disc.map(|disc| disc.radius);
        Self::alike(sizes.wheel, sizes.centre_distance, disc, (slot, arc, pin))
    }
}

impl AsBuiltWheel {
    /// A wheel whose slots, arcs and pins are all alike; lengths in millimetres.
    pub(super) fn alike(
        wheel: Wheel,
        centre_distance: f64,
        disc_radius: Option<f64>,
        (slot, arc, pin): (BuiltSlot, BuiltArc, BuiltPin),
    ) -> Self {
        Self {
            wheel,
            centre_distance,
            disc_radius,
            mouth: Mouth::Sharp,
            slots: vec![slot; wheel.stations() as usize],
            arcs: vec![arc; wheel.stations() as usize],
            pins: vec![pin; wheel.pins() as usize],
        }
    }

    /// The numbers of stations and pins.
    pub fn wheel(&self) -> &Wheel {
        &self.wheel
    }

    /// The slots, counter-clockwise.
    pub fn slots(&self) -> &[BuiltSlot] {
        &self.slots
    }

    /// The slots, counter-clockwise, to be changed.
    pub fn slots_mut(&mut self) -> &mut [BuiltSlot] {
        &mut self.slots
    }

    /// The locking arcs, counter-clockwise; the first is between the first two slots.
    pub fn arcs(&self) -> &[BuiltArc] {
        &self.arcs
    }

    /// The locking arcs, counter-clockwise, to be changed.
    pub fn arcs_mut(&mut self) -> &mut [BuiltArc] {
        &mut self.arcs
    }

    /// The pins, counter-clockwise.
    pub fn pins(&self) -> &[BuiltPin] {
        &self.pins
    }

    /// The pins, counter-clockwise, to be changed.
    pub fn pins_mut(&mut self) -> &mut [BuiltPin] {
        &mut self.pins
    }

    /// How much depth each slot lacks for the pin that reaches farthest into it, in millimetres; below zero the gap at its bottom.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::AsBuiltWheel;
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices::default())?;
    /// let mut built = AsBuiltWheel::from(&sizes);
    /// built.slots_mut()[2].end += sizes.bottom_gap() + 0.4; // mm: nearer to the rim
    /// let missing = built.missing_depths();
    /// assert!((missing[2] - 0.4).abs() < 1e-12 && (missing[0] + sizes.bottom_gap()).abs() < 1e-12);
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn missing_depths(&self) -> Vec<f64> {
        let reach = self.pins.iter().map(|pin| pin.crank_radius + pin.diameter / 2.0).fold(0.0, f64::max);
        let of = |slot: &BuiltSlot| slot.end - slot.width / 2.0 - (self.centre_distance - reach);
        self.slots.iter().map(of).collect()
    }

    /// Checks that all lengths are positive and finite, all directions finite and within half a pitch, that the wheel's axis is
    /// outside the pins' circles, and that the mouths leave some of each wall.
    ///
    /// # Errors
    ///
    /// [`BuiltError`] names the first size that is not so.
    pub fn check(&self) -> Result<(), BuiltError> {
        let c = self.centre_distance;
        let length = |name, asked: f64| {
            if asked > 0.0 && asked.is_finite() { Ok(()) } else { Err(BuiltError::Length { name, asked }) }
        };
        let most = self.wheel.half_pitch_angle();
        let direction = |name, asked: f64| {
            if asked.abs() < most { Ok(()) } else { Err(BuiltError::Direction { name, asked, most }) }
        };
        length("centre distance", c)?;
        self.disc_radius.map_or(Ok(()), |disc| length("radius of the locking disc", disc))?;
        for slot in &self.slots {
            length("width of a slot", slot.width)?;
            length("end of a slot", slot.end)?;
            length("radius of the rim", slot.tip_radius)?;
            direction("direction of a slot", slot.direction_error)?;
            if slot.width >= 2.0 * slot.tip_radius {
                return Err(BuiltError::TooWide { asked: slot.width, most: 2.0 * slot.tip_radius });
            }
        }
        for arc in &self.arcs {
            length("radius of a locking arc", arc.radius)?;
            length("distance of a locking arc's centre", arc.centre)?;
            direction("direction of a locking arc", arc.direction_error)?;
        }
        for pin in &self.pins {
            length("diameter of a pin", pin.diameter)?;
            length("crank radius", pin.crank_radius)?;
            length("distance of a crescent's centre", pin.crescent.centre)?;
            length("radius of a crescent", pin.crescent.radius)?;
            direction("direction of a pin", pin.direction_error)?;
            direction("direction of a crescent", pin.crescent.direction_error)?;
            if pin.crank_radius >= c {
                return Err(BuiltError::CrankTooLong { asked: pin.crank_radius, most: c });
            }
        }
        self.check_mouth()
    }
}
