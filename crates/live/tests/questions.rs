//! No question makes a figure panic or stall: seeded random questions, possible, impossible and broken, to every figure.
//!
//! `GENEVA_FUZZ` sets how many questions are asked, `GENEVA_FUZZ_SEED` where the sequence starts; see CONTRIBUTING.md.

use fastrand::Rng;
use geneva_live::{LIVE, Live, LiveArguments, answer};

/// Questions of a normal test run.
const QUESTIONS: u64 = 400;

/// Data for the figures that need some; only their form is that of a source.
const GIVEN: [(&str, &str); 2] = [
    ("escapement", "follower=0.00013"),
    (
        "mistake",
        "rows=4,0.21,0.31,151,43,0.041,0.0231;6,0.11,0.41,87,61,0.037,0.0113;3,0.23,0.17,93,11,0.067,0.0517&inertias=6,1.1e-5,1.3e-4;\
         4,1.7e-5,1.3e-4;3,1.9e-5,1.7e-4&headed=6,2.1e-4,1.1e-5&duration=0.2&delay=0.00005&pi=3.1416",
    ),
];

/// Endings of questions: parts of an answer, and what is none.
const ENDINGS: [&str; 5] = [".motion", ".turned", ".tolerances", ".wheel.dxf", "."];

/// Values that are no numbers, or numbers that no mechanism has.
const HOSTILE: [&str; 20] = [
    "",
    "x",
    "nan",
    "inf",
    "-inf",
    "1e300",
    "-1e300",
    "1e-300",
    "1e-308",
    "0",
    "-0",
    "-1",
    "2.5",
    "99999999999",
    "1%26unit%3Dx%0A%0A%3Cimg%20src%3Dx%20onerror%3Dalert(1)%3E",
    "%00",
    "%1B%5B31m",
    "%",
    "3e+2",
    "\u{202e}1",
];

fn one<'a>(of: &[&'a str], random: &mut Rng) -> &'a str {
    of[random.usize(..of.len())]
}

/// A question to a figure: some of its settings at the ends of a range, a few hostile.
fn question(live: &Live, random: &mut Rng) -> String {
    let given = GIVEN.iter().find(|(name, _)| *name == live.name).map_or("", |(_, given)| given);
    let mut pairs: Vec<String> = given.split('&').filter(|pair| !pair.is_empty()).map(str::to_owned).collect();
    let is_hostile = random.usize(..3) == 0;
    // In two of three questions few controls are moved, as by a reader: of all at random, few settings are possible.
    let moves_few = random.usize(..3) != 0;
    for control in live.controls {
        if moves_few && random.usize(..4) != 0 {
            continue;
        }
        let [least, most] = if random.usize(..4) == 0 { control.range } else { [control.least, control.most] };
        let value = least + (most - least) * random.f64();
        let value = match random.usize(..8) {
            0 => continue,
            1 => least,
            2 => most,
            3 => value,
            _ => (value / control.step).round() * control.step,
        };
        let text =
            if is_hostile && random.usize(..4) == 0 { one(&HOSTILE, random).to_owned() } else { value.to_string() };
        pairs.push(format!("{}={text}", control.name));
    }
    if is_hostile {
        // The page's data spoiled, a name that is unknown, a name that is given twice.
        let at = random.usize(..pairs.len() + 1);
        match (random.usize(..4), pairs.get(at).and_then(|pair| pair.split_once('='))) {
            (0, Some((name, _))) => pairs[at] = format!("{name}={}", one(&HOSTILE, random)),
            (1, Some((name, value))) => {
                let scaled =
                    value.parse::<f64>().map_or(f64::NAN, |value| value * 10_f64.powf(80.0 * random.f64() - 40.0));
                pairs[at] = format!("{name}={scaled}");
            }
            (2, _) => pairs.push("unknown=1".to_owned()),
            _ => {
                let twice = pairs.get(at).cloned();
                pairs.extend(twice);
            }
        }
    }
    let ending = if random.usize(..10) == 0 { one(&ENDINGS, random) } else { "" };
    format!("{}{ending}?{}", live.name, pairs.join("&"))
}

