//! The worked example, parts (a), (b) and (d). Part (c) has a file of its own.

use super::letters::{FASTEST, PARTS};
use super::peak::{number, rounds_to_the_speed};
use super::*;
use super::{dwell, text};
use crate::duals::halved;
use geneva_kinematics::indexing::{Indexing, Phase};
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::{Expression, Field, Identity, pin_vectors, prove};

const DATA: Locator = at("Example, data");
const A: Locator = at("Ex. (a)");
const B: Locator = at("Ex. (b)");
const D: Locator = at("Ex. (d)");

pub(super) fn claims() -> Vec<Claim> {
    [advances(), dwell::claims(), velocity()].concat()
}

fn advances() -> Vec<Claim> {
    vec![
        DATA.value(
            "jazar.ex.rpm",
            "360",
            "rpm",
            "the given speed of the driver, confirmed by the printed angular velocity and number of advances",
        )
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || 60.0 * JAZAR.printed_number("jazar.ex-a.advances"))
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
            60.0 * JAZAR.printed_number("jazar.ex-d.driver-speed") / (2.0 * PI)
        }),
        DATA.statement("jazar.ex.single-pin", "single pin", "the given number of pins, confirmed by parts (a) and (c)")
            .first_route(Evidence::LIMIT_CASE, |stated| {
                // As many advances as pins pass, in a turn of the driver.
                let pins = f64::from(stated.pick(stated.count(), 2));
                let advances = pins * JAZAR.printed_number("jazar.ex.rpm") / 60.0;
                Finding::new(
                    JAZAR.prints_rounding_of("jazar.ex-a.advances", advances),
                    format!("there are {advances} advances per second"),
                )
            })
            .second_route(Evidence::JET, |stated| {
                // The part of the cycle that part (c) gives is the one in which the wheel moves.
                let pins = f64::from(stated.pick(stated.count(), 2));
                let moving = pins * six(entry_crank) / (2.0 * PI);
                Finding::new(
                    JAZAR.prints_rounding_of("jazar.ex-c.fraction", moving),
                    format!("the wheel moves for {moving:.3} of the cycle"),
                )
            })
            .but_not("the driver has two pins"),
        A.equation("jazar.ex-a.formula", "360/60", "revolutions per second from revolutions per minute")
            .evaluated(Evidence::OTHER_PLACE_IN_SOURCE, |tex| match number(tex) {
                Some(quotient) => same(quotient * JAZAR.printed_number("jazar.ex-c.cycle"), 1.0),
                None => Finding::of_reading(None),
            })
            .read(Evidence::LIMIT_CASE, |tex| Some(agrees(number(tex)?, advances_in_ten_seconds() / 10.0))),
        A.value(
            "jazar.ex-a.advances",
            "6",
            "per second",
            "advances per second, one for each turn of a driver with one pin",
        )
        .first_route(Evidence::CLOSED_FORM, || {
            JAZAR.printed_number("jazar.ex.rpm") / 60.0 * six(|wheel| f64::from(wheel.pins()))
        })
        .second_route(Evidence::LIMIT_CASE, || advances_in_ten_seconds() / 10.0),
        B.equation("jazar.ex-b.formula", r"2\alpha = 360^{\circ}/N", "angle of an advance").in_letters(PARTS),
        B.value("jazar.ex-b.advance", "60", "°", "angle through which the wheel advances")
            .first_route(Evidence::CLOSED_FORM, || 2.0 * six(Wheel::half_pitch_angle).to_degrees())
            .second_route(Evidence::VECTORS, || six(advance).to_degrees()),
        B.value("jazar.ex.stations", "6", "stations", "the given number of stations, confirmed by the printed angles")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || 360.0 / JAZAR.printed_number("jazar.ex-b.advance"))
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || 180.0 / JAZAR.printed_number("jazar.ex-b.alpha")),
        B.value("jazar.ex-b.alpha", "30", "°", "α, half the angle between slots")
            .first_route(Evidence::CLOSED_FORM, || six(Wheel::half_pitch_angle).to_degrees())
            .second_route(Evidence::VECTORS, || six(advance).to_degrees() / 2.0),
    ]
}

