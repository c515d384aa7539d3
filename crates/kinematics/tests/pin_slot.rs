//! Are impossible lengths named, and does the follower rest at both ends of the engagement?

use geneva_kinematics::pin_slot::{PinSlot, velocity_ratio};
use geneva_kinematics::{Jet, KinematicsError, Turn};

#[test]
fn impossible_lengths_are_named() {
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(PinSlot::new(radius, 2.0), Err(KinematicsError::Length { .. })), "{radius}");
    }
    for distance in [1.0, 0.5, f64::NAN, f64::INFINITY] {
        assert!(matches!(PinSlot::new(1.0, distance), Err(KinematicsError::CentreDistance { .. })), "{distance}");
    }
    let message = PinSlot::new(2.0, 1.5).expect_err("too close").to_string();
    assert!(message.contains("1.5") && message.contains("greater than the crank radius 2"), "{message}");
}

#[test]
fn the_follower_stands_still_at_both_ends_of_the_engagement() {
    let mechanism = PinSlot::new(2.0, 3.0).expect("possible");
    let end = mechanism.engagement_half_angle();
    for crank in [Turn::from_radians(end), Turn::from_radians(-end)] {
        approx::assert_abs_diff_eq!(velocity_ratio(&mechanism.ratio(), &crank), 0.0, epsilon = 1e-15);
    }
    let inside = Turn::from_radians(0.99 * end);
    assert!(velocity_ratio(&mechanism.ratio(), &inside) > 0.0);
}

#[test]
fn a_library_of_dual_numbers_agrees_on_its_derivatives() {
    let crank = Turn::from_radians(0.3).moving::<4>(1.0);
    let ratio = Jet::constant(1.5);
    let ours = velocity_ratio(&ratio, &crank);
    let (_, first, second, third) = num_dual::third_derivative(
        |t| {
            use num_dual::DualNum;
            let (c, k) = (t.cos(), 1.5);
            (c * k - 1.0) / (c * (-2.0 * k) + 1.0 + k * k)
        },
        0.3,
    );
    for (order, theirs) in [(1, first), (2, second), (3, third)] {
        let ours = ours.derivative(order).expect("carried");
        approx::assert_relative_eq!(ours, theirs, max_relative = 1e-13);
    }
}
