//! What a maker should know before the parts are made.

use super::design::WheelDesign;
use super::kind::AnyWheel;
use super::pin_load::weaknesses;
use crate::Error;
use geneva_kinematics::wheel::Warning;

/// Stations up to which parts can be made: the same as are proposed for times.
const MOST_MADE: u32 = 60;

impl WheelDesign {
    /// What a maker should know about sizes that do fit: what is wrong with them, with the place of the axes, and with the play
    /// that the program chose.
    ///
    /// # Errors
    ///
    /// A distance of the axes at which the parts can't work together.
    pub fn warnings(&self) -> Result<Vec<String>, Error> {
        let Some(sizes) = &self.sizes else { return Ok(Vec::new()) };
        let chosen = self.question.play.is_none();
        let loose = sizes.looser_than_fit().filter(|_| chosen && self.question.process.is_none());
        let is_usual = |warning: &Warning| {
            let is_large = matches!(warning, Warning::LargePlay { .. } | Warning::LargeBacklash { .. });
            chosen && self.question.process.is_some() && is_large
        };
        let of_sizes = sizes.warnings().into_iter().filter(|warning| !is_usual(warning)).chain(loose);
        let of_sizes = of_sizes.map(|warning| warning.to_string());
        // Parts without play touch; only what is deeper than the tolerance is an overlap.
        let overlaps = self.clearance()?.is_some_and(|(nearest, tolerance)| nearest.distance < -tolerance);
        let error = self.centre_error();
        let placed = if overlaps {
            Some("with the axes at this distance, driver and wheel overlap; a clearance below zero says by how much")
        } else if sizes.entry(error).is_none() {
            Some("with the axes at this distance the pin does not meet the slot")
        } else {
            None
        };
        let many = (self.wheel.indexing().stations() > MOST_MADE).then(|| {
            format!(
                "with more than {MOST_MADE} stations, slots, horns and plays are too fine to be made: take this as geometry"
            )
        });
        let weak = match &self.wheel {
            AnyWheel::External(wheel) => weaknesses(self, wheel)?,
            AnyWheel::Internal(_) | AnyWheel::Spherical(_) => Vec::new(),
        };
        Ok(placed.map(str::to_owned).into_iter().chain(of_sizes).chain(weak).chain(many).collect())
    }
}
