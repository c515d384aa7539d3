//! The worked example, part (c): how long the output stands still.

use super::letters::{PARTS, PARTS_BY_DEGREES};
use super::*;
use crate::duals::halved;
use geneva_kinematics::indexing::{Indexing, Phase};
use geneva_kinematics::rational;

const C: Locator = at("Ex. (c)");

/// The part of the cycle that moves, in the place of the part that stands still.
const MOVING_PART: Slip = Slip {
    id: "jazar.ex-c.formula",
    reason: "The advance takes 180° − 2α of the driver's turn, as the handout itself says, where α is half the angle \
             between two slots. The dwell takes the rest of the turn. But the printed formula gives the part of the \
             cycle in which the wheel moves, and the printed numbers follow from this formula.",
    witness: "The caption of Fig. 5.28 says that the four-station wheel is locked for three quarters of the cycle, as \
              the corrected formula gives. For six stations, power series gave us the crank angle at which the \
              wheel comes to rest, and the corrected fraction follows from this angle. It also follows from the crank \
              angle at which the wheel in this book's code changes from indexing to dwell.",
    origin: Origin::Concept,
    consequence: Consequence::Result,
    changes: "Part (c) asks how long the output stands still, but the printed answer is the time for which it moves, \
              which is only half as long.",
};

pub(super) fn claims() -> Vec<Claim> {
    vec![
        formula(),
        C.value("jazar.ex-c.fraction", "1/3", "", "dwelling part of the cycle")
            .first_route(Evidence::CLOSED_FORM, || part(JAZAR.printed_number("jazar.ex-b.alpha"), -1.0))
            .second_route(Evidence::JET, || six(entry_crank) / (2.0 * PI))
            .right(Evidence::CLOSED_FORM, || six(Wheel::dwell_fraction), Evidence::LIMIT_CASE, || six(locked_part))
            .in_error(MOVING_PART),
        C.value("jazar.ex-c.cycle", "1/6", "s", "duration of a cycle")
            .first_route(Evidence::CLOSED_FORM, || 60.0 / JAZAR.printed_number("jazar.ex.rpm"))
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || 1.0 / JAZAR.printed_number("jazar.ex-a.advances")),
        C.equation("jazar.ex-c.product", r"\tau = \lambda T", "the dwell lasts its part λ of the time T of the cycle")
            .in_letters(PARTS),
        C.value("jazar.ex-c.dwell", "1/18", "s", "duration of the dwell, as a fraction")
            .first_route(Evidence::CLOSED_FORM, || seconds(JAZAR.printed_number("jazar.ex-c.fraction")))
            .second_route(Evidence::JET, || six(entry_crank) / example_speed())
            .right(Evidence::CLOSED_FORM, dwell_seconds, Evidence::LIMIT_CASE, || seconds(six(locked_part)))
            .in_error(MOVING_PART),
        C.value("jazar.ex-c.dwell-seconds", "0.0555", "s", "duration of the dwell, truncated instead of rounded")
            .first_route(Evidence::CLOSED_FORM, || seconds(part(JAZAR.printed_number("jazar.ex-b.alpha"), -1.0)))
            .second_route(Evidence::JET, || six(entry_crank) / example_speed())
            .rounded(|| long_division(4))
            .right(Evidence::CLOSED_FORM, dwell_seconds, Evidence::LIMIT_CASE, || seconds(six(locked_part)))
            .in_error(MOVING_PART)
            .interpreted_as(
                "The decimal is the fraction before it, cut off after the last place. If the fraction were rounded, the \
                 decimal would end in a 6.",
            ),
    ]
}

fn formula() -> Claim {
    C.equation(
        "jazar.ex-c.formula",
        r"\lambda = \frac{180 - 2\alpha}{360}",
        "part of the cycle in which the output stands still",
    )
    .in_letters(PARTS_BY_DEGREES)
    .with_second_witness(
        Evidence::OTHER_PLACE_IN_SOURCE, // The caption of Fig. 5.28: locked for three quarters of the cycle, with four stations.
        || {
            let alpha = rational(180, 4);
            let locked = (rational(180, 1) + rational(2, 1) * alpha) / rational(360, 1);
            Finding::new(
                locked == rational(3, 4),
                format!("for four stations the corrected form gives {locked}, and the caption of Fig. 5.28 says 3/4"),
            )
        },
    )
    .corrected(r"\lambda = \frac{180 + 2\alpha}{360}", MOVING_PART)
}

/// (180 ± 2α)/360 for α in degrees.
fn part(alpha: f64, sign: f64) -> f64 {
    (180.0 + sign * 2.0 * alpha) / 360.0
}

/// Part of a turn in which the wheel is locked, from where its motion ends and begins.
fn locked_part(wheel: &Wheel) -> f64 {
    let moves = |t: f64| wheel.motion(0, t).is_ok_and(|motion| motion.phase == Phase::Advance);
    1.0 - halved([0.0, PI], moves)[0] / PI
}

/// The time of a part of the cycle.
fn seconds(part: f64) -> f64 {
    part * JAZAR.printed_number("jazar.ex-c.cycle")
}

fn dwell_seconds() -> f64 {
    example().and_then(|wheel| wheel.dwell_time(example_speed())).unwrap_or(f64::NAN)
}

/// The printed fraction of a second as a decimal of so many places, by long division, which cuts off what is left.
fn long_division(places: u32) -> f64 {
    let numbers = JAZAR.printed_integers("jazar.ex-c.dwell");
    let [above, below] = numbers[..] else { return f64::NAN };
    let scale = 10u32.pow(places);
    (above * scale).checked_div(below).map_or(f64::NAN, |digits| f64::from(digits) / f64::from(scale))
}
