//! Are the formulas of a wheel's motion proven?

use geneva_kinematics::prove;
use geneva_kinematics::wheel_proofs::{OddAcceleration, UnsteadyAcceleration, WheelFormula, WheelQuantity};

#[test]
fn the_formulas_of_the_motion_are_proven() {
    let others = [prove(&UnsteadyAcceleration), prove(&OddAcceleration)];
    for proof in WheelQuantity::ALL.map(|quantity| prove(&WheelFormula(quantity))).into_iter().chain(others) {
        println!("{}", proof.expect("an identity"));
    }
}
