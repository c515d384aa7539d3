//! With which values of an argument the parts fit, where they don't: the remedy that a refusal names.
//!
//! What stands against what follows from trying: an argument is a remedy if the parts fit with another value of it, all else being
//! as it was asked for. So no table has to say which argument a refusal is about, and a value that is named works.

use super::arguments::{ActsOn, Argument, ArgumentSlot, FIT, SIZE};
use super::question::WheelQuestion;
use crate::number_format::{as_typed, rounded_down, rounded_up};
use geneva_kinematics::bisection::bisect_times;
use geneva_kinematics::wheel::{ShaftOf, SizesError};

/// An argument with the values, in its own unit, with which the parts fit while all others stay as they are.
#[derive(Clone, Debug, PartialEq)]
pub struct FittingValues {
    /// The argument's name, without hyphens.
    pub name: &'static str,
    /// What was given for it, in its own unit, if it was given.
    pub given: Option<f64>,
    /// The least value that fits, in its own unit, as it can be typed; none where all below fit.
    pub least: Option<String>,
    /// The greatest value that fits, in its own unit, as it can be typed; none where all above fit.
    pub most: Option<String>,
    /// Whether more fits, but leaves walls or locking arcs that can hardly be made.
    pub is_for_walls: bool,
}

impl FittingValues {
    /// The values in words: `from 2 to 5`.
    pub fn range(&self) -> String {
        match (self.least.as_deref(), self.most.as_deref()) {
            (Some(least), Some(most)) if least == most => least.to_owned(),
            (Some(least), Some(most)) => format!("from {least} to {most}"),
            (None, Some("0")) => "0".to_owned(),
            (None, Some(most)) => format!("up to {most}"),
            (Some(least), None) => format!("{least} or more"),
            (None, None) => "another value".to_owned(),
        }
    }

    /// What the values leave, where they are not all that fit: the end of a sentence, with a blank before it, or nothing.
    ///
    /// ```
    /// use geneva_ask::Error;
    /// use geneva_ask::wheel::{WheelDesign, WheelQuestion};
    ///
    /// let question = WheelQuestion::parse("--stations 6 --crank-radius 62 --pin-diameter 40")?;
    /// let Err(Error::Sizes { remedies, .. }) = WheelDesign::new(question) else { panic!("too thick") };
    /// assert!(remedies[0].range().starts_with("up to ") && !remedies[0].purpose().is_empty());
    /// # Ok::<(), geneva_ask::Error>(())
    /// ```
    pub fn purpose(&self) -> &'static str {
        if self.is_for_walls { " for sound walls and locking arcs" } else { "" }
    }
}

/// How many remedies are named at most.
const NAMED: usize = 3;
/// Tried values in a decade, and where it is known that some value fits.
const IN_A_DECADE: i32 = 12;
const FINELY: i32 = 60;
/// Decades that are tried to either side of one.
const DECADES: i32 = 6;
/// So many times smaller or larger than a value that fits, no limit is looked for.
const FAR: f64 = 1e6;
/// Halvings of the interval in which a limit is.
const HALVINGS: u32 = 50;

/// The arguments with which the parts would fit, each with its values: what was given of the fit; if nothing of that helps, what else
/// the fit has; and at last the size of the whole.
///
/// `fits` says how the parts of a question fit. Values with which all walls can be made go before others.
pub(super) fn remedies(question: &WheelQuestion, fits: &dyn Fn(&WheelQuestion) -> Fit) -> Vec<FittingValues> {
    let is_given = |argument: &&Argument| question.number(argument).is_some();
    let given = FIT.iter().filter(is_given);
    // A page has no control for what is measured instead of chosen.
    let others = FIT.iter().filter(|argument| !is_given(argument) && argument.knob.is_some());
    let sizes = SIZE.iter().filter(|argument| argument.acts_on.contains(&ActsOn::Size)).filter(is_given);
    let groups: [Vec<&Argument>; 3] = [given.collect(), others.collect(), sizes.collect()];
    well_or_barely(&groups, question, fits)
}

