//! Are the sign of the bars and the single solution proven?

use crate::proving::holds;
use geneva_dynamics::Sign;
use geneva_dynamics::equation_proofs::OneFormulaSolution;
use geneva_dynamics::equation_proofs::{
    SlopeOfOneSign, SolutionOfOneSign, SolutionsMeet, SwitchingFunctionDecidesSign,
};

#[test]
fn the_sign_and_the_single_solution_are_proven() {
    holds("solutions meet", &SolutionsMeet);
    for sign in Sign::BOTH {
        holds("solution", &SolutionOfOneSign(sign));
        holds("sign", &SwitchingFunctionDecidesSign(sign));
        holds("one formula", &OneFormulaSolution(sign));
        holds("slope", &SlopeOfOneSign(sign));
    }
}
