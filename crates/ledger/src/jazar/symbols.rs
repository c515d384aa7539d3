//! The letters of the handout and the book's.

use crate::Symbol;

/// Each letter and the book's symbol.
pub const SYMBOLS: &[Symbol] = &[
    Symbol {
        printed: "r",
        ours: "R",
        meaning: "crank radius, the radius of the circle of the pin's centre, which is called pin radius before Eq. \
                  (5.30)",
    },
    Symbol {
        printed: "x",
        ours: "r",
        meaning: "distance of the pin from the wheel's axis, which the source does not explain",
    },
    Symbol { printed: "θ", ours: r"\theta", meaning: "crank angle from the line of centres" },
    Symbol { printed: "ϕ", ours: r"\varphi", meaning: "wheel angle from the line of centres, in the opposite sense" },
    Symbol { printed: "α", ours: r"\alpha", meaning: "half the angle between neighbouring slots" },
    Symbol { printed: "γ", ours: r"\gamma", meaning: "coefficient of the quadratic for the peak" },
    Symbol { printed: "λ", ours: r"\lambda", meaning: "part of the cycle that is dwell" },
    Symbol { printed: "τ", ours: r"\tau", meaning: "time of the dwell" },
    Symbol { printed: "T", ours: "T", meaning: "time of a cycle" },
    Symbol { printed: "N", ours: "N", meaning: "number of stations" },
];
