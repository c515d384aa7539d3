//! The accelerations: seven terms, of which two are zero and two are known only in direction.

use super::letters::SIZES;
use super::*;
use geneva_evidence::tex::{Letters, Moment, holds, value};
use geneva_evidence::{equal_to, filled};
use rounding::STEPS;

const PIN_NORMAL: Locator = at("Solution, acceleration, normal of P2");
const PIN_TANGENTIAL: Locator = at("Solution, acceleration, tangential of P2");
const LEVER_NORMAL: Locator = at("Solution, acceleration, normal of P4");
const SLIDING_NORMAL: Locator = at("Solution, acceleration, relative normal");
const SLIDING: Locator = at("Solution, acceleration, relative tangential");
const LEVER_TANGENTIAL: Locator = at("Solution, acceleration, tangential of P4");
const LEVER: Locator = at("Solution, last line");

pub(super) fn claims() -> Vec<Claim> {
    [known(), coriolis::claims(), found()].concat()
}

fn known() -> Vec<Claim> {
    vec![
        frames::acceleration_in_a_frame(),
        given::accelerations(
            at("Solution, acceleration, 2nd line"),
            "quick-return.acceleration-by-points",
            r"a_{P2} = a_{P4} + a_{P2/P4}",
        ),
        given::components_of_all(
            at("Solution, acceleration, 3rd line"),
            "quick-return.seven-terms-by-points",
            concat!(
                r"(a_{P2}^n + a_{P2}^t) = (a_{P4}^n + a_{P4}^t)",
                r" + (a_{P2/P4}^n + a_{P2/P4}^t + 2\omega_4 \times v_{P2/P4})"
            ),
        ),
        frames::acceleration_from_the_lever(),
        PIN_NORMAL
            .equation(
                "quick-return.pin-normal-equation",
                r"A_{P2}^n = \omega_2^2 l_2",
                "centripetal acceleration of the pin",
            )
            .in_letters(SIZES),
        PIN_NORMAL
            .equation(
                "quick-return.square-of-the-rate",
                r"(\ldots)^2(\ldots)",
                "the square of the printed rate times the printed crank gives the printed result",
            )
            .evaluated(Evidence::OTHER_PLACE_IN_SOURCE, |tex| {
                gives("quick-return.pin-normal", tex, ["quick-return.driver-rate", "quick-return.crank"])
            })
            .read(SIZES.evidence, |tex| in_names(tex, "A_{P2}^n", &[r"\omega_2", "l_2"])),
        PIN_NORMAL
            .value("quick-return.pin-normal", "5.492", "m/s^2", "centripetal acceleration of the pin")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.pin_normal.norm()))
            .second_route(Evidence::JET, || series(given::total))
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.driver-rate")
                    * QUICK_RETURN.printed_number("quick-return.driver-rate")
                    * QUICK_RETURN.printed_number("quick-return.crank")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(STEPS),
        PIN_TANGENTIAL
            .equation(
                "quick-return.pin-tangential",
                r"A_{P2}^t = 0 \text{ since } \omega_2 = \text{constant}",
                "the pin has no tangential acceleration while the crank's speed is constant",
            )
            .rewritten_and_proven(SIZES, |tex| tex.replace(r"\text{ since }", ","))
            .with_second_witness(Evidence::JET, || {
                // Along the circle, the polar components of the whole acceleration cancel, and at no other speed.
                let along = |acceleration: f64| {
                    let mut at = LeverProblem::printed().ok()?;
                    at.drive.acceleration = acceleration;
                    let whole = given::components(&at.by_series()?);
                    Some(quarter_turn(&at.arm()).normalize().dot(&whole) / whole.norm())
                };
                at_the_instant(|_| {
                    let [constant, gaining] = [along(0.0)?, along(1.0)?];
                    let holds = vanishes(constant) && !vanishes(gaining);
                    let how = "along the circle the acceleration vanishes while the speed is constant, and only then";
                    Some(Finding::new(holds, how))
                })
            }),
        LEVER_NORMAL
            .equation(
                "quick-return.lever-normal-equation",
                r"A_{P4}^n = \omega_4^2 l_4",
                "centripetal acceleration of the lever's point",
            )
            .in_letters(SIZES)
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                let speed = QUICK_RETURN.printed_number("quick-return.lever-speed");
                let found = speed * speed * QUICK_RETURN.printed_number("quick-return.lever-length");
                let holds = QUICK_RETURN.prints_rounding_of("quick-return.lever-normal", found);
                Finding::new(holds, format!("the printed numbers give {found:.4} m/s²"))
            }),
        LEVER_NORMAL
            .equation(
                "quick-return.square-of-the-speed",
                r"(\ldots)^2(\ldots)",
                "the square of the lever's printed speed times its printed length gives the printed result",
            )
            .evaluated(Evidence::OTHER_PLACE_IN_SOURCE, |tex| {
                gives("quick-return.lever-normal", tex, ["quick-return.lever-speed", "quick-return.lever-length"])
            })
            .read(SIZES.evidence, |tex| in_names(tex, "A_{P4}^n", &[r"\omega_4", "l_4"])),
        LEVER_NORMAL
            .value("quick-return.lever-normal", "0.813", "m/s^2", "centripetal acceleration of the lever's point")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.accelerations.follower_normal.norm()))
            .second_route(Evidence::JET, || {
                series(|rates| rates.angular_velocity * rates.angular_velocity * radius(rates))
            })
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.lever-speed")
                    * QUICK_RETURN.printed_number("quick-return.lever-speed")
                    * QUICK_RETURN.printed_number("quick-return.lever-length")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(STEPS),
        SLIDING_NORMAL
            .equation(
                "quick-return.sliding-normal",
                r"A_{P2/P4}^n = \frac{v_{P2/P4}^2}{R} = 0",
                "there is no relative normal acceleration in a straight slot",
            )
            .evaluated(Evidence::VECTORS, |tex| Finding::of_reading(normal_by_diagrams(tex)))
            .read(Evidence::AUTOMATIC_DERIVATIVE, normal_by_duals),
        SLIDING_NORMAL
            .statement(
                "quick-return.infinite-radius",
                "R is infinite",
                "the radius of the pin's path relative to the lever is infinite, because the path is straight",
            )
            .first_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                from_duals(|crank| {
                    let slot = crank.polar()[1][0];
                    let [_, velocity, acceleration] =
                        path(|t| turned(crank.pin(t), -stated.pick(crank.slot(t) - slot, t * 0.0)));
                    let curvature = velocity.perp(&acceleration) / (velocity.norm() * velocity.norm_squared());
                    let straight = vanishes(curvature * crank.radius);
                    let what = if straight {
                        "has no curvature".into()
                    } else {
                        format!("has a radius of curvature of {:.2} m", curvature.recip())
                    };
                    Finding::new(straight, format!("the path {what}"))
                })
            })
            .second_route(Evidence::VECTORS, |stated| {
                // Three of the pin's places, the second and the third as seen by one who turns with the lever.
                at_the_instant(|at| {
                    let place = |degrees: f64| {
                        let crank = at.position.crank.plus(&Turn::from_degrees(degrees));
                        let here = at.linkage.position_at_crank(&crank).ok()?;
                        let back = here.lever.reversed().plus(&at.position.lever);
                        let seen = stated.pick(back.plus(&here.lever), here.lever);
                        Some(seen.direction() * here.pin_distance)
                    };
                    let [first, second, third] = [place(0.0)?, place(20.0)?, place(40.0)?];
                    let (one, other) = (second - first, third - first);
                    let sine = one.perp(&other) / (one.norm() * other.norm());
                    let bend = if vanishes(sine) { 0.0 } else { arcsine(sine) };
                    Some(Finding::new(
                        vanishes(sine),
                        format!(
                            "three places that are 20° of the crank apart deviate from a straight line by {bend:.1}°"
                        ),
                    ))
                })
            })
            .but_not("the radius of the pin's path relative to the ground is infinite"),
    ]
}

