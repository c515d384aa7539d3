//! How the parts fit: pin, slot, plays and horn.

use super::ActsOn::Parts;
use super::{Argument, ArgumentSlot, Knob};

/// The group of shapes that the mouths of the slots can have.
const MOUTH: &str = "mouth";
/// What can be typed for a size of a mouth, in millimetres.
const OF_MOUTH: [f64; 2] = [0.0, 1000.0];

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "process",
        "PROCESS",
        ArgumentSlot::Process(|question| &mut question.process),
        &[Parts],
        "How the parts are made: it gives the plays that are not given, and tells how many of 1000 simulated assemblies turn with \
         the errors of that process",
    )
    .with_knob(Knob::at("made by", "", [0.0, 0.0], 1.0, 0.0)),
    Argument::new(
        "measured-play",
        "MM",
        ArgumentSlot::Length(|question| &mut question.measured_play),
        &[Parts],
        "Least play in millimetres with which the pin ran on the test piece of --process: the play of slots and locking arcs and the \
         errors then come from there, and so does that of bores, but not with fdm and resin, which have one of their own",
    )
    .depending_on(&["process"])
    .with_knob(Knob::follows("play with which a printed pin runs", "mm", [0.05, 1.0], 0.05, "measured_play").typed([0.001, 10.0])),
    Argument::new(
        "pin-diameter",
        "MM",
        ArgumentSlot::Length(|question| &mut question.pin_diameter),
        &[Parts],
        "Diameter of the pins, in millimetres [default: one that fits; with --process one that is sold]",
    )
    .with_knob(Knob::follows("diameter of a pin", "mm", [1.0, 40.0], 0.1, "pin_diameter_mm").typed([0.001, 10_000.0])),
    Argument::new(
        "play",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.play),
        &[Parts],
        "How much wider slots and locking arcs are than the parts that run in them, in millimetres, zero or more; bores \
         have a quarter of it [default: that of --process, or a thousandth of the centre distance, or less if parts are small]",
    )
    .with_knob(Knob::follows("play of the slots", "mm", [0.0, 0.5], 0.01, "play_mm").typed([0.0, 1000.0])),
    Argument::new(
        "slot-width",
        "MM",
        ArgumentSlot::Length(|question| &mut question.slot_width),
        &[Parts],
        "Width of the slots, in millimetres, instead of --play, as it is measured on a wheel to be replaced",
    ),
    Argument::new(
        "locking-play",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.locking_play),
        &[Parts],
        "By how much the diameter of the locking arcs is greater than that of the locking disc, in millimetres, zero or more \
         [default: as --play]",
    )
    .with_knob(
        Knob::follows("play of the locking arcs", "mm", [0.0, 0.5], 0.01, "locking_play_mm").typed([0.0, 1000.0]),
    ),
    Argument::new(
        "bore-play",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.bore_play),
        &[Parts],
        "How much wider the bores are than the shafts that run in them, in millimetres, zero or more [default: a quarter of \
         --play, or that of --process]",
    )
    .with_knob(Knob::follows("play of the bores", "mm", [0.0, 0.2], 0.001, "bore_play_mm").typed([0.0, 1000.0])),
    Argument::new(
        "axial-play",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.axial_play),
        &[Parts],
        "Gap between the wheel and the driver's plate along the axes, in millimetres, zero or more [default: as --play]",
    )
    .with_knob(Knob::follows("axial play", "mm", [0.0, 2.0], 0.05, "axial_play_mm").typed([0.0, 1000.0])),
    Argument::new(
        "horn",
        "MM",
        ArgumentSlot::Length(|question| &mut question.horn),
        &[Parts],
        "Least thickness of the wheel between a slot and a locking arc, in millimetres [default: the pin's diameter]",
    )
    .with_knob(Knob::follows("thickness of a horn", "mm", [0.5, 40.0], 0.1, "horn_thickness_mm").typed([0.001, 10_000.0])),
    Argument::new(
        "locking-arc-radius",
        "MM",
        ArgumentSlot::Length(|question| &mut question.locking_arc_radius),
        &[Parts],
        "Radius of the wheel's locking arcs, in millimetres, instead of --horn, as it is measured on a wheel to be replaced",
    ),
    Argument::new(
        "bottom-clearance",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.bottom_clearance),
        &[Parts],
        "How much deeper the slots are than the pins need, in millimetres, zero or more [default: a twentieth of the \
         pin's diameter]",
    )
    .with_knob(
        Knob::follows("clearance at the slot's bottom", "mm", [0.0, 5.0], 0.05, "bottom_clearance_mm")
            .typed([0.0, 1000.0]),
    ),
    Argument::new(
        "mouth-chamfer",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.mouth_chamfer),
        &[Parts],
        "How much of each wall of a slot a chamfer takes at its mouth, along the slot, in millimetres; zero for sharp corners. \
         Give this, --mouth-radius or --lead-in [default: 0]",
    )
    .with_knob(
        Knob::at("chamfer of the mouths", "mm", [0.0, 5.0], 0.1, 0.0)
            .typed(OF_MOUTH)
            .on_side(MOUTH, 0)
            .told_by("mouth_chamfer_mm"),
    ),
    Argument::new(
        "mouth-angle",
        "DEG",
        ArgumentSlot::AboveZero(|question| &mut question.mouth_angle),
        &[Parts],
        "Angle of the chamfer to the wall of the slot, in degrees, less than 90; the flatter it is, the softer is the blow on \
         it [default: 45]",
    )
    .depending_on(&["mouth-chamfer"])
    .with_knob(Knob::follows("angle of the chamfer", "°", [2.0, 80.0], 1.0, "mouth_angle_deg").typed([0.1, 89.9])),
    Argument::new(
        "mouth-radius",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.mouth_radius),
        &[Parts],
        "Radius of rounded mouths of the slots, in millimetres, tangent to wall and rim; zero for sharp corners",
    )
    .with_knob(
        Knob::follows("or radius of the mouths", "mm", [0.0, 5.0], 0.1, "mouth_radius_mm").typed(OF_MOUTH).on_side(MOUTH, 1),
    ),
    Argument::new(
        "lead-in",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.lead_in),
        &[Parts],
        "How much of each wall of a slot an arc takes at its mouth, along the slot, in millimetres; it leaves the wall without a \
         corner. Zero for sharp corners",
    )
    .with_knob(Knob::follows("or lead-in", "mm", [0.0, 10.0], 0.1, "lead_in_mm").typed(OF_MOUTH).on_side(MOUTH, 2)),
    Argument::new(
        "lead-in-flare",
        "MM",
        ArgumentSlot::Length(|question| &mut question.lead_in_flare),
        &[Parts],
        "How far a lead-in has left the wall at the wheel radius, in millimetres [default: a tenth of --lead-in]",
    )
    .depending_on(&["lead-in"])
    .with_knob(Knob::follows("flare of the lead-in", "mm", [0.05, 2.0], 0.05, "lead_in_flare_mm").typed([0.001, 1000.0])),
    Argument::new(
        "wheel-shaft",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.wheel_shaft),
        &[Parts],
        "Diameter of the wheel's shaft, in millimetres; 0 for none, and no bore [default: 0]",
    )
    .with_knob(Knob::at("diameter of the wheel's shaft", "mm", [0.0, 100.0], 0.5, 0.0).typed([0.0, 10_000.0])),
    Argument::new(
        "driver-shaft",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.driver_shaft),
        &[Parts],
        "Diameter of the driver's shaft in the plane of the wheel, in millimetres; 0 if it ends in the plate [default: 0]",
    )
    .with_knob(Knob::at("diameter of the driver's shaft", "mm", [0.0, 100.0], 0.5, 0.0).typed([0.0, 10_000.0])),
    Argument::new(
        "plate-shaft",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.plate_shaft),
        &[Parts],
        "Diameter of the driver's shaft in its plate, in millimetres, for a shaft that ends there; 0 as in the plane of the \
         wheel [default: as --driver-shaft]",
    )
    .with_knob(Knob::at("diameter of the driver's shaft in the plate", "mm", [0.0, 100.0], 0.5, 0.0).typed([0.0, 10_000.0])),
];
