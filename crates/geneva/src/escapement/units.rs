//! Torque and inertias in SI units, for those who gave them in others.

use super::arguments::Units;
use geneva_dynamics::Parameters;
use serde::Serialize;
use uom::si::f64::{Time, Torque};
use uom::si::time::second;
use uom::si::torque::{newton_meter, pound_force_inch};

/// What was given, in SI units.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct InSi {
    pub torque_n_m: f64,
    pub driver_inertia_kg_m2: f64,
    pub follower_inertia_kg_m2: f64,
}

impl InSi {
    /// The parameters, which are in these units.
    pub fn new(parameters: &Parameters, units: Units) -> Self {
        let torque = |value: f64| match units {
            Units::InLbS => Torque::new::<pound_force_inch>(value),
            Units::Si => Torque::new::<newton_meter>(value),
        };
        // An inertia in a coherent system is a torque times the square of a time.
        let time = Time::new::<second>(1.0);
        let inertia = |value: f64| (torque(value) * time * time).value;
        Self {
            torque_n_m: torque(parameters.torque()).get::<newton_meter>(),
            driver_inertia_kg_m2: inertia(parameters.inertias().driver()),
            follower_inertia_kg_m2: inertia(parameters.inertias().follower()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;

    #[test]
    fn a_pound_is_a_mass_of_a_pound_under_standard_gravity() {
        let inertias = Inertias::new(2.0, 3.0).expect("inertias");
        let parameters = Parameters::new(Mechanism::FOUR_PIN, inertias, 5.0, 0.1).expect("an escapement");
        // 0.0254 m, 0.45359237 kg and 9.80665 m/s² are exact by definition; their product, in pieces.
        let inch_pound = 254.0 / 1e4 * (45_359_237.0 / 1e8) * (980_665.0 / 1e5);
        let found = InSi::new(&parameters, Units::InLbS);
        approx::assert_relative_eq!(found.torque_n_m, 5.0 * inch_pound, max_relative = 1e-6);
        approx::assert_relative_eq!(found.driver_inertia_kg_m2, 2.0 * inch_pound, max_relative = 1e-6);
        approx::assert_relative_eq!(found.follower_inertia_kg_m2, 3.0 * inch_pound, max_relative = 1e-6);
        let same = InSi::new(&parameters, Units::Si);
        assert_eq!([same.torque_n_m, same.driver_inertia_kg_m2, same.follower_inertia_kg_m2], [5.0, 2.0, 3.0]);
    }
}
