//! Every step from the loop closure of a wheel to the place of its greatest acceleration, as identities.
//!
//! Notation as in [`wheel`](crate::wheel). Where an equation is for four stations, √2 is kept exact; where it is for
//! any number, α enters by the tangent of its half, so that sin α and cos α are rational. The left sides come from
//! power series of the pin's place, the right sides are the formulas. Work::Jazar2003, Eqs. (5.25) to (5.34).

use crate::scalars::turn::angular_velocity;
use crate::wheel::{acceleration_ratio, jerk_ratio, unsteady_acceleration};
use crate::{Field, Identity, IdentityWithRoot, Jet, Turn, pin_slot};
use nalgebra::Vector2;

/// The pin seen from the wheel's axis, as a series: (k − cos θ, sin θ) in crank radii, θ growing by `advance`.
fn pin<S: Field, const N: usize>(ratio: &S, crank: &Turn<S>, advance: &Jet<S, N>) -> Vector2<Jet<S, N>> {
    pin_slot::pin_from_pivot(&Jet::constant(ratio.clone()), &crank.moving_by(advance))
}

/// Angular velocity of the wheel as a series. A proof stops with a panic, as at any pole, if the pin is on the axis.
fn wheel_velocity<S: Field, const N: usize>(ratio: &S, crank: &Turn<S>, advance: &Jet<S, N>) -> Jet<S, N> {
    angular_velocity(&pin(ratio, crank, advance)).expect("the pin is off the wheel's axis")
}

/// A crank angle that grows at the speed one.
fn steady<S: Field, const N: usize>() -> Jet<S, N> {
    Jet::variable(S::zero())
}

/// Loop closure, Eq. (5.25), against the pin's place: what the two equations give is where the pin is.
///
/// From the first, x = sin θ / sin φ in crank radii; from the second, k = cos θ + x cos φ. The pin at this k and θ must be
/// at x (cos φ, sin φ). Variables: tangents of θ/2 and φ/2.
pub struct LoopClosure {
    /// Whether to compare along the line of centres or across it.
    pub along: bool,
}

impl Identity<2> for LoopClosure {
    fn difference<S: Field>(&self, [half_theta, half_phi]: &[S; 2]) -> S {
        let (theta, phi) = (Turn::from_half_tangent(half_theta), Turn::from_half_tangent(half_phi));
        let x = theta.sin.clone() / phi.sin.clone();
        let ratio = theta.cos.clone() + x.clone() * phi.cos.clone();
        let place = pin_slot::pin_from_pivot(&ratio, &theta) - phi.direction() * x;
        if self.along { place.x.clone() } else { place.y.clone() }
    }
}

/// cos θ + sin θ / tan φ = k, with tan φ from the pin's place. Variables: k and the tangent of θ/2.
pub struct SlotEliminated;

impl Identity<2> for SlotEliminated {
    fn difference<S: Field>(&self, [ratio, half]: &[S; 2]) -> S {
        let crank = Turn::from_half_tangent(half);
        let pin = pin_slot::pin_from_pivot(ratio, &crank);
        crank.cos + crank.sin * pin.x.clone() / pin.y.clone() - ratio.clone()
    }
}

/// φ̇ (1 + tan² φ) = θ̇ (k cos θ − 1) / (k − cos θ)², both factors on the left from power series.
///
/// For k = √2 the display after Eq. (5.27). Variables: tangent of θ/2, θ̇.
pub struct TangentDifferentiated;

impl IdentityWithRoot<2> for TangentDifferentiated {
    fn difference<S: Field>(&self, root: &S, [half, speed]: &[S; 2]) -> S {
        let crank = Turn::from_half_tangent(half);
        let advance = Jet::<S, 2>::from_coefficients([S::zero(), speed.clone()]);
        let place = pin(root, &crank, &advance);
        let tangent = place.y.value() / place.x.value();
        let left = wheel_velocity(root, &crank, &advance).value() * (S::one() + tangent.clone() * tangent);
        let rest = root.clone() - crank.cos.clone();
        left - speed.clone() * (root.clone() * crank.cos - S::one()) / (rest.clone() * rest)
    }
}

/// Eq. (5.28), four stations: φ̇ = θ̇ (√2 cos θ − 1) / (3 − 2√2 cos θ). Variables: tangent of θ/2, θ̇.
pub struct VelocityOfFour;

