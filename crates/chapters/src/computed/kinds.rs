//! The kinds of routes to our own numbers.

use geneva_evidence::{Agreement, Evidence, Tolerance};

/// Differences of coordinates lose some digits.
pub(super) const VECTORS: &Evidence = &Evidence {
    slug: "vectors-of-places",
    name: "vectors",
    meaning: "lengths and angles measured between points",
    agreement: Agreement::Within(&Tolerance {
        name: "vectors-of-places",
        relative: 1e-10,
        reason: "differences of coordinates lose some digits",
    }),
};

/// The solution errs by less than that.
pub(super) const QUADRATURE: &Evidence = &Evidence {
    slug: "crank-integrals",
    name: "quadrature",
    meaning: "the equation of motion solved over the crank angle, by integrals",
    agreement: Agreement::Within(&Tolerance {
        name: "crank-integrals",
        relative: 1e-9,
        reason: "the solution errs by less than that",
    }),
};

/// The motion with thick pins and rubbing journals, which no integral gives.
pub(super) const ANGLE_STEPS: &Evidence = &Evidence {
    slug: "angle-steps",
    name: "angle steps",
    meaning: "the equation of motion solved in steps of the crank angle, the flank decided beforehand",
    agreement: Agreement::Within(&Tolerance {
        name: "angle-steps",
        relative: 1e-8,
        reason: "the motion with thick pins and rubbing journals, which no integral gives",
    }),
};

/// A count, which is right or wrong.
pub(super) const COMPARISON: &Evidence = &Evidence {
    slug: "comparison",
    name: "comparison",
    meaning: "computed results compared with the printed ones",
    agreement: Agreement::Within(&Tolerance {
        name: "comparison",
        relative: 0.0,
        reason: "a count, which is right or wrong",
    }),
};

/// A count of runs by the program itself.
pub(super) const PROGRAM: &Evidence = &Evidence {
    slug: "program-counts",
    name: "program",
    meaning: "the program of 1973 run, or its deck",
    agreement: Agreement::Within(&Tolerance {
        name: "program-counts",
        relative: 0.0,
        reason: "a count of runs by the program itself",
    }),
};

/// A statistic of the study of the runs: how far its routes may be apart is said with each.
pub(super) const STUDY: &Evidence = &Evidence {
    slug: "study",
    name: "study",
    meaning: "a statistic of the study of the runs",
    agreement: Agreement::Within(&Tolerance {
        name: "study",
        relative: 0.0,
        reason: "a statistic of the study of the runs: how far its routes may be apart is said with each",
    }),
};

/// A rule that a standard gives and a program searches with.
pub(super) const SEARCH: &Evidence = &Evidence {
    slug: "search",
    name: "search",
    meaning: "a search through sizes in order",
    agreement: Agreement::Within(&Tolerance {
        name: "search",
        relative: 1e-12,
        reason: "a rule that a standard gives and a program searches with",
    }),
};

/// The motion by another crate's witness, with the factors of the equation that `geneva-dynamics` proves.
pub(super) const CRANK_STEPS: &Evidence = &Evidence {
    slug: "crank-steps",
    name: "crank steps",
    meaning: "the equation of motion solved in equal steps of the crank",
    agreement: Agreement::Within(&Tolerance {
        name: "crank-steps",
        relative: 1e-4,
        reason: "the motion by another crate's witness, with the factors of the equation that `geneva-dynamics` proves",
    }),
};

/// A point that is followed through many places of the crank meets its nearest place but for a little.
pub(super) const OUTLINES: &Evidence = &Evidence {
    slug: "outlines",
    name: "outlines",
    meaning: "points of outlines followed as the crank turns",
    agreement: Agreement::Within(&Tolerance {
        name: "outlines",
        relative: 2e-3,
        reason: "a point that is followed through many places of the crank meets its nearest place but for a little",
    }),
};

/// Numbers of a table that a standard prints, rounded there.
pub(super) const STANDARD: &Evidence = &Evidence {
    slug: "standard",
    name: "standard",
    meaning: "the table of a standard",
    agreement: Agreement::Within(&Tolerance {
        name: "standard",
        relative: 1e-12,
        reason: "numbers of a table that a standard prints, rounded there",
    }),
};

