//! Simulated assemblies of the designer's wheel, counted a few at a time, and why too few turn.

use crate::answer::Progress;
use crate::control::Settings;
use crate::given::given;
use crate::page_words::words;
use geneva_ask::wheel::{ASSEMBLIES, ActsOn, CauseSearch, MountingQuestion, WheelDesign};
use geneva_kinematics::wheel::Sizes;
use geneva_kinematics::wheel::as_built::{Process, Yield};
use std::cell::RefCell;

/// Assemblies that are counted at one asking: few, so that a slider never waits for them.
const AT_ONCE: u64 = 50;

/// What is counted for a wheel, and how far.
#[derive(Default)]
struct Counting {
    /// The sizes, process, measured play and mounting by which its assemblies are drawn.
    of: Option<(Sizes, Process, Option<f64>, MountingQuestion)>,
    turning: Yield,
    /// What was given as the search for the cause began: a change that helps differs from it.
    given: Option<Vec<(&'static str, f64)>>,
    search: Option<CauseSearch>,
    cause: Option<String>,
}

thread_local! {
    static COUNTING: RefCell<Counting> = RefCell::new(Counting::default());
}

/// What is known of the assemblies of a wheel.
#[derive(Default)]
pub(crate) struct Counts {
    pub turning: Option<Yield>,
    /// Why too few turn, and what helps.
    pub cause: Option<String>,
    pub progress: Option<Progress>,
}

/// How many assemblies turn and, if too few do, why: at each asking some more is counted, at the first of a wheel nothing. Nothing
/// without a process.
pub(crate) fn counted(settings: &Settings, design: &WheelDesign) -> Result<Counts, String> {
    let Some((sizes, process)) = design.sizes.zip(design.question.process) else { return Ok(Counts::default()) };
    COUNTING.with_borrow_mut(|counting| {
        let of = Some((sizes, process, design.question.measured_play, design.question.mounting));
        if settings.is_in_motion() {
            // What is known of this wheel stays in sight.
            let is_known = counting.of == of && counting.given == Some(given_to_the_parts(settings)?);
            let known = Counts { turning: Some(counting.turning), cause: counting.cause.clone(), progress: None };
            return Ok(if is_known { known } else { Counts::default() });
        }
        if counting.of != of {
            *counting = Counting { of, ..Counting::default() };
        } else if counting.turning.tried < ASSEMBLIES {
            counting.turning = design.count_assemblies(counting.turning, AT_ONCE).map_err(words)?.unwrap_or_default();
        } else if let Some(search) = &mut counting.search
            && let Some(cause) = search.step(design, AT_ONCE).map_err(words)?
        {
            (counting.search, counting.cause) = (None, Some(cause));
        }
        let turning = counting.turning;
        if turning.tried == ASSEMBLIES {
            let given = Some(given_to_the_parts(settings)?);
            if counting.given != given {
                counting.search = CauseSearch::new(design, turning).map_err(words)?;
                (counting.given, counting.cause) = (given, None);
            }
        }
        let (parts, done, all) = match &counting.search {
            Some(search) => search.progress(),
            None => ("assemblies", turning.tried, ASSEMBLIES),
        };
        let is_left = counting.search.is_some() || turning.tried < ASSEMBLIES;
        let progress = is_left.then_some(Progress { parts, done: done as usize, all: all as usize });
        Ok(Counts { turning: Some(turning), cause: counting.cause.clone(), progress })
    })
}

/// What is given that the parts depend on; speeds and loads are left out.
fn given_to_the_parts(settings: &Settings) -> Result<Vec<(&'static str, f64)>, String> {
    let is_of_motion = |of: &ActsOn| matches!(of, ActsOn::Motion | ActsOn::Speed | ActsOn::Inertia | ActsOn::Load);
    let of_parts = given(settings)?.into_iter().filter(|(argument, _)| !argument.acts_on.iter().any(is_of_motion));
    Ok(of_parts.map(|(argument, value)| (argument.name, value)).collect())
}

#[cfg(test)]
mod tests {
    use crate::page_words::with_labels;
    use crate::{DESIGN, LiveArguments, wheel_for_a_file};
    use geneva_ask::FieldValue;

