//! What the designer's controls give: the command's arguments with their values.

use crate::control::Settings;
use geneva_ask::wheel::{Argument, ArgumentSlot, Knob, arguments};

/// The side of a group that the reader gave last: the first unless another was moved.
fn given_side(settings: &Settings, group: &str) -> Result<usize, String> {
    for argument in arguments() {
        if let Some(Knob { side: Some((of, number)), .. }) = argument.knob
            && of == group
            && number > 0
            && settings.value_if_moved(argument.name)?.is_some()
        {
            return Ok(number);
        }
    }
    Ok(0)
}

/// The arguments that these settings give, each with its value: of a choice its number.
pub(crate) fn given(settings: &Settings) -> Result<Vec<(&'static Argument, f64)>, String> {
    let mut given = Vec::new();
    for argument in arguments() {
        let Some(knob) = argument.knob else { continue };
        let is_given = match knob.side {
            Some((group, number)) => number == given_side(settings, group)?,
            None => true,
        };
        if !is_given {
            continue;
        }
        let value = match (argument.place, knob.first) {
            (
                ArgumentSlot::Stations(_)
                | ArgumentSlot::Pins(_)
                | ArgumentSlot::Material(_)
                | ArgumentSlot::Choice(_)
                | ArgumentSlot::Process(_),
                _,
            ) => Some(f64::from(settings.count(argument.name)?)),
            (ArgumentSlot::Count(_), _) => match settings.value_if_moved(argument.name)? {
                Some(_) => Some(f64::from(settings.count(argument.name)?)),
                None => None,
            },
            (_, Some(_)) => Some(settings.value(argument.name)?),
            (_, None) => settings.value_if_moved(argument.name)?,
        };
        given.extend(value.map(|value| (argument, value)));
    }
    // The play of a test piece replaces that of its process: without one, it waits until one is chosen.
    let has_process =
        |(argument, value): &(&Argument, f64)| matches!(argument.place, ArgumentSlot::Process(_)) && *value > 0.0;
    if !given.iter().any(has_process) {
        given.retain(|(argument, _)| argument.name != "measured-play");
    }
    Ok(given)
}