impl IdentityWithRoot<2> for VelocityOfFour {
    fn difference<S: Field>(&self, root: &S, [half, speed]: &[S; 2]) -> S {
        let crank = Turn::from_half_tangent(half);
        let advance = Jet::<S, 2>::from_coefficients([S::zero(), speed.clone()]);
        wheel_velocity(root, &crank, &advance).value() - speed.clone() * four_velocity(root, &crank)
    }
}

/// The display before Eq. (5.29), four stations, for a driver that speeds up:
/// φ̈ = θ̈ (√2 cos θ − 1)/(3 − 2√2 cos θ) − θ̇² √2 sin θ/(3 − 2√2 cos θ)². Variables: tangent of θ/2, θ̇, θ̈.
pub struct UnsteadyAccelerationOfFour;

impl IdentityWithRoot<3> for UnsteadyAccelerationOfFour {
    fn difference<S: Field>(&self, root: &S, [half, speed, gain]: &[S; 3]) -> S {
        let crank = Turn::from_half_tangent(half);
        let advance = Jet::<S, 3>::from_coefficients([S::zero(), speed.clone(), gain.clone() / S::integer(2)]);
        let printed = gain.clone() * four_velocity(root, &crank)
            - speed.clone() * speed.clone() * four_acceleration(root, &crank);
        wheel_velocity(root, &crank, &advance).rate() - printed
    }
}

/// Eq. (5.29), four stations, steady driver: φ̈ = ∓ θ̇² √2 sin θ/(3 − 2√2 cos θ)². Variables: tangent of θ/2, θ̇.
pub struct AccelerationOfFour {
    /// Whether the right side has the minus sign.
    pub negative: bool,
}

impl IdentityWithRoot<2> for AccelerationOfFour {
    fn difference<S: Field>(&self, root: &S, [half, speed]: &[S; 2]) -> S {
        let crank = Turn::from_half_tangent(half);
        let advance = Jet::<S, 3>::from_coefficients([S::zero(), speed.clone(), S::zero()]);
        let size = speed.clone() * speed.clone() * four_acceleration(root, &crank);
        let formula = if self.negative { -size } else { size };
        wheel_velocity(root, &crank, &advance).rate() - formula
    }
}

fn four_velocity<S: Field>(root: &S, crank: &Turn<S>) -> S {
    let product = root.clone() * crank.cos.clone();
    (product.clone() - S::one()) / (S::integer(3) - S::integer(2) * product)
}

fn four_acceleration<S: Field>(root: &S, crank: &Turn<S>) -> S {
    let square = S::integer(3) - S::integer(2) * root.clone() * crank.cos.clone();
    root.clone() * crank.sin.clone() / (square.clone() * square)
}

/// 1 + sin² α − 2 sin α cos θ.
fn denominator<S: Field>(alpha: &Turn<S>, crank: &Turn<S>) -> S {
    S::one() + alpha.sin.clone() * alpha.sin.clone() - S::integer(2) * alpha.sin.clone() * crank.cos.clone()
}

/// Which quantity of the motion an identity for any number of stations is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// tan φ, from Eq. (5.30).
    Tangent,
    /// φ̇ / θ̇, Eq. (5.31).
    Velocity,
    /// φ̈ / θ̇², Eq. (5.32).
    Acceleration,
    /// Its derivative over θ̇³, example (e).
    Jerk,
}

/// A printed formula in sin α and cos α against the power series of the pin's place, with k = 1 / sin α.
///
/// Variables: tangents of α/2 and θ/2.
pub struct Printed(
    /// The quantity.
    pub Quantity,
);

