//! Letters and arrows: what the copy made of them, and what they stand for.
//!
//! Greek letters have become Latin ones, and arrows have become letters. If a letter, with its index if it has one,
//! names one thing in all its places, then nothing is wrong with it, and the claim says what it names. A letter in
//! place of an arrow says nothing. One rule holds for all the arrows: the rest of the text tells what an arrow was if,
//! of all the arrows that could be there, only one makes the printed numbers right.

use super::*;
use crate::by_id::characters;

/// Letters where arrows are needed.
pub const ARROWS: Slip = Slip {
    id: "pin.mark-f",
    reason: "The copy we had shows the letters d, f and i in place of three arrows. The text settles each of them \
             without the drawing, because it gives the sense of the driver and the angle of the crank, and all other \
             senses follow from these. An arrow before an angle points up or down and to the left or to the right, \
             and its angle is measured from the horizontal or from the vertical. That makes eight possible arrows, \
             and only one of them fits the printed angles.",
    witness: "The angles of the crank and of the slot alone give the same directions. A public page that continues the \
              problem prints the arrows of the sliding velocity and of the wheel, and they are the same arrows. \
              However, it prints no velocity of the slot's point.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

pub fn letter_v() -> Claim {
    at("Problem, 1st paragraph")
        .statement(
            "pin.letter-v",
            "V_D",
            "the letter V or v (ω, it seems) with the index of a disk means the angular velocity of that disk, here \
             the driver's",
        )
        .by(Evidence::Dimension, |stated| {
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
        .by(OtherPlaceInSource, |stated| {
            // By the speed of the pin that the solution prints, and by the radius on which the pin goes round.
            let speed = printed("pin.pin-speed");
            let named = stated.pick(speed / printed("pin.crank-radius"), speed);
            Finding::new(rounds("pin.driver-speed", named), format!("what the letter stands for is {named:.1}"))
        })
        .but_not("the letter names a speed, as it does with the index of a point")
}

pub fn letter_f() -> Claim {
    at("Problem, 2nd paragraph")
        .statement("pin.letter-f", "f", "the letter f (φ, it seems) means the angle of the crank from the direction OB")
        .by(Vectors, |stated| {
            // The pin is on its circle about B, and as far from O as the printed r says.
            let (radius, distance) = (printed("pin.crank-radius"), printed("pin.crank-radius") * 2f64.sqrt());
            let [least, most] = interval("pin.radius").map(|side| {
                let x = (side * side - radius * radius + distance * distance) / (2.0 * distance);
                let pin = Vector2::new(x - distance, (side * side - x * x).sqrt());
                stated.pick(heading(&pin), 180.0 - heading(&pin))
            });
            let (least, most) = (least.min(most), least.max(most));
            let angle = printed("pin.crank-angle");
            Finding::new(
                (least..most).contains(&angle),
                format!("by the printed r that angle is {least:.1}° to {most:.1}°"),
            )
        })
        .by(OtherPlaceInSource, |stated| {
            let corner = printed("pin.angle-at-driver");
            the_crank_angle(stated.pick(180.0 - corner, corner))
        })
        .but_not("the letter names the angle of the triangle at B")
}

/// Whether the number printed behind the letter f is this angle.
fn the_crank_angle(angle: f64) -> Finding {
    Finding::new(rounds("pin.crank-angle", angle), format!("that angle is {angle:.1}°"))
}

pub fn letter_b() -> Claim {
    at("Solution, law of sines")
        .statement(
            "pin.letter-b",
            "b",
            "the letter b (β, it seems) means the angle of the triangle at O, opposite the crank, although the text \
             does not say so",
        )
        .by(Vectors, |stated| {
            at_the_instant(|instant, motion| {
                let (pivot, axis, pin) = (Vector2::zeros(), instant.axis(), motion.position);
                let [corner, one, other] = stated.pick([pivot, axis, pin], [pin, pivot, axis]);
                let angle = between(&(one - corner), &(other - corner));
                Finding::new(rounds("pin.angle-at-pivot", angle), format!("that angle is {angle:.2}°"))
            })
        })
        .by(OtherPlaceInSource, |stated| {
            // r sin b / sin 30° is the side opposite to b, by the printed digits.
            let [[r_least, r_most], [b_least, b_most]] = ["pin.radius", "pin.angle-at-pivot"].map(interval);
            let scale = sine(printed("pin.angle-at-driver"));
            let [least, most] = [r_least * sine(b_least) / scale, r_most * sine(b_most) / scale];
            let side = printed("pin.crank-radius") * stated.pick(1.0, 2f64.sqrt());
            Finding::new(
                (least..most).contains(&side),
                format!("the opposite side is {side:.1} mm, and the printed r and b need {least:.1} to {most:.1} mm"),
            )
        })
        .but_not("the letter names the angle at P, opposite the line of centres")
}

pub fn letter_g() -> Claim {
    at("Solution, angle in the velocity triangle")
        .statement(
            "pin.letter-g",
            "g",
            "the letter g (γ, it seems) means the angle between the pin's velocity and the slot, although the text \
             does not say so",
        )
        .by(Jet, |stated| {
            at_the_instant(|_, motion| {
                let side = stated.pick(motion.sliding_velocity, motion.slot_point_velocity);
                let angle = between(&motion.pin_velocity, &side);
                Finding::new(rounds("pin.velocity-angle", angle), format!("that angle is {angle:.2}°"))
            })
        })
        .by(OtherPlaceInSource, |stated| {
            let opposite = printed(stated.pick("pin.slot-point-speed", "pin.sliding-speed"));
            let angle = libm::asin(opposite / printed("pin.pin-speed")).to_degrees();
            Finding::new(
                rounds("pin.velocity-angle", angle),
                format!("by the printed speeds, the angle opposite that side is {angle:.2}°"),
            )
        })
        .but_not("the letter names the angle between the pin's velocity and the velocity of the slot's point")
}

pub fn mark_d() -> Claim {
    at("Solution, velocity of the pin")
        .statement(
            "pin.mark-d",
            "d",
            "the arrow before the angles of the pin's velocity and of its sliding velocity, which says what these \
             angles are measured from",
        )
        .by(Jet, |stated| {
            at_the_instant(|_, motion| {
                only_arrow(&TWO, [heading(&motion.pin_velocity), heading(&motion.sliding_velocity)], stated)
            })
        })
        .by(ClosedForm, |stated| {
            // Across the crank, and from the pin to O.
            let slot = triangle(|t| t.angle_at_pivot).to_degrees();
            let found = only_arrow(&TWO, [printed("pin.crank-angle") + 90.0, slot + 180.0], stated);
            Finding::new(found.holds && is_on_the_page(stated, "wild.holooly.sliding-direction"), found.how)
        })
        .corrected("an arrow down and to the left, with the angle from the horizontal", ARROWS)
}

/// Whether the public page that continues the problem prints these characters in a claim. The page is another copy of
/// the same text, so it says what a lost character was.
fn is_on_the_page(stated: Stated, id: &str) -> bool {
    stated.characters() == characters(id)
}

/// The claims whose angles have the first arrow before them, and the second.
const TWO: [&str; 2] = ["pin.pin-velocity-direction", "pin.sliding-velocity-direction"];
const ONE: [&str; 1] = ["pin.slot-point-velocity-direction"];

pub fn mark_f() -> Claim {
    at("Solution, components of the velocity")
        .statement(
            "pin.mark-f",
            "f",
            "the arrow before the angle of the slot point's velocity, showing the direction from which the angle is \
             measured",
        )
        .by(Jet, |stated| at_the_instant(|_, motion| only_arrow(&ONE, [heading(&motion.slot_point_velocity)], stated)))
        .by(ClosedForm, |stated| {
            // Across the slot, clockwise about O.
            only_arrow(&ONE, [270.0 + triangle(|t| t.angle_at_pivot).to_degrees()], stated)
        })
        .corrected("an arrow down and to the right, with the angle from the vertical", ARROWS)
}

pub fn follower_sense() -> Claim {
    at("Solution, angular velocity of the wheel")
        .statement("pin.follower-sense", "i", "the arrow that says in which sense the wheel turns")
        .by(Jet, |stated| at_the_instant(|_, motion| turns(motion.follower_speed, stated)))
        .by(OtherPlaceInSource, |stated| {
            // The pin goes round O in the sense in which its velocity is across OP, by the printed angles.
            let velocity = printed("pin.crank-angle") + 90.0;
            let found = turns(sine(velocity - printed("pin.angle-at-pivot")), stated);
            Finding::new(found.holds && is_on_the_page(stated, "wild.holooly.sense"), found.how)
        })
        .corrected("an arrow that turns clockwise", ARROWS)
}

/// An arrow before an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Arrow {
    up: bool,
    right: bool,
    from_the_horizontal: bool,
}

impl Arrow {
    /// Reads the arrow that the words describe; none if they describe none, as a letter does.
    fn read(words: &str) -> Option<Self> {
        let either = |one: &str, other: &str| match (words.contains(one), words.contains(other)) {
            (true, false) => Some(true),
            (false, true) => Some(false),
            _ => None,
        };
        Some(Self {
            up: either("up", "down")?,
            right: either("right", "left")?,
            from_the_horizontal: either("horizontal", "vertical")?,
        })
    }

    /// All eight.
    fn all() -> impl Iterator<Item = Self> {
        (0..8).map(|k| Self { up: k & 1 == 1, right: k & 2 == 2, from_the_horizontal: k & 4 == 4 })
    }

    /// The angle that is printed behind the arrow for a direction in degrees, counter-clockwise from the right; outside of
    /// 0° to 90° if the arrow points elsewhere.
    fn angle(self, heading: f64) -> f64 {
        // Turned over so that the arrow points up and to the right.
        let heading = if self.right { heading } else { 180.0 - heading };
        let heading = if self.up { heading } else { -heading }.rem_euclid(360.0);
        if self.from_the_horizontal { heading } else { 90.0 - heading }
    }

    /// Whether the arrow makes all these printed angles right, for these directions.
    fn fits(self, ids: &[&str], headings: &[f64]) -> bool {
        ids.iter().zip(headings).all(|(id, heading)| rounds(id, self.angle(*heading)))
    }
}

/// Whether the arrow in the statement fits the printed angles of these claims and no other arrow does.
pub(crate) fn only_arrow<const N: usize>(ids: &[&str; N], headings: [f64; N], stated: Stated) -> Finding {
    let fitting: Vec<Arrow> = Arrow::all().filter(|arrow| arrow.fits(ids, &headings)).collect();
    let pointing = headings.map(|heading| format!("{heading:.1}°")).join(" and ");
    let Some(arrow) = Arrow::read(stated.characters()) else {
        return Finding::new(false, "a letter is printed, which points nowhere");
    };
    let holds = fitting == [arrow];
    let count = fitting.len();
    Finding::new(holds, format!("{count} of eight arrows fits {pointing}, counted counter-clockwise from the right"))
}

/// Whether the wheel turns in the stated sense, by an angular velocity that is positive counter-clockwise.
pub(crate) fn turns(speed: f64, stated: Stated) -> Finding {
    let words = stated.characters();
    let said = match (words.contains("clockwise"), words.contains("counter")) {
        (true, counter) => counter,
        (false, _) => return Finding::new(false, "a letter is printed, which shows no sense of turning"),
    };
    let found = if speed > 0.0 { "counter-clockwise" } else { "clockwise" };
    Finding::new((speed > 0.0) == said, format!("the pin goes round the axis of the wheel {found}"))
}

/// The angle between two vectors in degrees, from 0° to 180°.
fn between(a: &Vector2<f64>, b: &Vector2<f64>) -> f64 {
    Turn { cos: a.dot(b), sin: a.perp(b).abs() }.degrees()
}

/// The dimension of the unit printed with the number in the claim with this id.
pub fn dimension(id: &str) -> Option<Dimension> {
    let mut parts = crate::claim(id)?.unit.split('/').map(|unit| match unit {
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
    use crate::{Erratum, Verdict, judge};

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
