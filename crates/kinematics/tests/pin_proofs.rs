//! Are the identities of the pin and its slot proven?

use geneva_kinematics::pin_proofs::SlotPointOnItsCircle;
use geneva_kinematics::pin_proofs::VelocityTriangle;
use geneva_kinematics::pin_proofs::{
    LawOfCosines, LawOfSines, PinSpeed, SlidesAlongTheSlot, SlidingSpeed, SlotPointMovesAcross, SlotPointSpeed,
    StandstillOfFourSlots, VelocityRatio, four_slot_entry_misfit,
};
use geneva_kinematics::{Field, Rational, Surd, prove, rational};

#[test]
fn all_identities_of_the_pin_are_proven() {
    let proofs = [
        prove(&LawOfCosines),
        prove(&LawOfSines),
        prove(&SlidesAlongTheSlot),
        prove(&SlotPointMovesAcross),
        prove(&PinSpeed),
        prove(&SlotPointSpeed),
        prove(&SlidingSpeed),
        prove(&VelocityRatio),
        prove(&VelocityTriangle { first: true }),
        prove(&VelocityTriangle { first: false }),
        prove(&SlotPointOnItsCircle),
    ];
    for proof in proofs {
        println!("{}", proof.expect("an identity"));
    }
    println!("{}", prove(&StandstillOfFourSlots).expect("an identity"));
}

#[test]
fn the_only_possible_ratio_of_four_slots_is_the_root_of_two() {
    type WithTwo = Surd<Rational, 2>;
    assert_eq!(four_slot_entry_misfit(&WithTwo::root()), WithTwo::integer(0));
    // The other positive root, k = 1, puts the pivot on the crank circle: no mechanism.
    assert_eq!(four_slot_entry_misfit(&rational(1, 1)), rational(0, 1));
    assert_ne!(four_slot_entry_misfit(&rational(2, 1)), rational(0, 1));
}