/// How the parts of a question fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fit {
    /// They don't.
    Not,
    /// They do, but some wall is so thin that it can hardly be made.
    Barely,
    /// They do, and all walls can be made.
    Well,
}

impl Fit {
    /// Of parts whose walls can be made, or can't.
    pub(super) fn of(can_be_made: bool) -> Self {
        if can_be_made { Self::Well } else { Self::Barely }
    }
}

/// What helps so that the parts fit well, or if nothing does, so that they fit at all.
fn well_or_barely(
    groups: &[Vec<&Argument>],
    question: &WheelQuestion,
    fits: &dyn Fn(&WheelQuestion) -> Fit,
) -> Vec<FittingValues> {
    let fit_at_all = |other: &WheelQuestion| fits(other) != Fit::Not;
    let mut well = of_first_group(groups, question, &|other| fits(other) == Fit::Well);
    if well.is_empty() {
        return of_first_group(groups, question, &fit_at_all);
    }
    for of in &mut well {
        let argument = groups.iter().flatten().find(|argument| argument.name == of.name);
        let all = argument.and_then(|argument| fitting_values(argument, question, &fit_at_all));
        of.is_for_walls = all.is_some_and(|all| all.range() != of.range());
    }
    well
}

/// The arguments among these, each with its values, with which a question `fits`, well if it can.
pub(super) fn remedies_among(
    arguments: &[Argument],
    question: &WheelQuestion,
    fits: &dyn Fn(&WheelQuestion) -> Fit,
) -> Vec<FittingValues> {
    let groups = [arguments.iter().filter(|argument| question.number(argument).is_some()).collect()];
    well_or_barely(&groups, question, fits)
}

fn of_first_group(
    groups: &[Vec<&Argument>],
    question: &WheelQuestion,
    fits: &dyn Fn(&WheelQuestion) -> bool,
) -> Vec<FittingValues> {
    let of = |group: &Vec<&Argument>| -> Vec<FittingValues> {
        group.iter().filter_map(|argument| fitting_values(argument, question, fits)).take(NAMED).collect()
    };
    groups.iter().map(of).find(|found| !found.is_empty()).unwrap_or_default()
}

/// The values of an argument with which a question fits: those around the one that is nearest to what was given.
pub(super) fn fitting_values(
    argument: &Argument,
    question: &WheelQuestion,
    fits: &dyn Fn(&WheelQuestion) -> bool,
) -> Option<FittingValues> {
    let may_be_zero = matches!(argument.place, ArgumentSlot::LengthOrZero(_) | ArgumentSlot::ZeroOrMore(_));
    let given = question.number(argument);
    let fits_usually = given.is_some() && question.with_number(argument, None).is_some_and(|without| fits(&without));
    let fits = |value: f64| question.with_number(argument, Some(value)).is_some_and(|with| fits(&with));
    let around = given.filter(|value| *value > 0.0).unwrap_or(1.0);
    let finely = || if fits_usually { nearest_that_fits(around, FINELY, &fits) } else { None };
    let seed = nearest_that_fits(around, IN_A_DECADE, &fits).or_else(finely);
    let Some(seed) = seed else {
        let zero = (may_be_zero && fits(0.0)).then(|| "0".to_owned())?;
        return Some(FittingValues { name: argument.name, given, least: None, most: Some(zero), is_for_walls: false });
    };
    // What was given doesn't fit, so a limit is on the way to it; on the other side it is looked for.
    let [floor, ceiling] = argument.range().unwrap_or([0.0, f64::INFINITY]);
    let [small, large] = [(around.min(seed) / FAR).max(floor), (around.max(seed) * FAR).min(ceiling)];
    let below = given.filter(|given| *given < seed).or_else(|| (!may_be_zero || !fits(0.0)).then_some(small));
    let above = given.filter(|given| *given > seed).unwrap_or(large);
    let limit = |asked: f64| {
        let end = asked.clamp(floor, ceiling);
        // Where all fits that makes sense, its end is told to one who asked for more.
        if fits(end) { (end != asked).then_some(end) } else { Some(bisect_times(HALVINGS, [seed, end], fits)[0]) }
    };
    let (least, most) = (below.and_then(limit), limit(above));
    let typed = |limit: f64, rounded: fn(f64) -> String| {
        let rounded = rounded(limit);
        if rounded.parse().is_ok_and(fits) { rounded } else { as_typed(limit) }
    };
    let (least, most) = (least.map(|least| typed(least, rounded_up)), most.map(|most| typed(most, rounded_down)));
    Some(FittingValues { name: argument.name, given, least, most, is_for_walls: false })
}

