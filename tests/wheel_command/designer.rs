//! Do the figure that a reader moves and the command say the same of the same wheel?

use crate::{answered, object};
use fastrand::Rng;
use geneva_ask::Error;
use geneva_ask::wheel::{ArgumentSlot, GROUPS, SHAPE_FILES, WheelDesign, WheelQuestion, arguments};
use geneva_dynamics::line_contact::MATERIALS;
use geneva_kinematics::wheel::as_built::Process;
use geneva_live::{Live, LiveArguments, LiveReply, by_name};
use serde_json::{Map, Value};
use std::collections::{BTreeMap, BTreeSet};

/// Settings that are tried.
const SETTINGS: u64 = 200;

/// Options that make a whole of a mounting: without the others of its row, the most of them are refused.
const MOUNTINGS: [&[&str]; 6] = [
    &[],
    &["wheel-bore-shape"],
    &["wheel-flat"],
    &["hub-screw", "wheel-hub-circle", "hub-holes"],
    &["disc-dowel", "disc-dowel-circle"],
    &["driver-pieces", "pin-screw", "base-thickness", "base-screw"],
];

/// One question for the page and for the command.
struct Asked {
    page: Vec<(&'static str, String)>,
    command: Vec<String>,
}

impl Asked {
    /// A question at random: a value of each control within a third of its slider from where most wheels are, one way of those that
    /// say the same, and of what follows the others one in three; one mounting in two of three questions, and any options of mountings in
    /// one of eight.
    fn new(random: &mut Rng) -> Self {
        let mut asked = Self { page: Vec::new(), command: vec!["wheel".to_owned()] };
        let mut chosen: BTreeMap<&str, usize> = BTreeMap::new();
        let mounting = MOUNTINGS[if random.u32(..3) > 0 { random.usize(..MOUNTINGS.len()) } else { 0 }];
        let is_mounted_anyhow = random.u32(..8) == 0;
        let mounts = GROUPS.iter().find(|group| group.heading == "How it is mounted").expect("mountings").rows;
        for argument in arguments() {
            let Some(knob) = argument.knob else { continue };
            let is_given = match knob.side {
                Some((group, number)) => {
                    let sides = arguments().filter_map(|argument| argument.knob?.side).filter(|side| side.0 == group);
                    let most = sides.map(|side| side.1).max().unwrap_or_default();
                    number == *chosen.entry(group).or_insert_with(|| random.usize(..=most))
                }
                None => knob.first.is_some() || random.u32(..3) == 0,
            };
            let is_of_mounting = mounts.iter().any(|of| of.name == argument.name);
            let is_in_mounting = mounting.contains(&argument.name);
            if if is_of_mounting && !is_mounted_anyhow { !is_in_mounting } else { !is_given } {
                continue;
            }
            if let ArgumentSlot::Process(_) = argument.place {
                // Most of them by no process, since each asks for a thousand assemblies.
                let at = if random.u32(..8) == 0 { random.usize(..=Process::ALL.len()) } else { 0 };
                asked.page.push((argument.name, at.to_string()));
                if let Some(process) = at.checked_sub(1).map(|at| Process::ALL[at]) {
                    asked.command.extend([format!("--{}", argument.name), process.name().to_owned()]);
                }
                continue;
            }
            if let ArgumentSlot::Choice(choice) = argument.place {
                // Bare parts for the most part: most mountings need another option, or a room that small wheels lack.
                let unsaid = choice.usual_entry();
                let is_said = is_in_mounting || random.u32(..10) == 0;
                let at = if is_said { random.usize(..choice.on_page().len()) } else { unsaid };
                asked.page.push((argument.name, at.to_string()));
                if at != unsaid {
                    asked.command.extend([format!("--{}", argument.name), choice.names[at].to_owned()]);
                }
                continue;
            }
            if let ArgumentSlot::Material(_) = argument.place {
                let at = random.usize(..=MATERIALS.len());
                match MATERIALS.get(at) {
                    Some(material) => asked.set(argument.name, at.to_string(), material.name),
                    // What the process has needs no word.
                    None => asked.page.push((argument.name, at.to_string())),
                }
                continue;
            }
            let [least, most] = match argument.name {
                "stations" => [3.0, 12.0],
                "pins" => [1.0, 2.4],
                "pin-diameter" | "horn" | "wheel-shaft" | "driver-shaft" | "wheel-flat" => [1.0, 12.0],
                "disc-dowel" | "shoulder-depth" => [1.0, 4.0],
                "play" | "locking-play" | "bottom-clearance" => [0.0, 0.2],
                "centre-error" => [-0.1, 0.1],
                _ => knob.slider,
            };
            let value = ((least + (most - least) * random.f64()) / knob.step).round() * knob.step;
            let value = if argument.name == "centre-error" && random.bool() { 0.0 } else { value };
            asked.set(argument.name, value.to_string(), &value.to_string());
        }
        // The command refuses an option that depends on one that is not given; the page waits for that.
        for argument in arguments() {
            let is_given = |name: &str| asked.command.iter().any(|word| word.strip_prefix("--") == Some(name));
            if !argument.has_dependency(is_given)
                && let Some(at) = asked.command.iter().position(|word| word.strip_prefix("--") == Some(argument.name))
            {
                asked.command.drain(at..at + 2);
            }
        }
        asked
    }

