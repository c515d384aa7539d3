//! What the wheel must do: stations, times and speeds.

use super::ActsOn::{Motion, Speed};
use super::{Argument, ArgumentSlot, Knob};

/// The group of ways to say how fast the driver turns.
const PACE: &str = "pace";

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "stations",
        "N",
        ArgumentSlot::Stations(|question| &mut question.stations),
        &[],
        "Number of slots, from 3 to 1000; the wheel stops this many times in one turn",
    )
    .with_knob(Knob::at("stations N", "", [3.0, 24.0], 1.0, 6.0).typed([3.0, 100.0])),
    Argument::new(
        "pins",
        "P",
        ArgumentSlot::Pins(|question| &mut question.pins),
        &[],
        "Number of evenly spaced pins on the driver. External wheels: at most 2N/(N − 2), or two pins would be in slots \
         at once. Internal wheels: 1. Spherical wheels: 1 or 2 [default: 1]",
    )
    .with_knob(Knob::at("pins", "", [1.0, 4.0], 1.0, 1.0).typed([1.0, 50.0])),
    Argument::new(
        "type",
        "TYPE",
        ArgumentSlot::Kind(|question| &mut question.kind),
        &[],
        "Kind of wheel [default: external]",
    ),
    Argument::new(
        "rpm",
        "R",
        ArgumentSlot::AboveZero(|question| &mut question.rpm),
        &[Motion, Speed],
        "Speed of the driver in turns per minute, above zero; adds times in s, and motion in rad/s, rad/s² and rad/s³",
    )
    .with_knob(
        Knob::at("speed of the driver", "rpm", [1.0, 600.0], 1.0, 60.0).typed([0.001, 100_000.0]).on_side(PACE, 0).told_by("rpm"),
    ),
    Argument::new(
        "rad-s",
        "W",
        ArgumentSlot::AboveZero(|question| &mut question.rad_s),
        &[Motion, Speed],
        "Speed of the driver in radians per second, above zero, instead of --rpm",
    ),
    Argument::new(
        "index-time",
        "S",
        ArgumentSlot::AboveZero(|question| &mut question.index_time),
        &[Motion, Speed],
        "Time of one index in seconds, above zero, instead of --rpm. With --dwell-time, you get the wheels that come nearest \
         to both times; with --stations as well, it is the longest that you allow, and you get the pins and speeds that \
         fulfil both",
    )
    .with_knob(
        Knob::follows("or time of an index", "s", [0.05, 5.0], 0.05, "indexing_time_s")
            .typed([0.000_1, 10_000.0])
            .on_side(PACE, 1),
    ),
    Argument::new(
        "dwell-time",
        "S",
        ArgumentSlot::AboveZero(|question| &mut question.dwell_time),
        &[Motion, Speed],
        "Time of one dwell in seconds, above zero, instead of --rpm; with --stations and --index-time, the shortest that you \
         allow",
    )
    .with_knob(
        Knob::follows("or time of a dwell", "s", [0.05, 10.0], 0.05, "dwell_time_s")
            .typed([0.000_1, 10_000.0])
            .on_side(PACE, 2),
    ),
    Argument::new(
        "dwell-angle",
        "DEG",
        ArgumentSlot::AboveZero(|question| &mut question.dwell_angle),
        &[],
        "Angle in degrees through which the driver turns while the wheel stands still, once for each pin: you get the wheels \
         that come nearest",
    ),
];