impl Identity<2> for Printed {
    fn difference<S: Field>(&self, [half_alpha, half_theta]: &[S; 2]) -> S {
        let (alpha, crank) = (Turn::from_half_tangent(half_alpha), Turn::from_half_tangent(half_theta));
        let ratio = S::one() / alpha.sin.clone();
        let (sin, cos) = (alpha.sin.clone(), alpha.cos.clone());
        let square = || denominator(&alpha, &crank);
        match self.0 {
            Quantity::Tangent => {
                let place = pin_slot::pin_from_pivot(&ratio, &crank);
                place.y.clone() / place.x.clone()
                    - sin.clone() * crank.sin.clone() / (S::one() - sin * crank.cos.clone())
            }
            Quantity::Velocity => {
                let series = wheel_velocity(&ratio, &crank, &steady::<S, 2>());
                series.value() - sin.clone() * (crank.cos.clone() - sin) / square()
            }
            Quantity::Acceleration => {
                let series = wheel_velocity(&ratio, &crank, &steady::<S, 3>());
                series.rate() + sin * cos.clone() * cos * crank.sin.clone() / (square() * square())
            }
            Quantity::Jerk => {
                let series = wheel_velocity(&ratio, &crank, &steady::<S, 4>());
                let braces =
                    square() * crank.cos.clone() - S::integer(4) * sin.clone() * crank.sin.clone() * crank.sin.clone();
                let printed = -(sin * cos.clone() * cos * braces) / (square() * square() * square());
                series.derivative(2).unwrap_or_else(S::zero) - printed
            }
        }
    }
}

/// The formulas of [`wheel`](crate::wheel) in k against the same power series. Variables: k, tangent of θ/2.
pub struct Implemented(
    /// The quantity.
    pub Quantity,
);

impl Identity<2> for Implemented {
    fn difference<S: Field>(&self, [ratio, half]: &[S; 2]) -> S {
        let crank = Turn::from_half_tangent(half);
        match self.0 {
            Quantity::Tangent => {
                let place = pin_slot::pin_from_pivot(ratio, &crank);
                place.y.clone() / place.x.clone() - crank.sin / (ratio.clone() - crank.cos)
            }
            Quantity::Velocity => {
                wheel_velocity(ratio, &crank, &steady::<S, 2>()).value() - pin_slot::velocity_ratio(ratio, &crank)
            }
            Quantity::Acceleration => {
                wheel_velocity(ratio, &crank, &steady::<S, 3>()).rate() - acceleration_ratio(ratio, &crank)
            }
            Quantity::Jerk => {
                let series = wheel_velocity(ratio, &crank, &steady::<S, 4>());
                series.derivative(2).unwrap_or_else(S::zero) - jerk_ratio(ratio, &crank)
            }
        }
    }
}

/// The acceleration is an odd function of the crank angle: f(θ) + f(−θ) = 0. Variables: k, tangent of θ/2.
pub struct OddAcceleration;

impl Identity<2> for OddAcceleration {
    fn difference<S: Field>(&self, [ratio, half]: &[S; 2]) -> S {
        let crank = Turn::from_half_tangent(half);
        acceleration_ratio(ratio, &crank) + acceleration_ratio(ratio, &crank.reversed())
    }
}

/// The acceleration for a driver that speeds up, any N, against power series. Variables: k, tangent of θ/2, θ̇, θ̈.
pub struct UnsteadyAcceleration;

impl Identity<4> for UnsteadyAcceleration {
    fn difference<S: Field>(&self, [ratio, half, speed, gain]: &[S; 4]) -> S {
        let crank = Turn::from_half_tangent(half);
        let advance = Jet::<S, 3>::from_coefficients([S::zero(), speed.clone(), gain.clone() / S::integer(2)]);
        wheel_velocity(ratio, &crank, &advance).rate() - unsteady_acceleration(ratio, &crank, speed, gain)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{prove, prove_with_root};

    #[test]
    fn every_step_to_the_ratios_is_proven() {
        let mut proofs = vec![
            prove(&LoopClosure { along: true }),
            prove(&LoopClosure { along: false }),
            prove(&SlotEliminated),
            prove_with_root::<2, 2>(&TangentDifferentiated),
            prove_with_root::<2, 2>(&VelocityOfFour),
            prove_with_root::<2, 3>(&UnsteadyAccelerationOfFour),
            prove_with_root::<2, 2>(&AccelerationOfFour { negative: true }),
            prove(&UnsteadyAcceleration),
            prove(&OddAcceleration),
        ];
        for quantity in [Quantity::Tangent, Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk] {
            proofs.extend([prove(&Printed(quantity)), prove(&Implemented(quantity))]);
        }
        for proof in proofs {
            println!("{}", proof.expect("an identity"));
        }
    }

    #[test]
    fn the_lost_sign_is_refuted() {
        assert!(prove_with_root::<2, 2>(&AccelerationOfFour { negative: false }).is_err());
    }
}