/// Whether a text has a zero with a sign, which is no part of a longer number or word.
fn has_signed_zero(text: &str) -> bool {
    let is_part = |sign: char| sign.is_alphanumeric() || matches!(sign, '.' | '-' | '−' | '_' | ')' | '°' | '`');
    text.char_indices().filter(|(_, sign)| matches!(sign, '-' | '−')).any(|(at, sign)| {
        let digits = &text[at + sign.len_utf8()..];
        let rest = digits.trim_start_matches(['0', '.']);
        digits.starts_with('0')
            && !rest.starts_with(|sign: char| sign.is_ascii_digit())
            && !text[..at].ends_with(is_part)
    })
}

/// Whether a refusal says what is possible: a range, a list, or what to do instead.
fn says_what_to_give(error: &str) -> bool {
    // What was typed is between backquotes.
    let own: String = error.split('`').step_by(2).collect();
    let has_range = own.contains(|sign: char| sign.is_ascii_digit());
    let is_of_a_number = error.contains("not a number") || error.contains("not an integer");
    let words = [
        "there are",
        "there is none",
        "give one",
        "give others",
        "give it once",
        "is missing",
        "write % as",
        "add ",
        "; give ",
    ];
    if is_of_a_number { own.contains(" to ") } else { has_range || words.iter().any(|words| own.contains(words)) }
}

/// What is wrong with an answer, if anything.
fn fault(answer: &str) -> Option<&'static str> {
    let Ok(read) = serde_json::from_str::<serde_json::Value>(answer) else { return Some("is no JSON") };
    let has_control = |text: &str| text.contains(|c: char| c.is_control() && c != '\n');
    if let Some(error) = read["error"].as_str() {
        if !says_what_to_give(error) {
            return Some("is an error that does not say what to give");
        }
        // The names of all controls of a figure are a longer list.
        let most = if error.starts_with("no argument") { 1200 } else { 400 };
        let is_poor = error.len() < 12 || error.contains('\n') || has_control(error) || error.len() > most;
        return is_poor.then_some("is an error without a reason, or not on one line");
    }
    if has_signed_zero(answer) {
        return Some("has a zero with a sign");
    }
    // How parts stand, which nothing says of a figure that doesn't turn, and rows of tolerances.
    if read.is_null() || read.is_array() || read["half_free"].is_number() {
        return answer.contains("NaN").then_some("has a number that is none");
    }
    let svg = read["svg"].as_str().unwrap_or_default();
    if !svg.starts_with("<svg ") || svg.contains("NaN") || svg.contains("=\"inf") || has_control(svg) {
        return Some("has no sound drawing");
    }
    let texts = read["numbers"].as_array().into_iter().flatten().map(|number| number["text"].as_str().unwrap_or("NaN"));
    texts.into_iter().any(|text| text.contains("NaN") || text.contains("inf")).then_some("has a number that is none")
}

