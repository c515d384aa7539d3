//! One wheel: its sizes, its times, its motion and loads, its drawing and files; or which wheels have wanted times.

mod design;
mod files;
mod instant;
mod kind;
mod loads;
mod making;
mod mounting;
mod parts;
mod report;
mod speeds;
mod times;

pub use design::WheelDesign;
pub use kind::{AnyWheel, WheelKind};
pub use mounting::{BoreShape, MountingQuestion, PinKind};
pub use speeds::speeds;
pub use times::{Times, proposals};

use crate::worked::DriverSpeed;
use crate::{Error, number, pairs};
use ActsOn::{Motion, Parts, Size, Speed};
use geneva_dynamics::line_contact::{MATERIALS, Material};

/// What is asked of a wheel: the arguments have the names of the fields, `--crank-radius 25`. Lengths are in millimetres.
#[derive(Clone, Debug, Default)]
pub struct WheelQuestion {
    /// Kind of wheel (`--type`); external unless it is given.
    pub kind: Option<WheelKind>,
    /// Number of slots.
    pub stations: Option<u32>,
    /// Number of pins on the driver; 1 unless it is given.
    pub pins: Option<u32>,
    /// Distance from the driver's axis to a pin's centre: this or one of the next two gives sizes.
    pub crank_radius: Option<f64>,
    /// Distance between the two axes.
    pub centre_distance: Option<f64>,
    /// Distance from the wheel's axis to a pin's centre as the pin enters.
    pub wheel_radius: Option<f64>,
    /// Diameter of the pins.
    pub pin_diameter: Option<f64>,
    /// How much wider slots and locking arcs are than the parts that run in them.
    pub play: Option<f64>,
    /// How much wider the bores are than the shafts; it has no name at the command line.
    pub bore_play: Option<f64>,
    /// Least thickness of the wheel between a slot and a locking arc.
    pub horn: Option<f64>,
    /// How much deeper the slots are than the pins need.
    pub bottom_clearance: Option<f64>,
    /// Diameter of the wheel's shaft.
    pub wheel_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plane of the wheel.
    pub driver_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plate, if it ends there; that in the plane of the wheel unless it is given.
    pub plate_shaft: Option<f64>,
    /// Holes for mounting, and what the files have besides wheel and driver.
    pub mounting: MountingQuestion,
    /// Speed of the driver in turns per minute: this or the next.
    pub rpm: Option<f64>,
    /// Speed of the driver in radians per second.
    pub rad_s: Option<f64>,
    /// Moment of inertia, in kg m², of everything that turns with the wheel, without the wheel itself if the density is given.
    pub inertia: Option<f64>,
    /// Thickness of the wheel.
    pub thickness: Option<f64>,
    /// Density of the wheel in kg/m³.
    pub density: Option<f64>,
    /// Torque of the friction that brakes the wheel, in N m.
    pub friction_torque: Option<f64>,
    /// Material of the pins.
    pub pin_material: Option<Material>,
    /// Material of the wheel.
    pub wheel_material: Option<Material>,
    /// Crank angles, in degrees, at which to report the motion.
    pub at: Vec<f64>,
    /// Wheel angles, in degrees from the middle of an index, at which to report the motion.
    pub at_wheel: Vec<f64>,
    /// By how much the axes are too far apart, for the clearance and the knock; it has no name at the command line.
    pub centre_error: f64,
    /// Coefficient of friction of a pin in its slot; it has no name at the command line.
    pub pin_friction: Option<f64>,
    /// Degrees of the crank before a pin enters, for the backlash there; it has no name at the command line.
    pub before_entry: Option<f64>,
    /// How long clearances are looked for.
    pub effort: SearchEffort,
}

/// An argument of a question about a wheel, as it is typed at the command line.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// Its name, which stands behind two hyphens.
    pub name: &'static str,
    /// A word for its value, which says the unit: `MM`.
    pub unit: &'static str,
    /// Where it is in the question, and so what it may be.
    pub place: ArgumentSlot,
    /// What it acts on: without that, it has no effect. Some act on all that is said of a wheel.
    pub acts_on: &'static [ActsOn],
    /// What it means, with its range and what it is by default.
    pub help: &'static str,
}

impl Argument {
    const fn new(
        name: &'static str,
        unit: &'static str,
        place: ArgumentSlot,
        acts_on: &'static [ActsOn],
        help: &'static str,
    ) -> Self {
        Self { name, unit, place, acts_on, help }
    }
}

