//! Slips of the project that show in several places, each told once.

use crate::{Consequence, Origin, Slip};

/// The program puts the driver back after a quarter of a turn, whatever the number of pins.
pub const RESET_ANGLE: Slip = Slip {
    id: "meyer.listing.fold",
    reason: "The next pin takes over after 2π/m of the driver: 90° for four pins, but 60° for six and 120° for three. With \
             90° the pin of six is followed to 60°, 30° beyond the end of its slot, and that of three is dropped at 30° \
             while the follower turns.",
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
    witness: "Fig. 11 prints the two the other way round, and the minima of the table, computed in steps, agree with it.",
    origin: Origin::Misprint,
    consequence: Consequence::Result,
    changes: "Who recomputes the table with the inertias of its heading does not find it.",
};

/// The spring's torque is called a rate or a constant.
pub const SPRING_RATE: Slip = Slip {
    id: "meyer.spring-rate",
    reason: "The torque of the spring is K itself, Eq. (1-15), whatever the angle. A rate or a constant of a spring would \
             have to be multiplied by an angle. An inch-pound per radian can be read as a torque, the work done per \
             radian; only the word is wrong.",
    witness: "In Eq. (1-17) and in the program K stands alone where a torque must stand.",
    origin: Origin::Concept,
    consequence: Consequence::Wording,
    changes: "",
};

/// A pin is said to have to enter along the slot, so that only three mechanisms are left.
pub const ENTRY_ALONG_THE_SLOT: Slip = Slip {
    id: "meyer.along-the-slot",
    reason: "A pin strikes the slot's wall if the two have different velocities across the slot. So the pin must move \
             along the slot if the follower is at rest; if the follower turns it must not. The velocity ratio is an \
             even function of the driver's angle: the leaving and the entering pin ask the follower for one speed, \
             whatever the numbers of pins and slots, and nothing strikes. Five pins and five slots, with the axes a \
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
    reason: "The follower's angle φ must stand where the copy has the driver's angle θ. Counted as a slip of the copy, \
             because the displays around each place have φ.",
    witness: "Angles, lengths and accelerations measured between axes and pin, at instants of all three escapements.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

/// The greatest printed speed is taken for the greatest.
pub const SAMPLED_PEAKS: Slip = Slip {
    id: "meyer.cyclic-oscillations",
    reason: "The lines of a run are a print interval apart, and the peak falls between them, now nearer to one, now \
             farther. The stronger the spring, the sharper the peak and the more is missed. By the law of similarity the \
             peak itself grows as the root of the torque, and does not swing.",
    witness: "The peak of the motion, not of its print-out, in steps of the angle.",
    origin: Origin::Concept,
    consequence: Consequence::Result,
    changes: "The oscillations of the peak velocity that are recommended for study are those of the print-out.",
};
