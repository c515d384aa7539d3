//! The ends of the range: hardly any friction, nearly too much, very different inertias, impossible requests.

use super::escapement;
use geneva_dynamics::steady::{Engagement, TOLERANCES};
use geneva_dynamics::{DynamicsError, existence};
use geneva_kinematics::Mechanism;
use std::f64::consts::PI;

#[test]
fn little_friction_gives_a_high_speed_and_keeps_its_digits() {
    for mechanism in Mechanism::ALL {
        let mut last: Option<f64> = None;
        for power in 2..=12 {
            let friction = libm::exp10(-f64::from(power));
            let engagement = Engagement::new(&escapement(mechanism, 0.07, friction)).expect("an engagement");
            let steady = engagement.steady_state().expect("a terminal speed");
            // For μ → 0 the loss goes as μ u, so that u goes as 1/μ.
            let constant = steady.entry_speed * steady.entry_speed * friction;
            if let Some(last) = last {
                assert!(
                    (constant / last - 1.0).abs() < 10.0 * friction.sqrt(),
                    "{mechanism:?} {friction} {constant} {last}"
                );
            }
            last = Some(constant);
            assert!((1.0 - steady.multiplier) / friction < 1e3, "{mechanism:?} {friction}");
        }
    }
}

#[test]
fn near_the_critical_friction_there_is_a_number_or_a_reason() {
    for mechanism in Mechanism::ALL {
        for inertia in [1e-3, 0.07, 1.0, 50.0] {
            let limit = existence::critical_friction(mechanism, inertia).expect("sound").friction;
            for gap in [0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-9, 1e-12] {
                let escapement = escapement(mechanism, inertia, limit * (1.0 - gap));
                match Engagement::with_tolerance(&escapement, 1e-10) {
                    Ok(engagement) => {
                        let steady = engagement.steady_state().expect("a terminal speed");
                        let end = engagement.return_map(steady.entry_speed).expect("a speed");
                        assert!((end / steady.entry_speed - 1.0).abs() < 1e-9, "{mechanism:?} {inertia} {gap}");
                        assert!(
                            steady.period.is_finite() && steady.minimum.speed > 0.0,
                            "{mechanism:?} {inertia} {gap}"
                        );
                        assert!((0.0..1.0).contains(&steady.multiplier), "{mechanism:?} {inertia} {gap}");
                    }
                    Err(error) => {
                        assert!(
                            matches!(error, DynamicsError::TooSharp { .. }) && gap < 1e-4,
                            "{mechanism:?} {gap} {error}"
                        );
                        assert!(error.to_string().contains("lower the friction"), "{error}");
                    }
                }
            }
        }
    }
}

#[test]
fn extreme_inertias_give_numbers_or_a_reason() {
    for mechanism in Mechanism::ALL {
        for power in [-300, -100, -30, -15, -9, -6, -3, 3, 6, 9, 15, 30, 100, 300] {
            let inertia = libm::exp10(f64::from(power));
            let limit = existence::critical_friction(mechanism, inertia).expect("sound").friction;
            for friction in [0.0, 1e-300, limit.min(1e3) * 0.5, limit.min(1e300) * 0.9] {
                let engagement = match Engagement::with_tolerance(&escapement(mechanism, inertia, friction), 1e-8) {
                    Ok(engagement) => engagement,
                    Err(error) => {
                        assert!(matches!(error, DynamicsError::TooSharp { .. }), "{error}");
                        continue;
                    }
                };
                match engagement.steady_state() {
                    Ok(steady) => {
                        let all = [steady.entry_speed, steady.peak.speed, steady.minimum.speed, steady.period];
                        assert!(
                            all.iter().all(|x| x.is_finite() && *x > 0.0),
                            "{mechanism:?} {inertia} {friction} {steady:?}"
                        );
                    }
                    Err(error) => assert!(matches!(error, DynamicsError::NoTerminalSpeed { .. }), "{error}"),
                }
                for speed in [0.0, 1e-300, 1e-150, 1.0, 1e100] {
                    if let Ok(passage) = engagement.passage(speed) {
                        assert!(passage.duration() > 0.0, "{mechanism:?} {inertia} {friction} {speed}");
                        let _ = (passage.extremes(), passage.multiplier());
                    }
                }
            }
        }
    }
}

#[test]
fn impossible_requests_are_named() {
    let escapement = escapement(Mechanism::FOUR_PIN, 0.07, 0.21);
    for reset in [0.0, -1.0, f64::NAN, f64::INFINITY, PI + PI / 4.0, 9.0] {
        let error = Engagement::reset_after(&escapement, reset, 1e-12).expect_err("no reset angle");
        assert!(matches!(error, DynamicsError::Reset { .. }) && error.to_string().contains("reset angle"), "{error}");
    }
    for tolerance in [0.0, -1.0, 1.0, f64::NAN, TOLERANCES.start() / 2.0, TOLERANCES.end() * 2.0] {
        let error = Engagement::with_tolerance(&escapement, tolerance).expect_err("no tolerance");
        assert!(matches!(error, DynamicsError::OutOfRange { .. }), "{error}");
    }
    let engagement = Engagement::new(&escapement).expect("an engagement");
    for speed in [-1.0, f64::NAN, f64::INFINITY, 1e200] {
        assert!(matches!(engagement.passage(speed), Err(DynamicsError::Speed { .. })), "{speed}");
        assert!(matches!(engagement.return_map(speed), Err(DynamicsError::Speed { .. })), "{speed}");
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(engagement.run(bad, 1.0), Err(DynamicsError::NotPositive { .. })), "{bad}");
        assert!(matches!(engagement.run(1.0, bad), Err(DynamicsError::NotPositive { .. })), "{bad}");
    }
    assert!(matches!(engagement.run(1e-9, 1.0), Err(DynamicsError::TooMany { .. })));
    for settled in [0.0, 1.0, f64::NAN, -0.5] {
        assert!(engagement.rise(settled).is_err(), "{settled}");
    }
}

#[test]
fn what_has_one_solution_within_the_slot_has_one_beyond() {
    for mechanism in Mechanism::ALL {
        for inertia in [0.01, 0.07, 0.7] {
            let limit = existence::critical_friction(mechanism, inertia).expect("sound").friction;
            for part in [0.2, 0.6, 0.9, 0.99, 0.9999] {
                let escapement = escapement(mechanism, inertia, limit * part);
                let half = mechanism.engagement_half_angle();
                let least = existence::least_margin(mechanism, inertia, escapement.friction()).expect("sound").margin;
                for step in 0..=1000 {
                    let angle = half + (PI - half) * f64::from(step) / 1000.0;
                    let margin = existence::margin(&escapement.pose(angle), inertia, escapement.friction());
                    assert!(margin > least, "{mechanism:?} {inertia} {part} {angle}");
                }
                let reset_after =
                    Engagement::reset_after(&escapement, 0.95 * (PI + half), 1e-10).expect("one solution");
                assert!(reset_after.steady_state().is_ok(), "{mechanism:?} {inertia} {part}");
            }
        }
    }
}
