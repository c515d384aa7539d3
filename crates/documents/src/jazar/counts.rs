//! What the handout says in number words and nowhere in digits before: the stations of Fig. 5.28, the part of its cycle in
//! which the wheel moves, and the stations of the example.

use super::text::{CAPTION, locked_part, quarters};
use super::*;
use geneva_evidence::numbers_in;

/// The claims of the caption of Fig. 5.28.
pub(super) fn of_the_caption() -> Vec<Claim> {
    vec![
        CAPTION
            .figure("jazar.fig-5.28-stations", "four-station", "the wheel of Fig. 5.28 has four stations")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let distance = value(JAZAR.printed_text("jazar.centre-distance"), &by_name([("r", 1.0)]));
                same(1.0 / libm::sin(PI / f64::from(stated.pick(stated.count(), 3))), distance)
            })
            .second_route(Evidence::JET, |stated| {
                let turned = |wheel: &Wheel| 2.0 * by_series(wheel, wheel.engagement_half_angle())[0];
                let quarters =
                    numbers_in(JAZAR.printed_text("jazar.quarter-turn")).first().map_or(f64::NAN, |(_, one)| *one);
                same(of(stated.pick(stated.count(), 3), turned), quarters * PI / 2.0)
            })
            .but_not("it has three"),
        CAPTION
            .figure(
                "jazar.fig-5.28-motion",
                "one-quarter of a cycle",
                "a four-station wheel advances for a quarter of the driver's cycle",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                same(of(4, Wheel::motion_fraction), stated.pick(quarters(stated), 0.5))
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                same(of(4, |wheel| 1.0 - locked_part(wheel)), stated.pick(quarters(stated), 0.5))
            })
            .but_not("it advances for half of the cycle"),
    ]
}

/// The claims of the sentence that gives the wheel of the example.
pub(super) fn of_the_example() -> Vec<Claim> {
    let data = at("Example, data");
    vec![
        data.statement(
            "jazar.ex.six-station",
            "six-station",
            "the given number of stations of the example's wheel is six, confirmed by the printed angle and its sine",
        )
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            same(360.0 / stated.pick(stated.number(), 5.0), JAZAR.printed_number("jazar.ex-b.advance"))
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            same(libm::sin(PI / stated.pick(stated.number(), 5.0)), JAZAR.printed_number("jazar.ex-d.sine"))
        })
        .but_not("the wheel has five stations"),
    ]
}
