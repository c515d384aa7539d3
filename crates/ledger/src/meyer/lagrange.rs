//! Lagrange's equation, the generalised force, and what is left out of it: Eqs. (1-9) and (1-10).

use super::instants::{display, equal, reads, statement};
use super::*;
use geneva_dynamics::derivation::{FrictionLine, FrictionTorque, LagrangeIsPower, MomentArm};
use geneva_dynamics::energy::MomentArmIsSliding;
use geneva_dynamics::{Inertias, Parameters, Sign, Slots};
use geneva_kinematics::pin_vectors;
use std::sync::OnceLock;

const FORCES: &str = "Definition of Q_k after Eq. (1-9)";
const FREEDOM: &str = "Sentence after the definition of Q_k";
const TORQUES: &str = "Paragraph before Eq. (1-10)";

pub fn claims() -> Vec<Claim> {
    [equations(), forces(), torques()].concat()
}

fn equations() -> Vec<Claim> {
    vec![
        display(
            "meyer.eq-1-9",
            "Eq. (1-9)",
            "Lagrange's equation for forces with and without a potential; here for \
                    one coordinate, where it is the balance of power",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{q}_k} \right) - \frac{\partial T}{\partial q_k} = Q_k",
            lagrange_is_power,
            newton_is_lagrange,
        ),
        display(
            "meyer.lagrange-for-theta",
            "1st display after Eq. (1-9)",
            "the same for the one coordinate θ",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) - \frac{\partial T}{\partial \theta} = Q_\theta",
            lagrange_is_power,
            || reads("meyer.lagrange-for-theta"),
        ),
    ]
}

fn forces() -> Vec<Claim> {
    vec![
        statement(
            "meyer.constraint-forces",
            FORCES,
            "the normal forces of the constraint do no work together",
            "drop out",
            (Vectors, || {
                let across = |ratio: f64, angle: f64| {
                    let crank = Turn::from_radians(PI - angle);
                    pin_vectors::solve(&1.0, &ratio, &crank, &-1.0)
                        .map_or(f64::NAN, |pin| pin.sliding_velocity.perp(&pin.position))
                };
                let holds = Escapement::all().iter().all(|escapement| {
                    (-10..10).all(|k| vanishes(across(escapement.centre_distance_ratio(), instant(escapement, k))))
                });
                Finding::new(
                    holds,
                    "the pin does not move against the slot in the direction of the normal \
                        force",
                )
            }),
            (ClosedForm, newton_is_lagrange),
        ),
        statement(
            "meyer.no-potential",
            FORCES,
            "no force is left to a potential energy; the spring stands among the \
                    torques instead, and the equation is the same as with the spring's \
                    potential −K θ",
            "no potential energy",
            (Vectors, newton_is_lagrange),
            (ClosedForm, || {
                // −∂V/∂θ for V = −K θ, by a difference over one radian: exact for a straight line.
                equal(
                    |letter| {
                        let potential = |angle: f64| -letter("K") * angle;
                        let theta = letter("theta");
                        (potential(theta) - potential(theta + 1.0), letter("tau_1"))
                    },
                    "the slope of the spring's energy is its torque",
                )
            }),
        ),
        statement(
            "meyer.one-degree",
            FREEDOM,
            "the mechanism has one degree of freedom",
            "one degree of freedom",
            (LimitCase, || {
                // Grübler's count for a frame and two members on pivots, with a pin in a slot.
                let (members, pivots, pins_in_slots) = (3, 2, 1);
                let freedom = 3 * (members - 1) - 2 * pivots - pins_in_slots;
                Finding::new(freedom == 1, format!("Grübler's count for plane linkages gives {freedom}"))
            }),
            (Vectors, || {
                at_instants(|at| {
                    let (across, along) = (at.place.y, at.place.x);
                    (at.angle(), libm::atan(across / along))
                })
            }),
        ),
        display(
            "meyer.virtual-work",
            "2nd display after Eq. (1-9)",
            "work of all torques on the driver in a small turn",
            r"\delta W = Q_\theta \delta\theta = \tau \delta\theta",
            || prove(&MomentArmIsSliding).into(),
            newton_is_lagrange,
        ),
        display(
            "meyer.generalised-torque",
            "3rd display after Eq. (1-9)",
            "the generalised force is the torque on the driver",
            r"Q_\theta = \tau",
            || prove(&MomentArm).into(),
            || reads("meyer.generalised-torque"),
        ),
    ]
}

