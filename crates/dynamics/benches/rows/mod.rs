//! Forty-nine escapements: three mechanisms with an inertia ratio each, four frictions, torques in steps.

use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// Like the table of a study, with numbers of no source.
pub(crate) fn escapements() -> Vec<Parameters> {
    let ratios = [(Mechanism::SIX_PIN, 0.7), (Mechanism::FOUR_PIN, 0.07), (Mechanism::THREE_PIN, 0.07)];
    let all = (0..49_u32).filter_map(|number| {
        let (mechanism, ratio) = ratios[number as usize % 3];
        let (friction, torque) = (0.17 + 0.05 * f64::from(number / 3 % 4), 1.0 + f64::from(number / 12));
        Parameters::new(mechanism, Inertias::new(ratio, 1.0).ok()?, torque, friction).ok()
    });
    all.collect()
}
