//! The letters of the source.

use geneva_evidence::Symbol;

/// Each printed letter and the book's symbol. A letter that is listed twice has two meanings in the source.
pub const SYMBOLS: &[Symbol] = &[
    Symbol { printed: "P2", ours: r"P_2", meaning: "the pin, on the crank" },
    Symbol { printed: "P4", ours: r"P_4", meaning: "the lever's point under the pin" },
    Symbol { printed: "P2P4, P2/P4", ours: r"\mathrm{rel}", meaning: "of the pin relative to the lever" },
    Symbol { printed: "l2", ours: "R", meaning: "" },
    Symbol { printed: "r, l4", ours: "r", meaning: "" },
    Symbol { printed: r"\omega_2", ours: r"\dot\theta", meaning: "" },
    Symbol { printed: r"\omega_4", ours: r"\dot\varphi", meaning: "" },
    Symbol { printed: r"\alpha_4", ours: r"|\ddot\varphi|", meaning: "angular acceleration of the lever" },
    Symbol { printed: "r", ours: r"\vec{r}", meaning: "the vector from the lever's pivot to the pin" },
    Symbol { printed: "R", ours: r"\vec{r}_4", meaning: "the vector to the frame's origin, the lever's point" },
    Symbol { printed: "R", ours: r"\rho", meaning: "radius of curvature of the pin's path in the frame" },
    Symbol { printed: "p", ours: r"\vec{p}", meaning: "the vector from the frame's origin to the pin" },
    Symbol { printed: "oxy", ours: r"xy", meaning: "the frame that turns with the lever" },
    Symbol { printed: "β", ours: r"\beta", meaning: "angle at the pin between lever and crank" },
    Symbol { printed: "γ", ours: r"|\theta|", meaning: "angle at the crank's axis between crank and ground" },
    Symbol { printed: "v", ours: "v", meaning: "velocity" },
    Symbol { printed: "a, A", ours: r"a", meaning: "acceleration" },
    Symbol { printed: "n, t", ours: r"\mathrm{n}, \mathrm{t}", meaning: "normal to a path and along it" },
];
