//! Materials of pins and wheel: from the list, or with numbers of one's own.

use super::question::WheelQuestion;
use geneva_dynamics::line_contact::{MATERIALS, Material};
use geneva_kinematics::wheel::as_built::Process;

const GIGA: f64 = 1e9;
const MEGA: f64 = 1e6;

/// The materials of pins and wheel, each number replaced by what is given for it.
pub(super) fn materials(question: &WheelQuestion) -> [Material; 2] {
    let pins = [question.pin_modulus, question.pin_poisson, question.pin_strength];
    let wheel = [question.wheel_modulus, question.wheel_poisson, question.wheel_strength];
    let [of_pin, of_wheel] = usual(question);
    [own(question.pin_material.unwrap_or(of_pin), pins), own(question.wheel_material.unwrap_or(of_wheel), wheel)]
}

/// The materials of pins and wheel that are not named: steel, or what a process is made for. A printed pin is of one piece with its
/// plate unless a dowel or a screw is in its place.
fn usual(question: &WheelQuestion) -> [Material; 2] {
    let named = |name: &str| MATERIALS.into_iter().find(|of| of.name == name).unwrap_or(MATERIALS[0]);
    let steel = MATERIALS[0];
    let mounting = &question.mounting;
    let is_printed = mounting.pin_mount.is_none() && mounting.pin_screw.is_none();
    let printed = |material| [if is_printed { material } else { steel }, material];
    match question.process {
        None | Some(Process::Ground | Process::Mill) => [steel; 2],
        Some(Process::Router) => [steel, named("mdf")],
        Some(Process::Laser) => [steel, named("acrylic")],
        Some(Process::Resin) => printed(named("acrylic")),
        Some(Process::Fdm) => printed(named("pla")),
    }
}

fn own(listed: Material, [modulus, poisson, strength]: [Option<f64>; 3]) -> Material {
    Material {
        modulus: modulus.map_or(listed.modulus, |modulus| modulus * GIGA),
        poisson: poisson.unwrap_or(listed.poisson),
        strength: strength.map_or(listed.strength, |strength| strength * MEGA),
        ..listed
    }
}