/// The value nearest to another one, by their ratio, that fits, of those evenly many in a decade.
fn nearest_that_fits(around: f64, in_a_decade: i32, fits: &dyn Fn(f64) -> bool) -> Option<f64> {
    let most = DECADES * in_a_decade;
    let middle = libm::log10(around) * f64::from(in_a_decade);
    let mut steps: Vec<i32> = (-most..=most).collect();
    steps.sort_by(|one, other| (f64::from(*one) - middle).abs().total_cmp(&(f64::from(*other) - middle).abs()));
    let values = steps.into_iter().map(|step| libm::pow(10.0, f64::from(step) / f64::from(in_a_decade)));
    values.into_iter().find(|value| fits(*value))
}

/// A refusal in words: the arguments that were given and stand against it, why, and the values to give.
pub(crate) fn refusal(reason: &str, remedies: &[FittingValues]) -> String {
    let given = remedies.iter().filter_map(|of| Some(format!("--{} {}", of.name, as_typed(of.given?))));
    let given: Vec<String> = given.collect();
    let head = if given.is_empty() { String::new() } else { format!("{}: ", given.join(", ")) };
    let values: Vec<String> =
        remedies.iter().map(|of| format!("--{} {}{}", of.name, of.range(), of.purpose())).collect();
    format!("{head}{reason}; give {}", values.join(", or "))
}

/// The refusal of parts that don't fit, in words, with what to give, or with what to choose where no one argument helps.
pub(crate) fn sizes_refusal(error: &SizesError, remedies: &[FittingValues]) -> String {
    if remedies.is_empty() {
        return error.to_string();
    }
    format!("{}{}", refusal(&error.reason(), remedies), elsewhere(error))
}

