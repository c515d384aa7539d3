//! Where there is one solution, where there is none, and what the program says then.

use super::*;
use approx::assert_relative_eq;
use geneva_dynamics::joints::{Reach, STEPS, largest_pin_radius};
use geneva_dynamics::{DynamicsError, Sign, existence};

#[test]
fn the_margin_goes_over_to_the_ideal_one() {
    for mechanism in Mechanism::ALL {
        for (inertia, friction) in [(0.06, 0.2), (0.5, 0.1), (2.0, 0.6)] {
            let parameters = parameters(mechanism, inertia, friction);
            let ours = escapement(&parameters, Joints::IDEAL).least_margin();
            let ideal = existence::least_margin(mechanism, inertia, friction).expect("sound");
            assert_relative_eq!(ours.margin, ideal.margin, max_relative = 1e-12);
            assert_relative_eq!(ours.angle.abs(), ideal.angle, epsilon = 1e-6);
        }
    }
}

#[test]
fn a_follower_that_locks_is_refused_with_what_to_do() {
    let parameters = like_the_thesis(Mechanism::SIX_PIN);
    let lever = Mechanism::SIX_PIN.centre_distance_ratio() - 1.0;
    let limit = lever / parameters.friction();
    let at = |pin_radius| Escapement::new(&parameters, Joints { pin_radius, ..Joints::IDEAL });
    let error = at(limit * (1.0 + 1e-12)).expect_err("it locks");
    assert!(matches!(error, DynamicsError::SelfLocking { .. }), "{error}");
    assert!(error.to_string().contains("give a thinner pin") && error.to_string().contains("0.154"), "{error}");
    // Just below it the follower can still be turned, by a great force.
    if let Err(error) = at(limit * (1.0 - 1e-6)) {
        assert!(matches!(error, DynamicsError::Jams { .. }), "{error}");
    }
    // The arm of the follower's journal counts as well.
    let journals = Joints { follower_journal: 0.9, bearing_friction: 0.2, ..Joints::IDEAL };
    let error = Escapement::new(&parameters, journals).expect_err("it locks");
    assert!(matches!(error, DynamicsError::SelfLocking { .. }), "{error}");
    let driver = Joints { driver_journal: 0.9, follower_journal: 0.0, ..journals };
    assert!(!matches!(Escapement::new(&parameters, driver), Err(DynamicsError::SelfLocking { .. })));
}

#[test]
fn the_arm_on_the_follower_is_least_on_the_line_of_centres() {
    let mut spread = Spread(0.0);
    for _ in 0..300 {
        for mechanism in Mechanism::ALL {
            let parameters = parameters(mechanism, 1.0, spread.between(0.0, 0.35));
            let Ok(escapement) = Escapement::new(&parameters, spread.joints()) else { continue };
            let arm = |angle: f64, flank| {
                let (joints, friction) = (escapement.joints(), parameters.friction());
                let reach = Reach::from_pose(&parameters.pose(angle));
                let sense = Sign::from_number(reach.sliding(&joints.pin_radius, flank));
                // A journal bears the whole force of the contact.
                let journal = |radius: f64| joints.bearing_friction * radius * (1.0 + friction * friction).sqrt();
                let (driver, follower) = (journal(joints.driver_journal), journal(joints.follower_journal));
                let arms = reach.arms(&joints.pin_radius, &friction, flank, sense);
                arms.with_journals(&driver, &follower, flank).follower
            };
            let least = arm(0.0, Sign::Plus);
            let angle = mechanism.engagement_half_angle() * spread.between(-1.0, 1.0);
            for flank in Sign::BOTH {
                assert!(arm(angle, flank) >= least - 1e-15, "{mechanism:?} {angle} {flank:?}");
            }
            // The sliding turns where it is said to.
            let turn = escapement.reversal_angle();
            let pin = escapement.joints().pin_radius;
            for (angle, flank) in [(-turn, Sign::Plus), (turn, Sign::Minus)] {
                let sliding = Reach::from_pose(&parameters.pose(angle)).sliding(&pin, flank);
                assert!(sliding.abs() < 1e-14, "{mechanism:?} {pin} {sliding}");
            }
        }
    }
}

