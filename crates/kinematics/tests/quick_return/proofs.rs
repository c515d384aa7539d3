//! Do diagrams and series give one motion?

use geneva_kinematics::prove;
use geneva_kinematics::quick_return::proofs::{DiagramAgainstSeries, LeverQuantity};

#[test]
fn diagrams_and_series_give_one_motion() {
    use LeverQuantity::*;
    for compared in [LeverSpeed, LeverAcceleration, Sliding, SlidingAcceleration, Coriolis] {
        let proof = prove(&DiagramAgainstSeries(compared));
        assert!(proof.is_ok(), "{compared:?}: {proof:?}");
    }
}