fn velocity() -> Vec<Claim> {
    vec![
        reference(),
        at("Ex. (d), reference to Eq. (5.32)")
            .value(
                "jazar.ex-d.angle",
                "0",
                "",
                "crank angle at which the wheel is fastest, where Eq. (5.32) is zero and changes from plus to minus",
            )
            .first_route(Evidence::JET, || zero_of_acceleration() + 0.0)
            .second_route(Evidence::LIMIT_CASE, || six(fastest_of_a_grid)),
        D.value("jazar.ex-d.sine", "0.5", "", "sin α of the six-station wheel")
            .first_route(Evidence::CLOSED_FORM, || six(|w| libm::sin(w.half_pitch_angle())))
            .second_route(Evidence::VECTORS, || six(|w| entry(w).normalize().y.abs())),
        at("Ex. (d), Eq. (5.31) at θ = 0")
            .equation(
                "jazar.ex-d.peak-equation",
                r"\dot{\phi}_{\rm max} = \dot{\theta}",
                "at its fastest, the six-station wheel turns as fast as its driver",
            )
            .in_letters(FASTEST),
        D.equation("jazar.ex-d.driver-formula", r"2\pi \times 6", "angular velocity of the driver")
            .evaluated(Evidence::CLOSED_FORM, rounds_to_the_speed)
            .read(Evidence::VECTORS, |tex| {
                // After the time of a cycle the crank is back where it was.
                let angle = number(tex)? * JAZAR.printed_number("jazar.ex-c.cycle");
                let [half, whole] = [angle / 2.0, angle].map(Turn::from_radians);
                Some(vanishes(whole.sin) && whole.cos > 0.0 && half.cos < 0.0)
            }),
        D.value("jazar.ex-d.driver-speed", "37.70", "rad/s", "angular velocity of the driver")
            .first_route(Evidence::CLOSED_FORM, example_speed)
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || 2.0 * PI / JAZAR.printed_number("jazar.ex-c.cycle")),
        D.value("jazar.ex-d.peak", "37.70", "rad/s", "peak angular velocity of the wheel")
            .first_route(Evidence::CLOSED_FORM, || example_speed() * six(Wheel::peak_velocity))
            .second_route(
                Evidence::JET, // By time, with as many turns in a second as the source counts advances.
                || six(|wheel| at_speed(wheel, 0.0, 2.0 * PI * JAZAR.printed_number("jazar.ex-a.advances"))[1]),
            ),
        absolute_senses(),
        senses(),
    ]
}

fn reference() -> Claim {
    at("Ex. (d), reference to Eq. (5.32)")
        .statement(
            "jazar.ex-d.reference",
            "maximum value",
            "Eq. (5.32) shows where the velocity of Eq. (5.31) is greatest",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            let formula = stated.pick("jazar.eq-5.32", "jazar.eq-5.30");
            for_all_stations(
                |wheel| tells_the_maximum(wheel, |t| steady_display(formula, wheel, t)),
                "it changes from plus to minus at θ = 0",
            )
        })
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            let order = stated.pick(2, 0);
            for_all_stations(
                |wheel| tells_the_maximum(wheel, |t| by_duals(wheel, t)[order]),
                "the derivative goes from plus to minus at θ = 0",
            )
        })
        .but_not("Eq. (5.30) shows it")
}

fn absolute_senses() -> Claim {
    at("Ex. (d), reference to Fig. 5.29")
        .statement(
            "jazar.ex-d.absolute-senses",
            "CCW direction while θ is positive in the CW",
            "ϕ is positive counterclockwise while θ is positive clockwise",
        )
        .first_route(Evidence::VECTORS, |stated| {
            let ([phi, theta], caption) = senses_and_caption(stated);
            for_all_stations(
                |wheel| {
                    let pin = |t: f64| turned_clockwise(wheel, -theta * t);
                    within(wheel.engagement_half_angle()).all(|t| {
                        let angle = libm::atan2(pin(t).y, pin(t).x);
                        let counted = vanishes(phi * angle - steady_display("jazar.eq-5.30", wheel, t));
                        counted && pin(t).perp(&pin(t + 1e-6)) * caption > 0.0
                    })
                },
                "with a driver turned so by θ, the pin's direction from the wheel's axis is the angle of Eq. (5.30), and \
                 the wheel turns as the caption of Fig. 5.28 says",
            )
        })
        .second_route(Evidence::EXACT_IDENTITY, |stated| {
            let (senses, caption) = senses_and_caption(stated);
            let proof: Finding = prove(&AbsoluteSenses { senses: senses.map(|sense| sense as i64) }).into();
            // The velocity of Eq. (5.31) is positive in the advance, so the wheel turns in the sense of positive φ.
            let as_in_the_caption = senses[0] == caption;
            let agrees = if as_in_the_caption { "agrees" } else { "disagrees" };
            let holds = proof.holds && as_in_the_caption;
            Finding::new(holds, format!("{}; the caption of Fig. 5.28 {agrees} with this sense of φ", proof.how))
        })
        .but_not("ϕ is positive clockwise while θ is positive counterclockwise")
        .interpreted_as(
            "This is a convention of Fig. 5.29, which is not in the copy we had. The equations need the two senses to \
             be opposite, but they hold in the mirror image as well. The caption of Fig. 5.28 decides between the two: it \
             says that the wheel is advanced counterclockwise, and by its own caption Fig. 5.29 models the same mechanism.",
        )
}

