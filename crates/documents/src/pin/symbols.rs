//! The letters of the source. In the copy, its Greek letters and its arrows have become Latin letters.

use geneva_evidence::Symbol;

/// Each printed letter and the book's symbol. A letter that is listed twice has two meanings in the source.
pub const SYMBOLS: &[Symbol] = &[
    Symbol { printed: "R", ours: "R", meaning: "" },
    Symbol { printed: "r", ours: "r", meaning: "" },
    Symbol { printed: "l", ours: "l", meaning: "" },
    Symbol { printed: "O, B, P", ours: "O, B, P", meaning: "axis of the wheel, axis of the driver, the pin" },
    Symbol { printed: "P′", ours: "P'", meaning: "the point of the wheel under the pin" },
    Symbol { printed: "f", ours: r"180^\circ + \theta", meaning: "angle of the crank, from the direction OB" },
    Symbol { printed: "b", ours: r"|\varphi|", meaning: "angle of the slot at O" },
    Symbol { printed: "g", ours: r"\gamma", meaning: "angle between the pin's velocity and the slot" },
    Symbol {
        printed: "v",
        ours: r"\dot\theta, \dot\varphi",
        meaning: "angular velocity, with the index of a disk (also printed V)",
    },
    Symbol { printed: "v", ours: r"v", meaning: "speed, with the index of a point" },
    Symbol { printed: "v", ours: r"\vec{v}", meaning: "velocity, printed upright" },
    Symbol { printed: "d", ours: r"\swarrow", meaning: "arrow before an angle that is measured from the horizontal" },
    Symbol { printed: "f", ours: r"\searrow", meaning: "arrow before an angle that is measured from the vertical" },
    Symbol { printed: "i", ours: r"\circlearrowright", meaning: "arrow that shows a sense of rotation" },
    Symbol { printed: r"1 \overline{2}", ours: r"\sqrt{2}", meaning: "a root" },
];
