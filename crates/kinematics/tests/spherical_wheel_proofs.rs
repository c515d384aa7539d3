//! Is every step to the spherical wheel's ratios proven, and a false one close to it refuted?

use geneva_kinematics::spherical_wheel::acceleration_ratio;
use geneva_kinematics::spherical_wheel_proofs::{
    BracesAtEntry, BracesRoot, SphericalEntryAcceleration, SphericalJerkBound, SphericalWheelFormula,
};
use geneva_kinematics::wheel_proofs::WheelQuantity;
use geneva_kinematics::{Expression, Identity, Turn, prove};

#[test]
fn every_step_to_the_ratios_and_their_peaks_is_proven() {
    let mut proofs =
        vec![prove(&SphericalEntryAcceleration), prove(&BracesAtEntry), prove(&BracesRoot), prove(&SphericalJerkBound)];
    proofs.extend(WheelQuantity::ALL.map(|quantity| prove(&SphericalWheelFormula(quantity))));
    for proof in proofs {
        println!("{}", proof.expect("an identity"));
    }
}

/// The planar wheel's acceleration at entry, tan α, a false neighbour, is refuted.
struct PlanarEntry;

impl Identity<1> for PlanarEntry {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let alpha = Turn::from_half_tangent(&half);
        let entry = Turn { cos: Expression::ZERO, sin: -Expression::ONE };
        acceleration_ratio(&(alpha.sin / alpha.cos), &entry) - alpha.sin / alpha.cos
    }
}

#[test]
fn entry_is_softer_than_that_of_a_planar_wheel() {
    assert!(prove(&PlanarEntry).is_err());
}
