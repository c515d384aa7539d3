//! What follows for the timer: which sizes slow it down, and how speed scales with the torque.

use super::*;
use crate::joints::{JointError, Varied, series};
use approx::assert_relative_eq;

#[test]
fn a_thicker_pin_speeds_the_timer_up_and_everything_else_slows_it_down() {
    for slots in Slots::ALL {
        let parameters = like_the_thesis(slots);
        let base = Joints { pin_radius: 0.05, ..Joints::journals(0.1, 0.1) };
        for varied in Varied::ALL {
            let most = match varied {
                Varied::PinRadius => 0.15,
                Varied::FollowerPreload | Varied::DriverPreload => 0.1,
                _ => 0.2,
            };
            let values = (0..=5).map(|k| most * f64::from(k) / 5.0);
            let effects = series(&parameters, &base, varied, values).expect("they run");
            for pair in effects.windows(2) {
                let faster = pair[1].mean_speed > pair[0].mean_speed;
                assert_eq!(faster, varied == Varied::PinRadius, "{slots:?} {varied:?} {pair:?}");
                assert_eq!(pair[1].state.period < pair[0].state.period, faster);
            }
        }
    }
}

#[test]
fn speeds_scale_with_the_root_of_the_torque_unless_a_torque_is_constant() {
    let scaled = |torque: f64, joints: Joints| {
        let inertias = Inertias::new(3.0, 50.0).expect("sound");
        let parameters = Parameters::new(Slots::Four, inertias, torque, 0.25).expect("sound");
        escapement(&parameters, joints).steady_state_in(1024).expect("a steady state")
    };
    let loaded = Joints { pin_radius: 0.1, ..Joints::journals(0.1, 0.2) };
    let (once, four) = (scaled(1.0, loaded), scaled(4.0, loaded));
    assert_relative_eq!(four.mean_speed, 2.0 * once.mean_speed, max_relative = 1e-12);
    assert_relative_eq!(four.peak.speed, 2.0 * once.peak.speed, max_relative = 1e-12);
    assert_relative_eq!(four.contraction, once.contraction, max_relative = 1e-12);
    for preloaded in [Joints { driver_preload: 0.1, ..loaded }, Joints { follower_preload: 0.02, ..loaded }] {
        let (once, four) = (scaled(1.0, preloaded), scaled(4.0, preloaded));
        // The preload weighs less against a stronger spring.
        assert!(four.mean_speed > 2.001 * once.mean_speed, "{} {}", once.mean_speed, four.mean_speed);
        // With the preloads scaled too, the law holds again.
        let scaled_too = Joints {
            driver_preload: 4.0 * preloaded.driver_preload,
            follower_preload: 4.0 * preloaded.follower_preload,
            ..preloaded
        };
        let four = scaled(4.0, scaled_too);
        assert_relative_eq!(four.mean_speed, 2.0 * once.mean_speed, max_relative = 1e-12);
    }
}

#[test]
fn journals_alone_brake_and_constant_torques_alone_do_not() {
    let parameters = parameters(Slots::Four, 3.0 / 50.0, 0.0);
    let steady = |joints| escapement(&parameters, joints).steady_state_in(1024);
    for joints in [Joints::IDEAL, Joints { driver_preload: 0.1, follower_preload: 0.1, ..Joints::IDEAL }] {
        let error = steady(joints).expect_err("nothing brakes faster running more");
        assert!(matches!(error, JointError::NoTerminalSpeed { .. }), "{error}");
        assert!(error.to_string().contains("grows with the load"), "{error}");
    }
    let state = steady(Joints::journals(0.2, 0.2)).expect("journals brake");
    assert_eq!(state.work.sliding, 0.0);
    assert_relative_eq!(state.work.losses(), state.work.input, max_relative = 1e-8);
    // The ideal mechanism has no terminal speed to compare with.
    assert!(series(&parameters, &Joints::journals(0.2, 0.2), Varied::PinRadius, [0.0]).is_err());
}

#[test]
fn a_pin_of_any_radius_bears_where_it_would_without_friction() {
    let (mut spread, mut seen) = (Spread(0.0), 0);
    for _ in 0..500 {
        let inertia = spread.between(0.05, 2.0);
        let smooth = escapement(&parameters(Slots::Four, inertia, 0.0), Joints::IDEAL);
        let rough = parameters(Slots::Four, inertia, spread.between(0.0, 0.35));
        let joints = Joints { driver_preload: 0.0, follower_preload: 0.0, ..spread.joints() };
        let Ok(rough) = Escapement::new(&rough, joints) else { continue };
        let angle = Slots::Four.engagement_half_angle() * spread.between(-1.0, 1.0);
        let speed = spread.between(0.0, 3.0);
        let flank = |escapement: &Escapement| escapement.motion(angle, speed).expect("sound").flank;
        assert_eq!(flank(&smooth), flank(&rough));
        seen += 1;
    }
    assert!(seen > 300, "{seen}");
}
