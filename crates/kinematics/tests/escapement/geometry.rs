//! Are there only three escapements, and do they have the sizes of wheels without dwell?

use geneva_kinematics::escapement::{EscapementError, Mechanism, pins_needed, possible_pairs};
use geneva_kinematics::indexing::{Indexing, Phase};
use geneva_kinematics::{Turn, rational};
use std::f64::consts::PI;

#[test]
fn the_three_are_all_that_trying_finds() {
    let mut found = Vec::new();
    for slots in 1..=2000_u64 {
        for pins in 1..=2000_u64 {
            if 2 * (slots + pins) == slots * pins {
                found.push((slots as u32, pins as u32));
            }
        }
    }
    assert_eq!(found, possible_pairs());
    assert_eq!(found, Mechanism::ALL.map(|one| (one.slots(), one.pins())));
    assert!(Mechanism::ALL.iter().enumerate().all(|(index, one)| one.index() == index));
}

#[test]
fn the_formula_is_whole_for_these_only_and_never_comes_down_to_two() {
    for slots in (3..=10_000).chain([1_000_000_007, u32::MAX]) {
        let pins = pins_needed(slots).unwrap();
        let whole = possible_pairs().iter().any(|&(n, m)| n == slots && rational(m.into(), 1) == pins);
        assert_eq!(pins.denominator().is_one(), whole, "{slots}");
        assert!(pins > rational(2, 1), "{slots}");
        assert_eq!(Mechanism::new(slots).is_ok(), whole, "{slots}");
        assert!(slots <= 6 || pins < rational(3, 1), "{slots}");
    }
    assert_eq!((pins_needed(2), pins_needed(0)), (None, None));
}

#[test]
fn what_does_not_exist_is_said_with_what_does() {
    let message = Mechanism::new(5).unwrap_err().to_string();
    assert!(message.contains("5 slots") && message.contains("3, 4 or 6"), "{message}");
    for slots in [0, 1, 2, 7, 18, u32::MAX] {
        assert_eq!(Mechanism::new(slots), Err(EscapementError::Slots(slots)));
    }
}

#[test]
fn sizes_are_those_of_a_wheel_without_dwell() {
    for escapement in Mechanism::ALL {
        let (n, m) = (f64::from(escapement.slots()), f64::from(escapement.pins()));
        assert_eq!(escapement.wheel().dwell_fraction(), 0.0);
        approx::assert_relative_eq!(escapement.engagement_half_angle(), PI / m, max_relative = 1e-15);
        approx::assert_relative_eq!(escapement.follower_half_angle(), PI / n, max_relative = 1e-15);
        approx::assert_relative_eq!(escapement.driver_pitch_angle(), 2.0 * PI / m, max_relative = 1e-15);
        approx::assert_relative_eq!(escapement.centre_distance_ratio(), 1.0 / (PI / n).sin(), max_relative = 1e-15);
        assert_eq!(escapement.centre_distance_ratio(), escapement.wheel().centre_distance_ratio());
        assert_eq!(escapement.rim_radius(), escapement.wheel().wheel_radius_ratio());
        // The form of appendix A, and the general distance at exit.
        let entry = (PI / m).sin() / (PI / n).sin();
        approx::assert_relative_eq!(escapement.rim_radius(), entry, max_relative = 1e-15);
        let exit = Turn::from_radians(escapement.engagement_half_angle());
        approx::assert_relative_eq!(escapement.pin_distance(&exit), entry, max_relative = 1e-14);
    }
    let sizes = Mechanism::ALL.map(Mechanism::mean_ratio);
    assert_eq!(sizes, [rational(2, 1), rational(1, 1), rational(1, 2)]);
}

#[test]
fn the_follower_goes_on_at_its_mean_ratio_and_never_dwells() {
    for escapement in Mechanism::ALL {
        let (wheel, pitch) = (escapement.wheel(), escapement.driver_pitch_angle());
        for pin in 0..escapement.pins() / 2 {
            for step in 1..200 {
                let crank = pitch * (f64::from(pin) + f64::from(step) / 200.0 - 0.5);
                let motion = wheel.motion(7, crank).unwrap();
                assert_eq!(motion.phase, Phase::Advance);
                assert!(motion.velocity > 0.0);
            }
        }
        let half = escapement.engagement_half_angle();
        let (first, last) = (wheel.engaged(-half).unwrap(), wheel.engaged(half).unwrap());
        approx::assert_relative_eq!(last.angle - first.angle, escapement.follower_pitch_angle(), max_relative = 1e-15);
        // Simpson's rule over the velocity ratio gives its mean.
        let steps = 400;
        let sum: f64 = (0..=steps)
            .map(|k| {
                let weight = if k == 0 || k == steps { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                weight * wheel.velocity_ratio(half * (2.0 * f64::from(k) / f64::from(steps) - 1.0)).unwrap()
            })
            .sum();
        let mean = sum / (3.0 * f64::from(steps));
        let ratio = escapement.mean_ratio().to_f64().value();
        approx::assert_relative_eq!(mean, ratio, max_relative = 1e-6);
    }
}
