//! The kinds of routes to our own numbers.

use super::own_number::RouteKind;

/// Two chains of a dozen operations differ by some units in the last place.
pub const FORMULA: RouteKind = RouteKind { slug: "formula", meaning: "a formula evaluated", tolerance: 1e-12 };

/// Differences of coordinates lose some digits.
pub const VECTORS: RouteKind =
    RouteKind { slug: "vectors", meaning: "lengths and angles measured between points", tolerance: 1e-10 };

/// The solution errs by less than that.
pub const QUADRATURE: RouteKind = RouteKind {
    slug: "quadrature",
    meaning: "the equation of motion solved over the crank angle, by integrals",
    tolerance: 1e-9,
};

/// The motion with thick pins and rubbing journals, which no integral gives.
pub const ANGLE_STEPS: RouteKind = RouteKind {
    slug: "angle-steps",
    meaning: "the equation of motion solved in steps of the crank angle, the flank decided beforehand",
    tolerance: 1e-8,
};

/// A count, which is right or wrong.
pub const COMPARISON: RouteKind =
    RouteKind { slug: "comparison", meaning: "computed results compared with the printed ones", tolerance: 0.0 };

/// A count of runs by the program itself.
pub const PROGRAM: RouteKind =
    RouteKind { slug: "program", meaning: "the program of 1973 run, or its deck", tolerance: 0.0 };

/// A statistic of the study of the runs: how far its routes may be apart is said with each.
pub const STUDY: RouteKind =
    RouteKind { slug: "study", meaning: "a statistic of the study of the runs", tolerance: 0.0 };

/// A rule that a standard gives and a program searches with.
pub const SEARCH: RouteKind =
    RouteKind { slug: "search", meaning: "a search through sizes in order", tolerance: 1e-12 };

/// The motion by another crate's witness, with the factors of the equation that `geneva-dynamics` proves.
pub const CRANK_STEPS: RouteKind = RouteKind {
    slug: "crank-steps",
    meaning: "the equation of motion solved in equal steps of the crank",
    tolerance: 1e-4,
};

/// A point that is followed through many places of the crank meets its nearest place but for a little.
pub const OUTLINES: RouteKind =
    RouteKind { slug: "outlines", meaning: "points of outlines followed as the crank turns", tolerance: 2e-3 };

/// Numbers of a table that a standard prints, rounded there.
pub const STANDARD: RouteKind = RouteKind { slug: "standard", meaning: "the table of a standard", tolerance: 1e-12 };

/// Sizes that grow with one size.
pub const PROPORTION: RouteKind =
    RouteKind { slug: "proportion", meaning: "sizes in proportion to those of another design", tolerance: 1e-12 };

/// Laws of triangles with angles, which the problem's own solution uses.
pub const TRIANGLE: RouteKind =
    RouteKind { slug: "triangle", meaning: "the laws of sines and cosines", tolerance: 1e-10 };

/// The second derivative of a place loses some digits.
pub const SERIES: RouteKind =
    RouteKind { slug: "series", meaning: "a place differentiated by its power series", tolerance: 1e-10 };

/// Printed lines of two programs whose steps see a change of the friction's sign at slightly different times.
pub const PRINTOUT: RouteKind =
    RouteKind { slug: "print-out", meaning: "lines that a program prints", tolerance: 3e-4 };

/// Logarithms of likelihoods after a search for the best spreads.
pub const DENSITIES: RouteKind = RouteKind {
    slug: "densities",
    meaning: "densities summed over each unit, the best spread sought by halving",
    tolerance: 5e-3,
};

/// Cells counted after a search by slopes.
pub const TANGENTS: RouteKind = RouteKind {
    slug: "tangents",
    meaning: "Gauss and Newton's method over the motion in steps of the crank",
    tolerance: 0.0,
};

/// A number that the ledger computes for a claim, and its witness computes again.
pub const LEDGER: RouteKind = RouteKind {
    slug: "ledger",
    meaning: "what the ledger computes for claims, or their witnesses do",
    tolerance: 1e-3,
};

/// A count over printed numbers alone.
pub const PRINTED: RouteKind =
    RouteKind { slug: "printed", meaning: "counted among the printed numbers", tolerance: 0.0 };

/// A slope over a small step.
pub const DIFFERENCE: RouteKind =
    RouteKind { slug: "difference", meaning: "a slope from two values of a formula nearby", tolerance: 1e-6 };

/// The interval of a share, evaluated.
pub const INTERVAL: RouteKind =
    RouteKind { slug: "interval", meaning: "Wilson's formula for the interval of a share", tolerance: 1e-9 };

/// The interval of a share, sought.
pub const TRIALS: RouteKind = RouteKind {
    slug: "trials",
    meaning: "shares tried one by one, whether what was counted allows them",
    tolerance: 1e-6,
};
