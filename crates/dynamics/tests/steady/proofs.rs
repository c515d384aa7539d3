//! Are the identities under the steady motion proven?

use crate::proving::holds;
use geneva_dynamics::steady::proofs::{
    Multiplier, OnACircle, RateOfDecay, SwitchingFactors, SwitchingFunctionFalls, TurningOnTheCircle,
};
use geneva_kinematics::Mechanism;

#[test]
fn the_steady_motion_rests_on_identities() {
    holds("on a circle", &OnACircle);
    for numerator in [true, false] {
        holds("turning on the circle", &TurningOnTheCircle { numerator });
    }
    holds("switching function", &SwitchingFactors);
    holds("rate of decay", &RateOfDecay);
    holds("multiplier", &Multiplier);
    holds("switch falls", &SwitchingFunctionFalls);
}

#[test]
fn the_switching_function_falls_all_the_way() {
    // A cubic in ρ between 0 and its value on the line of centres, c (1 + a): positive by a fine net and its slope.
    for mechanism in Mechanism::ALL {
        let centre = 1.0 / (mechanism.centre_distance_ratio_squared() - 1.0);
        let end = centre * (1.0 + mechanism.centre_distance_ratio());
        let steps = 100_000;
        let width = end / f64::from(steps);
        let steepest = 2.0 * centre + 2.0 * end + (2.0 * end + centre) * (1.0 + 4.0 * end) + 4.0 * end * end;
        for step in 0..=steps {
            let numerator = width * f64::from(step);
            let value = centre + 2.0 * centre * numerator - numerator * numerator
                + (numerator - centre) * numerator * (1.0 + 2.0 * numerator);
            assert!(value > steepest * width, "{mechanism:?} {numerator} {value}");
        }
    }
}