fn found() -> Vec<Claim> {
    vec![
        SLIDING
            .equation(
                "quick-return.sliding-acceleration-equation",
                r"A_{P2/P4}^t = A_{P2}^n \cos \ldots - A_{P4}^n",
                "sliding acceleration, towards the lever's pivot",
            )
            .rewritten_and_proven(SIZES, filled(&[r"\beta"]))
            .interpreted_as(DEGREES),
        SLIDING
            .value(
                "quick-return.sliding-acceleration",
                "2.694",
                "m/s^2",
                "sliding acceleration, towards the lever's pivot",
            )
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.accelerations.sliding_tangential.norm()))
            .second_route(Evidence::JET, || series(|rates| rates.sliding_rate.abs() * radius(rates)))
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.pin-normal")
                    * cosine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"))
                    - QUICK_RETURN.printed_number("quick-return.lever-normal")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(STEPS),
        LEVER_TANGENTIAL
            .equation(
                "quick-return.lever-tangential-equation",
                r"A_{P4}^t = A_{P2}^n \sin \ldots - 2\omega_4 v_{P2/P4}",
                "tangential acceleration of the lever's point, in the sense of the pin's acceleration across the \
                 lever",
            )
            .rewritten_and_proven(SIZES, filled(&[r"\beta"]))
            .interpreted_as(DEGREES),
        LEVER_TANGENTIAL
            .value("quick-return.lever-tangential", "2.266", "m/s^2", "tangential acceleration of the lever's point")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.accelerations.follower_tangential.norm()))
            .second_route(Evidence::JET, || series(|rates| rates.angular_acceleration.abs() * radius(rates)))
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.pin-normal")
                    * sine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"))
                    - QUICK_RETURN.printed_number("quick-return.coriolis")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(STEPS),
        LEVER
            .equation(
                "quick-return.lever-acceleration-equation",
                r"A_{P4}^t = \alpha_4 l_4",
                "tangential acceleration and angular acceleration of the lever",
            )
            .in_letters(SIZES)
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                let found = QUICK_RETURN.printed_number("quick-return.lever-acceleration")
                    * QUICK_RETURN.printed_number("quick-return.lever-length");
                let holds = QUICK_RETURN.prints_rounding_of("quick-return.lever-tangential", found);
                Finding::new(holds, format!("the printed numbers give {found:.3} m/s²"))
            }),
        LEVER
            .value("quick-return.lever-acceleration", "4.12", "rad/s^2", "angular acceleration of the lever")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.accelerations.follower_acceleration.abs()))
            .second_route(Evidence::JET, || series(|rates| rates.angular_acceleration.abs()))
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.lever-tangential")
                    / QUICK_RETURN.printed_number("quick-return.lever-length")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(STEPS),
        LEVER
            .statement(
                "quick-return.lever-acceleration-sense",
                r"\alpha_4",
                "the sense of the lever's angular acceleration, of which only the magnitude is given",
            )
            .missing(
                "The source gives magnitudes only. In the given position the lever slows down if the pin slides \
                 inwards. In the mirror image, which has the same printed numbers, the pin slides outwards and the \
                 lever speeds up",
            ),
    ]
}

