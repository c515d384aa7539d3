//! Do the scalar equations hold, and do diagrams and series give one motion?

use geneva_kinematics::prove;
use geneva_kinematics::quick_return::proofs::{
    AcrossTheLever, AlongTheLever, Compared, DiagramAgainstSeries, LawOfSinesAtThePin, LeverAsProjections, Part,
    ResolvedBy, ResolvedSpeed, TermsOfTheAcceleration,
};

#[test]
fn the_scalar_equations_hold() {
    assert!(prove(&LawOfSinesAtThePin).is_ok() && prove(&LeverAsProjections).is_ok());
    assert!(prove(&AlongTheLever).is_ok() && prove(&AcrossTheLever).is_ok());
    for part in [Part::Across, Part::Along] {
        assert!(prove(&ResolvedSpeed { by: ResolvedBy::AngleAtPin, part }).is_ok(), "{part:?}");
        assert!(prove(&ResolvedSpeed { by: ResolvedBy::AngleAtAxis, part }).is_err(), "{part:?}");
    }
}

#[test]
fn coriolis_counts_twice_and_nothing_else_will_do() {
    for coriolis in -2..5 {
        assert_eq!(prove(&TermsOfTheAcceleration { coriolis }).is_ok(), coriolis == 2, "{coriolis}");
    }
}

#[test]
fn diagrams_and_series_give_one_motion() {
    use Compared::*;
    for compared in [LeverSpeed, LeverAcceleration, Sliding, SlidingAcceleration, Coriolis] {
        let proof = prove(&DiagramAgainstSeries(compared));
        assert!(proof.is_ok(), "{compared:?}: {proof:?}");
    }
}
