//! Sizes that are not as drawn.

use super::ActsOn::Parts;
use super::{Argument, ArgumentSlot, Knob};

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "centre-error",
        "MM",
        ArgumentSlot::SignedLength(|question| &mut question.centre_error),
        &[Parts],
        "By how much the axes stand too far apart, in millimetres, or below zero too near: clearance and knock are those of \
         the parts so placed [default: 0]",
    )
    .with_knob(Knob::at("axes too far apart by", "mm", [-1.0, 1.0], 0.01, 0.0).typed([-10_000.0, 10_000.0])),
];
