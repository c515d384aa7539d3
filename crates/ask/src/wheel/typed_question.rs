//! A question about a wheel as it is typed: arguments with their values, lengths in millimetres or inches.

use super::arguments::{Argument, ArgumentSlot, NamedChoice, arguments};
use super::kind::WheelKind;
use super::question::WheelQuestion;
use crate::{Error, number, pairs};
use geneva_dynamics::line_contact::MATERIALS;
use geneva_kinematics::wheel::as_built::Process;
use std::borrow::Cow;

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

/// A length in millimetres: a number, or one in inches, `2.5in` or `1-1/2in`.
///
/// # Errors
///
/// What is no number.
pub(super) fn length(name: &str, text: &str) -> Result<f64, Error> {
    let (text, unit) = in_millimetres(text);
    number::<f64>(name, &text).map(|value| value * unit)
}

/// A length as it is typed, without its unit, and the millimetres of that unit: `2.5in`, `2.5"`, `1/8in`, `1-1/2in`, `8mm` or `8`.
/// A fraction of an inch becomes a decimal number; one without a unit is left as it is, and is no number.
///
/// ```
/// use geneva_ask::wheel::in_millimetres;
///
/// assert_eq!(in_millimetres("0.5in"), ("0.5".into(), 25.4)); // mm
/// assert_eq!(in_millimetres("1-1/2in"), ("1.5".into(), 25.4));
/// assert_eq!(in_millimetres("8"), ("8".into(), 1.0));
/// ```
pub fn in_millimetres(text: &str) -> (Cow<'_, str>, f64) {
    const INCH: f64 = 25.4;
    let without = |units: &[&str]| units.iter().find_map(|unit| text.trim().strip_suffix(unit)).map(str::trim_end);
    match without(&["in", "\"", "″"]) {
        Some(inches) => (fraction(inches).map_or(inches.into(), |inches| inches.to_string().into()), INCH),
        None => (without(&["mm"]).unwrap_or(text).into(), 1.0),
    }
}

/// The value of `1/8`, `1-1/2` or `1 1/2`, with a sign or without; none of anything else.
fn fraction(text: &str) -> Option<f64> {
    let (sign, size) = match text.strip_prefix(['-', '−']) {
        Some(size) => (-1.0, size),
        None => (1.0, text),
    };
    let (above, below) = size.split_once('/')?;
    let (whole, above) = above.trim().split_once(['-', ' ']).unwrap_or(("0", above));
    let [whole, above, below] = [whole, above, below].map(|digits| digits.trim().parse::<u32>().ok());
    let below = below.filter(|below| *below > 0)?;
    Some(sign * (f64::from(whole?) + f64::from(above?) / f64::from(below)))
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
    use super::{ArgumentSlot, NamedChoice, WheelQuestion, arguments, length};
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
            let given = GIVEN.iter().filter(|(_, gives)| !gives.are_met_by(left_out));
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
    fn inches_are_decimal_numbers_or_fractions() {
        // Sixty-fourths are exact in binary, so the closed form is, too.
        let right = [
            ("1in", 1.0),
            ("0.5in", 0.5),
            ("1/8in", 0.125),
            ("1-1/2in", 1.5),
            ("1 1/2 in", 1.5),
            ("-3/64\"", -0.046_875),
            ("−1/4″", -0.25),
        ];
        for (text, inches) in right {
            assert_eq!(length("crank-radius", text).expect(text), inches * 25.4, "{text}");
        }
        assert_eq!(length("crank-radius", "8mm").expect("millimetres"), 8.0);
        for text in ["1/8", "1/8mm", "1/0in", "1/in", "/8in", "1/2/4in", "1.5/8in", "1--1/2in", "in"] {
            let error = length("crank-radius", text).expect_err(text);
            assert!(error.to_string().starts_with("--crank-radius"), "{error}");
        }
        let question = WheelQuestion::parse("--crank-radius 1-1/2in --play 1/64in").expect("inches");
        assert_eq!((question.crank_radius, question.play), (Some(1.5 * 25.4), Some(25.4 / 64.0)));
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
