//! Chapter I from its first paragraph to Eq. (1-8).

use super::{NONE, exception, line};
use crate::Entry::{Claim, Label, Rest};
use crate::Line;

pub const LINES: &[Line] = &[
    line(
        136,
        0xaf63_ac4c_8601_9afc,
        &[
            exception(
                "meyer.usual-slots",
                "",
                "says that followers have three to eighteen slots and what they are mostly used for: a custom; \
                    geometry asks for three or more",
            ),
            Claim("meyer.indexing"),
            exception("meyer.usual-driver", "", "says that analyses take the driver's speed as constant: a custom"),
        ],
    ),
    line(
        138,
        NONE,
        &[
            exception(
                "meyer.simple-to-analyse",
                "",
                "calls the mechanism with one pin simple to analyse, and its motion undesirable for timing: judgements",
            ),
            Claim("meyer.intermittent"),
            Claim("meyer.always-engaged"),
        ],
    ),
    line(
        141,
        0xaf63_ae4c_8601_9e62,
        &[
            Label("3"),
            Claim("meyer.fig-3"),
            exception("meyer.fig-3-drawing", "", "the drawing itself is not in the copy; the book draws its own"),
        ],
    ),
    line(
        143,
        0x56f2_0918_221a_bc96,
        &[Label("3"), Claim("meyer.hand-over"), Claim("meyer.along-the-slot"), Label("4")],
    ),
    line(
        146,
        0xaf63_a94c_8601_95e3,
        &[
            Label("4"),
            exception(
                "meyer.fig-4-drawing",
                "",
                "the drawing itself is not in the copy; what the text reads off it are claims",
            ),
        ],
    ),
    line(150, 0xd44e_d2e6_0dd2_f774, &[Claim("meyer.phi-0")]),
    line(154, 0xd44e_d2e6_0dd2_f774, &[Claim("meyer.theta-0")]),
    line(156, NONE, &[Claim("meyer.right-triangle")]),
    line(158, 0xaf63_ad4c_8601_9caf, &[Claim("meyer.pin-circle")]),
    line(162, 0x459f_3818_184a_fe1f, &[Claim("meyer.eq-1-1"), Label("1-1")]),
    line(166, 0xa177_d5fc_5ff2_ea0d, &[Claim("meyer.eq-1-2"), Label("1-2")]),
    line(168, 0xaf63_a94c_8601_95e3, &[Label("4")]),
    line(
        170,
        0x895c_8e59_2100_13e7,
        &[
            Claim("meyer.half-turn"),
            Claim("meyer.quarter-turn"),
            Claim("meyer.angle-sum"),
            Claim("meyer.eq-1-3"),
            Label("1-3"),
        ],
    ),
    line(172, 0x37e7_9e65_8876_557d, &[Label("1-1"), Label("1-3"), Claim("meyer.continuous")]),
    line(174, 0x459f_3a18_184b_0185, &[Label("1-3"), Claim("meyer.only-three")]),
    line(
        176,
        0x7a56_d550_a509_f01c,
        &[Claim("meyer.table.three-slots"), Claim("meyer.table.four-slots"), Claim("meyer.table.six-slots")],
    ),
    line(
        177,
        0x9767_60e6_e111_c16c,
        &[Claim("meyer.table.six-pins"), Claim("meyer.table.four-pins"), Claim("meyer.table.three-pins")],
    ),
    line(
        179,
        0xb2ca_a7fc_69c2_aa37,
        &[Label("1-3"), Claim("meyer.fewer-pins"), Claim("meyer.two-pins"), Claim("meyer.tangent")],
    ),
    line(
        182,
        0xaf63_a84c_8601_9430,
        &[
            Label("5"),
            exception(
                "meyer.fig-5-drawing",
                "",
                "the drawing itself is not in the copy; what the text reads off it are claims",
            ),
        ],
    ),
    line(184, 0xaf63_a84c_8601_9430, &[Label("5")]),
    line(186, 0xaf63_ac4c_8601_9afc, &[Claim("meyer.projection"), Claim("meyer.cosine")]),
    line(188, 0x459f_3818_184a_fe1f, &[Label("1-1")]),
    line(190, 0xa177_cffc_5ff2_dfdb, &[Claim("meyer.eq-1-4"), Label("1-4")]),
    line(192, 0xaf63_a84c_8601_9430, &[Label("5")]),
    line(194, NONE, &[Claim("meyer.law-of-sines")]),
    line(196, 0x459f_3418_184a_f753, &[Claim("meyer.eq-1-5"), Label("1-5")]),
    line(198, 0x459f_3318_184a_f5a0, &[Label("1-4")]),
    line(200, NONE, &[Claim("meyer.cosine-substituted")]),
    line(202, 0xaf63_ac4c_8601_9afc, &[Claim("meyer.cotangent")]),
    line(204, 0x459f_3518_184a_f906, &[Claim("meyer.eq-1-6"), Label("1-6")]),
    line(
        206,
        0x459f_3518_184a_f906,
        &[
            Label("1-6"),
            exception(
                "meyer.fundamental-relation",
                "",
                "calls the equation fundamental, which adds nothing to be checked",
            ),
        ],
    ),
    line(208, 0x459f_3518_184a_f906, &[Label("1-6")]),
    line(210, 0xaf63_af4c_8601_a015, &[Claim("meyer.quotient-rule")]),
    line(212, 0x6075_4618_27bb_f5a7, &[Claim("meyer.secant-squared")]),
    line(214, 0x165b_528e_3896_3497, &[Claim("meyer.one-and-tangent-squared")]),
    line(216, 0xdd3f_abb8_a573_361d, &[Claim("meyer.tangent-substituted")]),
    line(218, 0x3191_2353_c84c_2dd1, &[Claim("meyer.eq-1-7"), Label("1-7")]),
    line(220, 0x459f_3618_184a_fab9, &[Label("1-7")]),
    line(222, 0x8135_ee1f_0a1c_01e2, &[Claim("meyer.acceleration-by-quotient")]),
    line(224, 0x52bd_8a65_97e7_133f, &[Rest("meyer.acceleration-by-quotient", 1)]),
    line(
        226,
        0x8dc6_2272_0af8_ede5,
        &[Claim("meyer.acceleration-differentiated"), Claim("meyer.eq-1-8"), Label("1-8")],
    ),
];
