//! The abstract's findings, chapter II, conclusions and recommendations, and the headings of Appendix E.

use super::{NONE, exception, line};
use crate::Entry::{Again, Claim, Label};
use crate::Line;

pub const ABSTRACT: &[Line] = &[line(
    68,
    NONE,
    &[Claim("meyer.abstract.terminal"), Claim("meyer.abstract.consequently"), Claim("meyer.abstract.fifty")],
)];

pub const PARAMETERS: &[Line] = &[
    line(
        430,
        NONE,
        &[exception(
            "meyer.to-be-shown",
            "",
            "says what the chapter is to show: a terminal velocity, which is a claim of the abstract, and small \
             effects of the parameters, which are the second conclusion",
        )],
    ),
    line(432, NONE, &[Claim("meyer.six-parameters")]),
    line(434, NONE, &[exception("meyer.parameter.slots", "", "says what the letter n stands for")]),
    line(435, 0xaf63_ad4c_8601_9caf, &[Claim("meyer.parameter.entry-angle")]),
    line(436, NONE, &[exception("meyer.parameter.friction", "", "says what the letter μ stands for")]),
    line(437, NONE, &[Claim("meyer.parameter.spring")]),
    line(438, NONE, &[exception("meyer.parameter.follower", "", "says what the letter I_f stands for")]),
    line(
        439,
        NONE,
        &[exception(
            "meyer.parameter.driver",
            "",
            "says what the letter I_d stands for, which is written I_D in chapter I",
        )],
    ),
    line(449, NONE, &[Claim("meyer.inertias-vary")]),
];

pub const FIGURES: &[Line] = &[
    line(
        451,
        0x7ae8_593a_8ae5_d777,
        &[
            Label("8"),
            Label("11"),
            exception("meyer.figures-summarized", "", "says what the figures show; their curves are not in the copy"),
            Label("8"),
        ],
    ),
    line(
        453,
        NONE,
        &[exception(
            "meyer.name-of-fig-8",
            "",
            "name of figure 8 on its page and the next line, with which the list of figures is compared",
        )],
    ),
    line(457, 0xaf63_b54c_8601_aa47, &[Claim("meyer.fig-8")]),
    line(459, 0xaf63_b54c_8601_aa47, &[Claim("meyer.shape"), Claim("meyer.scales"), Label("8")]),
    line(
        461,
        0xbb39_62b0_e741_ba2c,
        &[
            Claim("meyer.fig-8.rise"),
            Claim("meyer.first-minimum"),
            exception(
                "meyer.averages-defined",
                "",
                "defines average terminal velocity, period and resolution; Recommendation 7 comes back to the first",
            ),
        ],
    ),
    line(
        463,
        0x0814_0207_b4d1_8eac,
        &[
            Claim("meyer.fig-8.quarter"),
            Claim("meyer.peaks-at-entry"),
            Claim("meyer.still-at-entry"),
            Claim("meyer.peaks-at-rest"),
            Claim("meyer.driver-slows"),
            Claim("meyer.extremes-on-centres"),
            Claim("meyer.follower-decreases"),
            Claim("meyer.peaks-at-exit"),
            Claim("meyer.leaves-as-entered"),
        ],
    ),
    line(
        465,
        0xdd38_67d7_1ef3_8081,
        &[
            exception("meyer.three-statements", "", "announces three statements, which are claims of their own"),
            Label("9"),
            Label("10"),
            Label("11"),
        ],
    ),
    line(
        467,
        0xaf63_ac4c_8601_9afc,
        &[
            exception("meyer.first-statement", "1", "number of the first of the three statements"),
            Claim("meyer.more-torque"),
            Claim("meyer.least-rise-time"),
        ],
    ),
    line(470, 0xaf63_b44c_8601_a894, &[Claim("meyer.fig-9")]),
    line(472, 0x0814_0b07_b4d1_9df7, &[Claim("meyer.fig-10.rise-axis")]),
    line(474, NONE, &[exception("meyer.fig-10.upper", "", "name of the upper plot, whose curves are not in the copy")]),
    line(481, NONE, &[exception("meyer.fig-10.ordinate", "", "quantity on the ordinate of the lower plot")]),
    line(483, NONE, &[exception("meyer.fig-10.lower", "", "name of the lower plot, whose curves are not in the copy")]),
    line(489, 0x07f8_9207_b4ba_08a4, &[Claim("meyer.fig-10")]),
    line(491, 0x0814_0b07_b4d1_9df7, &[Again("meyer.fig-10.rise-axis")]),
    line(493, NONE, &[exception("meyer.fig-11.upper", "", "name of the upper plot, whose curves are not in the copy")]),
    line(499, NONE, &[Claim("meyer.fig-11.abscissa")]),
    line(501, NONE, &[exception("meyer.fig-11.ordinate", "", "quantity on the ordinate of the lower plot")]),
    line(503, NONE, &[exception("meyer.fig-11.lower", "", "name of the lower plot, whose curves are not in the copy")]),
    line(510, NONE, &[Again("meyer.fig-11.abscissa")]),
    line(512, 0x07f8_9307_b4ba_0a57, &[Claim("meyer.fig-11")]),
    line(
        514,
        NONE,
        &[exception(
            "meyer.least-rise-time.reason",
            "",
            "ends the first statement: a reason for the least rise time, which does not exist",
        )],
    ),
    line(
        516,
        0xaf63_af4c_8601_a015,
        &[
            exception("meyer.second-statement", "2", "number of the second of the three statements"),
            Claim("meyer.less-friction"),
            Claim("meyer.no-friction"),
        ],
    ),
    line(
        518,
        0xaf63_ae4c_8601_9e62,
        &[
            exception("meyer.third-statement", "3", "number of the third of the three statements"),
            Claim("meyer.almost-linear"),
        ],
    ),
];

