//! A question about a wheel: what was said of it, however it was said.

use super::arguments::{Argument, ArgumentSlot, NamedChoice, arguments};
use super::kind::WheelKind;
use super::mounting::MountingQuestion;
use crate::worked::DriverSpeed;
use crate::{Error, number, pairs};
use geneva_dynamics::line_contact::{MATERIALS, Material};
use geneva_kinematics::wheel::as_built::Process;
use std::borrow::Cow;

/// What is asked of a wheel: the arguments have the names of the fields, `--crank-radius 25`. Lengths are in millimetres.
#[derive(Clone, Debug, Default)]
pub struct WheelQuestion {
    /// Kind of wheel (`--type`); external unless it is given.
    pub kind: Option<WheelKind>,
    /// Number of slots.
    pub stations: Option<u32>,
    /// Number of pins on the driver; 1 unless it is given.
    pub pins: Option<u32>,
    /// Speed of the driver in turns per minute: this or one of the next three.
    pub rpm: Option<f64>,
    /// Speed of the driver in radians per second.
    pub rad_s: Option<f64>,
    /// Time of an index in seconds.
    pub index_time: Option<f64>,
    /// Time of a dwell in seconds.
    pub dwell_time: Option<f64>,
    /// Turn of the driver in a dwell in degrees, for the wheels that come nearest.
    pub dwell_angle: Option<f64>,
    /// Distance from the driver's axis to a pin's centre: this or one of the next three gives sizes.
    pub crank_radius: Option<f64>,
    /// Distance between the two axes.
    pub centre_distance: Option<f64>,
    /// Distance from the wheel's axis to a pin's centre as the pin enters.
    pub wheel_radius: Option<f64>,
    /// Diameter of the wheel over the corners of its slots.
    pub outside_diameter: Option<f64>,
    /// Thickness of the wheel.
    pub thickness: Option<f64>,
    /// How the parts are made.
    pub process: Option<Process>,
    /// Least play with which the pin ran on the test piece of the process.
    pub measured_play: Option<f64>,
    /// Diameter of the pins.
    pub pin_diameter: Option<f64>,
    /// How much wider slots and locking arcs are than the parts that run in them.
    pub play: Option<f64>,
    /// Width of the slots, which gives their play.
    pub slot_width: Option<f64>,
    /// How much wider the locking arcs are than the locking disc, as a difference of diameters; as the play of the slots unless
    /// it is given.
    pub locking_play: Option<f64>,
    /// How much wider the bores are than the shafts.
    pub bore_play: Option<f64>,
    /// Gap between wheel and plate along the axes; as the play of the slots unless it is given.
    pub axial_play: Option<f64>,
    /// Least thickness of the wheel between a slot and a locking arc.
    pub horn: Option<f64>,
    /// Radius of the locking arcs, which gives the horn.
    pub locking_arc_radius: Option<f64>,
    /// How much deeper the slots are than the pins need.
    pub bottom_clearance: Option<f64>,
    /// How much of each wall of a slot a chamfer takes at its mouth: this or one of the next but one.
    pub mouth_chamfer: Option<f64>,
    /// Angle of the chamfer to the wall in degrees.
    pub mouth_angle: Option<f64>,
    /// Radius of rounded mouths of the slots.
    pub mouth_radius: Option<f64>,
    /// How much of each wall of a slot a lead-in takes at its mouth.
    pub lead_in: Option<f64>,
    /// How far the lead-in has left the wall at the wheel radius.
    pub lead_in_flare: Option<f64>,
    /// Diameter of the wheel's shaft.
    pub wheel_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plane of the wheel.
    pub driver_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plate, if it ends there; that in the plane of the wheel unless it is given.
    pub plate_shaft: Option<f64>,
    /// Holes for mounting, and what the files have besides wheel and driver.
    pub mounting: MountingQuestion,
    /// By how much the axes are too far apart, for clearance and knock.
    pub centre_error: Option<f64>,
    /// Mass in kg of a round table that turns with the wheel.
    pub table_mass: Option<f64>,
    /// Diameter of that table.
    pub table_diameter: Option<f64>,
    /// Moment of inertia, in kg m², of everything that turns with the wheel, without the wheel itself.
    pub inertia: Option<f64>,
    /// Moment of inertia, in kg m², of the wheel and everything that turns with it.
    pub total_inertia: Option<f64>,
    /// Density of the wheel in kg/m³; that of its material unless it is given.
    pub density: Option<f64>,
    /// Torque of the friction that brakes the wheel, in N m.
    pub friction_torque: Option<f64>,
    /// Coefficient of friction of a pin in its slot.
    pub pin_friction: Option<f64>,
    /// Coefficient of friction of the locking disc in its arc.
    pub disc_friction: Option<f64>,
    /// Coefficient of friction of the bearings of wheel and driver.
    pub bearing_friction: Option<f64>,
    /// Diameter at which the wheel's bearing rubs; that of the wheel's shaft unless it is given.
    pub wheel_bearing: Option<f64>,
    /// Diameter at which the driver's bearing rubs; that of the driver's shaft unless it is given.
    pub driver_bearing: Option<f64>,
    /// Constant torque of friction on the driver, in N m.
    pub driver_friction: Option<f64>,
    /// Torque in N m that turns the wheel while it should stand, as of a table out of balance.
    pub held_torque: Option<f64>,
    /// Overload torque on the driver's arm, in N m, for the strength of the pin.
    pub arm_torque: Option<f64>,
    /// Moment of inertia, in kg m², of the driver and all that turns with it.
    pub driver_inertia: Option<f64>,
    /// Torque in N m with which the driver is started.
    pub drive_torque: Option<f64>,
    /// Turns of the motor in a turn of the driver.
    pub gear_ratio: Option<f64>,
    /// Modulus of the pins in GPa, instead of that of their material.
    pub pin_modulus: Option<f64>,
    /// Poisson's ratio of the pins, instead of that of their material.
    pub pin_poisson: Option<f64>,
    /// Strength of the pins in MPa, instead of that of their material.
    pub pin_strength: Option<f64>,
    /// Modulus of the wheel in GPa, instead of that of its material.
    pub wheel_modulus: Option<f64>,
    /// Poisson's ratio of the wheel, instead of that of its material.
    pub wheel_poisson: Option<f64>,
    /// Strength of the wheel in MPa, instead of that of its material.
    pub wheel_strength: Option<f64>,
    /// Allowed pressure between pin and slot in MPa, instead of that at which one of them begins to yield.
    pub allowed_pressure: Option<f64>,
    /// Material of the pins.
    pub pin_material: Option<Material>,
    /// Material of the wheel.
    pub wheel_material: Option<Material>,
    /// Crank angles, in degrees, at which to report the motion.
    pub at: Vec<f64>,
    /// Wheel angles, in degrees from the middle of an index, at which to report the motion.
    pub at_wheel: Vec<f64>,
    /// Degrees of the crank before a pin enters, for the backlash there; it has no name at the command line.
    pub before_entry: Option<f64>,
    /// Whether an external wheel without a size gets the one that suits its load.
    pub recommends_size: bool,
    /// How long clearances are looked for.
    pub effort: SearchEffort,
}

