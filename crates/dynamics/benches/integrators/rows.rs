//! Forty-nine escapements: three mechanisms with an inertia ratio each, four frictions, torques in steps.

use geneva_dynamics::{Inertias, Parameters, Slots};

/// Like the table of a study, with numbers of no source.
pub fn escapements() -> Vec<Parameters> {
    let ratios = [(Slots::Three, 0.7), (Slots::Four, 0.07), (Slots::Six, 0.07)];
    let all = (0..49_u32).filter_map(|number| {
        let (slots, ratio) = ratios[number as usize % 3];
        let (friction, torque) = (0.17 + 0.05 * f64::from(number / 3 % 4), 1.0 + f64::from(number / 12));
        Parameters::new(slots, Inertias::new(ratio, 1.0).ok()?, torque, friction).ok()
    });
    all.collect()
}
