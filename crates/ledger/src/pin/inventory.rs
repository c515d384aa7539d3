//! The problem line by line.

use crate::Entry::{Again, Claim, Exception};
use crate::Line;

/// All lines of the source's text that say something.
pub const INVENTORY: &[Line] = &[
    Line {
        number: 1,
        fingerprint: 0x79cb_f997_06ff_0495,
        entries: &[
            Exception {
                id: "pin.use",
                numbers: "",
                reason: "says where such mechanisms are used; nothing in the source or in mechanics can test it",
            },
            Exception {
                id: "pin.driver-sense",
                numbers: "",
                reason: "a datum: reversed, it would reverse every velocity and leave every printed number as it is",
            },
            Claim("pin.letter-v"),
            Claim("pin.driver-speed"),
            Exception {
                id: "pin.layout",
                numbers: "",
                reason: "says which part carries the pin and which the slots: the definition that every computation \
                         uses",
            },
            Claim("pin.standstill"),
            Claim("pin.centre-distance"),
            Exception {
                id: "pin.problem-figure",
                numbers: "",
                reason: "the problem's figure is not in the copy; the crank radius, which it must have shown, stands \
                         in the solution",
            },
        ],
    },
    Line {
        number: 2,
        fingerprint: 0x455e_c518_1814_56c1,
        entries: &[
            Claim("pin.letter-f"),
            Claim("pin.crank-angle"),
            Exception {
                id: "pin.questions",
                numbers: "",
                reason: "asks for what the solution answers; the answers are claims",
            },
        ],
    },
    Line {
        number: 3,
        fingerprint: 0x455e_c518_1814_56c1,
        entries: &[
            Claim("pin.position-figure"),
            Again("pin.letter-f"),
            Again("pin.crank-angle"),
            Exception {
                id: "pin.triangle-drawings",
                numbers: "",
                reason: "the drawings of the two triangles are not in the copy; what the text says of them is claimed",
            },
        ],
    },
    Line {
        number: 4,
        fingerprint: 0xa3c7_cdfa_7fa5_2b6d,
        entries: &[
            Claim("pin.law-of-cosines"),
            Claim("pin.angle-at-driver"),
            Claim("pin.radius-squared"),
            Claim("pin.radius-ratio"),
            Claim("pin.radius"),
        ],
    },
    Line {
        number: 5,
        fingerprint: 0x1068_5e86_e36e_64bc,
        entries: &[
            Claim("pin.letter-b"),
            Claim("pin.law-of-sines"),
            Claim("pin.sine-at-pivot"),
            Claim("pin.angle-at-pivot"),
        ],
    },
    Line {
        number: 6,
        fingerprint: 0x13b5_1647_4789_4e85,
        entries: &[
            Claim("pin.pin-speed-equation"),
            Claim("pin.crank-radius"),
            Again("pin.driver-speed"),
            Claim("pin.pin-speed"),
            Again("pin.pin-speed"),
            Claim("pin.mark-d"),
            Claim("pin.pin-velocity-direction"),
            Exception {
                id: "pin.moving-frame",
                numbers: "",
                reason: "names the wheel's point under the pin and the frame turning with the wheel: definitions",
            },
        ],
    },
    Line {
        number: 7,
        fingerprint: 0xcbf2_9ce4_8422_2325,
        entries: &[
            Claim("pin.velocity-equation"),
            Claim("pin.across-the-slot"),
            Claim("pin.along-the-slot"),
            Claim("pin.velocity-figure"),
        ],
    },
    Line {
        number: 8,
        fingerprint: 0x551c_428f_5e53_8fc1,
        entries: &[
            Claim("pin.letter-g"),
            Claim("pin.velocity-angle-equation"),
            Again("pin.angle-at-pivot"),
            Again("pin.angle-at-driver"),
            Claim("pin.velocity-angle"),
        ],
    },
    Line {
        number: 9,
        fingerprint: 0xfb3c_652e_d628_2992,
        entries: &[
            Claim("pin.slot-point-equation"),
            Again("pin.pin-speed"),
            Again("pin.velocity-angle"),
            Claim("pin.slot-point-speed"),
            Claim("pin.mark-f"),
            Claim("pin.slot-point-velocity-direction"),
            Claim("pin.sliding-equation"),
            Again("pin.pin-speed"),
            Again("pin.velocity-angle"),
            Exception {
                id: "pin.sliding-twice",
                numbers: "",
                reason: "the copy prints the left side of this equation twice; the repetition says nothing new",
            },
            Claim("pin.sliding-speed"),
            Again("pin.mark-d"),
            Claim("pin.sliding-velocity-direction"),
            Again("pin.across-the-slot"),
        ],
    },
    Line {
        number: 10,
        fingerprint: 0x7e82_9186_a5de_4a8d,
        entries: &[
            Claim("pin.follower-speed-equation"),
            Again("pin.slot-point-speed"),
            Again("pin.radius"),
            Exception {
                id: "pin.follower-twice",
                numbers: "",
                reason: "the copy prints the left side of this equation twice; the repetition says nothing new",
            },
            Claim("pin.follower-speed"),
            Claim("pin.follower-sense"),
        ],
    },
];