    fn set(&mut self, name: &'static str, on_the_page: String, typed: &str) {
        self.page.push((name, on_the_page));
        self.command.extend([format!("--{name}"), typed.to_owned()]);
    }
}

/// What the command has of a number that the figure shows.
fn in_the_object<'a>(object: &'a Map<String, Value>, name: &str, key: Option<&str>) -> Option<&'a Value> {
    let key = match (name, key) {
        (_, Some(key)) => key,
        ("clearance", None) => "least_clearance_mm",
        ("where", None) => "least_clearance_at_deg",
        _ => return None,
    };
    object.get(key)
}

/// The answer of a figure, asked again until it has come to its end.
fn whole_answer(live: &Live, settings: &LiveArguments) -> Result<LiveReply, String> {
    loop {
        let answer = live.answer(settings)?;
        let Some(progress) = &answer.progress else { return Ok(answer) };
        // What helps is looked for when the yield is known.
        let is_counted = progress.parts != "assemblies";
        let is_shown = answer.numbers.iter().any(|number| number.name == "yield");
        assert_eq!(is_shown, is_counted, "{progress:?}: a part is shown as the whole, or the whole is not shown");
    }
}

/// Compares both answers to a question; how many numbers are equal, none if both refuse it.
fn compare(live: &Live, Asked { page, command }: &Asked) -> Option<usize> {
    let words: Vec<&str> = command.iter().map(String::as_str).collect();
    let settings = LiveArguments::from_pairs(page.iter().map(|(name, value)| (*name, value.clone())));
    let moved = match whole_answer(live, &settings) {
        Ok(moved) => moved,
        Err(why) => {
            assert_eq!(answered(&words).code, 2, "the figure says: {why}; the command answers: {}", command.join(" "));
            return None;
        }
    };
    // The page shows numbers of a wheel that can't be mounted as it is asked for, and refuses its files.
    let told = answered(&[&words[..], &["--format", "json"]].concat());
    if told.code == 2 {
        let sheet = geneva_live_files::file(live.name, "sheet.txt", &settings);
        assert!(sheet.is_err(), "only the command refuses {}", command.join(" "));
        return None;
    }
    let object: Map<String, Value> = serde_json::from_str(&told.stdout).expect("an object");
    let message = moved.message.as_deref().unwrap_or_default();
    // Walls beside chosen holes are told where the page offers the files; what helps more assemblies turn is told with the page's words.
    let warnings: Vec<String> = object["warnings"]
        .as_array()
        .expect("a list")
        .iter()
        // The page calls options by what their controls are called.
        .map(|warning| Error::Argument(warning.as_str().expect("words").to_owned()))
        .map(|warning| geneva_live::refusal(warning).to_lowercase())
        .filter(|warning| !warning.contains(" mm are left between "))
        .collect();
    let mut rest = message.to_lowercase();
    for warning in &warnings {
        let (told, left) = match warning.split_once("would; ") {
            Some((cause, _)) if cause.contains(" of the assemblies turn; the largest cause") => {
                (cause.to_owned(), cause)
            }
            _ => (format!("{warning}."), ""),
        };
        assert!(rest.contains(&told), "{message}: {told}: {}", command.join(" "));
        rest = rest.replacen(&told, left, 1);
    }
    // What is left is said of the page alone.
    let own = [
        "clearance and knock are",
        "sizes, times and loads are for the right distance",
        "with so little play",
        "with these errors the wheel",
        "inertia, loads and pressure are for a wheel of",
        "choose “",
    ];
    let is_own = |text: &str| {
        own.iter().any(|of| text.starts_with(of))
            || text.starts_with("only ") && warnings.iter().any(|warning| warning.get(..20) == text.get(..20))
    };
    let sentences = rest.split(". ").map(str::trim).filter(|text| !text.is_empty());
    for sentence in sentences {
        assert!(is_own(sentence), "{sentence}: {}", command.join(" "));
    }
    let is_late = message.contains("too long to compute in a page");
    let mut equal = 0;
    for of in live.quantities.iter().chain(live.others).chain(&moved.further) {
        let shown = moved.numbers.iter().find(|number| number.name == of.name);
        let found = in_the_object(&object, of.name, of.key).and_then(Value::as_f64);
        let (shown, told) = match (shown, found) {
            (Some(shown), Some(told)) => (shown, told),
            (None, None) => continue,
            (None, Some(_)) if is_late => continue,
            _ => panic!("{}: {shown:?} and {told:?}: {}", of.name, command.join(" ")),
        };
        let part = if shown.text.contains('%') { 100.0 } else { 1.0 };
        let told = if of.name == "where" { told.abs() } else { told };
        assert_eq!(shown.value, part * told, "{}: {}", of.name, command.join(" "));
        equal += 1;
    }
    Some(equal)
}