fn setting(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

#[test]
fn fuzz_questions() {
    let (questions, seed) = (setting("GENEVA_FUZZ", QUESTIONS), setting("GENEVA_FUZZ_SEED", 1));
    let (mut drawn, mut refused) = (0_u64, 0_u64);
    for number in 0..questions {
        let mut random = Rng::with_seed(seed.wrapping_add(number << 32));
        let live = LIVE[random.usize(..LIVE.len())];
        let question = question(live, &mut random);
        let answer = answer(&question);
        assert_eq!(fault(&answer), None, "question {number}: {question}\n{answer}");
        *if answer.starts_with("{\"error\"") { &mut refused } else { &mut drawn } += 1;
    }
    println!("{questions} questions: {drawn} answered, {refused} refused");
    assert!(drawn > questions / 4 && refused > questions / 10, "{drawn} answered, {refused} refused");
}

#[test]
fn a_value_that_is_none_is_refused_with_the_range_or_the_choices_of_its_control() {
    for live in LIVE {
        let given = GIVEN.iter().find(|(name, _)| *name == live.name).map_or("", |(_, given)| given);
        for control in live.controls {
            let [least, most] = control.range;
            let range = match control.kind {
                geneva_live::ControlKind::Choice(choices) => format!("0 ({})", choices[0]),
                _ => format!("{least} to {most}"),
            };
            for value in ["x", "nan", "1e300", "5e-324", "-5.9e13"] {
                let text = answer(&format!("{}?{given}&{}={value}", live.name, control.name));
                assert!(text.contains(&range), "{}={value}: no {range} in {text}", control.name);
            }
        }
    }
    for (question, words) in [
        ("design?stations=6.5", "stations N 6.5: not an integer; give an integer from 3 to 100"),
        (
            "design?pin-material=0.5",
            "pin-material `0.5`: none of the choices; give one of 0 (steel), 1 (stainless-steel)",
        ),
        ("design.wheel.dxf?", "no part `wheel.dxf` of a figure: there are motion, turned, tolerances"),
    ] {
        assert!(answer(question).contains(words), "{question}: {}", answer(question));
    }
}

#[test]
fn a_speed_that_is_hardly_any_has_no_sign_where_it_is_rounded_to_zero() {
    for question in ["polygon?rpm=-1e-9", "polygon?crank=-0", "design?centre-error=-0", "wheel?error=-0&crank=-0"] {
        let answer = answer(question);
        assert!(answer.starts_with("{\"numbers\"") && !has_signed_zero(&answer), "{question}: {answer}");
    }
}

#[test]
fn an_unknown_figure_or_argument_is_named_with_those_there_are() {
    let figures: Vec<&str> = LIVE.iter().map(|live| live.name).collect();
    let text = answer("weel?stations=4");
    let refusal = format!("{{\"error\":\"no figure `weel`: there are {}", figures.join(", "));
    assert!(text.starts_with(&refusal), "{text}");
    let text = answer("wheel?stashuns=4");
    assert!(text.starts_with("{\"error\":\"no argument `stashuns`: there are crank, stations"), "{text}");
}

#[test]
fn every_preset_and_every_end_of_a_control_is_answered_or_refused_with_a_reason() {
    for live in LIVE {
        let given = GIVEN.iter().find(|(name, _)| *name == live.name).map_or("", |(_, given)| given);
        let [at_first, presets] =
            [vec![String::new()], live.presets.iter().map(|of| of.arguments.to_owned()).collect()];
        let ends = live.controls.iter().flat_map(|control| {
            [control.least, control.most, control.range[0], control.range[1], control.preset]
                .map(|value| format!("{}={value}", control.name))
        });
        for setting in at_first.into_iter().chain(presets).chain(ends) {
            let text = answer(&format!("{}?{given}&{setting}", live.name));
            assert_eq!(fault(&text), None, "{}?{setting}: {text}", live.name);
        }
    }
}

#[test]
fn every_hostile_value_of_every_control_is_refused() {
    for live in LIVE {
        let given = GIVEN.iter().find(|(name, _)| *name == live.name).map_or("", |(_, given)| given);
        for control in live.controls {
            let hostile = HOSTILE.iter().filter(|value| !["", "0", "-0", "-1", "2.5", "3e+2"].contains(value));
            for value in hostile {
                let text = answer(&format!("{}?{given}&{}={value}", live.name, control.name));
                assert!(text.starts_with("{\"error\":") && fault(&text).is_none(), "{}={value}: {text}", control.name);
            }
        }
    }
}

#[test]
fn broken_questions_are_answered_by_an_error() {
    let long = "x".repeat(1 << 17);
    for odd in ["", "?", "wheel?crank", "wheel?&&==&", "mistake?rows=;;;", "\u{0}", "wheel.exe?", &long] {
        let text = answer(odd);
        assert!(text.starts_with("{\"error\":") && fault(&text).is_none(), "{odd:.20}: {text}");
    }
}

#[test]
fn data_of_the_page_cannot_be_replaced() {
    for (name, given) in GIVEN {
        for pair in given.split('&') {
            let text = answer(&format!("{name}?{given}&{pair}"));
            assert!(text.contains("is given twice"), "{name} {pair}: {text}");
        }
    }
}

#[test]
fn what_a_preset_makes_a_figure_say_is_short_numbers_and_of_its_own_drawing() {
    for live in LIVE {
        let given = GIVEN.iter().find(|(name, _)| *name == live.name).map_or("", |(_, given)| given);
        for preset in live.presets {
            // The page multiplies what is set.
            let times = |pair: &str| match pair.split_once("=*") {
                Some((name, times)) => {
                    let control = live.controls.iter().find(|control| control.name == name).expect("a control");
                    format!("{name}={}", control.preset * times.parse::<f64>().expect("a factor"))
                }
                None => pair.to_owned(),
            };
            let arguments = preset.arguments.split('&').map(times).collect::<Vec<_>>().join("&");
            let setting = format!("{given}&{arguments}");
            let arguments = LiveArguments::parse(setting.trim_start_matches('&'));
            let (message, caption) = match live.answer(&arguments.expect("arguments")) {
                Ok(answer) => (answer.message.unwrap_or_default(), answer.figure.caption),
                Err(message) => (message, String::new()),
            };
            for word in message.split(|c: char| !c.is_ascii_digit() && c != '.') {
                let digits = word.chars().filter(char::is_ascii_digit).count();
                assert!(digits <= 6, "{} {}: {word} in: {message}", live.name, preset.name);
            }
            assert!(!message.contains(" rad "), "{}: an angle is in degrees: {message}", live.name);
            if live.name == "escapement" {
                let jams = message.contains("no single solution");
                assert_eq!(caption.contains("no single solution"), jams, "{}: {message} {caption}", preset.name);
            }
        }
    }
}

/// A number of the design with these settings, in the unit of its text, and its text.
fn designed(settings: &str, name: &str) -> Option<(f64, String)> {
    let live = geneva_live::by_name("design").expect("a figure");
    let answer = live.answer(&LiveArguments::parse(settings).expect("arguments")).expect("an answer");
    answer.numbers.into_iter().find(|number| number.name == name).map(|number| (number.value, number.text))
}

#[test]
fn a_close_fit_on_a_large_wheel_has_its_limits_and_its_clearance_its_digits() {
    for setting in
        ["stations=8&crank-radius=80&play=0.04", "stations=8&crank-radius=80&play=0.06", "crank-radius=100&play=0.15"]
    {
        for name in ["nearer", "farther", "clearance"] {
            assert!(designed(setting, name).is_some(), "{setting}: no {name}");
        }
    }
    assert_eq!(designed("crank-radius=100&play=0.15", "clearance").expect("found").1, "0.075 mm");
}

#[test]
fn axes_a_little_apart_soften_the_knock_and_farther_apart_it_is_a_corner() {
    let knock = |error: f64| designed(&format!("centre-error={error}"), "blow").expect("met").0;
    assert!(knock(0.02) < knock(0.0) && knock(0.04) < knock(0.02), "{} {}", knock(0.0), knock(0.02));
    assert!(knock(0.06) > knock(0.0));
    let live = geneva_live::by_name("design").expect("a figure");
    let told = live.answer(&LiveArguments::parse("centre-error=0.02").expect("one")).expect("an answer").message;
    assert!(told.is_some_and(|told| told.contains("right distance")), "it is not said what is for moved axes");
}

#[test]
fn a_preset_of_the_design_leaves_nothing_of_an_earlier_setting() {
    let live = geneva_live::by_name("design").expect("a figure");
    assert!(live.presets.iter().all(|preset| preset.is_whole), "a preset keeps what was set before it");
}

#[test]
fn no_hint_and_no_message_shows_marks_that_only_a_chapter_understands() {
    for live in LIVE {
        assert!(!live.hint.contains('`'), "{}", live.hint);
    }
    let live = geneva_live::by_name("design").expect("a figure");
    let told =
        live.answer(&LiveArguments::parse("crank-radius=100&play=0.0001").expect("one")).expect("an answer").message;
    assert!(told.is_some_and(|told| told.contains("geneva wheel") && !told.contains('`')));
}
