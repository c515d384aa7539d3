//! Are impossible values named, and does every pose of a sound escapement have one acceleration?

use geneva_dynamics::{DynamicsError, Inertias, Parameters, existence};
use geneva_kinematics::Mechanism;

#[test]
fn impossible_values_are_named() {
    let bad = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let sound = Inertias::new(1.0, 10.0).expect("sound");
    for value in bad {
        assert!(Inertias::new(value, 1.0).is_err() && Inertias::new(1.0, value).is_err(), "{value}");
        assert!(Parameters::new(Mechanism::FOUR_PIN, sound, value, 0.0).is_err(), "{value}");
    }
    for friction in &bad[1..] {
        let error = Parameters::new(Mechanism::FOUR_PIN, sound, 1.0, *friction).expect_err("bad friction");
        assert!(matches!(error, DynamicsError::Negative { .. }), "{error}");
    }
    assert!(Inertias::new(f64::MAX, f64::MIN_POSITIVE).is_err(), "their ratio overflows");
    assert!(Inertias::new(f64::MIN_POSITIVE, f64::MAX).is_err(), "their ratio vanishes");
    let error = Parameters::new(Mechanism::FOUR_PIN, sound, 1.0, 3.0).expect_err("too much friction");
    assert!(matches!(error, DynamicsError::TooMuchFriction { .. }), "{error}");
    assert!(Parameters::new(Mechanism::FOUR_PIN, sound, 1.0, 0.0).is_ok());
}

#[test]
fn every_pose_of_a_sound_escapement_has_one_acceleration() {
    for mechanism in Mechanism::ALL {
        let inertias = Inertias::new(3.0, 50.0).expect("sound");
        let limit = existence::critical_friction(mechanism, inertias.ratio()).expect("sound").friction;
        for part in 0..8 {
            let friction = limit * f64::from(part) / 8.0;
            let escapement = Parameters::new(mechanism, inertias, 7.0, friction).expect("below the limit");
            for step in -100..=100 {
                let angle = mechanism.engagement_half_angle() * f64::from(step) / 100.0;
                for speed in [0.0, 1.0, 30.0] {
                    let acceleration = escapement.acceleration(angle, speed).expect("one acceleration");
                    let coefficients = escapement.coefficients(angle);
                    let residual = coefficients.residual(&speed, &acceleration.value, acceleration.sign);
                    let scale = coefficients.e + coefficients.b.abs() * speed * speed;
                    assert!(residual.abs() < 1e-12 * scale, "{mechanism:?} {angle} {speed}");
                    let bars = coefficients.between_the_bars(&speed, &acceleration.value);
                    assert!(acceleration.sign.apply(bars) >= -1e-12 * scale, "{mechanism:?} {angle} {speed}");
                }
            }
        }
        let escapement = Parameters::new(mechanism, inertias, 7.0, 0.0).expect("no friction");
        for angle in [f64::NAN, f64::INFINITY] {
            assert!(matches!(escapement.acceleration(angle, 1.0), Err(DynamicsError::NotFinite { .. })));
        }
    }
}
