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
    // What depends on another that is not given waits until it is.
    let said: Vec<&str> =
        given.iter().filter(|given| says_something(given)).map(|(argument, _)| argument.name).collect();
    given.retain(|(argument, _)| argument.has_dependency(|name| said.contains(&name)));
    Ok(given)
}

/// Whether a control stands at something: of names, the entry that says nothing is none.
fn says_something((argument, value): &(&Argument, f64)) -> bool {
    match argument.place {
        ArgumentSlot::Process(_) => *value > 0.0,
        ArgumentSlot::Choice(choice) => *value as usize != choice.usual_entry(),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use crate::{DESIGN, LiveArguments};
    use geneva_ask::wheel::arguments;

    #[test]
    fn what_depends_on_another_control_waits_for_it() {
        let command = |setting: &str| {
            let arguments = LiveArguments::parse(setting).expect(setting);
            DESIGN.answer_in_motion(&arguments).expect(setting).command.expect("a command")
        };
        let settings = [
            ("measured-play", "measured-play=0.3", "measured-play=0.3&process=6"),
            ("mouth-angle", "mouth-angle=30&mouth-radius=1", "mouth-angle=30&mouth-chamfer=1"),
            ("lead-in-flare", "lead-in-flare=0.2", "lead-in-flare=0.2&lead-in=3"),
        ];
        for (name, waits, counts) in settings {
            let option = format!("--{name} ");
            assert!(!command(waits).contains(&option), "{waits}");
            assert!(command(counts).contains(&option), "{counts}");
        }
        let depending = arguments().filter(|argument| argument.knob.is_some() && !argument.depends_on.is_empty());
        assert_eq!(depending.map(|argument| argument.name).collect::<Vec<_>>(), settings.map(|(name, ..)| name));
    }
}
