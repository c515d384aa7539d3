//! The equations of the moving frame: how the rates of a vector in the frame are counted, and who sees them.

use super::letters::{AT_THE_ORIGIN, FRAME};
use super::*;

const VELOCITY: Locator = at("Solution, velocity, 1st line");
const NAMES: Locator = at("Solution, velocity, 2nd line");
const ADVICE: Locator = at("Solution, velocity, remark");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        VELOCITY
            .equation(
                "quick-return.velocity-in-a-frame",
                r"\dot{r} = \dot{R} + \dot{p} + \omega \times p",
                "velocity of a point given in a turning frame",
            )
            .in_letters(FRAME),
        NAMES
            .equation(
                "quick-return.velocity-by-points",
                r"v_{P2} = v_{P4} + v_{P2/P4} = \dot{R} + \dot{p}",
                "with p = 0 the last term vanishes, and the relative velocity is the velocity seen in the frame",
            )
            .in_letters(AT_THE_ORIGIN),
        ADVICE
            .statement(
                "quick-return.seen-from-the-lever",
                "P2 moving, P4 fixed",
                "the relative velocity is the pin's velocity as seen by an observer who holds the lever still",
            )
            .first_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                from_duals(|crank| {
                    let ([_, pin, _], [_, lever, _]) = (crank.pin_motion(), crank.point_motion());
                    alike(&pin, &(lever + seen(crank, stated)[1]))
                })
            })
            .second_route(Evidence::VECTORS, |stated| {
                at_the_instant(|instant| {
                    let (motion, rates) = (instant.by_diagrams()?.velocities, instant.by_series()?);
                    let both = [motion.pin_velocity, motion.slot_point_velocity];
                    let [moving, fixed] = stated.pick(both, [both[1], both[0]]);
                    Some(alike(&(moving - fixed), &(rates.position * rates.sliding)))
                })
            })
            .but_not("think of P4 moving and of P2, on the crank, as fixed"),
    ]
}

/// The acceleration of a point given in a turning frame, printed without brackets.
pub(super) fn acceleration_in_a_frame() -> Claim {
    at("Solution, acceleration, 1st line")
        .equation(
            "quick-return.acceleration-in-a-frame",
            concat!(
                r"\ddot{r} = \ddot{R} + \ddot{p} + \omega \times \omega \times p",
                r" + \dot{\omega} \times p + 2\omega \times \dot{p}"
            ),
            "acceleration of a point given in a turning frame",
        )
        .in_letters(FRAME)
        .interpreted_as(
            "The double product has no brackets, and we read it from the right, as ω × (ω × p). Read from the left it \
             would be zero for every motion, so there would be no reason to write it.",
        )
}

/// The advice for the accelerations.
pub(super) fn acceleration_from_the_lever() -> Claim {
    at("Solution, acceleration, remark")
        .statement(
            "quick-return.acceleration-from-the-lever",
            "P2 moving, P4 fixed",
            "the normal and tangential relative accelerations are the pin's accelerations as seen by an observer who \
             holds the lever still, and the Coriolis term is added to them",
        )
        .first_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            from_duals(|crank| {
                let ([_, _, pin], [_, _, lever]) = (crank.pin_motion(), crank.point_motion());
                let [_, velocity, acceleration] = seen(crank, stated);
                let coriolis = quarter_turn(&velocity) * (2.0 * crank.polar()[1][1]);
                alike(&pin, &(lever + acceleration + coriolis))
            })
        })
        .second_route(Evidence::VECTORS, |stated| {
            at_the_instant(|instant| {
                let (motion, rates) = (instant.by_diagrams()?, instant.by_series()?);
                let (velocities, terms) = (&motion.velocities, &motion.accelerations);
                let pin = [velocities.pin_velocity, motion.pin_normal + motion.pin_tangential];
                let lever = [velocities.slot_point_velocity, terms.follower_normal + terms.follower_tangential];
                let [moving, fixed] = stated.pick([pin, lever], [lever, pin]);
                let turning = stated.pick(velocities.follower_speed, instant.drive.speed);
                // What is left without the Coriolis term of a frame on the fixed link.
                let left = moving[1] - fixed[1] - quarter_turn(&(moving[0] - fixed[0])) * (2.0 * turning);
                Some(alike(&left, &(rates.position * rates.sliding_rate)))
            })
        })
        .but_not("think of P4 moving and of P2, on the crank, as fixed")
        .interpreted_as(
            "We take this to be about the normal and the tangential term, which follow the remark. The whole a(P2/P4) \
             of the equation contains the Coriolis term. It is 3.326 m/s², as seen by an observer who moves with P4 \
             without turning. An observer on the lever sees 2.689 m/s².",
        )
}

/// Place, velocity and acceleration of the pin as seen from the lever; or of the lever's point as seen from the crank.
pub(super) fn seen(crank: &Crank, stated: Stated) -> [Vector2<f64>; 3] {
    let slot = crank.polar()[1][0];
    path(|t| {
        let [x, y] = stated.pick(crank.pin(t), crank.point_under_the_pin(t));
        let angle = stated.pick(crank.slot(t) - slot, advance(crank.speed, crank.acceleration, t));
        // The crank turns about its own axis.
        turned([x - stated.pick(0.0, crank.ground), y], -angle)
    })
}

/// The direction of the slot, from the lever's pivot.
pub(super) fn along_the_slot(crank: &Crank) -> Vector2<f64> {
    Turn::from_radians(crank.polar()[1][0]).direction()
}
