//! The worked example, parts (a) to (d).

use super::*;
use crate::{Erratum, Severity, Verdict};
use geneva_kinematics::pin_proofs::VelocityRatio;
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::wheel::{Phase, peak_velocity};
use geneva_kinematics::wheel_proofs::{Printed, Quantity};
use geneva_kinematics::{Rational, prove, rational};

const DATA: &str = "Example, data";
const A: &str = "Ex. (a)";
const B: &str = "Ex. (b)";
const C: &str = "Ex. (c)";
const D: &str = "Ex. (d)";

pub fn claims() -> Vec<Claim> {
    [advances(), dwell(), velocity()].concat()
}

fn advances() -> Vec<Claim> {
    vec![
        value(
            "jazar.ex.rpm",
            DATA,
            "speed of the driver, a datum; the printed angular velocity and number of advances give it back",
            ("360", "rpm"),
            Check::number(
                (OtherPlaceInSource, || 60.0 * printed("jazar.ex-a.advances")),
                (OtherPlaceInSource, || 60.0 * printed("jazar.ex-d.driver-speed") / (2.0 * PI)),
            ),
        ),
        equation(
            "jazar.ex-a.formula",
            A,
            "revolutions per second from revolutions per minute",
            "360/60",
            Check::form(
                (ClosedForm, || same(printed("jazar.ex.rpm") / 60.0, printed("jazar.ex-a.advances"))),
                (OtherPlaceInSource, || same(1.0 / printed("jazar.ex-c.cycle"), printed("jazar.ex.rpm") / 60.0)),
            ),
        ),
        value(
            "jazar.ex-a.advances",
            A,
            "advances per second, one for each turn of a driver with one pin",
            ("6", "per second"),
            Check::number(
                (ClosedForm, || printed("jazar.ex.rpm") / 60.0 * six(|wheel| f64::from(wheel.pins()))),
                (LimitCase, || {
                    // Counted: stations passed in sixty turns of the driver, in ten seconds at its speed.
                    let turns = printed("jazar.ex.rpm") / 6.0;
                    let passed =
                        example().and_then(|w| w.at(turns as i64, 0.0)).map_or(f64::NAN, |m| m.stations as f64);
                    passed / 10.0
                }),
            ),
        ),
        equation(
            "jazar.ex-b.formula",
            B,
            "angle of an advance",
            r"2\alpha = 360^{\circ}/N",
            Check::form(
                (ClosedForm, || {
                    for_all_stations(
                        |w| (2.0 * w.half_station() * f64::from(w.stations()) - 2.0 * PI).abs() < 1e-14,
                        "2α is a turn over N",
                    )
                }),
                (Vectors, || same(six(advance).to_degrees(), 360.0 / printed("jazar.ex.stations"))),
            ),
        ),
        value(
            "jazar.ex-b.advance",
            B,
            "angle through which the wheel advances",
            ("60", "°"),
            Check::number(
                (ClosedForm, || 2.0 * six(Wheel::half_station).to_degrees()),
                (Vectors, || six(advance).to_degrees()),
            ),
        ),
        value(
            "jazar.ex.stations",
            B,
            "number of stations, a datum; the printed angles give it back",
            ("6", "stations"),
            Check::number(
                (OtherPlaceInSource, || 360.0 / printed("jazar.ex-b.advance")),
                (OtherPlaceInSource, || 180.0 / printed("jazar.ex-b.alpha")),
            ),
        ),
        value(
            "jazar.ex-b.alpha",
            B,
            "α, half the angle between slots",
            ("30", "°"),
            Check::number(
                (ClosedForm, || six(Wheel::half_station).to_degrees()),
                (Vectors, || six(advance).to_degrees() / 2.0),
            ),
        ),
    ]
}

