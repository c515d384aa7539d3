//! What the wheel carries, and of what it is made.

use super::ActsOn::{Inertia, Load, Motion, Parts};
use super::{Argument, ArgumentSlot, Knob};
use geneva_dynamics::line_contact::MATERIALS;

/// The group of ways to say what the wheel turns.
const TABLE: &str = "table";

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "table-mass",
        "KG",
        ArgumentSlot::ZeroOrMore(|question| &mut question.table_mass),
        &[Motion, Inertia],
        "Mass of a round table that turns with the wheel, in kg, zero or more; give --table-diameter with it, and leave \
         --inertia out",
    )
    .with_knob(Knob::follows("or mass of a round table", "kg", [0.0, 20.0], 0.1, "table_mass_kg").typed([0.0, 1e6]).on_side(TABLE, 1)),
    Argument::new(
        "table-diameter",
        "MM",
        ArgumentSlot::Length(|question| &mut question.table_diameter),
        &[Motion, Inertia],
        "Diameter of that table, in millimetres; it counts as a disc of uniform thickness",
    )
    .with_knob(
        Knob::follows("and its diameter", "mm", [10.0, 1000.0], 10.0, "table_diameter_mm").typed([0.1, 20_000.0]).on_side(TABLE, 1),
    ),
    Argument::new(
        "inertia",
        "KGM2",
        ArgumentSlot::ZeroOrMore(|question| &mut question.inertia),
        &[Motion, Inertia],
        "Moment of inertia, in kg m², zero or more, of everything that turns with the wheel but not of the wheel itself, which \
         is added if it has a size. With --rpm it gives torques and, if you also give a size, the force on the pin",
    )
    .with_knob(
        Knob::at("inertia of the table", "kg m²", [0.0, 0.05], 0.0005, 0.002).typed([0.0, 1e6]).on_side(TABLE, 0).told_by("table_inertia_kgm2"),
    ),
    Argument::new(
        "total-inertia",
        "KGM2",
        ArgumentSlot::ZeroOrMore(|question| &mut question.total_inertia),
        &[Motion, Inertia],
        "Moment of inertia, in kg m², of the wheel and everything that turns with it, instead of --inertia; nothing is added",
    ),
    Argument::new(
        "friction-torque",
        "NM",
        ArgumentSlot::ZeroOrMore(|question| &mut question.friction_torque),
        &[Motion, Load],
        "Torque of the friction that brakes the wheel, in N m, zero or more [default: 0]",
    )
    .with_knob(Knob::at("friction torque on the wheel", "N m", [0.0, 5.0], 0.05, 0.1).typed([0.0, 1e6])),
    Argument::new(
        "wheel-material",
        "MATERIAL",
        ArgumentSlot::Material(|question| &mut question.wheel_material),
        &[Parts],
        "Material of the wheel: it gives the wheel's own inertia and, with the pin's, the pressure between pin and slot \
         [default: steel, or that of --process]",
    )
    .with_knob(Knob::at("the wheel is made of", "", [0.0, 0.0], 1.0, 3.0)),
    Argument::new(
        "driver-material",
        "MATERIAL",
        ArgumentSlot::Material(|question| &mut question.driver_material),
        &[Parts],
        "Material of locking disc and plate, and of pins in one piece with them: it gives the driver's mass and own inertia, and the \
         speed that its rim bears [default: as the wheel]",
    )
    .with_knob(Knob::at("the driver is made of", "", [0.0, 0.0], 1.0, MATERIALS.len() as f64)),
    Argument::new(
        "pin-material",
        "MATERIAL",
        ArgumentSlot::Material(|question| &mut question.pin_material),
        &[Parts],
        "Material of the pins [default: in one piece with the plate, that of --driver-material; else steel, or that of --process]",
    )
    .with_knob(Knob::at("the pins are made of", "", [0.0, 0.0], 1.0, 0.0)),
    Argument::new(
        "density",
        "KGM3",
        ArgumentSlot::AboveZero(|question| &mut question.density),
        &[Parts],
        "Density of the wheel, in kg/m³ [default: that of its material]",
    ),
    Argument::new(
        "driver-density",
        "KGM3",
        ArgumentSlot::AboveZero(|question| &mut question.driver_density),
        &[Parts],
        "Density of locking disc and plate, in kg/m³ [default: that of their material]",
    ),
    Argument::new(
        "pin-density",
        "KGM3",
        ArgumentSlot::AboveZero(|question| &mut question.pin_density),
        &[Parts],
        "Density of the pins, in kg/m³ [default: that of their material]",
    ),
];
