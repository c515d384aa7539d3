//! The worked example, parts (a), (b) and (d); part (c) has a room of its own.

use super::dwell;
use super::*;
use geneva_kinematics::pin_proofs::VelocityRatio;
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::wheel::peak_velocity;
use geneva_kinematics::wheel_proofs::{Printed, Quantity};
use geneva_kinematics::{prove, rational};

const DATA: &str = "Example, data";
const A: &str = "Ex. (a)";
const B: &str = "Ex. (b)";
const D: &str = "Ex. (d)";

pub fn claims() -> Vec<Claim> {
    [advances(), dwell::claims(), velocity()].concat()
}

fn advances() -> Vec<Claim> {
    vec![
        Claim::value(
            WORK,
            "jazar.ex.rpm",
            DATA,
            "speed of the driver, a datum; the printed angular velocity and number of advances give it back",
            ("360", "rpm"),
            Check::number(
                (OtherPlaceInSource, || 60.0 * printed("jazar.ex-a.advances")),
                (OtherPlaceInSource, || 60.0 * printed("jazar.ex-d.driver-speed") / (2.0 * PI)),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-a.formula",
            A,
            "revolutions per second from revolutions per minute",
            "360/60",
            Check::equation(
                (ClosedForm, || same(printed("jazar.ex.rpm") / 60.0, printed("jazar.ex-a.advances"))),
                (OtherPlaceInSource, || same(1.0 / printed("jazar.ex-c.cycle"), printed("jazar.ex.rpm") / 60.0)),
            ),
        ),
        Claim::value(
            WORK,
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
        Claim::equation(
            WORK,
            "jazar.ex-b.formula",
            B,
            "angle of an advance",
            r"2\alpha = 360^{\circ}/N",
            Check::equation(
                (ClosedForm, || {
                    for_all_stations(
                        |w| (2.0 * w.half_station() * f64::from(w.stations()) - 2.0 * PI).abs() < 1e-14,
                        "2α is a turn over N",
                    )
                }),
                (Vectors, || same(six(advance).to_degrees(), 360.0 / printed("jazar.ex.stations"))),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.ex-b.advance",
            B,
            "angle through which the wheel advances",
            ("60", "°"),
            Check::number(
                (ClosedForm, || 2.0 * six(Wheel::half_station).to_degrees()),
                (Vectors, || six(advance).to_degrees()),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.ex.stations",
            B,
            "number of stations, a datum; the printed angles give it back",
            ("6", "stations"),
            Check::number(
                (OtherPlaceInSource, || 360.0 / printed("jazar.ex-b.advance")),
                (OtherPlaceInSource, || 180.0 / printed("jazar.ex-b.alpha")),
            ),
        ),
        Claim::value(
            WORK,
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

fn velocity() -> Vec<Claim> {
    vec![
        Claim::value(
            WORK,
            "jazar.ex-d.angle",
            "Ex. (d), reference to Eq. (5.32)",
            "crank angle at which the wheel is fastest; Eq. (5.32) is zero there and changes from plus to minus",
            ("0", ""),
            Check::number((Series, || zero_of_acceleration() + 0.0), (LimitCase, || six(fastest_of_a_grid))),
        ),
        Claim::value(
            WORK,
            "jazar.ex-d.sine",
            D,
            "sin α of the wheel of six",
            ("0.5", ""),
            Check::number(
                (ClosedForm, || six(|w| libm::sin(w.half_station()))),
                (Vectors, || six(|w| entry(w).normalize().y.abs())),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-d.peak-equation",
            "Ex. (d), Eq. (5.31) at θ = 0",
            "the wheel of six is at its fastest as fast as its driver",
            r"\dot{\phi}_{\rm max} = \dot{\theta}",
            Check::equation(
                (ExactIdentity, || {
                    let on_the_line = Turn { cos: rational(1, 1), sin: rational(0, 1) };
                    let ratio = velocity_ratio(&rational(2, 1), &on_the_line);
                    Finding::new(ratio == rational(1, 1), format!("with 1/sin α = 2 the ratio is {ratio}"))
                }),
                (Series, || same(six(|w| by_series(w, 0.0)[1]), 1.0)),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-d.driver-formula",
            D,
            "angular velocity of the driver",
            r"2\pi \times 6",
            Check::equation(
                (ClosedForm, || same(example_speed(), 2.0 * PI * printed("jazar.ex-a.advances"))),
                (OtherPlaceInSource, || {
                    let speed = 2.0 * PI * printed("jazar.ex-a.advances");
                    Finding::new(rounds("jazar.ex-d.driver-speed", speed), format!("{speed}"))
                }),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.ex-d.driver-speed",
            D,
            "angular velocity of the driver",
            ("37.70", "rad/s"),
            Check::number((ClosedForm, example_speed), (OtherPlaceInSource, || 2.0 * PI / printed("jazar.ex-c.cycle"))),
        ),
        Claim::value(
            WORK,
            "jazar.ex-d.peak",
            D,
            "peak angular velocity of the wheel",
            ("37.70", "rad/s"),
            Check::number(
                (ClosedForm, || example_speed() * six(peak_velocity)),
                (Series, || example_speed() * six(|w| by_series(w, 0.0)[1])),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.ex-d.senses",
            "Ex. (d), reference to Fig. 5.29",
            "positive φ̇ and θ̇ mean that wheel and driver turn in opposite senses",
            "opposite direction",
            Check::equation(
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
        Claim::statement(
            WORK,
            "jazar.ex-d.reference",
            "Ex. (d), reference to Eq. (5.32)",
            "Eq. (5.32) tells where the velocity of Eq. (5.31) is greatest",
            "maximum value",
            Check::equation(
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
