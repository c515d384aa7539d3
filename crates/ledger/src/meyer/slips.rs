//! Slips of the project that show in several places, each told once.

use crate::{Consequence, Origin, Slip};

/// The program puts the driver back after a quarter of a turn, whatever the number of pins.
pub const RESET_ANGLE: Slip = Slip {
    id: "meyer.listing.fold",
    reason: "The next pin takes over after 2π/m of the driver: 90° for four pins, but 60° for six and 120° for three. \
             With 90° the pin of six is followed to 60°, 30° beyond the end of its slot, and that of three is dropped \
             at 30° while the follower turns.",
    witness: "Of all pins by their coordinates, the one next to the follower's axis is where the corrected angle says.",
    origin: Origin::Concept,
    consequence: Consequence::Result,
    changes: "The tables for six and three pins are those of no mechanism, and the curves drawn from them too.",
};

/// The inertias of the six-pin runs stand in the heading the other way round.
pub const SWAPPED_INERTIAS: Slip = Slip {
    id: "meyer.app-e.6-pin.driver",
    reason: "The heading has the two members the other way round from Fig. 11. Only Fig. 11's choice gives the table's \
             peaks, minima and periods.",
    witness: "Fig. 11 prints the two the other way round, and the inertias that are found from the table's results, \
              by two routes, agree with it.",
    origin: Origin::Misprint,
    consequence: Consequence::Result,
    changes: "Who recomputes the table with the inertias of its heading does not find it.",
};

/// The spring's torque is called a rate.
pub const SPRING_RATE: Slip = Slip {
    id: "meyer.spring-rate",
    reason: "The torque of the spring is K itself, Eq. (1-15), whatever the angle, and the text uses it so. A rate \
             of a spring is a torque for each radian of winding. An inch-pound per radian can be read as a \
             torque, the work done per radian; only the word is wrong.",
    witness: "In Eq. (1-18) and in the program K stands alone where a torque must stand.",
    origin: Origin::Misprint,
    consequence: Consequence::Wording,
    changes: "",
};