#[test]
fn the_yield_comes_piece_by_piece_and_is_that_of_the_command() {
    let live = by_name("design").expect("a figure");
    let mut lowest = 1.0_f64;
    for (at, process) in Process::ALL.into_iter().enumerate() {
        // So little play that with some processes not all turn.
        let given =
            [("stations", "6"), ("crank-radius", "25"), ("play", "0.1")].map(|(name, value)| (name, value.to_owned()));
        let page = given.into_iter().chain([("process", (at + 1).to_string())]);
        let settings = LiveArguments::from_pairs(page);
        // The first answer waits for no assembly.
        let first = live.answer(&settings).expect("an answer").progress.expect("assemblies to count");
        assert_eq!((first.parts, first.done, first.all), ("assemblies", 0, 1000));
        let second = live.answer(&settings).expect("an answer").progress.expect("assemblies to count");
        assert!(second.done > 0 && second.done < 200, "{second:?}");
        let whole = whole_answer(live, &settings).expect("an answer");
        let command = whole.command.as_deref().and_then(|command| command.strip_prefix("geneva ")).expect("a command");
        let object = object(&command.split(' ').collect::<Vec<_>>());
        for (name, key) in [("yield", "yield"), ("yield-low", "yield_low"), ("yield-high", "yield_high")] {
            let shown = whole.numbers.iter().find(|number| number.name == name).expect(name);
            assert_eq!(
                Some(shown.value),
                object[key].as_f64().map(|share| 100.0 * share),
                "{}: {name}",
                process.name()
            );
        }
        lowest = lowest.min(object["yield"].as_f64().expect("a share"));
    }
    assert!(lowest < 1.0, "every assembly of every process turns, so nothing is compared");
}

#[test]
fn each_entry_of_a_choice_can_be_sent_whatever_the_process() {
    let live = by_name("design").expect("a figure");
    let mut sent = 0;
    for (process, name) in Process::ALL.map(Process::name).into_iter().enumerate() {
        let page = |at: usize| {
            let settings = [("process", (process + 1).to_string()), ("driver-pieces", at.to_string())];
            live.answer(&LiveArguments::from_pairs(settings))
        };
        for (at, said) in [Some("one-piece"), Some("two-pieces"), None].into_iter().enumerate() {
            let answer = match page(at) {
                Ok(answer) => answer,
                Err(why) => {
                    assert!(name == "laser" && why.starts_with("“disc and plate are” one-piece:"), "{name}: {why}");
                    continue;
                }
            };
            let command = answer.command.expect("a command");
            let found = command.split(" --driver-pieces ").nth(1).and_then(|rest| rest.split(' ').next());
            assert_eq!(found, said, "{name}: {command}");
            sent += 1;
        }
    }
    assert!(sent > 10, "only {sent} entries were sent");
}

