//! The letters of the source.

use geneva_evidence::Symbol;

/// Each printed letter and the symbol in the book's chapters on the source.
///
/// A letter that is listed twice has two meanings in the source.
pub const SYMBOLS: &[Symbol] = &[
    Symbol { printed: "r", ours: "R", meaning: "" },
    Symbol { printed: "c", ours: "l", meaning: "" },
    Symbol { printed: "a", ours: "k", meaning: "" },
    Symbol { printed: "R", ours: "r", meaning: "" },
    Symbol { printed: "n, N", ours: "N", meaning: "N in the program" },
    Symbol { printed: "m", ours: "m", meaning: "" },
    Symbol { printed: "θ", ours: r"\theta", meaning: "" },
    Symbol { printed: "φ", ours: r"\varphi", meaning: "" },
    Symbol { printed: "θ_0", ours: r"\theta_0", meaning: "driver's angle at the hand-over; chapter I gives its size" },
    Symbol { printed: "φ_0", ours: r"\varphi_0", meaning: "follower's angle at the hand-over" },
    Symbol {
        printed: "θ_∞", ours: r"\theta_\infty", meaning: "driver's angle at which a denominator would be zero"
    },
    Symbol { printed: "I_D, I_d, I_b", ours: "I_D", meaning: "moment of inertia of the driver" },
    Symbol { printed: "I_f, I_P", ours: "I_f", meaning: "moment of inertia of the follower" },
    Symbol { printed: "μ", ours: r"\mu", meaning: "coefficient of friction between pin and slot" },
    Symbol { printed: "N", ours: "F", meaning: "normal force between pin and slot" },
    Symbol { printed: "h", ours: "h", meaning: "moment arm of the friction about the driver's axis" },
    Symbol { printed: "τ, Q_θ", ours: r"\tau", meaning: "torque on the driver, the generalised force" },
    Symbol { printed: "τ_1, K", ours: "K", meaning: "torque of the spring" },
    Symbol { printed: "τ_2", ours: r"\tau_2", meaning: "torque of the friction on the driver" },
    Symbol { printed: "T", ours: "T", meaning: "kinetic energy" },
    Symbol { printed: "A, B, C, D, E", ours: "A, B, C, D, E", meaning: "factors of the equation of motion" },
    Symbol {
        printed: "F",
        ours: r"C\dot\theta^2 + D\ddot\theta",
        meaning: "the expression between the absolute-value bars",
    },
    Symbol { printed: "S", ours: "S", meaning: "sign of the expression between the absolute-value bars" },
    Symbol { printed: "A, B", ours: r"\dot{x}_0, x_0", meaning: "initial values in the example of the program" },
    Symbol { printed: "R", ours: "A_0", meaning: "factor A at the start" },
    Symbol { printed: "V", ours: "|D_0|", meaning: "factor D at the start; in the program, its size" },
    Symbol { printed: "m", ours: r"\rho", meaning: "mass density" },
    Symbol { printed: "m", ours: "M", meaning: "mass in the example of the program" },
    Symbol { printed: "c", ours: r"\delta", meaning: "damping in the example of the program" },
    Symbol { printed: "k", ours: r"\kappa", meaning: "stiffness in the example of the program" },
    Symbol { printed: "r", ours: r"r_\mathrm{d}", meaning: "radius of a disc" },
    Symbol { printed: "t", ours: "b", meaning: "thickness of a disc" },
    Symbol { printed: "t", ours: "t", meaning: "time" },
    Symbol { printed: "h", ours: r"\Delta t", meaning: "step of the integration" },
    Symbol { printed: "x_n, y_n", ours: "x_n, y_n", meaning: "time and state at the beginning of a step" },
    Symbol { printed: "f_1, f_2, f_3, f_4", ours: "f_1, f_2, f_3, f_4", meaning: "slopes in a step" },
    Symbol { printed: "x", ours: "x", meaning: "position in the example of the program" },
    Symbol { printed: "δW", ours: r"\delta W", meaning: "virtual work" },
    Symbol { printed: "I", ours: r"k\sin\theta", meaning: "in the program; elsewhere a moment of inertia" },
];
