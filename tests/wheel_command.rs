//! Does `geneva wheel` say what the kinematics say, and does it refuse what they refuse?

mod chapter;
mod cycle;
mod designer;
mod everywhere;
mod idle;
mod lengths;
mod loads;
mod parts;
mod times;
mod workshop;

use crate::{assert_is_drawn, assert_is_plain, number, object, on_sheet, pin, refused, right, stdout};
use geneva_ask::Needs;
use geneva_figures::stations::{internal_mechanism, mechanism, spherical_mechanism};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use geneva_kinematics::wheel::{STATIONS, Wheel};
use std::collections::BTreeMap;

const SIX_AT_360: [&str; 5] = ["wheel", "--stations", "6", "--rpm", "360"];

fn in_format(arguments: &[&'static str], format: &'static str) -> Vec<&'static str> {
    [arguments, &["--format", format]].concat()
}

#[test]
fn a_wheel_is_written_in_each_format() {
    pin("wheel-of-six", &SIX_AT_360);
    pin("wheel-of-six-with-lengths", &[&SIX_AT_360[..], &["--crank-radius", "50"]].concat());
    pin("wheel-of-six-json", &in_format(&SIX_AT_360, "json"));
    pin("wheel-of-six-fields", &in_format(&SIX_AT_360, "fields"));
    pin("wheel-of-six-svg", &in_format(&["wheel", "--stations", "6"], "svg"));
    pin("wheel-without-dwell", &["wheel", "--stations", "4", "--pins", "4"]);
}

#[test]
fn numbers_are_those_that_the_ledger_finds_right_in_the_handout() {
    let found = object(&SIX_AT_360);
    for (key, claim) in [
        ("stations", "jazar.ex.stations"),
        ("rpm", "jazar.ex.rpm"),
        ("dwell_fraction", "jazar.ex-c.fraction"),
        ("dwell_time_s", "jazar.ex-c.dwell"),
        ("peak_speed_rad_s", "jazar.ex-d.peak"),
        ("peak_acceleration_ratio", "jazar.ex-e.ratio"),
        ("peak_acceleration_rad_s2", "jazar.ex-e.peak"),
        ("peak_acceleration_angle_deg", "jazar.ex-e.angle"),
    ] {
        let (said, right) = (number(&found, key), right(claim));
        assert!((said / right - 1.0).abs() < 1e-12, "{key}: {said}, {claim}: {right}");
    }
    // The four slots of the textbook, with a crank of as many millimetres.
    let radius = right("pin.crank-radius");
    let found = object(&["wheel", "--stations", "4", "--crank-radius", &radius.to_string()]);
    assert_eq!(number(&found, "crank_radius_mm"), right("pin.crank-radius"));
    assert!((number(&found, "wheel_radius_mm") / right("pin.crank-radius") - 1.0).abs() < 1e-15);
}

#[test]
fn the_sheet_says_what_the_object_says() {
    for stations in ["3", "6", "1000"] {
        let wheel = ["wheel", "--stations", stations, "--rpm", "7", "--crank-radius", "50"];
        let (sheet, found) = (stdout(&wheel, 0), object(&wheel));
        assert_is_plain(&sheet);
        let mut lines = sheet.lines();
        for (name, keys) in [
            ("engagement half-angle", &["engagement_half_angle_deg"][..]),
            ("centre distance", &["centre_distance_ratio", "centre_distance_mm"]),
            ("wheel radius", &["wheel_radius_ratio", "wheel_radius_mm"]),
            ("least slot length", &["slot_length_ratio", "slot_length_mm"]),
            ("motion fraction", &["motion_fraction"]),
            ("dwell fraction", &["dwell_fraction"]),
            ("indexing time", &["indexing_time_s"]),
            ("dwell time", &["dwell_time_s"]),
            ("peak velocity", &["peak_velocity_ratio", "peak_speed_rad_s"]),
            ("entry acceleration", &["entry_acceleration_ratio", "entry_acceleration_rad_s2"]),
            ("peak acceleration", &["peak_acceleration_ratio", "peak_acceleration_rad_s2"]),
        ] {
            let mut line = lines.find_map(|line| line.strip_prefix("  ")?.strip_prefix(name)).expect(name);
            for key in keys {
                assert!((on_sheet(line) / number(&found, key) - 1.0).abs() < 6e-4, "{key}: {line}");
                // Past the rest of its meaning.
                let is_number = |line: &&str| line.trim_start().starts_with(|first: char| first.is_ascii_digit());
                line = lines.clone().find(is_number).unwrap_or_default();
            }
        }
    }
}