/// Where else a shaft has room that is too thick for the plane of the wheel.
pub(super) fn elsewhere(error: &SizesError) -> &'static str {
    match error {
        SizesError::Shaft { name: ShaftOf::Driver, .. } => ", or let the shaft end in the plate (--plate-shaft MM)",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::super::arguments::{ActsOn, Argument, ArgumentSlot, arguments};
    use super::super::design::WheelDesign;
    use super::super::question::{SearchEffort, WheelQuestion};
    use crate::Error;
    use crate::number_format::as_typed;
    use geneva_kinematics::wheel::as_built::Process;

    /// Designs that fit without a process and with any.
    const DESIGNS: [&str; 3] =
        ["--stations 4 --crank-radius 25", "--stations 6 --centre-distance 100", "--stations 15 --wheel-radius 200"];
    /// Values that are far too small for most arguments, and far too large.
    const FAR: [f64; 3] = [1e-9, 90.0, 1e5];

    /// All of an answer and of the files that can be refused, without what takes long.
    fn ask(text: &str) -> Result<(), Error> {
        let question = WheelQuestion::parse(text)?;
        let effort = SearchEffort { clearance: 1, tolerance: 1 };
        let design = WheelDesign::new(WheelQuestion { effort, ..question })?;
        design.loads(design.wheel.indexing())?;
        if text.contains("centre-error") {
            design.clearance()?;
        }
        let is_of_files = |(argument, _): &(Argument, f64)| argument.acts_on.contains(&ActsOn::Files);
        if design.question.numbers().iter().any(is_of_files) {
            design.part_list()?;
            design.svg_parts()?;
        }
        Ok(())
    }

    /// What an argument needs besides itself to have an effect.
    fn companions(name: &str) -> &'static str {
        match name {
            "rpm" | "rad-s" | "index-time" | "dwell-time" => "--inertia 0.002",
            "inertia" | "total-inertia" => "--rpm 60",
            "table-mass" => "--rpm 60 --table-diameter 100",
            "table-diameter" => "--rpm 60 --table-mass 1",
            "lead-in-flare" => "--lead-in 1",
            "mouth-angle" => "--mouth-chamfer 1",
            "bearing-friction" => "--rpm 60 --wheel-bearing 10 --driver-bearing 10",
            "wheel-bearing" => "--rpm 60 --bearing-friction 0.1 --driver-bearing 10",
            "driver-bearing" => "--rpm 60 --bearing-friction 0.1 --wheel-bearing 10",
            "disc-friction" => "--rpm 60 --held-torque 1",
            "drive-torque" => "--rpm 60 --driver-inertia 0.001",
            "wheel-flat" => "--wheel-shaft 5",
            "driver-flat" => "--driver-shaft 1",
            "wheel-hub-circle" | "driver-hub-circle" => "--hub-dowel 1",
            "hub-dowel" => "--wheel-hub-circle 12",
            "disc-dowel" => "--disc-dowel-circle 10",
            "disc-dowel-circle" => "--disc-dowel 1",
            "shoulder-diameter" => "--wheel-shaft 6 --plate-shaft 6 --base-thickness 10 --shoulder-depth 3",
            "shoulder-depth" => "--wheel-shaft 6 --plate-shaft 6 --base-thickness 10 --shoulder-diameter 12",
            _ => "--rpm 60 --inertia 0.002",
        }
    }

    /// The values that a refusal says to give: each argument with the ends of its range.
    fn values(refusal: &str) -> Vec<(String, String)> {
        let Some((_, remedies)) = refusal.split_once("; give --") else { return Vec::new() };
        let mut values = Vec::new();
        for remedy in remedies.split(", or --") {
            let Some((name, range)) = remedy.split_once(' ') else { continue };
            for end in range.split([' ', ',']).filter(|word| word.parse::<f64>().is_ok()) {
                values.push((name.to_owned(), end.to_owned()));
            }
        }
        values
    }

    /// A question with another value of an argument.
    fn with(question: &str, name: &str, value: &str) -> String {
        let words: Vec<&str> = question.split_whitespace().collect();
        let others = words.chunks(2).filter(|pair| pair[0].trim_start_matches("--") != name);
        others.map(|pair| pair.join(" ") + " ").collect::<String>() + &format!("--{name} {value}")
    }

    fn is_number(argument: &Argument) -> bool {
        use ArgumentSlot::{AboveZero, Length, LengthOrZero, SignedLength, ZeroOrMore};
        matches!(argument.place, Length(_) | LengthOrZero(_) | SignedLength(_) | AboveZero(_) | ZeroOrMore(_))
    }

    /// What is wrong with the refusal of a question because of an argument; nothing if it is right.
    fn flaw(question: &str, argument: &str, refusal: &str) -> Option<String> {
        let values = values(refusal);
        let failing = values
            .iter()
            .find_map(|(name, value)| ask(&with(question, name, value)).err().map(|error| (name, value, error)));
        let is_right = refusal.contains(&format!("--{argument}")) && !values.is_empty() && failing.is_none();
        (!is_right).then(|| format!("{question}: {refusal}\n    {failing:?}"))
    }

    #[test]
    fn what_is_far_from_fitting_is_refused_with_values_that_fit() {
        let processes = Process::ALL.map(|process| format!(" --process {}", process.name()));
        let with_processes = || std::iter::once("").chain(processes.iter().map(String::as_str)).cycle();
        let (mut refused, mut wrong) = (0, Vec::new());
        for (number, design) in DESIGNS.iter().enumerate() {
            // Each argument is tried with one process or none, and each process is with some argument of each design.
            // In the disc of fifteen stations no hub has room.
            let is_tried = |argument: &&Argument| {
                let acts_on = |what| argument.acts_on.contains(&what);
                is_number(argument) && !acts_on(ActsOn::Size) && !(number == 2 && acts_on(ActsOn::Files))
            };
            let tried = arguments().filter(is_tried);
            for (argument, process) in tried.zip(with_processes().skip(number)) {
                let usual = format!("{design}{process} {}", companions(argument.name));
                for value in FAR {
                    let question = with(&usual, argument.name, &as_typed(value));
                    let Err(error) = ask(&question) else { continue };
                    refused += 1;
                    wrong.extend(flaw(&question, argument.name, &error.to_string()));
                }
            }
        }
        assert!(wrong.is_empty(), "{} of {refused}:\n{}", wrong.len(), wrong.join("\n"));
        assert!(refused > 100, "only {refused} are refused");
    }

    #[test]
    fn a_refusal_has_one_limit_which_leaves_what_can_be_made() {
        // With a process, a thicker shaft gets a thinner pin, so there is more room than beside the usual pin.
        let shaft = "--stations 4 --crank-radius 25 --process fdm --wheel-shaft 30";
        let said = ask(shaft).expect_err("too thick").to_string();
        assert!(!said.contains("less than") && said.matches("give --wheel-shaft up to ").count() == 1, "{said}");
        assert_eq!(flaw(shaft, "wheel-shaft", &said), None);
        // Of each refusal the ends of the range leave walls without a warning, where the design has none itself.
        let mut tried = 0;
        for design in &DESIGNS[..2] {
            for (name, value) in [("horn", "1000"), ("pin-diameter", "1000"), ("play", "1000"), ("wheel-shaft", "1000")]
            {
                let question = with(design, name, value);
                let said = ask(&question).expect_err(&question).to_string();
                for (name, value) in values(&said) {
                    let mended = WheelQuestion::parse(&with(&question, &name, &value)).expect("a question");
                    let design = WheelDesign::new(mended).expect("a wheel");
                    let sizes = design.sizes.expect("sizes");
                    let disc = sizes.locking_disc.expect("a disc").radius;
                    assert!(sizes.has_sound_walls() && disc >= 0.999 * sizes.pin_radius(), "{said}: {disc}");
                    tried += 1;
                }
            }
        }
        assert!(tried > 6, "{tried}");
    }

    #[test]
    fn a_limit_is_the_true_one_or_says_what_it_leaves_and_beyond_it_is_a_warning() {
        let wheel = "--stations 6 --crank-radius 62 --thickness 10 --play 0.1";
        let pin = |diameter: &str| with(wheel, "pin-diameter", diameter);
        let said = ask(&pin("31")).expect_err("too thick").to_string();
        assert!(said.contains("for sound walls and locking arcs"), "{said}");
        let warnings = |diameter: &str| {
            let question = WheelQuestion::parse(&pin(diameter)).expect("a question");
            WheelDesign::new(question).expect("a wheel").warnings().expect("warnings").join("; ")
        };
        for diameter in ["28", "29.9", "30.5"] {
            let said = warnings(diameter);
            assert!(said.contains("the locking arcs reach only") || said.contains("the locking disc is"), "{said}");
        }
        let (_, most) = values(&said).remove(0);
        let said = warnings(&most);
        assert!(!said.contains("the locking arcs reach only") && !said.contains("the locking disc is"), "{said}");
        // A limit beyond which nothing fits has no such words.
        let shaft = ask("--stations 6 --crank-radius 62 --driver-shaft 60").expect_err("too thick").to_string();
        assert!(shaft.contains("give --driver-shaft up to "), "{shaft}");
    }

    #[test]
    fn a_default_fits_or_the_refusal_says_what_to_give() {
        let mut wrong = Vec::new();
        for stations in [3, 4, 6, 15, 40] {
            for process in Process::ALL.map(Process::name) {
                for size in [10.0, 40.77, 100.0, 400.0] {
                    let question = format!("--stations {stations} --centre-distance {size} --process {process}");
                    if let Err(error) = ask(&question) {
                        wrong.extend(flaw(&question, "", &error.to_string()));
                    }
                }
            }
        }
        assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
    }
}
