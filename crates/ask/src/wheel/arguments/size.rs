//! How large the wheel is.

use super::ActsOn::{Parts, Size};
use super::{Argument, ArgumentSlot, Knob};

/// The group of ways to say how large the wheel is.
const SIZES: &str = "size";

/// What can be typed for a size, in millimetres.
const TYPED: [f64; 2] = [0.1, 10_000.0];

pub(super) const ROWS: &[Argument] = &[
    Argument::new(
        "crank-radius",
        "MM",
        ArgumentSlot::Length(|question| &mut question.crank_radius),
        &[Size],
        "Distance from the driver's axis to a pin's centre, in millimetres; give this or one of the next four for sizes in \
         mm",
    )
    .with_knob(Knob::at("crank radius", "mm", [5.0, 100.0], 0.5, 25.0).typed(TYPED).on_side(SIZES, 0).told_by("crank_radius_mm")),
    Argument::new(
        "centre-distance",
        "MM",
        ArgumentSlot::Length(|question| &mut question.centre_distance),
        &[Size],
        "Distance between the two axes, in millimetres",
    )
    .with_knob(
        Knob::follows("or centre distance", "mm", [5.0, 300.0], 0.5, "centre_distance_mm").typed(TYPED).on_side(SIZES, 1),
    ),
    Argument::new(
        "wheel-radius",
        "MM",
        ArgumentSlot::Length(|question| &mut question.wheel_radius),
        &[Size],
        "Distance from the wheel's axis to a pin's centre as the pin enters, in millimetres",
    )
    .with_knob(
        Knob::follows("or wheel radius", "mm", [5.0, 300.0], 0.5, "wheel_radius_mm").typed(TYPED).on_side(SIZES, 2),
    ),
    Argument::new(
        "outside-diameter",
        "MM",
        ArgumentSlot::Length(|question| &mut question.outside_diameter),
        &[Size, Parts],
        "Diameter of the wheel over the corners of its slots, in millimetres, as it is measured on a wheel to be replaced",
    )
    .with_knob(
        Knob::follows("or outside diameter", "mm", [10.0, 600.0], 0.5, "outside_diameter_mm")
            .typed(TYPED)
            .on_side(SIZES, 3),
    ),
    Argument::new(
        "thickness",
        "MM",
        ArgumentSlot::Length(|question| &mut question.thickness),
        &[Parts],
        "Thickness of the wheel, in millimetres [default: the pin's diameter, rounded up to a whole millimetre from 1 mm on]",
    )
    .with_knob(Knob::at("thickness of the wheel", "mm", [1.0, 50.0], 0.5, 10.0).typed([0.001, 10_000.0])),
];