pub const CONCLUSIONS: &[Line] = &[
    line(
        522,
        NONE,
        &[exception("meyer.conclusions", "", "announces three conclusions, which are claims of their own")],
    ),
    line(
        524,
        0xaf63_ac4c_8601_9afc,
        &[exception("meyer.conclusion.first", "1", "number of the first conclusion"), Claim("meyer.conclusion.timing")],
    ),
    line(
        525,
        0xaf63_af4c_8601_a015,
        &[
            exception("meyer.conclusion.second", "2", "number of the second conclusion"),
            Claim("meyer.small-variations"),
        ],
    ),
    line(
        526,
        0xaf63_ae4c_8601_9e62,
        &[
            exception("meyer.conclusion.third", "3", "number of the third conclusion"),
            Claim("meyer.conclusion.three"),
            Claim("meyer.conclusion.the-three"),
        ],
    ),
    line(
        530,
        NONE,
        &[exception(
            "meyer.recommendations",
            "",
            "repeats the first conclusion and announces what further work should look at",
        )],
    ),
    line(
        532,
        0xaf63_ac4c_8601_9afc,
        &[
            exception("meyer.recommendation.first", "1", "number of the first recommendation"),
            Claim("meyer.not-fast-enough"),
            exception("meyer.recommendation.masses", "", "asks for work on the masses, to make the rise times smaller"),
        ],
    ),
    line(
        533,
        0xaf63_af4c_8601_a015,
        &[
            exception("meyer.recommendation.second", "2", "number of the second recommendation"),
            Claim("meyer.recommendation.spring-rates"),
            Claim("meyer.cyclic-oscillations"),
        ],
    ),
    line(
        534,
        0x0b57_d232_1ee7_26ea,
        &[
            exception(
                "meyer.recommendation.third",
                "3",
                "asks for finite pins and slots and for friction in the bearings, of which it says what may be, not \
                 what is",
            ),
            Label("1-14"),
        ],
    ),
    line(
        535,
        0xaf63_a94c_8601_95e3,
        &[exception("meyer.recommendation.fourth", "4", "asks how exact the mechanism is, without a number")],
    ),
    line(
        536,
        0xaf63_a84c_8601_9430,
        &[exception(
            "meyer.recommendation.fifth",
            "5",
            "has the impression that accelerations are high, without a number, and asks for work on them",
        )],
    ),
    line(
        537,
        0xaf63_ab4c_8601_9949,
        &[exception("meyer.recommendation.sixth", "6", "asks for a prototype, of which nothing is known")],
    ),
    line(
        538,
        0x8360_8ce1_d55e_52ba,
        &[
            exception("meyer.recommendation.seventh", "7", "number of the seventh recommendation"),
            Claim("meyer.page-of-definition"),
            Claim("meyer.better-average"),
        ],
    ),
];

pub const HEADINGS: &[Line] = &[
    line(783, NONE, &[Claim("meyer.app-e.torque-unit")]),
    line(
        804,
        NONE,
        &[exception(
            "meyer.app-e.columns",
            "",
            "letters above the columns of four pins; the units are in the next line",
        )],
    ),
    line(805, NONE, &[Again("meyer.app-e.torque-unit")]),
    line(827, NONE, &[Again("meyer.app-e.torque-unit")]),
];
