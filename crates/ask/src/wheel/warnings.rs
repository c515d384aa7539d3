//! What a maker should know before the parts are made.

use super::design::WheelDesign;
use super::drive::droop_warning;
use super::kind::AnyWheel;
use super::masses::Rim;
use super::pin_load::weaknesses;
use crate::Error;
use crate::number_format::{as_typed, number, rounded_down};
use crate::worked::DriverSpeed;
use geneva_kinematics::wheel::as_built::Process;
use geneva_kinematics::wheel::{Sizes, Warning};
use geneva_workshop::ThinWall;

/// Stations up to which parts can be made: the same as are proposed for times.
const MOST_MADE: u32 = 60;
/// Thickness in millimetres of the thickest sheet that a laser cuts without a warning: our choice.
const LASER_SHEET: f64 = 12.0;
/// Pascals of a megapascal.
const MEGA: f64 = 1e6;

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
        let placed = self.misplacement(sizes)?;
        let many = (self.wheel.indexing().stations() > MOST_MADE).then(|| {
            format!(
                "with more than {MOST_MADE} stations, slots, horns and plays are too fine to be made: take this as geometry"
            )
        });
        let weak = match &self.wheel {
            AnyWheel::External(wheel) => weaknesses(self, wheel)?,
            AnyWheel::Internal(_) | AnyWheel::Spherical(_) => Vec::new(),
        };
        let shape = self.thick_wheel(sizes).into_iter().chain(self.fast_rim(sizes)).chain(self.thick_sheet());
        Ok(placed.into_iter().chain(of_sizes).chain(self.loose_parts()).chain(weak).chain(shape).chain(many).collect())
    }

    /// All that the sheet says to know before the parts are made, in its order: these warnings, what it says of the motor, why too few
    /// assemblies turn as far as that is known, and walls that are thin.
    ///
    /// # Errors
    ///
    /// As for [`warnings`](Self::warnings), and what can't be made.
    pub fn warnings_with_cause(&self, cause: Option<String>) -> Result<Vec<String>, Error> {
        let thin = self.makeable_parts()?.map(|list| list.thin_walls).unwrap_or_default();
        let mut found = self.warnings()?;
        found.extend(droop_warning(self)?);
        found.extend(cause);
        found.extend(thin.iter().map(ThinWall::to_string));
        Ok(found)
    }

    /// What is odd about the thickness; none of a wheel that is a disc.
    fn thick_wheel(&self, sizes: &Sizes) -> Option<String> {
        let (thickness, across) = (self.thickness?, 2.0 * sizes.tip_radius);
        (thickness > across).then(|| {
            format!(
                "--thickness {}: the wheel would be thicker than the {} mm that it is wide; give how thick its disc is",
                as_typed(thickness),
                number(across)
            )
        })
    }

    /// The sheet that is too thick for a laser; none of parts that are made otherwise.
    fn thick_sheet(&self) -> Option<String> {
        let is_laser = self.question.process == Some(Process::Laser);
        let thickness = self.thickness.filter(|thickness| is_laser && *thickness > LASER_SHEET)?;
        let chosen =
            if self.question.thickness.is_some() { "" } else { " (as thick as the pin, because none was given)" };
        Some(format!(
            "the sheet would be {} mm thick{chosen}, and few lasers cut more than {} mm: give --thickness as that of your sheet, \
             or build the wheel up from several sheets",
            as_typed(thickness),
            as_typed(LASER_SHEET)
        ))
    }

    /// The stress from spinning alone, where it is more than the material bears.
    fn fast_rim(&self, sizes: &Sizes) -> Option<String> {
        let speed = self.speed()?.abs();
        let [wheel, plate] = self.rims(sizes.tip_radius, sizes.plate_radius);
        let (part, rim) = if wheel.most() < plate.most() { ("wheel", wheel) } else { ("driver's plate", plate) };
        let Rim { reach, material } = rim;
        let rim_speed = speed * reach;
        let stress = material.density * rim_speed * rim_speed;
        (speed > rim.most()).then(|| {
            let most = DriverSpeed::RadiansPerSecond(rim.most()).rpm();
            format!(
                "the rim of the {part} runs at {} m/s, which alone stresses it with up to {} MPa, more than the {} MPa that the material \
                 {} bears: stay below {} turns per minute, or make it smaller",
                number(rim_speed),
                number(stress / MEGA),
                number(material.strength / MEGA),
                material.name,
                rounded_down(most)
            )
        })
    }

    /// What is wrong with the place of the axes; none where it is within its limits.
    fn misplacement(&self, sizes: &Sizes) -> Result<Option<String>, Error> {
        let error = self.centre_error();
        if error == 0.0 {
            return Ok(None);
        }
        // Parts without play touch; only what is deeper than the tolerance is an overlap.
        let overlaps = self.clearance()?.is_some_and(|(nearest, tolerance)| nearest.distance < -tolerance);
        let what = if sizes.entry(error).is_none() {
            "with the axes at this distance the pin does not meet the slot"
        } else if overlaps {
            "with the axes at this distance, driver and wheel overlap; a clearance below zero says by how much"
        } else {
            "with the axes at this distance the pin does not pass the corners of its slot freely"
        };
        let tolerance = self.centre_tolerance()?;
        let limit = tolerance.map(|tolerance| if error > 0.0 { tolerance.farther } else { tolerance.nearer });
        let sense = if error > 0.0 { "farther apart" } else { "nearer" };
        Ok(match limit {
            Some(limit) if error.abs() > limit => Some(format!(
                "--centre-error {}: {what}. The axes may be {} mm {sense}",
                as_typed(error),
                rounded_down(limit)
            )),
            // What takes too long to find is not known to be kept.
            None if overlaps || sizes.entry(error).is_none() => Some(what.to_owned()),
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::{FieldValue, answer};

    fn warnings(question: &str) -> String {
        let report = answer(question).expect("an answer");
        match &report.field("warnings").expect("warnings").value {
            FieldValue::List(all) => all
                .iter()
                .map(|one| if let FieldValue::Text(text) = one { text.as_str() } else { "" })
                .collect::<Vec<_>>()
                .join("\n"),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_wheel_that_would_burst_or_is_thicker_than_wide_is_warned_of_with_a_limit_that_helps() {
        let fast = warnings("wheel --stations 6 --crank-radius 50 --rpm 120000");
        let (_, most) = fast.split_once("stay below ").expect(&fast);
        let (most, _) = most.split_once(' ').expect("a unit");
        let slower = warnings(&format!("wheel --stations 6 --crank-radius 50 --rpm {most}"));
        assert!(!slower.contains("stay below"), "{slower}");
        assert!(!warnings("wheel --stations 6 --crank-radius 50 --rpm 1000").contains("stay below"));
        let thick = warnings("wheel --stations 6 --crank-radius 25 --thickness 500");
        assert!(thick.contains("--thickness 500: the wheel would be thicker than"), "{thick}");
        assert!(!warnings("wheel --stations 6 --crank-radius 25 --thickness 50").contains("--thickness"));
    }

    #[test]
    fn a_sheet_that_few_lasers_cut_is_warned_of_whoever_chose_it() {
        let laser = |more: &str| warnings(&format!("wheel --stations 6 --crank-radius 60 --process laser {more}"));
        assert!(
            laser("").contains("(as thick as the pin, because none was given), and few lasers cut"),
            "{}",
            laser("")
        );
        assert!(laser("--thickness 40").contains("the sheet would be 40 mm thick, and few lasers cut"));
        assert!(!laser("--thickness 6").contains("few lasers"));
        assert!(!warnings("wheel --stations 6 --crank-radius 60 --process mill --thickness 40").contains("few lasers"));
    }

    #[test]
    fn every_error_of_the_axes_beyond_its_limit_is_warned_of() {
        let of = |error: f64| warnings(&format!("wheel --stations 6 --crank-radius 25 --centre-error {error}"));
        // The limits of this wheel are 0.02 mm and 0.049 mm.
        for error in [-5.0, -0.1, -0.03, 0.06, 0.1, 3.5, 4.0, 4.5, 5.0, 10.0, 12.0] {
            assert!(of(error).contains(&format!("--centre-error {error}: ")), "{error}: {}", of(error));
        }
        for error in [-0.01, 0.0, 0.02, 0.04] {
            assert!(!of(error).contains("--centre-error"), "{error}: {}", of(error));
        }
    }
}
