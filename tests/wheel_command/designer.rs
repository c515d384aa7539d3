//! Do the figure that a reader moves and the command say the same of the same wheel?

use crate::{answered, object};
use fastrand::Rng;
use geneva_dynamics::line_contact::MATERIALS;
use geneva_live::{Live, LiveArguments, by_name};
use serde_json::{Map, Value};

/// Settings that are tried.
const SETTINGS: u64 = 200;

/// One of two front ends, and the same question for both.
struct Asked {
    page: Vec<(&'static str, String)>,
    command: Vec<String>,
}

impl Asked {
    /// A question at random: sizes that the figure chooses itself are set in one of three questions each.
    fn new(random: &mut Rng) -> Self {
        let mut asked = Self { page: Vec::new(), command: vec!["wheel".to_owned()] };
        let number = |random: &mut Rng, [least, most]: [f64; 2], step: f64| {
            let value = least + (most - least) * random.f64();
            format!("{}", (value / step).round() * step)
        };
        asked.set("stations", "stations", number(random, [3.0, 12.0], 1.0));
        asked.set("pins", "pins", number(random, [1.0, 2.4], 1.0));
        let is_crank = random.bool();
        let size = number(random, [10.0, 100.0], 0.5);
        asked.page.push(("size", if is_crank { "0" } else { "1" }.to_owned()));
        asked.set("radius", if is_crank { "crank-radius" } else { "centre-distance" }, size);
        let mut set = |random: &mut Rng, [control, option]: [&'static str; 2], ends: [f64; 2], step: f64| {
            let value = number(random, ends, step);
            asked.set(control, option, value);
        };
        set(random, ["speed", "rpm"], [1.0, 600.0], 1.0);
        set(random, ["inertia", "inertia"], [0.0, 0.05], 0.0005);
        set(random, ["friction", "friction-torque"], [0.0, 5.0], 0.05);
        set(random, ["thickness", "thickness"], [1.0, 50.0], 0.5);
        if random.u32(..3) == 0 {
            set(random, ["pin", "pin-diameter"], [1.0, 12.0], 0.1);
        }
        if random.u32(..3) == 0 {
            set(random, ["play", "play"], [0.0, 0.2], 0.05);
        }
        if random.u32(..3) == 0 {
            set(random, ["wheel-shaft", "wheel-shaft"], [1.0, 20.0], 0.5);
        }
        let at = random.usize(..MATERIALS.len());
        asked.page.push(("material", at.to_string()));
        let material = &MATERIALS[at];
        let density = material.density.to_string();
        let more = ["--density", &density, "--pin-material", MATERIALS[0].name, "--wheel-material", material.name];
        asked.command.extend(more.map(str::to_owned));
        asked
    }

    fn set(&mut self, control: &'static str, option: &str, value: String) {
        self.page.push((control, value.clone()));
        self.command.extend([format!("--{option}"), value]);
    }
}

/// What the command has of a number that the figure shows.
fn in_the_object<'a>(object: &'a Map<String, Value>, name: &str, key: Option<&str>) -> Option<&'a Value> {
    let key = match (name, key) {
        // With its axes in place a wheel knocks as the answer says.
        (_, Some("entry_knock_mm_s")) => "knock_mm_s",
        (_, Some(key)) => key,
        ("clearance", None) => "least_clearance_mm",
        ("crank-radius", None) => "crank_radius_mm",
        _ => return None,
    };
    object.get(key)
}

/// The warnings of a message, and of the command.
fn warnings(message: &str, object: &Map<String, Value>) -> [Vec<String>; 2] {
    let of_page = message.split("Before you make it: ").skip(1);
    let of_page = of_page.map(|rest| rest.split_once(". With so").map_or(rest, |(warning, _)| warning));
    let of_page = of_page.map(|warning| warning.trim_end_matches([' ', '.']).to_owned());
    let of_command = object["warnings"].as_array().expect("a list").iter();
    [of_page.collect(), of_command.map(|warning| warning.as_str().expect("words").to_owned()).collect()]
}

/// Compares both answers to a question; how many numbers are equal, none if both refuse it.
fn compare(live: &Live, Asked { page, command }: &Asked) -> Option<usize> {
    let words: Vec<&str> = command.iter().map(String::as_str).collect();
    let pairs = page.iter().map(|(name, value)| (*name, value.clone()));
    let moved = match live.answer(&LiveArguments::from_pairs(pairs)) {
        Ok(moved) => moved,
        Err(why) => {
            assert_eq!(answered(&words).code, 2, "the figure says: {why}; the command answers: {}", command.join(" "));
            return None;
        }
    };
    let object = object(&words);
    let [of_page, of_command] = warnings(moved.message.as_deref().unwrap_or_default(), &object);
    assert_eq!(of_page, of_command, "{}", command.join(" "));
    let mut equal = 0;
    for of in live.quantities.iter().chain(live.others).chain(&moved.further) {
        let shown = moved.numbers.iter().find(|number| number.name == of.name);
        let told = in_the_object(&object, of.name, of.key).and_then(Value::as_f64);
        let (Some(shown), Some(told)) = (shown, told) else { continue };
        let part = if shown.text.contains('%') { 100.0 } else { 1.0 };
        assert_eq!(shown.value, part * told, "{}: {}", of.name, command.join(" "));
        equal += 1;
    }
    Some(equal)
}

#[test]
fn the_figure_and_the_command_give_the_same_numbers_and_warnings() {
    let live = by_name("design").expect("a figure");
    let mut answered = 0;
    for seed in 0..SETTINGS {
        let Some(equal) = compare(live, &Asked::new(&mut Rng::with_seed(seed))) else { continue };
        assert!(equal > 30, "setting {seed}: only {equal} numbers are in both answers");
        answered += 1;
    }
    assert!(answered > SETTINGS / 3, "only {answered} of {SETTINGS} wheels are possible");
}

#[test]
fn without_play_the_figure_warns_as_the_command_does() {
    let live = by_name("design").expect("a figure");
    for radius in ["10", "25", "33.3", "100"] {
        let settings = LiveArguments::from_pairs([("radius", radius.to_owned()), ("play", "0".to_owned())]);
        let message = live.answer(&settings).expect("an answer").message.expect("a warning");
        assert!(message.contains("without play, parts made exactly as drawn will jam"), "{message}");
        assert!(!message.contains("overlap"), "{message}");
    }
    // Axes that are too near are an overlap.
    let nearer = LiveArguments::from_pairs([("error", "-0.2".to_owned())]);
    let message = live.answer(&nearer).expect("an answer").message.expect("a warning");
    assert!(message.contains("overlap"), "{message}");
}
