//! Appendix B: the text before the program and after it.

use super::{NONE, exception, line};
use crate::Entry::{Claim, Label};
use crate::Line;

pub const TEXT: &[Line] = &[
    line(
        598,
        0xc6a5_eeea_87b4_47b4,
        &[exception(
            "meyer.app-b.machine",
            "6500",
            "name of the computer; that the language is a set of subroutines is what \
            it was",
        )],
    ),
    line(600, 0xaf63_ad4c_8601_9caf, &[Claim("meyer.app-b.example")]),
    line(602, NONE, &[exception("meyer.app-b.first-step", "", "says what the next display does")]),
    line(604, NONE, &[Claim("meyer.app-b.example.solved")]),
    line(608, 0xaf63_af4c_8601_a015, &[Claim("meyer.app-b.example.second")]),
    line(610, 0xaf63_af4c_8601_a015, &[Claim("meyer.app-b.example.first")]),
    line(612, NONE, &[Claim("meyer.app-b.example.place")]),
    line(
        614,
        0x6075_4818_27bb_f90d,
        &[
            Claim("meyer.app-b.example.names"),
            Claim("meyer.app-b.example.initial"),
            exception("meyer.app-b.start-named", "0", "the time at the start"),
        ],
    ),
    line(
        616,
        0xee6e_20e3_4b19_ef14,
        &[
            exception("meyer.app-b.steps-named", "2 0", "names of the derivative and of the first times"),
            Claim("meyer.app-b.method.name"),
            exception("meyer.app-b.next-time-named", "2 1", "names of the derivative and of the time after the step"),
            Claim("meyer.app-b.method.one-value"),
            exception(
                "meyer.app-b.increment",
                "",
                "says that the step is chosen by the library, of which the text knows no \
            more than the error it keeps",
            ),
        ],
    ),
    line(618, NONE, &[Claim("meyer.app-b.method.order")]),
    line(
        620,
        NONE,
        &[exception(
            "meyer.app-b.method.kutta",
            "",
            "the rest of the name, and the form of an equation that is integrated",
        )],
    ),
    line(622, NONE, &[exception("meyer.app-b.method.form", "", "the general form of an equation of first order")]),
    line(
        624,
        0xd525_4b57_f495_af34,
        &[
            exception("meyer.app-b.method.interval-named", "1", "name of the end of an interval"),
            Claim("meyer.app-b.method.widths"),
            Claim("meyer.app-b.method.constant"),
        ],
    ),
    line(
        628,
        NONE,
        &[exception("meyer.app-b.method.form-again", "", "the general form of an equation of first order, once more")],
    ),
    line(
        630,
        0x7b1e_1b25_9e5a_02cc,
        &[exception("meyer.app-b.method.points-named", "0 0 1", "names of points and their values")],
    ),
    line(632, 0xea05_eda3_cfff_28d2, &[Claim("meyer.app-b.method.step")]),
    line(636, 0xaf63_ac4c_8601_9afc, &[Claim("meyer.app-b.method.f1")]),
    line(638, 0xf43e_5679_64f4_0592, &[Claim("meyer.app-b.method.f2")]),
    line(640, 0x0d9f_1094_ef44_33cc, &[Claim("meyer.app-b.method.f3")]),
    line(642, 0x2ba2_c718_0993_021e, &[Claim("meyer.app-b.method.f4")]),
    line(
        644,
        0xdf36_33ce_8772_29e4,
        &[
            Claim("meyer.app-b.method.one-point"),
            exception(
                "meyer.app-b.method.points-in-turn",
                "0 0 1 1 1 0 2",
                "names of points that are found one after the other",
            ),
            Claim("meyer.app-b.method.subinterval"),
            Claim("meyer.app-b.method.truncation"),
            Claim("meyer.app-b.method.doubling"),
            exception(
                "meyer.app-b.method.tolerance",
                "1 5 10 6",
                "name of a value, and the relative error that the library keeps: a \
            property of a program that the text cannot show",
            ),
        ],
    ),
    line(646, 0x988a_76f1_476d_da92, &[Label("1-19")]),
    line(648, 0xf9ef_2346_8aa2_9fd2, &[Claim("meyer.app-b.eq-1-19"), Label("1-19")]),
    line(650, NONE, &[Claim("meyer.app-b.cannot-be-solved")]),
    line(654, 0xaf63_af4c_8601_a015, &[Claim("meyer.app-b.f")]),
    line(658, 0x1381_ec24_4d88_1457, &[Claim("meyer.app-b.s")]),
    line(660, 0x988a_76f1_476d_da92, &[Label("1-19")]),
    line(662, 0x6075_4618_27bb_f5a7, &[Claim("meyer.app-b.with-sign")]),
    line(664, 0x6075_4618_27bb_f5a7, &[Claim("meyer.app-b.expanded")]),
    line(666, 0xaf63_af4c_8601_a015, &[Claim("meyer.app-b.collected")]),
    line(668, 0xaf63_af4c_8601_a015, &[Claim("meyer.app-b.solved")]),
    line(
        670,
        NONE,
        &[exception(
            "meyer.app-b.required-form",
            "",
            "says that this form can be programmed, as the program below shows",
        )],
    ),
    line(672, NONE, &[Claim("meyer.app-b.first-seven-cards"), Claim("meyer.app-b.spring-constant")]),
    line(
        674,
        0x7f0b_1c0c_b785_236d,
        &[
            Claim("meyer.app-b.letters"),
            Label("1-18"),
            Label("1-19"),
            exception("meyer.app-b.old-acceleration", "2 2 2 2", "names of the acceleration and of its old value"),
            Claim("meyer.app-b.simultaneous"),
            Claim("meyer.app-b.delay"),
        ],
    ),
    line(676, NONE, &[Claim("meyer.app-b.small-time")]),
];

pub const AFTER: &[Line] = &[
    line(
        729,
        0x425f_1f4d_36a5_e5a1,
        &[
            exception("meyer.app-b.start-acceleration-named", "2", "name of the acceleration"),
            Claim("meyer.app-b.start-lines"),
            Claim("meyer.app-b.initial-angles"),
            Claim("meyer.app-b.from-rest"),
        ],
    ),
    line(
        731,
        0xee6e_21e3_4b19_f0c7,
        &[
            exception("meyer.app-b.acceleration-named", "2 0", "name of the acceleration, and the time at the start"),
            Claim("meyer.app-b.large-time"),
            Claim("meyer.app-b.primary"),
            Claim("meyer.app-b.speed-name"),
            exception(
                "meyer.app-b.speed-integrated",
                "2 0",
                "name of the acceleration, and the speed at the start, which is a claim \
            two lines before",
            ),
        ],
    ),
    line(
        733,
        0x5bd0_81fc_fa76_1e42,
        &[
            Claim("meyer.app-b.angle-name"),
            Claim("meyer.app-b.increases"),
            Claim("meyer.app-b.engaged"),
            Claim("meyer.app-b.fold"),
            Claim("meyer.app-b.hand-over"),
            Claim("meyer.app-b.one-pin-at-a-time"),
        ],
    ),
    line(735, 0xe929_e3f9_2e79_7bed, &[Label("1-7"), Claim("meyer.app-b.run-length")]),
];