#[test]
fn keys_are_always_there_and_null_without_what_they_need() {
    let report = geneva_ask::answer("wheel --stations 6").expect("an answer");
    let mut needs: BTreeMap<&str, Needs> = report.fields().map(|field| (field.key, field.needs)).collect();
    needs.insert("at", Needs::NONE);
    let (speed, size, pins) = (["--rpm", "360"], ["--crank-radius", "50"], ["--pins", "2"]);
    let (table, friction) = (["--inertia", "0.1"], ["--friction-torque", "2"]);
    let round = ["--table-mass", "2", "--table-diameter", "300"];
    let load = Needs::SPEED.union(Needs::INERTIA).union(Needs::TABLE_INERTIA);
    // A wheel with a size has an inertia of its own.
    let sized = Needs::SIZE.union(Needs::INERTIA);
    for (options, given) in [
        (vec![], Needs::NONE),
        (speed.to_vec(), Needs::SPEED),
        (size.to_vec(), sized),
        ([speed, size].concat(), Needs::SPEED.union(sized)),
        (pins.to_vec(), Needs::SECOND_PIN),
        ([pins, size].concat(), Needs::SECOND_PIN.union(sized)),
        ([speed, table].concat(), load),
        ([speed, table, friction, size].concat(), load.union(Needs::FRICTION_TORQUE).union(sized)),
        ([&speed[..], &size, &round].concat(), load.union(sized).union(Needs::TABLE)),
    ] {
        let found = object(&[&["wheel", "--stations", "6"], &options[..]].concat());
        assert!(found.keys().eq(needs.keys()), "{options:?}");
        for (key, value) in found {
            assert_eq!(value.is_null(), !needs[&*key].are_met_by(given), "{key} with {options:?}");
            let kind = ["type", "at", "holes", "warnings"].contains(&&*key);
            assert!(kind || value.is_null() || value.is_number(), "{key} with {options:?}: {value}");
        }
    }
}