fn torques() -> Vec<Claim> {
    vec![
        display(
            "meyer.resultant-torque",
            "Display before Eq. (1-10)",
            "it is the spring's torque less the size of the friction's",
            r"Q_\theta = \tau_1 - |\tau_2|",
            || friction(FrictionLine::Opposing),
            || reads("meyer.resultant-torque"),
        ),
        opposing(
            "meyer.friction-opposes",
            TORQUES,
            "the torque of friction is against the driving torque",
            "always oppose the driving torque",
        ),
        display(
            "meyer.eq-1-10",
            "Eq. (1-10)",
            "Lagrange's equation with the two torques",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) - \frac{\partial T}{\partial \theta} = \tau_1 - |\tau_2|",
            lagrange_is_power,
            || reads("meyer.eq-1-10"),
        ),
    ]
}

/// Friction is against the motion. That comes to the same only while the driver turns as it is driven.
pub fn opposing(id: &'static str, locator: &'static str, meaning: &'static str, printed: &'static str) -> Claim {
    Claim::statement(
        WORK,
        id,
        locator,
        meaning,
        printed,
        Check::corrected_equation(
            (Vectors, || {
                let holds = [1.0, -1.0].iter().all(|speed| power(-1.0, *speed) < 0.0);
                Finding::new(
                    holds,
                    "a torque against the driving one, were the driver turned back against \
                            its spring, would do work",
                )
            }),
            || {
                let holds = [1.0, -1.0].iter().all(|speed: &f64| power(-speed.signum(), *speed) < 0.0);
                Finding::new(holds, "a torque against the motion takes power in both senses")
            },
            (ClosedForm, || {
                let parameters =
                    Inertias::new(1.0, 4.0).and_then(|both| Parameters::new(Slots::Four, both, 1.0, 0.125));
                let refused = parameters.is_ok_and(|parameters| parameters.acceleration(0.5, -1.0).is_err());
                Finding::new(
                    refused,
                    "the equation of motion, with the bars as they are, is for forward \
                        motion only",
                )
            }),
        ),
    )
    .expecting(Verdict::Corrected)
    .with_erratum(Erratum {
        corrected: "always oppose the motion",
        slip: Slip {
            id: "meyer.friction-opposes",
            reason: "Friction is against the sliding, and so against the motion of the \
                driver, whatever the driving torque. The sign that follows is right, \
                because the driver never turns back.",
            witness: "The equation of motion holds for forward motion only: for a driver \
                turned back, both signs of the bars change.",
            origin: Origin::Concept,
            consequence: Consequence::Conclusion,
            changes: "",
        },
    })
}

/// Power of a torque of friction with this sign on a driver of this speed, for a normal force times friction of one.
fn power(sign: f64, speed: f64) -> f64 {
    let escapement = Escapement::all()[0];
    let seen = Seen::new(&escapement, instant(&escapement, 4));
    let sliding = seen.place.normalize().dot(&seen.velocity) / DRIVER.0;
    sign * sliding.abs() * speed
}

/// One proof for the three displays of Lagrange's equation.
fn lagrange_is_power() -> Finding {
    static PROOF: OnceLock<Finding> = OnceLock::new();
    PROOF.get_or_init(|| prove(&LagrangeIsPower).into()).clone()
}

/// A display of the torque of friction, for both signs of what stands between the bars.
pub fn friction(line: FrictionLine) -> Finding {
    all_proven(&Sign::BOTH.map(|contact| FrictionTorque { line, contact }))
}

/// Newton's laws for the two members give the power of spring and friction as the growth of the kinetic energy.
fn newton_is_lagrange() -> Finding {
    equal(
        |letter| {
            let growth =
                letter("I_D") * letter("theta'") * letter("theta''") + letter("I_f") * letter("phi'") * letter("phi''");
            (growth, letter("Q_theta") * letter("theta'"))
        },
        "growth of the kinetic energy and power of the torques",
    )
}
