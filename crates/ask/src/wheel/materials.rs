//! Materials of pins, wheel and driver: from the list, or with numbers of one's own.

use super::mounting::PinKind;
use super::question::WheelQuestion;
use geneva_dynamics::line_contact::{MATERIALS, Material};
use geneva_kinematics::wheel::as_built::Process;

const GIGA: f64 = 1e9;
const MEGA: f64 = 1e6;

/// Of what the parts are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartMaterials {
    /// Material of the pins.
    pub pin: Material,
    /// Material of the wheel.
    pub wheel: Material,
    /// Material of locking disc and plate.
    pub driver: Material,
}

/// What is given for a material instead of its own: modulus in GPa, Poisson's ratio, strength in MPa, and density in kg/m³.
type OwnNumbers = [Option<f64>; 4];

impl PartMaterials {
    /// The materials that a question asks for, each number replaced by what is given for it.
    pub(super) fn of(question: &WheelQuestion) -> Self {
        let of_pin = [question.pin_modulus, question.pin_poisson, question.pin_strength, question.pin_density];
        let of_wheel = [question.wheel_modulus, question.wheel_poisson, question.wheel_strength, question.density];
        let of_driver = [None, None, question.driver_strength, question.driver_density];
        let [usual_pin, usual_wheel] = usual(question);
        let wheel = own(question.wheel_material.unwrap_or(usual_wheel), of_wheel);
        let driver = own(question.driver_material.unwrap_or(wheel), of_driver);
        let of_one_piece = question.driver_material.filter(|_| has_joined_pins(question)).map(|_| driver);
        let pin = own(question.pin_material.or(of_one_piece).unwrap_or(usual_pin), of_pin);
        Self { pin, wheel, driver }
    }
}

/// Whether the pins are in one piece with their plate: no dowel or screw is in their place, and no plate is cut from a sheet.
fn has_joined_pins(question: &WheelQuestion) -> bool {
    let mounting = &question.mounting;
    let is_cut = matches!(question.process, Some(Process::Laser | Process::Router));
    mounting.pin_mount != Some(PinKind::Dowel) && mounting.pin_screw.is_none() && !is_cut
}

/// The materials of pins and wheel that are not named: steel, or what a process is made for. A printed pin is of one piece with its
/// plate unless a dowel or a screw is in its place.
fn usual(question: &WheelQuestion) -> [Material; 2] {
    let named = |name: &str| MATERIALS.into_iter().find(|of| of.name == name).unwrap_or(MATERIALS[0]);
    let steel = MATERIALS[0];
    let printed = |material| [if has_joined_pins(question) { material } else { steel }, material];
    match question.process {
        None | Some(Process::Ground | Process::Mill) => [steel; 2],
        Some(Process::Router) => [steel, named("mdf")],
        Some(Process::Laser) => [steel, named("acrylic")],
        Some(Process::Resin) => printed(named("acrylic")),
        Some(Process::Fdm) => printed(named("pla")),
    }
}

fn own(listed: Material, [modulus, poisson, strength, density]: OwnNumbers) -> Material {
    Material {
        modulus: modulus.map_or(listed.modulus, |modulus| modulus * GIGA),
        poisson: poisson.unwrap_or(listed.poisson),
        strength: strength.map_or(listed.strength, |strength| strength * MEGA),
        density: density.unwrap_or(listed.density),
        ..listed
    }
}
