//! A question about a wheel as it is typed: arguments with their values, lengths in millimetres or with their unit.

use super::arguments::{Argument, ArgumentSlot, NamedChoice, arguments};
use super::kind::WheelKind;
use super::question::WheelQuestion;
use crate::typed_number::length;
use crate::{Error, number, pairs};
use geneva_dynamics::line_contact::MATERIALS;
use geneva_kinematics::wheel::as_built::Process;

impl WheelQuestion {
    /// Reads arguments as they are typed: `--stations 6 --rpm 60`. With `--out DIR`, a wheel without a size gets the recommended one.
    ///
    /// # Errors
    ///
    /// An argument that there is not, with all that there are, and a value that it can't have.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let mut question = Self::default();
        for pair in pairs(text) {
            let (argument, value) = pair?;
            question.set(argument, value)?;
        }
        Ok(question)
    }

    fn set(&mut self, name: &str, value: &str) -> Result<(), Error> {
        match name {
            "before-entry" => self.before_entry = Some(number(name, value)?),
            // The command chooses a size where it writes all files.
            "out" => self.recommends_size = true,
            _ => {
                let known = arguments().find(|argument| argument.name == name).ok_or_else(|| {
                    let names = arguments().map(|argument| argument.name).collect::<Vec<_>>().join(", --");
                    refused!("no argument --{name}; there are --{names}")
                })?;
                match known.place {
                    ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) => *at(self) = Some(number(name, value)?),
                    ArgumentSlot::Kind(at) => {
                        *at(self) = Some(one_of(name, value, &WheelKind::ALL.map(|kind| (kind.name(), kind)))?)
                    }
                    ArgumentSlot::Length(at) | ArgumentSlot::LengthOrZero(at) | ArgumentSlot::SignedLength(at) => {
                        *at(self) = Some(length(name, value)?)
                    }
                    ArgumentSlot::AboveZero(at) | ArgumentSlot::ZeroOrMore(at) => {
                        *at(self) = Some(number(name, value)?)
                    }
                    ArgumentSlot::Count(at) => *at(self) = Some(number(name, value)?),
                    ArgumentSlot::Choice(NamedChoice { names, set, .. }) => {
                        let numbered: Vec<(&str, usize)> = names.iter().copied().zip(0..).collect();
                        set(self, one_of(name, value, &numbered)?);
                    }
                    ArgumentSlot::Process(at) => {
                        *at(self) = Some(one_of(name, value, &Process::ALL.map(|process| (process.name(), process)))?);
                    }
                    ArgumentSlot::Material(at) => {
                        *at(self) = Some(one_of(name, value, &MATERIALS.map(|material| (material.name, material)))?);
                    }
                    ArgumentSlot::Degrees(at) => at(self).push(number(name, value)?),
                }
            }
        }
        Ok(())
    }

    /// The arguments with a number that were given; of repeated ones the first.
    pub fn numbers(&self) -> Vec<(Argument, f64)> {
        let mut copy = self.clone();
        arguments().filter_map(|argument| Some((*argument, copy.number_at(argument)?))).collect()
    }

    /// The number that was given for an argument, in its own unit; of repeated ones the first.
    pub(super) fn number(&self, argument: &Argument) -> Option<f64> {
        self.clone().number_at(argument)
    }

    /// What [`number`](Self::number) says, without a copy; nothing is changed.
    fn number_at(&mut self, argument: &Argument) -> Option<f64> {
        match argument.place {
            ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) | ArgumentSlot::Count(at) => at(self).map(f64::from),
            ArgumentSlot::Length(at)
            | ArgumentSlot::LengthOrZero(at)
            | ArgumentSlot::SignedLength(at)
            | ArgumentSlot::AboveZero(at)
            | ArgumentSlot::ZeroOrMore(at) => *at(self),
            ArgumentSlot::Degrees(at) => at(self).first().copied(),
            ArgumentSlot::Kind(_) | ArgumentSlot::Process(_) | ArgumentSlot::Choice(_) | ArgumentSlot::Material(_) => {
                None
            }
        }
    }

    /// The question with another number for an argument, in its own unit, or without it; none of an argument that is no such number.
    pub(super) fn with_number(&self, argument: &Argument, value: Option<f64>) -> Option<Self> {
        let mut other = self.clone();
        match argument.place {
            ArgumentSlot::Length(at)
            | ArgumentSlot::LengthOrZero(at)
            | ArgumentSlot::SignedLength(at)
            | ArgumentSlot::AboveZero(at)
            | ArgumentSlot::ZeroOrMore(at) => *at(&mut other) = value,
            _ => return None,
        }
        Some(other)
    }
}

fn one_of<T: Copy>(name: &str, text: &str, all: &[(&str, T)]) -> Result<T, Error> {
    let found = all.iter().find(|(known, _)| *known == text).map(|(_, found)| *found);
    found.ok_or_else(|| {
        let names = all.iter().map(|(known, _)| *known).collect::<Vec<_>>().join(", ");
        refused!("--{name} {text}: give one of {names}")
    })
}

#[cfg(test)]
mod tests {
    use super::{ArgumentSlot, NamedChoice, WheelQuestion, arguments};
    use crate::{FieldValue, Needs, ReportField, answer, further};
    use std::collections::BTreeMap;

