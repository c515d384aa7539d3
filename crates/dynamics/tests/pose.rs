//! Does a pose have the rates of the pin in its slot, and does it move as its angle does?

use geneva_dynamics::Pose;
use geneva_kinematics::{Jet, Rational, Turn, pin_slot, rational, wheel};

#[test]
fn the_rates_are_those_of_the_pin_in_a_slot() {
    let (ratio, crank) = (rational(7, 4), Turn::<Rational>::from_half_tangent(&rational(-1, 5)));
    let pose = Pose::new(&ratio, &crank);
    assert_eq!(pose.velocity_ratio(), pin_slot::velocity_ratio(&ratio, &crank));
    assert_eq!(pose.acceleration_ratio(), wheel::acceleration_ratio(&ratio, &crank));
    let (speed, angular_acceleration) = (rational(3, 2), rational(-5, 7));
    let both = wheel::unsteady_acceleration(&ratio, &crank, &speed, &angular_acceleration);
    assert_eq!(pose.follower_acceleration(&speed, &angular_acceleration), both);
}

#[test]
fn a_pose_moves_as_its_angle_does() {
    let (ratio, crank) = (rational(9, 5), Turn::<Rational>::from_half_tangent(&rational(2, 7)));
    let advance = Jet::<Rational, 4>::from_coefficients([0, 3, -2, 5].map(|n| rational(n, 1)));
    let moving = Pose::new(&Jet::constant(ratio.clone()), &crank.moving_by(&advance));
    assert_eq!(Pose::new(&ratio, &crank).moving_by(&advance), moving);
}

#[test]
fn three_numbers_of_a_pose_give_the_fourth() {
    let pose = Pose::new(&rational(9, 5), &Turn::from_half_tangent(&rational(2, 7)));
    assert_eq!(Pose::from_square(&pose.radius_squared, &pose.numerator, &pose.k_sin_theta), pose);
    let sum = pose.numerator.clone() * pose.numerator + pose.k_sin_theta.clone() * pose.k_sin_theta;
    assert_eq!(sum, pose.radius_squared);
}
