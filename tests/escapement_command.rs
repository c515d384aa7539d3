//! Does `geneva escapement` say what the dynamics say, and does it refuse what they refuse?

mod refusals;
mod run;

use crate::{pin, stdout};
use geneva_dynamics::existence::{critical_friction, least_margin};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_figures::escapement::{mechanism, normal_force};
use geneva_figures::runs::speeds;
use geneva_kinematics::Mechanism;
use serde_json::{Map, Value};

/// Slots, friction, torque, inertia of the driver, of the follower.
type Design<'a> = [&'a str; 5];

const FOUR: Design = ["4", "0.3", "2", "4e-6", "6e-5"];

/// Escapements of each kind: hardly braked, nearly too much, light and heavy drivers, several units.
const DESIGNS: [Design; 9] = [
    FOUR,
    ["4", "0.05", "2", "4e-6", "6e-5"],
    ["4", "0.4", "11", "4", "60"],
    ["3", "0.1", "7", "4e-6", "3e-5"],
    ["3", "0.25", "1", "1", "5"],
    ["6", "0.3", "0.5", "7e-6", "1e-5"],
    ["6", "2", "1", "1", "1"],
    ["6", "1e-3", "1", "1", "1"],
    ["4", "0.6", "1e9", "1e12", "2e12"],
];

/// All keys of the object, in order.
const KEYS: [&str; 26] = [
    "slots",
    "pins",
    "friction",
    "torque",
    "driver_inertia",
    "follower_inertia",
    "inertia_ratio",
    "modulus_deg",
    "engagement_half_angle_deg",
    "critical_friction",
    "critical_angle_deg",
    "least_margin",
    "least_margin_angle_deg",
    "entry_speed",
    "peak_speed",
    "peak_angle_deg",
    "minimum_speed",
    "minimum_angle_deg",
    "mean_speed",
    "mean_of_extremes",
    "period",
    "contraction",
    "switch_angles_deg",
    "rise_time",
    "rise_time_definition",
    "engagements_to_settle",
];

fn command<'a>([slots, friction, torque, driver, follower]: Design<'a>, more: &[&'a str]) -> Vec<&'a str> {
    let inertias = ["--driver-inertia", driver, "--follower-inertia", follower];
    let options = ["escapement", "--slots", slots, "--friction", friction, "--torque", torque];
    [&options[..], &inertias, more].concat()
}

/// The object that the program writes for an escapement.
#[track_caller]
fn object(design: Design, more: &[&str]) -> Map<String, Value> {
    let text = stdout(&command(design, &[&["--format", "json"], more].concat()), 0);
    serde_json::from_str(&text).expect("an object")
}

/// The same by the library alone.
fn parameters([slots, friction, torque, driver, follower]: Design) -> Parameters {
    let [friction, torque, driver, follower] =
        [friction, torque, driver, follower].map(|text| text.parse().expect("a number"));
    let mechanism = Mechanism::new(slots.parse().expect("a number")).expect("possible");
    Parameters::new(mechanism, Inertias::new(driver, follower).expect("possible"), torque, friction).expect("possible")
}

#[track_caller]
fn number(object: &Map<String, Value>, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("{key} is {}", object[key]))
}

#[test]
fn inches_and_pounds_are_told_in_si_units_if_asked_for() {
    let options = ["--friction", "0.2", "--torque", "2", "--driver-inertia", "1", "--follower-inertia", "4"];
    let told = |units: &[&str]| {
        let arguments = [&["escapement", "--slots", "4", "--format", "json"][..], &options, units].concat();
        let text = stdout(&arguments, 0);
        serde_json::from_str::<Value>(&text).expect("an object")
    };
    let (plain, si) = (told(&[]), told(&["--units", "in-lb-s"]));
    assert!(plain.get("torque_n_m").is_none());
    assert_eq!(plain["peak_speed"], si["peak_speed"]);
    let number = |key: &str| si[key].as_f64().expect("a number");
    // Both convert by the same factor: a pound at an inch.
    assert!((number("torque_n_m") / 2.0 - number("follower_inertia_kg_m2") / 4.0).abs() < 1e-12);
    assert!((0.11..0.12).contains(&number("driver_inertia_kg_m2")));
}

#[test]
fn an_escapement_is_written_in_each_format() {
    pin("escapement", &command(FOUR, &[]));
    pin("escapement-json", &command(FOUR, &["--format", "json"]));
    pin("escapement-csv", &command(FOUR, &["--format", "csv", "--interval", "1e-3"]));
    pin("escapement-folded", &command(["6", "0.2", "1", "1", "5"], &["--modulus-deg", "90"]));
    pin("escapement-hardly-braked", &command(["3", "1e-7", "1", "1", "5"], &[]));
}

