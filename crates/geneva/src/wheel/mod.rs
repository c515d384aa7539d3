//! One wheel: its sizes, its times, its motion and loads, or its drawing; or which wheel has wanted times.

mod idle;

use crate::fields;
use crate::format::{Format, Output, formats};
use crate::typed;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use geneva_ask::wheel::{Design, Kind, Question, Times, proposals};
use geneva_dynamics::line_contact::{MATERIALS, Material};

/// Options of `geneva wheel`.
#[derive(Args, Debug)]
pub struct WheelArguments {
    /// Number of slots, from 3 to 1000; the wheel stops this many times in one turn
    #[arg(long, value_name = "N", required_unless_present_any = ["index_time", "dwell_time"],
        value_parser = typed::stations, allow_negative_numbers = true)]
    pub stations: Option<u32>,
    /// Number of evenly spaced pins on the driver. External wheels: at most 2N/(N − 2), or two pins would be in slots at
    /// once. Internal wheels: 1. Spherical wheels: 1 or 2 [default: 1]
    #[arg(long, value_name = "P", value_parser = typed::pins, allow_negative_numbers = true)]
    pub pins: Option<u32>,
    /// Kind of wheel [default: external]
    #[arg(long = "type", value_name = "TYPE", value_enum)]
    pub kind: Option<KindName>,
    /// Distance from the driver's axis to a pin's centre, in millimetres; give this or one of the next two for sizes in mm
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true,
        conflicts_with_all = ["centre_distance", "wheel_radius"])]
    pub crank_radius: Option<f64>,
    /// Distance between the two axes, in millimetres
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true,
        conflicts_with = "wheel_radius")]
    pub centre_distance: Option<f64>,
    /// Distance from the wheel's axis to a pin's centre as the pin enters, in millimetres
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true)]
    pub wheel_radius: Option<f64>,
    /// Diameter of the pins, in millimetres [default: one that fits]
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true)]
    pub pin_diameter: Option<f64>,
    /// How much wider slots and locking arcs are than the parts that run in them, in millimetres, zero or more; bores have
    /// a quarter of it [default: a thousandth of the centre distance, or less if parts are small]
    #[arg(long, value_name = "MM", value_parser = typed::zero_or_more, allow_hyphen_values = true)]
    pub play: Option<f64>,
    /// Least thickness of the wheel between a slot and a locking arc, in millimetres [default: the pin's diameter]
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true)]
    pub horn: Option<f64>,
    /// How much deeper the slots are than the pins need, in millimetres, zero or more [default: a twentieth of the pin's
    /// diameter]
    #[arg(long, value_name = "MM", value_parser = typed::zero_or_more, allow_hyphen_values = true)]
    pub bottom_clearance: Option<f64>,
    /// Diameter of the wheel's shaft, in millimetres [default: half of the largest possible]
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true)]
    pub wheel_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plane of the wheel, in millimetres [default: half of the largest possible; none
    /// if that would be very thin]
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true)]
    pub driver_shaft: Option<f64>,
    /// Speed of the driver in turns per minute, above zero; adds times in s, and motion in rad/s, rad/s² and rad/s³
    #[arg(long, value_name = "R", value_parser = typed::positive, allow_hyphen_values = true)]
    pub rpm: Option<f64>,
    /// Moment of inertia, in kg m², zero or more, of everything that turns with the wheel, including the wheel itself unless
    /// you give --density. With --rpm it gives torques and, if you also give a size, the force on the pin. These loads leave
    /// out the friction of pin, locking disc, bearings and gear
    #[arg(long, value_name = "KGM2", value_parser = typed::zero_or_more, allow_hyphen_values = true)]
    pub inertia: Option<f64>,
    /// Thickness of the wheel, in millimetres: needed for the wheel's own inertia (with --density), for the pressure between
    /// pin and slot, and for OpenSCAD and STL files
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true)]
    pub thickness: Option<f64>,
    /// Density of the wheel, in kg/m³; with --thickness and a size, the wheel's own inertia is computed and added to --inertia
    #[arg(long, value_name = "KGM3", value_parser = typed::positive, allow_hyphen_values = true)]
    pub density: Option<f64>,
    /// Torque of the friction that brakes the wheel, in N m, zero or more
    #[arg(long, value_name = "NM", value_parser = typed::zero_or_more, allow_hyphen_values = true)]
    pub friction_torque: Option<f64>,
    /// Material of the pins; with --wheel-material, --thickness and the options that give the force on the pin, it gives the
    /// pressure between pin and slot
    #[arg(long, value_name = "MATERIAL", value_parser = materials(), requires = "wheel_material")]
    pub pin_material: Option<Material>,
    /// Material of the wheel
    #[arg(long, value_name = "MATERIAL", value_parser = materials(), requires = "pin_material")]
    pub wheel_material: Option<Material>,
    /// Crank angle, in degrees, at which to report the motion; can be repeated
    #[arg(long, value_name = "DEG", value_parser = typed::finite_degrees, allow_hyphen_values = true)]
    pub at: Vec<f64>,
    /// Wheel angle, in degrees from the middle of an index, at which to report the motion; can be repeated
    #[arg(long, value_name = "DEG", value_parser = typed::finite_degrees, allow_hyphen_values = true)]
    pub at_wheel: Vec<f64>,
    /// Time that one index should take, in seconds; give it with --dwell-time, and instead of --stations and --rpm, to get
    /// the wheels that come nearest
    #[arg(long, value_name = "S", value_parser = typed::positive, allow_hyphen_values = true, requires = "dwell_time")]
    pub index_time: Option<f64>,
    /// Time that one dwell should take, in seconds
    #[arg(long, value_name = "S", value_parser = typed::positive, allow_hyphen_values = true, requires = "index_time")]
    pub dwell_time: Option<f64>,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (Format::Text, "A readable sheet, which says where everything is measured from"),
        (Format::Json, "An object with all digits; null for values that need an option you didn't give"),
        (Format::Csv, "The cycle, one row per degree of a turn of the driver, or one per --at"),
        (Format::Fields, "The numbers as CSV: a row with key, name, value, unit and meaning for each"),
        (Format::Svg, "A drawing as a standalone file; with dimensions if you give a size"),
        (Format::Dxf, "The outlines of all parts side by side, in mm, with true arcs; needs a size"),
        (Format::Scad, "A moving model for OpenSCAD, in mm; needs a size and --thickness"),
        (Format::Stl, "Meshes of the parts side by side, in mm; needs a size and --thickness"),
    ]))]
    pub format: Format,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Kinds of wheel: how wheel and driver are arranged.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum KindName {
    /// Driver beside the wheel: they turn in opposite senses
    External,
    /// Driver inside the wheel: they turn in the same sense, the wheel for more than half of each turn
    Internal,
    /// Axes that cross at right angles: half of each turn is motion, half is dwell
    Spherical,
}

