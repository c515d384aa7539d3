//! The kinetic energy, its derivative with the speed, and why Lagrange's equation holds here: up to Eq. (1-16).

use super::{Form, growth, momentum_rate, over, pose, position_rate, power};
use crate::{Pose, energy};
use geneva_kinematics::{Expression, Field, Identity, Jet, Turn, angular_velocity, pin_slot};

/// Eqs. (1-9) and (1-10), the left side: (d/dt ∂T/∂θ' − ∂T/∂θ) θ' = dT/dt, so Q θ' is the power of all torques.
///
/// The three derivatives are taken of the same kinetic energy. Variables: R², h, g, θ'', I_D.
pub struct LagrangeIsPower;

impl Identity<5> for LagrangeIsPower {
    fn difference(&self, [square, numerator, cross, angular_acceleration, inertia]: [Expression; 5]) -> Expression {
        let pose = pose(square, numerator, cross);
        momentum_rate(&pose, angular_acceleration, inertia)
            - position_rate(&pose, inertia)
            - growth(&pose, angular_acceleration, inertia)
    }
}

/// A display of the kinetic energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnergyLine {
    /// T = ½ I_D θ'² + ½ I_f φ'². The print has θ'² twice: the follower with the driver's speed.
    Members(Form),
    /// The display with Eq. (1-7) put in.
    Substituted,
    /// Eq. (1-16).
    Bracketed,
}

/// The displays of T against the speeds of crank and slot, from the pin's place; θ' = 1.
///
/// φ' is the rate of tan φ times cos² φ. Variables: p = (r/c) cos θ and q = (r/c) sin θ, in units of the centre
/// distance; I_D. Then (a cos θ − 1)/(1 + a² − 2 a cos θ) is (p − p² − q²)/R².
pub struct KineticEnergy(
    /// Which display.
    pub EnergyLine,
);

impl Identity<3> for KineticEnergy {
    fn difference(&self, [p, q, inertia]: [Expression; 3]) -> Expression {
        let crank = Turn { cos: p, sin: q };
        let place = pin_slot::pin_from_pivot(&Jet::integer(1), &crank.moving::<2>(Expression::ONE));
        let (x, y) = (place.x.value(), place.y.value());
        let square = x * x + y * y;
        let turning = angular_velocity(&place).expect("the pin is off the follower's pivot").value();
        let half = |energy: Expression| energy / 2;
        let truth = half(inertia + power(turning, 2));
        let ratio_squared = power(over(p - power(p, 2) - power(q, 2), square, 1), 2);
        let display = match self.0 {
            EnergyLine::Members(form) => {
                let tangent = place.y / place.x;
                let follower = form.pick(Expression::ONE, tangent.rate() * x * x / square);
                half(inertia) + half(power(follower, 2))
            }
            EnergyLine::Substituted => half(inertia) + half(ratio_squared),
            EnergyLine::Bracketed => half(inertia + ratio_squared),
        };
        truth - display
    }
}

/// ∂T/∂θ' = [I_D + (a cos θ − 1)²/R⁴ I_f] θ'. Variables: R², h, g, θ', I_D.
pub struct Momentum;

impl Identity<5> for Momentum {
    fn difference(&self, [square, numerator, cross, speed, inertia]: [Expression; 5]) -> Expression {
        let pose = pose(square, numerator, cross);
        let display = effective_inertia(&pose, inertia) * speed;
        let still = pose.map(Jet::<_, 2>::constant);
        let moving = Jet::variable(speed);
        energy::kinetic_energy(&still.velocity_ratio(), &moving, &Jet::constant(inertia)).rate() - display
    }
}

/// I_D + (a cos θ − 1)²/R⁴ I_f, the brackets of Eq. (1-16).
pub(super) fn effective_inertia<S: Field + Copy>(pose: &Pose<S>, inertia: S) -> S {
    inertia + over(power(pose.numerator, 2), pose.square, 2)
}
