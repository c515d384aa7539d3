//! From tan φ to the velocity and the acceleration of the follower, as identities.
//!
//! The left sides come from the pin's place as a power series in time, differentiated by its coefficients; the right
//! sides are the lines of the source. L stands for 1 + a² − 2 a cos θ and N for a cos θ − 1. Meyer 1973, from the
//! display after Eq. (1-6) to Eq. (1-8).

use super::Form;
use crate::pin_slot::{pin_path, velocity_ratio};
use crate::wheel_proofs::wheel_velocity;
use crate::{Expression, Field, Identity, Jet, Turn};

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
    fn difference(&self, [ratio, half, speed]: [Expression; 3]) -> Expression {
        let theta = Turn::from_half_tangent(&half);
        let moving = theta.moving::<2>(speed);
        let place = pin_path(&ratio, &moving);
        let follower = wheel_velocity(ratio, &moving).value();
        let (x, y) = (place.x.value(), place.y.value());
        let (rest, sin, cos) = (ratio - theta.cos, theta.sin, theta.cos);
        let reduced = (ratio * cos - 1) / rest.squared() * speed;
        match self {
            Self::QuotientRule => {
                let above = rest * moving.sin.rate() - sin * (Jet::constant(ratio) - moving.cos).rate();
                (place.y / place.x).rate() - above / rest.squared()
            }
            Self::SecantSquared => {
                let secant_squared = (x.squared() + y.squared()) / x.squared();
                let above = rest * cos * speed - sin * (sin * speed);
                secant_squared * follower - above / rest.squared()
            }
            Self::OneAndTangentSquared => (1 + (y / x).squared()) * follower - reduced,
            Self::TangentSubstituted => (1 + sin.squared() / rest.squared()) * follower - reduced,
            Self::Velocity => follower - velocity_ratio(&ratio, &theta) * speed,
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
    fn difference(&self, [ratio, half, speed, angular_acceleration]: [Expression; 4]) -> Expression {
        let theta = Turn::from_half_tangent(&half);
        let moving = theta.speeding_up(speed, angular_acceleration);
        let place = pin_path(&ratio, &moving);
        let (x, y) = (place.x.value(), place.y.value());
        let square = x * x + y * y;
        let over_fourth_power = |x: Expression| x / square / square;
        let (a_sin, a_cos) = (ratio * theta.sin, ratio * theta.cos);
        let above = a_cos - 1;
        let by_gain = above / square * angular_acceleration;
        let right = match self {
            Self::QuotientRule => {
                let above_rate = (Jet::constant(ratio) * moving.cos - Jet::integer(1)).rate();
                let square_rate = (place.x * place.x + place.y * place.y).rate();
                let bracket = over_fourth_power(square * above_rate - above * square_rate);
                bracket * speed + by_gain
            }
            Self::Differentiated(_) => {
                let first = square * -a_sin * speed;
                let second = above * (2 * a_sin) * speed;
                over_fourth_power(first - second) * speed + by_gain
            }
            Self::Acceleration(_) => {
                let shape = over_fourth_power(a_sin * (1 - ratio * ratio));
                shape * speed * speed + by_gain
            }
        };
        let left = match self {
            Self::Differentiated(Form::Printed) | Self::Acceleration(Form::Printed) => angular_acceleration,
            _ => wheel_velocity(ratio, &moving).rate(),
        };
        left - right
    }
}
