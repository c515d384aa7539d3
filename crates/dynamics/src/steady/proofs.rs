//! The identities on which the steady motion rests, for exact arithmetic.
//!
//! ρ, k, σ = ±μ, i = I_D/I_f and so on are as in [`steady`](crate::steady).
//!
//! ```
//! use geneva_dynamics::steady::proofs::{Multiplier, OnACircle};
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&OnACircle).is_ok() && prove(&Multiplier).is_ok());
//! ```

use crate::{Coefficients, Pose};
use geneva_kinematics::{Expression, Field, Identity, Jet, Turn};

/// The pose of a crank at centre distance over radius a, with its angle as a half tangent, moving at one radian.
fn moving(ratio: Expression, half_tangent: Expression) -> Pose<Jet<Expression, 3>> {
    let crank = Turn::from_half_tangent(&half_tangent);
    Pose::new(&ratio, &crank).moving_by(&Jet::variable(Expression::ZERO))
}

/// (ρ, k) runs on a circle: (ρ − c)² + k² = c² a² with c = 1/(a² − 1). Variables: a, tan(θ/2).
pub struct OnACircle;

impl Identity<2> for OnACircle {
    fn difference(&self, [ratio, tangent]: [Expression; 2]) -> Expression {
        let pose = Pose::new(&ratio, &Turn::from_half_tangent(&tangent));
        let centre = 1 / (ratio * ratio - 1);
        let (along, across) = (pose.velocity_ratio() - centre, pose.k_sin_theta / pose.radius_squared);
        let radius = centre * ratio;
        along * along + across * across - radius * radius
    }
}

/// dρ/dθ = −k (1 + 2 ρ), and dk/dθ = (ρ − c)(1 + 2 ρ): the point turns by 1 + 2 ρ per radian. Variables: a, tan(θ/2).
pub struct TurningOnTheCircle {
    /// Whether it is about ρ, or about k.
    pub numerator: bool,
}

impl Identity<2> for TurningOnTheCircle {
    fn difference(&self, [ratio, tangent]: [Expression; 2]) -> Expression {
        let pose = moving(ratio, tangent);
        let (numerator, slide) = (pose.velocity_ratio(), pose.k_sin_theta / pose.radius_squared);
        let turning = 1 + 2 * numerator.value();
        if self.numerator {
            numerator.rate() + slide.value() * turning
        } else {
            let centre = 1 / (ratio * ratio - 1);
            slide.rate() - (numerator.value() - centre) * turning
        }
    }
}

/// A C u + D (E − B u) = μ k (i ρ' u + ρ E): what decides the sign of the friction. Variables: a, tan(θ/2), i, μ, E,
/// θ'.
pub struct SwitchingFactors;

impl Identity<6> for SwitchingFactors {
    fn difference(&self, [ratio, tangent, inertia, friction, drive, speed]: [Expression; 6]) -> Expression {
        let pose = Pose::new(&ratio, &Turn::from_half_tangent(&tangent));
        let coefficients = Coefficients::from_pose(&pose, &inertia, &friction, &drive);
        let slide = friction * (pose.k_sin_theta / pose.radius_squared);
        let square = speed * speed;
        let angular_acceleration = inertia * pose.acceleration_ratio() * square + pose.velocity_ratio() * drive;
        coefficients.sign_switching_function(&speed) - slide * angular_acceleration
    }
}

/// Rate at which the difference of two motions decays:
/// p = 2 (ρ + σ k) k/(i + ρ² + σ k ρ) per ψ: −2 (B + S C)/(A + S D)/(1 + 2 ρ).
///
/// With the sign plus; the other is μ → −μ. Variables: a, tan(θ/2), i, μ.
pub struct RateOfDecay;

impl Identity<4> for RateOfDecay {
    fn difference(&self, [ratio, tangent, inertia, friction]: [Expression; 4]) -> Expression {
        let pose = Pose::new(&ratio, &Turn::from_half_tangent(&tangent));
        let of = Coefficients::from_pose(&pose, &inertia, &friction, &Expression::ONE);
        let (numerator, slide) = (pose.velocity_ratio(), pose.k_sin_theta / pose.radius_squared);
        let both = numerator + friction * slide;
        let inert = inertia + numerator * both;
        let turning = 1 + 2 * numerator;
        2 * both * slide / inert + 2 * (of.b + of.c) / ((of.a + of.d) * turning)
    }
}

/// p with the plus sign less p with the minus sign is 4 μ i k²/(A₊ A₋): the multiplier. Times A₊ A₋, for it has poles
/// on the grid of a proof. Variables: ρ, k, i, μ.
pub struct Multiplier;

impl Identity<4> for Multiplier {
    fn difference(&self, [numerator, slide, inertia, friction]: [Expression; 4]) -> Expression {
        let [plus, minus] = [friction, -friction].map(|sigma| {
            let both = numerator + sigma * slide;
            let inert = inertia + numerator * both;
            (2 * both * slide, inert)
        });
        let gap = 4 * friction * inertia * slide * slide;
        plus.0 * minus.1 - minus.0 * plus.1 - gap
    }
}

/// Q = ρ/(k (1 + 2 ρ)), the u at which the sign switches, falls with ψ: −dQ/dψ k² (1 + 2 ρ)² = c + 2 c ρ − ρ² + (ρ − c)
/// ρ (1 + 2 ρ) on the circle. Variables: a, tan(θ/2).
pub struct SwitchingFunctionFalls;

impl Identity<2> for SwitchingFunctionFalls {
    fn difference(&self, [ratio, tangent]: [Expression; 2]) -> Expression {
        let pose = moving(ratio, tangent);
        let (numerator, slide) = (pose.velocity_ratio(), pose.k_sin_theta / pose.radius_squared);
        let turning = Jet::integer(1) + Jet::integer(2) * numerator;
        let reversal = numerator / (slide * turning);
        let (numerator, slide, turning) = (numerator.value(), slide.value(), turning.value());
        let centre = 1 / (ratio * ratio - 1);
        let square = slide * turning * slide * turning;
        let claimed =
            centre + 2 * centre * numerator - numerator * numerator + (numerator - centre) * numerator * turning;
        // A rate with θ is 1 + 2 ρ times the rate with ψ.
        reversal.rate() * square + claimed * turning
    }
}
