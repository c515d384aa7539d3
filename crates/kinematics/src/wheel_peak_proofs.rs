//! From the derivative of the wheel's acceleration to the angle of its peak, as identities.
//!
//! Notation: s = sin α, c = cos θ, γ = (1 + s²)/(2 s), w = √(γ² + 8), which enters only by its square.
//! Work::Jazar2003, example (e), Eqs. (5.33) and (5.34).

use crate::{Field, Identity, Turn};

/// (1 + s² − 2 s cos θ) cos θ − 4 s sin² θ, the braces of the derivative, are the printed condition
/// (1 + s²) cos θ − 2 s cos² θ − 4 s sin² θ. Variables: s and the tangent of θ/2.
pub struct Condition;

impl Identity<2> for Condition {
    fn difference<S: Field>(&self, [sine, half]: &[S; 2]) -> S {
        let crank = Turn::from_half_tangent(half);
        let (c, two) = (crank.cos.clone(), S::integer(2));
        let one_and_square = S::one() + sine.clone() * sine.clone();
        let sines = S::integer(4) * sine.clone() * crank.sin.clone() * crank.sin;
        let braces = (one_and_square.clone() - two.clone() * sine.clone() * c.clone()) * c.clone() - sines.clone();
        braces - (one_and_square * c.clone() - two * sine.clone() * c.clone() * c - sines)
    }
}

/// sin² θ = 1 − cos² θ. Variable: the tangent of θ/2.
pub struct Pythagoras;

impl Identity<1> for Pythagoras {
    fn difference<S: Field>(&self, [half]: &[S; 1]) -> S {
        let crank = Turn::from_half_tangent(half);
        crank.sin.clone() * crank.sin - (S::one() - crank.cos.clone() * crank.cos)
    }
}

/// The condition with sin² θ replaced is 2 s (c² + γ c − 2). Variables: s and c.
pub struct Quadratic;

impl Identity<2> for Quadratic {
    fn difference<S: Field>(&self, [sine, cosine]: &[S; 2]) -> S {
        let (s, c, two) = (sine.clone(), cosine.clone(), S::integer(2));
        let one_and_square = S::one() + s.clone() * s.clone();
        let condition = one_and_square * c.clone()
            - two.clone() * s.clone() * c.clone() * c.clone()
            - S::integer(4) * s.clone() * (S::one() - c.clone() * c.clone());
        condition - two * s.clone() * quadratic(&c, &gamma(&s))
    }
}

/// (−γ ± w)/2 solves c² + γ c − 2 = 0: four times the left side is w² − γ² − 8. Variables: γ and w.
pub struct Roots {
    /// Whether w has the plus sign.
    pub plus: bool,
}

impl Identity<2> for Roots {
    fn difference<S: Field>(&self, [gamma, root]: &[S; 2]) -> S {
        let signed = if self.plus { root.clone() } else { -root.clone() };
        let cosine = (signed - gamma.clone()) / S::integer(2);
        let excess = root.clone() * root.clone() - gamma.clone() * gamma.clone() - S::integer(8);
        S::integer(4) * quadratic(&cosine, gamma) - excess
    }
}

/// At c = 1 the quadratic is γ − 1 = (1 − s)²/(2 s), which is positive: its root lies below one. Variable: s.
pub struct BelowOne;

impl Identity<1> for BelowOne {
    fn difference<S: Field>(&self, [sine]: &[S; 1]) -> S {
        let rest = S::one() - sine.clone();
        quadratic(&S::one(), &gamma(sine)) - rest.clone() * rest / (S::integer(2) * sine.clone())
    }
}

/// At c = sin α, where the pin enters, the quadratic is −3 (1 − s²)/2, which is negative: its root lies inside the
/// engagement. Variable: s.
pub struct InsideTheEngagement;

impl Identity<1> for InsideTheEngagement {
    fn difference<S: Field>(&self, [sine]: &[S; 1]) -> S {
        let square = S::one() - sine.clone() * sine.clone();
        quadratic(sine, &gamma(sine)) + S::integer(3) * square / S::integer(2)
    }
}

/// c² + γ c − 2.
fn quadratic<S: Field>(cosine: &S, gamma: &S) -> S {
    cosine.clone() * cosine.clone() + gamma.clone() * cosine.clone() - S::integer(2)
}

/// (1 + s²)/(2 s).
fn gamma<S: Field>(sine: &S) -> S {
    (S::one() + sine.clone() * sine.clone()) / (S::integer(2) * sine.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prove;

    #[test]
    fn every_step_to_the_peak_is_proven() {
        let proofs = [
            prove(&Condition),
            prove(&Pythagoras),
            prove(&Quadratic),
            prove(&Roots { plus: true }),
            prove(&Roots { plus: false }),
            prove(&BelowOne),
            prove(&InsideTheEngagement),
        ];
        for proof in proofs {
            println!("{}", proof.expect("an identity"));
        }
    }
}
