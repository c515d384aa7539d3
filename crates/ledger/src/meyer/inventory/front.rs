//! From the title to the figures of the introduction.

use super::{NONE, exception, line};
use crate::Entry::{Claim, Label, Rest};
use crate::Line;

pub const LINES: &[Line] = &[
    line(
        5,
        0x07f8_9107_b4ba_06f1,
        &[exception("meyer.copyright", "17", "the law on copies, printed by the library: nothing of the project")],
    ),
    line(7, NONE, &[exception("meyer.fair-use", "", "terms of use, printed by the library: nothing of the project")]),
    line(9, NONE, &[exception("meyer.refusal", "", "terms of use, printed by the library: nothing of the project")]),
    line(11, NONE, &[exception("meyer.rights", "", "who holds the rights: nothing that mechanics can test")]),
    line(13, NONE, &[exception("meyer.printing", "", "how to print the file: nothing of the project")]),
    line(
        15,
        NONE,
        &[exception(
            "meyer.removed",
            "",
            "says that the library took out names and dates of persons; the author's \
                    birth is among what is gone",
        )],
    ),
    line(
        17,
        NONE,
        &[exception("meyer.title", "", "title, author, college and degree, on this line and those that follow")],
    ),
    line(
        33,
        NONE,
        &[exception(
            "meyer.passages",
            "",
            "asks that passages be quoted with leave only; the ledger quotes formulas and numbers",
        )],
    ),
    line(
        36,
        0xd05b_c5f0_d5c6_2a11,
        &[exception("meyer.year", "1973", "the year on the title page; the approval has it too")],
    ),
    line(
        58,
        0xd05b_c5f0_d5c6_2a11,
        &[exception("meyer.approval", "1973", "month and year of the approval, which agree with the title page")],
    ),
    line(
        62,
        NONE,
        &[exception(
            "meyer.purpose",
            "",
            "says what the study is for, and that pallet escapements are widely used: purpose and custom",
        )],
    ),
    line(
        64,
        NONE,
        &[exception(
            "meyer.objective",
            "",
            "asks whether a terminal velocity is reached and how soon; the answers are claims elsewhere",
        )],
    ),
    line(
        66,
        NONE,
        &[exception(
            "meyer.method",
            "",
            "says by which means the study was made; derivation and program are claims elsewhere",
        )],
    ),
    line(72, NONE, &[exception("meyer.thanks", "", "thanks to persons who helped")]),
    line(77, 0xaf63_ac4c_8601_9afc, &[Claim("meyer.contents")]),
    line(79, 0xaf63_a94c_8601_95e3, &[Rest("meyer.contents", 1)]),
    line(80, 0x07f8_8f07_b4ba_038b, &[Rest("meyer.contents", 2)]),
    line(81, 0x0803_0607_b4c3_2245, &[Rest("meyer.contents", 3)]),
    line(82, 0x0803_0507_b4c3_2092, &[Rest("meyer.contents", 4)]),
    line(84, 0x0803_0007_b4c3_1813, &[Rest("meyer.contents", 5)]),
    line(85, 0x0803_0c07_b4c3_2c77, &[Rest("meyer.contents", 6)]),
    line(86, 0x07ff_7d07_b4c0_03a3, &[Rest("meyer.contents", 7)]),
    line(
        87,
        0x37ab_cff9_9ceb_195a,
        &[
            exception("meyer.contents-zero", "0", "the instant in the name of appendix D, where it is a datum"),
            Rest("meyer.contents", 8),
        ],
    ),
    line(88, 0x07ff_8307_b4c0_0dd5, &[Rest("meyer.contents", 9)]),
    line(89, 0x07ff_8607_b4c0_12ee, &[Rest("meyer.contents", 10)]),
    line(90, 0x07ff_8707_b4c0_14a1, &[Rest("meyer.contents", 11)]),
    line(95, 0x459f_3918_184a_ffd2, &[Claim("meyer.list-of-figures")]),
    line(
        96,
        0x6075_4518_27bb_f3f4,
        &[
            Rest("meyer.list-of-figures", 1),
            exception(
                "meyer.list.fig-2",
                "",
                "name of figure 2, the Geneva mechanism of the introduction; its page names it by the pins",
            ),
        ],
    ),
    line(97, 0x56f2_0918_221a_bc96, &[Rest("meyer.list-of-figures", 2)]),
    line(98, 0x2ba2_c918_0993_0584, &[Rest("meyer.list-of-figures", 3)]),
    line(99, 0x22f9_1118_04aa_9f32, &[Rest("meyer.list-of-figures", 4)]),
    line(100, 0x3dcf_1318_141b_8256, &[Rest("meyer.list-of-figures", 5)]),
    line(101, 0x8360_87e1_d55e_4a3b, &[Rest("meyer.list-of-figures", 6)]),
    line(
        102,
        0x631f_3e3d_89a7_d11e,
        &[
            Rest("meyer.list-of-figures", 7),
            exception(
                "meyer.list.fig-8",
                "",
                "name of figure 8; its page adds that the velocities are angular, as are all of the project",
            ),
        ],
    ),
    line(103, 0xc2be_6835_331b_19fd, &[Rest("meyer.list-of-figures", 8)]),
    line(104, 0xf996_1576_0c60_13ba, &[Rest("meyer.list-of-figures", 9)]),
    line(105, 0xc2ac_a07f_9b83_22ef, &[Rest("meyer.list-of-figures", 10)]),
    line(106, 0x6373_7187_f266_84c3, &[Rest("meyer.list-of-figures", 11), Claim("meyer.list.fig-12")]),
    line(107, 0xd97c_1a8f_0ef8_f69b, &[Rest("meyer.list-of-figures", 12), Claim("meyer.list.fig-13")]),
    line(108, 0xa333_ff55_ecd2_d0bb, &[Rest("meyer.list-of-figures", 13), Claim("meyer.list.fig-14")]),
    line(109, 0x4398_495e_4362_82cf, &[Rest("meyer.list-of-figures", 14)]),
    line(
        113,
        0xaf63_ac4c_8601_9afc,
        &[
            Label("1"),
            exception(
                "meyer.classic",
                "",
                "says where runaway escapements are used, that they are not accurate and what they cost: custom, \
                    without a number. Kindly read: among watches and clocks those with an alarm or a timer",
            ),
        ],
    ),
    line(
        115,
        0xaf63_af4c_8601_a015,
        &[
            exception(
                "meyer.impacts",
                "",
                "says why the pallet escapement is inaccurate: its impacts and high accelerations, of which no size is \
                given, nor to what accuracy they lead",
            ),
            Label("2"),
        ],
    ),
    line(
        117,
        NONE,
        &[exception(
            "meyer.rise-time-defined",
            "",
            "sets the test that the study applies, a terminal velocity that is reached soon enough, and says what \
                rise time is to mean: a definition; what the study finds by it are claims",
        )],
    ),
    line(119, NONE, &[Claim("meyer.fig-1")]),
    line(122, 0xaf63_ac4c_8601_9afc, &[Label("1")]),
    line(
        124,
        NONE,
        &[exception(
            "meyer.name-of-fig-2",
            "",
            "name of figure 2 on its page, with which the list of figures is compared",
        )],
    ),
    line(128, 0x214d_3fba_a4c9_d1d7, &[Claim("meyer.fig-2")]),
    line(130, 0xaf63_af4c_8601_a015, &[Label("2")]),
];
