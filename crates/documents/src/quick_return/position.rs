//! The position: a triangle of ground, crank and lever.

use super::letters::{SIZES, TURN_A_MINUTE, UNITS};
use super::*;
use geneva_evidence::{equal_to, filled};

const SINES: Locator = at("Solution, position, 1st line");
const PROJECTIONS: Locator = at("Solution, position, 2nd line");
const SPEED: Locator = at("Solution, position, 3rd line");
const ANGLES: Locator = at("Solution, position, 4th line");
const CRANK: Locator = at("Solution, position, 5th line");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        SINES
            .value(
                "quick-return.ground",
                "0.45",
                "",
                "distance of the two axes in metres (as the speeds show), from the lost drawing, confirmed by the \
                 printed angles and lengths",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                QUICK_RETURN.printed_number("quick-return.crank")
                    * sine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"))
                    / sine(QUICK_RETURN.printed_number("quick-return.lever-angle"))
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                let along = QUICK_RETURN.printed_number("quick-return.crank")
                    * cosine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"));
                (QUICK_RETURN.printed_number("quick-return.lever-length") - along)
                    / cosine(QUICK_RETURN.printed_number("quick-return.lever-angle"))
            }),
        SINES
            .value(
                "quick-return.lever-angle",
                "20",
                "°",
                "angle of the lever from the line of centres, a value from the lost drawing",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                180.0
                    - QUICK_RETURN.printed_number("quick-return.angle-at-axis")
                    - QUICK_RETURN.printed_number("quick-return.angle-at-pin")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                arcsine(
                    QUICK_RETURN.printed_number("quick-return.crank")
                        * sine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"))
                        / QUICK_RETURN.printed_number("quick-return.ground"),
                )
            }),
        SINES
            .value(
                "quick-return.crank",
                "0.20",
                "",
                "radius of the crank in metres (as the speeds show), a value from the lost drawing",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                QUICK_RETURN.printed_number("quick-return.pin-speed")
                    / QUICK_RETURN.printed_number("quick-return.driver-rate")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                QUICK_RETURN.printed_number("quick-return.ground")
                    * sine(QUICK_RETURN.printed_number("quick-return.lever-angle"))
                    / sine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"))
            })
            .interpreted_as("Our copy has lost the drawing that gives this length. The printed results need it."),
        SINES
            .equation(
                "quick-return.law-of-sines",
                r"\ldots \sin \ldots^\circ = \ldots \sin \beta",
                "law of sines at the lever's pivot and at the pin",
            )
            .rewritten_and_proven(SIZES, filled(&["l", r"\varphi^\circ", "l_2"])),
        SINES
            .value("quick-return.angle-at-pin", "50.31", "°", "β, the angle at the pin between lever and crank")
            .first_route(Evidence::VECTORS, || position_of(|position| position.angle_at_pin().to_degrees()))
            .second_route(Evidence::CLOSED_FORM, || {
                arcsine(
                    QUICK_RETURN.printed_number("quick-return.ground")
                        * sine(QUICK_RETURN.printed_number("quick-return.lever-angle"))
                        / QUICK_RETURN.printed_number("quick-return.crank"),
                )
            }),
        SINES
            .statement(
                "quick-return.branch",
                "beta",
                "of the two angles with this sine the acute one is meant, so the pin is at the far point of its \
                 circle",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let at = LeverProblem::on(stated.pick(Branch::Far, Branch::Near));
                let length = at.map_or(f64::NAN, |at| at.position.pin_distance);
                Finding::new(
                    QUICK_RETURN.prints_rounding_of("quick-return.lever-length", length),
                    format!("with this angle the lever is {length:.3} m long"),
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                let lever = QUICK_RETURN.printed_number("quick-return.lever-angle");
                let beta = angle_at_pin(lever);
                let left = 180.0 - lever - stated.pick(beta, 180.0 - beta);
                Finding::new(
                    QUICK_RETURN.prints_rounding_of("quick-return.angle-at-axis", left),
                    format!("the angle at the crank's axis would be {left:.2}°"),
                )
            })
            .but_not("the obtuse angle is meant, so the pin is at the near point"),
        PROJECTIONS
            .equation(
                "quick-return.projections",
                r"r = \ldots \cos \ldots^\circ + \ldots \cos \beta",
                "length of the lever, as the projections of ground and crank on it",
            )
            .rewritten_and_proven(SIZES, filled(&["l", r"\varphi^\circ", "l_2"])),
        PROJECTIONS
            .value(
                "quick-return.lever-length",
                "0.55",
                "",
                "distance of the pin from the lever's pivot, later called l with the index 4",
            )
            .first_route(Evidence::CLOSED_FORM, || {
                projected_length(QUICK_RETURN.printed_number("quick-return.lever-angle"))
            })
            .second_route(Evidence::VECTORS, || position_of(|position| position.pin_distance)),
        SPEED
            .equation(
                "quick-return.rate-conversion",
                concat!(
                    r"\frac{\text{rev}}{\text{min}} \cdot \frac{2\pi \text{ rad}}{1 \text{ rev}}",
                    r" \cdot \frac{\text{min}}{60 \text{ s}}"
                ),
                "revolutions per minute to radians per second",
            )
            .rewritten_and_proven(UNITS, equal_to(TURN_A_MINUTE))
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                let circumference = 2.0 * PI * QUICK_RETURN.printed_number("quick-return.crank");
                let turns = QUICK_RETURN.printed_number("quick-return.pin-speed") * 60.0 / circumference;
                let holds = QUICK_RETURN.prints_rounding_of("quick-return.driver-speed", turns);
                Finding::new(
                    holds,
                    format!("at the printed speed the pin goes round its circle {turns:.2} times in a minute"),
                )
            }),
        SPEED
            .value("quick-return.driver-rate", "5.24", "rad/s", "angular velocity of the crank")
            .first_route(Evidence::CLOSED_FORM, || {
                LeverProblem::printed().map_or(f64::NAN, |instant| instant.drive.speed)
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                QUICK_RETURN.printed_number("quick-return.pin-speed")
                    / QUICK_RETURN.printed_number("quick-return.crank")
            }),
        ANGLES
            .equation(
                "quick-return.angle-sum",
                r"\gamma = 180^\circ - \ldots^\circ - \beta",
                "the third angle of the triangle",
            )
            .rewritten_and_proven(SIZES, filled(&[r"\varphi^\circ"]))
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                let left = 180.0
                    - QUICK_RETURN.printed_number("quick-return.lever-angle")
                    - QUICK_RETURN.printed_number("quick-return.angle-at-pin");
                Finding::new(
                    QUICK_RETURN.prints_rounding_of("quick-return.angle-at-axis", left),
                    format!("the printed angles leave {left:.2}°"),
                )
            }),
        ANGLES
            .value(
                "quick-return.angle-at-axis",
                "109.69",
                "°",
                "γ, the angle at the crank's axis between crank and ground",
            )
            .first_route(Evidence::VECTORS, || 180.0 - position_of(|position| position.crank.degrees().abs()))
            .second_route(Evidence::CLOSED_FORM, || {
                let sine_at_pin = QUICK_RETURN.printed_number("quick-return.ground")
                    * sine(QUICK_RETURN.printed_number("quick-return.lever-angle"))
                    / QUICK_RETURN.printed_number("quick-return.crank");
                180.0 - QUICK_RETURN.printed_number("quick-return.lever-angle") - arcsine(sine_at_pin)
            }),
        CRANK
            .equation(
                "quick-return.supplement",
                r"180^\circ - \gamma",
                "half a turn less γ is the angle of the crank from the line of centres",
            )
            .rewritten_and_proven(SIZES, equal_to(r"\psi"))
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                let left = 180.0 - QUICK_RETURN.printed_number("quick-return.angle-at-axis");
                Finding::new(
                    QUICK_RETURN.prints_rounding_of("quick-return.crank-angle", left),
                    format!("the printed γ leaves {left:.2}°"),
                )
            }),
        CRANK
            .value(
                "quick-return.crank-angle",
                "70.31",
                "°",
                "the crank's angle from the line of centres, extended beyond the crank's axis",
            )
            .first_route(Evidence::VECTORS, || position_of(|position| position.crank.degrees().abs()))
            .second_route(Evidence::CLOSED_FORM, || {
                let sine_at_pin = QUICK_RETURN.printed_number("quick-return.ground")
                    * sine(QUICK_RETURN.printed_number("quick-return.lever-angle"))
                    / QUICK_RETURN.printed_number("quick-return.crank");
                QUICK_RETURN.printed_number("quick-return.lever-angle") + arcsine(sine_at_pin)
            }),
    ]
}
