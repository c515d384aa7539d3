//! Which positions does the lever have, on which branch, and where does it reverse?

use geneva_kinematics::quick_return::{Branch, QuickReturn};
use geneva_kinematics::{KinematicsError, Turn};
use std::f64::consts::{FRAC_PI_2, PI};

fn linkage(ground: f64, crank: f64) -> QuickReturn {
    QuickReturn::new(ground, crank).expect("possible")
}

#[test]
fn both_ways_of_driving_agree_on_both_branches_and_for_both_kinds_of_lever() {
    for (ground, crank) in [(3.0, 1.0), (1.1, 1.0), (1.0, 1.0), (0.7, 1.0), (0.1, 2.0)] {
        let linkage = linkage(ground, crank);
        for step in -17..18 {
            let by_crank = linkage.position_at_crank_degrees(f64::from(step) * 10.0).expect("off the pivot");
            let degrees = by_crank.lever.degrees();
            let by_lever = linkage.position_at_lever_degrees(degrees, by_crank.branch());
            let by_lever = if ground > crank || by_crank.branch() == Branch::Far {
                by_lever.expect("reached")
            } else {
                // The lever's pivot is inside the circle: whatever the angle at the pin, there is one position.
                linkage.position_at_lever_degrees(degrees, Branch::Far).expect("reached")
            };
            approx::assert_abs_diff_eq!(by_lever.crank.cos, by_crank.crank.cos, epsilon = 1e-11);
            approx::assert_abs_diff_eq!(by_lever.crank.sin, by_crank.crank.sin, epsilon = 1e-11);
            approx::assert_relative_eq!(by_lever.pin_distance, by_crank.pin_distance, max_relative = 1e-11);
        }
    }
}

#[test]
fn the_lever_reverses_where_it_is_at_right_angles_to_the_crank() {
    let linkage = linkage(3.0, 1.0);
    let strokes = linkage.strokes();
    let limit = strokes.swing_limit.expect("it swings");
    let end = linkage.position_at_crank(&Turn::from_radians(PI - strokes.fast / 2.0)).expect("off the pivot");
    approx::assert_relative_eq!(end.lever.radians(), limit, max_relative = 1e-14);
    approx::assert_relative_eq!(end.angle_at_pin(), FRAC_PI_2, max_relative = 1e-14);
    approx::assert_relative_eq!(strokes.slow + strokes.fast, 2.0 * PI);
    assert!(strokes.time_ratio() > 1.0);
}

#[test]
fn a_lever_that_turns_has_half_turns_instead_of_a_swing() {
    let linkage = linkage(1.0, 2.0);
    let strokes = linkage.strokes();
    assert_eq!(strokes.swing_limit, None);
    let half = linkage.position_at_crank(&Turn::from_radians(PI - strokes.fast / 2.0)).expect("off the pivot");
    approx::assert_abs_diff_eq!(half.lever.radians(), FRAC_PI_2, epsilon = 1e-14);
    approx::assert_relative_eq!(strokes.time_ratio(), 2.0, max_relative = 1e-14);
}

#[test]
fn impossible_assemblies_say_what_is_possible() {
    let message = linkage(2.0, 1.0).position_at_lever_degrees(31.0, Branch::Far).expect_err("beyond").to_string();
    assert!(message.contains("31°") && message.contains("30.0") && message.contains("−30.0"), "{message}");
    assert!(linkage(2.0, 1.0).position_at_lever_degrees(180.0, Branch::Far).is_err(), "the ray points away");
    let message = linkage(1.0, 2.0).position_at_lever_degrees(90.0, Branch::Near).expect_err("one point").to_string();
    assert!(message.contains("far branch"), "{message}");
    assert_eq!(linkage(1.0, 1.0).position_at_crank_degrees(180.0), Err(KinematicsError::PinOnPivot));
    let open =
        linkage(1.0, 1.0).position_at_lever_degrees(90.0, Branch::Far).expect_err("the pin would be on the pivot");
    assert!(open.to_string().contains("not to"), "{open}");
    for (ground, crank) in [(0.0, 1.0), (1.0, -1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY), (1e300, 1e-300)] {
        let message = QuickReturn::new(ground, crank).expect_err("impossible").to_string();
        assert!(message.contains("give"), "{message}");
    }
    assert!(linkage(2.0, 1.0).position_at_crank_degrees(f64::NAN).is_err());
    assert!(linkage(2.0, 1.0).position_at_lever_degrees(f64::INFINITY, Branch::Far).is_err());
}

#[test]
fn the_end_of_the_swing_as_printed_is_possible() {
    for k in 2..2000 {
        let linkage = linkage(f64::from(k) / 100.0 + 1.0, 1.0);
        let limit = linkage.strokes().swing_limit.expect("it swings").to_degrees();
        for angle in [limit, -limit] {
            assert!(linkage.position_at_lever_degrees(angle, Branch::Far).is_ok(), "{angle} with {}", linkage.ratio());
        }
        assert!(linkage.position_at_lever_degrees(limit * (1.0 + 1e-12), Branch::Far).is_err());
    }
}

#[test]
fn the_branches_meet_at_the_end_of_the_swing() {
    let linkage = linkage(5.0, 3.0);
    let limit = linkage.strokes().swing_limit.expect("it swings").to_degrees() * (1.0 - 1e-12);
    let [near, far] =
        [Branch::Near, Branch::Far].map(|branch| linkage.position_at_lever_degrees(limit, branch).expect("reached"));
    approx::assert_relative_eq!(near.pin_distance, far.pin_distance, max_relative = 1e-5);
    approx::assert_relative_eq!(near.pin_distance, 4.0, max_relative = 1e-5);
}
