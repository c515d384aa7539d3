//! The mouths of the slots of a wheel that exists, as they are typed.

use super::arguments::{Argument, ArgumentSlot};
use super::design::WheelDesign;
use super::mouth::{asked_mouth, check_mouth, mouth_arguments};
use super::question::WheelQuestion;
use crate::number_format::as_typed;
use crate::typed_number::length;
use crate::{Error, number};
use geneva_kinematics::wheel::Mouth;

/// What is said of the mouths: arguments with their numbers, lengths in millimetres and angles in degrees.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct TypedMouth(Vec<(&'static str, f64)>);

impl TypedMouth {
    /// Takes an argument as it is typed; false if it is none of a mouth.
    ///
    /// # Errors
    ///
    /// What is no number, or one that makes no sense.
    pub(super) fn set(&mut self, name: &str, text: &str) -> Result<bool, Error> {
        let Some(argument) = mouth_arguments().find(|argument| argument.name == name) else { return Ok(false) };
        if text.contains("+-") || text.contains('±') {
            return Err(refused!("--{name} {text}: a mouth is taken as it is; give its size without an uncertainty"));
        }
        let value = match argument.place {
            ArgumentSlot::Length(_) | ArgumentSlot::LengthOrZero(_) => length(name, text)?,
            _ => number(name, text)?,
        };
        let is_possible = value >= 0.0 && argument.makes_sense(value);
        if let Some([least, most]) = argument.range().filter(|_| !is_possible) {
            let (least, most) = (as_typed(least), as_typed(most));
            return Err(refused!("--{name} {text}: that makes no sense; give --{name} from {least} to {most}"));
        }
        self.0.retain(|(other, _)| *other != argument.name);
        self.0.push((argument.name, value));
        Ok(true)
    }

    /// Whether anything is said.
    pub(super) fn is_given(&self) -> bool {
        !self.0.is_empty()
    }

    /// The mouth.
    ///
    /// # Errors
    ///
    /// Two shapes for one mouth, and sizes of a shape that is not given.
    pub(super) fn shape(&self) -> Result<Mouth, Error> {
        let value =
            |argument: &Argument| self.0.iter().find(|(name, _)| *name == argument.name).map(|(_, value)| *value);
        let asked = mouth_arguments().fold(WheelQuestion::default(), |asked, argument| {
            asked.with_number(argument, value(argument)).unwrap_or(asked)
        });
        check_mouth(&asked)?;
        Ok(asked_mouth(&asked).unwrap_or(Mouth::Sharp))
    }

    /// These arguments of `geneva wheel` with those of the mouth, if a wheel can be designed so; else as they are.
    pub(super) fn beside(&self, arguments: &str) -> String {
        if self.shape() == Ok(Mouth::Sharp) {
            return arguments.to_owned();
        }
        let with = self
            .0
            .iter()
            .fold(arguments.to_owned(), |with, (name, value)| format!("{with} --{name} {}", as_typed(*value)));
        if WheelQuestion::parse(&with).and_then(WheelDesign::new).is_ok() { with } else { arguments.to_owned() }
    }
}

#[cfg(test)]
mod tests {
    use crate::wheel::CheckQuestion;
    use crate::{FieldValue, MechanismReport};

    /// A right wheel of six stations for axes 100 mm apart, with axes a little too far apart, so that the pin comes in on a corner.
    const FAR_AXES: &str = "--stations 6 --centre-distance 100.3 --crank-radius 50 --outside-diameter 173.52 --pin-diameter 10 --slot-width 10.3 \
                             --locking-disc-radius 34.5 --locking-arc-radius 34.85 --slot-end 49.5";

    #[test]
    fn measured_mouths_change_entry_and_blow_and_are_in_the_design() {
        let asked = |more: &str| CheckQuestion::parse(&format!("{FAR_AXES} {more}")).expect(more).answer().expect(more);
        let number =
            |report: &MechanismReport, key: &str| report.field(key).and_then(|field| field.number()).expect(key);
        let sharp = asked("");
        assert_eq!(sharp.field("lands_on_corner").map(|field| &field.value), Some(&FieldValue::Flag(true)));
        assert!(sharp.note.contains("give --mouth-chamfer, --mouth-radius or --lead-in"), "{}", sharp.note);
        for mouth in ["--mouth-chamfer 3 --mouth-angle 20", "--mouth-radius 3", "--lead-in 8 --lead-in-flare 0.8"] {
            let with = asked(mouth);
            assert!(number(&with, "greatest_blow_ratio") < number(&sharp, "greatest_blow_ratio"), "{mouth}");
            assert!(with.note.contains("mouths that are given"), "{}", with.note);
            assert_ne!(with.field("lost_motion_deg"), sharp.field("lost_motion_deg"), "{mouth}");
        }
        assert_eq!(asked("--mouth-chamfer 0").fields().collect::<Vec<_>>(), sharp.fields().collect::<Vec<_>>());
        // New parts get the mouths that were measured.
        let worn = CheckQuestion::parse(
            "--stations 6 --centre-distance 100 --crank-radius 50 --outside-diameter 173.52 --pin-diameter 10 --slot-width 12 --new-slot-width \
             10.1 --mouth-chamfer 1",
        );
        let report = worn.expect("sizes").answer().expect("a wheel");
        let commands = format!("{:?}", report.field("design_commands"));
        assert!(commands.contains("--mouth-chamfer 1"), "{commands}");
        for (mouth, said) in [
            ("--mouth-chamfer 1 --mouth-radius 1", "a mouth has one shape"),
            ("--mouth-angle 30", "has no effect without --mouth-chamfer"),
            ("--mouth-chamfer 1+-0.1", "without an uncertainty"),
            ("--mouth-chamfer -1", "give --mouth-chamfer from"),
            ("--mouth-chamfer 80", "chamfer of the mouths 80 mm: it must be at most"),
            ("--lead-in 1 --lead-in-flare 2", "flare of the lead-in 2 mm: it must be at most 1 mm"),
        ] {
            let refused = CheckQuestion::parse(&format!("{FAR_AXES} {mouth}")).and_then(|question| question.answer());
            let words = refused.expect_err(mouth).to_string();
            assert!(words.contains(said), "{mouth}: {words}");
        }
    }
}
