//! The problem and its solution line by line.

use crate::Entry::{Again, Claim, Exception, Label, Reading, Rest};
use crate::Line;

/// All lines of the source's text that say something.
pub const INVENTORY: &[Line] = &[
    Line {
        number: 3,
        fingerprint: 0x4a3d_c51c_8147_c1bd,
        entries: &[
            Label("7"),
            Exception { id: "quick-return.link-2", numbers: "2", reason: "the name of a link of the mechanism" },
            Claim("quick-return.driver-sense"),
            Claim("quick-return.driver-speed"),
            Exception {
                id: "quick-return.points",
                numbers: "2 4 2 4",
                reason: "names of points and links; that the points coincide at the instant is \
                        what the vectors are drawn for",
            },
        ],
    },
    Line {
        number: 5,
        fingerprint: 0xe6ea_d93a_9094_c307,
        entries: &[Exception {
            id: "quick-return.velocities-named",
            numbers: "2 4 2 4",
            reason: "names of the two velocities that the equation relates",
        }],
    },
    Line { number: 7, fingerprint: 0xe6ea_d93a_9094_c307, entries: &[Claim("quick-return.velocity-equation")] },
    Line {
        number: 9,
        fingerprint: 0xb276_14ed_8111_77a2,
        entries: &[
            Exception {
                id: "quick-return.relative-velocity-named",
                numbers: "2 4 2 4",
                reason: "says what the third symbol means",
            },
            Label("7"),
            Claim("quick-return.three"),
            Exception {
                id: "quick-return.velocity-questions",
                numbers: "4",
                reason: "asks for what the solution answers; the answers are claims",
            },
        ],
    },
    Line {
        number: 11,
        fingerprint: 0xaf63_a84c_8601_9430,
        entries: &[Exception { id: "quick-return.marks-a", numbers: "5", reason: "marks to be had for the answer" }],
    },
    Line {
        number: 13,
        fingerprint: 0xe6ea_d93a_9094_c307,
        entries: &[Exception {
            id: "quick-return.accelerations-named",
            numbers: "2 4 2 4",
            reason: "names of the two accelerations that the equation relates",
        }],
    },
    Line { number: 15, fingerprint: 0xe6ea_d93a_9094_c307, entries: &[Claim("quick-return.acceleration-equation")] },
    Line {
        number: 17,
        fingerprint: 0xe6ea_d93a_9094_c307,
        entries: &[Exception {
            id: "quick-return.relative-acceleration-named",
            numbers: "2 4 2 4",
            reason: "says what the third symbol means",
        }],
    },
    Line { number: 19, fingerprint: 0x4256_7ada_1584_3d37, entries: &[Claim("quick-return.seven-terms")] },
    Line {
        number: 21,
        fingerprint: 0x3525_e518_0f34_0682,
        entries: &[
            Label("7"),
            Claim("quick-return.seven"),
            Exception {
                id: "quick-return.acceleration-questions",
                numbers: "4",
                reason: "asks for what the solution answers; the answers are claims",
            },
        ],
    },
    Line {
        number: 23,
        fingerprint: 0x07f8_8f07_b4ba_038b,
        entries: &[Exception { id: "quick-return.marks-b", numbers: "15", reason: "marks to be had for the answer" }],
    },
    Line { number: 26, fingerprint: 0xaf63_aa4c_8601_9796, entries: &[Label("7"), Claim("quick-return.figure")] },
    Line {
        number: 30,
        fingerprint: 0xcbf2_9ce4_8422_2325,
        entries: &[Exception {
            id: "quick-return.heading-position",
            numbers: "",
            reason: "a heading; the drawing that stood below it is not in the copy",
        }],
    },
    Line {
        number: 34,
        fingerprint: 0xe3d7_341a_20fd_3373,
        entries: &[
            Claim("quick-return.law-of-sines"),
            Claim("quick-return.ground"),
            Rest("quick-return.law-of-sines", 1),
            Claim("quick-return.lever-angle"),
            Rest("quick-return.law-of-sines", 2),
            Claim("quick-return.crank"),
            Rest("quick-return.law-of-sines", 3),
            Claim("quick-return.angle-at-pin"),
            Reading("quick-return.branch"),
        ],
    },
    Line {
        number: 36,
        fingerprint: 0x2a3a_2d27_f07c_b616,
        entries: &[
            Claim("quick-return.projections"),
            Again("quick-return.ground"),
            Rest("quick-return.projections", 1),
            Again("quick-return.lever-angle"),
            Rest("quick-return.projections", 2),
            Again("quick-return.crank"),
            Rest("quick-return.projections", 3),
            Claim("quick-return.lever-length"),
        ],
    },
    Line {
        number: 38,
        fingerprint: 0xaebd_c017_805d_a846,
        entries: &[
            Again("quick-return.driver-speed"),
            Claim("quick-return.rate-conversion"),
            Claim("quick-return.driver-rate"),
        ],
    },
    Line {
        number: 40,
        fingerprint: 0x6bd7_79be_24fe_a8c1,
        entries: &[
            Claim("quick-return.angle-sum"),
            Again("quick-return.lever-angle"),
            Rest("quick-return.angle-sum", 1),
            Claim("quick-return.angle-at-axis"),
        ],
    },
    Line {
        number: 42,
        fingerprint: 0x9752_a0e7_e9b7_cd77,
        entries: &[Claim("quick-return.supplement"), Claim("quick-return.crank-angle")],
    },
    Line { number: 44, fingerprint: 0xaf63_af4c_8601_a015, entries: &[Claim("quick-return.point-located")] },
    Line { number: 46, fingerprint: 0xaf63_a94c_8601_95e3, entries: &[Claim("quick-return.frame")] },
    Line { number: 48, fingerprint: 0xaf63_ad4c_8601_9caf, entries: &[Claim("quick-return.p-is-zero")] },
    Line { number: 50, fingerprint: 0xcbf2_9ce4_8422_2325, entries: &[Claim("quick-return.sum-of-places")] },
    Line { number: 52, fingerprint: 0xe6ea_d93a_9094_c307, entries: &[Claim("quick-return.sum-of-places-by-points")] },
    Line {
        number: 54,
        fingerprint: 0xcbf2_9ce4_8422_2325,
        entries: &[Exception {
            id: "quick-return.heading-velocity",
            numbers: "",
            reason: "a heading, which claims nothing",
        }],
    },
    Line { number: 56, fingerprint: 0xcbf2_9ce4_8422_2325, entries: &[Claim("quick-return.velocity-in-a-frame")] },
    Line { number: 58, fingerprint: 0xe6ea_d93a_9094_c307, entries: &[Claim("quick-return.velocity-by-points")] },
    Line { number: 60, fingerprint: 0x6075_4418_27bb_f241, entries: &[Claim("quick-return.seen-from-the-lever")] },
    Line {
        number: 62,
        fingerprint: 0x7683_465e_b536_3dbf,
        entries: &[
            Claim("quick-return.pin-speed-equation"),
            Again("quick-return.driver-rate"),
            Again("quick-return.crank"),
            Claim("quick-return.pin-speed"),
        ],
    },
    Line {
        number: 66,
        fingerprint: 0xb35c_3d56_8b03_06cb,
        entries: &[
            Claim("quick-return.lever-point-speed-equation"),
            Again("quick-return.crank-angle"),
            Rest("quick-return.lever-point-speed-equation", 1),
            Claim("quick-return.lever-point-speed"),
        ],
    },
    Line {
        number: 68,
        fingerprint: 0x4076_467b_7354_b2f2,
        entries: &[
            Claim("quick-return.lever-speed-equation"),
            Again("quick-return.lever-point-speed"),
            Again("quick-return.lever-length"),
            Claim("quick-return.lever-speed"),
        ],
    },
    Line {
        number: 70,
        fingerprint: 0x847d_64c5_b9e5_8db4,
        entries: &[
            Claim("quick-return.sliding-speed-equation"),
            Again("quick-return.crank-angle"),
            Rest("quick-return.sliding-speed-equation", 1),
            Claim("quick-return.sliding-speed"),
        ],
    },
    Line {
        number: 72,
        fingerprint: 0xcbf2_9ce4_8422_2325,
        entries: &[Exception {
            id: "quick-return.heading-acceleration",
            numbers: "",
            reason: "a heading, which claims nothing",
        }],
    },
    Line { number: 74, fingerprint: 0xaf63_af4c_8601_a015, entries: &[Claim("quick-return.acceleration-in-a-frame")] },
    Line { number: 76, fingerprint: 0xe6ea_d93a_9094_c307, entries: &[Again("quick-return.acceleration-equation")] },
    Line { number: 78, fingerprint: 0x4256_7ada_1584_3d37, entries: &[Again("quick-return.seven-terms")] },
    Line {
        number: 80,
        fingerprint: 0x6075_4418_27bb_f241,
        entries: &[Claim("quick-return.acceleration-from-the-lever")],
    },
    Line {
        number: 82,
        fingerprint: 0x687d_5c38_5771_325e,
        entries: &[
            Claim("quick-return.pin-normal-equation"),
            Again("quick-return.driver-rate"),
            Exception {
                id: "quick-return.square-of-the-rate",
                numbers: "2",
                reason: "the exponent of the equation before it, with numbers put in",
            },
            Again("quick-return.crank"),
            Claim("quick-return.pin-normal"),
            Exception {
                id: "quick-return.pin-normal-ticked",
                numbers: "",
                reason: "a tick, as behind the other normal acceleration: the term is known",
            },
        ],
    },
    Line { number: 84, fingerprint: 0xd2b5_0291_fd67_7a3f, entries: &[Claim("quick-return.pin-tangential")] },
    Line {
        number: 86,
        fingerprint: 0x0c47_b121_f4f1_56a1,
        entries: &[
            Claim("quick-return.lever-normal-equation"),
            Again("quick-return.lever-speed"),
            Exception {
                id: "quick-return.square-of-the-speed",
                numbers: "2",
                reason: "the exponent of the equation before it, with numbers put in",
            },
            Again("quick-return.lever-length"),
            Claim("quick-return.lever-normal"),
            Exception { id: "quick-return.lever-normal-ticked", numbers: "", reason: "a tick: the term is known" },
        ],
    },
    Line {
        number: 88,
        fingerprint: 0xaf63_a94c_8601_95e3,
        entries: &[Exception {
            id: "quick-return.lever-tangential-asked",
            numbers: "4",
            reason: "marks a term as not yet known",
        }],
    },
    Line {
        number: 90,
        fingerprint: 0x4425_732c_4184_3a9b,
        entries: &[
            Claim("quick-return.sliding-normal"),
            Claim("quick-return.infinite-radius"),
            Exception {
                id: "quick-return.straight-path",
                numbers: "2 4",
                reason: "the same in other words: the path of the pin relative to the lever is straight",
            },
        ],
    },
    Line {
        number: 92,
        fingerprint: 0x6075_4418_27bb_f241,
        entries: &[Exception {
            id: "quick-return.sliding-acceleration-asked",
            numbers: "2 4",
            reason: "marks a term as not yet known",
        }],
    },
    Line {
        number: 94,
        fingerprint: 0xd6db_4ef2_54db_9efb,
        entries: &[
            Claim("quick-return.coriolis-equation"),
            Exception {
                id: "quick-return.factor-two",
                numbers: "2",
                reason: "the factor of the expression before it, with numbers put in",
            },
            Again("quick-return.lever-speed"),
            Again("quick-return.sliding-speed"),
            Claim("quick-return.coriolis"),
        ],
    },
    Line { number: 96, fingerprint: 0x8414_a97c_ecec_acf5, entries: &[Claim("quick-return.coriolis-direction")] },
    Line {
        number: 97,
        fingerprint: 0x8414_a97c_ecec_acf5,
        entries: &[
            Exception { id: "quick-return.factors-named", numbers: "4 2 4", reason: "names of the two factors" },
            Claim("quick-return.lever-sense"),
            Claim("quick-return.sense-of-sliding"),
        ],
    },
    Line {
        number: 99,
        fingerprint: 0x25af_68f2_4578_fcee,
        entries: &[
            Claim("quick-return.sliding-acceleration-equation"),
            Again("quick-return.angle-at-pin"),
            Rest("quick-return.sliding-acceleration-equation", 1),
        ],
    },
    Line {
        number: 101,
        fingerprint: 0xae06_a694_0722_18b1,
        entries: &[
            Exception {
                id: "quick-return.sliding-acceleration-again",
                numbers: "2 4",
                reason: "the name of the term that the equation before it gives",
            },
            Again("quick-return.pin-normal"),
            Again("quick-return.angle-at-pin"),
            Again("quick-return.lever-normal"),
            Claim("quick-return.sliding-acceleration"),
        ],
    },
    Line {
        number: 103,
        fingerprint: 0xdf78_4496_e9a7_3cbf,
        entries: &[
            Claim("quick-return.lever-tangential-equation"),
            Again("quick-return.angle-at-pin"),
            Rest("quick-return.lever-tangential-equation", 1),
            Again("quick-return.pin-normal"),
            Again("quick-return.angle-at-pin"),
            Again("quick-return.coriolis"),
            Claim("quick-return.lever-tangential"),
        ],
    },
    Line {
        number: 105,
        fingerprint: 0x0b5c_4735_7bbf_693e,
        entries: &[
            Claim("quick-return.lever-acceleration-equation"),
            Exception { id: "quick-return.lever-acceleration-named", numbers: "4", reason: "the name of the result" },
            Again("quick-return.lever-tangential"),
            Again("quick-return.lever-length"),
            Claim("quick-return.lever-acceleration"),
            Reading("quick-return.lever-acceleration-sense"),
        ],
    },
];
