//! Do presets set what they say? Each number in a preset's name is looked for among what it sets.

use super::{PAGES, browser, given_on, moves, of, open};
use crate::browser::devtools::Medium;
use geneva_evidence::numbers_in;
use geneva_live::{LIVE, LiveArguments, Preset};
use serde_json::Value;

/// The choice of a mechanism, by the number of its pins.
const PINS: [f64; 3] = [6.0, 4.0, 3.0];

/// The numbers that a preset's name says, in words or in digits, but for ratios.
fn said(name: &str) -> Vec<f64> {
    let is_ratio = |word: &str| ["half", "twice"].contains(&word);
    numbers_in(name).into_iter().filter(|(at, _)| !is_ratio(&name[at.clone()])).map(|(_, number)| number).collect()
}

/// What a preset sets: names, and values as they are written.
fn set(preset: &Preset) -> Vec<(String, String)> {
    let arguments = LiveArguments::parse(preset.arguments).expect("arguments");
    let names: Vec<String> = arguments.names().map(str::to_owned).collect();
    names.iter().map(|name| (name.clone(), arguments.text(name).expect("a value").to_owned())).collect()
}

/// The number that a preset sets for a name.
fn number(preset: &Preset, name: &str) -> Option<f64> {
    set(preset).into_iter().find(|(of, _)| of == name).and_then(|(_, value)| value.parse().ok())
}

/// What is wrong with the words of a figure's preset, if anything.
fn wrong(presets: &[Preset], preset: &Preset) -> Option<String> {
    let set = set(preset);
    let is_set = |number: f64| {
        set.iter().any(|(name, value)| {
            let value = value.parse().map_or(f64::NAN, f64::abs);
            value == number || name == "mechanism" && PINS.get(value as usize) == Some(&number)
        })
    };
    if let Some(missing) = said(preset.name).into_iter().find(|number| !is_set(*number)) {
        return Some(format!("{missing} is not set"));
    }
    // A ratio is a ratio of what is there; a half of what is right may also be half of the right preset's number.
    let is_half = |(name, value): &(String, String)| {
        let right = presets.iter().find(|other| other.name.starts_with("right")).and_then(|right| number(right, name));
        right.is_some_and(|right| value.parse() == Ok(right / 2.0))
    };
    let claims: [(&str, &dyn Fn() -> bool); 5] = [
        ("twice", &|| set.len() == 1 && set[0].1 == "*2"),
        ("half", &|| set.len() == 1 && is_half(&set[0])),
        ("too far", &|| number(preset, "error") > Some(0.0)),
        ("too near", &|| number(preset, "error") < Some(0.0)),
        ("forgotten", &|| set.len() == 1 && set[0].1 == "0"),
    ];
    let broken = claims.iter().find(|(words, holds)| preset.name.contains(words) && !holds());
    let relative = set.iter().any(|(_, value)| value.starts_with('*')) && !preset.name.contains("twice");
    broken.map(|(words, _)| (*words).to_owned()).or_else(|| relative.then(|| "it says no ratio".to_owned()))
}

#[test]
fn presets_set_the_numbers_and_ratios_that_they_say() {
    let mut read = 0;
    for live in LIVE {
        for preset in live.presets {
            assert_eq!(wrong(live.presets, preset), None, "{}: “{}” sets {}", live.name, preset.name, preset.arguments);
            read += said(preset.name).len();
        }
    }
    assert!(read > 10, "{read} numbers were read");
    // What was once there, and some more that is not true.
    for (name, arguments) in [
        ("twice the torque", "torque=0.6"),
        ("half of it: 1", "factor=1.5"),
        ("axes 1 % too near", "error=1"),
        ("eight slots, two pins", "stations=8&pins=1"),
        ("double", "torque=*2"),
    ] {
        let preset = Preset::new(name, arguments);
        let right = Preset::new("right: 2", "factor=2");
        assert!(wrong(&[right], &preset).is_some(), "{name}");
    }
}

/// The answer of a figure that is asked with what its page gives, where every control is as at first but for these.
fn answer(name: &str, page: &str, setting: &str) -> Value {
    let answer = geneva_live::answer(&format!("{name}?{}&{setting}", given_on(page)));
    serde_json::from_str(&answer).expect("JSON")
}

