//! What a mouth leaves of the wheel, and which mouths leave too little.
//!
//! Notation: `D` centre of a locking arc, `A` its radius.

use super::fit::Remedy::{self, ThickerHorn, ThinnerPin};
use super::fit::{MouthSize, SizesError};
use super::mouth::{Mouth, MouthFace};
use super::sizes::Sizes;
use crate::bisection::bisect_times;
use crate::error::length;
use crate::indexing::Indexing;
use nalgebra::Vector2;
use std::f64::consts::FRAC_PI_2;

/// The least thickness of a horn at a mouth over the pin's diameter, dimensionless; our choice.
const LEAST_HORN: f64 = 0.1;
/// The greatest part of a wall, from the wheel radius to the deepest pin, that a mouth may take, dimensionless; our choice. The
/// rest is what drives the wheel.
const OF_WALL: f64 = 0.5;
/// The least flare of a lead-in over its length, dimensionless: a flatter one is a straight wall to any tool, and its arc is so long
/// that digits are lost.
const FLATTEST: f64 = 0.001;
/// Halvings of the interval in which the greatest size of a mouth is.
const HALVINGS: u32 = 60;

/// Why a mouth is too large.
type TooLarge = (&'static str, &'static [Remedy]);

impl Sizes {
    /// Least thickness of the wheel between the mouth of a slot and a locking arc, in millimetres. None if the mouth is sharp:
    /// then it is the [horn's](Self::horn_thickness).
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Mouth, Scale, Sizes, Wheel};
    ///
    /// let horn = |width| {
    ///     let mouth = Mouth::Chamfer { width, angle: 45_f64.to_radians() }; // mm
    ///     let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices { mouth, ..Choices::default() })?;
    ///     Ok::<_, geneva_kinematics::wheel::SizesError>(sizes.mouth_horn().expect("not sharp"))
    /// };
    /// assert!(horn(2.0)? < horn(1.0)?); // mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn mouth_horn(&self) -> Option<f64> {
        let profile = self.mouth_profile();
        let face = profile.face?;
        // In the slot's frame D is at (R, a), above the wall.
        let (sin, cos) = libm::sincos(self.wheel.half_pitch_angle());
        let locking = Vector2::new(cos, sin) * self.centre_distance;
        let mut least =
            profile.corners().map(|corner| (corner - locking).norm()).into_iter().fold(f64::INFINITY, f64::min);
        match face {
            MouthFace::Flat { normal, length } => {
                let from = locking - profile.wall_end;
                let along = -from.perp(&normal);
                if (0.0..=length).contains(&along) {
                    least = least.min(from.dot(&normal).abs());
                }
            }
            MouthFace::Round { .. } => {
                let foot = profile.on_arc(|centre| locking - centre);
                least = foot.map_or(least, |foot| least.min((foot - locking).norm()));
            }
        }
        Some(least - self.locking_arc_radius)
    }

    /// Refuses a mouth that is none, or that leaves too little of horn, rim or wall.
    pub(super) fn check_mouth(&self) -> Result<(), SizesError> {
        let (name, asked) = match self.mouth {
            Mouth::Sharp => return Ok(()),
            Mouth::Chamfer { width, angle } => {
                if !(angle > 0.0 && angle < FRAC_PI_2) {
                    return Err(SizesError::ChamferAngle { asked: angle });
                }
                (MouthSize::Chamfer, length("mouth chamfer", width)?)
            }
            Mouth::Round { radius } => (MouthSize::Radius, length("mouth radius", radius)?),
            Mouth::LeadIn { length: along, flare } => {
                let (along, asked) = (length("lead-in", along)?, length("flare of the lead-in", flare)?);
                let least = FLATTEST * along;
                if asked < least {
                    return Err(SizesError::TooFlat { asked, least });
                }
                (MouthSize::LeadIn, along)
            }
        };
        let Err(too_large) = self.mouth_room(self.mouth) else { return Ok(()) };
        match self.mouth {
            // Too long whatever its flare, or too wide where it is.
            Mouth::LeadIn { length, flare } if length < self.longest_mouth() => {
                Err(self.too_large(MouthSize::Flare, flare, too_large, |flare| Mouth::LeadIn { length, flare }))
            }
            Mouth::LeadIn { flare, .. } => {
                Err(self.too_large(name, asked, too_large, |length| Mouth::LeadIn { length, flare }))
            }
            Mouth::Chamfer { angle, .. } => {
                Err(self.too_large(name, asked, too_large, |width| Mouth::Chamfer { width, angle }))
            }
            Mouth::Round { .. } | Mouth::Sharp => {
                Err(self.too_large(name, asked, too_large, |radius| Mouth::Round { radius }))
            }
        }
    }

    fn too_large(
        &self,
        name: MouthSize,
        asked: f64,
        (reason, remedies): TooLarge,
        of: impl Fn(f64) -> Mouth,
    ) -> SizesError {
        let [most, _] = bisect_times(HALVINGS, [0.0, asked], |size| self.mouth_room(of(size)).is_ok());
        SizesError::Mouth { name, asked, most, reason, remedies }
    }

    /// How much of a wall a mouth may take, in millimetres.
    fn longest_mouth(&self) -> f64 {
        OF_WALL * (self.wheel_radius - self.deepest())
    }

    /// Whether a mouth leaves enough of the wheel.
    fn mouth_room(&self, mouth: Mouth) -> Result<(), TooLarge> {
        let with = Self { mouth, ..*self };
        if mouth.profile(self.wheel_radius, self.slot_width / 2.0, self.tip_radius).is_none() {
            return Err(("its faces do not come to the rim", &[]));
        }
        if let Mouth::LeadIn { length, flare } = mouth
            && flare > length
        {
            return Err(("it opens by more than its own length", &[]));
        }
        if with.mouth_length() > self.longest_mouth() {
            return Err(("it takes more than half of the wall that drives the wheel", &[]));
        }
        if with.corner_angle() >= with.tip_angle() {
            return Err(("it takes the rim as far as the end of the locking arc", &[ThickerHorn, ThinnerPin]));
        }
        let least = LEAST_HORN * self.pin_diameter;
        if with.mouth_horn().is_some_and(|horn| horn < least) {
            return Err(("it leaves the horn thinner than a tenth of the pin", &[ThickerHorn, ThinnerPin]));
        }
        Ok(())
    }
}
