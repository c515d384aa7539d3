//! Instants at which the motion is told.

use super::ActsOn::Motion;
use super::{Argument, ArgumentSlot};

pub(super) const ROWS: &[Argument] = &[
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
