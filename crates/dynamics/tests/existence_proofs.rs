//! Is the algebra of the critical friction proven?

use crate::proving::holds;
use geneva_dynamics::existence_proofs::{
    Convexity, ConvexityFactors, CriticalDerivative, CriticalNumerator, HalfEngagement, KappaBelowTwo, Margin,
    MarginDerivative,
};

#[test]
fn the_algebra_of_existence_is_proven() {
    holds("R² in h", &HalfEngagement { radius: true });
    holds("a sin θ in h", &HalfEngagement { radius: false });
    holds("margin", &Margin);
    holds("critical numerator", &CriticalNumerator);
    holds("critical derivative", &CriticalDerivative);
    holds("convexity", &Convexity);
    holds("κ below two", &KappaBelowTwo);
    holds("factors", &ConvexityFactors);
    holds("margin derivative", &MarginDerivative);
}
