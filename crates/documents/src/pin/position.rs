//! The position triangle OPB: law of cosines, law of sines.

use super::letters::{AT_THIRTY, SPEEDS, makes_exact};
use super::signs::between;
use super::*;
use geneva_evidence::filled;

const COSINES: Locator = at("Solution, law of cosines");
const SINES: Locator = at("Solution, law of sines");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        at("Solution, 1st sentence")
            .figure("pin.position-figure", "OPB", "triangle OPB is the position at the given crank angle")
            .first_route(Evidence::VECTORS, |stated| {
                // The corner P from the triangle's own side and angle at O, against the crank's end.
                let radius = triangle(|t| t.slot_radius);
                let corner = Turn::from_radians(triangle(|t| t.angle_at_pivot)).direction() * radius;
                let crank =
                    stated.pick(PIN.printed_number("pin.crank-angle"), PIN.printed_number("pin.angle-at-driver"));
                at_the_instant(|instant, _| {
                    let end = Turn::from_degrees(crank).direction() * instant.mechanism.crank_radius();
                    let gap = (corner - instant.axis() - end).norm();
                    Finding::new(
                        vanishes(gap / radius),
                        format!("with the crank at {crank}° its end is {gap:.1} mm from the corner P"),
                    )
                })
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                // The angle at B from the three sides, by the digits of the printed r.
                let (radius, distance) =
                    (PIN.printed_number("pin.crank-radius"), PIN.printed_number("pin.crank-radius") * 2f64.sqrt());
                let [least, most] = PIN.printed_interval("pin.radius").map(|side| {
                    let cosine = (radius * radius + distance * distance - side * side) / (2.0 * radius * distance);
                    libm::acos(cosine).to_degrees()
                });
                let crank =
                    stated.pick(PIN.printed_number("pin.crank-angle"), PIN.printed_number("pin.angle-at-driver"));
                Finding::new(
                    (least..most).contains(&(180.0 - crank)),
                    format!("the printed r needs a crank angle of {:.1}° to {:.1}°", 180.0 - most, 180.0 - least),
                )
            })
            .but_not("it is the position at a crank angle of 30°"),
        COSINES
            .equation(
                "pin.law-of-cosines",
                r"r^{2}=R^{2}+l^{2}-2 R l \cos \ldots^{\circ}",
                "law of cosines for the side OP",
            )
            .rewritten_and_proven(SPEEDS, filled(&[r"\theta^\circ"])),
        COSINES
            .value("pin.angle-at-driver", "30", "°", "angle of the triangle at B")
            .first_route(Evidence::CLOSED_FORM, || 180.0 - PIN.printed_number("pin.crank-angle"))
            .second_route(Evidence::VECTORS, || {
                PinProblem::printed().map_or(f64::NAN, |instant| {
                    let (to_pin, to_pivot) = (instant.crank.direction(), Vector2::new(-1.0, 0.0));
                    between(&to_pin, &to_pivot)
                })
            }),
        COSINES
            .value("pin.radius-squared", "0.551", "R^{2}", "square of OP, in squared crank radii")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.radius_squared_ratio))
            .second_route(Evidence::VECTORS, || {
                let radius = PIN.printed_number("pin.crank-radius");
                vectors(|motion| motion.position.norm_squared()) / (radius * radius)
            }),
        COSINES
            .value("pin.radius-ratio", "0.742", "R", "OP in crank radii")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.radius_ratio))
            .second_route(Evidence::VECTORS, || {
                vectors(|motion| motion.position.norm()) / PIN.printed_number("pin.crank-radius")
            })
            .rounded(|| PIN.printed_number("pin.radius-squared").sqrt()),
        COSINES
            .value("pin.radius", "37.1", "mm", "OP, distance of the pin from the follower's pivot")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.slot_radius))
            .second_route(Evidence::VECTORS, || vectors(|motion| motion.position.norm()))
            .rounded(|| PIN.printed_number("pin.radius-ratio") * PIN.printed_number("pin.crank-radius")),
        signs::letter_b(),
        SINES
            .equation(
                "pin.law-of-sines",
                r"\frac{\sin b}{R}=\frac{\sin 30^{\circ}}{r}",
                "law of sines for the angle at O",
            )
            .in_letters(AT_THIRTY),
        // An equation with a rounded number in it holds if the number is a rounding of what would make it exact.
        SINES
            .equation(
                "pin.sine-at-pivot",
                r"\sin b=\frac{\sin 30^{\circ}}{0.742}",
                "sine of the angle at O, from the rounded r/R",
            )
            .evaluated(Evidence::VECTORS, |tex| {
                let angle = vectors(|motion| libm::atan2(motion.position.y.abs(), motion.position.x));
                Finding::of_reading(makes_exact(tex, ("b", angle)))
            })
            .read(Evidence::CLOSED_FORM, |tex| {
                // The angle at O from the three sides, with r² = (3 − √6) R² and l² = 2 R².
                let square = 3.0 - 6f64.sqrt();
                makes_exact(tex, ("b", libm::acos((1.0 + square) / (2.0 * (2.0 * square).sqrt()))))
            }),
        SINES
            .value("pin.angle-at-pivot", "42.4", "°", "angle of the slot at O from the line of centres")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.angle_at_pivot).to_degrees())
            .second_route(Evidence::VECTORS, || {
                vectors(|motion| Turn { cos: motion.position.x, sin: motion.position.y.abs() }.degrees())
            })
            .rounded(|| {
                let sine = sine(PIN.printed_number("pin.angle-at-driver")) / PIN.printed_number("pin.radius-ratio");
                Turn { cos: (1.0 - sine * sine).sqrt(), sin: sine }.degrees()
            }),
    ]
}
