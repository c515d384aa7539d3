//! What follows for the timer: which sizes slow it down, and how speed scales with the torque.

use super::*;
use approx::assert_relative_eq;
use geneva_dynamics::DynamicsError;
use geneva_dynamics::joints::{Varied, effects, series};

#[test]
fn a_thicker_pin_speeds_the_timer_up_and_everything_else_slows_it_down() {
    for mechanism in Mechanism::ALL {
        let parameters = like_the_thesis(mechanism);
        let base = Joints { pin_radius: 0.05, ..Joints::journals(0.1, 0.1) };
        for varied in Varied::ALL {
            let most = match varied {
                Varied::PinRadius => 0.15,
                Varied::FollowerDragTorque | Varied::DriverDragTorque => 0.1,
                _ => 0.2,
            };
            let values = (0..=5).map(|k| most * f64::from(k) / 5.0);
            let effects = series(&parameters, &base, varied, values).expect("they run");
            for pair in effects.windows(2) {
                let faster = pair[1].mean_speed > pair[0].mean_speed;
                assert_eq!(faster, varied == Varied::PinRadius, "{mechanism:?} {varied:?} {pair:?}");
                assert_eq!(pair[1].state.duration < pair[0].state.duration, faster);
            }
        }
    }
}

#[test]
fn from_one_entry_speed_a_thicker_pin_costs_less_and_nearly_everything_else_more() {
    for mechanism in Mechanism::ALL {
        let parameters = like_the_thesis(mechanism);
        let entry = escapement(&parameters, Joints::IDEAL).steady_state_in(1024).expect("steady").entry_speed;
        for varied in Varied::ALL {
            let base = Joints { pin_radius: 0.05, ..Joints::journals(0.1, 0.1) };
            let lost = |value: f64| {
                let passage = escapement(&parameters, varied.set(&base, value)).passage(entry, 1024);
                passage.expect("it runs").work.losses()
            };
            let lost: Vec<_> = (0..=5).map(|k| lost(0.02 * f64::from(k))).collect();
            let less = lost.windows(2).all(|pair| pair[1] < pair[0]);
            let more = lost.windows(2).all(|pair| pair[1] > pair[0]);
            // With four slots the follower's journal costs less than it saves in the slot and in the other bearing.
            let exception = mechanism == Mechanism::FOUR_PIN && varied == Varied::FollowerJournal;
            let expected = if varied == Varied::PinRadius || exception { less } else { more };
            assert!(expected, "{mechanism:?} {varied:?} {lost:?}");
        }
    }
}

#[test]
fn of_the_journals_only_radius_times_friction_counts_and_the_drivers_more() {
    for mechanism in Mechanism::ALL {
        let parameters = like_the_thesis(mechanism);
        let mean = |joints| escapement(&parameters, joints).steady_state(1e-9).expect("steady").state.mean_speed;
        let products =
            [(0.1, 0.2), (0.2, 0.1), (0.4, 0.05)].map(|(radius, friction)| Joints::journals(radius, friction));
        let [first, second, third] = products.map(mean);
        assert_relative_eq!(first, second, max_relative = 1e-14);
        assert_relative_eq!(first, third, max_relative = 1e-14);
        let one = |driver_journal, follower_journal| {
            mean(Joints { driver_journal, follower_journal, bearing_friction: 0.1, ..Joints::IDEAL })
        };
        let ideal = mean(Joints::IDEAL);
        let [driver, follower] = [ideal - one(0.1, 0.0), ideal - one(0.0, 0.1)];
        println!("{mechanism:?}: the driver's journal costs {} times the follower's", driver / follower);
        let least = [1.0, 2.0, 4.0][mechanism.index()];
        assert!(follower > 0.0 && driver > least * follower, "{mechanism:?} {driver} {follower}");
    }
}

#[test]
fn a_pin_of_a_tenth_speeds_up_by_some_per_cent_and_makes_up_for_journals() {
    for mechanism in Mechanism::ALL {
        let mean = |joints| {
            let found = effects(&like_the_thesis(mechanism), [(0.0, joints)]).expect("it runs");
            found[0].mean_speed
        };
        let pin = mean(Joints { pin_radius: 0.1, ..Joints::IDEAL });
        let journals = mean(Joints::journals(0.1, 0.2));
        let both = mean(Joints { pin_radius: 0.1, ..Joints::journals(0.1, 0.2) });
        assert!(pin > 1.05 && pin < 1.09, "{mechanism:?} {pin}");
        assert!(journals > 0.9 && journals < 0.96, "{mechanism:?} {journals}");
        assert!((both - 1.0).abs() < 0.01, "{mechanism:?} {both}");
    }
}

