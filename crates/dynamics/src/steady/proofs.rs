//! The identities on which the steady motion rests, for exact arithmetic.
//!
//! ρ, k, σ = ±μ, i = I_D/I_f and so on are as in [`steady`](crate::steady).

use crate::{Coefficients, Pose};
use geneva_kinematics::{Field, Identity, Jet, Turn};

/// The pose of a crank at centre distance over radius a, with its angle as a half tangent, moving at one radian.
fn moving<S: Field>(ratio: &S, half_tangent: &S) -> Pose<Jet<S, 3>> {
    let crank = Turn::from_half_tangent(half_tangent);
    Pose::new(ratio, &crank).moving_by(&Jet::variable(S::zero()))
}

/// (ρ, k) runs on a circle: (ρ − c)² + k² = c² a² with c = 1/(a² − 1). Variables: a, tan(θ/2).
pub struct OnACircle;

impl Identity<2> for OnACircle {
    fn difference<S: Field>(&self, [ratio, tangent]: &[S; 2]) -> S {
        let pose = Pose::new(ratio, &Turn::from_half_tangent(tangent));
        let centre = S::one() / (ratio.clone() * ratio.clone() - S::one());
        let (along, across) = (pose.velocity_ratio() - centre.clone(), pose.cross.clone() / pose.square.clone());
        let radius = centre * ratio.clone();
        along.clone() * along + across.clone() * across - radius.clone() * radius
    }
}

/// dρ/dθ = −k (1 + 2 ρ), and dk/dθ = (ρ − c)(1 + 2 ρ): the point turns by 1 + 2 ρ per radian. Variables: a, tan(θ/2).
pub struct TurningOnTheCircle {
    /// Whether it is about ρ, or about k.
    pub lead: bool,
}

impl Identity<2> for TurningOnTheCircle {
    fn difference<S: Field>(&self, [ratio, tangent]: &[S; 2]) -> S {
        let pose = moving(ratio, tangent);
        let (lead, slide) = (pose.velocity_ratio(), pose.cross.clone() / pose.square.clone());
        let turning = S::one() + S::integer(2) * lead.value();
        if self.lead {
            lead.rate() + slide.value() * turning
        } else {
            let centre = S::one() / (ratio.clone() * ratio.clone() - S::one());
            slide.rate() - (lead.value() - centre) * turning
        }
    }
}

/// A C u + D (E − B u) = μ k (i ρ' u + ρ E): what decides the sign of the friction. Variables: a, tan(θ/2), i, μ, E, θ'.
pub struct DeciderFactors;

impl Identity<6> for DeciderFactors {
    fn difference<S: Field>(&self, [ratio, tangent, inertia, friction, drive, speed]: &[S; 6]) -> S {
        let pose = Pose::new(ratio, &Turn::from_half_tangent(tangent));
        let coefficients = Coefficients::of_pose(&pose, inertia, friction, drive);
        let slide = friction.clone() * (pose.cross.clone() / pose.square.clone());
        let square = speed.clone() * speed.clone();
        let gain = inertia.clone() * pose.acceleration_ratio() * square + pose.velocity_ratio() * drive.clone();
        coefficients.sign_decider(speed) - slide * gain
    }
}

/// What two motions differ by decays at p = 2 (ρ + σ k) k/(i + ρ² + σ k ρ) per ψ: −2 (B + S C)/(A + S D)/(1 + 2 ρ).
///
/// With the sign plus; the other is μ → −μ. Variables: a, tan(θ/2), i, μ.
pub struct RateOfDecay;

