//! From tan φ to the velocity and the acceleration of the follower, as identities.
//!
//! The left sides come from the pin's place as a power series in time, differentiated by its coefficients; the right
//! sides are the lines of the source. L stands for 1 + a² − 2 a cos θ and N for a cos θ − 1. Meyer 1973, from the
//! display after Eq. (1-6) to Eq. (1-8).

use super::Form;
use crate::pin_slot::{pin_from_pivot, velocity_ratio};
use crate::scalars::turn::angular_velocity;
use crate::{Field, Identity, Jet, Turn};
use nalgebra::Vector2;

/// The pin from the follower's axis in radii of its circle, as a series in time: (a − cos θ, sin θ).
fn pin<S: Field, const N: usize>(ratio: &S, theta: &Turn<Jet<S, N>>) -> Vector2<Jet<S, N>> {
    pin_from_pivot(&Jet::constant(ratio.clone()), theta)
}

/// φ̇ as a series. A proof stops with a panic, as at any pole, if the pin is on the follower's axis.
fn follower<S: Field, const N: usize>(ratio: &S, theta: &Turn<Jet<S, N>>) -> Jet<S, N> {
    angular_velocity(&pin(ratio, theta)).expect("the pin is off the follower's axis")
}

/// One line of the way to the velocity. Variables: a, the tangent of θ/2, θ̇.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VelocityStep {
    /// d(tan φ)/dt = [(a − cos θ) d(sin θ)/dt − sin θ d(a − cos θ)/dt] / (a − cos θ)².
    /// Meyer 1973, first display after Eq. (1-6). The left side divides the series of the pin's coordinates.
    QuotientRule,
    /// sec² φ φ̇ = [(a − cos θ) cos θ θ̇ − sin θ sin θ θ̇] / (a − cos θ)². Second display after Eq. (1-6).
    SecantSquared,
    /// (1 + tan² φ) φ̇ = (a cos θ − 1) / (a − cos θ)² θ̇. Third display after Eq. (1-6).
    OneAndTangentSquared,
    /// (1 + sin² θ / (a − cos θ)²) φ̇ = (a cos θ − 1) / (a − cos θ)² θ̇. Fourth display after Eq. (1-6).
    TangentSubstituted,
    /// φ̇ = (a cos θ − 1) / (1 + a² − 2 a cos θ) θ̇. Meyer 1973, Eq. (1-7).
    Velocity,
}

impl VelocityStep {
    /// All lines in the order of the source.
    pub const ALL: [Self; 5] =
        [Self::QuotientRule, Self::SecantSquared, Self::OneAndTangentSquared, Self::TangentSubstituted, Self::Velocity];
}

impl Identity<3> for VelocityStep {
    fn difference<S: Field>(&self, [ratio, half, speed]: &[S; 3]) -> S {
        let theta = Turn::from_half_tangent(half);
        let moving = theta.moving::<2>(speed.clone());
        let place = pin(ratio, &moving);
        let follower = || follower(ratio, &moving).value();
        let (x, y) = (place.x.value(), place.y.value());
        let square = |x: S| x.clone() * x;
        let (rest, sin, cos) = (ratio.clone() - theta.cos.clone(), theta.sin.clone(), theta.cos.clone());
        let reduced = || (ratio.clone() * cos.clone() - S::one()) / square(rest.clone()) * speed.clone();
        match self {
            Self::QuotientRule => {
                let above = rest.clone() * moving.sin.rate() - sin * (Jet::constant(ratio.clone()) - moving.cos).rate();
                (place.y.clone() / place.x.clone()).rate() - above / square(rest)
            }
            Self::SecantSquared => {
                let secant_squared = (square(x.clone()) + square(y)) / square(x);
                let above = rest.clone() * cos.clone() * speed.clone() - sin.clone() * (sin * speed.clone());
                secant_squared * follower() - above / square(rest)
            }
            Self::OneAndTangentSquared => (S::one() + square(y / x)) * follower() - reduced(),
            Self::TangentSubstituted => (S::one() + square(sin) / square(rest.clone())) * follower() - reduced(),
            Self::Velocity => follower() - velocity_ratio(ratio, &theta) * speed.clone(),
        }
    }
}

