//! The equations of the moving frame: what locates what, and how the rates of a vector in the frame are counted.

use super::*;
use crate::claim;
use geneva_kinematics::prove;
use geneva_kinematics::quick_return::frame_proofs::{AccelerationInAFrame, Brackets, VelocityInAFrame};
use geneva_kinematics::quick_return::proofs::{Compared, DiagramAgainstSeries};
use nalgebra::Vector2;

const PLACES: &str = "Solution, position, vectors";
const VELOCITY: &str = "Solution, velocity, 1st line";
const NAMES: &str = "Solution, velocity, 2nd line";
const ADVICE: &str = "Solution, velocity, remark";

pub fn claims() -> Vec<Claim> {
    [places(), rates()].concat()
}

fn places() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "quick-return.letter-r",
            PLACES,
            "the letter r names the vector to the pin",
            "r",
            Check::corrected_equation(
                (OtherPlaceInSource, || {
                    let length =
                        claim("quick-return.projections").is_some_and(|claim| claim.printed.starts_with("r ="));
                    Finding::new(!length, "the letter r is the length of the lever too, two lines before")
                }),
                || Finding::new(symbols::ours_are_unambiguous(), "each of the book's symbols stands for one thing"),
                (Vectors, || {
                    // The rate of the length and the length of the rate.
                    let (length, vector) = (
                        series(|rates| (rates.sliding * radius(rates)).abs()),
                        diagram(|motion| motion.velocities.pin_velocity.norm()),
                    );
                    Finding::new(
                        !agrees(length, vector),
                        format!("the length changes at {length:.3} m/s, the vector at {vector:.3} m/s"),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\vec{r}",
            slip: Slip {
                id: "",
                reason: "One letter stands for the lever's length and for the vector to the pin. \
                    A dot over it then means two different rates.",
                witness: "The rate of the length and the length of the rate are different numbers.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::statement(
            WORK,
            "quick-return.frame",
            PLACES,
            "the frame's origin is the lever's point under the pin",
            "oxy",
            Check::equation(
                (Vectors, || {
                    let speed = diagram(|motion| motion.velocities.slot_point_velocity.norm());
                    same(
                        speed,
                        diagram(|motion| (motion.velocities.follower_speed * motion.velocities.position.norm()).abs()),
                    )
                }),
                (Series, || {
                    let origin = series(|rates| rates.turning * radius(rates));
                    same(origin, diagram(|motion| motion.velocities.slot_point_velocity.norm()))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.p-is-zero",
            PLACES,
            "the pin is at the frame's origin at this instant, and does not stay \
                there",
            "p = 0",
            Check::equation(
                (Vectors, || {
                    let offset = diagram(|motion| {
                        motion.velocities.position.perp(&motion.velocities.slot_point_velocity)
                            - motion.velocities.position.norm() * motion.velocities.slot_point_velocity.norm()
                    });
                    Finding::new(vanishes(offset), "the point under the pin is as far from the pivot as the pin")
                }),
                (Series, || {
                    let sliding = series(|rates| rates.sliding * radius(rates));
                    Finding::new(sliding != 0.0, format!("and leaves it at {:.3} m/s", sliding.abs()))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.sum-of-places",
            PLACES,
            "place of the pin: that of the frame's origin and that in the frame",
            "r = R + p",
            Check::equation(
                (ExactIdentity, || velocity_in_a_frame(true)),
                (ExactIdentity, || velocity_in_a_frame(false)),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.sum-of-places-by-points",
            PLACES,
            "the same by the names of the points",
            r"r_{P2} = r_{P4} + r_{P2/P4}",
            Check::equation(
                (Vectors, || {
                    same(
                        position_of(|position| position.pin_distance),
                        diagram(|motion| motion.velocities.position.norm()),
                    )
                }),
                (Series, || same(series(radius), diagram(|motion| motion.velocities.position.norm()))),
            ),
        ),
    ]
}

fn rates() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "quick-return.velocity-in-a-frame",
            VELOCITY,
            "velocity of a point given in a turning frame",
            r"\dot{r} = \dot{R} + \dot{p} + \omega \times p",
            Check::equation(
                (ExactIdentity, || velocity_in_a_frame(true)),
                (ExactIdentity, || velocity_in_a_frame(false)),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.velocity-by-points",
            NAMES,
            "with p = 0 the last term goes, and the relative velocity is that seen in the frame",
            r"v_{P2} = v_{P4} + v_{P2/P4} = \dot{R} + \dot{p}",
            Check::equation(
                (ExactIdentity, || prove(&DiagramAgainstSeries(Compared::LeverSpeed)).into()),
                (ExactIdentity, || prove(&DiagramAgainstSeries(Compared::Sliding)).into()),
            ),
        ),
        Claim::statement(
            WORK,
            "quick-return.seen-from-the-lever",
            ADVICE,
            "the relative velocity is what one sees who holds the lever still: along the slot",
            "P2 moving, P4 fixed",
            Check::equation(
                (Vectors, || {
                    let across = diagram(|motion| motion.velocities.sliding_velocity.perp(&motion.velocities.position));
                    Finding::new(vanishes(across), "nothing of it is across the lever")
                }),
                (Series, || {
                    same(
                        series(|rates| (rates.sliding * radius(rates)).abs()),
                        diagram(|motion| motion.velocities.sliding_velocity.norm()),
                    )
                }),
            ),
        ),
    ]
}

/// The acceleration of a point given in a turning frame, printed without brackets.
pub fn acceleration_in_a_frame() -> Claim {
    Claim::equation(WORK, "quick-return.acceleration-in-a-frame", "Solution, acceleration, 1st line", "acceleration of a point given in a turning frame",
        r"\ddot{r} = \ddot{R} + \ddot{p} + \omega \times \omega \times p + \dot{\omega} \times p + 2\omega \times \dot{p}",
        Check::corrected_equation(
            (ExactIdentity, || prove(&AccelerationInAFrame { first: true, brackets: Brackets::FromTheLeft, coriolis: 2 }).into()),
            || prove(&AccelerationInAFrame { first: true, brackets: Brackets::FromTheRight, coriolis: 2 }).into(),
            (LimitCase, at_rest_in_a_turning_frame),
        ),
    )
    .expecting(Verdict::Corrected)
    .with_erratum(Erratum { corrected: r"\ddot{r} = \ddot{R} + \ddot{p} + \omega \times (\omega \times p) + \dot{\omega} \times p + 2\omega \times \dot{p}", slip: Slip {
 id: "",
reason: "A double cross product needs brackets. Read from left to right, ω × ω is zero and the term \
                    is lost. Here p = 0, and nothing comes of it.",
witness: "A point at rest in a frame that turns steadily is accelerated towards the centre: three of \
                    its places, a short time apart, say so.",
origin: Origin::Misprint,
consequence: Consequence::Derivation,
changes: "",
} })
}

/// The acceleration of a point at distance 1 in a frame that turns at 1 rad/s, from three of its places.
fn at_rest_in_a_turning_frame() -> Finding {
    let inwards = -second_difference(|time| Turn::from_radians(time).direction()).x;
    Finding::new((inwards - 1.0).abs() < STEP, format!("towards the centre {inwards:.4}, and not 0, in units of ω² p"))
}

/// A short time, in seconds at 1 rad/s: small enough to see the first digits, large enough for rounding not to show.
const STEP: f64 = 1e-3;

/// The acceleration at time zero from three places.
pub fn second_difference(place: impl Fn(f64) -> Vector2<f64>) -> Vector2<f64> {
    (place(STEP) - place(0.0) * 2.0 + place(-STEP)) / (STEP * STEP)
}

/// The acceleration across a lever that turns at 1 rad/s, of a bead that slides outwards at 1 m/s, from three places.
pub fn coriolis_by_finite_turns() -> Finding {
    let across = second_difference(|time| Turn::from_radians(time).direction() * (1.0 + time)).y;
    Finding::new(
        (across - 2.0).abs() < STEP,
        format!("a bead on a turning lever: {across:.4} times ω v, from three places"),
    )
}

fn velocity_in_a_frame(first: bool) -> Finding {
    prove(&VelocityInAFrame { first }).into()
}
