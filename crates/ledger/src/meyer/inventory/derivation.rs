//! Chapter I from Lagrange's equation to Eq. (1-19), and the estimate of the inertias in chapter II.

use super::{NONE, exception, line};
use crate::Entry::{Again, Claim, Label, Reading};
use crate::Line;

pub const LINES: &[Line] = &[
    line(
        228,
        NONE,
        &[exception(
            "meyer.lagrange-chosen",
            "",
            "says which form of the equation is needed; the equation itself is a \
            claim",
        )],
    ),
    line(230, 0x459f_4018_184b_0bb7, &[Claim("meyer.eq-1-9"), Label("1-9")]),
    line(232, NONE, &[exception("meyer.t-named", "", "says what the letter T stands for")]),
    line(
        234,
        0xaa20_edfc_64da_407f,
        &[exception("meyer.q-named", "1, 2, 3", "numbers the coordinates; there is one here")],
    ),
    line(236, 0x459f_4018_184b_0bb7, &[Label("1-9"), Claim("meyer.constraint-forces"), Claim("meyer.no-potential")]),
    line(238, 0x459f_4018_184b_0bb7, &[Claim("meyer.one-degree"), Label("1-9")]),
    line(240, NONE, &[Claim("meyer.lagrange-for-theta")]),
    line(244, NONE, &[Claim("meyer.virtual-work")]),
    line(246, NONE, &[Claim("meyer.generalised-torque")]),
    line(248, NONE, &[Claim("meyer.vector-sum")]),
    line(
        250,
        NONE,
        &[exception(
            "meyer.three-frictions",
            "",
            "names three places of friction, two of them here and one in the next \
            line",
        )],
    ),
    line(
        252,
        NONE,
        &[exception(
            "meyer.bearings-ignored",
            "",
            "an assumption: friction in the bearings is left out; no number of the \
            source depends on how much that is",
        )],
    ),
    line(254, 0x459f_3918_184a_ffd2, &[Claim("meyer.resultant-torque")]),
    line(
        256,
        0xaa20_ecfc_64da_3ecc,
        &[exception("meyer.torques-named", "1 2 2", "names of the two torques"), Claim("meyer.friction-opposes")],
    ),
    line(258, 0x9365_74aa_273e_914e, &[Claim("meyer.eq-1-10"), Label("1-10")]),
    line(
        260,
        0xaf63_a84c_8601_9430,
        &[
            exception(
                "meyer.friction-named",
                "",
                "says what μ and N stand for; that N may change its sign is in the bars",
            ),
            Label("5"),
        ],
    ),
    line(263, 0xaf63_ab4c_8601_9949, &[Claim("meyer.fig-6")]),
    line(265, NONE, &[exception("meyer.thin-pin", "", "an assumption: a thin pin; its diameter is not given")]),
    line(269, 0xaf63_af4c_8601_a015, &[Claim("meyer.friction-torque")]),
    line(271, NONE, &[Claim("meyer.friction-opposes-again")]),
    line(273, 0xaf63_af4c_8601_a015, &[Claim("meyer.friction-torque.opposing")]),
    line(275, 0x459f_3818_184a_fe1f, &[Label("1-1")]),
    line(277, 0xaf63_af4c_8601_a015, &[Claim("meyer.friction-torque.by-ratio")]),
    line(
        279,
        0x459f_3518_184a_f906,
        &[
            Label("1-6"),
            exception(
                "meyer.triangle-lost",
                "",
                "announces a drawing without a caption that the copy has lost; the sine that is read off it is a claim",
            ),
        ],
    ),
    line(285, 0x65eb_7266_df19_aaac, &[Claim("meyer.eq-1-11"), Label("1-11")]),
    line(289, 0x9c7b_ad24_3b59_8bef, &[Claim("meyer.eq-1-12"), Label("1-12")]),
    line(294, 0xaf63_aa4c_8601_9796, &[Claim("meyer.fig-7")]),
    line(298, NONE, &[Claim("meyer.moments")]),
    line(300, 0x2e3b_33a6_d5d7_3a8e, &[Label("1-5"), Label("1-11")]),
    line(302, 0xdd3f_abb8_a573_361d, &[Claim("meyer.slot-radius.by-sines")]),
    line(304, 0xdd3f_abb8_a573_361d, &[Claim("meyer.slot-radius")]),
    line(306, 0x459f_3f18_184b_0a04, &[Label("1-8")]),
    line(308, NONE, &[Claim("meyer.normal-force")]),
    line(310, 0x2700_5009_97df_0bcd, &[Claim("meyer.normal-force.substituted")]),
    line(312, 0x60bc_bc36_b4f1_ba74, &[Claim("meyer.eq-1-13"), Label("1-13")]),
    line(314, 0x988a_7df1_476d_e677, &[Label("1-12")]),
    line(316, 0xafcf_8090_97ab_6435, &[Claim("meyer.friction-torque.substituted")]),
    line(318, 0x1d37_f29e_c83e_2280, &[Claim("meyer.eq-1-14"), Label("1-14")]),
    line(320, NONE, &[Claim("meyer.outside-the-bars")]),
    line(
        322,
        NONE,
        &[exception("meyer.spring-assumed", "", "an assumption: the spring of Appendix C, whose torque is constant")],
    ),
    line(324, 0x5180_43d7_09ba_b3f3, &[Claim("meyer.eq-1-15"), Label("1-15")]),
    line(326, NONE, &[Claim("meyer.spring-rate")]),
    line(
        328,
        0x988a_7ff1_476d_e9dd,
        &[
            Label("1-10"),
            exception(
                "meyer.energy-named",
                "",
                "says that the kinetic energy is that of the two rotations; the next \
            display is the claim",
            ),
        ],
    ),
    line(330, 0xc63b_c22e_1505_a82f, &[Claim("meyer.kinetic-energy")]),
    line(332, 0x459f_3618_184a_fab9, &[Label("1-7"), Claim("meyer.kinetic-energy.replaced")]),
    line(334, 0xd720_3372_45b0_de5f, &[Claim("meyer.kinetic-energy.substituted")]),
    line(336, 0x43d0_7d0e_7dae_9c16, &[Claim("meyer.eq-1-16"), Label("1-16")]),
    line(340, 0xb9b1_e767_42ce_166c, &[Claim("meyer.position-rate.set-up")]),
    line(342, 0xddbf_eea1_dda0_c2d7, &[Claim("meyer.momentum")]),
    line(344, 0xddbf_eea1_dda0_c2d7, &[Claim("meyer.momentum-rate.set-up")]),
    line(
        346,
        0x0ec8_6cc0_d6a5_c055,
        &[
            Claim("meyer.momentum-rate.quotient.first-line"),
            Claim("meyer.momentum-rate.quotient.second-line"),
            Claim("meyer.momentum-rate.quotient.third-line"),
        ],
    ),
    line(
        348,
        0x9277_9efd_14b7_f3bc,
        &[Claim("meyer.momentum-rate.cancelled.first-line"), Claim("meyer.momentum-rate.cancelled.second-line")],
    ),
    line(
        350,
        0xd855_b783_c92c_90a4,
        &[Claim("meyer.momentum-rate.factored.first-line"), Claim("meyer.momentum-rate.factored.second-line")],
    ),
    line(352, 0xd2f0_0577_a9aa_357f, &[Claim("meyer.momentum-rate")]),
    line(356, 0xb9b1_e767_42ce_166c, &[Claim("meyer.position-rate.taken-up")]),
    line(358, 0x2162_2d7d_f4c0_6c54, &[Claim("meyer.position-rate.outside")]),
    line(360, 0x5b56_db12_d9ff_aaba, &[Claim("meyer.position-rate.quotient")]),
    line(362, 0x22dc_7c87_a80e_c90f, &[Claim("meyer.position-rate.cancelled")]),
    line(364, 0xa30b_3043_0f46_e7fa, &[Claim("meyer.position-rate.factored")]),
    line(366, 0xe8ac_8533_0cd6_d9ad, &[Claim("meyer.position-rate")]),
    line(368, 0x988a_7ff1_476d_e9dd, &[Label("1-10")]),
    line(370, 0xc748_97f3_4703_7c6e, &[Claim("meyer.left-side"), Claim("meyer.eq-1-17"), Label("1-17")]),
    line(372, 0xc0d4_d6bf_bdc1_778b, &[Label("1-14"), Label("1-15"), Label("1-17"), Label("1-10")]),
    line(
        374,
        0x8c2f_46c3_c973_1aea,
        &[Claim("meyer.parts-put-in.first-line"), Claim("meyer.parts-put-in.second-line")],
    ),
    line(
        378,
        0x361e_fdf4_fef3_1ed4,
        &[Claim("meyer.eq-1-18.first-line"), Claim("meyer.eq-1-18.second-line"), Label("1-18")],
    ),
    line(380, 0x988a_77f1_476d_dc45, &[Label("1-18"), Claim("meyer.possible-flaw")]),
    line(382, 0xaa20_ecfc_64da_3ecc, &[Claim("meyer.singularity.quantity")]),
    line(
        384,
        NONE,
        &[exception(
            "meyer.theta-infinity-named",
            "",
            "says what θ_∞ stands for, and that nothing may be divided by zero",
        )],
    ),
    line(386, 0xfd38_c38e_2a97_a95c, &[Claim("meyer.singularity.assumed")]),
    line(388, 0x52bd_8a65_97e7_133f, &[Claim("meyer.singularity.angle")]),
    line(392, 0xfd38_c48e_2a97_ab0f, &[Claim("meyer.singularity.bound")]),
    line(394, 0xaa20_ecfc_64da_3ecc, &[Claim("meyer.singularity.cleared")]),
    line(396, 0xf43e_5479_64f4_022c, &[Claim("meyer.singularity.collected")]),
    line(398, 0xaa20_eefc_64da_4232, &[Claim("meyer.singularity.square")]),
    line(400, 0xa177_d5fc_5ff2_ea0d, &[Claim("meyer.singularity.only-one"), Label("1-2")]),
    line(402, 0x459f_3818_184a_fe1f, &[Claim("meyer.singularity.ratio")]),
    line(404, 0xaf63_ac4c_8601_9afc, &[Claim("meyer.singularity.sine")]),
    line(
        406,
        0x8833_eeb8_1e37_d17f,
        &[
            Claim("meyer.singularity.two-slots"),
            Again("meyer.singularity.two-slots"),
            Claim("meyer.singularity.ruled-out"),
            Label("1-3"),
            Label("1-18"),
            Claim("meyer.singularity.conclusion"),
        ],
    ),
    line(408, 0x988a_77f1_476d_dc45, &[Label("1-18")]),
    line(410, 0xddbf_eea1_dda0_c2d7, &[Claim("meyer.factor-a")]),
    line(412, 0xdc24_5b49_7f55_0dc7, &[Claim("meyer.factor-b")]),
    line(414, 0xcc7f_771b_7953_fee4, &[Claim("meyer.factor-c")]),
    line(416, 0xb1d9_bbc5_6034_752d, &[Claim("meyer.factor-d")]),
    line(418, NONE, &[Claim("meyer.factor-e")]),
    line(422, 0xf9ef_2346_8aa2_9fd2, &[Claim("meyer.eq-1-19"), Label("1-19")]),
    line(
        424,
        NONE,
        &[exception(
            "meyer.solved-in-appendix",
            "",
            "says that the equation will be solved by a computer, in Appendix B",
        )],
    ),
];

pub const INERTIA: &[Line] = &[
    line(
        441,
        0x633e_cc7c_5b80_f5ec,
        &[
            Claim("meyer.one-geometric-parameter"),
            Claim("meyer.four-parameters"),
            exception(
                "meyer.inertias-fixed",
                "",
                "says that the inertias are not varied: a choice, to which the tables keep",
            ),
            Claim("meyer.like-discs"),
            Claim("meyer.steel"),
        ],
    ),
    line(443, 0xaa20_eafc_64da_3b66, &[Claim("meyer.disc"), Claim("meyer.letter-m")]),
    line(445, 0x54c9_75db_0553_2d6a, &[Claim("meyer.disc.numbers"), Reading("meyer.gravity")]),
    line(447, 0xc5cf_9b46_6948_7f83, &[Claim("meyer.disc.inertia")]),
];
