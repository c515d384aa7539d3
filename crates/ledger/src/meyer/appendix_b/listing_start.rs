//! The program's lines for the start: P, Q, R, V and the first acceleration.

use super::*;
use geneva_dynamics::derivation::{StartAtEntry, StartingAcceleration};
use geneva_dynamics::{Coefficients, Pose, Sign, Slots};

const PROGRAM: &str = "Appendix B, program, lines of SMT";

pub fn claims() -> Vec<Claim> {
    vec![
        statement(
            "meyer.listing.p",
            PROGRAM,
            "P is L at the start",
            "P",
            (ClosedForm, || at_start(|start| (start.p, start.pose.square))),
            (Vectors, || {
                for_each(
                    |at| agrees(start_of(at).p, Seen::new(at, -at.driver_half_angle()).place.norm_squared()),
                    "the pin's distance from the follower's axis, squared",
                )
            }),
        ),
        statement(
            "meyer.listing.q",
            PROGRAM,
            "Q is H at the start, which is zero",
            "Q",
            (ClosedForm, || at_start(|start| (start.q, 0.0))),
            (Vectors, || exactly(|at| is_zero(&at.entering.across), "the entering pin moves along its slot")),
        ),
        statement(
            "meyer.listing.r",
            PROGRAM,
            "R is A at the start, which is the ratio of the inertias",
            "R",
            (ClosedForm, || at_start(|start| (start.r, start.coefficients.a))),
            (ExactIdentity, || prove(&StartAtEntry).into()),
        ),
        statement(
            "meyer.listing.v",
            PROGRAM,
            "V is the size of D at the start, which is zero",
            "V",
            (ClosedForm, || at_start(|start| (start.v, start.coefficients.d.abs()))),
            (Vectors, || exactly(|at| is_zero(&at.entering.across), "where the pin moves along its slot, D is zero")),
        ),
        statement(
            "meyer.listing.start",
            PROGRAM,
            "the first acceleration; with V = 0 it is the torque over the driver's \
                    inertia, whatever the friction",
            "2DX",
            (ClosedForm, || start_solves(0.0)),
            (ExactIdentity, || all_proven(&Sign::BOTH.map(|sign| StartingAcceleration { sign }))),
        ),
    ]
}

const FRICTION: f64 = 0.25;
const INERTIA_RATIO: f64 = 0.625;
const DRIVE: f64 = 1.5;

/// What the lines compute for the printed start.
struct Start {
    p: f64,
    q: f64,
    r: f64,
    v: f64,
    acceleration: f64,
    pose: Pose<f64>,
    coefficients: Coefficients<f64>,
}

fn start(ratio: f64, angle: f64) -> Start {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let p = 1.0 + ratio * ratio - 2.0 * ratio * cos;
    let q = ratio * cos - 1.0;
    let r = INERTIA_RATIO + (q * q) / (p * p);
    let v = ((FRICTION * ratio * q * sin) / (p * p)).abs();
    let pose = Pose::new(&ratio, &Turn::from_radians(angle));
    let coefficients = Coefficients::of_pose(&pose, &INERTIA_RATIO, &FRICTION, &DRIVE);
    Start { p, q, r, v, acceleration: DRIVE / (r + v), pose, coefficients }
}

fn start_of(at: &Escapement) -> Start {
    start(at.centre_distance_ratio(), -at.driver_half_angle())
}

fn at_start(both: fn(&Start) -> (f64, f64)) -> Finding {
    let holds = Slots::ALL.iter().all(|slots| {
        let (a, b) = both(&start(slots.ratio(), -slots.engagement_half_angle()));
        vanishes((a - b) / a.abs().max(1.0))
    });
    Finding::new(holds, "at the entry of each of the three mechanisms")
}

/// Whether the first acceleration satisfies the equation of motion at this speed, and is the torque over the driver's
/// inertia.
pub fn start_solves(speed: f64) -> Finding {
    let holds = Slots::ALL.iter().all(|slots| {
        let found = start(slots.ratio(), -slots.engagement_half_angle());
        let solved = found.coefficients.acceleration(speed).map_or(f64::NAN, |solved| solved.value);
        agrees(found.acceleration, solved) && agrees(solved, DRIVE / INERTIA_RATIO)
    });
    Finding::new(holds, "the equation of motion at the start, from rest")
}
