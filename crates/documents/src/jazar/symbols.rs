//! The letters of the handout and the book's.

use geneva_evidence::Symbol;

/// Each letter and the book's symbol.
pub const SYMBOLS: &[Symbol] = &[
    Symbol { printed: "r", ours: "R", meaning: "the source calls it pin radius before Eq. (5.30)" },
    Symbol { printed: "x", ours: "r", meaning: "the source does not explain it" },
    Symbol { printed: "θ", ours: r"\theta", meaning: "" },
    Symbol { printed: "ϕ", ours: r"\varphi", meaning: "" },
    Symbol { printed: "α", ours: r"\alpha", meaning: "" },
    Symbol { printed: "γ", ours: r"\gamma", meaning: "coefficient of the quadratic for the peak" },
    Symbol { printed: "λ", ours: r"\text{dwell time}/T", meaning: "part of the cycle that is dwell" },
    Symbol { printed: "τ", ours: r"\text{dwell time}", meaning: "time of the dwell" },
    Symbol { printed: "T", ours: "T", meaning: "time of a cycle" },
    Symbol { printed: "N", ours: "N", meaning: "" },
];
