//! The claims of the section, in its order.

mod additional;
mod calculus;
mod challenge;
mod drag_forces;
mod further;
mod problems;
mod terminal;

use geneva_evidence::{Claim, QuantityUnit};

/// All claims.
pub(crate) fn all() -> Vec<Claim> {
    [
        drag_forces::claims(),
        terminal::claims(),
        calculus::claims(),
        problems::claims(),
        additional::claims(),
        further::claims(),
        challenge::claims(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The claims that print answers to the exercises and examples.
pub(crate) const ANSWERS: &[&str] = &[
    "drag.spread-eagle",
    "drag.light-spread-eagle",
    "drag.boat-way",
    "drag.heavy-factor",
    "drag.head-speed",
    "drag.head-speed-road",
    "drag.squirrel-speed",
    "drag.person-speed",
    "drag.car-factor",
    "drag.oil-viscosity",
    "drag.diamond-factor",
    "drag.diamond-way",
    "drag.scale",
    "drag.scale-ratio",
    "drag.string-tension",
    "drag.block-tension",
    "drag.bin-force",
    "drag.barge-acceleration",
    "drag.barge-tension",
    "drag.object-speed",
    "drag.belt-time",
    "drag.two-block-acceleration",
    "drag.crate-static",
    "drag.crate-up",
    "drag.crate-up-force",
    "drag.crate-down",
    "drag.road-friction",
    "drag.ball-top",
    "drag.ball-bottom",
    "drag.ball-side",
    "drag.cyclist",
    "drag.bacon",
    "drag.turn-radius",
    "drag.pulled-blocks",
    "drag.truck-way",
    "drag.stopping-way",
    "drag.parachute-speed",
    "drag.parachute-fall",
    "drag.parachute-limit",
    "drag.parachute-time",
    "drag.thrust-limit",
];

/// The units of the quantities, by the words with which their meanings begin.
pub(crate) const UNITS: &[QuantityUnit] = &[
    ("share of the power", "%"),
    ("speed in miles per hour", "mi/h"),
    ("speed in kilometres per hour", "km/h"),
    ("speed in micrometres per second", "μm/s"),
    ("speed of", "m/s"),
    ("coefficient", ""),
    ("decrease", "%"),
    ("remaining part of the speed", "× 10⁻⁵"),
    ("part of the way", ""),
    ("rate of slowing", "s⁻¹"),
    ("way", "m"),
    ("factor of the square", "kg/m"),
    ("factor of the speed", "kg/s"),
    ("ratio", ""),
    ("area", "m²"),
    ("viscosity", "kg/(m·s)"),
    ("force", "N"),
    ("thousands of newtons", "× 10³ N"),
    ("weight in pounds", "lb"),
    ("acceleration over gravity", "× g"),
    ("acceleration of", "m/s²"),
    ("time", "s"),
];
