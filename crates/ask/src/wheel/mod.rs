//! One wheel: its sizes, its times, its motion and loads, its drawing and files; or which wheels have wanted times.

mod design;
mod files;
mod instant;
mod kind;
mod loads;
mod making;
mod parts;
mod report;
mod times;

pub use design::Design;
pub use kind::{AnyWheel, Kind};
pub use times::{Times, proposals};

use crate::written::{as_typed, rounded_down};
use crate::{Error, number, pairs};
use geneva_dynamics::line_contact::{MATERIALS, Material};

/// What is asked of a wheel: the arguments have the names of the fields, `--crank-radius 25`. Lengths are in millimetres.
#[derive(Clone, Debug, Default)]
pub struct Question {
    /// Kind of wheel (`--type`); external unless it is given.
    pub kind: Option<Kind>,
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
    /// Speed of the driver in turns per minute.
    pub rpm: Option<f64>,
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
    pub effort: Effort,
}

/// Crank angles at which clearances are looked for at most. Where the play is so small against the parts that more are needed,
/// the numbers are missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// For the least clearance.
    pub clearance: u32,
    /// For each of the clearances that give the tolerance of the axes.
    pub tolerance: u32,
}

impl Default for Effort {
    /// A few seconds at most.
    fn default() -> Self {
        Self { clearance: 4_000_000, tolerance: 400_000 }
    }
}

/// Most angles at which the motion is reported at once.
const MOST_INSTANTS: usize = 10_000;

impl Question {
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
            "type" => self.kind = Some(one_of(name, value, &Kind::ALL.map(|kind| (kind.name(), kind)))?),
            "stations" => self.stations = Some(number(name, value)?),
            "pins" => self.pins = Some(number(name, value)?),
            "pin-material" => self.pin_material = Some(material(name, value)?),
            "wheel-material" => self.wheel_material = Some(material(name, value)?),
            "at" => self.at.push(number(name, value)?),
            "at-wheel" => self.at_wheel.push(number(name, value)?),
            "centre-error" => self.centre_error = number(name, value)?,
            "pin-friction" => self.pin_friction = Some(number(name, value)?),
            "before-entry" => self.before_entry = Some(number(name, value)?),
            _ => {
                let mut all = self.measures();
                let names = all.iter().map(|(known, _)| *known).collect::<Vec<_>>().join(", --");
                let Some((_, measure)) = all.iter_mut().find(|(known, _)| *known == name) else {
                    return Err(refused!("no argument --{name}; there are --{names}"));
                };
                **measure = Some(number(name, value)?);
            }
        }
        Ok(())
    }

    /// The arguments that are measured, by their names.
    fn measures(&mut self) -> [(&'static str, &mut Option<f64>); 14] {
        [
            ("crank-radius", &mut self.crank_radius),
            ("centre-distance", &mut self.centre_distance),
            ("wheel-radius", &mut self.wheel_radius),
            ("pin-diameter", &mut self.pin_diameter),
            ("play", &mut self.play),
            ("horn", &mut self.horn),
            ("bottom-clearance", &mut self.bottom_clearance),
            ("wheel-shaft", &mut self.wheel_shaft),
            ("driver-shaft", &mut self.driver_shaft),
            ("rpm", &mut self.rpm),
            ("inertia", &mut self.inertia),
            ("thickness", &mut self.thickness),
            ("density", &mut self.density),
            ("friction-torque", &mut self.friction_torque),
        ]
    }

    /// The arguments with a number that were given, by their names; of repeated ones the first.
    pub fn numbers(&self) -> Vec<(&'static str, f64)> {
        let counts =
            [("stations", self.stations), ("pins", self.pins)].map(|(name, count)| (name, count.map(f64::from)));
        let angles = [("at", self.at.first().copied()), ("at-wheel", self.at_wheel.first().copied())];
        let mut copy = self.clone();
        let measures = copy.measures().map(|(name, value)| (name, *value));
        counts.into_iter().chain(measures).chain(angles).filter_map(|(name, value)| Some((name, value?))).collect()
    }
}

impl Design {
    /// The crank angles in degrees at which to report the motion.
    fn angles(&self) -> Result<Vec<f64>, Error> {
        let Question { at, at_wheel, .. } = &self.question;
        let asked = at.len() + at_wheel.len();
        if asked > MOST_INSTANTS {
            return Err(refused!(
                "--at and --at-wheel give {asked} angles, but at most {MOST_INSTANTS} can be reported at once; give fewer, or \
                 none with --format csv, which has a row for each degree"
            ));
        }
        let wheel = self.wheel.indexing();
        let most = 180.0 / f64::from(wheel.stations());
        let of_the_wheel = at_wheel.iter().map(|degrees| {
            if degrees.abs() > most {
                return Err(refused!(
                    "--at-wheel {}: during an index the wheel turns from −{most}° to {most}°; give an angle in this range",
                    as_typed(*degrees),
                    most = rounded_down(most)
                ));
            }
            Ok(wheel.crank_at(degrees.to_radians())?.to_degrees())
        });
        at.iter().map(|degrees| Ok(*degrees)).chain(of_the_wheel).collect()
    }
}

fn material(name: &str, text: &str) -> Result<Material, Error> {
    one_of(name, text, &MATERIALS.map(|material| (material.name, material)))
}

fn one_of<T: Copy>(name: &str, text: &str, all: &[(&str, T)]) -> Result<T, Error> {
    let found = all.iter().find(|(known, _)| *known == text).map(|(_, found)| *found);
    found.ok_or_else(|| {
        let names = all.iter().map(|(known, _)| *known).collect::<Vec<_>>().join(", ");
        refused!("--{name} {text}: give one of {names}")
    })
}
