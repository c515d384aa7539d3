//! Does a scan find the same least margin and critical friction, and are impossible values named?

use geneva_dynamics::Pose;
use geneva_dynamics::existence::{
    critical_friction, critical_inertia_ratio, least_margin, margin, surely_below_critical,
};
use geneva_kinematics::{Mechanism, Turn};

const RATIOS: [(f64, f64); 5] = [(1.0, 20.0), (3.0, 40.0), (3.0, 50.0), (3.0, 5.0), (5.0, 3.0)];

fn brute_force(mechanism: Mechanism, inertia: f64, friction: f64) -> (f64, f64) {
    let steps = 4_000;
    (0..=steps)
        .map(|step| {
            let angle = mechanism.engagement_half_angle() * f64::from(step) / f64::from(steps);
            (
                margin(&Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle)), inertia, friction),
                angle,
            )
        })
        .fold((f64::INFINITY, 0.0), |least, next| if next.0 < least.0 { next } else { least })
}

#[test]
fn the_least_margin_is_the_least_of_many() {
    for mechanism in Mechanism::ALL {
        for (driver, follower) in RATIOS {
            for part in 0..=10 {
                let (inertia, friction) = (driver / follower, f64::from(part) / 20.0);
                let found = least_margin(mechanism, inertia, friction).expect("sound");
                let (least, angle) = brute_force(mechanism, inertia, friction);
                assert!(found.margin <= least + 1e-15 && found.margin > least - 1e-6, "{mechanism:?} {inertia} {part}");
                assert!((found.angle - angle).abs() < 1e-3, "{mechanism:?} {inertia} {part}");
            }
        }
    }
}

#[test]
fn at_the_critical_friction_the_least_margin_is_zero() {
    for mechanism in Mechanism::ALL {
        for (driver, follower) in RATIOS.into_iter().chain([(1.0, 1e6), (1e6, 1.0)]) {
            let inertia = driver / follower;
            let critical = critical_friction(mechanism, inertia).expect("sound");
            println!("{mechanism:?} {inertia}: {} at {}°", critical.friction, critical.angle.to_degrees());
            let there = least_margin(mechanism, inertia, critical.friction).expect("sound");
            assert!(there.margin.abs() < 1e-13 * (1.0 + inertia), "{mechanism:?} {inertia} {}", there.margin);
            assert!((there.angle - critical.angle).abs() < 1e-6, "{mechanism:?} {inertia}");
            let back = critical_inertia_ratio(mechanism, critical.friction).expect("sound");
            approx::assert_relative_eq!(back, inertia, max_relative = 1e-12);
            for (factor, holds) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
                let near = least_margin(mechanism, inertia, critical.friction * factor).expect("sound");
                assert_eq!(near.margin > 0.0, holds, "{mechanism:?} {inertia}");
            }
        }
    }
}

#[test]
fn more_inertia_of_the_driver_bears_more_friction() {
    for mechanism in Mechanism::ALL {
        let limits = (-300..=300)
            .step_by(10)
            .map(|power| critical_friction(mechanism, libm::exp2(f64::from(power))).expect("sound").friction);
        let limits: Vec<_> = limits.collect();
        assert!(limits.windows(2).all(|pair| pair[0] < pair[1]), "{limits:?}");
    }
}

#[test]
fn extreme_values_give_numbers_and_bad_ones_are_named() {
    for mechanism in Mechanism::ALL {
        for inertia in [5e-324, f64::MIN_POSITIVE, 1e-200, 1e200, f64::MAX] {
            let critical = critical_friction(mechanism, inertia).expect("positive and finite");
            assert!(critical.friction > 0.0, "{mechanism:?} {inertia}");
            assert!((0.0..=mechanism.engagement_half_angle() + 1e-12).contains(&critical.angle), "{inertia}");
        }
        for friction in [5e-324, 1e-200, 1e200, f64::MAX] {
            let least = least_margin(mechanism, 1.0, friction).expect("finite");
            assert!(!least.margin.is_nan() && !least.angle.is_nan(), "{mechanism:?} {friction}");
        }
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(critical_friction(mechanism, bad).is_err() && least_margin(mechanism, bad, 0.0).is_err(), "{bad}");
        }
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(
                least_margin(mechanism, 1.0, bad).is_err() && critical_inertia_ratio(mechanism, bad).is_err(),
                "{bad}"
            );
        }
    }
}

#[test]
fn the_cheap_test_accepts_nothing_that_the_exact_one_refuses() {
    for mechanism in Mechanism::ALL {
        for step in -400..=400 {
            let inertia = libm::exp10(f64::from(step) / 4.0);
            let limit = critical_friction(mechanism, inertia).expect("sound").friction;
            for power in 1..=53 {
                let friction = limit * (1.0 + libm::exp2(f64::from(-power)));
                assert!(!surely_below_critical(mechanism, inertia, friction), "{mechanism:?} {inertia} {power}");
            }
            assert!(!surely_below_critical(mechanism, inertia, limit), "{mechanism:?} {inertia}");
            // For inertias as mechanisms have them it leaves little to the exact one.
            let far = if (-8..=4).contains(&step) { 0.99 } else { 0.0 };
            assert!(surely_below_critical(mechanism, inertia, limit * far), "{mechanism:?} {inertia}");
        }
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-101, 1e101, 5e-324, f64::MAX] {
            assert!(!surely_below_critical(mechanism, bad, 0.0), "{bad}");
        }
    }
}

#[test]
fn an_escapement_is_accepted_if_and_only_if_its_friction_is_below_the_critical_one() {
    let accepts = |mechanism, inertia, friction| {
        let inertias = geneva_dynamics::Inertias::new(inertia, 1.0).expect("sound");
        geneva_dynamics::Parameters::new(mechanism, inertias, 1.0, friction).is_ok()
    };
    for mechanism in Mechanism::ALL {
        for step in -300..=300 {
            let inertia = libm::exp10(f64::from(step) / 2.0);
            let limit = critical_friction(mechanism, inertia).expect("sound").friction;
            assert!(accepts(mechanism, inertia, 0.0) && accepts(mechanism, inertia, limit * 0.5));
            assert!(accepts(mechanism, inertia, limit.next_down()) && !accepts(mechanism, inertia, limit));
            assert!(!accepts(mechanism, inertia, limit.next_up()), "{mechanism:?} {inertia}");
            for power in 1..=50 {
                let gap = libm::exp2(f64::from(-power));
                assert!(accepts(mechanism, inertia, limit * (1.0 - gap)), "{mechanism:?} {inertia} {power}");
                assert!(!accepts(mechanism, inertia, limit * (1.0 + gap)), "{mechanism:?} {inertia} {power}");
            }
        }
    }
}
