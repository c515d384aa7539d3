//! How the parts are mounted: shapes of bores, hubs, the pins' hold, dowels, a base plate, and the width of a cut.

use super::ActsOn::{Files, Parts, Play};
use super::{Argument, ArgumentSlot, Knob, NamedChoice};
use crate::wheel::mounting::{BoreShape, PinKind};
use geneva_workshop::{ScrewHole, Thread};

const THREADS: &[&str] = &["none", "M3", "M4", "M5", "M6", "M8"];
const HOLES: &[&str] = &["clearance", "tapped", "nut-trap"];
const BORES: &[&str] = &["round", "key"];
const HELD: &[&str] = &["solid", "dowel"];
const PIECES: &[&str] = &["one-piece", "two-pieces"];
const PIECES_ON_PAGE: &[&str] = &["one-piece", "two-pieces", "as usual for how they are made"];

/// The thread with a number of [`THREADS`].
fn thread(number: usize) -> Option<Thread> {
    number.checked_sub(1).and_then(|at| Thread::ALL.get(at)).copied()
}

/// The hole with a number of [`HOLES`]; the first is the usual one, and needs no word.
fn hole(number: usize) -> Option<ScrewHole> {
    ScrewHole::ALL.get(number).map(|(_, hole)| *hole).filter(|_| number > 0)
}

fn bore(number: usize) -> Option<BoreShape> {
    BoreShape::ALL.get(number).map(|(_, shape)| *shape).filter(|_| number > 0)
}

/// A length of the mounting with a slider that begins where there is none.
const fn length(label: &'static str, most: f64, step: f64, key: &'static str) -> Knob {
    Knob::follows(label, "mm", [0.0, most], step, key).typed([0.0, 10_000.0])
}

/// How many holes, with a slider that begins where nothing is said.
const fn count(label: &'static str, key: &'static str) -> Knob {
    Knob::follows(label, "", [2.0, 12.0], 1.0, key)
}

