//! The worked example, part (c): how long the output stands still.

use super::*;
use crate::{Consequence, Erratum, Origin, Slip, Verdict};
use geneva_kinematics::wheel::Phase;
use geneva_kinematics::{Rational, rational};

const C: &str = "Ex. (c)";

pub fn claims() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "jazar.ex-c.formula",
            C,
            "part of the cycle in which the output stands still",
            r"\lambda = \frac{180 - 2\alpha}{360}",
            Check::corrected_equation(
                (LimitCase, || same(fraction(-1), locked_part())),
                || same(fraction(1), locked_part()),
                // The caption of Fig. 5.28: locked for three quarters of the cycle, with four stations.
                (OtherPlaceInSource, || {
                    let alpha = rational(180, 4);
                    let locked = (rational(180, 1) + rational(2, 1) * alpha) / rational(360, 1);
                    Finding::new(
                        locked == Rational::from_parts(3.into(), 4u8.into()),
                        format!("{locked} for four stations"),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\lambda = \frac{180 + 2\alpha}{360}",
            slip: Slip {
                id: "",
                reason: "The advance takes 180° − 2α of the driver's turn, as the text says itself; the dwell takes \
                    the rest. The part that moves was taken for the part that stands still.",
                witness: "The caption of Fig. 5.28 has the wheel of four locked for three quarters of the cycle.",
                origin: Origin::Concept,
                consequence: Consequence::Derivation,
                changes: "",
            },
        }),
        Claim::value(
            WORK,
            "jazar.ex-c.fraction",
            C,
            "dwelling part of the cycle",
            ("1/3", ""),
            Check::number(
                (ClosedForm, || six(Wheel::dwell_fraction)),
                (Series, || 1.0 - six(entry_crank) / (2.0 * PI)),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "2/3", slip: inherits("One third of the cycle is the advance.") }),
        Claim::value(
            WORK,
            "jazar.ex-c.cycle",
            C,
            "duration of a cycle",
            ("1/6", "s"),
            Check::number(
                (ClosedForm, || 60.0 / printed("jazar.ex.rpm")),
                (OtherPlaceInSource, || 1.0 / printed("jazar.ex-a.advances")),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-c.product",
            C,
            "the time of the dwell is its part of the cycle's time",
            r"\tau = \lambda T",
            Check::equation(
                (ClosedForm, || same(dwell_seconds(), six(Wheel::dwell_fraction) * printed("jazar.ex-c.cycle"))),
                (LimitCase, || same(locked_part() * printed("jazar.ex-c.cycle"), dwell_seconds())),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.ex-c.dwell",
            C,
            "duration of the dwell, as a fraction",
            ("1/18", "s"),
            Check::number((ClosedForm, dwell_seconds), (LimitCase, || locked_part() * printed("jazar.ex-c.cycle"))),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "1/9",
            slip: inherits("An eighteenth of a second is the time of the advance."),
        }),
        Claim::statement(
            WORK,
            "jazar.ex-c.division",
            C,
            "the decimal is the fraction, rounded",
            "1/18 = 0.0555",
            Check::corrected_equation(
                (ClosedForm, || last_place(rational(0, 1))),
                || last_place(rational(1, 1)),
                (ClosedForm, || {
                    let next = next_digit();
                    Finding::new(next >= 5, format!("the first digit cut off is {next}"))
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "1/18 = 0.0556",
            slip: Slip {
                id: "",
                reason: "The decimal was cut off, not rounded.",
                witness: "Long division: the first digit that was cut off rounds up.",
                origin: Origin::Arithmetic,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::value(
            WORK,
            "jazar.ex-c.dwell-seconds",
            C,
            "duration of the dwell",
            ("0.0555", "s"),
            Check::number((ClosedForm, dwell_seconds), (LimitCase, || locked_part() * printed("jazar.ex-c.cycle"))),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "0.1111",
            slip: inherits("The time of the advance, and cut off rather than rounded."),
        }),
    ]
}

/// What an erratum of a number says that inherits the wrong fraction.
fn inherits(reason: &'static str) -> Slip {
    Slip {
        id: "",
        reason,
        witness: "Where the wheel of the power series comes to rest, or the state of the wheel changes: the rest of the turn is the dwell.",
        origin: Origin::Concept,
        consequence: Consequence::Result,
        changes: "",
    }
}

/// (180 ± 2α)/360 with the printed α.
fn fraction(sign: i32) -> f64 {
    (180.0 + f64::from(sign) * 2.0 * printed("jazar.ex-b.alpha")) / 360.0
}

/// Crank angle between entry and exit, from where the wheel of the power series is at rest.
fn entry_crank(wheel: &Wheel) -> f64 {
    2.0 * halved(0.0, PI / 2.0, |t| by_series(wheel, t)[1] > 0.0).0
}

/// Part of a turn in which the wheel is locked, from where its motion ends and begins.
fn locked_part() -> f64 {
    let Ok(wheel) = example() else { return f64::NAN };
    let moves = |t: f64| wheel.at(0, t).is_ok_and(|motion| motion.phase == Phase::Advance);
    1.0 - halved(0.0, PI, moves).0 / PI
}

fn dwell_seconds() -> f64 {
    example().and_then(|wheel| wheel.dwell_time(example_speed())).unwrap_or(f64::NAN)
}

fn exactly(id: &str) -> Rational {
    decimal(id).map_or(Rational::ZERO, |decimal| decimal.exact())
}

fn unit_of_the_decimal() -> Rational {
    decimal("jazar.ex-c.dwell-seconds").map_or(Rational::ZERO, |decimal| decimal.unit_in_last_place())
}

/// The digit of the printed fraction behind those of the printed decimal, by long division.
fn next_digit() -> i64 {
    let places = decimal("jazar.ex-c.dwell-seconds").map_or(0, |decimal| decimal.places());
    let shifted = exactly("jazar.ex-c.dwell") * Rational::from(10_i64.pow(places + 1));
    let ten = rational(10, 1);
    let whole = shifted.trunc();
    let tens = (Rational::from(whole.clone()) / ten).trunc();
    i64::try_from(whole - tens * 10).unwrap_or(0)
}

/// Whether the printed decimal and so many units of its last place are the printed fraction, rounded.
fn last_place(units: Rational) -> Finding {
    let off = exactly("jazar.ex-c.dwell") - exactly("jazar.ex-c.dwell-seconds") - units * unit_of_the_decimal();
    let half = unit_of_the_decimal() / rational(2, 1);
    Finding::new(-half.clone() <= off && off <= half, format!("the decimal is off by {off}"))
}