#[test]
fn the_multiplier_grows_with_the_pin_and_falls_with_the_drivers_journal() {
    for mechanism in Mechanism::ALL {
        let parameters = like_the_thesis(mechanism);
        let grow = |varied, most: f64| {
            let values = (0..=4).map(|k| most * f64::from(k) / 4.0);
            let base = Joints { bearing_friction: 0.1, ..Joints::IDEAL };
            let effects = series(&parameters, &base, varied, values).expect("they run");
            assert_relative_eq!(effects[0].mean_speed, 1.0, max_relative = 1e-12);
            for effect in &effects {
                assert_relative_eq!(effect.decay_constant, -1.0 / effect.multiplier.ln(), max_relative = 1e-12);
            }
            let pairs: Vec<_> = effects.windows(2).map(|pair| pair[1].multiplier - pair[0].multiplier).collect();
            pairs
        };
        assert!(grow(Varied::PinRadius, 0.15).iter().all(|change| *change > 0.0));
        assert!(grow(Varied::DriverJournal, 0.2).iter().all(|change| *change < 0.0));
        // The follower's journal moves it less, and with four slots the other way.
        let follower = grow(Varied::FollowerJournal, 0.2);
        let up = mechanism == Mechanism::FOUR_PIN;
        assert!(follower.iter().all(|change| (*change > 0.0) == up), "{mechanism:?} {follower:?}");
    }
}

#[test]
fn speeds_scale_with_the_root_of_the_torque_unless_a_torque_is_constant() {
    let scaled = |torque: f64, joints: Joints| {
        let inertias = Inertias::new(3.0, 50.0).expect("sound");
        let parameters = Parameters::new(Mechanism::FOUR_PIN, inertias, torque, 0.25).expect("sound");
        escapement(&parameters, joints).steady_state_in(1024).expect("a steady state")
    };
    let loaded = Joints { pin_radius: 0.1, ..Joints::journals(0.1, 0.2) };
    let (once, four) = (scaled(1.0, loaded), scaled(4.0, loaded));
    assert_relative_eq!(four.mean_speed, 2.0 * once.mean_speed, max_relative = 1e-12);
    assert_relative_eq!(four.peak.speed, 2.0 * once.peak.speed, max_relative = 1e-12);
    assert_relative_eq!(four.multiplier, once.multiplier, max_relative = 1e-12);
    for with_drag_torque in
        [Joints { driver_drag_torque: 0.1, ..loaded }, Joints { follower_drag_torque: 0.02, ..loaded }]
    {
        let (once, four) = (scaled(1.0, with_drag_torque), scaled(4.0, with_drag_torque));
        // The drag torque weighs less against a stronger spring.
        assert!(four.mean_speed > 2.001 * once.mean_speed, "{} {}", once.mean_speed, four.mean_speed);
        // With the drag torques scaled too, the law holds again.
        let scaled_too = Joints {
            driver_drag_torque: 4.0 * with_drag_torque.driver_drag_torque,
            follower_drag_torque: 4.0 * with_drag_torque.follower_drag_torque,
            ..with_drag_torque
        };
        let four = scaled(4.0, scaled_too);
        assert_relative_eq!(four.mean_speed, 2.0 * once.mean_speed, max_relative = 1e-12);
    }
}

#[test]
fn journals_alone_brake_and_constant_torques_alone_do_not() {
    let parameters = parameters(Mechanism::FOUR_PIN, 3.0 / 50.0, 0.0);
    let steady = |joints| escapement(&parameters, joints).steady_state_in(1024);
    for joints in [Joints::IDEAL, Joints { driver_drag_torque: 0.1, follower_drag_torque: 0.1, ..Joints::IDEAL }] {
        let error = steady(joints).expect_err("nothing brakes faster running more");
        assert!(matches!(error, DynamicsError::NoTerminalSpeed { .. }), "{error}");
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
        let smooth = escapement(&parameters(Mechanism::FOUR_PIN, inertia, 0.0), Joints::IDEAL);
        let rough = parameters(Mechanism::FOUR_PIN, inertia, spread.between(0.0, 0.35));
        let joints = Joints { driver_drag_torque: 0.0, follower_drag_torque: 0.0, ..spread.joints() };
        let Ok(rough) = Escapement::new(&rough, joints) else { continue };
        let angle = Mechanism::FOUR_PIN.engagement_half_angle() * spread.between(-1.0, 1.0);
        let speed = spread.between(0.0, 3.0);
        let flank = |escapement: &Escapement| escapement.motion(angle, speed).expect("sound").flank;
        assert_eq!(flank(&smooth), flank(&rough));
        seen += 1;
    }
    assert!(seen > 300, "{seen}");
}
