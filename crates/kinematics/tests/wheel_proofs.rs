//! Is every step to the wheel's ratios proven, and the lost sign refuted?

use geneva_kinematics::wheel_proofs::{
    AccelerationOfFour, Implemented, LoopClosure, OddAcceleration, Printed, Quantity, SlotEliminated,
    TangentDifferentiated, UnsteadyAcceleration, UnsteadyAccelerationOfFour, VelocityOfFour,
};
use geneva_kinematics::{prove, prove_with_root};

#[test]
fn every_step_to_the_ratios_is_proven() {
    let mut proofs = vec![
        prove(&LoopClosure { along: true }),
        prove(&LoopClosure { along: false }),
        prove(&SlotEliminated),
        prove_with_root::<2, 2>(&TangentDifferentiated),
        prove_with_root::<2, 2>(&VelocityOfFour),
        prove_with_root::<2, 3>(&UnsteadyAccelerationOfFour),
        prove_with_root::<2, 2>(&AccelerationOfFour { negative: true }),
        prove(&UnsteadyAcceleration),
        prove(&OddAcceleration),
    ];
    for quantity in Quantity::ALL {
        proofs.extend([prove(&Printed(quantity)), prove(&Implemented(quantity))]);
    }
    for proof in proofs {
        println!("{}", proof.expect("an identity"));
    }
}

#[test]
fn the_lost_sign_is_refuted() {
    assert!(prove_with_root::<2, 2>(&AccelerationOfFour { negative: false }).is_err());
}