/// A choice on the page, the first of its names.
const fn choice(label: &'static str) -> Knob {
    Knob::at(label, "", [0.0, 0.0], 1.0, 0.0)
}

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "wheel-bore-shape",
        "SHAPE",
        ArgumentSlot::Choice(NamedChoice {
            names: BORES,
            with_usual: None,
            set: |question, number| question.mounting.wheel_bore_shape = bore(number),
        }),
        &[Parts, Files, Play],
        "Bore of the wheel: round, or with a keyway by DIN 6885-1 for --wheel-shaft [default: round]",
    )
    .with_knob(choice("the wheel's bore is")),
    Argument::new(
        "wheel-flat",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.wheel_flat),
        &[Parts, Files, Play],
        "Width in millimetres of a D-shaped shaft of the wheel, from its flat to the opposite side",
    )
    .with_knob(length("flat of the wheel's shaft", 50.0, 0.1, "wheel_flat_mm")),
    Argument::new(
        "driver-bore-shape",
        "SHAPE",
        ArgumentSlot::Choice(NamedChoice {
            names: BORES,
            with_usual: None,
            set: |question, number| question.mounting.driver_bore_shape = bore(number),
        }),
        &[Parts, Files, Play],
        "Bores of disc and plate: round, or with a keyway for --driver-shaft [default: round]",
    )
    .with_knob(choice("the driver's bores are")),
    Argument::new(
        "driver-flat",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.driver_flat),
        &[Parts, Files, Play],
        "Width in millimetres of a D-shaped shaft of the driver, from its flat to the opposite side",
    )
    .with_knob(length("flat of the driver's shaft", 50.0, 0.1, "driver_flat_mm")),
    Argument::new(
        "wheel-hub-circle",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.wheel_hub_circle),
        &[Parts, Files],
        "Diameter in millimetres of a circle of holes through the wheel, for a hub or a table",
    )
    .with_knob(length("circle of holes in the wheel", 100.0, 0.5, "wheel_hub_circle_mm")),
    Argument::new(
        "driver-hub-circle",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.driver_hub_circle),
        &[Parts, Files, Play],
        "Diameter in millimetres of a circle of holes through locking disc and plate",
    )
    .with_knob(length("circle of holes in the driver", 100.0, 0.5, "driver_hub_circle_mm")),
    Argument::new(
        "hub-holes",
        "COUNT",
        ArgumentSlot::Count(|question| &mut question.mounting.hub_holes),
        &[Parts, Files],
        "Holes of each of these circles, from 2 to 12 [default: 3]",
    )
    .with_knob(count("how many holes of each circle", "hub_holes")),
    Argument::new(
        "hub-screw",
        "THREAD",
        ArgumentSlot::Choice(NamedChoice {
            names: THREADS,
            with_usual: None,
            set: |question, number| question.mounting.hub_screw = thread(number),
        }),
        &[Parts, Files, Play],
        "Screws through these circles",
    )
    .with_knob(choice("screws of the hubs")),
    Argument::new(
        "hub-screw-hole",
        "HOLE",
        ArgumentSlot::Choice(NamedChoice {
            names: HOLES,
            with_usual: None,
            set: |question, number| question.mounting.hub_screw_hole = hole(number),
        }),
        &[Parts, Files, Play],
        "Holes for these screws: clearance (ISO 273, medium), tapped, or clearance with a pocket for the nut (ISO 4032) [default: \
         clearance]",
    )
    .with_knob(choice("their holes")),
    Argument::new(
        "hub-dowel",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.hub_dowel),
        &[Parts, Files, Play],
        "Diameter in millimetres of dowels through these circles, instead of screws",
    )
    .with_knob(length("dowels of the hubs", 20.0, 0.5, "hub_dowel_mm")),
    Argument::new(
        "pin-mount",
        "MOUNT",
        ArgumentSlot::Choice(NamedChoice {
            names: HELD,
            with_usual: None,
            set: |question, number| {
                question.mounting.pin_mount =
                    PinKind::ALL.get(number).map(|(_, kind)| *kind).filter(|_| number > 0);
            },
        }),
        &[Parts, Files, Play],
        "Pins in one piece with the plate, or dowels pressed into it [default: solid]",
    )
    .with_knob(choice("the pins are")),
    Argument::new(
        "pin-screw",
        "THREAD",
        ArgumentSlot::Choice(NamedChoice {
            names: THREADS,
            with_usual: None,
            set: |question, number| question.mounting.pin_screw = thread(number),
        }),
        &[Parts, Files, Play],
        "Screws that hold the pins, or are the pins",
    )
    .with_knob(choice("screws of the pins")),
    Argument::new(
        "pin-screw-hole",
        "HOLE",
        ArgumentSlot::Choice(NamedChoice {
            names: HOLES,
            with_usual: None,
            set: |question, number| question.mounting.pin_screw_hole = hole(number),
        }),
        &[Parts, Files, Play],
        "Holes for these screws in the plate [default: clearance]",
    )
    .with_knob(choice("their holes in the plate")),
    Argument::new(
        "disc-dowel",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.disc_dowel),
        &[Parts, Files, Play],
        "Diameter in millimetres of dowels between locking disc and plate",
    )
    .with_knob(length("dowels of the locking disc", 20.0, 0.5, "disc_dowel_mm")),
    Argument::new(
        "disc-dowel-circle",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.disc_dowel_circle),
        &[Parts, Files, Play],
        "Diameter in millimetres of the circle on which these are",
    )
    .with_knob(length("their circle", 100.0, 0.5, "disc_dowel_circle_mm")),
    Argument::new(
        "disc-dowels",
        "COUNT",
        ArgumentSlot::Count(|question| &mut question.mounting.disc_dowels),
        &[Parts, Files, Play],
        "How many of them, from 2 to 12 [default: 2]",
    )
    .with_knob(count("how many of them", "disc_dowels")),
    Argument::new(
        "driver-pieces",
        "PIECES",
        ArgumentSlot::Choice(NamedChoice {
            names: PIECES,
            with_usual: Some(PIECES_ON_PAGE),
            set: |question, number| question.mounting.stacked = Some(number == 1),
        }),
        &[Parts, Files, Play],
        "Locking disc and plate in one piece, or as two [default: one-piece, but two-pieces with --process laser or router]",
    )
    .with_knob(choice("disc and plate are")),
    Argument::new(
        "base-thickness",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.base_thickness),
        &[Parts, Files],
        "Thickness in millimetres of a base plate with holes for both shafts at the right distance",
    )
    .with_knob(length("thickness of a base plate", 30.0, 0.5, "base_thickness_mm")),
    Argument::new(
        "base-screw",
        "THREAD",
        ArgumentSlot::Choice(NamedChoice {
            names: THREADS,
            with_usual: None,
            set: |question, number| question.mounting.base_screw = thread(number),
        }),
        &[Parts, Files],
        "Screws at the corners of the base plate",
    )
    .with_knob(choice("screws of the base plate")),
    Argument::new(
        "shoulder-diameter",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.shoulder_diameter),
        &[Parts, Files],
        "Diameter in millimetres of a wider part of the base plate's holes, for a shoulder or a bearing",
    ),
    Argument::new(
        "shoulder-depth",
        "MM",
        ArgumentSlot::Length(|question| &mut question.mounting.shoulder_depth),
        &[Parts, Files],
        "Depth in millimetres of that wider part",
    ),
    Argument::new(
        "kerf",
        "MM",
        ArgumentSlot::LengthOrZero(|question| &mut question.mounting.kerf),
        &[Parts, Files],
        "Width in millimetres that a laser takes away: the file of parts to cut has contours moved by half of it [default: that of \
         --process, or 0]",
    ),
];
