//! What is asked of an escapement.

use crate::{Error, number, pairs};
use geneva_dynamics::joints::Joints;

/// What is asked of an escapement; torque and inertias in units that fit each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EscapementQuestion {
    /// Number of slots of the follower: 3, 4 or 6.
    pub slots: u32,
    /// Coefficient of friction between pin and slot.
    pub friction: f64,
    /// Torque of the spring on the driver.
    pub torque: f64,
    /// Moment of inertia of the driver about its axis.
    pub driver_inertia: f64,
    /// Moment of inertia of the follower about its axis.
    pub follower_inertia: f64,
    /// Units of torque and inertias, to report them in SI units too.
    pub units: Option<UnitSystem>,
    /// Turn of the driver, in degrees, after which its angle is reset, unless that is the turn from pin to pin.
    pub reset_deg: Option<f64>,
    /// What has no name at the command line.
    pub further: Further,
}

/// Arguments that have no name at the command line, and to which only further fields answer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Further {
    /// Distance from the driver's axis to a pin's centre, in millimetres (`--crank-radius`).
    pub crank_radius: Option<f64>,
    /// Width of a slot less the diameter of the pin, in crank radii (`--play`).
    pub play: Option<f64>,
    /// Coefficient of friction with which the timer was set right (`--set-friction`).
    pub set_friction: Option<f64>,
    /// Radii of the pin and of the journals, in crank radii, and the friction of the journals (`--pin-radius`,
    /// `--driver-journal`, `--follower-journal`, `--bearing-friction`).
    pub joints: Option<Joints>,
}

impl Further {
    /// The radii of the pin and of the journals of driver and follower, in crank radii, and the friction of the journals; nothing
    /// else is asked.
    pub fn with_joints([pin_radius, driver_journal, follower_journal, bearing_friction]: [f64; 4]) -> Self {
        let joints = Joints { pin_radius, driver_journal, follower_journal, bearing_friction, ..Joints::IDEAL };
        Self { joints: Some(joints), ..Self::default() }
    }
}

/// Coherent systems of units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitSystem {
    /// Inch, pound-force and second: torque in in lb, inertias in in lb s².
    InLbS,
    /// Metre, kilogram and second: torque in N m, inertias in kg m².
    Si,
}

impl UnitSystem {
    /// The unit of torque in N m, which is that of inertia in kg m², for the unit of time is the second.
    ///
    /// A pound is the weight of 0.45359237 kg where gravity is standard, 9.80665 m/s², and an inch is 0.0254 m, all by
    /// definition.
    pub(super) fn torque_n_m(self) -> f64 {
        match self {
            Self::InLbS => 0.0254 * 0.453_592_37 * 9.806_65,
            Self::Si => 1.0,
        }
    }
}

/// The arguments that are measured, by their names; the first four are needed.
const MEASURES: [&str; 12] = [
    "friction",
    "torque",
    "driver-inertia",
    "follower-inertia",
    "reset-deg",
    "crank-radius",
    "play",
    "set-friction",
    "pin-radius",
    "driver-journal",
    "follower-journal",
    "bearing-friction",
];

impl EscapementQuestion {
    /// Reads arguments as they are typed: `--slots 4 --friction 0.2 --torque 0.3 --driver-inertia 4e-6 --follower-inertia 5e-5`.
    /// Of an argument that is given twice the last counts.
    ///
    /// # Errors
    ///
    /// An argument that there is not, one that is missing, and a value that it can't have.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let (mut slots, mut units, mut measures) = (None, None, [None; MEASURES.len()]);
        for pair in pairs(text) {
            match pair? {
                ("slots", value) => slots = Some(number("slots", value)?),
                ("units", "in-lb-s") => units = Some(UnitSystem::InLbS),
                ("units", "si") => units = Some(UnitSystem::Si),
                (name, value) => {
                    let place = MEASURES.iter().zip(&mut measures).find(|(known, _)| **known == name);
                    let (_, place) = place.ok_or_else(|| {
                        refused!("--{name} {value}: give --slots, --units in-lb-s or si, --{}", MEASURES.join(", --"))
                    })?;
                    *place = Some(number(name, value)?);
                }
            }
        }
        let [friction, torque, driver, follower, reset_deg, crank_radius, play, set_friction, joints @ ..] = measures;
        let joints = joints.iter().any(Option::is_some).then(|| joints.map(Option::unwrap_or_default));
        let further = joints.map_or_else(Further::default, Further::with_joints);
        let needed = |name, value: Option<f64>| value.ok_or_else(|| refused!("--{name} is missing; give it"));
        Ok(Self {
            slots: slots.ok_or_else(|| refused!("--slots is missing; give it"))?,
            friction: needed("friction", friction)?,
            torque: needed("torque", torque)?,
            driver_inertia: needed("driver-inertia", driver)?,
            follower_inertia: needed("follower-inertia", follower)?,
            units,
            reset_deg,
            further: Further { crank_radius, play, set_friction, ..further },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{EscapementQuestion, UnitSystem};

    #[test]
    fn a_pound_is_a_mass_of_a_pound_under_standard_gravity() {
        // 1 in = 254/1e4 m, 1 lb = 45359237/1e8 kg and 980665/1e5 m/s²: their product is a fraction of integers.
        let fraction = (254_u64 * 45_359_237 * 980_665) as f64 / 1e17;
        approx::assert_relative_eq!(UnitSystem::InLbS.torque_n_m(), fraction, max_relative = 1e-15);
        // The inverse, as tables give it: a newton metre is 8.850746 inch pounds.
        approx::assert_relative_eq!(1.0 / UnitSystem::InLbS.torque_n_m(), 8.850_746, max_relative = 1e-7);
        assert_eq!(UnitSystem::Si.torque_n_m(), 1.0);
    }

    #[test]
    fn what_is_asked_is_read_as_it_is_typed() {
        let four = "--slots 4 --friction 0.2 --torque 2 --driver-inertia 4e-6 --follower-inertia 6e-5";
        let question = EscapementQuestion::parse(&format!("{four} --friction 0.3 --pin-radius 0.1")).expect("complete");
        let joints = question.further.joints.expect("a pin");
        assert_eq!([question.friction, joints.pin_radius, joints.driver_journal], [0.3, 0.1, 0.0]);
        assert_eq!(EscapementQuestion::parse(four).expect("complete").further.joints, None);
        for (text, words) in [
            ("--slots 4 --friction 0.2", "--torque is missing"),
            (&four.replace("--slots 4", ""), "--slots is missing"),
            (&format!("{four} --units cgs"), "--units cgs: give --slots, --units in-lb-s or si"),
            (&format!("{four} --oil 1"), "--oil 1: give --slots"),
            (&format!("{four} --play x"), "--play x: not a number"),
        ] {
            let error = EscapementQuestion::parse(text).expect_err(text).to_string();
            assert!(error.contains(words), "{error}");
        }
    }
}
