//! Compares the entry speed and the period alone with the steady state and its extremes.

use super::{escapement, samples};
use geneva_dynamics::DynamicsError;
use geneva_dynamics::existence;
use geneva_dynamics::steady::Engagement;
use geneva_kinematics::Mechanism;
use std::f64::consts::PI;

/// Whether both ways of asking give the same numbers to the last bit, or the same refusal.
#[track_caller]
fn the_same(engagement: &Engagement) -> bool {
    match (engagement.entry_speed_and_period(), engagement.steady_state()) {
        (Ok(pair), Ok(steady)) => {
            assert_eq!(pair, (steady.entry_speed, steady.period), "{steady:?}");
            true
        }
        (Err(one), Err(other)) => {
            assert_eq!(one.to_string(), other.to_string());
            false
        }
        (one, other) => panic!("{one:?} and {other:?}"),
    }
}

#[test]
fn without_the_extremes_the_numbers_are_the_same() {
    let mut found = samples().iter().filter(|engagement| the_same(engagement)).count();
    assert_eq!(found, samples().len());
    for mechanism in Mechanism::ALL {
        for quarter in (-12..=12).step_by(3) {
            let inertia = libm::exp10(f64::from(quarter) / 4.0);
            let limit = existence::critical_friction(mechanism, inertia).expect("sound").friction.min(3.0);
            for part in [0.0, 1e-9, 1e-3, 0.1, 0.5, 0.9, 0.997] {
                let escapement = escapement(mechanism, inertia, limit * part);
                let half = mechanism.engagement_half_angle();
                // Short of the line of centres, at it, short of the exit, at it, beyond, and nearly as far as it goes.
                for reset in [0.2 * half, half, 1.7 * half, 2.0 * half, 3.0 * half, 0.95 * (PI + half)] {
                    for tolerance in [1e-6, 1e-10] {
                        let engagement = Engagement::reset_after(&escapement, reset, tolerance).expect("an engagement");
                        found += usize::from(the_same(&engagement));
                    }
                }
            }
        }
    }
    // Only without friction, reset at the exit, is there none.
    assert_eq!(found, samples().len() + 3 * 9 * 2 * (6 * 7 - 1));
}

#[test]
fn at_the_ends_of_the_range_both_give_numbers_or_both_refuse() {
    let mut refused = 0;
    for mechanism in Mechanism::ALL {
        for power in [-300, -30, -15, -9, -6, 6, 9, 15, 30, 300] {
            let inertia = libm::exp10(f64::from(power));
            let limit = existence::critical_friction(mechanism, inertia).expect("sound").friction;
            for friction in [
                0.0,
                1e-300,
                limit.min(1.0) * 1e-17,
                limit.min(1e3) * 0.5,
                limit.min(1e300) * 0.9,
                limit * (1.0 - 1e-6),
            ] {
                match Engagement::with_tolerance(&escapement(mechanism, inertia, friction), 1e-8) {
                    Ok(engagement) => refused += usize::from(!the_same(&engagement)),
                    Err(error) => assert!(matches!(error, DynamicsError::TooSharp { .. }), "{error}"),
                }
            }
        }
    }
    assert!(refused > 0);
}

#[test]
fn what_was_asked_for_before_changes_nothing() {
    // Stretches with the minus sign are made when they are asked for: from rest the switch comes late, fast it is
    // early.
    for mechanism in Mechanism::ALL {
        let escapement = escapement(mechanism, 0.07, 0.21);
        let fresh = || Engagement::new(&escapement).expect("an engagement");
        let used = fresh();
        let slow = used.return_map(0.0).expect("a speed");
        let fast = used.return_map(1e4).expect("a speed");
        assert_eq!(used.steady_state(), fresh().steady_state());
        assert_eq!(fresh().return_map(1e4), Ok(fast));
        assert_eq!(used.clone().return_map(0.0), Ok(slow));
        assert_eq!(fresh().return_map(0.0), Ok(slow));
    }
}
