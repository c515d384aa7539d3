//! The program's lines for the start: P, Q, R, V and the first acceleration.

use super::listing::line;
use super::program;
use super::program_letters::{FACTORS_AT_START, PLACES_AT_START, START, holds_from_rest};
use super::*;
use crate::meyer::reading::Letters;
use geneva_dynamics::{Coefficients, Pose};
use geneva_kinematics::Mechanism;

const PROGRAM: Locator = at("Appendix B, program, lines of SMT");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        line(PROGRAM, "meyer.listing.p", "P is L at the start", "P 1.+(G*G)-(2.*G*COS(X0))", program::P, PLACES_AT_START),
        line(PROGRAM, "meyer.listing.q", "Q is H at the start, which is zero", "Q (G*COS(X0))-1.", program::Q, PLACES_AT_START),
        line(
            PROGRAM, "meyer.listing.r",
            "R is A at the start, the ratio of the inertias",
            "R (IC/IW)+((Q*Q)/(P*P))",
            program::R,
            FACTORS_AT_START,
        ),
        line(
            PROGRAM, "meyer.listing.v",
            "V is the size of D at the start, which is zero",
            "V ABS((U*G*Q*SIN(X0))/(P*P))",
            program::V,
            FACTORS_AT_START,
        ),
        line(
            PROGRAM, "meyer.listing.start",
            "the first acceleration, which with V = 0 is the torque over the driver's inertia, whatever the friction",
            "2DX E/(R+V)",
            program::START,
            START,
        ),
        at("Appendix B, first sentence after the program")
            .statement(
                "meyer.app-b.start-lines",
                "simply equation 1-18",
                "the lines of SMT are the equation of motion for the start, solved for the acceleration",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // At all angles: at the start itself friction asks for nothing.
                let holds = poses(0.25).all(|(letters, c)| {
                    let friction = stated.pick(start_line("V", &letters), 0.0);
                    let angular_acceleration = DRIVE / (start_line("R", &letters) + friction);
                    c.acceleration(0.0).is_ok_and(|solved| agrees(angular_acceleration, solved.value))
                });
                Finding::new(holds, "the value they give satisfies Eq. (1-18) from rest, at all angles")
            })
            .second_route(Evidence::VECTORS, |stated| {
                let line = program::named(program::START).1.replace('V', stated.pick("V", "0"));
                let holds = holds_from_rest(&format!(r"\text{{2DX}} = {line}"));
                Finding::new(
                    holds == Some(true),
                    "we read and evaluated the lines and compared them with the torque that both members require from rest",
                )
            })
            .but_not("they are the equation without its friction"),
    ]
}

const INERTIA_RATIO: f64 = 0.625;
const DRIVE: f64 = 1.5;

/// The factors of the equation of motion, and the letters of the program's start.
fn pose(mechanism: Mechanism, angle: f64, friction: f64) -> (Letters, Coefficients<f64>) {
    let pose = Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle));
    let cards =
        [("G", mechanism.centre_distance_ratio()), ("X0", angle), ("U", friction), ("IC", INERTIA_RATIO), ("IW", 1.0)];
    let letters = reading::by_name(cards);
    (letters, Coefficients::from_pose(&pose, &INERTIA_RATIO, &friction, &DRIVE))
}

fn poses(friction: f64) -> impl Iterator<Item = (Letters, Coefficients<f64>)> {
    Mechanism::ALL.into_iter().flat_map(move |mechanism| {
        (-9..=9).map(move |k| pose(mechanism, mechanism.engagement_half_angle() * f64::from(k) / 10.0, friction))
    })
}

/// Whether the first acceleration satisfies the equation of motion at the entry at this speed, whatever the friction.
pub(crate) fn start_solves(speed: f64) -> Finding {
    let holds = Mechanism::ALL.iter().all(|mechanism| {
        [0.0, 0.125, 0.25].iter().all(|friction| {
            let (letters, c) = pose(*mechanism, -mechanism.engagement_half_angle(), *friction);
            let angular_acceleration = DRIVE / (start_line("R", &letters) + start_line("V", &letters));
            c.acceleration(speed).is_ok_and(|solved| agrees(angular_acceleration, solved.value))
        })
    });
    Finding::new(
        holds,
        format!("we put the program's first acceleration into the equation of motion at entry, at the speed {speed}"),
    )
}
