//! Is each ratio the derivative of the one before?

use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::wheel::{acceleration_ratio, jerk_ratio};
use geneva_kinematics::{Jet, Rational, Turn, rational};

#[test]
fn each_ratio_is_the_derivative_of_the_one_before() {
    let (ratio, crank) = (rational(7, 4), Turn::<Rational>::from_half_tangent(&rational(1, 5)));
    let moving = crank.moving::<3>(rational(1, 1));
    let velocity = velocity_ratio(&Jet::constant(ratio.clone()), &moving);
    assert_eq!(velocity.derivative(1), Some(acceleration_ratio(&ratio, &crank)));
    assert_eq!(velocity.derivative(2), Some(jerk_ratio(&ratio, &crank)));
}
