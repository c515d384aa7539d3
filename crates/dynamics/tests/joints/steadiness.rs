//! The steady motion: its method's order, its balance of work, and what it is made of.

use super::*;
use approx::assert_relative_eq;
use geneva_dynamics::DynamicsError;
use geneva_dynamics::joints::{JointPassage, effects};

fn samples() -> Vec<Escapement> {
    let sizes = [
        Joints { pin_radius: 0.1, ..Joints::IDEAL },
        Joints::journals(0.15, 0.15),
        Joints { pin_radius: 0.12, ..Joints::journals(0.1, 0.1) },
        Joints { pin_radius: 0.05, driver_drag_torque: 0.1, follower_drag_torque: 0.02, ..Joints::journals(0.1, 0.1) },
    ];
    let all = Mechanism::ALL.into_iter().flat_map(|mechanism| sizes.map(|joints| (mechanism, joints)));
    all.map(|(mechanism, joints)| escapement(&like_the_thesis(mechanism), joints)).collect()
}

fn parts(passage: &JointPassage) -> [f64; 5] {
    let JointPassage { exit_speed, multiplier, duration, peak, minimum, .. } = passage;
    [*exit_speed, *multiplier, *duration, peak.speed, minimum.speed]
}

#[test]
fn halving_the_steps_takes_the_error_to_a_sixteenth() {
    for escapement in samples() {
        let run = |steps| parts(&escapement.passage(1.0, steps).expect("it runs"));
        let [coarse, fine, reference] = [512, 1024, 16_384].map(run);
        for part in 0..3 {
            let errors = [coarse, fine].map(|run| (run[part] - reference[part]).abs() / reference[part]);
            // The cut steps do not halve exactly; rounding hides errors below.
            assert!(errors[1] < errors[0] / 10.0 || errors[1] < 1e-12, "{escapement:?} {part} {errors:?}");
            assert!(errors[1] < 1e-6, "{escapement:?} {part} {errors:?}");
        }
    }
}

#[test]
fn what_is_told_of_the_error_is_its_size() {
    for escapement in samples() {
        let settled = escapement.steady_state(1e-7).expect("a steady state");
        let better = escapement.steady_state_in(16_384).expect("a steady state");
        for (ours, true_one) in [
            (settled.state.duration, better.duration),
            (settled.state.peak.speed, better.peak.speed),
            (settled.state.minimum.speed, better.minimum.speed),
            (settled.state.multiplier, better.multiplier),
        ] {
            assert_relative_eq!(ours, true_one, max_relative = settled.change + 1e-12);
        }
        assert!(settled.change <= 1e-7);
    }
}

#[test]
fn friction_takes_all_that_the_spring_gives_in_a_cycle() {
    for escapement in samples() {
        let state = escapement.steady_state(1e-9).expect("a steady state").state;
        assert_relative_eq!(state.work.losses(), state.work.input, max_relative = 1e-8);
        let turn = 2.0 * escapement.parameters().mechanism().engagement_half_angle();
        assert_relative_eq!(state.work.input, turn, max_relative = 1e-15);
        assert_relative_eq!(state.mean_speed * state.duration, turn, max_relative = 1e-15);
        let mean = f64::midpoint(state.peak.speed, state.minimum.speed);
        assert!(state.minimum.speed < state.mean_speed && state.mean_speed < state.peak.speed && mean > 0.0);
    }
}

#[test]
fn the_steady_entry_repeats_itself_and_neighbours_come_nearer_as_told() {
    for escapement in samples() {
        let state = escapement.steady_state_in(2048).expect("a steady state");
        let run = |speed| escapement.passage(speed, 2048).expect("it runs").exit_speed;
        assert_relative_eq!(run(state.entry_speed), state.entry_speed, max_relative = 1e-11);
        let step = 1e-4 * state.entry_speed;
        let slope = (run(state.entry_speed + step) - run(state.entry_speed - step)) / (2.0 * step);
        assert_relative_eq!(slope, state.multiplier, max_relative = 1e-5);
        assert!(state.multiplier > 0.0 && state.multiplier < 1.0);
    }
}

#[test]
fn extremes_are_where_the_driver_does_not_accelerate() {
    for escapement in samples() {
        let state = escapement.steady_state(1e-9).expect("a steady state").state;
        let least = escapement.motion(state.minimum.angle, state.minimum.speed).expect("sound");
        let scale = escapement.parameters().torque() / escapement.parameters().inertias().driver();
        assert!(
            least.angular_acceleration.abs() < 1e-4 * scale,
            "{escapement:?} {} {}",
            state.minimum.angle,
            least.angular_acceleration
        );
    }
}

#[test]
fn a_drag_torque_that_is_too_great_stalls_the_driver() {
    let parameters = like_the_thesis(Mechanism::FOUR_PIN);
    let stopped = |drag_torque| {
        let joints = Joints { follower_drag_torque: drag_torque, ..Joints::IDEAL };
        escapement(&parameters, joints).steady_state_in(512)
    };
    // Slower and slower with the drag torque, until none is slow enough.
    let mean = |drag_torque| stopped(drag_torque).ok().map(|state| state.mean_speed);
    let means: Vec<_> = (0..40).map(|k| mean(0.02 * f64::from(k))).collect();
    let running = means.iter().take_while(|mean| mean.is_some()).count();
    println!("the driver stalls from a drag torque of {}", 0.02 * running as f64);
    assert!(running > 5 && running < 40 && means[running..].iter().all(Option::is_none), "{means:?}");
    assert!(means[..running].windows(2).all(|pair| pair[1] < pair[0]), "{means:?}");
    let error = stopped(1.5).expect_err("the follower's bearing holds it");
    assert!(matches!(error, DynamicsError::Stalls { .. }), "{error}");
    assert!(error.to_string().contains("give more torque"), "{error}");
    let rest = escapement(&parameters, Joints::IDEAL).passage(0.0, 512).expect_err("from rest");
    assert!(matches!(rest, DynamicsError::Stalls { .. }), "{rest}");
}

#[test]
fn a_tolerance_ten_times_finer_gives_the_same_effects() {
    for mechanism in Mechanism::ALL {
        let parameters = like_the_thesis(mechanism);
        for joints in [Joints::journals(0.1, 0.1), Joints { pin_radius: 0.1, ..Joints::journals(0.1, 0.2) }] {
            let listed = effects(&parameters, [(0.0, joints)]).expect("they run").remove(0).state;
            let finer = escapement(&parameters, joints).steady_state(1e-10).expect("a steady state").state;
            for (listed, finer) in [
                (listed.mean_speed, finer.mean_speed),
                (listed.multiplier, finer.multiplier),
                (listed.peak.speed, finer.peak.speed),
                (listed.minimum.speed, finer.minimum.speed),
            ] {
                // Six digits are more than the book prints.
                assert_relative_eq!(listed, finer, max_relative = 1e-7);
            }
        }
    }
}
