//! What the pin must bear, and what drives the wheel.

use super::ActsOn::{Load, Motion, Parts};
use super::{Argument, ArgumentSlot};

/// What gives a force on the pin: an overload, or a speed.
const FORCE: &[&str] = &["arm-torque", "rpm", "rad-s", "index-time", "dwell-time"];

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "arm-torque",
        "NM",
        ArgumentSlot::ZeroOrMore(|question| &mut question.arm_torque),
        &[Parts],
        "Overload torque on the driver's arm, in N m, zero or more, such as that of a motor that stalls: adds the force on the \
         pin in mid-index, its stresses and the least pin, without speed or inertia",
    ),
    Argument::new(
        "held-torque",
        "NM",
        ArgumentSlot::ZeroOrMore(|question| &mut question.held_torque),
        &[Motion, Load],
        "Torque that turns the wheel while it should stand, in N m, zero or more, as of a table out of balance: for the locking \
         disc, and for a stop in mid-index",
    ),
    Argument::new(
        "driver-inertia",
        "KGM2",
        ArgumentSlot::AboveZero(|question| &mut question.driver_inertia),
        &[Motion, Load],
        "Moment of inertia, in kg m², above zero, of the driver and all that turns with it, as a flywheel, and the motor's times \
         the square of the gear ratio: adds the speed droop",
    ),
    Argument::new(
        "drive-torque",
        "NM",
        ArgumentSlot::AboveZero(|question| &mut question.drive_torque),
        &[Motion, Load],
        "Constant torque on the driver, in N m, above zero: with --driver-inertia it adds the time of a start in mid-index",
    )
    .depending_on(&["driver-inertia"]),
    Argument::new(
        "gear-ratio",
        "I",
        ArgumentSlot::AboveZero(|question| &mut question.gear_ratio),
        &[Motion, Load],
        "Turns of the motor in a turn of the driver, above zero: adds what the motor feels, through a gear without losses",
    ),
    Argument::new(
        "pin-modulus",
        "GPA",
        ArgumentSlot::AboveZero(|question| &mut question.pin_modulus),
        &[Parts],
        "Modulus of elasticity of the pins, in GPa [default: that of their material]",
    )
    .depending_on(FORCE),
    Argument::new(
        "pin-poisson",
        "NU",
        ArgumentSlot::ZeroOrMore(|question| &mut question.pin_poisson),
        &[Parts],
        "Poisson's ratio of the pins, from 0 to 0.5 [default: that of their material]",
    )
    .depending_on(FORCE),
    Argument::new(
        "pin-strength",
        "MPA",
        ArgumentSlot::AboveZero(|question| &mut question.pin_strength),
        &[Parts],
        "Stress at which the pins yield, in MPa [default: that of a soft grade of their material]",
    ),
    Argument::new(
        "wheel-modulus",
        "GPA",
        ArgumentSlot::AboveZero(|question| &mut question.wheel_modulus),
        &[Parts],
        "Modulus of elasticity of the wheel, in GPa [default: that of its material]",
    )
    .depending_on(FORCE),
    Argument::new(
        "wheel-poisson",
        "NU",
        ArgumentSlot::ZeroOrMore(|question| &mut question.wheel_poisson),
        &[Parts],
        "Poisson's ratio of the wheel, from 0 to 0.5 [default: that of its material]",
    )
    .depending_on(FORCE),
    Argument::new(
        "wheel-strength",
        "MPA",
        ArgumentSlot::AboveZero(|question| &mut question.wheel_strength),
        &[Parts],
        "Stress at which the wheel yields, in MPa [default: that of a soft grade of its material]",
    ),
    Argument::new(
        "driver-strength",
        "MPA",
        ArgumentSlot::AboveZero(|question| &mut question.driver_strength),
        &[Parts],
        "Stress at which locking disc and plate yield, in MPa [default: that of a soft grade of their material]",
    ),
    Argument::new(
        "allowed-pressure",
        "MPA",
        ArgumentSlot::AboveZero(|question| &mut question.allowed_pressure),
        &[Parts],
        "Allowed pressure between pin and slot (Hertz), in MPa [default: that at which the weaker of both begins to yield]",
    ),
];
