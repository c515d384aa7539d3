//! Does `geneva wheel` say what the kinematics say, and does it refuse what they refuse?

use crate::{assert_is_drawn, assert_is_plain, geneva, number, object, on_sheet, pin, refusal, right, stdout};
use geneva_figures::stations::mechanism;
use geneva_kinematics::wheel::{STATIONS, Wheel};

/// What needs the speed of the driver.
const OF_SPEED: [&str; 6] = [
    "rpm",
    "indexing_time_s",
    "dwell_time_s",
    "peak_speed_rad_s",
    "entry_acceleration_rad_s2",
    "peak_acceleration_rad_s2",
];
/// What needs the crank radius.
const OF_SIZE: [&str; 4] = ["crank_radius_mm", "centre_distance_mm", "wheel_radius_mm", "slot_length_mm"];
const SIX_AT_360: [&str; 5] = ["wheel", "--stations", "6", "--rpm", "360"];

fn in_format(arguments: &[&'static str], format: &'static str) -> Vec<&'static str> {
    [arguments, &["--format", format]].concat()
}

#[test]
fn a_wheel_is_written_in_each_format() {
    pin("wheel-of-six", &SIX_AT_360);
    pin("wheel-of-six-with-lengths", &[&SIX_AT_360[..], &["--crank-radius", "0.05"]].concat());
    pin("wheel-of-six-json", &in_format(&SIX_AT_360, "json"));
    pin("wheel-is-no-series", &in_format(&SIX_AT_360, "csv"));
    pin("wheel-of-six-svg", &in_format(&SIX_AT_360, "svg"));
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
    // The four slots of the textbook, with a crank of as many metres.
    let radius = right("pin.crank-radius") / 1000.0;
    let found = object(&["wheel", "--stations", "4", "--crank-radius", &radius.to_string()]);
    assert_eq!(number(&found, "crank_radius_mm"), right("pin.crank-radius"));
    assert!((number(&found, "wheel_radius_mm") / right("pin.crank-radius") - 1.0).abs() < 1e-15);
}

#[test]
fn the_sheet_says_what_the_object_says() {
    for stations in ["3", "6", "1000"] {
        let wheel = ["wheel", "--stations", stations, "--rpm", "7", "--crank-radius", "0.05"];
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
                line = lines.clone().next().unwrap_or_default();
            }
        }
    }
}

#[test]
fn keys_are_always_there_and_null_without_what_they_need() {
    let all = object(&["wheel", "--stations", "6", "--rpm", "360", "--crank-radius", "0.05"]);
    for (options, missing) in [
        (&[][..], [&OF_SPEED[..], &OF_SIZE].concat()),
        (&["--rpm", "360"], OF_SIZE.to_vec()),
        (&["--crank-radius", "0.05"], OF_SPEED.to_vec()),
        (&["--rpm", "360", "--crank-radius", "0.05"], Vec::new()),
    ] {
        let found = object(&[&["wheel", "--stations", "6"], options].concat());
        assert!(found.keys().eq(all.keys()), "{options:?}");
        for (key, value) in found {
            assert_eq!(value.is_null(), missing.contains(&&*key), "{key} with {options:?}");
            assert!(value.is_null() || value.is_number(), "{key} with {options:?}: {value}");
        }
    }
}

#[test]
fn the_drawing_is_that_of_the_figures_and_stands_alone() {
    for (stations, pins) in [("3", "1"), ("6", "1"), ("8", "2")] {
        let wheel = Wheel::with_pins(stations.parse().expect("whole"), pins.parse().expect("whole")).expect("possible");
        assert_is_drawn(&["wheel", "--stations", stations, "--pins", pins], &mechanism(&wheel));
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
        (&["--stations", "6", "--rpm", "0"], "'0' for '--rpm", "above zero"),
        (&["--stations", "6", "--rpm", "-360"], "'-360' for '--rpm", "above zero"),
        (&["--stations", "6", "--rpm", "nan"], "'nan' for '--rpm", "above zero"),
        (&["--stations", "6", "--rpm", "inf"], "'inf' for '--rpm", "above zero"),
        (&["--stations", "6", "--rpm", "1e200"], "'1e200' for '--rpm", "can have"),
        (&["--stations", "6", "--rpm", "fast"], "'fast'", "above zero"),
        (&["--stations", "6", "--crank-radius", "0"], "'0' for '--crank-radius", "above zero"),
        (&["--stations", "6", "--crank-radius", "-50"], "'-50' for '--crank-radius", "above zero"),
        (&["--stations", "6", "--crank-radius", "1e308"], "'1e308' for '--crank-radius", "can have"),
        (&["--stations", "6", "--crank-radius", "long"], "'long'", "above zero"),
    ] {
        // The drawing needs neither speed nor size, but a wrong one is a mistake there too.
        for format in ["text", "json", "svg"] {
            let said = refusal(geneva(&[&["wheel", "--format", format], options].concat()));
            assert!(said.starts_with("error: ") && said.contains("give "), "{options:?}: {said}");
            assert!(said.contains(value) && said.contains(allowed), "{options:?}: {said}");
        }
    }
    pin("wheel-with-too-many-pins", &["wheel", "--stations", "6", "--pins", "4"]);
    pin("wheel-without-stations", &["wheel", "--rpm", "360"]);
}
