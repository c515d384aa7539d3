//! Do both diagrams close, and is the lever a Geneva wheel that is never let go?

use geneva_kinematics::quick_return::{Drive, LeverMotion, QuickReturn};
use geneva_kinematics::wheel::{Wheel, acceleration_ratio};
use geneva_kinematics::{Turn, pin_slot};

#[test]
fn both_diagrams_close_all_around_and_for_both_kinds_of_lever() {
    for (ground, radius) in [(3.0, 1.0), (0.4, 1.0)] {
        for degrees in (0..360).step_by(7) {
            let crank = Turn::from_degrees(f64::from(degrees));
            let drive = Drive { speed: 2.0, acceleration: -3.0 };
            let motion = LeverMotion::new(&ground, &radius, &crank, &drive).expect("off the pivot");
            assert!(motion.velocity_gap().norm() < 1e-12 * motion.velocities.pin_velocity.norm());
            assert!(motion.acceleration_gap().norm() < 1e-12 * motion.accelerations.coriolis.norm().max(1.0));
        }
    }
}

#[test]
fn the_lever_is_a_geneva_wheel_that_is_never_let_go() {
    let wheel = Wheel::new(4).expect("possible");
    let (ratio, speed) = (wheel.centre_distance_ratio(), 1.7);
    for degrees in [-40.0, -13.0, 0.0, 8.0, 44.0] {
        let crank = Turn::from_degrees(degrees);
        // The wheel's angle is measured from the line of centres, the crank's here from the other side.
        let motion =
            LeverMotion::new(&ratio, &1.0, &crank.supplement(), &Drive::steady(-speed)).expect("off the pivot");
        let expected = pin_slot::velocity_ratio(&ratio, &crank) * speed;
        approx::assert_relative_eq!(motion.velocities.follower_speed, expected, max_relative = 1e-12);
        let expected = acceleration_ratio(&ratio, &crank) * speed * speed;
        approx::assert_relative_eq!(
            motion.accelerations.follower_acceleration,
            expected,
            max_relative = 1e-12,
            epsilon = 1e-12
        );
    }
}

#[test]
fn the_lever_stands_still_at_the_ends_of_its_swing() {
    let linkage = QuickReturn::new(2.0, 1.0).expect("possible");
    let end = Turn::from_radians(std::f64::consts::PI - linkage.strokes().fast / 2.0);
    let motion = LeverMotion::new(&2.0, &1.0, &end, &Drive::steady(5.0)).expect("off the pivot");
    approx::assert_abs_diff_eq!(motion.velocities.follower_speed, 0.0, epsilon = 1e-14);
    approx::assert_abs_diff_eq!(motion.accelerations.coriolis.norm(), 0.0, epsilon = 1e-13);
}