/// How we read the equations whose angle is printed without a unit.
const DEGREES: &str = "The angle is printed without a unit here, so we take it in degrees, as where it was found.";

/// Whether a formula with dots rounds to the number printed in the claim with the first id, with the printed numbers of the
/// other claims at its dots.
pub(super) fn gives(id: &str, tex: &str, of: [&str; 2]) -> Finding {
    let letters: Letters = ["a", "b"]
        .into_iter()
        .zip(of.map(|id| QUICK_RETURN.printed_number(id)))
        .map(|(name, of)| (name.into(), of))
        .collect();
    let number = value(&filled(&["a", "b"])(tex), &letters);
    if number.is_nan() {
        return Finding::of_reading(None);
    }
    Finding::new(QUICK_RETURN.prints_rounding_of(id, number), format!("the printed numbers give {number:.4}"))
}

/// Whether a formula with dots equals a letter, with these letters at its dots.
pub(super) fn in_names(tex: &str, side: &'static str, names: &'static [&'static str]) -> Option<bool> {
    holds(&equal_to(side)(&filled(names)(tex)), (SIZES.numbers)())
}

/// The letters of the normal component, at one instant.
fn normal(normal: f64, speed: f64, radius: f64) -> [Moment; 1] {
    [Moment::default().with([("A_{P2/P4}^n", normal), ("v_{P2/P4}", speed), ("R", radius)])]
}

/// Whether a display of the normal component holds by vectors: in the slot, and but for its last side on circles.
fn normal_by_diagrams(tex: &str) -> Option<bool> {
    let (chain, _) = tex.rsplit_once('=')?;
    // A point on a circle, by its coordinates: the component of its acceleration towards the centre.
    let curved = |radius: f64| {
        let (place, speed, angular_acceleration) = (Turn::from_degrees(40.0).direction() * radius, 1.7, -2.3);
        let velocity = quarter_turn(&place) * speed;
        let acceleration = quarter_turn(&velocity) * speed + quarter_turn(&place) * angular_acceleration;
        holds(chain, &normal(-place.normalize().dot(&acceleration), velocity.norm(), radius))
    };
    let motion = LeverProblem::printed().ok()?.by_diagrams()?;
    let slot = LeverProblem::printed().ok()?.position.lever.direction();
    let across = slot.perp(&motion.accelerations.sliding_tangential);
    let straight = holds(tex, &normal(across, motion.velocities.sliding_velocity.norm(), f64::INFINITY));
    Some(curved(0.6)? && curved(3.0)? && straight?)
}

/// Whether it holds by the paths of pins: of one on a crank about the pivot, and of the pin as the lever sees it.
fn normal_by_duals(tex: &str) -> Option<bool> {
    let (chain, _) = tex.rsplit_once('=')?;
    let on = |tex: &str, [_, velocity, acceleration]: [Vector2<f64>; 3], radius: f64| {
        holds(tex, &normal(velocity.perp(&acceleration) / velocity.norm(), velocity.norm(), radius))
    };
    let curved = |radius: f64| {
        on(chain, Crank { ground: 0.0, radius, angle: 0.4, speed: 2.3, acceleration: 1.9 }.pin_motion(), radius)
    };
    let crank = LeverProblem::printed().ok()?.by_duals();
    let slot = crank.polar()[1][0];
    let seen = path(|t| turned(crank.pin(t), -(crank.slot(t) - slot)));
    Some(curved(0.7)? && curved(2.5)? && on(tex, seen, f64::INFINITY)?)
}
