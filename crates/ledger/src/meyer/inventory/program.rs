//! Appendix B: the program, line by line.

use super::{NONE, exception, line};
use crate::Entry::{Again, Claim};
use crate::Line;

pub const LINES: &[Line] = &[
    line(
        682,
        NONE,
        &[exception("meyer.listing.comment-n", "", "a comment: says what a letter of the program stands for")],
    ),
    line(
        683,
        NONE,
        &[exception("meyer.listing.comment-u", "", "a comment: says what a letter of the program stands for")],
    ),
    line(684, NONE, &[Claim("meyer.listing.comment-k")]),
    line(
        685,
        NONE,
        &[exception("meyer.listing.comment-iw", "", "a comment: says what a letter of the program stands for")],
    ),
    line(
        686,
        NONE,
        &[exception("meyer.listing.comment-ic", "", "a comment: says what a letter of the program stands for")],
    ),
    line(687, 0xaf63_ad4c_8601_9caf, &[Claim("meyer.listing.parameters")]),
    line(688, 0xc2ac_d0f9_ebc4_76b6, &[Claim("meyer.listing.print-interval")]),
    line(
        689,
        0x280f_17e1_4835_ec13,
        &[
            Claim("meyer.listing.g"),
            exception(
                "meyer.listing.digits-g",
                "1",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
            Claim("meyer.listing.pi"),
        ],
    ),
    line(
        690,
        0xaf63_ac4c_8601_9afc,
        &[
            Claim("meyer.listing.h"),
            exception(
                "meyer.listing.digits-h",
                "1",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(691, NONE, &[Claim("meyer.listing.i")]),
    line(
        692,
        0xaf63_ac4c_8601_9afc,
        &[
            Claim("meyer.listing.j"),
            exception(
                "meyer.listing.digits-j",
                "1",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(
        693,
        0x459f_3918_184a_ffd2,
        &[
            Claim("meyer.listing.l"),
            exception(
                "meyer.listing.digits-l",
                "1 2",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(694, NONE, &[Claim("meyer.listing.a")]),
    line(695, NONE, &[Claim("meyer.listing.b")]),
    line(696, NONE, &[Claim("meyer.listing.c")]),
    line(697, NONE, &[Claim("meyer.listing.d")]),
    line(698, NONE, &[Claim("meyer.listing.e")]),
    line(
        699,
        0xa177_d5fc_5ff2_ea0d,
        &[
            Claim("meyer.listing.f"),
            exception(
                "meyer.listing.digits-f",
                "1 1 2",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(
        700,
        0x520d_7e1c_c8c7_c67a,
        &[
            Claim("meyer.listing.s"),
            exception(
                "meyer.listing.digits-s",
                "1.,1.,1",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(
        701,
        0x2527_e0ee_af7c_1ccd,
        &[
            exception("meyer.listing.old", "2 2", "names of the old acceleration and of the acceleration"),
            Claim("meyer.listing.delay"),
        ],
    ),
    line(702, NONE, &[exception("meyer.listing.smt", "", "the control variable, which the text describes")]),
    line(
        703,
        0xaa20_eefc_64da_4232,
        &[
            Claim("meyer.listing.p"),
            exception(
                "meyer.listing.digits-p",
                "1 2 0",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(
        704,
        0x4e48_7118_1d32_8ca4,
        &[
            Claim("meyer.listing.q"),
            exception(
                "meyer.listing.digits-q",
                "0 1",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(705, NONE, &[Claim("meyer.listing.r")]),
    line(
        706,
        0xaf63_ad4c_8601_9caf,
        &[
            Claim("meyer.listing.v"),
            exception(
                "meyer.listing.digits-v",
                "0",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(707, 0xaf63_af4c_8601_a015, &[Claim("meyer.listing.start")]),
    line(708, NONE, &[exception("meyer.listing.lgt", "", "the opposite control variable, which the text describes")]),
    line(
        709,
        0xca0b_ea91_f880_23cd,
        &[
            Claim("meyer.listing.acceleration"),
            exception(
                "meyer.listing.digits-acceleration",
                "1 1",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(
        710,
        0xaa20_eefc_64da_4232,
        &[
            Claim("meyer.listing.speed"),
            exception(
                "meyer.listing.digits-speed",
                "2 0",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(
        711,
        0x459f_3718_184a_fc6c,
        &[exception(
            "meyer.listing.angle",
            "1 0",
            "the driver turns from its own zero, which the start of the engaged \
            angle makes good",
        )],
    ),
    line(712, 0xe9ba_9024_efff_6062, &[Claim("meyer.listing.degrees")]),
    line(
        713,
        0xa6c3_d3ea_f915_c482,
        &[
            Claim("meyer.listing.fold"),
            Claim("meyer.listing.quarter-turn"),
            exception(
                "meyer.listing.digits-fold",
                "0",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(714, 0xe9ba_9024_efff_6062, &[Again("meyer.listing.degrees")]),
    line(
        715,
        0xaf63_ac4c_8601_9afc,
        &[
            Claim("meyer.listing.phidot"),
            exception(
                "meyer.listing.digits-phidot",
                "1",
                "names and coefficients in a line of the program, which the claim about \
            the line evaluates",
            ),
        ],
    ),
    line(716, 0xaf63_af4c_8601_a015, &[Claim("meyer.listing.run-length")]),
    line(717, NONE, &[exception("meyer.listing.heading", "", "headings of the five columns that are printed")]),
    line(718, 0x459f_3918_184a_ffd2, &[exception("meyer.listing.printed", "1 2", "names of two of the five columns")]),
    line(
        719,
        0xaf63_ac4c_8601_9afc,
        &[exception("meyer.listing.plotted-speed", "1", "name of the quantity that is plotted")],
    ),
    line(720, 0x76f2_817e_190a_a536, &[exception("meyer.listing.scale-speed", "002,2.5", "scales of a plot: chosen")]),
    line(
        721,
        0xbec2_93f9_5888_adc7,
        &[exception("meyer.listing.zero-speed", "0.,0", "where the axes of a plot cross: chosen")],
    ),
    line(722, NONE, &[exception("meyer.listing.plotted-follower", "", "name of the quantity that is plotted")]),
    line(
        723,
        0x76f2_817e_190a_a536,
        &[exception("meyer.listing.scale-follower", "002,2.5", "scales of a plot: chosen")],
    ),
    line(
        724,
        0xbec2_93f9_5888_adc7,
        &[exception("meyer.listing.zero-follower", "0.,0", "where the axes of a plot cross: chosen")],
    ),
    line(725, NONE, &[exception("meyer.listing.end", "", "the last card, which ends the program")]),
];
