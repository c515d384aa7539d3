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

pub use geneva_kinematics::Form;

use crate::{Pose, energy};
use geneva_kinematics::{Expression, Field, Jet};

fn power<S: Field + Copy>(base: S, exponent: u32) -> S {
    (0..exponent).fold(S::one(), |product, _| product * base)
}

/// `value` divided so many times by `divisor`: one divisor, not a new one for each power.
fn over<S: Field + Copy>(value: S, divisor: S, times: u32) -> S {
    (0..times).fold(value, |quotient, _| quotient / divisor)
}

/// The pose from R², h and g.
fn pose(square: Expression, numerator: Expression, cross: Expression) -> Pose<Expression> {
    Pose::from_square(&square, &numerator, &cross)
}

/// The pose while the driver turns at the speed one: h' = −g, g' = h + 1, (R²)' = 2 g.
fn turning<S: Field + Copy>(pose: &Pose<S>) -> Pose<Jet<S, 2>> {
    let (h, g) = (pose.numerator, pose.cross);
    Pose {
        numerator: Jet::from_coefficients([h, -g]),
        cross: Jet::from_coefficients([g, h + S::one()]),
        square: Jet::from_coefficients([pose.square, S::integer(2) * g]),
        shape: Jet::constant(pose.shape),
    }
}

/// The speed θ' = 1 while it grows at θ''.
fn speed(angular_acceleration: Expression) -> Jet<Expression, 2> {
    Jet::from_coefficients([Expression::ONE, angular_acceleration])
}

/// φ'' over the motion, from φ' = θ' h/R² as a series.
fn follower_acceleration(pose: &Pose<Expression>, angular_acceleration: Expression) -> Expression {
    (turning(pose).velocity_ratio() * speed(angular_acceleration)).rate()
}

/// d/dt(∂T/∂θ') from the kinetic energy: its derivative with θ' as a series in time, and the rate of that.
fn momentum_rate(pose: &Pose<Expression>, angular_acceleration: Expression, inertia: Expression) -> Expression {
    let ratio: Jet<_, 2> = Jet::constant(turning(pose).velocity_ratio());
    energy::kinetic_energy(&ratio, &Jet::variable(speed(angular_acceleration)), &Jet::constant(Jet::constant(inertia)))
        .rate()
        .rate()
}

/// ∂T/∂θ from the kinetic energy, the speed kept.
fn position_rate(pose: &Pose<Expression>, inertia: Expression) -> Expression {
    energy::kinetic_energy(&turning(pose).velocity_ratio(), &Jet::integer(1), &Jet::constant(inertia)).rate()
}

/// dT/dt along the motion, which is Lagrange's left side at θ' = 1 ([`LagrangeIsPower`]).
fn growth(pose: &Pose<Expression>, angular_acceleration: Expression, inertia: Expression) -> Expression {
    energy::kinetic_energy(&turning(pose).velocity_ratio(), &speed(angular_acceleration), &Jet::constant(inertia))
        .rate()
}

/// Torque of the friction without its sign, μ N dR/dθ, from N R = φ'' and R dR/dθ = (R²)'/2.
fn friction_torque(pose: &Pose<Expression>, angular_acceleration: Expression, friction: Expression) -> Expression {
    let sliding = turning(pose).square.rate() / 2;
    friction * follower_acceleration(pose, angular_acceleration) * sliding / pose.square
}

#[cfg(test)]
mod tests;
