//! The Coriolis term: how large it is, which way it points, and what the text says of its factors.

use super::letters::SIZES;
use super::*;
use geneva_evidence::equal_to;

const CORIOLIS: Locator = at("Solution, acceleration, Coriolis");
const SENSE: Locator = at("Solution, acceleration, direction of Coriolis");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        CORIOLIS
            .equation(
                "quick-return.coriolis-equation",
                r"2\omega_4 v_{P2/P4}",
                "magnitude of the Coriolis acceleration, whose factors are at right angles",
            )
            .rewritten_and_proven(SIZES, equal_to(r"a_\mathrm{Cor}")),
        CORIOLIS
            .equation(
                "quick-return.factor-two",
                r"2(\ldots)(\ldots)",
                "twice the lever's printed speed times the printed sliding speed gives the printed result",
            )
            .evaluated(Evidence::OTHER_PLACE_IN_SOURCE, |tex| {
                let of = ["quick-return.lever-speed", "quick-return.sliding-speed"];
                acceleration::gives("quick-return.coriolis", tex, of)
            })
            .read(SIZES.evidence, |tex| acceleration::in_names(tex, r"a_\mathrm{Cor}", &[r"\omega_4", "v_{P2/P4}"])),
        CORIOLIS
            .value("quick-return.coriolis", "1.960", "m/s^2", "magnitude of the Coriolis acceleration")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.accelerations.coriolis.norm()))
            .second_route(Evidence::JET, || {
                series(|rates| 2.0 * (rates.angular_velocity * rates.sliding).abs() * radius(rates))
            })
            .rounded(|| {
                2.0 * QUICK_RETURN.printed_number("quick-return.lever-speed")
                    * QUICK_RETURN.printed_number("quick-return.sliding-speed")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(rounding::STEPS),
        SENSE
            .statement(
                "quick-return.coriolis-direction",
                r"\omega_4 \times v_{P2/P4}",
                "the Coriolis acceleration has the direction of this product, although the text does not say which \
                 direction that is",
            )
            .first_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                in_both_drawings(|instant| {
                    let crank = instant.by_duals();
                    let [[_, sliding, _], [_, turning, _]] = crank.polar();
                    let product = product(turning, frames::along_the_slot(&crank) * sliding, stated);
                    let part = term(&crank).normalize().dot(&product.normalize());
                    Some(Finding::new(
                        agrees(part, 1.0),
                        format!("its part in that direction is {part:.3} of the whole"),
                    ))
                })
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let bead = across_by_finite_turns();
                let product = product(1.0, Vector2::new(1.0, 0.0), stated);
                let how =
                    format!("a bead that slides outwards gives {bead:.4}, and the product gives {:.0}", product.y);
                Finding::new(bead * product.y > 0.0, how)
            })
            .but_not("it has the direction of the product with its factors exchanged"),
        SENSE
            .statement("quick-return.lever-sense", "out of the page", "the lever turns counter-clockwise")
            .first_route(Evidence::VECTORS, |stated| {
                in_both_drawings(|instant| Some(points(instant.by_diagrams()?.velocities.follower_speed, stated)))
            })
            .second_route(Evidence::JET, |stated| {
                in_both_drawings(|instant| Some(points(instant.by_series()?.angular_velocity, stated)))
            })
            .but_not("the lever turns clockwise"),
        SENSE
            .statement(
                "quick-return.sense-of-sliding",
                "as in velocity diagram",
                "the sense of the sliding velocity, as in the velocity diagram",
            )
            .missing(
                "The copy we had does not include the diagram. Suppose that the crank turns counter-clockwise. If the \
                 pin has passed the line of centres, it slides towards the lever's pivot. In the mirror image, which \
                 has the same printed numbers, the pin has yet to reach this line, and it slides away from the pivot. \
                 The sense of the Coriolis acceleration depends on the sense of the sliding",
            ),
    ]
}

/// ω × v for an angular velocity, counter-clockwise positive; or v × ω.
fn product(turning: f64, velocity: Vector2<f64>, stated: Stated) -> Vector2<f64> {
    let [x, y] = [velocity.x * turning, velocity.y * turning];
    stated.pick(Vector2::new(-y, x), Vector2::new(y, -x))
}

/// Whether an angular velocity, counter-clockwise positive, points out of the page; or into it.
fn points(speed: f64, stated: Stated) -> Finding {
    let axis = stated.pick(1.0, -1.0);
    Finding::new(speed * axis > 0.0, format!("the angular velocity is {speed:.3} rad/s, counter-clockwise positive"))
}

/// What the pin's acceleration contains beside the acceleration of the lever's point and the one seen from the lever.
fn term(crank: &Crank) -> Vector2<f64> {
    let ([_, _, pin], [_, _, lever]) = (crank.pin_motion(), crank.point_motion());
    pin - lever - frames::seen(crank, Stated::right(""))[2]
}

/// A short time, in seconds at 1 rad/s: small enough to see the first digits, large enough for rounding not to show.
const STEP: f64 = 1e-3;

/// The acceleration across a lever that turns at 1 rad/s, of a bead that slides outwards at 1 m/s, from three places.
fn across_by_finite_turns() -> f64 {
    let place = |time: f64| Turn::from_radians(time).direction() * (1.0 + time);
    ((place(STEP) - place(0.0) * 2.0 + place(-STEP)) / (STEP * STEP)).y
}
