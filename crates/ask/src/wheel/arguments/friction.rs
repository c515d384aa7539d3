//! What rubs.

use super::ActsOn::{Load, Motion, Parts};
use super::{Argument, ArgumentSlot};

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "pin-friction",
        "MU",
        ArgumentSlot::ZeroOrMore(|question| &mut question.pin_friction),
        &[Motion, Load],
        "Coefficient of friction of a pin in its slot, zero or more; the pin is fast to the driver. It counts in every load \
         [default: 0]",
    ),
    Argument::new(
        "disc-friction",
        "MU",
        ArgumentSlot::ZeroOrMore(|question| &mut question.disc_friction),
        &[Motion, Load, Parts],
        "Coefficient of friction of the locking disc in its arc, zero or more. In the dwell --held-torque, or else \
         --friction-torque, presses an end of the arc on the disc [default: 0]",
    ),
    Argument::new(
        "bearing-friction",
        "MU",
        ArgumentSlot::ZeroOrMore(|question| &mut question.bearing_friction),
        &[Motion, Load, Parts],
        "Coefficient of friction of the bearings of wheel and driver, zero or more, under the force of the pin; give \
         --wheel-bearing and --driver-bearing with it, unless the shafts are given [default: 0]",
    ),
    Argument::new(
        "wheel-bearing",
        "MM",
        ArgumentSlot::Length(|question| &mut question.wheel_bearing),
        &[Motion, Load],
        "Diameter at which the wheel's bearing rubs, in millimetres [default: that of --wheel-shaft]",
    )
    .depending_on(&["bearing-friction"]),
    Argument::new(
        "driver-bearing",
        "MM",
        ArgumentSlot::Length(|question| &mut question.driver_bearing),
        &[Motion, Load],
        "Diameter at which the driver's bearing rubs, in millimetres [default: that of --plate-shaft, or else of --driver-shaft]",
    )
    .depending_on(&["bearing-friction"]),
    Argument::new(
        "driver-friction",
        "NM",
        ArgumentSlot::ZeroOrMore(|question| &mut question.driver_friction),
        &[Motion, Load],
        "Torque of friction on the driver over its whole turn, in N m, zero or more: of seals, or of a gear [default: 0]",
    ),
];
