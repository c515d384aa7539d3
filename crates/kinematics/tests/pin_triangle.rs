//! The pin on the line of centres, by the triangle.

use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use geneva_kinematics::pin_triangle::solve;

#[test]
fn on_the_line_of_centres_the_pin_drives_across_the_slot() {
    let mechanism = PinSlot::new(1.0, 3.0).expect("possible");
    let solution = solve(&mechanism, &Turn::from_radians(0.0), 2.0);
    approx::assert_relative_eq!(solution.slot_radius, 2.0);
    approx::assert_relative_eq!(solution.follower_speed, 1.0);
    approx::assert_abs_diff_eq!(solution.sliding_speed, 0.0, epsilon = 1e-15);
}
