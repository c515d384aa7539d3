//! Does `geneva escapement` say what the dynamics say, and does it refuse what they refuse?

mod refusals;
mod run;

use crate::{assert_is_drawn, assert_is_plain, number, on_sheet, pin, right, stdout};
use geneva_case1973::Hypothesis;
use geneva_documents::LEDGER;
use geneva_documents::meyer::terms::starts;
use geneva_dynamics::steady::{Engagement, RiseMeasure};
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

fn command<'a>([slots, friction, torque, driver, follower]: Design<'a>, more: &[&'a str]) -> Vec<&'a str> {
    let inertias = ["--driver-inertia", driver, "--follower-inertia", follower];
    let options = ["escapement", "--slots", slots, "--friction", friction, "--torque", torque];
    [&options[..], &inertias, more].concat()
}

/// The object that the program writes for an escapement.
#[track_caller]
fn object(design: Design, more: &[&str]) -> Map<String, Value> {
    crate::object(&command(design, more))
}

/// Parameters of a design by the library alone, without the command.
fn parameters([slots, friction, torque, driver, follower]: Design) -> Parameters {
    let [friction, torque, driver, follower] =
        [friction, torque, driver, follower].map(|text| text.parse().expect("a number"));
    let mechanism = Mechanism::new(slots.parse().expect("a number")).expect("possible");
    Parameters::new(mechanism, Inertias::new(driver, follower).expect("possible"), torque, friction).expect("possible")
}

#[test]
fn inches_and_pounds_are_told_in_si_units_if_asked_for() {
    let options = ["--friction", "0.2", "--torque", "2", "--driver-inertia", "1", "--follower-inertia", "4"];
    let told = |units: &[&str]| crate::object(&[&["escapement", "--slots", "4"], &options[..], units].concat());
    let (plain, si) = (told(&[]), told(&["--units", "in-lb-s"]));
    assert!(plain.get("torque_n_m").is_none());
    assert_eq!(plain["peak_speed"], si["peak_speed"]);
    // All convert by the same factor: a pound at an inch.
    for (key, value) in [("torque_n_m", 2.0), ("driver_inertia_kg_m2", 1.0), ("follower_inertia_kg_m2", 4.0)] {
        assert!((number(&si, key) / value - 0.112_984_829).abs() < 1e-9, "{key}");
    }
}

#[test]
fn an_escapement_is_written_in_each_format() {
    pin("escapement", &command(FOUR, &[]));
    pin("escapement-json", &command(FOUR, &["--format", "json"]));
    pin("escapement-fields", &command(FOUR, &["--format", "fields"]));
    pin("escapement-csv", &command(FOUR, &["--format", "csv", "--interval", "1e-3"]));
    pin("escapement-reset", &command(["6", "0.2", "1", "1", "5"], &["--reset-deg", "90"]));
    pin("escapement-hardly-braked", &command(["3", "1e-7", "1", "1", "5"], &[]));
}

#[test]
fn numbers_are_those_that_the_ledger_finds_right_in_the_tables_of_1973() {
    for (slots, pins) in [("3", "6-pin"), ("4", "4-pin"), ("6", "3-pin")] {
        let table = format!("meyer.app-e.{pins}");
        let [driver, follower] = ["driver", "follower"].map(|name| {
            let heading = LEDGER.claim(&format!("{table}.{name}")).expect("an inertia above the table");
            format!("{}e-6", heading.right_characters())
        });
        let rows: Vec<_> = LEDGER.claims().iter().filter_map(|claim| row_of(&table, claim.id)).collect();
        assert!(rows.len() >= 12, "{table}: {rows:?}");
        for (friction, torque) in rows {
            let found = object([slots, friction, torque, &driver, &follower], &[]);
            for (key, cell) in [("peak_speed", "max"), ("minimum_speed", "min"), ("period", "period")] {
                let (said, right) = (number(&found, key), right(&format!("{table}.mu-{friction}.k-{torque}.{cell}")));
                assert!((said / right - 1.0).abs() < 1e-9, "{table} {friction} {torque} {key}: {said} {right}");
            }
        }
    }
}

/// Friction and torque of the row whose greatest speed this claim is.
fn row_of(table: &str, id: &'static str) -> Option<(&'static str, &'static str)> {
    id.strip_prefix(table)?.strip_prefix(".mu-")?.strip_suffix(".max")?.split_once(".k-")
}

#[test]
fn each_rise_time_is_called_by_its_measure_in_the_object_and_on_the_sheet() {
    let found = object(FOUR, &[]);
    let keys: Vec<&String> = found.keys().collect();
    let named = |key: &str| {
        let slug = |measure: &RiseMeasure| measure.name().replace(' ', "_");
        RiseMeasure::ALL.iter().any(|measure| key.starts_with(&slug(measure)))
    };
    let rises: Vec<_> = keys.into_iter().filter(|key| key.contains("rise")).collect();
    assert!(rises.len() == 4 && rises.iter().all(|key| named(key)), "{rises:?}");
    let sheet = stdout(&command(FOUR, &[]), 0);
    for measure in [RiseMeasure::Profile, RiseMeasure::Average, RiseMeasure::EntrySpeed] {
        assert!(sheet.contains(&format!("rise, {}", measure.name())), "{sheet}");
    }
    assert!(!sheet.contains("rise time"), "{sheet}");
    assert!(number(&found, "minimum_speed") < number(&found, "entry_speed"));
    assert!(number(&found, "entry_speed") <= number(&found, "peak_speed"));
}

#[test]
fn the_rise_times_of_a_run_of_the_thesis_are_those_that_its_claims_go_by() {
    for (row, start) in starts() {
        let at = Hypothesis::IDEAL.parameters(row).expect("an escapement");
        let numbers = [at.friction(), at.torque(), at.inertias().driver(), at.inertias().follower()];
        let [friction, torque, driver, follower] = numbers.map(|number| format!("{number:e}"));
        let slots = at.mechanism().slots().to_string();
        let found = object([&slots, &friction, &torque, &driver, &follower], &[]);
        let times = ["profile_rise_time", "average_rise_time"].map(|key| number(&found, key));
        for (time, expected) in times.into_iter().zip(start.rise_times) {
            assert!((time / expected - 1.0).abs() < 1e-6, "{}: {time} {expected}", row.slug());
        }
    }
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
            ("profile_rise_time", 0.5),
            ("average_rise_time", 0.5),
            ("entry_speed_rise_time", 0.5),
            ("peak_angle_deg", 1.0),
            ("multiplier", 1.0),
            ("critical_friction", 1.0),
            ("entry_speed_rise_engagements", 1.0),
        ] {
            let (found, expected) = (number(&strong, key), factor * number(&weak, key));
            // The profile's place is found by halving, and the rest by formulas.
            let within = if key == "profile_rise_time" { 1e-8 } else { 1e-12 };
            assert!((found / expected - 1.0).abs() < within, "{slots} {friction}: {key}: {found} {expected}");
        }
    }
}

