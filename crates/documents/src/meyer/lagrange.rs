//! Lagrange's equation, the generalised force, and what is left out of it: Eqs. (1-9) and (1-10).

use super::instants::{equal, holds, moments};
use super::letters::{mechanism, opposed};
use super::*;
use geneva_dynamics::{Inertias, Parameters, Sign};
use geneva_kinematics::Mechanism;
use geneva_kinematics::{Jet, angular_velocity, pin_slot};
use nalgebra::SMatrix;

const FORCES: Locator = at("Definition of Q_k after Eq. (1-9)");
const FREEDOM: Locator = at("Sentence after the definition of Q_k");
const TAU: Locator = at("Line after Q_θ = τ");
const TORQUES: &str = "Paragraph before Eq. (1-10)";

pub(super) fn claims() -> Vec<Claim> {
    [equations(), forces(), torques()].concat()
}

fn equations() -> Vec<Claim> {
    vec![
        at("Eq. (1-9)")
            .equation(
                "meyer.eq-1-9",
                concat!(
                    r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{q}_k} \right) - \frac{\partial ",
                    r"T}{\partial q_k} = Q_k"
                ),
                "Lagrange's equation for forces with and without a potential, here for one coordinate, where it is \
                 the power balance",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
        at("1st display after Eq. (1-9)")
            .equation(
                "meyer.lagrange-for-theta",
                concat!(
                    r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) - ",
                    r"\frac{\partial T}{\partial \theta} = Q_\theta"
                ),
                "Lagrange's equation for the one coordinate θ",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
    ]
}

