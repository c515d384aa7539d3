//! Is every step to the internal wheel's ratios proven, and a false one close to it refuted?

use geneva_kinematics::internal_wheel::velocity_ratio;
use geneva_kinematics::internal_wheel_proofs::{
    BracesArePositive, InternalEntryAcceleration, InternalWheelFormula, JerkRate, JerkRoot,
};
use geneva_kinematics::wheel_proofs::WheelQuantity;
use geneva_kinematics::{Expression, Identity, Turn, prove};

#[test]
fn every_step_to_the_ratios_and_their_peaks_is_proven() {
    let mut proofs =
        vec![prove(&BracesArePositive), prove(&InternalEntryAcceleration), prove(&JerkRate), prove(&JerkRoot)];
    proofs.extend(WheelQuantity::ALL.map(|quantity| prove(&InternalWheelFormula(quantity))));
    for proof in proofs {
        println!("{}", proof.expect("an identity"));
    }
}

/// The external wheel's velocity, a false neighbour, is refuted.
struct External;

impl Identity<2> for External {
    fn difference(&self, [m, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        velocity_ratio(&m, &crank) - m * (crank.cos - m) / (1 + m * m - 2 * m * crank.cos)
    }
}

#[test]
fn the_external_wheel_moves_otherwise() {
    assert!(prove(&External).is_err());
}
