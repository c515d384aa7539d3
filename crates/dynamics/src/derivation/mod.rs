//! Every display between Lagrange's equation and the equation of motion, against what is true of the moving mechanism.
//!
//! Meyer 1973, chapter I, Eqs. (1-9) to (1-19), and the steps of Appendices B and D. Each display is an
//! [`Identity`](geneva_kinematics::Identity). Where the print has a slip, the display takes a [`Form`]: as printed it
//! is refuted, put right it is proven. The other side is never the same formula: it is a derivative of the kinetic
//! energy along the motion, or the follower's acceleration from the moving pose, or the pin's place.
//!
//! **Units.** Lengths in crank radii, inertias in units of I_f, and the speed θ' = 1 at the instant, unless said
//! otherwise: every display is of one degree in θ'² and θ'', and of one degree in the inertias and the torque.
//!
//! **Variables.** R², h = a cos θ − 1 and g = a sin θ are free, with a² = R² + 2 h + 1, the law of cosines; they move
//! as (R²)' = 2 g θ', h' = −g θ', g' = (h + 1) θ'. That they also satisfy R² = h² + g² is nowhere needed. Where half
//! powers stand, R itself is the variable. That this bookkeeping is that of the pin is proven in
//! [`energy`]. A bar |x| stands as ± x, for both signs. A letter that is a slip for another is a variable
//! of its own.

mod contact;
mod force;
mod friction;
mod kinetic_energy;
mod momentum;
mod motion;
mod position;
mod singularity;

pub use contact::{
    BarsOpened, BarsReprinted, Demonstration, Opening, StartAtEntry, StartingAcceleration, StartingEquation,
    StartingLine,
};
pub use force::{
    ForceFromMoment, ForceSubstituted, FrictionOfMotion, FrictionSubstituted, MomentEquation, NormalForce,
};
pub use friction::{FrictionLine, FrictionTorque, MomentArm, SineOfFollower, SlotRadius, SlotRadiusBySines};
pub use kinetic_energy::{EnergyLine, KineticEnergy, LagrangeIsPower, Momentum};
pub use momentum::{MomentumLine, MomentumRate};
pub use motion::{Coefficient, CoefficientPrinted, EquationOfMotion, LeftSide, LeftSideLine, MotionLine};
pub use position::{PositionLine, PositionRate};
pub use singularity::{AtOne, BoundAsSquare, OffTheSingularity, SingularAngle};

use crate::{Pose, energy};
use geneva_kinematics::{Field, Jet};

/// How a display stands: with its slip, or without.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// As printed.
    Printed,
    /// Put right.
    Corrected,
}

impl Form {
    /// Both forms.
    pub const BOTH: [Self; 2] = [Self::Printed, Self::Corrected];

    fn pick<T>(self, printed: T, corrected: T) -> T {
        match self {
            Self::Printed => printed,
            Self::Corrected => corrected,
        }
    }
}

fn two<S: Field>() -> S {
    S::integer(2)
}

fn power<S: Field>(base: &S, exponent: u32) -> S {
    (0..exponent).fold(S::one(), |product, _| product * base.clone())
}

/// `value` divided so many times by `divisor`: one divisor, not a new one for each power.
fn over<S: Field>(value: S, divisor: &S, times: u32) -> S {
    (0..times).fold(value, |quotient, _| quotient / divisor.clone())
}

/// The pose while the driver turns at the speed one: h' = −g, g' = h + 1, (R²)' = 2 g.
fn turning<S: Field>(pose: &Pose<S>) -> Pose<Jet<S, 2>> {
    let (h, g) = (pose.lead.clone(), pose.cross.clone());
    Pose {
        lead: Jet::from_coefficients([h.clone(), -g.clone()]),
        cross: Jet::from_coefficients([g.clone(), h + S::one()]),
        square: Jet::from_coefficients([pose.square.clone(), two::<S>() * g]),
        shape: Jet::constant(pose.shape.clone()),
    }
}

/// φ'' over the motion, from φ' = θ' h/R² as a series.
fn follower_gain<S: Field>(pose: &Pose<S>, gain: &S) -> S {
    (turning(pose).velocity_ratio() * Jet::from_coefficients([S::one(), gain.clone()])).rate()
}

/// d/dt(∂T/∂θ') from the kinetic energy: its derivative with θ' as a series in time, and the rate of that.
fn momentum_rate<S: Field>(pose: &Pose<S>, gain: &S, inertia: &S) -> S {
    type Nested<S> = Jet<Jet<S, 2>, 2>;
    let ratio: Nested<S> = Jet::constant(turning(pose).velocity_ratio());
    let speed: Nested<S> = Jet::variable(Jet::from_coefficients([S::one(), gain.clone()]));
    energy::kinetic_energy(&ratio, &speed, &Jet::constant(Jet::constant(inertia.clone()))).rate().rate()
}

/// ∂T/∂θ from the kinetic energy, the speed kept.
fn position_rate<S: Field>(pose: &Pose<S>, inertia: &S) -> S {
    energy::kinetic_energy(&turning(pose).velocity_ratio(), &Jet::integer(1), &Jet::constant(inertia.clone())).rate()
}

/// dT/dt along the motion, which is Lagrange's left side at θ' = 1 ([`LagrangeIsPower`]).
fn growth<S: Field>(pose: &Pose<S>, gain: &S, inertia: &S) -> S {
    let speed = Jet::from_coefficients([S::one(), gain.clone()]);
    energy::kinetic_energy(&turning(pose).velocity_ratio(), &speed, &Jet::constant(inertia.clone())).rate()
}

/// Torque of the friction without its sign, μ N dR/dθ, from N R = φ'' and R dR/dθ = (R²)'/2.
fn friction_torque<S: Field>(pose: &Pose<S>, gain: &S, friction: &S) -> S {
    let sliding = turning(pose).square.rate() / two::<S>();
    friction.clone() * follower_gain(pose, gain) * sliding / pose.square.clone()
}

#[cfg(test)]
mod tests;
