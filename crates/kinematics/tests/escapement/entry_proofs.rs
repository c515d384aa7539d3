//! Is it proven which numbers of pins and slots are possible?

use geneva_kinematics::escapement::entry_proofs::PinsAndSlots;
use geneva_kinematics::{Expression, Identity, prove};

#[test]
fn the_numbers_of_pins_and_slots_are_proven() {
    use PinsAndSlots::*;
    for step in [Factors, NeverTwo] {
        println!("{step:?}: {}", prove(&step).expect("an identity"));
    }
}

/// The sum of the angles with a wrong remainder: the proof must see it.
struct Perturbed;

impl Identity<2> for Perturbed {
    fn difference(&self, variables: [Expression; 2]) -> Expression {
        PinsAndSlots::Factors.difference(variables) + Expression::ONE / 1_000_000
    }
}

#[test]
fn a_millionth_is_noticed() {
    assert!(prove(&Perturbed).is_err());
}
