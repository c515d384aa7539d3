//! Is every step to the peak of the acceleration proven?

use geneva_kinematics::prove;
use geneva_kinematics::wheel_peak_proofs::{BelowOne, Condition, InsideTheEngagement, Pythagoras, Quadratic, Roots};

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