impl Identity<4> for RateOfDecay {
    fn difference<S: Field>(&self, [ratio, tangent, inertia, friction]: &[S; 4]) -> S {
        let pose = Pose::new(ratio, &Turn::from_half_tangent(tangent));
        let of = Coefficients::of_pose(&pose, inertia, friction, &S::one());
        let (lead, slide) = (pose.velocity_ratio(), pose.cross.clone() / pose.square.clone());
        let both = lead.clone() + friction.clone() * slide.clone();
        let inert = inertia.clone() + lead.clone() * both.clone();
        let turning = S::one() + S::integer(2) * lead;
        S::integer(2) * both * slide / inert + S::integer(2) * (of.b + of.c) / ((of.a + of.d) * turning)
    }
}

/// p with the plus sign less p with the minus sign is 4 μ i k²/(A₊ A₋): the contraction. Times A₊ A₋, for it has poles
/// on the grid of a proof. Variables: ρ, k, i, μ.
pub struct Contraction;

impl Identity<4> for Contraction {
    fn difference<S: Field>(&self, [lead, slide, inertia, friction]: &[S; 4]) -> S {
        let [plus, minus] = [friction.clone(), -friction.clone()].map(|sigma| {
            let both = lead.clone() + sigma * slide.clone();
            let inert = inertia.clone() + lead.clone() * both.clone();
            (S::integer(2) * both * slide.clone(), inert)
        });
        let gap = S::integer(4) * friction.clone() * inertia.clone() * slide.clone() * slide.clone();
        plus.0 * minus.1 - minus.0 * plus.1 - gap
    }
}

/// Q = ρ/(k (1 + 2 ρ)), the u at which the sign switches, falls with ψ: −dQ/dψ k² (1 + 2 ρ)² = c + 2 c ρ − ρ² + (ρ − c) ρ
/// (1 + 2 ρ) on the circle. Variables: a, tan(θ/2).
pub struct SwitchFalls;

impl Identity<2> for SwitchFalls {
    fn difference<S: Field>(&self, [ratio, tangent]: &[S; 2]) -> S {
        let pose = moving(ratio, tangent);
        let (lead, slide) = (pose.velocity_ratio(), pose.cross.clone() / pose.square.clone());
        let one = Jet::constant(S::one());
        let turning = one + Jet::constant(S::integer(2)) * lead.clone();
        let switch = lead.clone() / (slide.clone() * turning.clone());
        let (lead, slide, turning) = (lead.value(), slide.value(), turning.value());
        let centre = S::one() / (ratio.clone() * ratio.clone() - S::one());
        let square = slide.clone() * turning.clone() * slide * turning.clone();
        let claimed = centre.clone() + S::integer(2) * centre.clone() * lead.clone() - lead.clone() * lead.clone()
            + (lead.clone() - centre) * lead * turning.clone();
        // A rate with θ is 1 + 2 ρ times the rate with ψ.
        switch.rate() * square + claimed * turning
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Slots;
    use crate::proving::holds;

    #[test]
    fn the_steady_motion_rests_on_identities() {
        holds("on a circle", &OnACircle);
        for lead in [true, false] {
            holds("turning on the circle", &TurningOnTheCircle { lead });
        }
        holds("decider", &DeciderFactors);
        holds("rate of decay", &RateOfDecay);
        holds("contraction", &Contraction);
        holds("switch falls", &SwitchFalls);
    }

    #[test]
    fn the_switch_falls_all_the_way() {
        // A cubic in ρ between 0 and its value on the line of centres, c (1 + a): positive by a fine net and its slope.
        for slots in Slots::ALL {
            let centre = 1.0 / (slots.ratio_squared() - 1.0);
            let end = centre * (1.0 + slots.ratio());
            let steps = 100_000;
            let width = end / f64::from(steps);
            let steepest = 2.0 * centre + 2.0 * end + (2.0 * end + centre) * (1.0 + 4.0 * end) + 4.0 * end * end;
            for step in 0..=steps {
                let lead = width * f64::from(step);
                let value = centre + 2.0 * centre * lead - lead * lead + (lead - centre) * lead * (1.0 + 2.0 * lead);
                assert!(value > steepest * width, "{slots:?} {lead} {value}");
            }
        }
    }
}
