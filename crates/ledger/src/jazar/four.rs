//! The equations of the wheel of four stations, (5.25) to (5.29), and the figures 5.29 and 5.30.

use super::*;
use crate::{Consequence, Dimension as Exponents, Erratum, Origin, Slip, Verdict};
use geneva_kinematics::wheel::{acceleration_ratio, entry_acceleration, unsteady_acceleration};
use geneva_kinematics::wheel_proofs::{
    AccelerationOfFour, LoopClosure, Printed, Quantity, SlotEliminated, TangentDifferentiated, UnsteadyAcceleration,
    UnsteadyAccelerationOfFour, VelocityOfFour,
};
use geneva_kinematics::{prove, prove_with_root};

const LOOP: &str = "Eq. (5.25)";
const PLOT: &str = "Paragraph on Fig. 5.30";
const STATIONS: &str = "2nd paragraph on Fig. 5.30";

pub fn claims() -> Vec<Claim> {
    [equations(), accelerations(), curves()].concat()
}

fn equations() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "jazar.eq-5.25-across",
            LOOP,
            "loop closure across the line of centres",
            r"r \sin \theta = x \sin \phi",
            Check::equation(
                (ExactIdentity, || prove(&LoopClosure { along: false }).into()),
                (Vectors, || {
                    at_instants(|wheel, t| (libm::sin(t), slot_radius(wheel, t) * libm::sin(by_series(wheel, t)[0])))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.25-along",
            LOOP,
            "loop closure along the line of centres",
            r"r \cos \theta + x \cos \phi = \sqrt{2}r",
            Check::equation(
                (ExactIdentity, || prove(&LoopClosure { along: true }).into()),
                (Vectors, || {
                    at_instants(|wheel, t| {
                        (libm::cos(t) + slot_radius(wheel, t) * libm::cos(by_series(wheel, t)[0]), 2f64.sqrt())
                    })
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.slot-eliminated",
            "Display after Eq. (5.25)",
            "the pin's distance eliminated",
            r"\cos \theta + \frac{\sin \theta}{\tan \phi} = \sqrt{2}",
            Check::equation(
                (ExactIdentity, || prove(&SlotEliminated).into()),
                (Vectors, || {
                    at_instants(|wheel, t| {
                        (libm::cos(t) + libm::sin(t) / libm::tan(by_series(wheel, t)[0]), 2f64.sqrt())
                    })
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.26",
            "Eq. (5.26)",
            "tangent of the wheel angle",
            r"\tan \phi = \frac{\sin \theta}{\sqrt{2} - \cos \theta}",
            Check::equation(
                (ExactIdentity, || prove(&Printed(Quantity::Tangent)).into()),
                (Vectors, || {
                    at_instants(|wheel, t| {
                        (libm::tan(by_series(wheel, t)[0]), libm::sin(t) / (2f64.sqrt() - libm::cos(t)))
                    })
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.27",
            "Eq. (5.27)",
            "wheel angle",
            r"\phi = \tan^{-1} \left(\frac{\sin \theta}{\sqrt{2} - \cos \theta} \right)",
            Check::equation(
                // The denominator is positive for every θ, so the principal value is the right one.
                (Vectors, || {
                    at_instants(|wheel, t| {
                        (by_series(wheel, t)[0], libm::atan(libm::sin(t) / (2f64.sqrt() - libm::cos(t))))
                    })
                }),
                (ExactIdentity, || prove(&Printed(Quantity::Tangent)).into()),
            ),
        ),
        Claim::figure(
            WORK,
            "jazar.fig-5.29",
            "Fig. 5.29, caption",
            "θ and φ are angles of rotation from the line of centres",
            "line of centers",
            Check::equation(
                (Vectors, || same(of(4, |wheel| by_series(wheel, 0.0)[0]), 0.0)),
                (ExactIdentity, || prove(&LoopClosure { along: false }).into()),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.tangent-differentiated",
            "Display before Eq. (5.28)",
            "Eq. (5.26) differentiated",
            r"\dot{\phi}(1 + \tan^2 \phi) = \dot{\theta} \frac{(\sqrt{2}\cos\theta - 1)}{(\sqrt{2} - \cos\theta)^2}",
            Check::equation(
                (ExactIdentity, || prove_with_root::<2, 2>(&TangentDifferentiated).into()),
                (Series, || {
                    at_instants(|wheel, t| {
                        let ([angle, speed, ..], rest) = (by_series(wheel, t), 2f64.sqrt() - libm::cos(t));
                        let tangent = libm::tan(angle);
                        (speed * (1.0 + tangent * tangent), (2f64.sqrt() * libm::cos(t) - 1.0) / (rest * rest))
                    })
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.28",
            "Eq. (5.28)",
            "angular velocity of the wheel of four",
            r"\dot{\phi} = \dot{\theta} \left(\frac{\sqrt{2} \cos \theta - 1}{3 - 2\sqrt{2} \cos \theta} \right)",
            Check::equation(
                (ExactIdentity, || prove_with_root::<2, 2>(&VelocityOfFour).into()),
                (AutomaticDerivative, || as_by_duals_of_four(1, printed_5_28)),
            ),
        ),
    ]
}

fn accelerations() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "jazar.unsteady-acceleration",
            "Display before Eq. (5.29)",
            "angular acceleration of the wheel of four, the driver speeding up",
            r"\ddot{\phi} = \ddot{\theta} \left(\frac{\sqrt{2} \cos \theta - 1}{3 - 2\sqrt{2} \cos \theta} \right) - \dot{\theta}^2 \frac{\sqrt{2} \sin \theta}{(3 - 2\sqrt{2} \cos \theta)^2}",
            Check::equation(
                (ExactIdentity, || prove_with_root::<2, 3>(&UnsteadyAccelerationOfFour).into()),
                (ExactIdentity, || prove(&UnsteadyAcceleration).into()),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.steady-driver",
            "Sentence before Eq. (5.29)",
            "with a steady driver the first term vanishes",
            "first term disappears",
            Check::equation(
                (ClosedForm, || {
                    at_instants(|wheel, t| {
                        let (k, turn) = (wheel.centre_distance_ratio(), Turn::from_radians(t));
                        (unsteady_acceleration(&k, &turn, &1.0, &0.0), acceleration_ratio(&k, &turn))
                    })
                }),
                (Series, || {
                    at_instants(|wheel, t| {
                        (
                            by_series(wheel, t)[2],
                            acceleration_ratio(&wheel.centre_distance_ratio(), &Turn::from_radians(t)),
                        )
                    })
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.29",
            "Eq. (5.29)",
            "angular acceleration of the wheel of four, the driver steady",
            r"\ddot{\phi} = \dot{\theta}^2 \frac{\sqrt{2} \sin \theta}{(3 - 2\sqrt{2} \cos \theta)^2}",
            Check::corrected_equation(
                (ExactIdentity, || prove_with_root::<2, 2>(&AccelerationOfFour { negative: false }).into()),
                || prove_with_root::<2, 2>(&AccelerationOfFour { negative: true }).into(),
                // (5.32), whose sign is right, for four stations.
                (OtherPlaceInSource, || at_instants(|wheel, t| (printed_5_32(wheel, t), -printed_5_29(t)))),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\ddot{\phi} = -\dot{\theta}^2 \frac{\sqrt{2} \sin \theta}{(3 - 2\sqrt{2} \cos \theta)^2}",
            slip: Slip {
                id: "",
                reason: "The display before it has a minus sign in front of this term; here it is lost. As printed \
                    the wheel would first slow down and then speed up.",
                witness: "Eq. (5.32) of the same source has the sign, and gives the corrected form for four stations.",
                origin: Origin::Misprint,
                consequence: Consequence::Derivation,
                changes: "",
            },
        }),
    ]
}

fn curves() -> Vec<Claim> {
    vec![
        Claim::figure(
            WORK,
            "jazar.fig-5.30",
            PLOT,
            "Eqs. (5.27) and (5.28) give the wheel's angle and velocity over the advance",
            "plotted",
            Check::equation(
                (Series, || {
                    at_instants(|wheel, t| (by_series(wheel, t)[0], wheel.engaged(t).map_or(f64::NAN, |m| m.angle)))
                }),
                (ExactIdentity, || prove_with_root::<2, 2>(&VelocityOfFour).into()),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.phi-range",
            PLOT,
            "wheel angle at entry and exit",
            ("-45", "°"),
            Check::number(
                (ClosedForm, || -of(4, Wheel::half_station).to_degrees()),
                (Vectors, || of(4, |wheel| by_series(wheel, -wheel.engagement_half_angle())[0]).to_degrees()),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.velocity-normalisation",
            PLOT,
            "the velocity curve is a pure number",
            r"\dot{\phi}/\dot{\theta}",
            Check::equation(
                (Dimension, || quotient(Exponents::ANGULAR_SPEED, Exponents::ANGULAR_SPEED)),
                (ExactIdentity, || prove_with_root::<2, 2>(&VelocityOfFour).into()),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.acceleration-normalisation",
            PLOT,
            "the acceleration curve is a pure number",
            r"\ddot{\phi}/\dot{\theta}",
            Check::corrected_equation(
                (Dimension, || quotient(Exponents::ANGULAR_ACCELERATION, Exponents::ANGULAR_SPEED)),
                || quotient(Exponents::ANGULAR_ACCELERATION, Exponents::ANGULAR_SPEED * Exponents::ANGULAR_SPEED),
                (ExactIdentity, || prove_with_root::<2, 2>(&AccelerationOfFour { negative: true }).into()),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\ddot{\phi}/\dot{\theta}^2",
            slip: Slip {
                id: "",
                reason: "The square is lost. The quotient as printed still has the unit of an angular speed, and \
                    could not be drawn on one axis with the velocity curve.",
                witness: "The caption of Fig. 5.30 says it rightly, and the corrected Eq. (5.29) is proportional to \
                    the square.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::statement(
            WORK,
            "jazar.smooth-inside",
            STATIONS,
            "velocity and acceleration are smooth inside the advance",
            "smooth",
            Check::equation(
                (LimitCase, || {
                    for_all_stations(
                        |wheel| wheel.centre_distance_ratio() > 1.0,
                        "the denominators are at least (k − 1)² > 0",
                    )
                }),
                (Series, || {
                    for_all_stations(
                        |wheel| {
                            (-9..=9).all(|k| {
                                by_series(wheel, wheel.engagement_half_angle() * f64::from(k) / 9.0)
                                    .iter()
                                    .all(|d| d.is_finite())
                            })
                        },
                        "three derivatives are finite at 19 instants, the ends included",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.infinite-jerk",
            STATIONS,
            "the jerk is infinite where the advance begins and ends",
            "infinite",
            Check::equation(
                (ClosedForm, || {
                    for_all_stations(|wheel| entry_acceleration(wheel) > 0.0, "the acceleration jumps by tan α")
                }),
                (Series, || {
                    for_all_stations(
                        |wheel| by_series(wheel, -wheel.engagement_half_angle())[2] > 0.0,
                        "φ̈ is not zero as the pin enters",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.least-stations",
            STATIONS,
            "three is the geometric lower limit of stations",
            "three",
            Check::equation(
                (LimitCase, || {
                    // With two stations the slot is across the line of centres as the pin enters: no angle to advance in.
                    let engagement = |stations: f64| PI / 2.0 - PI / stations;
                    let (two, three) = (engagement(2.0), engagement(3.0));
                    Finding::new(
                        two <= 0.0 && three > 0.0,
                        format!("engagement ±{two} for two, ±{:.0}° for three", three.to_degrees()),
                    )
                }),
                (ClosedForm, || {
                    Finding::new(Wheel::new(2).is_err() && Wheel::new(3).is_ok(), "two cannot be built, three can")
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.more-pins",
            STATIONS,
            "drivers with two or more pins are possible",
            "two or more",
            Check::equation(
                (LimitCase, || {
                    for_all_stations(
                        |wheel| Wheel::with_pins(wheel.stations(), 2).is_ok_and(|two| two.dwell_fraction() > 0.0),
                        "two pins leave a dwell",
                    )
                }),
                (ClosedForm, || {
                    let most: Vec<_> = [3, 4, 5, 6]
                        .iter()
                        .map(|n| (1..).take_while(|p| Wheel::with_pins(*n, *p).is_ok()).count())
                        .collect();
                    Finding::new(most.iter().all(|p| *p >= 2), format!("3, 4, 5, 6 stations take up to {most:?} pins"))
                }),
            ),
        ),
        Claim::figure(
            WORK,
            "jazar.fig-5.30-caption",
            "Fig. 5.30, caption",
            "the curves are normalised by the driver's speed and by its square",
            "driver angular velocity squared",
            Check::equation(
                (Dimension, || {
                    quotient(Exponents::ANGULAR_ACCELERATION, Exponents::ANGULAR_SPEED * Exponents::ANGULAR_SPEED)
                }),
                (Series, || {
                    at_instants(|wheel, t| {
                        (
                            by_series(wheel, t)[2],
                            acceleration_ratio(&wheel.centre_distance_ratio(), &Turn::from_radians(t)),
                        )
                    })
                }),
            ),
        ),
    ]
}

/// Eq. (5.28) as it is printed, for a driver of speed one.
pub(super) fn printed_5_28(theta: f64) -> f64 {
    let product = 2f64.sqrt() * libm::cos(theta);
    (product - 1.0) / (3.0 - 2.0 * product)
}

/// Eq. (5.29) as it is printed, without its minus sign, for a driver of speed one.
pub(super) fn printed_5_29(theta: f64) -> f64 {
    let square = 3.0 - 2.0 * 2f64.sqrt() * libm::cos(theta);
    2f64.sqrt() * libm::sin(theta) / (square * square)
}

/// Eq. (5.32) as it is printed, for a driver of speed one.
pub(super) fn printed_5_32(wheel: &Wheel, theta: f64) -> f64 {
    let (sine, cosine) = (libm::sin(wheel.half_station()), libm::cos(wheel.half_station()));
    let square = 1.0 + sine * sine - 2.0 * sine * libm::cos(theta);
    -(sine * cosine * cosine * libm::sin(theta)) / (square * square)
}

/// The pin's distance from the wheel's axis in crank radii.
fn slot_radius(wheel: &Wheel, theta: f64) -> f64 {
    pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(theta)).norm()
}

/// Whether a formula for four stations agrees with a derivative by dual numbers.
fn as_by_duals_of_four(order: usize, formula: fn(f64) -> f64) -> Finding {
    let Ok(wheel) = four_stations() else { return Finding::new(false, "no wheel of four") };
    let instants = (-9..=9).map(|k| wheel.engagement_half_angle() * f64::from(k) / 9.0);
    let holds = instants.map(|t| formula(t) - by_duals(&wheel, t)[order]).all(vanishes);
    Finding::new(holds, if holds { "agrees at 19 instants" } else { "differs" })
}

/// Whether both sides of an equation for four stations agree at instants all over the advance.
fn at_instants(sides: fn(&Wheel, f64) -> (f64, f64)) -> Finding {
    let Ok(wheel) = four_stations() else { return Finding::new(false, "no wheel of four") };
    let end = wheel.engagement_half_angle();
    let instants = (-45..45).map(|step| end * (f64::from(step) + 0.5) / 45.5);
    let worst = instants
        .map(|t| sides(&wheel, t))
        .map(|(a, b)| (a - b).abs() / a.abs().max(b.abs()).max(1.0))
        .fold(0.0, f64::max);
    Finding::new(
        worst <= crate::tolerance::ROUTES.relative,
        format!("the sides differ by at most {worst:.0e} at 90 instants"),
    )
}

/// Whether the quotient of two quantities is a pure number.
fn quotient(above: Exponents, below: Exponents) -> Finding {
    let exponents = above / below;
    Finding::new(exponents == Exponents::NONE, exponents.to_string())
}
