//! What the problem gives: its values, and how far apart the axes must be.

use super::letters::FOUR_SLOTS;
use super::*;
use geneva_evidence::tex::{decide, holds};
use geneva_kinematics::{Field, Rational, Surd, rational};

const STATEMENT: Locator = at("Problem, 1st paragraph");
const QUESTION: Locator = at("Problem, 2nd paragraph");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        at("Problem, 1st sentence")
            .figure("pin.problem-figure", "shown", "the drawing of the mechanism, with its crank radius")
            .missing(placement::LOST_DRAWING),
        signs::driver_sense(),
        signs::letter_v(),
        STATEMENT
            .value(
                "pin.driver-speed",
                "10",
                "rad/s",
                "the given angular velocity of the driver, confirmed by the printed speed and radius",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                PIN.printed_number("pin.pin-speed") / PIN.printed_number("pin.crank-radius")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                PIN.printed_number("pin.follower-speed") / ratio_at_the_instant()
            }),
        STATEMENT
            .statement(
                "pin.standstill",
                "four slots",
                "a four-slot wheel stands still as the pin enters and leaves a slot if l is √2 R",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let (needed, found) = (slot_at_entry(slots(stated)), slot_at_standstill(2));
                let holds = needed.as_ref() == Some(&found);
                let needed = needed.map_or("not rational".to_owned(), |needed| needed.to_string());
                Finding::new(
                    holds,
                    format!("the wheel stands still where tan² φ is {found}, and the pin enters where it is {needed}"),
                )
            })
            .second_route(Evidence::JET, |stated| {
                let speeds = match slots(stated) {
                    4 => speeds_of_four(),
                    6 => speeds_of_six(),
                    other => return Finding::new(false, format!("there is no exact power series with {other} slots")),
                };
                let still =
                    speeds.as_ref().is_some_and(|speeds| speeds.iter().all(|speed| *speed == Roots::integer(0)));
                let which = if still { "zero at both, exactly" } else { "not zero" };
                Finding::new(
                    still,
                    format!("by power series at entry and exit, with √2 exact, the wheel's speed is {which}"),
                )
            })
            .but_not("six slots, with the same distance"),
        STATEMENT
            .equation(
                "pin.centre-distance",
                r"l=1 \overline{2} R",
                "centre distance of a four-slot wheel that starts from rest and stops at rest",
            )
            .decided(|tex| {
                // A digit one and a bar over the two: one times two, or 1.222…
                let read = ["2", r"\frac{11}{9}"]
                    .map(|number| decide(&tex.replace(r"1 \overline{2}", number), FOUR_SLOTS.exact));
                let [first, second] = read;
                if first.holds { first } else { second }
            })
            .read(FOUR_SLOTS.evidence, |tex| holds(tex, (FOUR_SLOTS.numbers)()))
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                let [least, most] = ratio_from_printed_radius();
                Finding::new(
                    (least..most).contains(&2f64.sqrt()),
                    format!("the printed r² needs an l/R between {least:.4} and {most:.4}"),
                )
            })
            .corrected(
                r"l=\sqrt{2} R",
                Slip {
                    id: "",
                    reason: "The copy we had shows a digit one and a bar over the two where a root sign is needed. It \
                             has lost signs in other places too, so we put this mistake down to the copy.",
                    witness: "The printed value of r² leads back to l/R = √2 within its digits, but not to either \
                              reading of the printed characters.",
                    origin: Origin::Copy,
                    consequence: Consequence::Copy,
                    changes: "",
                },
            ),
        QUESTION
            .value(
                "pin.crank-angle",
                "150",
                "°",
                "the given crank angle from the direction OB, confirmed by the angle at B and the printed r",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || 180.0 - PIN.printed_number("pin.angle-at-driver"))
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                // The angle at B from the three sides.
                let (radius, side) = (PIN.printed_number("pin.crank-radius"), PIN.printed_number("pin.radius"));
                let distance = 2f64.sqrt() * radius;
                let cosine = (radius * radius + distance * distance - side * side) / (2.0 * radius * distance);
                180.0 - libm::acos(cosine).to_degrees()
            }),
        signs::letter_f(),
    ]
}

/// The wheel's speed over the driver's by the closed form, from the angle alone.
fn ratio_at_the_instant() -> f64 {
    let crank = Turn::from_degrees(PIN.printed_number("pin.crank-angle"));
    velocity_ratio(&std::f64::consts::SQRT_2, &crank.supplement())
}

type WithTwo = Surd<Rational, 2>;

/// The number of slots; or six.
fn slots(stated: Stated) -> u32 {
    stated.pick(stated.count(), 6)
}

/// tan² of half a pitch, the angle of the slot as the pin enters; none if it is not rational.
fn slot_at_entry(slots: u32) -> Option<Rational> {
    match slots {
        3 => Some(rational(3, 1)),
        4 => Some(rational(1, 1)),
        6 => Some(rational(1, 3)),
        _ => None,
    }
}

/// tan² of the angle of the slot at which the wheel stands still, for l² over R²: where the pin moves along the slot,
/// and so cos θ = R / l.
fn slot_at_standstill(square: i64) -> Rational {
    let (square, one) = (rational(square, 1), rational(1, 1));
    let cosine_squared = one.clone() / square.clone();
    // (l − R cos θ)², in squared crank radii.
    let along_squared = square - rational(2, 1) + cosine_squared.clone();
    (one - cosine_squared) / along_squared
}

type Roots = Surd<WithTwo, 3>;

/// One half, √2 and √3.
fn roots() -> [Roots; 3] {
    [Roots::integer(1) / Roots::integer(2), Roots::from_plain(WithTwo::root()), Roots::root()]
}

/// The wheel's speed where its slots are at ±45°; OP is then R.
fn speeds_of_four() -> Option<[Roots; 2]> {
    let [half, two, _] = roots();
    speeds_at(&Roots::integer(1), &Turn { cos: two.clone() * half.clone(), sin: two * half })
}

/// The wheel's speed where its slots are at ±30° and the pin in them is nearer to O.
fn speeds_of_six() -> Option<[Roots; 2]> {
    let [half, two, three] = roots();
    let radius = (three.clone() - Roots::integer(1)) * two * half.clone();
    speeds_at(&radius, &Turn { cos: three * half.clone(), sin: half })
}

/// The wheel's speed with the pin at this distance from O in slots at this angle and at the opposite one, by the pin's
/// place differentiated, for l = √2 R. `None` if that is not on the pin's circle.
fn speeds_at(radius: &Roots, slot: &Turn<Roots>) -> Option<[Roots; 2]> {
    let [_, root, _] = roots();
    let speed = |slot: &Turn<Roots>| {
        let (cos, sin) = (slot.cos.clone() * radius.clone() - root.clone(), slot.sin.clone() * radius.clone());
        let on_the_circle = cos.clone() * cos.clone() + sin.clone() * sin.clone() == Roots::integer(1);
        let motion = pin_vectors::solve(&Roots::integer(1), &root, &Turn { cos, sin }, &Roots::integer(1))?;
        on_the_circle.then_some(motion.follower_speed)
    };
    Some([speed(slot)?, speed(&slot.reversed())?])
}

/// The interval of l/R that the printed digits of r² allow: k² − 2 k cos θ + 1 = r²/R² solved for the larger k.
fn ratio_from_printed_radius() -> [f64; 2] {
    let cosine = Turn::from_degrees(PIN.printed_number("pin.angle-at-driver")).cos;
    PIN.printed_interval("pin.radius-squared").map(|square| cosine + (square - 1.0 + cosine * cosine).sqrt())
}
