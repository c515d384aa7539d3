//! Does `geneva wheel` say what the kinematics say, and does it refuse what they refuse?

use crate::{geneva, pin, refusal, run, stdout};
use geneva_figures::stations::mechanism;
use geneva_kinematics::wheel::{STATIONS, Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use serde_json::{Map, Value};
use std::f64::consts::PI;

/// What needs the speed of the driver.
const OF_SPEED: [&str; 6] = [
    "rpm",
    "advance_time_s",
    "dwell_time_s",
    "peak_speed_rad_s",
    "entry_acceleration_rad_s2",
    "peak_acceleration_rad_s2",
];
/// What needs the crank radius.
const OF_SIZE: [&str; 4] = ["crank_radius_mm", "centre_distance_mm", "wheel_radius_mm", "slot_length_mm"];
/// What needs neither.
const ALWAYS: [&str; 12] = [
    "stations",
    "pins",
    "engagement_half_angle_deg",
    "centre_distance_ratio",
    "wheel_radius_ratio",
    "slot_length_ratio",
    "motion_fraction",
    "dwell_fraction",
    "peak_velocity_ratio",
    "entry_acceleration_ratio",
    "peak_acceleration_ratio",
    "peak_acceleration_angle_deg",
];

const SIX_AT_360: [&str; 5] = ["wheel", "--stations", "6", "--rpm", "360"];

fn in_format(arguments: &[&'static str], format: &'static str) -> Vec<&'static str> {
    [arguments, &["--format", format]].concat()
}

/// The object that the program writes for these options.
#[track_caller]
fn object(options: &[&str]) -> Map<String, Value> {
    let arguments = [&["wheel", "--format", "json"], options].concat();
    serde_json::from_str(&stdout(&arguments, 0)).expect("an object")
}

#[test]
fn a_wheel_is_written_in_each_format() {
    pin("wheel-of-six", &SIX_AT_360);
    pin("wheel-of-six-with-lengths", &[&SIX_AT_360[..], &["--crank-radius", "50"]].concat());
    pin("wheel-of-six-json", &in_format(&SIX_AT_360, "json"));
    pin("wheel-of-six-csv", &in_format(&SIX_AT_360, "csv"));
    pin("wheel-of-six-svg", &in_format(&SIX_AT_360, "svg"));
    pin("wheel-without-dwell", &["wheel", "--stations", "4", "--pins", "4"]);
}

#[test]
fn numbers_are_those_of_the_kinematics_with_all_their_digits() {
    for (stations, pins) in [(3, 1), (4, 4), (6, 1), (7, 2), (18, 1), (1000, 2)] {
        let wheel = Wheel::with_pins(stations, pins).expect("it can be built");
        let (rpm, radius) = (360_f64, 50_f64);
        let speed = rpm * PI / 30.0;
        let (peak_speed, peak_acceleration) = wheel.peaks(speed).expect("a speed");
        let (stations, pins) = (stations.to_string(), pins.to_string());
        let found = object(&["--stations", &stations, "--pins", &pins, "--rpm", "360", "--crank-radius", "50"]);
        assert_eq!(found["stations"], wheel.stations());
        assert_eq!(found["pins"], wheel.pins());
        for (key, value) in [
            ("rpm", rpm),
            ("crank_radius_mm", radius),
            ("engagement_half_angle_deg", wheel.engagement_half_angle().to_degrees()),
            ("centre_distance_ratio", wheel.centre_distance_ratio()),
            ("centre_distance_mm", radius * wheel.centre_distance_ratio()),
            ("wheel_radius_ratio", wheel.wheel_radius_ratio()),
            ("wheel_radius_mm", radius * wheel.wheel_radius_ratio()),
            ("slot_length_ratio", wheel.slot_length_ratio()),
            ("slot_length_mm", radius * wheel.slot_length_ratio()),
            ("motion_fraction", wheel.motion_fraction()),
            ("dwell_fraction", wheel.dwell_fraction()),
            ("advance_time_s", wheel.advance_time(speed).expect("a speed")),
            ("dwell_time_s", wheel.dwell_time(speed).expect("a speed")),
            ("peak_velocity_ratio", peak_velocity(&wheel)),
            ("peak_speed_rad_s", peak_speed),
            ("entry_acceleration_ratio", entry_acceleration(&wheel)),
            ("entry_acceleration_rad_s2", speed * speed * entry_acceleration(&wheel)),
            ("peak_acceleration_ratio", acceleration_peak(&wheel).ratio),
            ("peak_acceleration_rad_s2", peak_acceleration),
            ("peak_acceleration_angle_deg", acceleration_peak(&wheel).angle.to_degrees()),
        ] {
            let said = found[key].as_f64().map(f64::to_bits);
            assert_eq!(said, Some(value.to_bits()), "{stations} stations, {pins} pins, {key}");
        }
    }
}

#[test]
fn keys_are_always_there_and_null_without_what_they_need() {
    for (options, missing) in [
        (&[][..], [&OF_SPEED[..], &OF_SIZE].concat()),
        (&["--rpm", "360"], OF_SIZE.to_vec()),
        (&["--crank-radius", "50"], OF_SPEED.to_vec()),
        (&["--rpm", "360", "--crank-radius", "50"], Vec::new()),
    ] {
        let found = object(&[&["--stations", "6"], options].concat());
        let keys = [&ALWAYS[..], &OF_SPEED, &OF_SIZE].concat();
        assert_eq!(found.len(), keys.len(), "{options:?}");
        for key in keys {
            let value = found.get(key).unwrap_or_else(|| panic!("{key} is missing with {options:?}"));
            assert_eq!(value.is_null(), missing.contains(&key), "{key} with {options:?}");
            assert!(value.is_null() || value.is_number(), "{key} with {options:?}: {value}");
        }
    }
}

#[test]
fn csv_is_the_object_in_a_row() {
    for options in [&["--stations", "6"][..], &["--stations", "6", "--rpm", "360", "--crank-radius", "50"]] {
        let text = stdout(&[&["wheel", "--format", "csv"], options].concat(), 0);
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let columns = reader.headers().expect("a header").clone();
        let rows: Vec<_> = reader.records().map(|row| row.expect("as many cells as columns")).collect();
        let object = object(options);
        assert_eq!(rows.len(), 1);
        assert_eq!(columns.len(), object.len());
        for (column, cell) in columns.iter().zip(&rows[0]) {
            assert_eq!(cell.parse::<f64>().ok(), object[column].as_f64(), "{column}");
            assert_eq!(cell.is_empty(), object[column].is_null(), "{column}");
        }
    }
}

#[test]
fn the_sheet_is_no_wider_than_a_line() {
    for wheel in [&SIX_AT_360[..], &["wheel", "--stations", "1000", "--rpm", "7", "--crank-radius", "50"]] {
        for line in stdout(wheel, 0).lines() {
            assert!(line.chars().count() <= 100, "{line}");
            assert_eq!(line.trim_end(), line);
        }
    }
}

#[test]
fn the_drawing_is_that_of_the_figures_and_stands_alone() {
    for (stations, pins) in [("3", "1"), ("6", "1"), ("8", "2")] {
        let svg = stdout(&["wheel", "--stations", stations, "--pins", pins, "--format", "svg"], 0);
        let wheel = Wheel::with_pins(stations.parse().expect("whole"), pins.parse().expect("whole")).expect("possible");
        let figure = mechanism(&wheel).svg;
        assert!(!svg.contains("var("), "a colour that only a browser understands");
        let (drawn, expected) = (roxmltree::Document::parse(&svg), roxmltree::Document::parse(&figure));
        let (drawn, expected) = (drawn.expect("XML"), expected.expect("XML"));
        assert!(drawn.root_element().has_tag_name(("http://www.w3.org/2000/svg", "svg")));
        let paths = |document: &roxmltree::Document| -> Vec<String> {
            document.descendants().filter_map(|node| node.attribute("d")).map(str::to_owned).collect()
        };
        assert_eq!(paths(&drawn), paths(&expected), "{stations} stations, {pins} pins");
    }
}

#[test]
fn what_cannot_be_is_refused_with_what_can() {
    let (least, most) = (STATIONS.start(), STATIONS.end());
    let range = format!("{least} to {most}");
    assert!(stdout(&["wheel", "--help"], 0).contains(&range));
    for (options, value, allowed) in [
        (&["--stations", "2"][..], "2 stations", &*range),
        (&["--stations", "1001"], "1001 stations", &range),
        (&["--stations", "-3"], "'-3'", &range),
        (&["--stations", "six"], "'six'", &range),
        (&["--stations", "6", "--pins", "4"], "4 pins", "1 to 3"),
        (&["--stations", "6", "--pins", "0"], "0 pins", "1 to 3"),
        (&["--stations", "6", "--pins", "-1"], "'-1'", "from 1 up"),
        (&["--stations", "6", "--rpm", "0"], "--rpm 0", "above zero"),
        (&["--stations", "6", "--rpm", "-360"], "--rpm -360", "above zero"),
        (&["--stations", "6", "--rpm", "nan"], "--rpm NaN", "above zero"),
        (&["--stations", "6", "--rpm", "inf"], "--rpm inf", "above zero"),
        (&["--stations", "6", "--rpm", "1e200"], "--rpm 1e200", "can have"),
        (&["--stations", "6", "--rpm", "fast"], "'fast'", "above zero"),
        (&["--stations", "6", "--crank-radius", "0"], "--crank-radius 0", "above zero"),
        (&["--stations", "6", "--crank-radius", "-50"], "--crank-radius -50", "above zero"),
        (&["--stations", "6", "--crank-radius", "1e308"], "--crank-radius 1e308", "can have"),
        (&["--stations", "6", "--crank-radius", "long"], "'long'", "above zero"),
    ] {
        // The drawing needs neither speed nor size, but a wrong one is a mistake there too.
        for format in ["text", "json", "csv", "svg"] {
            let said = refusal(geneva(&[&["wheel", "--format", format], options].concat()));
            assert!(said.starts_with("error: ") && said.contains("give "), "{options:?}: {said}");
            assert!(said.contains(value) && said.contains(allowed), "{options:?}: {said}");
        }
    }
    pin("wheel-with-too-many-pins", &["wheel", "--stations", "6", "--pins", "4"]);
    pin("wheel-without-stations", &["wheel", "--rpm", "360"]);
}

#[test]
fn nothing_but_text_goes_into_a_pipe() {
    for arguments in [&SIX_AT_360[..], &["wheel", "--stations", "2"]] {
        let output = run(arguments);
        assert!(!output.stdout.contains(&0x1b) && !output.stderr.contains(&0x1b), "{arguments:?}");
        assert_eq!(output.stderr.is_empty(), output.status.success(), "{arguments:?}");
    }
}
