//! The escapement with real joints, compared with vectors and with the ideal escapement, and at the ends of its range.

mod contact_proofs;
mod equation_proofs;
mod laws;
mod limits;
mod routes;
mod steadiness;
mod vectors;

use geneva_dynamics::joints::{Escapement, Joints};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// An escapement with torque one and a follower's inertia of one.
fn parameters(mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> Parameters {
    let inertias = Inertias::new(inertia_ratio, 1.0).expect("sound inertias");
    Parameters::new(mechanism, inertias, 1.0, friction).expect("a sound escapement")
}

/// Escapements with inertias like those that the thesis ran, and a friction of a quarter.
fn like_the_thesis(mechanism: Mechanism) -> Parameters {
    let inertia_ratios = [6.0 / 10.0, 3.0 / 50.0, 3.0 / 40.0];
    parameters(mechanism, inertia_ratios[mechanism.index()], 1.0 / 4.0)
}

fn escapement(parameters: &Parameters, joints: Joints) -> Escapement {
    Escapement::new(parameters, joints).expect("a sound escapement")
}

/// Numbers from 0 to 1, spread evenly in every few of them, the same at every call.
struct Spread(f64);

impl Spread {
    fn next(&mut self) -> f64 {
        self.0 += 1.0;
        (self.0 * 0.618_033_988_749_895).fract() * 0.5 + (self.0 * self.0 * 0.414_213_562_373_095).fract() * 0.5
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Joints of all kinds, some of them without one part or another.
    fn joints(&mut self) -> Joints {
        let mut some = |most: f64| if self.next() < 0.2 { 0.0 } else { self.between(0.0, most) };
        Joints {
            pin_radius: some(0.3),
            driver_journal: some(0.3),
            follower_journal: some(0.2),
            bearing_friction: some(0.2),
            driver_drag_torque: some(0.3),
            follower_drag_torque: some(0.2),
        }
    }
}
