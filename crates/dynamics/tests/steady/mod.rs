//! The steady motion, compared with other routes to it, and at the ends of its range.

mod accuracy;
mod circle;
mod exponential;
mod largest_printed;
mod laws;
mod limits;
mod proofs;
mod quadrature;
mod rise;
mod routes;
mod terminal;

use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// An escapement with torque one and a follower's inertia of one.
pub(crate) fn escapement(mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> Parameters {
    let inertias = Inertias::new(inertia_ratio, 1.0).expect("sound inertias");
    Parameters::new(mechanism, inertias, 1.0, friction).expect("a sound escapement")
}

/// Escapements of all kinds, with their engagement as it is, or reset sooner or later.
pub(crate) fn samples() -> Vec<Engagement> {
    let mut samples = Vec::new();
    for mechanism in Mechanism::ALL {
        for (inertia, friction) in [(0.07, 0.21), (0.7, 0.33), (0.7, 0.11), (3.0, 0.4)] {
            let escapement = escapement(mechanism, inertia, friction);
            let natural = 2.0 * mechanism.engagement_half_angle();
            samples.push(Engagement::new(&escapement).expect("an engagement"));
            for part in [0.3, 0.5, 0.6, 0.8, 1.1, 1.3] {
                let reset = Engagement::reset_after(&escapement, natural * part, 1e-12);
                samples.push(reset.expect("a reset angle in range"));
            }
        }
    }
    samples
}
