//! Is √2 the only possible ratio of a follower with four slots?

use geneva_kinematics::pin_proofs::{StandstillOfFourSlots, four_slot_entry_misfit};
use geneva_kinematics::{Field, Rational, Surd, prove, rational};

#[test]
fn the_condition_for_a_standstill_is_proven() {
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