/// Crank angles at which clearances are looked for at most. Where the play is so small against the parts that more are needed,
/// the numbers are missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SearchEffort {
    /// For the least clearance.
    pub clearance: u32,
    /// For each of the clearances that give the tolerance of the axes.
    pub tolerance: u32,
}

impl Default for SearchEffort {
    /// A few seconds at most.
    fn default() -> Self {
        Self { clearance: 4_000_000, tolerance: 400_000 }
    }
}

impl WheelQuestion {
    /// The speed of the driver, if it is given as such and not as a time.
    pub fn speed(&self) -> Option<DriverSpeed> {
        self.rpm.map(DriverSpeed::Rpm).or(self.rad_s.map(DriverSpeed::RadiansPerSecond))
    }

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
                    ArgumentSlot::Choice(NamedChoice { names, set }) => {
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
        let mut number = |argument: &Argument| match argument.place {
            ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) | ArgumentSlot::Count(at) => {
                at(&mut copy).map(f64::from)
            }
            ArgumentSlot::Length(at)
            | ArgumentSlot::LengthOrZero(at)
            | ArgumentSlot::SignedLength(at)
            | ArgumentSlot::AboveZero(at)
            | ArgumentSlot::ZeroOrMore(at) => *at(&mut copy),
            ArgumentSlot::Degrees(at) => at(&mut copy).first().copied(),
            ArgumentSlot::Kind(_) | ArgumentSlot::Process(_) | ArgumentSlot::Choice(_) | ArgumentSlot::Material(_) => {
                None
            }
        };
        arguments().filter_map(|argument| Some((*argument, number(argument)?))).collect()
    }
}

/// A shaft that was given; one of no diameter is none.
pub(super) fn given(shaft: Option<f64>) -> Option<f64> {
    shaft.filter(|diameter| *diameter != 0.0)
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
    const GIVEN: [(&str, Needs); 20] = [
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