fn forces() -> Vec<Claim> {
    vec![
        FORCES
            .statement("meyer.constraint-forces", "drop out", "together, the normal forces of the constraint do no work")
            .first_route(Evidence::VECTORS, |stated| {
                at_instants(|seen| {
                    // The velocity of pin against slot, with the follower's velocity by Eq. (1-7).
                    let turning = pin_slot::velocity_ratio(&seen.ratio, &seen.crank) * DRIVER.0;
                    let sliding = seen.velocity - quarter_turn(&seen.place) * turning;
                    (direction_of_a_force(seen, stated).dot(&sliding), 0.0)
                })
            })
            .second_route(Evidence::JET, |stated| {
                at_instants(|seen| {
                    // The torques of the pair about the two axes, each with the rate at which its member turns.
                    let force = direction_of_a_force(seen, stated);
                    let from_driver = seen.place - Vector2::new(seen.ratio, 0.0);
                    let place = pin_slot::pin_from_pivot(&Jet::constant(seen.ratio), &seen.crank.moving::<2>(1.0));
                    let follower = angular_velocity(&place).map_or(f64::NAN, |turning| turning.value().abs());
                    let inner = follower * seen.place.perp(&force) * seen.angular_velocity().signum();
                    let outer = from_driver.perp(&force) * from_driver.perp(&seen.velocity).signum();
                    (inner, outer)
                })
            })
            .but_not("the forces along the slot drop out too"),
        FORCES
            .statement(
                "meyer.no-potential",
                "no potential energy",
                "no force is assigned to a potential energy, because the spring counts among the torques instead",
            )
            .first_route(Evidence::VECTORS, |stated| {
                equal(
                    |letter| {
                        let growth = letter("I_D") * letter("theta'") * letter("theta''")
                            + letter("I_f") * letter("phi'") * letter("phi''");
                        let potential = stated.pick(0.0, -letter("K") * letter("theta'"));
                        (growth + potential, letter("tau") * letter("theta'"))
                    },
                    "the growth of the energies and the power of the torques",
                )
            })
            .second_route(crate::evidence::QUADRATURE, |stated| {
                let holds = frictionless().all(|(parameters, advance)| {
                    let potential = stated.pick(0.0, -parameters.drive() * advance);
                    agrees_in_steps(energy_gained(&parameters) + potential, parameters.drive() * advance)
                });
                Finding::new(
                    holds,
                    "we compared the energy gained over an engagement without friction with the work of the spring's torque",
                )
            })
            .but_not("the spring's potential −K θ is in the equation along with its torque")
            .interpreted_as(
                "No force is treated as conservative. (A constant torque could be, with the potential −K θ, but then \
                 it would not count among the torques.)",
            ),
        FREEDOM
            .statement("meyer.one-degree", "one degree of freedom", "the mechanism has one degree of freedom")
            .first_route(Evidence::LIMIT_CASE, |stated| {
                // Grübler's count for a frame and two members on pivots, with a pin in a slot.
                let (members, pivots, pins_in_slots) = (3, 2, 1);
                let freedom = 3 * (members - 1) - 2 * pivots - pins_in_slots;
                Finding::new(
                    f64::from(freedom) == stated.pick(stated.number(), 2.0),
                    format!("Grübler's count for plane linkages gives {freedom}"),
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                let freedom = stated.pick(stated.count() as usize, 2);
                for_each(
                    |at| {
                        (-10..10)
                            .all(|k| 6 - constraints(&PinKinematics::new(at, instant(at, k))).rank(1e-9) == freedom)
                    },
                    "we subtracted the rank of the constraints from the number of coordinates of two members in the \
                     plane",
                )
            })
            .but_not("it has two"),
        at("2nd display after Eq. (1-9)")
            .equation(
                "meyer.virtual-work",
                r"\delta W = Q_\theta \delta\theta = \tau \delta\theta",
                "work of all torques on the driver in a small turn",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
        at("3rd display after Eq. (1-9)")
            .equation(
                "meyer.generalised-torque",
                r"Q_\theta = \tau",
                "the generalised force is the torque on the driver",
            )
            .proven_by(opposed)
            .read(Evidence::CLOSED_FORM, holds),
        vector_sum(),
    ]
}

fn vector_sum() -> Claim {
    TAU.statement(
        "meyer.vector-sum",
        "vector sum of the driving torque and all frictional torques",
        "how the torques of the system make up the generalised force",
    )
    .first_route(Evidence::VECTORS, |stated| {
        // A brake on the follower's axis beside its inertia; no friction in the slot.
        let holds = moments().iter().map(instants::letters_of).all(|letter| {
            let brake = letter("I_f") / 2.0;
            // The normal force passes the driver's axis at the distance r cos(θ + φ).
            let arm = letter("r") * libm::cos(letter("theta") + letter("phi"));
            let driving =
                letter("I_D") * letter("theta''") + (letter("I_f") * letter("phi''") + brake) / letter("R") * arm;
            let factor = stated.pick(letter("phi'") / letter("theta'"), 1.0);
            let force = driving - brake * factor;
            let asked =
                letter("I_D") * letter("theta''") + letter("I_f") * letter("phi''") * letter("phi'") / letter("theta'");
            vanishes((force - asked) / force.abs().max(asked.abs()).max(1.0))
        });
        Finding::new(
            holds,
            "with a torque on the follower, we computed the generalised force from the forces between pin and slot",
        )
    })
    .second_route(crate::evidence::QUADRATURE, |stated| {
        for_each(
            |at| {
                // The work of a unit torque on the follower is the angle by which it turns. We take two thirds of an
                // engagement: over all of it, the driver turns as far with four slots.
                let ratio = at.centre_distance_ratio();
                let factor =
                    |angle: f64| stated.pick(pin_slot::velocity_ratio(&ratio, &Turn::from_radians(angle)), 1.0);
                let ends = [-at.engagement_half_angle(), at.engagement_half_angle() / 3.0];
                let [from, to] = ends.map(|end| PinKinematics::new(at, end).angle());
                agrees_in_steps(simpson(factor, ends[0], ends[1]), to - from)
            },
            "we compared the work of a torque on the follower over two thirds of an engagement with the angle through \
             which the follower turns",
        )
    })
    .but_not("a torque on the follower counts like a torque on the driver")
    .interpreted_as(
        "We sum what each torque contributes to τ, which the previous display defines by δW = τ δθ. The next sentences \
         speak of contributions too. The friction of the follower's bearing contributes φ'/θ' times its torque.",
    )
}

fn torques() -> Vec<Claim> {
    vec![
        at("Display before Eq. (1-10)")
            .equation(
                "meyer.resultant-torque",
                r"Q_\theta = \tau_1 - |\tau_2|",
                "the generalised force is the spring's torque minus the size of the friction torque",
            )
            .proven_by(opposed)
            .read(Evidence::CLOSED_FORM, holds),
        opposing("meyer.friction-opposes", TORQUES, "always oppose the driving torque"),
        at("Eq. (1-10)")
            .equation(
                "meyer.eq-1-10",
                concat!(
                    r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) - ",
                    r"\frac{\partial T}{\partial \theta} = \tau_1 - |\tau_2|"
                ),
                "Lagrange's equation with the two torques",
            )
            .proven_by(opposed)
            .read(Evidence::CLOSED_FORM, holds),
    ]
}

/// The claim that friction opposes the driving torque.
///
/// Friction acts against the motion, and therefore against the driving torque while the driver turns as it is driven.
pub(super) fn opposing(id: &'static str, locator: &'static str, printed: &'static str) -> Claim {
    at(locator)
        .statement(id, printed, "the friction torque acts against the driving torque")
        .first_route(Evidence::VECTORS, |stated| {
            let holds = Mechanism::ALL.iter().all(|escapement| {
                (-10..10).all(|k| {
                    let seen = PinKinematics::new(escapement, instant(escapement, k));
                    [1.0_f64, -1.0].iter().all(|normal| {
                        let said = stated.pick(-1.0, -normal.signum());
                        torque_of_friction(&seen, *normal).signum() == said
                    })
                })
            });
            Finding::new(
                holds,
                "we compared friction with the sliding of the pin, on either flank, at 20 instants of each escapement",
            )
        })
        .second_route(Evidence::CLOSED_FORM, |stated| {
            // The equation of motion with its bars, or with what stands between them.
            let holds = Mechanism::ALL.iter().all(|mechanism| {
                let parameters = Inertias::new(1.0, 2.0).and_then(|both| Parameters::new(*mechanism, both, 1.0, 0.25));
                parameters.is_ok_and(|parameters| {
                    (-9..=9).all(|k| {
                        let angle = mechanism.engagement_half_angle() * f64::from(k) / 10.0;
                        [0.25, 0.5, 1.0, 2.0, 4.0]
                            .iter()
                            .all(|speed| lost(&parameters, angle, *speed, stated) >= -1e-12)
                    })
                })
            });
            Finding::new(holds, "the power of the spring minus the growth of the kinetic energy is never negative")
        })
        .but_not(
            "it opposes the driving torque while the pin presses on one flank of the slot, and helps it on the other",
        )
        .interpreted_as("We take the driver to turn forwards, as it does from the start.")
}

/// What friction takes per unit of time and inertia of the follower, by the equation of motion.
fn lost(parameters: &Parameters, angle: f64, speed: f64, stated: Stated) -> f64 {
    let (factors, pose) = (parameters.coefficients(angle), parameters.pose(angle));
    let signed = factors.acceleration_with(&speed, Sign::Plus);
    let angular_acceleration = stated.pick(factors.acceleration(speed).map_or(f64::NAN, |found| found.value), signed);
    let follower = pose.velocity_ratio() * speed * pose.follower_acceleration(&speed, &angular_acceleration);
    parameters.drive() * speed - parameters.inertias().ratio() * speed * angular_acceleration - follower
}

/// Torque on the driver, positive as it turns, of a friction of the size of this normal force on the pin.
fn torque_of_friction(seen: &PinKinematics, normal: f64) -> f64 {
    let slot = seen.place.normalize();
    let force = -slot * slot.dot(&seen.velocity).signum() * normal.abs();
    let arm = seen.place - Vector2::new(seen.ratio, 0.0);
    arm.perp(&force) * arm.perp(&seen.velocity).signum()
}

/// A unit force between pin and slot: across the slot, as the constraint has it, or along it.
fn direction_of_a_force(seen: &PinKinematics, stated: Stated) -> Vector2<f64> {
    let along = seen.place.normalize();
    stated.pick(quarter_turn(&along), along)
}

/// How the constraints change with the places and angles of the two members: two pivots, and the pin in its slot.
///
/// Each member has the coordinates of its point on its own pivot and its angle; angles count alike for both.
fn constraints(seen: &PinKinematics) -> SMatrix<f64, 5, 6> {
    let mut rows = SMatrix::<f64, 5, 6>::zeros();
    for (row, column) in [(0, 0), (1, 1), (2, 3), (3, 4)] {
        rows[(row, column)] = 1.0;
    }
    let across = quarter_turn(&seen.place.normalize());
    let from_driver = quarter_turn(&(seen.place - Vector2::new(seen.ratio, 0.0)));
    let moved = [across.x, across.y, across.dot(&from_driver), -across.x, -across.y, -seen.radius()];
    for (column, change) in moved.into_iter().enumerate() {
        rows[(4, column)] = change;
    }
    rows
}

/// An escapement without friction for each number of slots, and the angle between two of its pins.
pub(super) fn frictionless() -> impl Iterator<Item = (Parameters, f64)> {
    Mechanism::ALL.into_iter().filter_map(|mechanism| {
        let parameters = Inertias::new(1.0, 2.0).and_then(|both| Parameters::new(mechanism, both, 1.5, 0.0)).ok()?;
        Some((parameters, 2.0 * mechanism.engagement_half_angle()))
    })
}

/// Whether two numbers agree as numbers do that were computed in steps.
pub(super) fn agrees_in_steps(a: f64, b: f64) -> bool {
    crate::evidence::STEPS_TOLERANCE.agrees(a, b)
}

/// An integral by Simpson's rule.
fn simpson(of: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let parts = 1000;
    let step = (to - from) / f64::from(parts);
    let weight = |k: u32| match k {
        0 => 1.0,
        k if k == parts => 1.0,
        k if k.is_multiple_of(2) => 2.0,
        _ => 4.0,
    };
    (0..=parts).map(|k| weight(k) * of(from + step * f64::from(k))).sum::<f64>() * step / 3.0
}

/// The growth of the kinetic energy over an engagement per unit of the follower's inertia, by the equation of motion.
///
/// The square of the speed grows with the angle by twice the acceleration. At both ends the follower stands still.
pub(super) fn energy_gained(parameters: &Parameters) -> f64 {
    let half = parameters.mechanism().engagement_half_angle();
    let parts = 2000;
    let step = 2.0 * half / f64::from(parts);
    let growth = |angle: f64, square: f64| {
        2.0 * parameters.acceleration(angle, libm::sqrt(square)).map_or(f64::NAN, |found| found.value)
    };
    let start = 1.0;
    let end = (0..parts).fold(start, |square, k| {
        let angle = -half + step * f64::from(k);
        let first = growth(angle, square);
        let second = growth(angle + step / 2.0, square + first * step / 2.0);
        let third = growth(angle + step / 2.0, square + second * step / 2.0);
        let fourth = growth(angle + step, square + third * step);
        square + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
    });
    parameters.inertias().ratio() * (end - start) / 2.0
}
