//! How does a wheel move when its axes are at a wrong distance?

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{MisplacedWheel, Wheel};

#[test]
fn at_the_right_distance_it_is_the_wheel() {
    for stations in 3..=24 {
        let wheel = Wheel::new(stations).expect("possible");
        let right = MisplacedWheel::new(&wheel, 0.0).expect("possible");
        assert_eq!(right.entry_velocity_ratio(), 0.0);
        approx::assert_relative_eq!(right.index_angle(), 2.0 * wheel.half_pitch_angle(), max_relative = 1e-12);
        for crank in [-3.0, -0.4, 0.0, 0.2, 1.9] {
            assert_eq!(right.motion(crank), wheel.motion(0, crank));
        }
    }
}

#[test]
fn at_the_right_distance_the_pin_slides_as_in_the_wheel_and_at_any_other_as_its_distance_changes() {
    for (stations, pins) in [(3, 1), (4, 2), (8, 1), (24, 2)] {
        let wheel = Wheel::with_pins(stations, pins).expect("possible");
        for error in [-0.02, 0.0, 0.03] {
            let misplaced = MisplacedWheel::new(&wheel, error).expect("possible");
            let (half, pitch) = (misplaced.engagement_half_angle(), std::f64::consts::TAU / f64::from(pins));
            let distance =
                |crank: f64| libm::hypot(misplaced.centre_distance_ratio() - libm::cos(crank), libm::sin(crank));
            for part in -9..=9 {
                let crank = 0.1 * f64::from(part) * half;
                let sliding = misplaced.sliding_ratio(crank).expect("an angle").expect("a pin");
                let numeric = (distance(crank + 1e-6) - distance(crank - 1e-6)) / 2e-6;
                approx::assert_abs_diff_eq!(sliding, numeric, epsilon = 1e-8);
                if error == 0.0 {
                    let of_wheel = wheel.pin_in_slot(crank).expect("inside").sliding;
                    approx::assert_abs_diff_eq!(sliding, of_wheel, epsilon = 1e-12);
                }
            }
            // With the axes too near, a pin may come in before the last one has left.
            assert_eq!(misplaced.sliding_ratio(pitch / 2.0).expect("an angle").is_none(), pitch / 2.0 > half);
            assert!(misplaced.sliding_ratio(4.0).is_err());
        }
    }
}

#[test]
fn next_to_the_right_distance_the_motion_is_next_to_the_right_one() {
    for (stations, pins) in [(3, 1), (4, 2), (8, 1), (24, 2)] {
        let wheel = Wheel::with_pins(stations, pins).expect("possible");
        let near = MisplacedWheel::new(&wheel, 1e-9).expect("possible");
        for step in -30..=30 {
            let crank = 0.1 * f64::from(step);
            let [a, b] = [near.motion(crank).expect("an angle"), wheel.motion(0, crank).expect("an angle")];
            // The rim is passed at a small angle to the slot: half the digits.
            approx::assert_abs_diff_eq!(a.angle, b.angle, epsilon = 1e-6);
            approx::assert_abs_diff_eq!(a.velocity, b.velocity, epsilon = 1e-3);
        }
    }
}

#[test]
fn too_far_apart_the_pin_drives_at_once_and_too_near_it_turns_the_wheel_back_first() {
    for stations in 3..=24 {
        let wheel = Wheel::new(stations).expect("possible");
        let mut last = f64::NEG_INFINITY;
        for error in [-0.02, -0.01, 0.0, 0.01, 0.02] {
            let misplaced = MisplacedWheel::new(&wheel, error).expect("possible");
            let blow = misplaced.entry_velocity_ratio();
            assert!(blow > last && blow.signum() * error >= 0.0, "{stations} {error} {blow}");
            last = blow;
            // By the pin's velocity across the slot, over its distance from the wheel's axis.
            let half = -misplaced.engagement_half_angle();
            let at = |crank: f64| {
                let ratio = misplaced.centre_distance_ratio();
                libm::atan2(libm::sin(crank), ratio - libm::cos(crank))
            };
            let numeric = (at(half + 1e-6) - at(half - 1e-6)) / 2e-6;
            approx::assert_abs_diff_eq!(blow, numeric, epsilon = 1e-8);
            let pin = libm::hypot(misplaced.centre_distance_ratio() - libm::cos(half), libm::sin(half));
            approx::assert_relative_eq!(pin, wheel.wheel_radius_ratio(), max_relative = 1e-12);
        }
    }
}

#[test]
fn distances_at_which_no_pin_enters_are_named() {
    let wheel = Wheel::new(4).expect("possible");
    for error in [-0.5, 1.0, f64::NAN, f64::INFINITY] {
        let words = MisplacedWheel::new(&wheel, error).expect_err("no pin enters").to_string();
        assert!(words.contains("-0.29") && words.contains("0.41"), "{words}");
    }
    assert!(MisplacedWheel::new(&wheel, 0.0).expect("possible").motion(4.0).is_err());
}
