//! Slips of the project that show in several places, each explained once.

use geneva_evidence::{Consequence, Origin, Slip};

/// The program puts the driver back after a quarter of a turn, whatever the number of pins.
pub(super) const RESET_ANGLE: Slip = Slip {
    id: "meyer.listing.fold",
    reason: "The next pin takes over after the driver has turned by 2π/m, where m is the number of pins. That is 90° \
             for four pins, but 60° for six and 120° for three. With 90°, the program follows a pin of the six-pin \
             mechanism to 60°, although the pin leaves its slot at 30°. In the three-pin mechanism the program drops \
             the pin at 30°, while the follower is still turning.",
    witness: "We computed the coordinates of all pins. The pin nearest to the follower's axis is always at the angle \
              that the corrected reset gives.",
    origin: Origin::Concept,
    consequence: Consequence::Result,
    changes: "The tables for six and three pins describe no mechanism, and neither do the curves drawn from them.",
};

/// The inertias of the six-pin runs are swapped in the heading.
pub(super) const SWAPPED_INERTIAS: Slip = Slip {
    id: "meyer.app-e.6-pin.driver",
    reason: "Compared with Fig. 11, the heading swaps the inertias of driver and follower. Only the assignment in Fig. \
             11 gives the table's peaks, minima and periods.",
    witness: "Fig. 11 gives the driver the inertia that the heading gives the follower, and vice versa. Its two values \
              agree with the inertias that we computed from the table's results by two routes.",
    origin: Origin::Misprint,
    consequence: Consequence::Result,
    changes: "If you recompute the table with the inertias in its heading, you do not get the table's numbers.",
};

/// The spring's torque is called a rate.
pub(super) const SPRING_RATE: Slip = Slip {
    id: "meyer.spring-rate",
    reason: "By Eq. (1-15) the torque of the spring is K itself, whatever the angle, and the text uses K in this way. \
             But a spring rate is a torque for each radian of winding. Inch-pounds per radian can be read as a torque, \
             which is the work done per radian, so only the word “rate” is wrong.",
    witness: "In Eq. (1-18) and in the program, K appears on its own where a torque is needed.",
    origin: Origin::Misprint,
    consequence: Consequence::Wording,
    changes: "",
};