/// 3/2 for other half powers.
pub const HALF_POWERS: Slip = Slip {
    id: "meyer.normal-force.substituted",
    reason: "R has the power 1/2, and two whole powers and a half make 5/2. Three displays in a row have 3/2 for both. \
             Whether the typist or the copy has put it there cannot be told. It is counted as the copy's, because 1/2 \
             stands right in the two displays of R just before, and Eq. (1-14), just after, has the powers that only \
             the right ones give.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members; the printed \
              ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// I_b for I_D, in five displays.
pub const DRIVER_INDEX: Slip = Slip {
    id: "meyer.momentum-rate.quotient.first-line",
    reason: "The inertia of the driver is I_D, as in Eq. (1-16) before and in Eq. (1-17) after these five displays; \
             the source has no I_b.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members; the printed \
              ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// The square of a cos θ − 1 is missing twice in a row.
pub const MISSING_SQUARE: Slip = Slip {
    id: "meyer.eq-1-17",
    reason: "The factor of the driver's acceleration is that of the line before, where the bracket is squared; Eq. \
             (1-18) has the square again. It is missing in two displays, of which the second is put together from the \
             first. Whether the typist or the copy has lost it cannot be told. It is counted as the copy's, because it \
             stands right in the displays before and after these.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members; the printed \
              ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// Bars that are lost.
pub const LOST_BARS: Slip = Slip {
    id: "meyer.parts-put-in.second-line",
    reason: "Friction stands between bars in Eq. (1-14), before, and in Eq. (1-19), after. In two displays brackets \
             stand in their place, which look much alike; in Appendix B they are gone, and two dots with them, where \
             the text goes on to say how they are dealt with. Without them friction would drive the mechanism wherever \
             the pin presses on the other flank.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members; the printed \
              ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// a cos θ that has become an inverse cosine.
pub const ARC: Slip = Slip {
    id: "meyer.factor-b",
    reason: "The letters of a and cos run together in the copy, which makes an inverse cosine of a times the cosine, \
             here and in the display of A.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members; the printed \
              ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// One dot for two.
pub const LOST_DOTS: Slip = Slip {
    id: "meyer.app-b.example",
    reason: "A second derivative has lost one of its two dots. In the example the text asks for the derivative of the \
             highest order, and the program computes the second; in Appendix D the factor D belongs to the \
             acceleration, as in Eq. (1-19), and the speed is zero.",
    witness: "The corrected characters, read and evaluated, hold for a vibration, and Appendix D's go with Eq. (1-19); the \
              printed ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// LDX for 1DX.
pub const ONE_AS_L: Slip = Slip {
    id: "meyer.app-b.example.second",
    reason: "The name begins with the order of the derivative, as 2DX does: here stands the letter L for the one. \
             The listing has a one throughout. Whether the copy or the typist put the L cannot be told.",
    witness: "The program has the name with a one.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// The equation with its bars is said to have no solution for the acceleration.
pub const SOLVED_WITH_BARS: Slip = Slip {
    id: "meyer.app-b.cannot-be-solved",
    reason: "Where A > |D|, as in all runs of the thesis, θ'' = [A(E − Bθ'²) + CDθ'² − |ACθ'² + D(E − Bθ'²)|]/(A² − D²): \
             the left side of the equation then grows with θ'' throughout, and the formula is the solution of whichever \
             sign the bars have. No sign has to be known, and no acceleration of a moment before.",
    witness: "With the factors from the mechanism by coordinates and Newton's laws, the formula gives the acceleration of \
              these laws.",
    origin: Origin::Concept,
    consequence: Consequence::Remark,
    changes: "The sign S, the old acceleration and the delay line of the program are not needed.",
};

/// A number in a row that nothing explains: neither the mechanism nor the program gives it.
pub const UNEXPLAINED: Slip = Slip {
    id: "",
    reason: "The reset of the program is right for four pins, so mechanism and program agree here, and both differ from the \
             printed peak by more than two units of its last digit. The minimum and the period of the same row fit. How the \
             peak came to be printed is not known.",
    witness: "The steady cycle of the mechanism, by quadrature and by Runge-Kutta steps, has a higher peak.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Result,
    changes: "The peak of the row is too low, by more than a per cent.",
};

/// The greatest printed speed is taken for the greatest.
pub const SAMPLED_PEAKS: Slip = Slip {
    id: "meyer.cyclic-oscillations",
    reason: "The lines of a run are a print interval apart, and the peak falls between them, now nearer to one, now \
             farther. The stronger the spring, the shorter the peak and the more is missed. The peaks of the steady \
             motion themselves are equal, and grow as the root of the torque.",
    witness: "The program with all its particulars, printing far more often, shows equal peaks.",
    origin: Origin::Concept,
    consequence: Consequence::Result,
    changes: "There is nothing in the mechanism to investigate: closer lines make the oscillations disappear. Printed \
              peaks are too small where the peak is short.",
};

/// A pin is said to have to enter along the slot, so that only three mechanisms are left.
pub const ENTRY_ALONG_THE_SLOT: Slip = Slip {
    id: "meyer.conclusion.three",
    reason: "A pin strikes the slot's wall if the two have different velocities across the slot. So the pin must move \
             along the slot if the follower is at rest; if the follower turns it must not. The velocity ratio is an \
             even function of the driver's angle: the leaving and the entering pin ask the follower for one speed, \
             whatever the numbers of pins and slots, and nothing strikes (few of either do not make a mechanism). Five pins and five slots, with the axes a \
             golden ratio of the pins' radius apart, do so while the follower never stops. Eq. (1-3) tells which \
             mechanisms have the follower at rest at each hand-over: those are the three.",
    witness: "Pins and slots by coordinates, and the motion of the other pairs in steps, with friction: it reaches a \
              terminal velocity.",
    origin: Origin::Concept,
    consequence: Consequence::Conclusion,
    changes: "The choice is not of three mechanisms: in many others one pin takes over from the next without a blow.",
};

/// The follower's angle φ has become the driver's angle θ.
pub const PHI_AS_THETA: Slip = Slip {
    id: "meyer.cosine-substituted",
    reason: "The follower's angle φ must stand where the copy has the driver's angle θ; in the two equations of \
             moments the index of I_f has become a P as well. Counted as a slip of the copy, because the displays \
             around each place have φ, and I_f.",
    witness: "Angles, lengths and accelerations measured between axes and pin, at instants of all three escapements.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};
