//! Letters and arrows: what the copy made of them, and what they stand for.
//!
//! Greek letters have become Latin ones, and arrows have become letters. If a letter, with its index if it has one,
//! names one thing in all its places, then nothing is wrong with it, and the claim says what it names. A letter in
//! place of an arrow says nothing. One rule holds for all the arrows: an arrow is known if it is the same in all
//! placements of the lost drawing that fit the text, or else in all those that fit the page that continues the problem.

use super::continuation::WHEEL_ARROW;
use super::placement::{AS_ON_THE_PAGE, fitting, left_by_the_page};
use super::*;

/// Letters where arrows are needed.
pub(super) const ARROWS: Slip = Slip {
    id: "pin.mark-f",
    reason: "The copy we had shows the letters d, f and i in place of three arrows. The text settles the sense of the \
             wheel, because it says in which sense the driver turns, and the wheel turns in the opposite sense wherever \
             the axes are drawn. But the text does not settle the two arrows before angles. An arrow before an angle \
             points up or down and to the left or to the right, and its angle is measured from the horizontal or from \
             the vertical. The printed angles fit eight ways of drawing the mechanism, each with its own pair of arrows. \
             A public page that continues the problem prints the first of the two arrows, and only one of the eight ways \
             has this arrow. So the page, together with the printed angles, settles the second arrow too.",
    witness: "The angles of the crank and of the slot alone give the same directions in each placement, and the page prints \
              the arrows of the sliding velocity and of the wheel. However, it prints no velocity of the slot's point.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

pub(super) fn letter_v() -> Claim {
    at("Problem, 1st paragraph")
        .statement(
            "pin.letter-v",
            "V_D",
            "the letter V or v (ω, it seems) with the index of a disk means the angular velocity of that disk, here \
             the driver's",
        )
        .first_route(Evidence::DIMENSION, |stated| {
            // As an angular velocity, or as what the letter v names with the index of a point: a speed.
            let named = stated.pick(Some(Dimension::ANGULAR_SPEED), dimension("pin.pin-speed"));
            let printed = dimension("pin.driver-speed");
            let words = |dimension: Option<Dimension>| dimension.map_or("unknown".into(), |d| d.to_string());
            Finding::new(
                printed.is_some() && printed == named,
                format!(
                    "the printed unit has the dimension {}, and what the letter stands for has the dimension {}",
                    words(printed),
                    words(named)
                ),
            )
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            // By the speed of the pin that the solution prints, and by the radius on which the pin goes round.
            let speed = PIN.printed_number("pin.pin-speed");
            let named = stated.pick(speed / PIN.printed_number("pin.crank-radius"), speed);
            Finding::new(
                PIN.prints_rounding_of("pin.driver-speed", named),
                format!("what the letter stands for is {named:.1}"),
            )
        })
        .but_not("the letter names a speed, as it does with the index of a point")
}

pub(super) fn letter_f() -> Claim {
    at("Problem, 2nd paragraph")
        .statement("pin.letter-f", "f", "the letter f (φ, it seems) means the angle of the crank from the direction OB")
        .first_route(Evidence::VECTORS, |stated| {
            // The pin is on its circle about B, and as far from O as the printed r says.
            let (radius, distance) =
                (PIN.printed_number("pin.crank-radius"), PIN.printed_number("pin.crank-radius") * 2f64.sqrt());
            let [least, most] = PIN.printed_interval("pin.radius").map(|side| {
                let x = (side * side - radius * radius + distance * distance) / (2.0 * distance);
                let pin = Vector2::new(x - distance, (side * side - x * x).sqrt());
                stated.pick(heading(&pin), 180.0 - heading(&pin))
            });
            let (least, most) = (least.min(most), least.max(most));
            let angle = PIN.printed_number("pin.crank-angle");
            Finding::new(
                (least..most).contains(&angle),
                format!("by the printed r that angle is {least:.1}° to {most:.1}°"),
            )
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let corner = PIN.printed_number("pin.angle-at-driver");
            the_crank_angle(stated.pick(180.0 - corner, corner))
        })
        .but_not("the letter names the angle of the triangle at B")
}

/// Whether the number printed behind the letter f is this angle.
fn the_crank_angle(angle: f64) -> Finding {
    Finding::new(PIN.prints_rounding_of("pin.crank-angle", angle), format!("that angle is {angle:.1}°"))
}

pub(super) fn letter_b() -> Claim {
    at("Solution, law of sines")
        .statement(
            "pin.letter-b",
            "b",
            "the letter b (β, it seems) means the angle of the triangle at O, opposite the crank, although the text \
             does not say so",
        )
        .first_route(Evidence::VECTORS, |stated| {
            at_the_instant(|instant, motion| {
                let (pivot, axis, pin) = (Vector2::zeros(), instant.axis(), motion.position);
                let [corner, one, other] = stated.pick([pivot, axis, pin], [pin, pivot, axis]);
                let angle = between(&(one - corner), &(other - corner));
                Finding::new(PIN.prints_rounding_of("pin.angle-at-pivot", angle), format!("that angle is {angle:.2}°"))
            })
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            // r sin b / sin 30° is the side opposite to b, by the printed digits.
            let [[r_least, r_most], [b_least, b_most]] =
                ["pin.radius", "pin.angle-at-pivot"].map(|id| PIN.printed_interval(id));
            let scale = sine(PIN.printed_number("pin.angle-at-driver"));
            let [least, most] = [r_least * sine(b_least) / scale, r_most * sine(b_most) / scale];
            let side = PIN.printed_number("pin.crank-radius") * stated.pick(1.0, 2f64.sqrt());
            Finding::new(
                (least..most).contains(&side),
                format!("the opposite side is {side:.1} mm, and the printed r and b need {least:.1} to {most:.1} mm"),
            )
        })
        .but_not("the letter names the angle at P, opposite the line of centres")
}

pub(super) fn letter_g() -> Claim {
    at("Solution, angle in the velocity triangle")
        .statement(
            "pin.letter-g",
            "g",
            "the letter g (γ, it seems) means the angle between the pin's velocity and the slot, although the text \
             does not say so",
        )
        .first_route(Evidence::JET, |stated| {
            at_the_instant(|_, motion| {
                let side = stated.pick(motion.sliding_velocity, motion.slot_point_velocity);
                let angle = between(&motion.pin_velocity, &side);
                Finding::new(PIN.prints_rounding_of("pin.velocity-angle", angle), format!("that angle is {angle:.2}°"))
            })
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let opposite = PIN.printed_number(stated.pick("pin.slot-point-speed", "pin.sliding-speed"));
            let angle = libm::asin(opposite / PIN.printed_number("pin.pin-speed")).to_degrees();
            Finding::new(
                PIN.prints_rounding_of("pin.velocity-angle", angle),
                format!("by the printed speeds, the angle opposite that side is {angle:.2}°"),
            )
        })
        .but_not("the letter names the angle between the pin's velocity and the velocity of the slot's point")
}

pub(super) fn mark_d() -> Claim {
    at("Solution, velocity of the pin")
        .statement(
            "pin.mark-d",
            "d",
            "the arrow before the angles of the pin's velocity and of its sliding velocity, which says what these \
             angles are measured from",
        )
        .first_route(Evidence::JET, |stated| left_by_the_page(&fitting(by_vectors), |[first, _]| first, stated))
        .second_route(Evidence::CLOSED_FORM, |stated| left_by_the_page(&fitting(by_angles), |[first, _]| first, stated))
        .interpreted_as(AS_ON_THE_PAGE)
        .corrected("an arrow down and to the left, with the angle from the horizontal", ARROWS)
}

/// The directions of the pin's velocity, of the sliding velocity and of the slot point's velocity, by vectors.
pub(super) fn by_vectors(placement: Placement) -> [f64; 3] {
    let velocities: [fn(&PinMotion<f64>) -> f64; 3] = [
        |motion| heading(&motion.pin_velocity),
        |motion| heading(&motion.sliding_velocity),
        |motion| heading(&motion.slot_point_velocity),
    ];
    velocities.map(|velocity| placement.heading(placement.by_vectors(|_, motion| velocity(motion))))
}

/// Directions of the three velocities by the angles of the triangle: across the crank, from the pin to O, and across the
/// slot.
fn by_angles(placement: Placement) -> [f64; 3] {
    let slot = triangle(|t| t.angle_at_pivot).to_degrees();
    [PIN.printed_number("pin.crank-angle") + 90.0, slot + 180.0, slot + 270.0]
        .map(|angle| placement.heading_of_velocity(angle))
}

pub(super) fn mark_f() -> Claim {
    at("Solution, components of the velocity")
        .statement(
            "pin.mark-f",
            "f",
            "the arrow before the angle of the slot point's velocity, showing the direction from which the angle is \
             measured",
        )
        .first_route(Evidence::JET, |stated| left_by_the_page(&fitting(by_vectors), |[_, second]| second, stated))
        .second_route(Evidence::CLOSED_FORM, |stated| {
            left_by_the_page(&fitting(by_angles), |[_, second]| second, stated)
        })
        .interpreted_as(AS_ON_THE_PAGE)
        .corrected("an arrow down and to the right, with the angle from the vertical", ARROWS)
}

/// The sense in which the driver turns, which the page that continues the problem confirms.
pub(super) fn driver_sense() -> Claim {
    let speed = |stated: Stated| stated.pick(1.0, -1.0) * PIN.printed_number("pin.driver-speed");
    at("Problem, 1st paragraph")
        .statement("pin.driver-sense", "counterclockwise", "the driver turns counterclockwise")
        .first_route(Evidence::JET, move |stated| {
            as_on_the_page(move |placement| {
                let at = PinProblem { driver_speed: speed(stated), ..PinProblem::placed(placement).ok()? };
                Some(at.by_vectors()?.follower_speed)
            })
        })
        .second_route(Evidence::CLOSED_FORM, move |stated| {
            // Against the driver by the velocity ratio, which is positive in opposite senses.
            as_on_the_page(move |_| {
                let crank = Turn::from_degrees(PIN.printed_number("pin.angle-at-driver"));
                Some(-speed(stated) * velocity_ratio(&2f64.sqrt(), &crank))
            })
        })
        .but_not("the driver turns clockwise")
        .interpreted_as(
            "In the copy, nothing else shows the sense of the driver. We confirm it by the page that continues the problem: \
             this page prints an arrow for the sense of the wheel.",
        )
}

/// Whether the wheel turns in the sense that the page prints, wherever the mechanism is drawn.
fn as_on_the_page(speed: impl Fn(Placement) -> Option<f64>) -> Finding {
    let page = Stated::right(WHEEL_ARROW);
    let found = Placement::all().map(|at| turns(speed(at).unwrap_or(f64::NAN), page)).collect::<Vec<_>>();
    Finding::of_cases(found.iter().all(|found| found.holds), &found)
}

pub(super) fn follower_sense() -> Claim {
    at("Solution, angular velocity of the wheel")
        .statement("pin.follower-sense", "i", "the arrow that says in which sense the wheel turns")
        .first_route(Evidence::JET, |stated| {
            let found: Vec<_> = Placement::all()
                .map(|placement| turns(placement.by_vectors(|_, motion| motion.follower_speed), stated))
                .collect();
            Finding::of_cases(found.iter().all(|found| found.holds), &found)
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            // The pin goes round O in the sense in which its velocity is across OP, by the printed angles; in the mirror
            // image both directions are mirrored and the velocity is reversed.
            let (velocity, slot) =
                (PIN.printed_number("pin.crank-angle") + 90.0, PIN.printed_number("pin.angle-at-pivot"));
            let [found, mirrored] = [[velocity, slot], [180.0 - velocity, -slot]]
                .map(|[velocity, slot]| turns(sine(velocity - slot), stated));
            // The page that continues the problem is another copy of the same text, so it says what the lost character was.
            let holds = found.holds && mirrored.holds && stated.characters() == WHEEL_ARROW;
            Finding::of_cases(holds, &[found, mirrored])
        })
        .corrected("an arrow that turns clockwise", ARROWS)
}

/// Whether the wheel turns in the stated sense, by an angular velocity that is positive counter-clockwise.
pub(crate) fn turns(speed: f64, stated: Stated) -> Finding {
    let words = stated.characters();
    let said = match (words.contains("clockwise"), words.contains("counter")) {
        (true, counter) => counter,
        (false, _) => return Finding::new(false, "a letter is printed, which shows no sense of turning"),
    };
    let found = if speed > 0.0 { "counter-clockwise" } else { "clockwise" };
    Finding::new(!speed.is_nan() && (speed > 0.0) == said, format!("the pin goes round the axis of the wheel {found}"))
}

/// The angle between two vectors in degrees, from 0° to 180°.
pub(super) fn between(a: &Vector2<f64>, b: &Vector2<f64>) -> f64 {
    Turn { cos: a.dot(b), sin: a.perp(b).abs() }.degrees()
}

/// The dimension of the unit printed with the number in the claim with this id.
pub(super) fn dimension(id: &str) -> Option<Dimension> {
    let mut parts = PIN.claim(id)?.unit.split('/').map(|unit| match unit {
        "mm" => Some(Dimension::LENGTH),
        "s" => Some(Dimension::TIME),
        "rad" => Some(Dimension::NONE),
        _ => None,
    });
    let above = parts.next()??;
    parts.try_fold(above, |quotient, below| Some(quotient / below?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::{Erratum, judge};

    #[test]
    fn every_other_arrow_is_refused() {
        let word = |is: bool, one: &'static str, other: &'static str| if is { one } else { other };
        let arrows = Arrow::all().map(|arrow| {
            format!(
                "an arrow {} and to the {}, with the angle from the {}",
                word(arrow.up, "up", "down"),
                word(arrow.right, "right", "left"),
                word(arrow.from_the_horizontal, "horizontal", "vertical")
            )
        });
        let words: Vec<&'static str> = arrows.map(|words| &*words.leak()).collect();
        for (claim, all) in [
            (mark_d as fn() -> Claim, words.clone()),
            (mark_f, words),
            (follower_sense, vec!["an arrow that turns clockwise", "an arrow that turns counter-clockwise"]),
        ] {
            let right = claim().right_characters();
            let holds = |corrected: &&&'static str| {
                let erratum = Erratum { corrected, places: 1, slip: ARROWS };
                let judged = judge(Box::leak(Box::new(Claim { erratum: Some(erratum), ..claim() })));
                judged.verdict == Verdict::Corrected && judged.faults.is_empty()
            };
            assert_eq!(all.iter().filter(holds).copied().collect::<Vec<_>>(), [right]);
        }
    }
}