    /// What the sheet of the setting warns of, in the page's words, or its refusal.
    fn on_the_sheet(arguments: &LiveArguments) -> Result<Vec<String>, String> {
        let answer = wheel_for_a_file(arguments)?.answer().map_err(crate::refusal)?;
        let FieldValue::List(warnings) = &answer.field("warnings").expect("warnings").value else {
            return Ok(Vec::new());
        };
        let words = |warning: &FieldValue| match warning {
            FieldValue::Text(text) => with_labels(text),
            other => panic!("{other:?}"),
        };
        Ok(warnings.iter().map(words).collect())
    }

    /// What the page says of the setting once all is counted, or its refusal.
    fn on_the_page(arguments: &LiveArguments) -> Result<String, String> {
        for _ in 0..1000 {
            let answer = DESIGN.answer(arguments)?;
            if answer.progress.is_none() {
                return Ok(answer.message.unwrap_or_default());
            }
        }
        panic!("it is never counted: {}", arguments.to_query());
    }

    #[test]
    fn the_page_refuses_what_the_sheet_refuses_and_warns_of_what_the_sheet_warns_of() {
        let few = "stations=4&crank-radius=25&process=6&wheel-shaft=5&driver-shaft=5";
        for (setting, says) in [
            ("stations=6&crank-radius=25&wheel-hub-circle=30", Err("“screws of the hubs” M3")),
            ("stations=4&crank-radius=25&wheel-hub-circle=20&hub-screw=1", Err("circle of holes in the wheel")),
            ("stations=6&crank-radius=25&wheel-flat=5", Err("add its diameter, “diameter of the wheel's shaft”")),
            ("stations=4&crank-radius=25&pin-diameter=3&pin-screw=2", Err("“diameter of a pin” 4")),
            ("stations=6&crank-radius=25&play=3", Ok("play")),
            (&format!("{few}&measured-play=0.2"), Ok("With “play of the bores” ")),
            (&format!("{few}&play=0.3&bore-play=0.02"), Ok("the largest cause is the errors of the sizes")),
            (&format!("{few}&bore-play=0.1"), Ok("")),
            (
                "stations=6&crank-radius=60&wheel-shaft=20&wheel-hub-circle=30&hub-screw=3",
                Ok("left between a hole of the hub and the bore"),
            ),
        ] {
            let arguments = LiveArguments::parse(setting).expect(setting);
            match (on_the_page(&arguments), on_the_sheet(&arguments)) {
                (Ok(page), Ok(sheet)) => {
                    for warning in sheet {
                        let is_told = page.to_lowercase().contains(&warning.to_lowercase());
                        assert!(is_told, "{setting}: {warning}: {page}");
                    }
                    assert!(
                        says.is_ok_and(|says| page.to_lowercase().contains(&says.to_lowercase())),
                        "{setting}: {page}"
                    );
                }
                (Err(page), Err(sheet)) => {
                    assert_eq!(page, sheet, "{setting}");
                    assert!(says.is_err_and(|says| page.contains(says)), "{setting}: {page}");
                }
                (page, sheet) => panic!("{setting}: {page:?}, {sheet:?}"),
            }
        }
    }

    #[test]
    fn in_motion_the_drawing_and_all_numbers_that_take_no_time_are_those_of_the_setting() {
        let arguments = LiveArguments::parse("stations=7&process=2").expect("arguments");
        let moving = DESIGN.answer_in_motion(&arguments).expect("a wheel");
        on_the_page(&arguments).expect("a wheel");
        let still = DESIGN.answer(&arguments).expect("a wheel");
        assert_eq!((&moving.figure, &moving.turned), (&still.figure, &still.turned));
        assert!(moving.progress.is_some() && still.progress.is_none());
        let names = |of: &[crate::LiveNumber]| of.iter().map(|number| number.name).collect::<Vec<_>>();
        let missing: Vec<&str> =
            names(&still.numbers).into_iter().filter(|name| !names(&moving.numbers).contains(name)).collect();
        assert_eq!(missing, ["yield", "yield-low", "yield-high", "nearer", "farther"]);
        // Once they are counted, they stay in sight.
        let again = DESIGN.answer_in_motion(&arguments).expect("a wheel");
        assert!(names(&again.numbers).contains(&"yield"));
    }
}