fn dwell() -> Vec<Claim> {
    vec![
        equation(
            "jazar.ex-c.formula",
            C,
            "part of the cycle in which the output stands still",
            r"\lambda = \frac{180 - 2\alpha}{360}",
            Check::corrected_form(
                (LimitCase, || same(fraction(-1), locked_part())),
                || same(fraction(1), locked_part()),
                // The caption of Fig. 5.28: locked for three quarters of the cycle, with four stations.
                (OtherPlaceInSource, || {
                    let alpha = rational(180, 4);
                    let locked = (rational(180, 1) + rational(2, 1) * alpha) / rational(360, 1);
                    Finding::new(locked == Rational::from_parts(3.into(), 4u8.into()), format!("{locked} for four stations"))
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\lambda = \frac{180 + 2\alpha}{360}",
            reason: "The advance takes 180° − 2α of the driver's turn, as the text says itself; the dwell takes the rest. \
                     The part that moves was taken for the part that stands still.",
            witness: "The caption of Fig. 5.28 has the wheel of four locked for three quarters of the cycle.",
            severity: Severity::Conceptual,
            inherited_by: &["jazar.ex-c.fraction", "jazar.ex-c.dwell", "jazar.ex-c.dwell-seconds"],
        }),
        value(
            "jazar.ex-c.fraction",
            C,
            "dwelling part of the cycle",
            ("1/3", ""),
            Check::number((ClosedForm, || six(Wheel::dwell_fraction)), (Series, || 1.0 - six(entry_crank) / (2.0 * PI))),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "2/3", ..inherits("One third of the cycle is the advance.") }),
        value(
            "jazar.ex-c.cycle",
            C,
            "duration of a cycle",
            ("1/6", "s"),
            Check::number(
                (ClosedForm, || 60.0 / printed("jazar.ex.rpm")),
                (OtherPlaceInSource, || 1.0 / printed("jazar.ex-a.advances")),
            ),
        ),
        equation(
            "jazar.ex-c.product",
            C,
            "the time of the dwell is its part of the cycle's time",
            r"\tau = \lambda T",
            Check::form(
                (ClosedForm, || same(dwell_seconds(), six(Wheel::dwell_fraction) * printed("jazar.ex-c.cycle"))),
                (LimitCase, || same(locked_part() * printed("jazar.ex-c.cycle"), dwell_seconds())),
            ),
        ),
        value(
            "jazar.ex-c.dwell",
            C,
            "duration of the dwell, as a fraction",
            ("1/18", "s"),
            Check::number((ClosedForm, dwell_seconds), (LimitCase, || locked_part() * printed("jazar.ex-c.cycle"))),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "1/9", ..inherits("An eighteenth of a second is the time of the advance.") }),
        statement(
            "jazar.ex-c.division",
            C,
            "the decimal is the fraction, rounded",
            "1/18 = 0.0555",
            Check::corrected_form(
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
            reason: "The decimal was cut off, not rounded.",
            witness: "Long division: the first digit that was cut off rounds up.",
            severity: Severity::Arithmetical,
            inherited_by: &["jazar.ex-c.dwell-seconds"],
        }),
        value(
            "jazar.ex-c.dwell-seconds",
            C,
            "duration of the dwell",
            ("0.0555", "s"),
            Check::number((ClosedForm, dwell_seconds), (LimitCase, || locked_part() * printed("jazar.ex-c.cycle"))),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "0.1111", ..inherits("The time of the advance, and cut off rather than rounded.") }),
    ]
}