/// Every kind of wheel, and what makes it.
fn kinds(stations: u32) -> [(&'static str, Box<dyn Indexing>); 3] {
    [
        ("external", Box::new(Wheel::new(stations).expect("possible"))),
        ("internal", Box::new(InternalWheel::new(stations).expect("possible"))),
        ("spherical", Box::new(SphericalWheel::new(stations).expect("possible"))),
    ]
}

#[test]
fn every_kind_of_wheel_says_what_its_kinematics_say() {
    for stations in [3, 5, 8, 40] {
        for (kind, wheel) in kinds(stations) {
            let typed = stations.to_string();
            let found = object(&["wheel", "--stations", &typed, "--type", kind, "--rpm", "30"]);
            assert_eq!(found["type"], kind);
            let speed = std::f64::consts::PI;
            for (key, right) in [
                ("motion_fraction", wheel.motion_fraction()),
                ("dwell_fraction", wheel.dwell_fraction()),
                ("engagement_half_angle_deg", wheel.engagement_half_angle().to_degrees()),
                ("indexing_time_s", wheel.indexing_time(speed).expect("positive")),
                ("dwell_time_s", wheel.dwell_time(speed).expect("positive")),
                ("peak_velocity_ratio", wheel.peak_velocity()),
                ("peak_speed_rad_s", wheel.peak_velocity() * speed),
                ("entry_acceleration_ratio", wheel.entry_acceleration()),
                ("peak_acceleration_ratio", wheel.acceleration_peak().ratio),
                ("peak_acceleration_angle_deg", wheel.acceleration_peak().angle.to_degrees()),
                ("peak_jerk_ratio", wheel.jerk_peak().ratio),
                ("peak_jerk_rad_s3", wheel.jerk_peak().ratio * speed * speed * speed),
            ] {
                let said = number(&found, key);
                assert!((said - right).abs() <= 1e-14 * right.abs(), "{kind} {stations} {key}: {said}, {right}");
            }
        }
    }
    pin("wheel-internal", &["wheel", "--stations", "6", "--type", "internal", "--centre-distance", "100"]);
    pin("wheel-spherical", &["wheel", "--stations", "6", "--type", "spherical", "--rpm", "60", "--wheel-radius", "80"]);
}

#[test]
fn the_drawing_is_that_of_the_figures_and_stands_alone() {
    for (stations, pins) in [("3", "1"), ("6", "1"), ("8", "2")] {
        let wheel = Wheel::with_pins(stations.parse().expect("whole"), pins.parse().expect("whole")).expect("possible");
        assert_is_drawn(&["wheel", "--stations", stations, "--pins", pins], &mechanism(&wheel));
    }
    let internal = internal_mechanism(&InternalWheel::new(5).expect("possible"));
    assert_is_drawn(&["wheel", "--stations", "5", "--type", "internal"], &internal);
    let spherical = spherical_mechanism(&SphericalWheel::with_pins(7, 2).expect("possible"));
    assert_is_drawn(&["wheel", "--stations", "7", "--type", "spherical", "--pins", "2"], &spherical);
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
        (&["--stations", "6", "--pins", "-1"], "'-1'", "from 1 to 6"),
        (&["--stations", "6", "--rpm", "0"], "'0' for '--rpm", "above zero"),
        (&["--stations", "6", "--rpm", "-360"], "'-360' for '--rpm", "above zero"),
        (&["--stations", "6", "--rpm", "nan"], "'nan' for '--rpm", "above zero"),
        (&["--stations", "6", "--rpm", "inf"], "'inf' for '--rpm", "between 1e-30 and 1e30"),
        (&["--stations", "6", "--rpm", "1e200"], "'1e200' for '--rpm", "between 1e-30 and 1e30"),
        (&["--stations", "6", "--rpm", "fast"], "'fast'", "above zero"),
        (&["--stations", "6", "--crank-radius", "0"], "'0' for '--crank-radius", "above zero"),
        (&["--stations", "6", "--crank-radius", "-50"], "'-50' for '--crank-radius", "above zero"),
        (&["--stations", "6", "--crank-radius", "1e308"], "'1e308' for '--crank-radius", "between 1e-30 and 1e30"),
        (&["--stations", "6", "--crank-radius", "long"], "'long'", "millimetres above zero"),
        (&["--stations", "6", "--centre-distance", "0"], "'0' for '--centre-distance", "above zero"),
        (&["--stations", "6", "--wheel-radius", "nan"], "'nan' for '--wheel-radius", "above zero"),
        (&["--stations", "6", "--pin-diameter", "-1"], "'-1' for '--pin-diameter", "above zero"),
        (&["--stations", "6", "--play", "-0.1"], "'-0.1' for '--play", "zero or more"),
        (&["--stations", "6", "--horn", "0"], "'0' for '--horn", "above zero"),
        (&["--stations", "6", "--wheel-shaft", "thick"], "'thick'", "give zero"),
        (&["--stations", "6", "--driver-shaft", "-3"], "'-3' for '--driver-shaft", "zero or more"),
        (&["--stations", "6", "--inertia", "-2"], "'-2' for '--inertia", "zero or more"),
        (&["--stations", "6", "--friction-torque", "inf"], "'inf' for '--friction-torque", "between 1e-30 and 1e30"),
        (&["--stations", "6", "--density", "0"], "'0' for '--density", "above zero"),
        (&["--stations", "6", "--at", "inf"], "'inf' for '--at", "between"),
        (&["--stations", "6", "--at", "north"], "'north'", "degrees"),
        (&["--stations", "6", "--type", "internal", "--pins", "2"], "2 pins", "has only 1,"),
        (&["--stations", "6", "--type", "spherical", "--pins", "3"], "3 pins", "1 to 2"),
        (&["--index-time", "0", "--dwell-time", "1"], "'0' for '--index-time", "above zero"),
    ] {
        // The drawing needs neither speed nor load, but a wrong one is a mistake there too.
        for format in ["text", "json", "csv", "svg"] {
            let said = refused(&[&["wheel", "--format", format], options].concat());
            assert!(said.starts_with("error: ") && said.contains("give "), "{options:?}: {said}");
            assert!(said.contains(value) && said.contains(allowed), "{options:?}: {said}");
        }
    }
    pin("wheel-with-too-many-pins", &["wheel", "--stations", "6", "--pins", "4"]);
    pin("wheel-without-stations", &["wheel", "--rpm", "360"]);
}
