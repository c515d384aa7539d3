//! Kinds of evidence that a section on forces has beside those of every subject.

use geneva_evidence::{Agreement, Evidence, Tolerance};

/// For what is found by moving a body in small steps of time.
static STEPPING: Tolerance = Tolerance {
    name: "small steps",
    relative: 1e-9,
    reason: "four thousand steps of the fourth order are wrong by less than a part in a thousand million, where a body moves \
             for a few of its time constants, but a wrong law differs in the first few digits",
};

/// A motion, or an area under a curve, in small steps.
pub const IN_STEPS: &Evidence = &Evidence {
    slug: "in-steps",
    name: "small steps",
    meaning: "an equation of motion or an integral worked in small steps",
    agreement: Agreement::Within(&STEPPING),
};
/// The laws of motion of all bodies, written down one by one and solved together.
pub const BALANCE: &Evidence = &Evidence::between_routes(
    "balance",
    "forces on each body",
    "the forces on each body, with its law of motion, solved for all unknowns at once",
);
/// Work and energy.
pub const ENERGY: &Evidence = &Evidence::between_routes(
    "energy",
    "work and energy",
    "the work of the forces compared with the energy, or their power",
);
/// The definitions of units.
pub const UNITS: &Evidence =
    &Evidence::between_routes("units", "units", "another unit by its definition, such as the mile of 1609.344 m");
