//! The kinds of evidence that the claims of these documents use, with the tolerances of those that are their own.

use geneva_evidence::{Agreement, Evidence, Tolerance};

/// The equation of motion solved over the driver's angle.
pub const QUADRATURE: &Evidence = &Evidence::between_routes(
    "quadrature",
    "integrals over the driver's angle",
    "the equation of motion solved over the driver's angle, by integrals",
);

/// The equation of motion solved step by step.
pub const RUNGE_KUTTA: &Evidence = &Evidence {
    slug: "runge-kutta",
    name: "integration in steps",
    meaning: "the equation of motion solved in steps of time or angle",
    agreement: Agreement::Within(&STEPS_TOLERANCE),
};

/// The program of 1973 as it is listed, on its integrator.
pub const PROGRAM: &Evidence = &Evidence {
    slug: "program",
    name: "the program of 1973",
    meaning: "the program of 1973 run as it is listed, on an integrator like its own",
    agreement: Agreement::Within(&PROGRAM_TOLERANCE),
};

/// All kinds, in the order in which readers see them.
pub const EVIDENCE: &[&Evidence] = &[
    Evidence::CLOSED_FORM,
    Evidence::EXACT_IDENTITY,
    Evidence::JET,
    Evidence::AUTOMATIC_DERIVATIVE,
    Evidence::VECTORS,
    Evidence::LIMIT_CASE,
    Evidence::DIMENSION,
    Evidence::OTHER_PLACE_IN_SOURCE,
    QUADRATURE,
    RUNGE_KUTTA,
    PROGRAM,
];

/// For a number that a step-by-step integration gives a second time.
pub static STEPS_TOLERANCE: Tolerance = Tolerance {
    name: "steps",
    relative: 1e-5,
    reason: "whatever the method, a step over a place where the friction changes its sign is less accurate than other \
             steps. But the printed tables have three digits, and a wrong equation differs in the first or second \
             digit",
};

/// For a number that the program of 1973 prints, and the same by other steps.
pub static PROGRAM_TOLERANCE: Tolerance = Tolerance {
    name: "program",
    relative: 3e-4,
    reason: "the program takes the sign of the friction from a slightly earlier acceleration. If the sign changes \
             within a step, two ways of stepping see the change at different times, but these times differ by only \
             a part of the short delay. The printed tables have three digits, and a wrong equation differs in the \
             first or second digit",
};
