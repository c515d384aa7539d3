//! Letters and arrows: what the copy made of them, and what they stand for.
//!
//! Greek letters have become Latin ones, and arrows have become letters. A letter, with its index if it has one, names one
//! thing in all its places; then nothing is wrong with it, and the claim says what it names. An arrow cannot be told from
//! the letter that stands for it, and what its angle is measured from is lost.

use super::*;

/// Letters where arrows are needed.
pub const ARROWS: Slip = Slip {
    id: "pin.mark-f",
    reason: "The copy has the letters d, f and i for arrows. With the arrows before the velocities it is lost what \
             their angles count from: two of them from the horizontal to the left, that of the slot's point from the \
             vertical. Which way the arrows pointed cannot be told without the drawing.",
    witness: "The angles of the crank and of the slot alone give the same directions.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

pub fn letter_v() -> Claim {
    at("Problem, 1st paragraph")
        .statement(
            "pin.letter-v",
            "V_D",
            "the letter V or v (ω, it seems) with the index of a disk names its angular velocity, here that of the driver",
        )
        .by(Evidence::Dimension, |stated| {
            // As an angular velocity, or as what the letter v names with the index of a point: a speed.
            let named = stated.pick(Some(Dimension::ANGULAR_SPEED), dimension("pin.pin-speed"));
            let printed = dimension("pin.driver-speed");
            let words = |dimension: Option<Dimension>| dimension.map_or("unknown".into(), |d| d.to_string());
            Finding::new(
                printed.is_some() && printed == named,
                format!("the printed unit is {}, the letter stands for {}", words(printed), words(named)),
            )
        })
        .by(Jet, |stated| {
            at_the_instant(|instant, motion| {
                let crank = motion.position - instant.axis();
                let turning = crank.perp(&motion.pin_velocity) / crank.norm_squared();
                let named = stated.pick(turning, motion.pin_velocity.norm());
                Finding::new(rounds("pin.driver-speed", named), format!("what the letter stands for is {named:.1}"))
            })
        })
        .but_not("it names a speed, as with the index of a point")
}

pub fn letter_f() -> Claim {
    at("Problem, 2nd paragraph")
        .statement("pin.letter-f", "f", "the letter f (φ, it seems) names the angle of the crank from the direction OB")
        .by(Jet, |stated| {
            at_the_instant(|instant, motion| {
                let crank = heading(&(motion.position - instant.axis()));
                the_crank_angle(stated.pick(crank, 180.0 - crank))
            })
        })
        .by(OtherPlaceInSource, |stated| {
            let corner = printed("pin.angle-at-driver");
            the_crank_angle(stated.pick(180.0 - corner, corner))
        })
        .but_not("it names the angle of the triangle at B")
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
            "the letter b (β, it seems) names the angle of the triangle at O, opposite to the crank; the text does not \
             say so",
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
                format!("the side opposite is {side:.1} mm; the printed r and b want {least:.1} to {most:.1} mm"),
            )
        })
        .but_not("it names the angle at P, opposite to the line of centres")
}

pub fn letter_g() -> Claim {
    at("Solution, angle in the velocity triangle")
        .statement(
            "pin.letter-g",
            "g",
            "the letter g (γ, it seems) names the angle between the pin's velocity and the slot; the text does not say \
             so",
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
                format!("by the printed speeds the angle opposite to that side is {angle:.2}°"),
            )
        })
        .but_not("it names the angle between the pin's velocity and that of the slot's point")
}

pub fn mark_d() -> Claim {
    at("Solution, velocity of the pin")
        .statement(
            "pin.mark-d",
            "d",
            "the arrow before the angles of the pin's velocity and of its sliding velocity, which says what they are \
             measured from",
        )
        .by(Jet, |stated| {
            at_the_instant(|_, motion| {
                arrow_of_two([heading(&motion.pin_velocity), heading(&motion.sliding_velocity)], stated)
            })
        })
        .by(ClosedForm, |stated| {
            // Across the crank, and from the pin to O.
            let slot = triangle(|t| t.angle_at_pivot).to_degrees();
            arrow_of_two([printed("pin.crank-angle") + 90.0, slot + 180.0], stated)
        })
        .corrected("an arrow; the angles are from the horizontal to the left", ARROWS)
}

/// Whether both velocities point as printed if the arrow is ↙ and the angles from the left; or without an arrow.
fn arrow_of_two([pin, sliding]: [f64; 2], stated: Stated) -> Finding {
    let from = stated.pick(180.0, 0.0);
    let angles = [pin - from, sliding - from];
    let holds = rounds("pin.pin-velocity-direction", angles[0]) && rounds("pin.sliding-velocity-direction", angles[1]);
    Finding::new(holds, format!("{:.1}° and {:.1}° beyond {from}° from the right", angles[0], angles[1]))
}

pub fn mark_f() -> Claim {
    at("Solution, components of the velocity")
        .statement(
            "pin.mark-f",
            "f",
            "the arrow before the angle of the slot point's velocity, which says what the angle is measured from",
        )
        .by(Jet, |stated| at_the_instant(|_, motion| arrow_of_one(heading(&motion.slot_point_velocity), stated)))
        .by(ClosedForm, |stated| {
            // Across the slot, clockwise about O.
            arrow_of_one(270.0 + triangle(|t| t.angle_at_pivot).to_degrees(), stated)
        })
        .corrected("an arrow; the angle is from the vertical", ARROWS)
}

/// Whether the velocity points as printed if the arrow is ↘ and the angle from the vertical; or without an arrow.
fn arrow_of_one(direction: f64, stated: Stated) -> Finding {
    let from = stated.pick(270.0, 0.0);
    let angle = direction - from;
    Finding::new(
        rounds("pin.slot-point-velocity-direction", angle),
        format!("{angle:.1}° beyond {from}° from the right"),
    )
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
