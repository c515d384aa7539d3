//! Is every line of the hand-over proven?

use geneva_kinematics::escapement::Form;
use geneva_kinematics::escapement::entry_proofs::{EntryTriangle, HalfAngle, PinsAndSlots};
use geneva_kinematics::{Expression, Identity, prove};

#[test]
fn every_line_of_the_hand_over_is_proven() {
    for step in [HalfAngle::Halved, HalfAngle::Simplified] {
        println!("{step:?}: {}", prove(&step).expect("an identity"));
    }
    use EntryTriangle::*;
    for step in [PinCircle, CentreDistance, Standstill, HalfTurn, QuarterTurn, SlotRadius, RimRadius] {
        println!("{step:?}: {}", prove(&step).expect("an identity"));
    }
    use PinsAndSlots::*;
    for step in [AngleSum, Pins, Factors, NeverTwo] {
        println!("{step:?}: {}", prove(&step).expect("an identity"));
    }
}

#[test]
fn the_unit_of_the_appendix_is_the_other_radius() {
    println!("{}", prove(&EntryTriangle::AppendixUnit(Form::Printed)).expect_err("R is not r"));
    println!("{}", prove(&EntryTriangle::AppendixUnit(Form::Corrected)).expect("an identity"));
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