#[test]
fn the_own_modulus_is_the_default() {
    for (slots, own) in [("3", "60"), ("4", "90"), ("6", "120")] {
        let design = [slots, "0.2", "1", "1", "5"];
        assert_eq!(object(design, &[]), object(design, &["--reset-deg", own]));
        let reset_after = object(design, &["--reset-deg", "89"]);
        assert_ne!(object(design, &[])["period"], reset_after["period"]);
        assert_eq!(object(design, &[])["critical_friction"], reset_after["critical_friction"]);
    }
}

#[test]
fn a_rise_that_is_too_long_is_missing_and_all_else_is_there() {
    let design = ["4", "1e-7", "2", "4e-6", "6e-5"];
    let found = object(design, &[]);
    for key in ["profile_rise_time", "average_rise_time", "entry_speed_rise_time", "entry_speed_rise_engagements"] {
        assert!(found[key].is_null(), "{key}");
    }
    assert!(number(&found, "multiplier") < 1.0 && number(&found, "entry_speed") > 0.0);
    assert!(stdout(&command(design, &[]), 0).contains("longer than 100000 engagements"));
}

#[test]
fn the_sheet_says_what_the_object_says_and_is_no_wider_than_a_line() {
    for design in DESIGNS {
        let (sheet, found) = (stdout(&command(design, &[]), 0), object(design, &[]));
        assert_is_plain(&sheet);
        for (name, key) in [
            ("inertia ratio", "inertia_ratio"),
            ("half-angle", "engagement_half_angle_deg"),
            ("reset angle", "reset_deg"),
            ("critical friction", "critical_friction"),
            ("margin", "least_margin"),
            ("entry speed", "entry_speed"),
            ("peak speed", "peak_speed"),
            ("minimum speed", "minimum_speed"),
            ("mean speed", "mean_speed"),
            ("mean of extremes", "mean_of_extremes"),
            ("period", "period"),
            ("multiplier", "multiplier"),
            ("rise, profile", "profile_rise_time"),
            ("rise, average", "average_rise_time"),
            ("rise, entry speed", "entry_speed_rise_time"),
            ("engagements", "entry_speed_rise_engagements"),
        ] {
            let line = sheet.lines().find_map(|line| line.strip_prefix("  ")?.strip_prefix(name)?.strip_prefix("  "));
            let line = line.unwrap_or_else(|| panic!("{design:?}: no line for {name}"));
            assert!((on_sheet(line) / number(&found, key) - 1.0).abs() < 6e-4, "{design:?}: {line}");
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
            assert_is_drawn(&command(design, options), figure);
        }
    }
    // Without friction there is a mechanism to draw all the same.
    assert!(stdout(&command(["4", "0", "1", "1", "5"], &["--format", "svg"]), 0).starts_with("<svg"));
}