#[test]
fn numbers_are_those_of_the_dynamics_with_all_their_digits() {
    for design in DESIGNS {
        for modulus in [None, Some("45"), Some("72.5"), Some("90"), Some("150")] {
            let parameters = parameters(design);
            let (mechanism, ratio) = (parameters.mechanism(), parameters.inertias().ratio());
            let more: Vec<_> = modulus.into_iter().flat_map(|modulus| ["--modulus-deg", modulus]).collect();
            let own = 360.0 / f64::from(mechanism.pins());
            let degrees = modulus.map_or(own, |text| text.parse::<f64>().expect("a number"));
            let engagement = if degrees == own {
                Engagement::new(&parameters)
            } else {
                Engagement::folded(&parameters, degrees.to_radians(), 1e-12)
            };
            let engagement = engagement.expect("an engagement");
            let steady = engagement.steady_state().expect("a steady state");
            let (engagements, rise_time) = engagement.engagements_to_settle(0.01).expect("a rise");
            let critical = critical_friction(mechanism, ratio).expect("possible");
            let margin = least_margin(mechanism, ratio, parameters.friction()).expect("possible");
            let found = object(design, &more);
            for (key, value) in [
                ("slots", f64::from(mechanism.slots())),
                ("pins", f64::from(mechanism.pins())),
                ("friction", parameters.friction()),
                ("torque", parameters.torque()),
                ("driver_inertia", parameters.inertias().driver()),
                ("follower_inertia", parameters.inertias().follower()),
                ("inertia_ratio", ratio),
                ("modulus_deg", degrees),
                ("engagement_half_angle_deg", mechanism.engagement_half_angle().to_degrees()),
                ("critical_friction", critical.friction),
                ("critical_angle_deg", critical.angle.to_degrees()),
                ("least_margin", margin.margin),
                ("least_margin_angle_deg", margin.angle.to_degrees()),
                ("entry_speed", steady.entry_speed),
                ("peak_speed", steady.peak.speed),
                ("peak_angle_deg", steady.peak.angle.to_degrees()),
                ("minimum_speed", steady.minimum.speed),
                ("minimum_angle_deg", steady.minimum.angle.to_degrees()),
                ("mean_speed", steady.mean_speed),
                ("mean_of_extremes", steady.mean_of_extremes()),
                ("period", steady.period),
                ("contraction", steady.contraction),
                ("rise_time", rise_time),
                ("engagements_to_settle", engagements as f64),
            ] {
                assert_eq!(number(&found, key).to_bits(), value.to_bits(), "{design:?} {modulus:?}: {key}");
            }
            let centres = (degrees > own / 2.0).then_some(0.0);
            let switches: Vec<_> = centres.into_iter().chain(steady.switch_angle.map(f64::to_degrees)).collect();
            assert_eq!(found["switch_angles_deg"], Value::from(switches), "{design:?} {modulus:?}");
        }
    }
}

#[test]
fn the_object_has_its_keys_and_says_what_the_rise_time_is() {
    let found = object(FOUR, &[]);
    let text = stdout(&command(FOUR, &["--format", "json"]), 0);
    let places: Vec<_> = KEYS.iter().map(|key| text.find(&format!("\"{key}\":"))).collect();
    assert!(places.is_sorted() && places.iter().all(Option::is_some) && found.len() == KEYS.len(), "{text}");
    let definition = found["rise_time_definition"].as_str().expect("text");
    assert!(definition.contains("99 %") && definition.contains("entry speed"), "{definition}");
    assert!(number(&found, "minimum_speed") < number(&found, "entry_speed"));
    assert!(number(&found, "entry_speed") <= number(&found, "peak_speed"));
}

#[test]
fn four_times_the_torque_doubles_speeds_and_halves_times() {
    for [slots, friction, torque, driver, follower] in DESIGNS {
        let fourfold = format!("{:e}", 4.0 * torque.parse::<f64>().expect("a number"));
        let weak = object([slots, friction, torque, driver, follower], &[]);
        let strong = object([slots, friction, &fourfold, driver, follower], &[]);
        for (key, factor) in [
            ("entry_speed", 2.0),
            ("peak_speed", 2.0),
            ("minimum_speed", 2.0),
            ("mean_speed", 2.0),
            ("mean_of_extremes", 2.0),
            ("period", 0.5),
            ("rise_time", 0.5),
            ("peak_angle_deg", 1.0),
            ("contraction", 1.0),
            ("critical_friction", 1.0),
            ("engagements_to_settle", 1.0),
        ] {
            let (found, expected) = (number(&strong, key), factor * number(&weak, key));
            assert!((found / expected - 1.0).abs() < 1e-12, "{slots} {friction}: {key}: {found} {expected}");
        }
    }
}