/// The place of an argument in a question, by what it may be.
#[derive(Clone, Copy, Debug)]
pub enum ArgumentSlot {
    /// A number of stations.
    Stations(fn(&mut WheelQuestion) -> &mut Option<u32>),
    /// A number of pins.
    Pins(fn(&mut WheelQuestion) -> &mut Option<u32>),
    /// A kind of wheel, by its name.
    Kind(fn(&mut WheelQuestion) -> &mut Option<WheelKind>),
    /// A length in millimetres, above zero.
    Length(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A number above zero.
    AboveZero(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A number that is zero or more.
    ZeroOrMore(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A material, by its name.
    Material(fn(&mut WheelQuestion) -> &mut Option<Material>),
    /// Angles in degrees; the argument can be repeated.
    Degrees(fn(&mut WheelQuestion) -> &mut Vec<f64>),
}

/// What an argument acts on besides the wheel as such.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActsOn {
    /// The size of the wheel: one such argument gives it.
    Size,
    /// The parts in millimetres, which only an external wheel with a size has.
    Parts,
    /// Motion and loads.
    Motion,
    /// The speed of the driver: one such argument gives it.
    Speed,
}

/// The arguments that the command line has, in its order.
pub const ARGUMENTS: [Argument; 22] = [
    Argument::new(
        "stations",
        "N",
        ArgumentSlot::Stations(|question| &mut question.stations),
        &[],
        "Number of slots, from 3 to 1000; the wheel stops this many times in one turn",
    ),
    Argument::new(
        "pins",
        "P",
        ArgumentSlot::Pins(|question| &mut question.pins),
        &[],
        "Number of evenly spaced pins on the driver. External wheels: at most 2N/(N − 2), or two pins would be in slots \
         at once. Internal wheels: 1. Spherical wheels: 1 or 2 [default: 1]",
    ),
    Argument::new(
        "type",
        "TYPE",
        ArgumentSlot::Kind(|question| &mut question.kind),
        &[],
        "Kind of wheel [default: external]",
    ),
    Argument::new(
        "crank-radius",
        "MM",
        ArgumentSlot::Length(|question| &mut question.crank_radius),
        &[Size],
        "Distance from the driver's axis to a pin's centre, in millimetres; give this or one of the next two for sizes in \
         mm",
    ),
    Argument::new(
        "centre-distance",
        "MM",
        ArgumentSlot::Length(|question| &mut question.centre_distance),
        &[Size],
        "Distance between the two axes, in millimetres",
    ),
    Argument::new(
        "wheel-radius",
        "MM",
        ArgumentSlot::Length(|question| &mut question.wheel_radius),
        &[Size],
        "Distance from the wheel's axis to a pin's centre as the pin enters, in millimetres",
    ),
    Argument::new(
        "pin-diameter",
        "MM",
        ArgumentSlot::Length(|question| &mut question.pin_diameter),
        &[Parts],
        "Diameter of the pins, in millimetres [default: one that fits]",
    ),
    Argument::new(
        "play",
        "MM",
        ArgumentSlot::ZeroOrMore(|question| &mut question.play),
        &[Parts],
        "How much wider slots and locking arcs are than the parts that run in them, in millimetres, zero or more; bores \
         have a quarter of it [default: a thousandth of the centre distance, or less if parts are small]",
    ),
    Argument::new(
        "horn",
        "MM",
        ArgumentSlot::Length(|question| &mut question.horn),
        &[Parts],
        "Least thickness of the wheel between a slot and a locking arc, in millimetres [default: the pin's diameter]",
    ),
    Argument::new(
        "bottom-clearance",
        "MM",
        ArgumentSlot::ZeroOrMore(|question| &mut question.bottom_clearance),
        &[Parts],
        "How much deeper the slots are than the pins need, in millimetres, zero or more [default: a twentieth of the \
         pin's diameter]",
    ),
    Argument::new(
        "wheel-shaft",
        "MM",
        ArgumentSlot::Length(|question| &mut question.wheel_shaft),
        &[Parts],
        "Diameter of the wheel's shaft, in millimetres [default: none, and no bore]",
    ),
    Argument::new(
        "driver-shaft",
        "MM",
        ArgumentSlot::Length(|question| &mut question.driver_shaft),
        &[Parts],
        "Diameter of the driver's shaft in the plane of the wheel, in millimetres [default: none, and no bore]",
    ),
    Argument::new(
        "rpm",
        "R",
        ArgumentSlot::AboveZero(|question| &mut question.rpm),
        &[Motion, Speed],
        "Speed of the driver in turns per minute, above zero; adds times in s, and motion in rad/s, rad/s² and rad/s³",
    ),
    Argument::new(
        "rad-s",
        "W",
        ArgumentSlot::AboveZero(|question| &mut question.rad_s),
        &[Motion, Speed],
        "Speed of the driver in radians per second, above zero, instead of --rpm",
    ),
    Argument::new(
        "inertia",
        "KGM2",
        ArgumentSlot::ZeroOrMore(|question| &mut question.inertia),
        &[Motion],
        "Moment of inertia, in kg m², zero or more, of everything that turns with the wheel, including the wheel itself \
         unless you give --density. With --rpm it gives torques and, if you also give a size, the force on the pin. These \
         loads leave out the friction of pin, locking disc, bearings and gear",
    ),
    Argument::new(
        "thickness",
        "MM",
        ArgumentSlot::Length(|question| &mut question.thickness),
        &[Parts],
        "Thickness of the wheel, in millimetres: needed for the wheel's own inertia (with --density), for the pressure \
         between pin and slot, and for OpenSCAD and STL files",
    ),
    Argument::new(
        "density",
        "KGM3",
        ArgumentSlot::AboveZero(|question| &mut question.density),
        &[Parts, Motion],
        "Density of the wheel, in kg/m³; with --thickness and a size, the wheel's own inertia is computed and added to \
         --inertia",
    ),
    Argument::new(
        "friction-torque",
        "NM",
        ArgumentSlot::ZeroOrMore(|question| &mut question.friction_torque),
        &[Motion],
        "Torque of the friction that brakes the wheel, in N m, zero or more",
    ),
    Argument::new(
        "pin-material",
        "MATERIAL",
        ArgumentSlot::Material(|question| &mut question.pin_material),
        &[],
        "Material of the pins; with --wheel-material, --thickness and the options that give the force on the pin, it \
         gives the pressure between pin and slot",
    ),
    Argument::new(
        "wheel-material",
        "MATERIAL",
        ArgumentSlot::Material(|question| &mut question.wheel_material),
        &[],
        "Material of the wheel",
    ),
    Argument::new(
        "at",
        "DEG",
        ArgumentSlot::Degrees(|question| &mut question.at),
        &[Motion],
        "Crank angle, in degrees, at which to report the motion; can be repeated",
    ),
    Argument::new(
        "at-wheel",
        "DEG",
        ArgumentSlot::Degrees(|question| &mut question.at_wheel),
        &[Motion],
        "Wheel angle, in degrees from the middle of an index, at which to report the motion; can be repeated",
    ),
];

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
    /// The speed of the driver, if it is given.
    pub fn speed(&self) -> Option<DriverSpeed> {
        self.rpm.map(DriverSpeed::Rpm).or(self.rad_s.map(DriverSpeed::RadiansPerSecond))
    }

    /// Reads arguments as they are typed: `--stations 6 --rpm 60`.
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
            "centre-error" => self.centre_error = number(name, value)?,
            "pin-friction" => self.pin_friction = Some(number(name, value)?),
            "before-entry" => self.before_entry = Some(number(name, value)?),
            _ => {
                let known = ARGUMENTS.iter().find(|argument| argument.name == name).ok_or_else(|| {
                    let names = ARGUMENTS.map(|argument| argument.name).join(", --");
                    refused!("no argument --{name}; there are --{names}")
                })?;
                match known.place {
                    ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) => *at(self) = Some(number(name, value)?),
                    ArgumentSlot::Kind(at) => {
                        *at(self) = Some(one_of(name, value, &WheelKind::ALL.map(|kind| (kind.name(), kind)))?)
                    }
                    ArgumentSlot::Length(at) | ArgumentSlot::AboveZero(at) | ArgumentSlot::ZeroOrMore(at) => {
                        *at(self) = Some(number(name, value)?)
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
            ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) => at(&mut copy).map(f64::from),
            ArgumentSlot::Length(at) | ArgumentSlot::AboveZero(at) | ArgumentSlot::ZeroOrMore(at) => *at(&mut copy),
            ArgumentSlot::Degrees(at) => at(&mut copy).first().copied(),
            ArgumentSlot::Kind(_) | ArgumentSlot::Material(_) => None,
        };
        ARGUMENTS.iter().filter_map(|argument| Some((*argument, number(argument)?))).collect()
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
    use super::{ARGUMENTS, ArgumentSlot, WheelQuestion};
    use crate::{FieldValue, Needs, ReportField, answer, further};
    use std::collections::BTreeMap;

    /// Every argument that a value may need, by what it gives.
    const GIVEN: [(&str, Needs); 13] = [
        ("--rpm 60", Needs::SPEED),
        ("--crank-radius 25", Needs::SIZE),
        ("--inertia 0.002", Needs::TABLE_INERTIA),
        ("--friction-torque 0.0001", Needs::FRICTION_TORQUE),
        ("--thickness 10", Needs::THICKNESS),
        ("--density 7800", Needs::DENSITY),
        ("--pin-material steel", Needs::MATERIALS),
        ("--wheel-material steel", Needs::MATERIALS),
        ("--pins 2", Needs::SECOND_PIN),
        ("--pin-friction 0.15", Needs::PIN_FRICTION),
        ("--before-entry 20", Needs::BEFORE_ENTRY),
        ("--wheel-shaft 6", Needs::WHEEL_SHAFT),
        ("--driver-shaft 2", Needs::DRIVER_SHAFT),
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
        let none = Needs::TABLE_INERTIA.union(Needs::DENSITY).union(Needs::INERTIA);
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
        assert!(lost > 150, "only {lost} values are missing without what they need");
    }

    #[test]
    fn each_argument_sets_the_field_of_its_name() {
        for argument in ARGUMENTS {
            let (value, set) = match argument.place {
                ArgumentSlot::Kind(_) => ("spherical", "kind: Some(Spherical)".to_owned()),
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
