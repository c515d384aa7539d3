//! Do the vectors of pin and slot agree with the closed form, exactly?

use geneva_kinematics::pin_vectors::solve;
use geneva_kinematics::{Turn, pin_slot, rational};

#[test]
fn the_slot_carries_across_and_the_pin_slides_along() {
    let crank = Turn::from_half_tangent(&rational(5, 2));
    let motion = solve(&rational(2, 1), &rational(3, 1), &crank, &rational(7, 1)).expect("off the pivot");
    let zero = rational(0, 1);
    assert_eq!(motion.slot_point_velocity.dot(&motion.position), zero);
    assert_eq!(motion.sliding_velocity.perp(&motion.position), zero);
    // And the closed form says the same, with the sign of the opposite sense.
    let ratio = pin_slot::velocity_ratio(&rational(3, 2), &crank.supplement());
    assert_eq!(motion.follower_speed, -(rational(7, 1) * ratio));
}

#[test]
fn a_pin_on_the_pivot_has_no_motion_of_the_slot() {
    let half_turn = Turn { cos: rational(-1, 1), sin: rational(0, 1) };
    assert_eq!(solve(&rational(1, 1), &rational(1, 1), &half_turn, &rational(1, 1)), None);
}
