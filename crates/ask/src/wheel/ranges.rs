//! Numbers that make no sense are refused, with the values that do for this wheel.

use super::arguments::{ActsOn, Argument, ArgumentSlot};
use super::fitting::{FittingValues, fitting_values, refusal};
use super::question::WheelQuestion;
use crate::Error;
use crate::number_format::as_typed;

impl WheelQuestion {
    /// Whether all its numbers make sense.
    pub(super) fn is_in_range(&self) -> bool {
        self.numbers().iter().all(|(argument, value)| argument.makes_sense(*value))
    }
}

/// Refuses the first number that makes no sense of the arguments that act on files, or of those that don't, with the values of its
/// argument with which the wheel can be made as it is asked for; `can_be_made` says whether that of a question can.
///
/// # Errors
///
/// The argument, its value, and the values to give.
pub(super) fn refuse_out_of_range(
    question: &WheelQuestion,
    of_files: bool,
    can_be_made: &dyn Fn(&WheelQuestion) -> bool,
) -> Result<(), Error> {
    let is_far = |(argument, value): &(Argument, f64)| {
        argument.acts_on.contains(&ActsOn::Files) == of_files && !argument.makes_sense(*value)
    };
    let far = question.numbers().into_iter().find(is_far);
    let Some((argument, value)) = far else { return Ok(()) };
    let Some([least, most]) = argument.range() else { return Ok(()) };
    let tried = WheelQuestion { is_trial: true, ..question.clone() };
    let fits = |other: &WheelQuestion| other.is_in_range() && can_be_made(other);
    let found = if question.is_trial { None } else { fitting_values(&argument, &tried, &fits) };
    let range = || FittingValues {
        name: argument.name,
        given: Some(value),
        least: Some(as_typed(least)),
        most: Some(as_typed(most)),
        is_for_walls: false,
    };
    let reason = match argument.place {
        ArgumentSlot::Count(_) => "that is no number of holes on a circle",
        _ if value.abs() > most => "that is too large to make sense",
        _ => "that is too small to make sense",
    };
    Err(Error::Argument(refusal(reason, &[found.unwrap_or_else(range)])))
}

#[cfg(test)]
mod tests {
    use crate::wheel::{ArgumentSlot, WheelDesign, WheelQuestion, arguments};

    #[test]
    fn each_number_has_a_range_that_is_told_and_holds_what_a_page_offers() {
        let (mut refused, mut accepted) = (0, Vec::new());
        for argument in arguments() {
            let is_number = !matches!(
                argument.place,
                ArgumentSlot::Stations(_)
                    | ArgumentSlot::Pins(_)
                    | ArgumentSlot::Kind(_)
                    | ArgumentSlot::Choice(_)
                    | ArgumentSlot::Process(_)
                    | ArgumentSlot::Material(_)
                    | ArgumentSlot::Degrees(_)
            );
            assert_eq!(argument.range().is_some(), is_number, "--{}", argument.name);
            let Some([least, most]) = argument.range() else { continue };
            if let Some(knob) = argument.knob {
                let [from, to] = knob.typed;
                assert!(to <= most && (from <= 0.0 || from >= least), "--{}: {from} to {to}", argument.name);
            }
            let is_of_files = argument.acts_on.contains(&crate::wheel::ActsOn::Files);
            let is_count = matches!(argument.place, ArgumentSlot::Count(_));
            let size = if argument.acts_on.contains(&crate::wheel::ActsOn::Size) { "" } else { " --crank-radius 25" };
            for value in if is_count { ["1", "1000000000"] } else { ["1e-9", "1e9"] } {
                let text = format!("--stations 6{size} --{} {value}", argument.name);
                let question = WheelQuestion::parse(&text).expect(&text);
                let made = WheelDesign::new(question);
                match made.and_then(|design| if is_of_files { design.part_list().map(|_| ()) } else { Ok(()) }) {
                    Err(error) => {
                        let said = error.to_string();
                        let start = format!("--{} ", argument.name);
                        assert!(said.starts_with(&start) && said.contains("; give --"), "{text}: {said}");
                        refused += 1;
                    }
                    Ok(_) => accepted.push(format!("--{} {value}", argument.name)),
                }
            }
        }
        // What a watch has.
        let small = ["inertia", "total-inertia", "friction-torque", "driver-friction", "arm-torque", "held-torque"];
        let small = small.into_iter().chain(["driver-inertia", "drive-torque"]).map(|name| format!("--{name} 1e-9"));
        assert_eq!(accepted.len(), small.clone().count(), "{accepted:?}");
        assert!(small.into_iter().all(|argument| accepted.contains(&argument)), "{accepted:?}");
        assert!(refused > 90, "only {refused} are refused");
    }

    #[test]
    fn a_modulus_in_the_wrong_unit_is_told_from_one_that_is_meant() {
        let asked = |text: &str| WheelDesign::new(WheelQuestion::parse(text).expect(text)).map(|_| ());
        let said = asked("--stations 6 --crank-radius 25 --pin-modulus 200000").expect_err("in MPa").to_string();
        assert!(said.contains("too large to make sense; give --pin-modulus up to 1300"), "{said}");
        assert!(asked("--stations 6 --crank-radius 25 --pin-modulus 200").is_ok());
        assert!(asked("--stations 6 --crank-radius 25 --pin-friction 0 --play 0").is_ok());
    }
}
