//! Identities that show why the flank is known beforehand, how speeds scale, and the limits of the equation.
//!
//! The factor of θ'', I_D/I_f + m q, is a variable instead of I_D/I_f, because it is divided by. p, q, m, the drive and
//! the drag torque are free: nothing depends on what they stand for.
//!
//! ```
//! use geneva_dynamics::joints::equation_proofs::{SwitchingFunctionDecidesFlank, SolutionObeys};
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&SolutionObeys).is_ok() && prove(&SwitchingFunctionDecidesFlank).is_ok());
//! ```

use super::{Reach, Terms};
use crate::{Coefficients, Pose, Sign};
use geneva_kinematics::{Expression, Identity};

fn terms([slope, leverage, ratio, bend, drive, drag]: [Expression; 6]) -> Terms<Expression> {
    Terms { inertia: slope - leverage * ratio, drive, drag, ratio, bend }
}

/// The solution obeys Newton's law for the driver: (I_D θ'' + m M − (K − G)) / I_f = 0.
///
/// Variables: factor of θ'', m, q, p, drive, drag torque, θ'².
pub struct SolutionObeys;

impl Identity<7> for SolutionObeys {
    fn difference(&self, [slope, leverage, ratio, bend, drive, drag, square]: [Expression; 7]) -> Expression {
        let terms = terms([slope, leverage, ratio, bend, drive, drag]);
        let angular_acceleration = terms.angular_acceleration(&square, &leverage);
        terms.inertia * angular_acceleration + leverage * terms.moment(&square, &angular_acceleration) - drive
    }
}

/// The factor of θ'' times the follower's moment is the switching function, in which m does not stand.
///
/// Variables: factor of θ'', m, q, p, drive, drag torque, θ'².
pub struct SwitchingFunctionDecidesFlank;

impl Identity<7> for SwitchingFunctionDecidesFlank {
    fn difference(&self, [slope, leverage, ratio, bend, drive, drag, square]: [Expression; 7]) -> Expression {
        let terms = terms([slope, leverage, ratio, bend, drive, drag]);
        let angular_acceleration = terms.angular_acceleration(&square, &leverage);
        slope * terms.moment(&square, &angular_acceleration) - terms.flank_switching_function(&square)
    }
}

/// Similarity: with drive, drag torque and θ'² times κ, θ'' and the number that decides the flank grow by κ.
///
/// So speeds go as √(K/I_f) if there is no constant torque, or one that grows with K. The arms of pin and journals
/// stand in m alone, which stays. Variables: factor of θ'', m, q, p, drive, drag torque, θ'², κ.
pub enum JointSimilarity {
    /// Of θ''.
    AngularAcceleration,
    /// Of the number that decides the flank.
    Flank,
}

impl Identity<8> for JointSimilarity {
    fn difference(&self, [slope, leverage, ratio, bend, drive, drag, square, kappa]: [Expression; 8]) -> Expression {
        let scaled = |number: Expression| kappa * number;
        let old = terms([slope, leverage, ratio, bend, drive, drag]);
        let new = terms([slope, leverage, ratio, bend, scaled(drive), scaled(drag)]);
        match self {
            Self::AngularAcceleration => {
                new.angular_acceleration(&scaled(square), &leverage)
                    - scaled(old.angular_acceleration(&square, &leverage))
            }
            Self::Flank => {
                new.flank_switching_function(&scaled(square)) - scaled(old.flank_switching_function(&square))
            }
        }
    }
}

/// For a pin that is a point and bearings without friction the equation is Eq. (1-19) of Meyer 1973.
///
/// Its left side less its right, with the sign S = s σ of the bars. Variables: R, h = a cos θ − 1, g = a sin θ, μ,
/// I_D/I_f, E, θ', θ''.
pub struct GoesOverToMeyer {
    /// The flank, s.
    pub flank: Sign,
    /// The sense of the sliding, σ.
    pub sliding: Sign,
}

impl Identity<8> for GoesOverToMeyer {
    fn difference(
        &self,
        [radius, numerator, cross, friction, inertia, drive, speed, angular_acceleration]: [Expression; 8],
    ) -> Expression {
        let pose = Pose::from_square(&radius.squared(), &numerator, &cross);
        let sign = self.flank.times(self.sliding);
        let meyer =
            Coefficients::from_pose(&pose, &inertia, &friction, &drive).residual(&speed, &angular_acceleration, sign);
        let reach = Reach { radius, ratio: pose.velocity_ratio(), slide: cross / radius };
        let arms = reach.arms(&Expression::ZERO, &friction, self.flank, self.sliding);
        let moment = pose.follower_acceleration(&speed, &angular_acceleration);
        inertia * angular_acceleration + arms.driver / arms.follower * moment - drive - meyer
    }
}
