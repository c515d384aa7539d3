//! Are the formulas of a wheel's motion proven?

use geneva_kinematics::prove;
use geneva_kinematics::wheel_proofs::{Implemented, OddAcceleration, Quantity, UnsteadyAcceleration};

#[test]
fn the_formulas_of_the_motion_are_proven() {
    let others = [prove(&UnsteadyAcceleration), prove(&OddAcceleration)];
    for proof in Quantity::ALL.map(|quantity| prove(&Implemented(quantity))).into_iter().chain(others) {
        println!("{}", proof.expect("an identity"));
    }
}
