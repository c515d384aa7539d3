//! What the problem gives and asks.

use super::*;
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::prove;
use geneva_kinematics::quick_return::proofs::{Compared, DiagramAgainstSeries, TermsOfTheAcceleration};
use nalgebra::Vector2;

const DATA: &str = "Problem, 1st paragraph";
const VELOCITY: &str = "Problem, part (a), equation";
const ACCELERATION: &str = "Problem, part (b), 1st equation";
const TERMS: &str = "Problem, part (b), 2nd equation";
const QUESTION: &str = "Problem, part (b), question";
const DRAWING: &str = "Figure 7";

pub fn claims() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "quick-return.driver-sense",
            DATA,
            "the crank turns counter-clockwise",
            "counter-clockwise",
            Check::equation(
                (Vectors, || {
                    let speed = diagram(|motion| motion.velocities.follower_speed);
                    Finding::new(
                        speed > 0.0,
                        format!(
                            "then the lever turns counter-clockwise too, at {speed:.3} rad/s: out of \
                                    the page, as the solution says"
                        ),
                    )
                }),
                (Series, || {
                    let speed = clockwise().map_or(f64::NAN, |rates| rates.turning);
                    Finding::new(
                        speed < 0.0,
                        format!(
                            "a crank that turns clockwise would turn it into the page, at {speed:.3} \
                                rad/s"
                        ),
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.driver-speed",
            DATA,
            "speed of the crank, a datum; the solution's rate in rad/s gives it back",
            ("50", "r.p.m."),
            Check::number(
                (OtherPlaceInSource, || printed("quick-return.driver-rate") * 30.0 / PI),
                (OtherPlaceInSource, || printed("quick-return.pin-speed") / printed("quick-return.crank") * 30.0 / PI),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.velocity-equation",
            VELOCITY,
            "velocity of the pin: that of the lever's point under it and that relative to the lever",
            r"v_{P_2} = v_{P_4} + v_{P_2P_4}",
            Check::equation(
                (ExactIdentity, || prove(&DiagramAgainstSeries(Compared::Sliding)).into()),
                (Vectors, || {
                    closes(diagram(|motion| motion.velocity_gap().norm() / motion.velocities.pin_velocity.norm()))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.acceleration-equation",
            ACCELERATION,
            "acceleration of the pin: that of the lever's point and the rest, seen without turning",
            r"a_{P_2} = a_{P_4} + a_{P_2P_4}",
            Check::equation(
                (Vectors, || closes(diagram(|motion| motion.acceleration_gap().norm() / motion.pin_normal.norm()))),
                (Series, || same(series(total), diagram(|motion| (motion.pin_normal + motion.pin_tangential).norm()))),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.seven-terms",
            TERMS,
            "the same by normal, tangential and Coriolis components",
            r"(a_{P_2}^n + a_{P_2}^t) = (a_{P_4}^n + a_{P_4}^t) + (a_{P_2P_4}^n + a_{P_2P_4}^t + 2\omega_4 \times v_{P_2P_4})",
            Check::equation(
                (ExactIdentity, || prove(&TermsOfTheAcceleration { coriolis: 2 }).into()),
                (LimitCase, frames::coriolis_by_finite_turns),
            ),
        ),
        Claim::statement(
            WORK,
            "quick-return.seven",
            QUESTION,
            "the equation has seven terms, two of which are zero at constant speed and in a straight slot",
            "seven",
            Check::equation(
                (Vectors, || {
                    let zero = terms().iter().filter(|term| term.is_some_and(|norm| norm == 0.0)).count();
                    Finding::new(
                        terms().len() == 7 && zero == 2,
                        format!("{} terms, {zero} of them zero", terms().len()),
                    )
                }),
                (OtherPlaceInSource, || {
                    let terms = crate::claim("quick-return.seven-terms")
                        .map_or(0, |claim| claim.printed.matches("^").count() + claim.printed.matches("times").count());
                    Finding::new(terms == 7, format!("{terms} terms stand in the equation"))
                }),
            ),
        ),
        Claim::figure(
            WORK,
            "quick-return.figure",
            DRAWING,
            "the drawing of the mechanism, with its lengths and its angle",
            "Figure",
            Check::Missing {
                reason: "The drawing is not in the copy. Lengths, angle and branch follow from the solution; on which \
                         side of the line of centres the lever stands does not, and with it the senses of the sliding, \
                         of the Coriolis acceleration and of the lever's angular acceleration",
            },
        )
        .expecting(Verdict::NotReproducible),
    ]
}

/// The rates at the printed position if the crank turned the other way.
fn clockwise() -> Option<PolarRates<f64>> {
    let mut instant = Instant::printed().ok()?;
    instant.drive.speed = -instant.drive.speed;
    instant.by_series()
}

/// Whether a diagram closes: what is missing, as a part of its longest side.
fn closes(gap: f64) -> Finding {
    Finding::new(vanishes(gap), format!("closes but for {gap:.0e} of its longest side"))
}

/// The lengths of the seven terms, in the order of the equation.
fn terms() -> [Option<f64>; 7] {
    let motion = Instant::printed().ok().and_then(|instant| instant.by_diagrams());
    let lengths = motion.map(|motion| {
        let right = &motion.accelerations;
        [
            motion.pin_normal.norm(),
            motion.pin_tangential.norm(),
            right.follower_normal.norm(),
            right.follower_tangential.norm(),
            right.sliding_normal.norm(),
            right.sliding_tangential.norm(),
            right.coriolis.norm(),
        ]
    });
    std::array::from_fn(|at| lengths.map(|lengths| lengths[at]))
}

/// The pin's acceleration from its components along the lever and across it, in polar coordinates.
pub fn components(rates: &PolarRates<f64>) -> Vector2<f64> {
    let along = rates.sliding_rate - rates.turning * rates.turning;
    let across = rates.turning_rate + 2.0 * rates.sliding * rates.turning;
    rates.position * along + quarter_turn(&rates.position) * across
}

/// The length of the pin's acceleration, by the differentiated loop closure.
pub fn total(rates: &PolarRates<f64>) -> f64 {
    components(rates).norm()
}
