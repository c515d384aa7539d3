//! The position: a triangle of ground, crank and lever.

use super::letters::{SIZES, TURN_A_MINUTE, UNITS};
use super::*;
use crate::vocabulary::{equal_to, filled};

const SINES: Place = at("Solution, position, 1st line");
const PROJECTIONS: Place = at("Solution, position, 2nd line");
const SPEED: Place = at("Solution, position, 3rd line");
const ANGLES: Place = at("Solution, position, 4th line");
const CRANK: Place = at("Solution, position, 5th line");

pub fn claims() -> Vec<Claim> {
    vec![
        SINES
            .value(
                "quick-return.ground",
                "0.45",
                "",
                "distance of the two axes in metres (as the speeds show), from the lost drawing, confirmed by the \
                 printed angles and lengths",
            )
            .by(OtherPlaceInSource, || {
                printed("quick-return.crank") * sine(printed("quick-return.angle-at-pin"))
                    / sine(printed("quick-return.lever-angle"))
            })
            .by(OtherPlaceInSource, || {
                let along = printed("quick-return.crank") * cosine(printed("quick-return.angle-at-pin"));
                (printed("quick-return.lever-length") - along) / cosine(printed("quick-return.lever-angle"))
            }),
        SINES
            .value(
                "quick-return.lever-angle",
                "20",
                "°",
                "angle of the lever from the line of centres, a value from the lost drawing",
            )
            .by(OtherPlaceInSource, || {
                180.0 - printed("quick-return.angle-at-axis") - printed("quick-return.angle-at-pin")
            })
            .by(OtherPlaceInSource, || {
                arcsine(
                    printed("quick-return.crank") * sine(printed("quick-return.angle-at-pin"))
                        / printed("quick-return.ground"),
                )
            }),
        SINES
            .value(
                "quick-return.crank",
                "0.20",
                "",
                "radius of the crank in metres (as the speeds show), a value from the lost drawing",
            )
            .by(OtherPlaceInSource, || printed("quick-return.pin-speed") / printed("quick-return.driver-rate"))
            .by(OtherPlaceInSource, || {
                printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                    / sine(printed("quick-return.angle-at-pin"))
            })
            .read_as("Our copy has lost the drawing that gives this length. The printed results need it."),
        SINES
            .equation(
                "quick-return.law-of-sines",
                r"\ldots \sin \ldots^\circ = \ldots \sin \beta",
                "law of sines at the lever's pivot and at the pin",
            )
            .rewritten_and_proven(SIZES, filled(&["l", r"\varphi^\circ", "l_2"])),
        SINES
            .value("quick-return.angle-at-pin", "50.31", "°", "β, the angle at the pin between lever and crank")
            .by(Vectors, || position_of(|position| position.angle_at_pin().to_degrees()))
            .by(ClosedForm, || {
                arcsine(
                    printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                        / printed("quick-return.crank"),
                )
            }),
        SINES
            .statement(
                "quick-return.branch",
                "beta",
                "of the two angles with this sine the acute one is meant, so the pin is at the far point of its \
                 circle",
            )
            .by(OtherPlaceInSource, |stated| {
                let at = Instant::on(stated.pick(Branch::Far, Branch::Near));
                let length = at.map_or(f64::NAN, |at| at.position.pin_distance);
                Finding::new(
                    rounds("quick-return.lever-length", length),
                    format!("with this angle the lever is {length:.3} m long"),
                )
            })
            .by(ClosedForm, |stated| {
                let lever = printed("quick-return.lever-angle");
                let beta = angle_at_pin(lever);
                let left = 180.0 - lever - stated.pick(beta, 180.0 - beta);
                Finding::new(
                    rounds("quick-return.angle-at-axis", left),
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
            .by(ClosedForm, || projected_length(printed("quick-return.lever-angle")))
            .by(Vectors, || position_of(|position| position.pin_distance)),
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
            .also_by(OtherPlaceInSource, || {
                let circumference = 2.0 * PI * printed("quick-return.crank");
                let turns = printed("quick-return.pin-speed") * 60.0 / circumference;
                let holds = rounds("quick-return.driver-speed", turns);
                Finding::new(
                    holds,
                    format!("at the printed speed the pin goes round its circle {turns:.2} times in a minute"),
                )
            }),
        SPEED
            .value("quick-return.driver-rate", "5.24", "rad/s", "angular velocity of the crank")
            .by(ClosedForm, || Instant::printed().map_or(f64::NAN, |instant| instant.drive.speed))
            .by(OtherPlaceInSource, || printed("quick-return.pin-speed") / printed("quick-return.crank")),
        ANGLES
            .equation(
                "quick-return.angle-sum",
                r"\gamma = 180^\circ - \ldots^\circ - \beta",
                "the third angle of the triangle",
            )
            .rewritten_and_proven(SIZES, filled(&[r"\varphi^\circ"]))
            .also_by(OtherPlaceInSource, || {
                let left = 180.0 - printed("quick-return.lever-angle") - printed("quick-return.angle-at-pin");
                Finding::new(rounds("quick-return.angle-at-axis", left), format!("the printed angles leave {left:.2}°"))
            }),
        ANGLES
            .value(
                "quick-return.angle-at-axis",
                "109.69",
                "°",
                "γ, the angle at the crank's axis between crank and ground",
            )
            .by(Vectors, || 180.0 - position_of(|position| position.crank.degrees().abs()))
            .by(ClosedForm, || {
                let sine_at_pin = printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                    / printed("quick-return.crank");
                180.0 - printed("quick-return.lever-angle") - arcsine(sine_at_pin)
            }),
        CRANK
            .equation(
                "quick-return.supplement",
                r"180^\circ - \gamma",
                "half a turn less γ is the angle of the crank from the line of centres",
            )
            .rewritten_and_proven(SIZES, equal_to(r"\psi"))
            .also_by(OtherPlaceInSource, || {
                let left = 180.0 - printed("quick-return.angle-at-axis");
                Finding::new(rounds("quick-return.crank-angle", left), format!("the printed γ leaves {left:.2}°"))
            }),
        CRANK
            .value(
                "quick-return.crank-angle",
                "70.31",
                "°",
                "the crank's angle from the line of centres, extended beyond the crank's axis",
            )
            .by(Vectors, || position_of(|position| position.crank.degrees().abs()))
            .by(ClosedForm, || {
                let sine_at_pin = printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                    / printed("quick-return.crank");
                printed("quick-return.lever-angle") + arcsine(sine_at_pin)
            }),
    ]
}
