//! The kinetic energy, its derivative with the speed, and why Lagrange's equation holds here: up to Eq. (1-16).

use super::{Form, growth, momentum_rate, over, position_rate, power, two};
use crate::{Pose, energy};
use geneva_kinematics::{Field, Identity, Jet, Turn, angular_velocity, pin_slot};

/// Eqs. (1-9) and (1-10), the left side: (d/dt ∂T/∂θ' − ∂T/∂θ) θ' = dT/dt, so Q θ' is the power of all torques.
///
/// The three derivatives are taken of the same kinetic energy. Variables: R², h, g, θ'', I_D.
pub struct LagrangeIsPower;

impl Identity<5> for LagrangeIsPower {
    fn difference<S: Field>(&self, [square, lead, cross, gain, inertia]: &[S; 5]) -> S {
        let pose = Pose::from_square(square, lead, cross);
        momentum_rate(&pose, gain, inertia) - position_rate(&pose, inertia) - growth(&pose, gain, inertia)
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
    fn difference<S: Field>(&self, [p, q, inertia]: &[S; 3]) -> S {
        let crank = Turn { cos: p.clone(), sin: q.clone() };
        let place = pin_slot::pin_from_pivot(&Jet::integer(1), &crank.moving::<2>(S::one()));
        let (x, y) = (place.x.value(), place.y.value());
        let square = x.clone() * x.clone() + y.clone() * y;
        let turning = angular_velocity(&place).expect("the pin is off the follower's pivot").value();
        let half = |energy: S| energy / two::<S>();
        let truth = half(inertia.clone() + power(&turning, 2));
        let ratio_squared = power(&over(p.clone() - power(p, 2) - power(q, 2), &square, 1), 2);
        let display = match self.0 {
            EnergyLine::Members(form) => {
                let tangent = place.y.clone() / place.x.clone();
                let follower = form.pick(S::one(), tangent.rate() * x.clone() * x / square);
                half(inertia.clone()) + half(power(&follower, 2))
            }
            EnergyLine::Substituted => half(inertia.clone()) + half(ratio_squared),
            EnergyLine::Bracketed => half(inertia.clone() + ratio_squared),
        };
        truth - display
    }
}

/// ∂T/∂θ' = [I_D + (a cos θ − 1)²/R⁴ I_f] θ'. Variables: R², h, g, θ', I_D.
pub struct Momentum;

impl Identity<5> for Momentum {
    fn difference<S: Field>(&self, [square, lead, cross, speed, inertia]: &[S; 5]) -> S {
        let pose = Pose::from_square(square, lead, cross);
        let display = effective_inertia(&pose, inertia) * speed.clone();
        let still = pose.map(Jet::<S, 2>::constant);
        let moving = Jet::variable(speed.clone());
        energy::kinetic_energy(&still.velocity_ratio(), &moving, &Jet::constant(inertia.clone())).rate() - display
    }
}

/// I_D + (a cos θ − 1)²/R⁴ I_f, the brackets of Eq. (1-16).
pub(super) fn effective_inertia<S: Field>(pose: &Pose<S>, inertia: &S) -> S {
    inertia.clone() + over(power(&pose.lead, 2), &pose.square, 2)
}