/// Compares the numbers and warnings of the figure with those of the command in every second setting, from this one on.
#[track_caller]
fn compare_every_second(first: u64) {
    let live = by_name("design").expect("a figure");
    let mut answered = 0;
    for seed in (first..SETTINGS).step_by(2) {
        let Some(equal) = compare(live, &Asked::new(&mut Rng::with_seed(seed))) else { continue };
        assert!(equal > 30, "setting {seed}: only {equal} numbers are in both answers");
        answered += 2;
    }
    assert!(answered > SETTINGS / 3, "only {} of {} wheels are possible", answered / 2, SETTINGS / 2);
}

// In two halves, which run side by side.
#[test]
fn the_figure_and_the_command_give_the_same_numbers_and_warnings() {
    compare_every_second(0);
}

#[test]
fn the_figure_and_the_command_give_the_same_numbers_and_warnings_in_other_settings() {
    compare_every_second(1);
}

/// Settings whose numbers and sheets are compared, and those whose files are made: some of those above, for each answer, and each mesh
/// still more, takes its time. That figure and command have the same question is asked of all.
const WITH_NUMBERS: u64 = 60;
const WITH_FILES: u64 = 40;

/// Compares what the figure and its command make of some settings; how many files of shapes were compared.
fn compare_figure_with_command(seeds: impl Iterator<Item = u64>) -> usize {
    let live = by_name("design").expect("a figure");
    let mut compared = 0;
    for seed in seeds {
        let asked = Asked::new(&mut Rng::with_seed(seed));
        let settings = LiveArguments::from_pairs(asked.page.iter().map(|(name, value)| (*name, value.clone())));
        let Ok(moved) = live.answer(&settings) else { continue };
        let command = moved.command.expect("a command");
        let question = command.strip_prefix("geneva wheel ").expect("a wheel");
        let design = WheelDesign::new(WheelQuestion::parse(question).expect(question)).expect(question);
        let made = |name: &str| geneva_live_files::file(live.name, name, &settings);
        let file = |name: &str| made(name).expect(name);
        // What is shown to be typed is what the test types, but for axes in their place.
        let is_needed = |word: &str| !["centre-error 0", "centre-error -0"].contains(&word.trim());
        let words = |text: &str| -> BTreeSet<String> {
            text.split(" --").filter(|word| is_needed(word)).map(|word| word.trim().to_owned()).collect()
        };
        assert_eq!(words(&format!("wheel {question}")), words(&asked.command.join(" ")));
        if seed >= WITH_NUMBERS {
            continue;
        }
        let Ok(answer) = design.answer() else {
            assert!(made("numbers.csv").is_err() && made("sheet.txt").is_err(), "numbers of {question}");
            continue;
        };
        assert!(file("numbers.csv") == answer.table().into_bytes(), "numbers: {question}");
        assert!(file("sheet.txt") == answer.plain_sheet().into_bytes(), "sheet: {question}");
        if seed < WITH_FILES {
            for shape in SHAPE_FILES {
                let of_command = (shape.make)(&design);
                // A mounting that can't be made is refused by both.
                assert_eq!(made(shape.name).is_ok(), of_command.is_ok(), "{}: {question}", shape.name);
                let Ok(of_command) = of_command else { continue };
                assert!(file(shape.name) == of_command, "{}: {question}", shape.name);
                compared += 1;
            }
        }
    }
    compared
}

// In two halves, which run side by side.
#[test]
fn the_command_that_the_figure_shows_makes_the_same_numbers_and_the_same_files() {
    let compared = compare_figure_with_command((0..SETTINGS).step_by(2));
    assert!(compared > 15, "only {compared} files were compared");
}

#[test]
fn other_commands_that_the_figure_shows_make_the_same_numbers_and_the_same_files() {
    let compared = compare_figure_with_command((1..SETTINGS).step_by(2));
    assert!(compared > 15, "only {compared} files were compared");
}

#[test]
fn without_play_the_figure_warns_as_the_command_does() {
    let live = by_name("design").expect("a figure");
    for radius in ["10", "25", "33.3", "100"] {
        let settings = LiveArguments::from_pairs([("crank-radius", radius.to_owned()), ("play", "0".to_owned())]);
        let message = live.answer(&settings).expect("an answer").message.expect("a warning");
        assert!(message.contains("Without play, parts made exactly as drawn will jam"), "{message}");
        assert!(!message.contains("overlap"), "{message}");
    }
    // Axes that are too near are an overlap.
    let nearer = LiveArguments::from_pairs([("centre-error", "-0.2".to_owned())]);
    let message = live.answer(&nearer).expect("an answer").message.expect("a warning");
    assert!(message.contains("overlap"), "{message}");
}
