//! Do the scalar equations hold, and do diagrams and series give one motion?

use geneva_kinematics::prove;
use geneva_kinematics::quick_return::proofs::CoriolisMagnitude;
use geneva_kinematics::quick_return::proofs::TermsInAnySlot;
use geneva_kinematics::quick_return::proofs::TermsOfTheVelocity;
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
        for first in [true, false] {
            assert_eq!(prove(&TermsOfTheAcceleration { first, coriolis }).is_ok(), coriolis == 2, "{coriolis}");
            assert_eq!(prove(&TermsInAnySlot { first, coriolis }).is_ok(), coriolis == 2, "{coriolis}");
        }
        assert_eq!(prove(&CoriolisMagnitude { coriolis }).is_ok(), coriolis.abs() == 2, "{coriolis}");
    }
}

#[test]
fn the_velocity_has_two_terms_in_both_components() {
    for first in [true, false] {
        assert!(prove(&TermsOfTheVelocity { first }).is_ok());
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