    /// Every argument that a value may need, by what it gives.
    const GIVEN: [(&str, Needs); 23] = [
        ("--rpm 60", Needs::SPEED),
        ("--crank-radius 25", Needs::SIZE),
        ("--table-mass 1", Needs::TABLE.union(Needs::TABLE_INERTIA)),
        ("--table-diameter 100", Needs::TABLE.union(Needs::TABLE_INERTIA)),
        ("--friction-torque 0.0001", Needs::FRICTION_TORQUE),
        ("--pins 2", Needs::SECOND_PIN),
        ("--pin-friction 0.15", Needs::PIN_FRICTION),
        ("--before-entry 20", Needs::BEFORE_ENTRY),
        ("--wheel-shaft 6", Needs::WHEEL_SHAFT),
        ("--driver-shaft 2", Needs::DRIVER_SHAFT),
        ("--thickness 10", Needs::SIZE),
        ("--process mill", Needs::PROCESS),
        ("--disc-friction 0.1", Needs::DISC_FRICTION),
        ("--bearing-friction 0.01 --wheel-bearing 10 --driver-bearing 10", Needs::BEARING_FRICTION),
        ("--driver-friction 0.001", Needs::DRIVER_FRICTION),
        ("--held-torque 0.01", Needs::HELD_TORQUE),
        ("--arm-torque 1", Needs::ARM_TORQUE),
        ("--driver-inertia 0.001", Needs::DRIVER_INERTIA),
        ("--drive-torque 1", Needs::DRIVE_TORQUE),
        ("--gear-ratio 10", Needs::GEAR_RATIO),
        ("--wheel-flat 5", Needs::WHEEL_FLAT),
        ("--driver-flat 1.5", Needs::DRIVER_FLAT),
        ("--pin-screw M3 --pin-screw-hole tapped --pin-diameter 3", Needs::PIN_SCREW),
    ];

    /// The fields of the answer and the further ones, by their keys, to a question with these arguments.
    fn fields(arguments: impl Iterator<Item = &'static str>) -> BTreeMap<&'static str, ReportField> {
        let question = arguments.fold("wheel --stations 6".to_owned(), |question, argument| question + " " + argument);
        let (report, further) = (answer(&question).expect(&question), further(&question).expect(&question));
        report.fields().cloned().chain(further).map(|field| (field.key, field)).collect()
    }

    #[test]
    fn a_value_is_missing_just_where_something_that_it_needs_is_not_given() {
        let all = fields(GIVEN.iter().map(|(argument, _)| *argument));
        let each = GIVEN.map(|(_, left_out)| left_out);
        // Without both there is no inertia at all.
        let none = Needs::TABLE.union(Needs::TABLE_INERTIA).union(Needs::SIZE).union(Needs::INERTIA);
        let mut lost = 0;
        for left_out in each.into_iter().chain([Needs::NONE, none]) {
            // A flat without its shaft is refused.
            let has_shaft = |gives: Needs| {
                [(Needs::WHEEL_FLAT, Needs::WHEEL_SHAFT), (Needs::DRIVER_FLAT, Needs::DRIVER_SHAFT)]
                    .iter()
                    .all(|(flat, shaft)| gives != *flat || !shaft.are_met_by(left_out))
            };
            let given = GIVEN.iter().filter(|(_, gives)| !gives.are_met_by(left_out) && has_shaft(*gives));
            let some = fields(given.map(|(argument, _)| *argument));
            for (key, field) in &all {
                let value = some.get(key).map_or(&FieldValue::Missing, |field| &field.value);
                let is_given = field.needs.difference(left_out) == field.needs;
                assert_eq!(*value != FieldValue::Missing, is_given, "{key} without {left_out:?}: {value:?}");
                lost += usize::from(!is_given);
            }
        }
        assert!(lost > 100, "only {lost} values are missing without what they need");
    }

    #[test]
    fn lengths_may_have_units() {
        let question = WheelQuestion::parse("--crank-radius 1-1/2in --play 1/64in --thickness 1cm").expect("units");
        let lengths = (question.crank_radius, question.play, question.thickness);
        assert_eq!(lengths, (Some(1.5 * 25.4), Some(25.4 / 64.0), Some(10.0)));
    }

    #[test]
    fn each_argument_sets_the_field_of_its_name() {
        for argument in arguments() {
            let (value, set) = match argument.place {
                ArgumentSlot::Kind(_) => ("spherical", "kind: Some(Spherical)".to_owned()),
                ArgumentSlot::Count(_) => ("7", format!("{}: Some(7)", argument.name)),
                ArgumentSlot::Choice(NamedChoice { names, .. }) => {
                    let said = |name: &str| {
                        let question = WheelQuestion::parse(&format!("--{} {name}", argument.name)).expect("a choice");
                        format!("{question:?}")
                    };
                    assert_ne!(said(names[0]), said(names[1]), "--{}", argument.name);
                    continue;
                }
                ArgumentSlot::Process(_) => ("resin", "process: Some(Resin)".to_owned()),
                ArgumentSlot::Material(_) => ("acetal", format!("{}: Some(Material", argument.name)),
                ArgumentSlot::Stations(_) | ArgumentSlot::Pins(_) => ("7", format!("{}: Some(7)", argument.name)),
                ArgumentSlot::Degrees(_) => ("7", format!("{}: [7.0]", argument.name)),
                _ => ("7", format!("{}: Some(7.0)", argument.name)),
            };
            let question = WheelQuestion::parse(&format!("--{} {value}", argument.name)).expect("an argument");
            let set = format!(" {}", set.replace('-', "_"));
            assert!(format!("{question:?}").contains(&set), "--{}: no{set}", argument.name);
        }
    }
}
