//! The mouths of the slots: what is asked of them, and what they do to play and blow.

use super::arguments::{Argument, FIT};
use super::question::WheelQuestion;
use crate::Error;
use crate::number_format::as_typed;
use geneva_kinematics::wheel::Mouth;

/// Angle of a chamfer to the wall, in degrees, unless it is given: the one that a workshop means by a chamfer's width alone.
pub(super) const ANGLE: f64 = 45.0;
/// Flare of a lead-in over its length unless it is given, dimensionless; our choice. On wheels of four to twelve stations with the
/// play that the program chooses, no other flare of that length makes the hardest blow softer by more than a third.
const OF_LENGTH: f64 = 0.1;

/// The arguments that say which mouths the slots have, and no others.
///
/// ```
/// let names: Vec<&str> = geneva_ask::wheel::mouth_arguments().map(|argument| argument.name).collect();
/// assert_eq!(names, ["mouth-chamfer", "mouth-angle", "mouth-radius", "lead-in", "lead-in-flare"]);
/// ```
pub fn mouth_arguments() -> impl Iterator<Item = &'static Argument> {
    FIT.iter().filter(|argument| argument.name.starts_with("mouth-") || argument.name.starts_with("lead-in"))
}

/// The mouth that a question describes, if it names one.
pub(super) fn asked_mouth(question: &WheelQuestion) -> Option<Mouth> {
    let given = |size: Option<f64>| size.filter(|size| *size != 0.0);
    let chamfer = given(question.mouth_chamfer)
        .map(|width| Mouth::Chamfer { width, angle: question.mouth_angle.unwrap_or(ANGLE).to_radians() });
    let round = given(question.mouth_radius).map(|radius| Mouth::Round { radius });
    let lead_in = given(question.lead_in)
        .map(|length| Mouth::LeadIn { length, flare: question.lead_in_flare.unwrap_or(OF_LENGTH * length) });
    chamfer.or(round).or(lead_in)
}

/// The arguments that give a mouth its shape, and what was given.
fn mouth_shapes(question: &WheelQuestion) -> [(&'static str, Option<f64>); 3] {
    [("mouth-chamfer", question.mouth_chamfer), ("mouth-radius", question.mouth_radius), ("lead-in", question.lead_in)]
}

/// The arguments with which a mouth is not sharp, and their sizes in millimetres.
pub(super) fn given_mouths(question: &WheelQuestion) -> impl Iterator<Item = (&'static str, f64)> {
    mouth_shapes(question).into_iter().filter_map(|(name, size)| Some((name, size.filter(|size| *size != 0.0)?)))
}

/// Refuses two shapes for one mouth, and sizes of a shape that the mouth does not have.
pub(super) fn check_mouth(question: &WheelQuestion) -> Result<(), Error> {
    let mut given = given_mouths(question);
    if let (Some((one, first)), Some((other, second))) = (given.next(), given.next()) {
        let (first, second) = (as_typed(first), as_typed(second));
        return Err(refused!("--{one} {first} and --{other} {second}: a mouth has one shape; give one of them"));
    }
    let is_given = |name: &str| mouth_arguments().any(|of| of.name == name && question.number(of).is_some());
    let alone = mouth_arguments().find_map(|of| Some((of, question.number(of)?, of.missing_dependency(is_given)?)));
    match alone {
        Some((Argument { name, .. }, size, without)) => {
            Err(refused!("--{name} {} has no effect {without}", as_typed(size)))
        }
        None => Ok(()),
    }
}