/// The exponent 3/2 is printed for other half powers.
pub(super) const HALF_POWERS: Slip = Slip {
    id: "meyer.normal-force.substituted",
    reason: "R has the power 1/2, and two whole powers and a half power make 5/2. Three displays in a row print 3/2 in \
             place of both powers. We cannot tell whether the typist or the copy put it there. We count it as the \
             copy's mistake, because the two displays of R just before print 1/2 correctly, and because the powers in \
             Eq. (1-14), just after, follow from the right powers only.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members, but the \
              printed ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// The letter I_b is printed for I_D, in five displays.
pub(super) const DRIVER_INDEX: Slip = Slip {
    id: "meyer.momentum-rate.quotient.first-line",
    reason: "The inertia of the driver is I_D, as in Eq. (1-16) before these five displays and in Eq. (1-17) after \
             them, and the source has no I_b.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members, but the \
              printed ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// The square of a cos θ − 1 is missing twice in a row.
pub(super) const MISSING_SQUARE: Slip = Slip {
    id: "meyer.eq-1-17",
    reason: "The factor of the driver's acceleration is the same as in the line before, where the bracket is squared, \
             and Eq. (1-18) has the square again. The square is missing in two displays, the second of which is put \
             together from the first. We cannot tell whether the typist or the copy lost it. We count it as the copy's \
             mistake, because the square is right in the displays before and after these.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members, but the \
              printed ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// Bars that are lost.
pub(super) const LOST_BARS: Slip = Slip {
    id: "meyer.parts-put-in.second-line",
    reason: "Eq. (1-14), before these displays, and Eq. (1-19), after them, have the friction between bars. Two \
             displays have brackets instead, and brackets look much like bars. In Appendix B the bars and two dots are \
             gone, exactly where the text goes on to say how it deals with the bars. Without the bars, friction would \
             drive the mechanism wherever the pin presses on the other flank.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members, but the \
              printed ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// a cos θ that has become an inverse cosine.
pub(super) const ARC: Slip = Slip {
    id: "meyer.factor-b",
    reason: "The letters of a and cos run together in the copy we had. That makes an inverse cosine of a times the \
             cosine, here and in the display of A.",
    witness: "The corrected characters, read and evaluated, agree with Newton's laws for the two members, but the \
              printed ones do not.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// One dot is printed for two.
pub(super) const LOST_DOTS: Slip = Slip {
    id: "meyer.app-b.example",
    reason: "A second derivative has lost one of its two dots. In the example, the text asks for the derivative of \
             the highest order, which the program computes as a second derivative. In Appendix D the factor D belongs \
             to the acceleration, as in Eq. (1-19), and the speed is zero.",
    witness: "We read and evaluated the corrected characters. The example holds for a vibration, and Appendix D agrees \
              with Eq. (1-19). With the printed characters, neither is true.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// The name LDX is printed for 1DX.
pub(super) const ONE_AS_L: Slip = Slip {
    id: "meyer.app-b.example.second",
    reason: "The name begins with the order of the derivative, as 2DX does, but here the letter L has replaced the \
             digit one. The listing has a one throughout. We cannot tell whether the L is the copy's or the typist's.",
    witness: "The program has the name with a one.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// The equation with its bars is said to have no solution for the acceleration.
pub(super) const SOLVED_WITH_BARS: Slip = Slip {
    id: "meyer.app-b.cannot-be-solved",
    reason: "Where A > |D|, as in all runs of the thesis, the left side of Aθ'' + Bθ'² + |Cθ'² + Dθ''| = E grows with \
             θ'' throughout, so there is one solution: θ'' = [A(E − Bθ'²) + CDθ'² − |ACθ'² + D(E − Bθ'²)|]/(A² − D²). \
             This formula is right whatever the sign of the expression between the bars of the equation. So we need to \
             know neither that sign nor an earlier acceleration.",
    witness: "We computed A to E from the mechanism's coordinates and Newton's laws. With these factors, the formula \
              gives the acceleration that the laws require.",
    origin: Origin::Concept,
    consequence: Consequence::Remark,
    changes: "With this formula the program could do without the sign S, and so without the earlier acceleration and \
              the delay line that supplies it.",
};

/// A number in a row that nothing explains, because neither the mechanism nor the program gives it.
pub(super) const UNEXPLAINED: Slip = Slip {
    id: "",
    reason: "With four pins, the program resets the driver's angle correctly, so both the program and the mechanism \
             should give the printed peak. But both give a higher peak. The largest speed that the program prints \
             exceeds the printed peak by more than one and a half units of the last digit. The mechanism's own peak, \
             which we give as the right one, exceeds the printed peak by more than two and a half units. The minimum \
             and the period in the same row do agree. We do not know how the printed peak came about.",
    witness: "We computed the mechanism's steady cycle by quadrature and in Runge-Kutta steps, and both results have a \
              higher peak than the printed one.",
    origin: Origin::Unknown,
    consequence: Consequence::Result,
    changes: "The printed peak is too low by more than one per cent.",
};

/// The greatest printed speed is taken for the greatest.
pub(super) const SAMPLED_PEAKS: Slip = Slip {
    id: "meyer.cyclic-oscillations",
    reason: "The print-out has one line for each print interval, so the true peak falls between two lines, sometimes \
             nearer to one of them and sometimes farther away. The stronger the spring, the shorter the peak, and the \
             more of its height the lines miss. In the steady motion of a run, the true peaks are all equal, and with \
             more torque all of them grow as its square root.",
    witness: "If the program prints far more often, with everything else as in the listing, the peaks that it prints \
              in the steady motion are equal to within one unit of the tables.",
    origin: Origin::Concept,
    consequence: Consequence::Result,
    changes: "The thesis wants these oscillations investigated, but they are not in the mechanism: they disappear if \
              the print-out has more lines per second. Where the true peak lasts only a short time, the printed peak \
              is too low.",
};

/// A pin is said to have to enter along the slot, so that only three mechanisms are left.
pub(super) const ENTRY_ALONG_THE_SLOT: Slip = Slip {
    id: "meyer.conclusion.three",
    reason: "An entering pin strikes the slot's wall if pin and wall have different velocities across the slot. So if \
             the follower is at rest, the pin must move along the slot. But if the follower is turning, the pin's \
             velocity across the slot must equal the wall's. The velocity ratio is an even function of the driver's \
             angle. Therefore the leaving pin and the entering pin require the same speed of the follower, and nothing \
             strikes. This holds whatever the numbers of pins and slots, as long as there are enough of each to make a \
             mechanism. For example, take five pins, five slots and a centre distance of the golden ratio times the \
             crank radius. Each pin then takes over from the pin before it without a blow, although the follower never \
             stops. Eq. (1-3) selects the mechanisms whose follower is at rest at each hand-over, and there are three \
             of them.",
    witness: "We computed the velocities of pins and slots from coordinates. For mechanisms with other numbers of pins \
              and slots we also integrated the motion with friction, in steps. Each of these mechanisms reaches a \
              terminal velocity.",
    origin: Origin::Concept,
    consequence: Consequence::Conclusion,
    changes: "There are more than three mechanisms to choose from, because in many others each pin also takes over \
              from the pin before it without a blow.",
};

/// The follower's angle φ has become the driver's angle θ.
pub(super) const PHI_AS_THETA: Slip = Slip {
    id: "meyer.cosine-substituted",
    reason: "The copy has the driver's angle θ where the follower's angle φ is needed. In the two equations of \
             moments, the index of I_f has become a P as well. We count this as a mistake of the copy, because the \
             displays around each place have φ and I_f.",
    witness: "We measured angles, lengths and accelerations between axes and pin at instants of all three escapements.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};
