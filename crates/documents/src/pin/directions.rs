//! Which way the two parts of the pin's velocity point.

use super::*;
use geneva_kinematics::{Expression, Identity, prove};

const TRIANGLE: Locator = at("Solution, velocity triangle");

pub(super) fn across_the_slot() -> Claim {
    TRIANGLE
        .statement("pin.across-the-slot", "perpendicular", "the slot's point under the pin moves across OP")
        .first_route(Evidence::EXACT_IDENTITY, |stated| prove(&Across(stated)).into())
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            // What moves across a line from a fixed point keeps its distance from that point.
            from_duals(|crank| {
                let [place, velocity, _] = path(|t| {
                    let [x, y] = crank.point_under_the_pin(t);
                    [x - stated.pick(0.0, crank.ground), y]
                });
                let rate = place.dot(&velocity) / place.norm();
                let kept = vanishes(rate / velocity.norm());
                let rate = if kept { 0.0 } else { rate };
                Finding::new(kept, format!("its distance from the centre changes at {rate:.0} mm/s"))
            })
        })
        .but_not("it moves across the crank, BP")
}

pub(super) fn along_the_slot() -> Claim {
    TRIANGLE
        .statement("pin.along-the-slot", "along the slot", "the pin moves along the slot as seen from the wheel")
        .first_route(Evidence::EXACT_IDENTITY, |stated| prove(&Along(stated)).into())
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            from_duals(|crank| {
                let [_, [slot, ..]] = crank.polar();
                // The pin's places in a frame that turns with the slot from this instant on.
                let [_, seen, _] = path(|t| turned(crank.pin(t), -(crank.slot(t) - slot)));
                let line = Turn::from_radians(stated.pick(slot, crank.angle)).direction();
                let part = line.perp(&seen) / seen.norm();
                let along = vanishes(part);
                let angle = if along { 0.0 } else { libm::asin(part.abs()).to_degrees() };
                Finding::new(along, format!("the velocity as seen from the wheel makes {angle:.1}° with that line"))
            })
        })
        .but_not("it moves along the crank, as seen from the wheel")
}

pub(super) fn velocity_figure() -> Claim {
    TRIANGLE
        .figure(
            "pin.velocity-figure",
            "triangle",
            "the velocity triangle has its right angle between the velocity of the slot's point and the sliding \
             velocity",
        )
        .first_route(Evidence::JET, |stated| {
            at_the_instant(|_, motion| {
                let side = stated.pick(motion.slot_point_velocity, motion.pin_velocity);
                let cosine = side.normalize().dot(&motion.sliding_velocity.normalize());
                let angle = libm::acos(cosine).to_degrees();
                Finding::new(vanishes(cosine), format!("the angle between the two velocities is {angle:.1}°"))
            })
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            // Pythagoras with the printed speeds, each somewhere within its digits.
            let ids = ["pin.slot-point-speed", "pin.pin-speed"];
            let [side, longest] = stated.pick(ids, [ids[1], ids[0]]).map(|id| PIN.printed_interval(id));
            let sliding = PIN.printed_interval("pin.sliding-speed");
            let squares = |at: usize| side[at] * side[at] + sliding[at] * sliding[at];
            let [least, most] = [squares(0).sqrt(), squares(1).sqrt()];
            Finding::new(
                least < longest[1] && longest[0] < most,
                format!(
                    "the two printed legs need a longest side of {least:.1} to {most:.1} mm/s, and it is {:.1} mm/s",
                    longest[0].midpoint(longest[1])
                ),
            )
        })
        .but_not("it has its right angle between the pin's velocity and the sliding velocity")
}

/// Whether the slot's point moves across OP, or across BP. Variables as in the formula crate: p, q, l, ω.
struct Across<'a>(Stated<'a>);

impl Identity<4> for Across<'_> {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        moving(variables, |motion, crank| motion.slot_point_velocity.dot(&self.0.pick(motion.position, crank)))
    }
}

/// Whether the sliding velocity is along OP, or along BP. The variables are the same as in [`Across`].
struct Along<'a>(Stated<'a>);

impl Identity<4> for Along<'_> {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        moving(variables, |motion, crank| motion.sliding_velocity.perp(&self.0.pick(motion.position, crank)))
    }
}

/// A part of the motion, with the crank (p, q) at the centre distance l and the angular velocity ω.
fn moving(
    [p, q, distance, driver]: [Expression; 4],
    of: impl Fn(PinMotion<Expression>, Vector2<Expression>) -> Expression,
) -> Expression {
    let crank = Turn { cos: p, sin: q };
    // One, which refutes, on the pivot.
    pin_vectors::solve(&Expression::ONE, &distance, &crank, &driver)
        .map_or(Expression::ONE, |motion| of(motion, crank.direction()))
}