/// One line of the way to the acceleration. Variables: a, the tangent of θ/2, θ̇, θ̈.
///
/// L is taken from the pin's place as R²/r²; that this is 1 + a² − 2 a cos θ says
/// [`AngleStep::SlotRadiusByRoot`](super::angle_proofs::AngleStep::SlotRadiusByRoot). Both sides then have one
/// denominator, and few points prove them equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccelerationStep {
    /// φ̈ = [(L dN/dt − N dL/dt) / L²] θ̇ + (N / L) θ̈. Meyer 1973, first display after Eq. (1-7).
    QuotientRule,
    /// φ̈ = [(L (−a sin θ) θ̇ − N (2 a sin θ) θ̇) / L²] θ̇ + (N / L) θ̈. Meyer 1973, second display after Eq. (1-7).
    ///
    /// Printed with θ̈ on the left. The right side is correct as it stands.
    Differentiated(Form),
    /// φ̈ = a sin θ (1 − a²) / L² θ̇² + (N / L) θ̈. Meyer 1973, Eq. (1-8).
    ///
    /// Printed with θ̈ on the left. The right side is correct as it stands.
    Acceleration(Form),
}

impl AccelerationStep {
    /// All lines in the order of the source, those with a slip in both forms.
    pub const ALL: [Self; 5] = [
        Self::QuotientRule,
        Self::Differentiated(Form::Printed),
        Self::Differentiated(Form::Corrected),
        Self::Acceleration(Form::Printed),
        Self::Acceleration(Form::Corrected),
    ];
}

impl Identity<4> for AccelerationStep {
    fn difference<S: Field>(&self, [ratio, half, speed, gain]: &[S; 4]) -> S {
        let theta = Turn::from_half_tangent(half);
        let advance = Jet::<S, 3>::from_coefficients([S::zero(), speed.clone(), gain.clone() / S::integer(2)]);
        let moving = theta.moving_by(&advance);
        let place = pin(ratio, &moving);
        let (x, y) = (place.x.value(), place.y.value());
        let square = x.clone() * x + y.clone() * y;
        let over_fourth_power = |x: S| x / square.clone() / square.clone();
        let (a_sin, a_cos) = (ratio.clone() * theta.sin.clone(), ratio.clone() * theta.cos.clone());
        let above = a_cos - S::one();
        let by_gain = above.clone() / square.clone() * gain.clone();
        let right = match self {
            Self::QuotientRule => {
                let above_rate = (Jet::constant(ratio.clone()) * moving.cos.clone() - Jet::integer(1)).rate();
                let square_rate = (place.x.clone() * place.x.clone() + place.y.clone() * place.y.clone()).rate();
                let bracket = over_fourth_power(square.clone() * above_rate - above * square_rate);
                bracket * speed.clone() + by_gain
            }
            Self::Differentiated(_) => {
                let first = square.clone() * -a_sin.clone() * speed.clone();
                let second = above * (S::integer(2) * a_sin) * speed.clone();
                over_fourth_power(first - second) * speed.clone() + by_gain
            }
            Self::Acceleration(_) => {
                let shape = over_fourth_power(a_sin * (S::one() - ratio.clone() * ratio.clone()));
                shape * speed.clone() * speed.clone() + by_gain
            }
        };
        let left = match self {
            Self::Differentiated(Form::Printed) | Self::Acceleration(Form::Printed) => gain.clone(),
            _ => follower(ratio, &moving).rate(),
        };
        left - right
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prove;

    #[test]
    fn every_line_to_the_velocity_is_proven() {
        for step in VelocityStep::ALL {
            println!("{step:?}: {}", prove(&step).expect("an identity"));
        }
    }

    #[test]
    fn every_line_to_the_acceleration_is_proven_but_the_printed_slips() {
        for step in AccelerationStep::ALL {
            let slip = matches!(
                step,
                AccelerationStep::Differentiated(Form::Printed) | AccelerationStep::Acceleration(Form::Printed)
            );
            match prove(&step) {
                Ok(proof) => println!("{step:?}: {proof}"),
                Err(refutation) => println!("{step:?}: {refutation}"),
            }
            assert_eq!(prove(&step).is_err(), slip, "{step:?}");
        }
    }

    /// The second display after Eq. (1-7) with the other sign before the product that comes from dL/dt.
    struct OtherSign;

    impl Identity<4> for OtherSign {
        fn difference<S: Field>(&self, variables: &[S; 4]) -> S {
            let [ratio, half, speed, _] = variables.clone();
            let theta = Turn::from_half_tangent(&half);
            let square = crate::pin_slot::slot_radius_squared(&ratio, &theta);
            let product = (ratio.clone() * theta.cos - S::one()) * S::integer(2) * ratio * theta.sin;
            let twice = S::integer(2) * product * speed.clone() * speed / (square.clone() * square);
            AccelerationStep::Differentiated(Form::Corrected).difference(variables) - twice
        }
    }

    #[test]
    fn the_sign_of_the_second_product_is_right_as_printed() {
        assert!(prove(&OtherSign).is_err());
    }
}
