//! The handout line by line.

use crate::Entry::{self, Again, Claim, Label, Reading};
use crate::Line;

/// An exception with its id, numbers and reason.
const fn exception(id: &'static str, numbers: &'static str, reason: &'static str) -> Entry {
    Entry::Exception { id, numbers, reason }
}

const fn line(number: u32, fingerprint: u64, entries: &'static [Entry]) -> Line {
    Line { number, fingerprint, entries }
}

/// The fingerprint of a line without numbers.
const NONE: u64 = 0xcbf2_9ce4_8422_2325;

/// All lines of the source's text that say something; connecting words alone are left out.
pub const INVENTORY: &[Line] = &[
    line(
        3,
        0xc3eb_efd4_e498_10f9,
        &[exception("jazar.heading", "58105 341 2003", "the address, course and year of the lecture")],
    ),
    line(7, 0x3e16_69bf_bab7_100d, &[exception("jazar.hours", "27 8 00 9 15", "the room and hours of the lecture")]),
    line(
        11,
        NONE,
        &[
            Claim("jazar.one-direction"),
            exception(
                "jazar.uses",
                "",
                "says what indexing mechanisms and dwell cams are and where they are used: definitions and experience",
            ),
        ],
    ),
    line(
        13,
        NONE,
        &[
            Claim("jazar.slider-crank"),
            Claim("jazar.journal-bearing"),
            exception(
                "jazar.varieties",
                "",
                "says that the Geneva mechanism is the most common and comes in many varieties: experience",
            ),
        ],
    ),
    line(
        15,
        NONE,
        &[exception("jazar.name", "", "says where the name comes from: history, which mechanics cannot test")],
    ),
    line(
        17,
        0x3fd8_2f12_2112_9530,
        &[
            Label("5.28"),
            Claim("jazar.quarter-turn"),
            Claim("jazar.locking"),
            Claim("jazar.tangent-entry"),
            Claim("jazar.centre-distance"),
            Claim("jazar.wheel-radius"),
            Claim("jazar.journal-radius"),
            Claim("jazar.cutout-centres"),
        ],
    ),
    line(
        20,
        0x9100_cfd0_3285_63a0,
        &[
            Label("5.28"),
            Claim("jazar.fig-5.28"),
            exception(
                "jazar.fig-5.28-drawing",
                "",
                "the drawing itself is not in the copy, nor the sense in which it turns; the book draws its own",
            ),
        ],
    ),
    line(
        22,
        NONE,
        &[
            exception(
                "jazar.slider-crank-again",
                "",
                "says once more that the advancing wheel is an inverted slider crank, as line 13 does",
            ),
            Claim("jazar.speeds-up-then-slows-down"),
        ],
    ),
    line(24, 0x9100_d0d0_3285_6553, &[Label("5.29")]),
    line(
        26,
        NONE,
        &[
            Claim("jazar.eq-5.25-across"),
            exception(
                "jazar.letter-x",
                "",
                "the letter x is not explained; from the equations it is the pin's distance from the wheel's axis",
            ),
        ],
    ),
    line(28, 0xaf63_af4c_8601_a015, &[Claim("jazar.eq-5.25-along")]),
    line(29, 0x9100_dcd0_3285_79b7, &[Label("5.25")]),
    line(33, 0xaf63_af4c_8601_a015, &[Claim("jazar.slot-eliminated")]),
    line(37, 0xd85d_e8e7_a380_1fa0, &[Claim("jazar.eq-5.26"), Label("5.26")]),
    line(39, 0x2c90_7d89_fe9f_8416, &[Claim("jazar.eq-5.27"), Label("5.27")]),
    line(42, 0x97bc_fe94_954e_a0e4, &[Label("5.29"), Claim("jazar.fig-5.29"), Label("5.28")]),
    line(44, 0x9100_ddd0_3285_7b6a, &[Label("5.26")]),
    line(46, 0xc63b_c22e_1505_a82f, &[Claim("jazar.tangent-differentiated")]),
    line(48, 0x9100_ddd0_3285_7b6a, &[Label("5.26")]),
    line(50, 0xf91e_e81b_54dc_8e60, &[Claim("jazar.eq-5.28"), Label("5.28")]),
    line(54, 0xca5b_963b_09dc_87cc, &[Claim("jazar.unsteady-acceleration")]),
    line(56, NONE, &[Claim("jazar.steady-driver")]),
    line(58, 0xfab6_a0e4_8d36_e832, &[Claim("jazar.eq-5.29"), Label("5.29")]),
    line(
        60,
        0xaa51_b3bc_096b_1f6a,
        &[
            Label("5.27"),
            Label("5.28"),
            Label("5.29"),
            Claim("jazar.fig-5.30"),
            Label("5.30"),
            exception("jazar.axes", "", "says in which units angles are drawn in Fig. 5.30, which is not in the copy"),
            Claim("jazar.phi-range"),
            Again("jazar.phi-range"),
            Claim("jazar.velocity-normalisation"),
            Claim("jazar.acceleration-normalisation"),
        ],
    ),
    line(
        62,
        0x9104_5dd0_3288_8ac1,
        &[
            Label("5.30"),
            Claim("jazar.smooth-inside"),
            Claim("jazar.infinite-jerk"),
            Claim("jazar.least-stations"),
            exception(
                "jazar.most-stations",
                "",
                "says that locking arcs become too short in practice above some number of stations, and names none: \
                 what is too short depends on clearances and wear",
            ),
            exception(
                "jazar.usual",
                "",
                "calls four stations in a plane the simplest wheel and one pin the usual number: judgement and \
                 experience",
            ),
            Claim("jazar.more-pins"),
        ],
    ),
    line(64, 0x9104_5cd0_3288_890e, &[Label("5.31"), Claim("jazar.alpha")]),
    line(
        67,
        0xcfc1_7f5b_132a_0768,
        &[
            Claim("jazar.fig-5.30-caption"),
            exception(
                "jazar.drawings",
                "",
                "the drawings of Figs. 5.29, 5.30 and 5.31 are not in the copy; the captions and what the text says of \
                 them are claimed",
            ),
            Label("5.30"),
            Label("5.28"),
            Label("5.29"),
        ],
    ),
    line(70, 0x9104_5cd0_3288_890e, &[Claim("jazar.fig-5.31"), Label("5.31")]),
    line(
        72,
        0xdf8c_616c_3999_0d77,
        &[
            Claim("jazar.alpha-degrees"),
            Claim("jazar.duration"),
            Claim("jazar.duration-grows"),
            Claim("jazar.duration-limit"),
            Claim("jazar.gentler"),
            Claim("jazar.dwell-shrinks"),
            exception(
                "jazar.gearing",
                "",
                "advises against gears behind the mechanism, because of backlash, and names what to weigh: engineering \
                 judgement without a number; that the acceleration reverses is claimed in line 22",
            ),
        ],
    ),
    line(
        74,
        0xd6b5_d6d2_74a4_d6a6,
        &[Label("5.31"), Claim("jazar.centre-distance-ratio"), Claim("jazar.wheel-radius-ratio")],
    ),
    line(
        76,
        0x84af_561a_d28c_7815,
        &[Claim("jazar.alpha-radians"), Label("5.27"), Label("5.29"), Claim("jazar.generalises")],
    ),
    line(78, 0x459f_3818_184a_fe1f, &[Claim("jazar.eq-5.30")]),
    line(79, 0x9104_5dd0_3288_8ac1, &[Label("5.30")]),
    line(81, 0xaa20_ecfc_64da_3ecc, &[Claim("jazar.eq-5.31")]),
    line(82, 0x9104_5cd0_3288_890e, &[Label("5.31")]),
    line(84, 0x5676_b2e3_674c_ee82, &[Claim("jazar.eq-5.32")]),
    line(85, 0x9104_5bd0_3288_875b, &[Label("5.32")]),
    line(
        87,
        NONE,
        &[exception("jazar.spherical", "", "says what spherical Geneva mechanisms allow, without their geometry")],
    ),
    line(
        91,
        0x572f_1918_224e_85e4,
        &[
            Claim("jazar.ex.rpm"),
            exception(
                "jazar.single-pin",
                "",
                "that the driver has one pin is a datum, which the number of advances uses",
            ),
            exception(
                "jazar.synchronous",
                "",
                "says that a synchronous motor keeps to the mains, whose frequency is not given; the driver is taken \
                 to turn with it",
            ),
        ],
    ),
    line(95, NONE, &[exception("jazar.questions", "", "parts (a) to (e) ask; the answers are claims")]),
    line(101, 0x7ac3_41be_2cc1_3168, &[Claim("jazar.ex-a.formula"), Claim("jazar.ex-a.advances")]),
    line(
        102,
        0xdf8a_377a_1f19_3fed,
        &[
            Claim("jazar.ex-b.formula"),
            Claim("jazar.ex-b.advance"),
            Claim("jazar.ex.stations"),
            Claim("jazar.ex-b.alpha"),
        ],
    ),
    line(105, 0xfae3_2103_06da_8159, &[Claim("jazar.ex-c.formula")]),
    line(107, 0x3c15_fbb9_e615_4598, &[Claim("jazar.ex-c.fraction"), Claim("jazar.ex-c.cycle")]),
    line(
        109,
        0x3f74_320a_3a6a_afe8,
        &[
            Claim("jazar.ex-c.product"),
            Claim("jazar.ex-c.dwell"),
            Reading("jazar.ex-c.division"),
            Claim("jazar.ex-c.dwell-seconds"),
        ],
    ),
    line(
        111,
        0xec95_bfa9_2d25_ee7d,
        &[Label("5.32"), Claim("jazar.ex-d.reference"), Claim("jazar.ex-d.angle"), Again("jazar.ex.stations")],
    ),
    line(113, 0x4e18_e118_1d0a_2732, &[Claim("jazar.ex-d.sine")]),
    line(115, 0x5e39_09c2_5b2b_93b6, &[Again("jazar.ex-d.angle"), Label("5.31")]),
    line(117, NONE, &[Claim("jazar.ex-d.peak-equation")]),
    line(121, 0x3870_34b4_4493_44e0, &[Claim("jazar.ex-d.driver-formula"), Claim("jazar.ex-d.driver-speed")]),
    line(125, 0x77ae_9fee_8a92_f474, &[Claim("jazar.ex-d.peak")]),
    line(
        127,
        0x9100_d0d0_3285_6553,
        &[
            Label("5.29"),
            Claim("jazar.ex-d.senses"),
            exception(
                "jazar.absolute-senses",
                "",
                "which of the two angles grows clockwise is a choice of the lost Fig. 5.29; only that they are \
                 opposite can be tested",
            ),
        ],
    ),
    line(
        129,
        0x30f9_01c2_41cd_8b44,
        &[Label("5.32"), Claim("jazar.ex-e.plot"), Label("5.30"), Again("jazar.ex-b.alpha")],
    ),
    line(131, 0x9104_5bd0_3288_875b, &[Label("5.32")]),
    line(133, 0x39fc_8dbd_7137_c12b, &[Claim("jazar.ex-e.derivative")]),
    line(
        137,
        0xaf63_ad4c_8601_9caf,
        &[exception(
            "jazar.ex-e.zero",
            "0",
            "sets the derivative to zero; what that leads to is the claim of line 141",
        )],
    ),
    line(141, 0x8aaa_75d6_3080_6280, &[Claim("jazar.ex-e.condition")]),
    line(143, 0xca0b_e791_f880_1eb4, &[Claim("jazar.ex-e.pythagoras")]),
    line(145, 0xc088_ae91_f2de_ec6f, &[Claim("jazar.ex-e.quadratic")]),
    line(149, 0x3c30_ba9f_fa37_104d, &[Claim("jazar.eq-5.33"), Label("5.33")]),
    line(151, NONE, &[Claim("jazar.ex-e.preceding")]),
    line(153, 0x8c8f_ca91_d56e_f107, &[Claim("jazar.ex-e.roots")]),
    line(
        155,
        0x294d_48d7_95f9_d54a,
        &[Claim("jazar.ex-e.root-choice"), Claim("jazar.ex-e.alpha-range"), Claim("jazar.ex-e.maximum")],
    ),
    line(157, 0x6cd9_5d7b_d0b0_e0e0, &[Claim("jazar.eq-5.34"), Label("5.34")]),
    line(
        159,
        0x3d28_5ed2_d1c6_4962,
        &[
            Claim("jazar.ex-e.sign-of-angle"),
            Claim("jazar.ex-e.general-validity"),
            Label("5.33"),
            Label("5.34"),
            Again("jazar.ex-d.sine"),
            Label("5.33"),
        ],
    ),
    line(161, 0x41e1_5cf1_1655_123b, &[Claim("jazar.ex-e.gamma")]),
    line(163, 0x9104_61d0_3288_918d, &[Label("5.34")]),
    line(165, 0xbc42_381d_154d_3e98, &[Claim("jazar.ex-e.angle")]),
    line(167, 0x9104_5bd0_3288_875b, &[Label("5.32")]),
    line(
        169,
        0x7826_6988_1b91_e044,
        &[Claim("jazar.ex-e.ratio-form"), Reading("jazar.ex-e.signs"), Claim("jazar.ex-e.ratio")],
    ),
    line(
        171,
        0x36dc_d37e_1a43_1591,
        &[Claim("jazar.ex-e.driver-formula"), Again("jazar.ex-d.driver-speed"), Claim("jazar.ex-e.peak")],
    ),
];