fn velocity() -> Vec<Claim> {
    vec![
        value(
            "jazar.ex-d.angle",
            "Ex. (d), reference to Eq. (5.32)",
            "crank angle at which the wheel is fastest; Eq. (5.32) is zero there and changes from plus to minus",
            ("0", ""),
            Check::number((Series, || zero_of_acceleration() + 0.0), (LimitCase, || six(fastest_of_a_grid))),
        ),
        value(
            "jazar.ex-d.sine",
            D,
            "sin α of the wheel of six",
            ("0.5", ""),
            Check::number(
                (ClosedForm, || six(|w| libm::sin(w.half_station()))),
                (Vectors, || six(|w| entry(w).normalize().y.abs())),
            ),
        ),
        equation(
            "jazar.ex-d.peak-equation",
            "Ex. (d), Eq. (5.31) at θ = 0",
            "the wheel of six is at its fastest as fast as its driver",
            r"\dot{\phi}_{\rm max} = \dot{\theta}",
            Check::form(
                (ExactIdentity, || {
                    let on_the_line = Turn { cos: rational(1, 1), sin: rational(0, 1) };
                    let ratio = velocity_ratio(&rational(2, 1), &on_the_line);
                    Finding::new(ratio == rational(1, 1), format!("with 1/sin α = 2 the ratio is {ratio}"))
                }),
                (Series, || same(six(|w| by_series(w, 0.0)[1]), 1.0)),
            ),
        ),
        equation(
            "jazar.ex-d.driver-formula",
            D,
            "angular velocity of the driver",
            r"2\pi \times 6",
            Check::form(
                (ClosedForm, || same(example_speed(), 2.0 * PI * printed("jazar.ex-a.advances"))),
                (OtherPlaceInSource, || {
                    let speed = 2.0 * PI * printed("jazar.ex-a.advances");
                    Finding::new(rounds("jazar.ex-d.driver-speed", speed), format!("{speed}"))
                }),
            ),
        ),
        value(
            "jazar.ex-d.driver-speed",
            D,
            "angular velocity of the driver",
            ("37.70", "rad/s"),
            Check::number((ClosedForm, example_speed), (OtherPlaceInSource, || 2.0 * PI / printed("jazar.ex-c.cycle"))),
        ),
        value(
            "jazar.ex-d.peak",
            D,
            "peak angular velocity of the wheel",
            ("37.70", "rad/s"),
            Check::number(
                (ClosedForm, || example_speed() * six(peak_velocity)),
                (Series, || example_speed() * six(|w| by_series(w, 0.0)[1])),
            ),
        ),
        statement(
            "jazar.ex-d.senses",
            "Ex. (d), reference to Fig. 5.29",
            "positive φ̇ and θ̇ mean that wheel and driver turn in opposite senses",
            "opposite direction",
            Check::form(
                (ExactIdentity, || prove(&VelocityRatio).into()),
                (Vectors, || {
                    // Counter-clockwise is positive for both here: the wheel's speed for a driver of speed one.
                    let crank = Turn::from_degrees(170.0);
                    let wheel =
                        geneva_kinematics::pin_vectors::solve(&1.0, &2.0, &crank, &1.0).map(|m| m.follower_speed);
                    Finding::new(
                        wheel.is_some_and(|speed| speed < 0.0),
                        format!("counter-clockwise driver of speed 1, wheel at {:.3}", wheel.unwrap_or(f64::NAN)),
                    )
                }),
            ),
        ),
        statement(
            "jazar.ex-d.reference",
            "Ex. (d), reference to Eq. (5.32)",
            "Eq. (5.32) tells where the velocity of Eq. (5.31) is greatest",
            "maximum value",
            Check::form(
                (ExactIdentity, || prove(&Printed(Quantity::Acceleration)).into()),
                (Series, || {
                    for_all_stations(
                        |w| by_series(w, -1e-3)[2] > 0.0 && by_series(w, 1e-3)[2] < 0.0,
                        "φ̈ goes from plus to minus at θ = 0",
                    )
                }),
            ),
        ),
    ]
}

/// What an erratum of a number says that inherits the wrong fraction.
fn inherits(reason: &'static str) -> Erratum {
    Erratum {
        corrected: "",
        reason,
        witness: "Where the wheel of the power series comes to rest, or the state of the wheel changes: the rest of the turn is the dwell.",
        severity: Severity::Conceptual,
        inherited_by: &[],
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

/// Angle through which the wheel turns from entry to exit.
fn advance(wheel: &Wheel) -> f64 {
    let end = wheel.engagement_half_angle();
    by_series(wheel, end)[0] - by_series(wheel, -end)[0]
}

/// The crank angle, of a thousand over the engagement, at which the wheel is fastest.
fn fastest_of_a_grid(wheel: &Wheel) -> f64 {
    let end = wheel.engagement_half_angle();
    let angles = (-500..=500).map(|step| end * f64::from(step) / 500.0);
    angles.max_by(|a, b| by_series(wheel, *a)[1].total_cmp(&by_series(wheel, *b)[1])).unwrap_or(f64::NAN)
}

/// Where the acceleration of the power series changes sign.
fn zero_of_acceleration() -> f64 {
    let Ok(wheel) = example() else { return f64::NAN };
    let end = wheel.engagement_half_angle();
    let (_, high) = halved(-end, end, |t| by_series(&wheel, t)[2] > 0.0);
    if high.abs() < 1e-15 { 0.0 } else { high }
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
