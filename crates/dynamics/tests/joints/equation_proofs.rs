//! Is the flank known beforehand, and does the equation without sizes become the equation of the thesis?

use crate::proving::holds;
use geneva_dynamics::Sign;
use geneva_dynamics::joints::equation_proofs::{
    GoesOverToMeyer, JointSimilarity, SolutionObeys, SwitchingFunctionDecidesFlank,
};

#[test]
fn the_flank_is_told_beforehand_and_the_ideal_is_the_thesis() {
    holds("similarity", &JointSimilarity::AngularAcceleration);
    holds("similarity of the flank", &JointSimilarity::Flank);
    holds("solution", &SolutionObeys);
    holds("flank", &SwitchingFunctionDecidesFlank);
    for flank in Sign::BOTH {
        for sliding in Sign::BOTH {
            holds("ideal", &GoesOverToMeyer { flank, sliding });
        }
    }
}
