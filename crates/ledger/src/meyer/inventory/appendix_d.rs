//! Appendix D: the acceleration at the start.

use super::{NONE, exception, line};
use crate::Entry::{Claim, Label};
use crate::Line;

pub const LINES: &[Line] = &[
    line(748, 0xaf63_ad4c_8601_9caf, &[exception("meyer.app-d.heading", "0", "a heading, with the time at the start")]),
    line(
        750,
        0x4e48_7418_1d32_91bd,
        &[exception(
            "meyer.app-d.needed",
            "0 2",
            "says that the program needs a first acceleration for its loop, of which \
            Appendix B tells",
        )],
    ),
    line(752, 0xaf63_ad4c_8601_9caf, &[exception("meyer.app-d.known", "0", "the time at the start")]),
    line(
        754,
        0x7b1e_1c25_9e5a_047f,
        &[Claim("meyer.app-d.from-rest"), exception("meyer.app-d.from-rest-when", "0", "the time at the start")],
    ),
    line(
        756,
        0xe178_bfde_02a2_d681,
        &[Claim("meyer.app-d.angles"), exception("meyer.app-d.angles-when", "0", "the time at the start")],
    ),
    line(
        758,
        0xaf63_ad4c_8601_9caf,
        &[exception("meyer.app-d.angle-named", "0", "name of the angle at the start"), Claim("meyer.app-d.order")],
    ),
    line(
        760,
        0x78c0_49d6_8ee7_8af2,
        &[
            Label("1-19"),
            exception("meyer.app-d.at-rest-said", "0", "the speed at the start, which is a claim in this appendix"),
        ],
    ),
    line(762, NONE, &[Claim("meyer.app-d.at-rest")]),
    line(
        764,
        0x7b1e_1c25_9e5a_047f,
        &[
            exception("meyer.app-d.start-named", "0 0", "the time at the start, twice"),
            Claim("meyer.app-d.letters"),
            Claim("meyer.app-d.constant"),
            exception("meyer.app-d.start-named-again", "0", "the time at the start"),
        ],
    ),
    line(766, NONE, &[Claim("meyer.app-d.with-letters")]),
    line(
        768,
        0x7b1e_1c25_9e5a_047f,
        &[
            exception(
                "meyer.app-d.acceleration-named",
                "0 0 0",
                "name of the first acceleration, and the time at the start twice",
            ),
            Claim("meyer.app-d.forwards"),
        ],
    ),
    line(770, NONE, &[Claim("meyer.app-d.outside")]),
    line(772, 0xaf63_ad4c_8601_9caf, &[Claim("meyer.app-d.acceleration")]),
    line(
        774,
        0xaf63_ad4c_8601_9caf,
        &[
            exception("meyer.app-d.acceleration-named-again", "0", "name of the first acceleration"),
            Claim("meyer.app-d.always-positive"),
        ],
    ),
];