#[test]
fn a_preset_that_names_a_state_gives_it_wherever_the_other_controls_are() {
    if !moves() {
        return;
    }
    let presets = geneva_live::by_name("escapement").expect("a figure").presets;
    let jammed = presets.iter().find(|preset| preset.name.contains("may jam")).expect("a preset");
    for torque in ["0.001", "0.08", "1"] {
        let answer = answer("escapement", "escapement", &format!("{}&torque={torque}", jammed.arguments));
        assert!(answer["message"].as_str().is_some_and(|told| told.contains("no single solution")), "{answer}");
    }
    let of = jammed.arguments;
    let controls = geneva_live::by_name("escapement").expect("a figure").controls;
    let free: Vec<&str> = controls.iter().map(|of| of.name).filter(|name| !of.contains(&format!("{name}="))).collect();
    assert_eq!(free, ["share", "torque"], "the mechanism may jam or not as these are");
}

#[test]
fn the_program_as_listed_prints_as_often_as_the_listing_says() {
    let presets = geneva_live::by_name("mistake").expect("a figure").presets;
    let listed = presets.iter().find(|preset| preset.name.contains("as listed")).expect("a preset");
    let interval = geneva_documents::meyer::runs::table::listing().interval;
    approx::assert_relative_eq!(
        number(listed, "interval").expect("it is set"),
        1000.0 * interval,
        max_relative = 1e-12
    );
}

#[test]
fn twice_the_torque_is_twice_what_it_was_each_time() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    let (name, page) = PAGES.into_iter().find(|(name, _)| *name == "escapement").expect("a page");
    open(&mut browser, page, "");
    let state = "[Number(g.querySelector('[data-box=torque]').value), ...['entry', 'least', 'greatest', 'period'].map(name => \
                 parseFloat(g.closest('figure').querySelector(`output[name=${name}]`).value)), \
                 ...['rate', 'engagements', 'critical'].map(name => f.querySelector(`output[name=${name}]`).value)]";
    let mut before = of(&mut browser, name, state);
    // At the start, beside what the slider can stand at, and beyond its end.
    for typed in [None, Some("0.123"), Some("0.9")] {
        if let Some(torque) = typed {
            of(&mut browser, name, &super::typed("torque", torque));
            before = of(&mut browser, name, state);
        }
        for _ in 0..2 {
            of(
                &mut browser,
                name,
                "[...g.querySelectorAll('[data-set]')].find(of => of.textContent === 'twice the torque').click()",
            );
            let after = of(&mut browser, name, state);
            let ratio = |k: usize| after[k].as_f64().expect("a number") / before[k].as_f64().expect("a number");
            approx::assert_relative_eq!(ratio(0), 2.0, max_relative = 1e-9);
            for k in 1..=3 {
                approx::assert_relative_eq!(ratio(k), 2f64.sqrt(), max_relative = 2e-3);
            }
            approx::assert_relative_eq!(ratio(4), 0.5f64.sqrt(), max_relative = 2e-3);
            for k in 5..=7 {
                assert_eq!(after[k], before[k], "{before} {after}");
            }
            before = after;
        }
    }
    let names = of(&mut browser, name, "f.querySelector('.says').textContent");
    assert!(names.as_str().is_some_and(|told| told.contains("follower's moment of inertia")), "{names}");
}

#[test]
fn the_presets_of_the_chapters_tasks_give_the_numbers_of_their_commands() {
    for (words, task) in [("a table of", "table"), ("from a printer", "printed")] {
        let design = geneva_live::DESIGN;
        let preset = design.presets.iter().find(|preset| preset.name.starts_with(words)).expect(words);
        let arguments = LiveArguments::parse(preset.arguments).expect("arguments");
        let answer = design.answer(&arguments).expect("a wheel");
        let question = geneva_chapters::questions::question(task).expect("a question");
        let mut compared = 0;
        for quantity in design.quantities.iter().chain(design.others) {
            let shown = answer.numbers.iter().find(|number| number.name == quantity.name);
            let (Some(shown), Some(key)) = (shown, quantity.key) else { continue };
            // The page always has a table, and the command of the printed wheel has none.
            if (task, key) == ("printed", "inertia_kgm2") {
                continue;
            }
            // Without a load, none is told.
            let Ok(told) = geneva_chapters::questions::value(&question, key) else { continue };
            // A share is shown in hundredths.
            let told = if shown.text.contains('%') { 100.0 * told } else { told };
            approx::assert_relative_eq!(shown.value, told, max_relative = 1e-9);
            compared += 1;
        }
        assert!(compared > 15, "{task}: {compared}");
    }
}