/// The senses in which φ and θ are positive, by the statement or by its mirror image; and the sense in which the wheel is
/// advanced by the caption of Fig. 5.28.
fn senses_and_caption(stated: Stated) -> ([f64; 2], f64) {
    let senses = text::senses_in(stated.characters()).map(|sense| sense * stated.pick(1.0, -1.0));
    (senses, text::sense(JAZAR.printed_text("jazar.fig-5.28-sense")))
}

fn senses() -> Claim {
    at("Ex. (d), reference to Fig. 5.29")
        .statement(
            "jazar.ex-d.senses",
            "opposite direction",
            "positive φ̇ and θ̇ mean that wheel and driver turn in opposite senses",
        )
        .first_route(Evidence::EXACT_IDENTITY, |stated| prove(&Senses { sign: stated.pick(1, -1) }).into())
        .second_route(Evidence::VECTORS, |stated| {
            for_all_stations(
                |wheel| {
                    within(wheel.engagement_half_angle()).all(|t| {
                        // The driver turns on, clockwise or counter-clockwise. The wheel turns counter-clockwise if the
                        // product is positive.
                        let pin = turned_clockwise(wheel, t);
                        [1e-6, -1e-6].iter().all(|on| {
                            let turning = pin.perp(&turned_clockwise(wheel, t + on));
                            turning * on * stated.pick(1.0, -1.0) > 0.0
                        })
                    })
                },
                "the wheel turns in this sense against the driver, whether the driver turns clockwise or counter-clockwise",
            )
        })
        .but_not("the wheel and the driver turn in the same sense")
}

/// While the driver turns in the sense in which θ is positive, the wheel's speed in the sense in which φ is positive is the
/// velocity ratio of Eq. (5.31). The senses of φ and θ are 1 counter-clockwise and −1 clockwise. Variables: k and the tangent
/// of half the crank's angle θ.
struct AbsoluteSenses {
    senses: [i64; 2],
}

impl Identity<2> for AbsoluteSenses {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let [phi, theta] = self.senses;
        let crank = Turn::from_half_tangent(&half);
        let formula = velocity_ratio(&ratio, &crank);
        let place = if theta < 0 { crank.supplement() } else { crank.supplement().reversed() };
        pin_vectors::solve(&Expression::ONE, &ratio, &place, &Expression::integer(theta))
            .map_or(Expression::ONE, |motion| phi * motion.follower_speed - formula)
    }
}

/// In one counter-clockwise sense for both, the speed of the wheel and `sign` times the velocity ratio of Eq. (5.31)
/// are opposite. Variables: k and the tangent of half the crank's angle.
struct Senses {
    sign: i64,
}

impl Identity<2> for Senses {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        let formula = self.sign * velocity_ratio(&ratio, &crank.supplement());
        pin_vectors::solve(&Expression::ONE, &ratio, &crank, &Expression::ONE)
            .map_or(Expression::ONE, |motion| motion.follower_speed + formula)
    }
}

/// Whether the velocity with this slope rises up to θ = 0 and falls from there.
fn tells_the_maximum(wheel: &Wheel, slope: impl Fn(f64) -> f64) -> bool {
    within(wheel.engagement_half_angle()).all(|t| if t == 0.0 { vanishes(slope(t)) } else { slope(t) * t < 0.0 })
}

/// Advances that begin in ten seconds of the example: from a locked wheel to one that moves, counted.
fn advances_in_ten_seconds() -> f64 {
    let Ok(wheel) = example() else { return f64::NAN };
    let turns = 10.0 * example_speed() / (2.0 * PI);
    let moves = |eighth: i64| {
        let crank = PI * (eighth.rem_euclid(8) as f64 - 4.0) / 4.0;
        wheel.motion(eighth.div_euclid(8), crank).is_ok_and(|motion| motion.phase == Phase::Advance)
    };
    let eighths = libm::round(8.0 * turns) as i64;
    (0..eighths).filter(|eighth| !moves(*eighth) && moves(eighth + 1)).count() as f64
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
    let [_, high] = halved([-end, end], |t| by_series(&wheel, t)[2] > 0.0);
    if high.abs() < 1e-15 { 0.0 } else { high }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::judge;

    #[test]
    fn other_senses_are_refused() {
        for [phi, theta] in [["CW", "CCW"], ["CW", "CW"], ["CCW", "CCW"]] {
            let words = format!("{phi} direction while θ is positive in the {theta}").leak();
            let claim = Claim { printed: words, ..absolute_senses() };
            assert!(!judge(Box::leak(Box::new(claim))).matches_record(), "{words}");
        }
        assert!(judge(Box::leak(Box::new(absolute_senses()))).matches_record());
    }
}