#[test]
fn a_driver_that_jams_is_refused_with_the_angle() {
    // A light driver: the ideal mechanism can bear this friction, the one with journals cannot.
    let limit = existence::critical_friction(Mechanism::FOUR_PIN, 0.06).expect("sound").friction;
    let parameters = parameters(Mechanism::FOUR_PIN, 0.06, 0.98 * limit);
    assert!(Escapement::new(&parameters, Joints::IDEAL).is_ok());
    let error = Escapement::new(&parameters, Joints::journals(0.2, 0.2)).expect_err("it jams");
    let DynamicsError::Jams { margin, angle } = error else { panic!("{error}") };
    assert!(margin <= 0.0 && angle.abs() < Mechanism::FOUR_PIN.engagement_half_angle());
    assert!(error.to_string().contains("more inertia"), "{error}");
}

#[test]
fn beyond_the_limit_there_are_two_accelerations_or_none() {
    let limit = existence::critical_friction(Mechanism::FOUR_PIN, 0.06).expect("sound").friction;
    let parameters = parameters(Mechanism::FOUR_PIN, 0.06, 0.98 * limit);
    let jammed = Joints::journals(0.2, 0.2);
    let Err(DynamicsError::Jams { margin, angle }) = Escapement::new(&parameters, jammed) else { panic!("it jams") };
    assert!(margin < 0.0, "{margin}");
    // With ever more friction in the journals it is the trailing flank that comes to it.
    let (mut sound, mut least) = (0.0, None);
    let mut jams = 0.2;
    for _ in 0..40 {
        let middle = f64::midpoint(sound, jams);
        match Escapement::new(&parameters, Joints::journals(0.2, middle)) {
            Ok(escapement) => (sound, least) = (middle, Some(escapement.least_margin())),
            Err(_) => jams = middle,
        }
    }
    let least = least.expect("a sound one between them");
    assert!(least.margin > 0.0 && least.margin < 1e-9 && least.flank == Sign::Minus, "{least:?}");
    // Where the follower is to be driven on, the pin can be wedged on the trailing flank as well.
    let flanks = |angle: f64, speed: f64| vectors::solutions(&parameters, &jammed, angle, speed);
    assert_eq!(flanks(-angle.abs(), 1.0), Sign::BOTH);
    // Behind the line of centres and at speed the follower is to be held back, and no force can do it.
    assert_eq!(flanks(angle.abs(), 10.0), []);
    assert_eq!(flanks(0.0, 1.0).len(), 1);
}

