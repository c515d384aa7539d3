//! The law of similarity: how speed and time scale with the torque.
//!
//! Eq. (1-19) is linear in θ'', θ'² and E. If θ' grows by a factor κ while θ'' and E = K/I_f grow by κ², it holds as
//! before, with the same sign of the friction. So with the inertias and the friction kept, speeds go as √(K/I_f) and
//! times as its inverse; only the number of slots, μ and I_D/I_f shape the motion.

use crate::{Coefficients, Sign};
use geneva_kinematics::{Expression, Identity};

/// The factors of speed, acceleration and time when E = K/I_f grows by a factor.
///
/// ```
/// use geneva_dynamics::similarity::Scaling;
///
/// // Four times the torque on the same inertias: twice the speed, half the time.
/// let scaling = Scaling::from_drives(1.0, 4.0).expect("positive torques");
/// assert_eq!((scaling.speed, scaling.acceleration, scaling.time), (2.0, 4.0, 0.5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaling {
    /// Factor of all angular speeds, dimensionless.
    pub speed: f64,
    /// Factor of all angular accelerations, dimensionless.
    pub acceleration: f64,
    /// Factor of all times, dimensionless.
    pub time: f64,
}

impl Scaling {
    /// The scale factor from the old and the new K/I_f; `None` unless their quotient is positive and finite.
    pub fn from_drives(old: f64, new: f64) -> Option<Self> {
        let acceleration = new / old;
        let speed = acceleration.sqrt();
        (acceleration > 0.0 && acceleration.is_finite()).then_some(Self { speed, acceleration, time: 1.0 / speed })
    }
}

/// The equation with θ', θ'', E scaled by κ, κ², κ² is κ² times the equation. Variables: A to E, θ', θ'', κ.
pub struct Similarity(
    /// The sign of the bars.
    pub Sign,
);

impl Identity<8> for Similarity {
    fn difference(&self, [a, b, c, d, e, speed, angular_acceleration, kappa]: [Expression; 8]) -> Expression {
        let square = kappa * kappa;
        let with = |e: Expression| Coefficients { a, b, c, d, e };
        let scaled = with(square * e).residual(&(kappa * speed), &(square * angular_acceleration), self.0);
        scaled - square * with(e).residual(&speed, &angular_acceleration, self.0)
    }
}

/// Similarity of the sign: what decides the sign of the friction scales by κ² too, so the sign stays.
/// Variables: A to E, θ', κ.
pub struct SimilarityOfTheSign;

impl Identity<7> for SimilarityOfTheSign {
    fn difference(&self, [a, b, c, d, e, speed, kappa]: [Expression; 7]) -> Expression {
        let square = kappa * kappa;
        let with = |e: Expression| Coefficients { a, b, c, d, e };
        let scaled = with(square * e).sign_switching_function(&(kappa * speed));
        scaled - square * with(e).sign_switching_function(&speed)
    }
}
