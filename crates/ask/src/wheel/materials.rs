//! Materials of pins and wheel: from the list, or with numbers of one's own.

use super::question::WheelQuestion;
use crate::Error;
use crate::number_format::as_typed;
use geneva_dynamics::line_contact::{MATERIALS, Material};

const GIGA: f64 = 1e9;
const MEGA: f64 = 1e6;
/// Poisson's ratio that no common material exceeds.
const MOST_POISSON: f64 = 0.5;

/// The materials of pins and wheel: steel unless another is named, each number replaced by what is given for it.
///
/// # Errors
///
/// A Poisson's ratio above a half.
pub(super) fn materials(question: &WheelQuestion) -> Result<[Material; 2], Error> {
    let pins = [question.pin_modulus, question.pin_poisson, question.pin_strength];
    let wheel = [question.wheel_modulus, question.wheel_poisson, question.wheel_strength];
    Ok([own("pin", question.pin_material, pins)?, own("wheel", question.wheel_material, wheel)?])
}

fn own(part: &str, named: Option<Material>, [modulus, poisson, strength]: [Option<f64>; 3]) -> Result<Material, Error> {
    let listed = named.unwrap_or(MATERIALS[0]);
    if let Some(poisson) = poisson.filter(|poisson| *poisson > MOST_POISSON) {
        return Err(refused!(
            "--{part}-poisson {}: Poisson's ratio is from 0 to 0.5; give that of the material",
            as_typed(poisson)
        ));
    }
    Ok(Material {
        modulus: modulus.map_or(listed.modulus, |modulus| modulus * GIGA),
        poisson: poisson.unwrap_or(listed.poisson),
        strength: strength.map_or(listed.strength, |strength| strength * MEGA),
        ..listed
    })
}