/// Sizes that grow with one size.
pub(super) const PROPORTION: &Evidence = &Evidence {
    slug: "proportion",
    name: "proportion",
    meaning: "sizes in proportion to those of another design",
    agreement: Agreement::Within(&Tolerance {
        name: "proportion",
        relative: 1e-12,
        reason: "sizes that grow with one size",
    }),
};

/// Laws of triangles with angles, which the problem's own solution uses.
pub(super) const TRIANGLE: &Evidence = &Evidence {
    slug: "triangle",
    name: "triangle",
    meaning: "the laws of sines and cosines",
    agreement: Agreement::Within(&Tolerance {
        name: "triangle",
        relative: 1e-10,
        reason: "laws of triangles with angles, which the problem's own solution uses",
    }),
};

/// The second derivative of a place loses some digits.
pub(super) const SERIES: &Evidence = &Evidence {
    slug: "series",
    name: "series",
    meaning: "a place differentiated by its power series",
    agreement: Agreement::Within(&Tolerance {
        name: "series",
        relative: 1e-10,
        reason: "the second derivative of a place loses some digits",
    }),
};

/// Printed lines of two programs whose steps see a change of the friction's sign at slightly different times.
pub(super) const PRINTOUT: &Evidence = &Evidence {
    slug: "print-out",
    name: "print out",
    meaning: "lines that a program prints",
    agreement: Agreement::Within(&Tolerance {
        name: "print-out",
        relative: 3e-4,
        reason: "printed lines of two programs whose steps see a change of the friction's sign at slightly different times",
    }),
};

/// Logarithms of likelihoods after a search for the best spreads.
pub(super) const DENSITIES: &Evidence = &Evidence {
    slug: "densities",
    name: "densities",
    meaning: "densities summed over each unit, the best spread sought by halving",
    agreement: Agreement::Within(&Tolerance {
        name: "densities",
        relative: 5e-3,
        reason: "logarithms of likelihoods after a search for the best spreads",
    }),
};

/// Cells counted after a search by slopes.
pub(super) const TANGENTS: &Evidence = &Evidence {
    slug: "tangents",
    name: "tangents",
    meaning: "Gauss and Newton's method over the motion in steps of the crank",
    agreement: Agreement::Within(&Tolerance {
        name: "tangents",
        relative: 0.0,
        reason: "cells counted after a search by slopes",
    }),
};

/// A number that the ledger computes for a claim, and its witness computes again.
pub(super) const LEDGER: &Evidence = &Evidence {
    slug: "ledger",
    name: "ledger",
    meaning: "what the ledger computes for claims, or their witnesses do",
    agreement: Agreement::Within(&Tolerance {
        name: "ledger",
        relative: 1e-3,
        reason: "a number that the ledger computes for a claim, and its witness computes again",
    }),
};

/// A count over printed numbers alone.
pub(super) const PRINTED: &Evidence = &Evidence {
    slug: "printed",
    name: "printed",
    meaning: "counted among the printed numbers",
    agreement: Agreement::Within(&Tolerance {
        name: "printed",
        relative: 0.0,
        reason: "a count over printed numbers alone",
    }),
};

/// A slope over a small step.
pub(super) const DIFFERENCE: &Evidence = &Evidence {
    slug: "difference",
    name: "difference",
    meaning: "a slope from two values of a formula nearby",
    agreement: Agreement::Within(&Tolerance {
        name: "difference",
        relative: 1e-6,
        reason: "a slope over a small step",
    }),
};

/// The interval of a share, evaluated.
pub(super) const INTERVAL: &Evidence = &Evidence {
    slug: "interval",
    name: "interval",
    meaning: "Wilson's formula for the interval of a share",
    agreement: Agreement::Within(&Tolerance {
        name: "interval",
        relative: 1e-9,
        reason: "the interval of a share, evaluated",
    }),
};

/// The interval of a share, sought.
pub(super) const TRIALS: &Evidence = &Evidence {
    slug: "trials",
    name: "trials",
    meaning: "shares tried one by one, whether what was counted allows them",
    agreement: Agreement::Within(&Tolerance {
        name: "trials",
        relative: 1e-6,
        reason: "the interval of a share, sought",
    }),
};
