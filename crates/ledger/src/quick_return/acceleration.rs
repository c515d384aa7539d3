//! The accelerations: seven terms, two of them zero, two unknown but for their directions.

use super::*;
use geneva_kinematics::prove;
use geneva_kinematics::quick_return::proofs::{AcrossTheLever, AlongTheLever, Compared, DiagramAgainstSeries};

const ADVICE: &str = "Solution, acceleration, remark";
const PIN_NORMAL: &str = "Solution, acceleration, normal of P2";
const PIN_TANGENTIAL: &str = "Solution, acceleration, tangential of P2";
const LEVER_NORMAL: &str = "Solution, acceleration, normal of P4";
const SLIDING_NORMAL: &str = "Solution, acceleration, relative normal";
const CORIOLIS: &str = "Solution, acceleration, Coriolis";
const SENSE: &str = "Solution, acceleration, direction of Coriolis";
const SLIDING: &str = "Solution, acceleration, relative tangential";
const LEVER_TANGENTIAL: &str = "Solution, acceleration, tangential of P4";
const LEVER: &str = "Solution, last line";

pub fn claims() -> Vec<Claim> {
    [known(), coriolis(), found()].concat()
}

fn known() -> Vec<Claim> {
    vec![
        frames::acceleration_in_a_frame(),
        Claim::statement(
            WORK,
            "quick-return.acceleration-from-the-lever",
            ADVICE,
            "normal and tangential relative acceleration are what one sees who holds \
                the lever still; the Coriolis term is on top of it",
            "P2 moving, P4 fixed",
            Check::equation(
                (ExactIdentity, || prove(&DiagramAgainstSeries(Compared::SlidingAcceleration)).into()),
                (Vectors, || {
                    let (seen, whole) = (
                        diagram(|motion| motion.accelerations.sliding_tangential.norm()),
                        diagram(|motion| {
                            (motion.accelerations.sliding_tangential + motion.accelerations.coriolis).norm()
                        }),
                    );
                    Finding::new(
                        seen < whole,
                        format!(
                            "{seen:.3} m/s² are seen from the lever, {whole:.3} m/s² are the \
                            difference of the two points"
                        ),
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.pin-normal-equation",
            PIN_NORMAL,
            "centripetal acceleration of the pin",
            r"A_{P2}^n = \omega_2^2 l_2",
            Check::equation(
                (Vectors, || {
                    same(
                        diagram(|motion| motion.pin_normal.norm()),
                        Instant::printed().map_or(f64::NAN, |at| at.drive.speed * at.drive.speed * at.linkage.crank()),
                    )
                }),
                (Series, || same(diagram(|motion| motion.pin_normal.norm()), series(given::total))),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.pin-normal",
            PIN_NORMAL,
            "centripetal acceleration of the pin",
            ("5.492", "m/s^2"),
            Check::number_from_rounded(
                (Vectors, || diagram(|motion| motion.pin_normal.norm())),
                (Series, || series(given::total)),
                || {
                    printed("quick-return.driver-rate")
                        * printed("quick-return.driver-rate")
                        * printed("quick-return.crank")
                },
            ),
        )
        .expecting(Verdict::FromRounded)
        .with_erratum(rounded("5.483", "The rate of the crank, rounded to three digits, is squared.")),
        Claim::equation(
            WORK,
            "quick-return.pin-tangential",
            PIN_TANGENTIAL,
            "no tangential acceleration of the pin at constant speed of the crank",
            r"A_{P2}^t = 0 \text{ since } \omega_2 = \text{constant}",
            Check::equation(
                (Vectors, || {
                    Finding::new(
                        diagram(|motion| motion.pin_tangential.norm()) == 0.0,
                        "the crank has no angular acceleration",
                    )
                }),
                (Series, || {
                    // Along the circle, the polar components of the whole acceleration cancel.
                    let along = Instant::printed().ok().and_then(|at| Some((at.by_series()?, at.by_diagrams()?)));
                    let along = along.map_or(f64::NAN, |(rates, motion)| {
                        given::components(&rates).dot(&motion.velocities.pin_velocity.normalize())
                    });
                    Finding::new(vanishes(along), format!("along the circle {along:.0e} m/s² are left"))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.lever-normal-equation",
            LEVER_NORMAL,
            "centripetal acceleration of the lever's point",
            r"A_{P4}^n = \omega_4^2 l_4",
            Check::equation(
                (Vectors, || {
                    same(
                        diagram(|motion| motion.accelerations.follower_normal.norm()),
                        series(|rates| rates.turning * rates.turning * radius(rates)),
                    )
                }),
                (Series, || {
                    let squared = diagram(|motion| {
                        motion.velocities.slot_point_velocity.norm_squared() / motion.velocities.position.norm()
                    });
                    same(series(|rates| rates.turning * rates.turning * radius(rates)), squared)
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.lever-normal",
            LEVER_NORMAL,
            "centripetal acceleration of the lever's point",
            ("0.813", "m/s^2"),
            Check::number_from_rounded(
                (Vectors, || diagram(|motion| motion.accelerations.follower_normal.norm())),
                (Series, || series(|rates| rates.turning * rates.turning * radius(rates))),
                || {
                    printed("quick-return.lever-speed")
                        * printed("quick-return.lever-speed")
                        * printed("quick-return.lever-length")
                },
            ),
        )
        .expecting(Verdict::FromRounded)
        .with_erratum(rounded(
            "0.812",
            "The rounded speed of the lever is squared and multiplied by its rounded length.",
        )),
        Claim::equation(
            WORK,
            "quick-return.sliding-normal",
            SLIDING_NORMAL,
            "no relative normal acceleration in a straight slot",
            r"A_{P2/P4}^n = \frac{v_{P2/P4}^2}{R} = 0",
            Check::equation(
                (Vectors, || {
                    Finding::new(
                        diagram(|motion| motion.accelerations.sliding_normal.norm()) == 0.0,
                        "the slot is straight: no term across it but the lever's own and \
                        Coriolis",
                    )
                }),
                (Series, || {
                    let across = Instant::printed().ok().and_then(|at| Some((at.by_series()?, at.by_diagrams()?)));
                    let gap = across.map_or(f64::NAN, |(rates, motion)| {
                        let rest = (rates.turning_rate + 2.0 * rates.turning * rates.sliding) * radius(&rates);
                        let whole =
                            motion.velocities.position.perp(&motion.pin_normal) / motion.velocities.position.norm();
                        rest - whole
                    });
                    Finding::new(vanishes(gap), format!("across the lever {gap:.0e} m/s² are left for it"))
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "quick-return.letter-capital-r",
            SLIDING_NORMAL,
            "the letter R names the radius of the relative path",
            "R is infinite",
            Check::corrected_equation(
                (OtherPlaceInSource, || {
                    let vector =
                        crate::claim("quick-return.sum-of-places").is_some_and(|claim| claim.printed.contains("= R"));
                    Finding::new(!vector, "the letter R is the vector to the frame's origin too")
                }),
                || Finding::new(symbols::ours_are_unambiguous(), "each of the book's symbols stands for one thing"),
                (LimitCase, || {
                    let length = series(radius);
                    Finding::new(length.is_finite(), format!("the vector R is {length:.3} m long, not infinite"))
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "ρ is infinite",
            slip: Slip {
                id: "",
                reason: "One letter stands for the vector to the frame's origin and for the \
                    radius of curvature of the pin's path in the frame.",
                witness: "The vector has the lever's length, the radius is infinite.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
    ]
}

fn coriolis() -> Vec<Claim> {
    vec![
        Claim::equation(WORK, "quick-return.coriolis-equation", CORIOLIS, "magnitude of the Coriolis acceleration; its factors are at right angles", r"2\omega_4 v_{P2/P4}",
            Check::equation(
                (ExactIdentity, || prove(&DiagramAgainstSeries(Compared::Coriolis)).into()),
                (Series, || same(series(|rates| 2.0 * (rates.turning * rates.sliding).abs() * radius(rates)), diagram(|motion| motion.accelerations.coriolis.norm()))),
            ),
        ),
        Claim::value(WORK, "quick-return.coriolis", CORIOLIS, "magnitude of the Coriolis acceleration", ("1.960", "m/s^2"),
            Check::number_from_rounded(
                (Vectors, || diagram(|motion| motion.accelerations.coriolis.norm())),
                (Series, || series(|rates| 2.0 * (rates.turning * rates.sliding).abs() * radius(rates))),
                || 2.0 * printed("quick-return.lever-speed") * printed("quick-return.sliding-speed"),
            ),
        )
        .expecting(Verdict::FromRounded)
        .with_erratum(rounded("1.958", "The speed of the lever is the rounded one.")),
        Claim::statement(WORK, "quick-return.coriolis-direction", SENSE, "the direction of the Coriolis acceleration, of which the factors are \
                given and the result is not", r"\omega_4 \times v_{P2/P4}",
            Check::Missing {
                reason: "The line says how to find the direction and does not say which it is; one of the two factors \
                         is in the lost diagram. Across the lever, clockwise about its pivot if the pin slides \
                         inwards, counter-clockwise in the mirror image",
            },
        )
        .expecting(Verdict::NotReproducible),
        Claim::statement(WORK, "quick-return.lever-sense", SENSE, "the lever turns counter-clockwise", "out of the page",
            Check::equation(
                (Vectors, || positive(diagram(|motion| motion.velocities.follower_speed))),
                (Series, || {
                    let mirrored = Instant::mirrored().ok().and_then(|at| at.by_series());
                    positive(mirrored.map_or(f64::NAN, |rates| rates.turning))
                }),
            ),
        ),
        Claim::statement(WORK, "quick-return.sense-of-sliding", SENSE, "the sense of the sliding velocity, as in the velocity diagram", "as in velocity diagram",
            Check::Missing {
                reason: "The diagram is not in the copy. Towards the lever's pivot if the lever stands where a crank that \
                         turns counter-clockwise has passed the line of centres; away from it in the mirror image, \
                         which has the same printed numbers",
            },
        )
        .expecting(Verdict::NotReproducible),
    ]
}

fn found() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "quick-return.sliding-acceleration-equation",
            SLIDING,
            "sliding acceleration, towards the lever's pivot",
            r"A_{P2/P4}^t = A_{P2}^n \cos \ldots - A_{P4}^n",
            Check::equation(
                (ExactIdentity, || prove(&AlongTheLever).into()),
                (Vectors, || {
                    let inwards = diagram(|motion| {
                        -motion.accelerations.sliding_tangential.dot(&motion.velocities.position.normalize())
                    });
                    let beta = Turn::from_radians(position_of(Position::angle_at_pin));
                    same(
                        inwards,
                        diagram(|motion| motion.pin_normal.norm()) * beta.cos
                            - diagram(|motion| motion.accelerations.follower_normal.norm()),
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.sliding-acceleration",
            SLIDING,
            "sliding acceleration, towards the lever's pivot",
            ("2.694", "m/s^2"),
            Check::number_from_rounded(
                (Vectors, || diagram(|motion| motion.accelerations.sliding_tangential.norm())),
                (Series, || series(|rates| rates.sliding_rate.abs() * radius(rates))),
                || {
                    printed("quick-return.pin-normal") * cosine(printed("quick-return.angle-at-pin"))
                        - printed("quick-return.lever-normal")
                },
            ),
        )
        .expecting(Verdict::FromRounded)
        .with_erratum(rounded("2.689", "Both terms come from rounded steps.")),
        Claim::equation(
            WORK,
            "quick-return.lever-tangential-equation",
            LEVER_TANGENTIAL,
            "tangential acceleration of the lever's point, in the sense of the pin's \
                    acceleration across the lever",
            r"A_{P4}^t = A_{P2}^n \sin \ldots - 2\omega_4 v_{P2/P4}",
            Check::equation(
                (ExactIdentity, || prove(&AcrossTheLever).into()),
                (Vectors, || {
                    let beta = Turn::from_radians(position_of(Position::angle_at_pin));
                    let across = diagram(|motion| motion.pin_normal.norm()) * beta.sin
                        - diagram(|motion| motion.accelerations.coriolis.norm());
                    same(across, diagram(|motion| motion.accelerations.follower_tangential.norm()))
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.lever-tangential",
            LEVER_TANGENTIAL,
            "tangential acceleration of the lever's point",
            ("2.266", "m/s^2"),
            Check::number_from_rounded(
                (Vectors, || diagram(|motion| motion.accelerations.follower_tangential.norm())),
                (Series, || series(|rates| rates.turning_rate.abs() * radius(rates))),
                || {
                    printed("quick-return.pin-normal") * sine(printed("quick-return.angle-at-pin"))
                        - printed("quick-return.coriolis")
                },
            ),
        )
        .expecting(Verdict::FromRounded)
        .with_erratum(rounded("2.262", "Both terms come from rounded steps.")),
        Claim::equation(
            WORK,
            "quick-return.lever-acceleration-equation",
            LEVER,
            "tangential acceleration and angular acceleration of the lever",
            r"A_{P4}^t = \alpha_4 l_4",
            Check::equation(
                (Vectors, || {
                    same(
                        diagram(|motion| motion.accelerations.follower_tangential.norm()),
                        series(|rates| (rates.turning_rate * radius(rates)).abs()),
                    )
                }),
                (Series, || {
                    same(
                        series(|rates| rates.turning_rate),
                        diagram(|motion| motion.accelerations.follower_acceleration),
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.lever-acceleration",
            LEVER,
            "angular acceleration of the lever",
            ("4.12", "rad/s^2"),
            Check::number_from_rounded(
                (Vectors, || diagram(|motion| motion.accelerations.follower_acceleration.abs())),
                (Series, || series(|rates| rates.turning_rate.abs())),
                || printed("quick-return.lever-tangential") / printed("quick-return.lever-length"),
            ),
        )
        .expecting(Verdict::FromRounded)
        .with_erratum(rounded("4.11", "Numerator and denominator come from rounded steps.")),
        Claim::statement(
            WORK,
            "quick-return.lever-acceleration-sense",
            LEVER,
            "the sense of the lever's angular acceleration, of which the magnitude alone is given",
            r"\alpha_4",
            Check::Missing {
                reason: "Magnitudes only. The lever slows down if the pin slides inwards; in the mirror image, which \
                         has the same printed numbers, it speeds up",
            },
        )
        .expecting(Verdict::NotReproducible),
    ]
}

fn positive(speed: f64) -> Finding {
    Finding::new(speed > 0.0, format!("{speed:.3} rad/s, counter-clockwise positive"))
}
