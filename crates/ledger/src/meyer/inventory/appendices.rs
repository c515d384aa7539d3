//! Appendix A, appendix C, the references and the author's life.

use super::{NONE, exception, line};
use crate::Entry::{Again, Claim, Label};
use crate::Line;

pub const APPENDIX_A: &[Line] = &[
    line(544, NONE, &[exception("meyer.app-a.purpose", "", "says what the computations below are for")]),
    line(546, 0x58cd_40a8_fcc3_57c2, &[Claim("meyer.app-a.unit")]),
    line(548, 0x2ba2_ca18_0993_0737, &[Again("meyer.table.four-pins"), Again("meyer.table.four-slots")]),
    line(550, 0xb8a4_68d8_44d4_e866, &[Again("meyer.table.four-pins"), Claim("meyer.app-a.four-slots.theta")]),
    line(552, 0xb8a4_68d8_44d4_e866, &[Again("meyer.table.four-slots"), Claim("meyer.app-a.four-slots.phi")]),
    line(
        554,
        0xd40c_c07f_2221_4024,
        &[Claim("meyer.app-a.four-slots.centre-equation"), Claim("meyer.app-a.four-slots.centre")],
    ),
    line(
        556,
        0x3697_5b2b_98dc_83c3,
        &[Claim("meyer.app-a.four-slots.radius-equation"), Claim("meyer.app-a.four-slots.radius")],
    ),
    line(558, 0x3dcf_1918_141b_8c88, &[Again("meyer.table.six-pins"), Again("meyer.table.three-slots")]),
    line(560, 0x2274_5bea_2ad0_1ca8, &[Again("meyer.table.six-pins"), Claim("meyer.app-a.three-slots.theta")]),
    line(562, 0xd7fb_0e01_f368_5b00, &[Again("meyer.table.three-slots"), Claim("meyer.app-a.three-slots.phi")]),
    line(
        564,
        0x1bba_a4c5_3526_6760,
        &[Claim("meyer.app-a.three-slots.centre-equation"), Claim("meyer.app-a.three-slots.centre")],
    ),
    line(
        566,
        0x4881_74d7_0ae8_d522,
        &[Claim("meyer.app-a.three-slots.radius-equation"), Claim("meyer.app-a.three-slots.radius")],
    ),
    line(568, 0x56f2_0718_221a_b930, &[Again("meyer.table.three-pins"), Again("meyer.table.six-slots")]),
    line(570, 0xd7fb_0e01_f368_5b00, &[Again("meyer.table.three-pins"), Claim("meyer.app-a.six-slots.theta")]),
    line(572, 0x2274_5bea_2ad0_1ca8, &[Again("meyer.table.six-slots"), Claim("meyer.app-a.six-slots.phi")]),
    line(
        574,
        0xac45_d18d_d6c5_df9e,
        &[Claim("meyer.app-a.six-slots.centre-equation"), Claim("meyer.app-a.six-slots.centre")],
    ),
    line(
        576,
        0x921b_197e_f4d6_3c24,
        &[Claim("meyer.app-a.six-slots.radius-equation"), Claim("meyer.app-a.six-slots.radius")],
    ),
    line(
        580,
        0x214d_3fba_a4c9_d1d7,
        &[
            Claim("meyer.fig-12"),
            exception(
                "meyer.fig-12-name",
                "",
                "the copy has lost the name that stood above the scale; the list of figures has it",
            ),
        ],
    ),
    line(582, 0x07f8_9407_b4ba_0c0a, &[Label("12")]),
    line(
        584,
        0x214d_3fba_a4c9_d1d7,
        &[
            exception(
                "meyer.fig-13-name",
                "",
                "the name by the pins alone, run together with the scale in the copy; \
                        the list of figures adds the slots",
            ),
            Claim("meyer.fig-13"),
        ],
    ),
    line(586, 0x07f8_9507_b4ba_0dbd, &[Label("13")]),
    line(
        588,
        NONE,
        &[exception("meyer.fig-14-name", "", "the name by the pins alone; the list of figures adds the slots")],
    ),
    line(590, 0x52bd_8b65_97e7_14f2, &[Claim("meyer.fig-14")]),
    line(592, 0x07f8_8e07_b4ba_01d8, &[Label("14")]),
];

pub const APPENDIX_C: &[Line] = &[
    line(
        741,
        NONE,
        &[
            exception(
                "meyer.app-c.spring",
                "",
                "describes how the spring is wound and why its torque hardly changes; no \
                        size is given to test it by",
            ),
            Claim("meyer.app-c.turns"),
        ],
    ),
    line(744, 0x07f8_8f07_b4ba_038b, &[Label("15"), Claim("meyer.fig-15")]),
];

pub const END: &[Line] = &[
    line(847, NONE, &[exception("meyer.chironis", "", "a book; this line has no number of it")]),
    line(
        848,
        0xa164_cfb5_f45b_3df1,
        &[exception("meyer.chironis-pages", "1966 114 116", "year and pages of a book that is not at hand")],
    ),
    line(
        849,
        0xd05b_c2f0_d5c6_24f8,
        &[exception("meyer.mimic-manual", "1970", "the manual of the program that was used, which is not at hand")],
    ),
    line(
        850,
        0x28ce_75ed_085a_25de,
        &[exception("meyer.shigley", "1961 263 267", "year and pages of a book that is not at hand")],
    ),
    line(851, NONE, &[exception("meyer.southworth", "", "a book; this line has no number of it")]),
    line(
        852,
        0x12db_b927_de16_eae8,
        &[exception("meyer.southworth-pages", "1965 455 457", "year and pages of a book that is not at hand")],
    ),
    line(
        853,
        0x3fe0_5547_ff36_2d59,
        &[exception("meyer.timoshenko", "1948 176 181", "year and pages of a book that is not at hand")],
    ),
    line(
        854,
        0x7c2c_5190_3c34_674a,
        &[exception("meyer.wahl", "1963 154", "year and page of a book that is not at hand")],
    ),
    line(858, NONE, &[exception("meyer.born", "", "the author's birth, taken out by the library")]),
    line(
        860,
        0xd05f_40f0_d5c9_30e9,
        &[exception("meyer.studies", "1968", "the author's studies and work: nothing that mechanics can test")],
    ),
    line(
        862,
        0xc6a5_eeea_87b4_47b4,
        &[exception(
            "meyer.computer",
            "6500",
            "the computer, by the name that appendix B gives it too, and the hours \
                    spent, of which nothing is left to count",
        )],
    ),
    line(864, NONE, &[exception("meyer.help", "", "thanks to a person who helped")]),
];
