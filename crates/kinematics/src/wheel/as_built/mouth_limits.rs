//! Which mouths a made wheel can have.

use super::errors::BuiltError;
use super::free_angles::Assembled;
use super::parts::AsBuiltWheel;
use crate::bisection::bisect_times;
use crate::wheel::Mouth;
use std::f64::consts::FRAC_PI_2;

/// Halvings of the interval in which the greatest size of a mouth is.
const HALVINGS: u32 = 40;

impl AsBuiltWheel {
    /// Refuses mouths that are none, or leave nothing of a wall.
    ///
    /// # Errors
    ///
    /// [`BuiltError`] for a size of the mouths that is not positive and finite, or too large.
    pub(super) fn check_mouth(&self) -> Result<(), BuiltError> {
        let length = |name, asked: f64| {
            if asked > 0.0 && asked.is_finite() { Ok(asked) } else { Err(BuiltError::Length { name, asked }) }
        };
        let of = |size: f64| match self.mouth {
            Mouth::Sharp => Mouth::Sharp,
            Mouth::Chamfer { angle, .. } => Mouth::Chamfer { width: size, angle },
            Mouth::Round { .. } => Mouth::Round { radius: size },
            Mouth::LeadIn { flare, .. } => Mouth::LeadIn { length: size, flare },
        };
        let (name, asked) = match self.mouth {
            Mouth::Sharp => return Ok(()),
            Mouth::Chamfer { width, angle } => {
                if !(angle > 0.0 && angle < FRAC_PI_2) {
                    return Err(BuiltError::ChamferAngle { asked: angle });
                }
                ("chamfer of the mouths", length("chamfer of the mouths", width)?)
            }
            Mouth::Round { radius } => ("radius of the mouths", length("radius of the mouths", radius)?),
            Mouth::LeadIn { length: along, flare } => {
                let (along, asked) = (length("lead-in of the mouths", along)?, length("flare of the lead-in", flare)?);
                if asked > along {
                    return Err(BuiltError::Flare { asked, most: along });
                }
                ("lead-in of the mouths", along)
            }
        };
        let is_possible = |size: f64| {
            let mut other = self.clone();
            other.mouth = of(size);
            Assembled::new(&other).mouths().all(|mouth| mouth.is_complete())
        };
        if is_possible(asked) {
            return Ok(());
        }
        let [most, _] = bisect_times(HALVINGS, [0.0, asked], is_possible);
        Err(BuiltError::Mouth { name, asked, most })
    }
}