#[test]
fn impossible_values_are_named() {
    let parameters = like_the_thesis(Mechanism::FOUR_PIN);
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let sizes = [
            Joints { pin_radius: bad, ..Joints::IDEAL },
            Joints { driver_journal: bad, ..Joints::IDEAL },
            Joints { follower_journal: bad, ..Joints::IDEAL },
            Joints { bearing_friction: bad, ..Joints::IDEAL },
            Joints { driver_drag_torque: bad, ..Joints::IDEAL },
            Joints { follower_drag_torque: bad, ..Joints::IDEAL },
        ];
        for joints in sizes {
            let error = Escapement::new(&parameters, joints).expect_err("bad size");
            assert!(matches!(error, DynamicsError::Negative { .. }), "{error}");
        }
    }
    let refused = |joints| Escapement::new(&parameters, joints).expect_err("refused");
    assert!(matches!(refused(Joints { pin_radius: 1.0, ..Joints::IDEAL }), DynamicsError::PinTooThick { .. }));
    assert!(matches!(refused(Joints { driver_drag_torque: 1.0, ..Joints::IDEAL }), DynamicsError::DragTorque { .. }));
    // A product that is not a number is refused too.
    let endless = Joints { follower_journal: f64::MAX, bearing_friction: f64::MAX, ..Joints::IDEAL };
    assert!(matches!(refused(endless), DynamicsError::SelfLocking { .. }));
    let endless = Joints { driver_journal: f64::MAX, bearing_friction: f64::MAX, ..Joints::IDEAL };
    assert!(matches!(refused(endless), DynamicsError::Jams { .. }));

    let sound = escapement(&parameters, Joints::IDEAL);
    for angle in [f64::NAN, f64::INFINITY, 0.8] {
        assert!(matches!(sound.motion(angle, 1.0), Err(DynamicsError::OutsideTheSlot { .. })), "{angle}");
    }
    for speed in [-1.0, f64::NAN, f64::INFINITY, 1e200] {
        assert!(matches!(sound.motion(0.0, speed), Err(DynamicsError::Speed { .. })), "{speed}");
        assert!(matches!(sound.passage(speed, 64), Err(DynamicsError::Speed { .. })), "{speed}");
    }
    for steps in [0, STEPS.end() + 1] {
        assert!(matches!(sound.passage(1.0, steps), Err(DynamicsError::OutOfRange { .. })), "{steps}");
        assert!(matches!(sound.steady_state_in(steps), Err(DynamicsError::OutOfRange { .. })), "{steps}");
    }
    let error = sound.steady_state(0.0).expect_err("nothing is exact");
    assert!(matches!(error, DynamicsError::NotSettled { .. }), "{error}");
}

#[test]
fn slots_run_into_one_another_where_their_ends_touch() {
    for mechanism in Mechanism::ALL {
        // Centres of two neighbouring slot ends, from the follower's axis.
        let reach = mechanism.centre_distance_ratio() - 1.0;
        let angle = 2.0 * std::f64::consts::PI / f64::from(mechanism.slots());
        let apart = libm::hypot(reach * libm::cos(angle) - reach, reach * libm::sin(angle));
        assert_relative_eq!(2.0 * largest_pin_radius(mechanism), apart, max_relative = 1e-14);
    }
}

#[test]
fn at_the_ends_a_thick_pin_slides_less_and_on_the_line_of_centres_more() {
    for mechanism in Mechanism::ALL {
        let thick = escapement(&like_the_thesis(mechanism), Joints { pin_radius: 0.1, ..Joints::IDEAL });
        let sliding = |angle| thick.motion(angle, 1.0).expect("sound").sliding;
        let half = mechanism.engagement_half_angle();
        assert_relative_eq!(sliding(-half), 0.1 - 1.0, max_relative = 1e-14);
        assert_relative_eq!(sliding(half), 1.0 - 0.1, max_relative = 1e-14);
        // The follower turns 1/(a − 1) times as fast as the driver there.
        assert_relative_eq!(
            sliding(0.0),
            0.1 * (1.0 + 1.0 / (mechanism.centre_distance_ratio() - 1.0)),
            max_relative = 1e-14
        );
    }
}

#[test]
fn at_entry_and_exit_the_pin_counts_as_leading_and_trailing() {
    for mechanism in Mechanism::ALL {
        let joints = Joints { pin_radius: 0.1, ..Joints::journals(0.1, 0.1) };
        let escapement = escapement(&like_the_thesis(mechanism), joints);
        let half = mechanism.engagement_half_angle();
        let inertias = escapement.parameters().inertias();
        for speed in [0.0, 1.0] {
            let [entry, exit] = [-half, half].map(|angle| escapement.motion(angle, speed).expect("sound"));
            assert_eq!(entry.flank, Sign::Plus);
            if speed == 0.0 {
                // Nothing asks for a force: the driver feels its own inertia only.
                assert!(entry.normal_moment.abs() < 1e-13, "{}", entry.normal_moment);
                assert_relative_eq!(entry.angular_acceleration, 1.0 / inertias.driver(), max_relative = 1e-12);
            } else {
                assert!(entry.normal_moment > 0.0 && exit.normal_moment < 0.0);
            }
        }
    }
}