impl From<KindName> for Kind {
    fn from(name: KindName) -> Self {
        match name {
            KindName::External => Self::External,
            KindName::Internal => Self::Internal,
            KindName::Spherical => Self::Spherical,
        }
    }
}

impl WheelArguments {
    fn question(&self) -> Question {
        Question {
            kind: self.kind.map(Kind::from),
            stations: self.stations,
            pins: self.pins,
            crank_radius: self.crank_radius,
            centre_distance: self.centre_distance,
            wheel_radius: self.wheel_radius,
            pin_diameter: self.pin_diameter,
            play: self.play,
            horn: self.horn,
            bottom_clearance: self.bottom_clearance,
            wheel_shaft: self.wheel_shaft,
            driver_shaft: self.driver_shaft,
            rpm: self.rpm,
            inertia: self.inertia,
            thickness: self.thickness,
            density: self.density,
            friction_torque: self.friction_torque,
            pin_material: self.pin_material,
            wheel_material: self.wheel_material,
            at: self.at.clone(),
            at_wheel: self.at_wheel.clone(),
            ..Question::default()
        }
    }
}

/// One of the materials whose moduli are known, by its name.
fn materials() -> impl TypedValueParser<Value = Material> {
    PossibleValuesParser::new(MATERIALS.map(|material| material.name))
        .try_map(|name| MATERIALS.into_iter().find(|material| material.name == name).ok_or("not a known material"))
}

/// The wheel that is wanted, in the format that is wanted.
pub fn page(wanted: &WheelArguments) -> anyhow::Result<String> {
    let (format, question) = (wanted.format, wanted.question());
    if let (Some(index), Some(dwell)) = (wanted.index_time, wanted.dwell_time) {
        idle::beside_times(&question, format)?;
        let answer = proposals(Times { index, dwell }, question.kind);
        return match format {
            Format::Csv => fields::csv(answer.rows().next(), answer.rows().cloned()),
            Format::Json => fields::json(&answer),
            _ => Ok(fields::sheet(&answer)),
        };
    }
    let design = Design::new(question)?;
    if matches!(format, Format::Dxf | Format::Scad | Format::Stl) {
        design.is_made_from(format.name())?;
    }
    idle::refused(&design.question, format)?;
    Ok(match format {
        Format::Svg => design.drawing().standalone(),
        Format::Dxf => design.dxf()?,
        Format::Scad => design.scad()?,
        Format::Stl => design.stl()?,
        Format::Csv => {
            let rows = design.cycle()?;
            fields::csv(rows.first(), rows.iter().cloned())?
        }
        Format::Json => fields::json(&design.answer()?)?,
        Format::Fields => fields::table(&design.answer()?)?,
        _ => fields::sheet(&design.answer()?),
    })
}
