//! Is every line to the follower's velocity and acceleration proven but the printed slips?

use geneva_kinematics::escapement::Form;
use geneva_kinematics::escapement::rate_proofs::{AccelerationStep, VelocityStep};
use geneva_kinematics::{Expression, Identity, Turn, prove};

#[test]
fn every_line_to_the_velocity_is_proven() {
    for step in VelocityStep::ALL {
        println!("{step:?}: {}", prove(&step).expect("an identity"));
    }
}

#[test]
fn every_line_to_the_acceleration_is_proven_but_the_printed_slips() {
    for step in AccelerationStep::ALL {
        let slip = matches!(
            step,
            AccelerationStep::Differentiated(Form::Printed) | AccelerationStep::Acceleration(Form::Printed)
        );
        match prove(&step) {
            Ok(proof) => println!("{step:?}: {proof}"),
            Err(refutation) => println!("{step:?}: {refutation}"),
        }
        assert_eq!(prove(&step).is_err(), slip, "{step:?}");
    }
}

/// The second display after Eq. (1-7) with the other sign before the product that comes from dL/dt.
struct OtherSign;

impl Identity<4> for OtherSign {
    fn difference(&self, variables: [Expression; 4]) -> Expression {
        let [ratio, half, speed, _] = variables;
        let theta = Turn::from_half_tangent(&half);
        let square = geneva_kinematics::pin_slot::slot_radius_squared(&ratio, &theta);
        let product = (ratio * theta.cos - 1) * 2 * ratio * theta.sin;
        let twice = 2 * product * speed * speed / (square * square);
        AccelerationStep::Differentiated(Form::Corrected).difference(variables) - twice
    }
}

#[test]
fn the_sign_of_the_second_product_is_right_as_printed() {
    assert!(prove(&OtherSign).is_err());
}
