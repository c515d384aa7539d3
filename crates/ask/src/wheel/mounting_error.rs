//! Errors about what can't be mounted, with the arguments that change it.

use super::arguments::MOUNTING;
use super::fitting::{Fit, refusal, remedies_among};
use super::question::WheelQuestion;
use crate::Error;
use crate::number_format::{as_typed, rounded_down};
use geneva_workshop::MountingError;

/// The play of a bore over the depth of a flat with which the flat is told to hold: our choice.
const HALF: f64 = 0.5;

/// The error about what can't be mounted, with the arguments of the mounting that mend it; `fits` says how the parts of a question fit.
pub(super) fn with_remedies_of_mounting(
    error: MountingError,
    question: &WheelQuestion,
    fits: impl Fn(&WheelQuestion) -> Fit,
) -> Error {
    if question.is_trial {
        return Error::Argument(error.to_string());
    }
    let in_range = |other: &WheelQuestion| if other.is_in_range() { fits(other) } else { Fit::Not };
    let remedies = remedies_among(MOUNTING, question, in_range);
    if remedies.is_empty() {
        return with_arguments(error, question);
    }
    // What to choose stands behind what is wrong, and values say it better.
    let words = error.to_string();
    let reason = words.split_once("; ").map_or(words.as_str(), |(reason, _)| reason);
    let less_play = match error {
        MountingError::LooseFlat { across, shaft, .. } => {
            format!(", or --bore-play up to {}", rounded_down(HALF * (shaft - across)))
        }
        _ => String::new(),
    };
    Error::Argument(refusal(reason, &remedies) + &less_play)
}

/// The error about what can't be mounted, with the arguments that change it.
pub(super) fn with_arguments(error: MountingError, question: &WheelQuestion) -> Error {
    let asked = &question.mounting;
    let numbers = match &error {
        MountingError::BreaksOut { hole, .. } | MountingError::TooDeep { hole, .. } => match *hole {
            "a hole of the hub" => vec![
                ("wheel-hub-circle", asked.wheel_hub_circle),
                ("driver-hub-circle", asked.driver_hub_circle),
                ("hub-dowel", asked.hub_dowel),
            ],
            "a hole between disc and plate" => {
                vec![("disc-dowel-circle", asked.disc_dowel_circle), ("disc-dowel", asked.disc_dowel)]
            }
            "the bore" => vec![
                ("wheel-shaft", question.wheel_shaft),
                ("driver-shaft", question.driver_shaft),
                ("plate-shaft", question.plate_shaft),
            ],
            _ => Vec::new(),
        },
        _ => Vec::new(),
    };
    let given = numbers.iter().filter_map(|(name, value)| Some(format!("--{name} {}", as_typed((*value)?))));
    let given = given.collect::<Vec<_>>().join(", ");
    if given.is_empty() { refused!("{error}") } else { refused!("{error} ({given})") }
}