#[test]
fn the_own_modulus_is_the_default() {
    for (slots, own) in [("3", "60"), ("4", "90"), ("6", "120")] {
        let design = [slots, "0.2", "1", "1", "5"];
        assert_eq!(object(design, &[]), object(design, &["--modulus-deg", own]));
        let folded = object(design, &["--modulus-deg", "89"]);
        assert_ne!(object(design, &[])["period"], folded["period"]);
        assert_eq!(object(design, &[])["critical_friction"], folded["critical_friction"]);
    }
}

#[test]
fn a_rise_that_is_too_long_is_missing_and_all_else_is_there() {
    let design = ["4", "1e-7", "2", "4e-6", "6e-5"];
    let found = object(design, &[]);
    assert!(found["rise_time"].is_null() && found["engagements_to_settle"].is_null());
    assert!(number(&found, "contraction") < 1.0 && number(&found, "entry_speed") > 0.0);
    assert!(stdout(&command(design, &[]), 0).contains("more than 100000 engagements"));
}

#[test]
fn the_sheet_says_what_the_object_says_and_is_no_wider_than_a_line() {
    for design in DESIGNS {
        let (sheet, found) = (stdout(&command(design, &[]), 0), object(design, &[]));
        for line in sheet.lines() {
            assert!(line.chars().count() <= 100, "{line}");
            assert_eq!(line.trim_end(), line);
            assert!(!line.contains('\u{1b}'), "{line}");
        }
        for (name, key) in [
            ("inertia ratio", "inertia_ratio"),
            ("half-angle", "engagement_half_angle_deg"),
            ("modulus", "modulus_deg"),
            ("critical friction", "critical_friction"),
            ("margin", "least_margin"),
            ("entry speed", "entry_speed"),
            ("peak speed", "peak_speed"),
            ("minimum speed", "minimum_speed"),
            ("mean speed", "mean_speed"),
            ("mean of extremes", "mean_of_extremes"),
            ("period", "period"),
            ("contraction", "contraction"),
            ("rise time", "rise_time"),
            ("engagements", "engagements_to_settle"),
        ] {
            let line = sheet.lines().find_map(|line| line.strip_prefix("  ")?.strip_prefix(name)?.strip_prefix("  "));
            let line = line.unwrap_or_else(|| panic!("{design:?}: no line for {name}")).replace('−', "-");
            let said: f64 = line.split_whitespace().next().and_then(|word| word.parse().ok()).expect("a number");
            assert!((said / number(&found, key) - 1.0).abs() < 6e-4, "{design:?}: {line}");
        }
    }
}

#[test]
fn the_drawings_are_those_of_the_figures_and_stand_alone() {
    for design in [FOUR, ["3", "0.1", "7", "4e-6", "3e-5"], ["6", "2", "1", "1", "1"]] {
        let parameters = parameters(design);
        let escapement = parameters.mechanism();
        let scaled = mechanism(&escapement, -escapement.engagement_half_angle() / 3.0).expect("an engaged pin");
        let steady = Engagement::new(&parameters).and_then(|engagement| engagement.steady_state()).expect("steady");
        let forces = normal_force(&parameters, steady.entry_speed).expect("a motion");
        let run = Engagement::new(&parameters).expect("an engagement");
        let run = speeds(&run, "").expect("a run");
        for (options, figure) in [
            (&[][..], &scaled),
            (&["--figure", "mechanism"], &scaled),
            (&["--figure", "normal-force"], &forces),
            (&["--figure", "run"], &run),
        ] {
            let svg = stdout(&command(design, &[&["--format", "svg"], options].concat()), 0);
            assert!(!svg.contains("var("), "a colour that only a browser understands");
            let (drawn, expected) = (roxmltree::Document::parse(&svg), roxmltree::Document::parse(&figure.svg));
            let (drawn, expected) = (drawn.expect("XML"), expected.expect("XML"));
            assert!(drawn.root_element().has_tag_name(("http://www.w3.org/2000/svg", "svg")));
            let paths = |document: &roxmltree::Document| -> Vec<String> {
                document.descendants().filter_map(|node| node.attribute("d")).map(str::to_owned).collect()
            };
            assert_eq!(paths(&drawn), paths(&expected), "{design:?}: {}", figure.id);
        }
    }
    // Without friction there is a mechanism to draw all the same.
    assert!(stdout(&command(["4", "0", "1", "1", "5"], &["--format", "svg"]), 0).starts_with("<svg"));
}
