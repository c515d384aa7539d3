//! Does `geneva quick-return` say what the kinematics say, and does it refuse what they refuse?

mod refusals;

use crate::{assert_is_drawn, number, on_sheet, pin, right, stdout};
use geneva_figures::quick_return::{acceleration_diagram, mechanism, velocity_diagram};
use geneva_kinematics::quick_return::{Branch, Drive, QuickReturn};
use serde_json::{Map, Value};
use std::f64::consts::PI;

const VELOCITIES: [&str; 3] = ["pin_velocity_m_s", "lever_point_velocity_m_s", "sliding_velocity_m_s"];
const ACCELERATIONS: [&str; 7] = [
    "pin_normal_acceleration_m_s2",
    "pin_tangential_acceleration_m_s2",
    "lever_point_normal_acceleration_m_s2",
    "lever_point_tangential_acceleration_m_s2",
    "sliding_normal_acceleration_m_s2",
    "sliding_tangential_acceleration_m_s2",
    "coriolis_acceleration_m_s2",
];

/// The options of a mechanism at an instant: ground, crank, what drives it and by how much, turns a minute.
type Instant<'a> = [&'a str; 5];

const SLOW: Instant = ["0.3", "0.1", "--crank-angle", "75", "60"];

/// Instants of levers that swing, that turn and that do neither; on both branches, both ways, and special ones.
const INSTANTS: [Instant; 14] = [
    SLOW,
    ["0.3", "0.1", "--crank-angle", "-130", "60"],
    ["0.3", "0.1", "--lever-angle", "10", "60"],
    ["0.3", "0.1", "--lever-angle", "-7.5", "-33"],
    ["2", "1.9", "--crank-angle", "170", "-600"],
    ["40", "0.1", "--crank-angle", "1000", "7"],
    ["0.1", "0.3", "--crank-angle", "75", "60"],
    ["0.1", "0.3", "--lever-angle", "150", "-1e3"],
    ["0.3", "0.3", "--crank-angle", "120", "60"],
    ["0.3", "0.1", "--crank-angle", "0", "60"],
    ["0.3", "0.1", "--crank-angle", "180", "60"],
    ["0.2", "0.1", "--lever-angle", "30", "60"],
    ["0.1", "0.3", "--lever-angle", "90", "60"],
    ["3e20", "1e20", "--crank-angle", "75", "1e-20"],
];

fn command<'a>([ground, crank, angle, degrees, rpm]: Instant<'a>, more: &[&'a str]) -> Vec<&'a str> {
    let options = ["quick-return", "--ground", ground, "--crank", crank, angle, degrees, "--rpm", rpm];
    [&options, more].concat()
}

/// The object that the program writes for an instant.
#[track_caller]
fn object(instant: Instant, more: &[&str]) -> Map<String, Value> {
    crate::object(&command(instant, more))
}

#[track_caller]
fn components(object: &Map<String, Value>, key: &str) -> [f64; 2] {
    ["x", "y"].map(|axis| object[key][axis].as_f64().unwrap_or_else(|| panic!("{key} is {}", object[key])))
}

#[test]
fn a_mechanism_is_written_in_each_format() {
    pin("quick-return", &command(SLOW, &[]));
    pin("quick-return-json", &command(SLOW, &["--format", "json"]));
    pin("quick-return-fields", &command(SLOW, &["--format", "fields"]));
    pin("quick-return-near", &command(["0.3", "0.1", "--lever-angle", "-10", "-60"], &["--branch", "near"]));
    pin("quick-return-at-the-end", &command(["0.2", "0.1", "--lever-angle", "30", "60"], &[]));
    pin("quick-return-on-the-line", &command(["0.3", "0.1", "--crank-angle", "180", "60"], &[]));
    pin("quick-return-turning", &command(["0.1", "0.3", "--lever-angle", "150", "60"], &[]));
    pin("quick-return-at-half-speed", &command(["0.3", "0.3", "--crank-angle", "120", "60"], &[]));
    pin(
        "quick-return-at-half-speed-json",
        &command(["0.3", "0.3", "--crank-angle", "120", "60"], &["--format", "json"]),
    );
}

#[test]
fn numbers_are_those_that_the_ledger_finds_right_in_the_examination_problem() {
    let [ground, crank, lever] = ["ground", "crank", "lever-angle"].map(claim_printed);
    let rpm = claim_printed("driver-speed");
    let found = object([ground, crank, "--lever-angle", lever, rpm], &[]);
    for (key, claim) in [
        ("crank_speed_rad_s", "driver-rate"),
        ("crank_angle_deg", "crank-angle"),
        ("lever_angle_deg", "lever-angle"),
        ("angle_at_pin_deg", "angle-at-pin"),
        ("pin_distance_m", "lever-length"),
        ("pin_velocity_m_s", "pin-speed"),
        ("lever_point_velocity_m_s", "lever-point-speed"),
        ("sliding_velocity_m_s", "sliding-speed"),
        ("lever_speed_rad_s", "lever-speed"),
        ("pin_normal_acceleration_m_s2", "pin-normal"),
        ("lever_point_normal_acceleration_m_s2", "lever-normal"),
        ("lever_point_tangential_acceleration_m_s2", "lever-tangential"),
        ("sliding_tangential_acceleration_m_s2", "sliding-acceleration"),
        ("coriolis_acceleration_m_s2", "coriolis"),
        ("lever_acceleration_rad_s2", "lever-acceleration"),
    ] {
        let said =
            found[key].as_object().map_or_else(|| number(&found, key).abs(), |vector| number(vector, "magnitude"));
        let right = right(&format!("quick-return.{claim}"));
        assert!((said / right - 1.0).abs() < 1e-12, "{key}: {said}, {claim}: {right}");
    }
}

/// A datum of the problem, as it is printed.
fn claim_printed(name: &str) -> &'static str {
    let id = format!("quick-return.{name}");
    geneva_documents::LEDGER.claims().iter().find(|claim| claim.id == id).expect("a claim of that id").printed
}

#[test]
fn the_vectors_of_an_instant_add_up() {
    for instant in INSTANTS {
        let found = object(instant, &[]);
        let [pin, lever, sliding] = VELOCITIES.map(|key| components(&found, key));
        let [normal, tangential, rest @ ..] = ACCELERATIONS.map(|key| components(&found, key));
        for axis in [0, 1] {
            let gap = pin[axis] - lever[axis] - sliding[axis];
            assert!(gap.abs() <= 1e-12 * pin[0].hypot(pin[1]), "{instant:?}: {gap}");
            let gap = normal[axis] + tangential[axis] - rest.iter().map(|term| term[axis]).sum::<f64>();
            assert!(gap.abs() <= 1e-12 * normal[0].hypot(normal[1]), "{instant:?}: {gap}");
        }
    }
}

#[test]
fn a_crank_the_other_way_turns_velocities_around_and_leaves_accelerations() {
    for [ground, crank, angle, degrees, rpm] in INSTANTS {
        let reversed = if let Some(rpm) = rpm.strip_prefix('-') { rpm.to_owned() } else { format!("-{rpm}") };
        let (one, other) = (
            object([ground, crank, angle, degrees, rpm], &[]),
            object([ground, crank, angle, degrees, &reversed], &[]),
        );
        for key in VELOCITIES {
            assert_eq!(components(&one, key), components(&other, key).map(|velocity| -velocity), "{key}");
        }
        for key in ACCELERATIONS {
            assert_eq!(one[key], other[key], "{key}");
        }
        assert_eq!(one["stroke"], other["stroke"]);
    }
}

#[test]
fn a_vector_has_no_direction_where_it_is_zero_for_a_reason() {
    let always = ["pin_tangential_acceleration_m_s2", "sliding_normal_acceleration_m_s2"];
    let on_the_line =
        ["sliding_velocity_m_s", "lever_point_tangential_acceleration_m_s2", "coriolis_acceleration_m_s2"];
    let at_the_end = [
        "lever_point_velocity_m_s",
        "lever_point_normal_acceleration_m_s2",
        "sliding_tangential_acceleration_m_s2",
        "coriolis_acceleration_m_s2",
    ];
    for (instant, zero) in [
        (SLOW, &[][..]),
        (["0.3", "0.1", "--crank-angle", "0", "60"], &on_the_line),
        (["0.3", "0.1", "--crank-angle", "-180", "60"], &on_the_line),
        (["0.1", "0.3", "--lever-angle", "180", "60"], &on_the_line),
        (["0.2", "0.1", "--lever-angle", "-30", "60"], &at_the_end),
        (["0.2", "0.1", "--crank-angle", "120", "60"], &at_the_end),
        (["0.1", "0.3", "--lever-angle", "-90", "60"], &["sliding_tangential_acceleration_m_s2"]),
        (["0.3", "0.3", "--crank-angle", "120", "60"], &["lever_point_tangential_acceleration_m_s2"]),
    ] {
        let found = object(instant, &[]);
        for key in VELOCITIES.iter().chain(&ACCELERATIONS) {
            let expected = always.contains(key) || zero.contains(key);
            assert_eq!(found[*key]["direction_deg"].is_null(), expected, "{instant:?}: {key}");
        }
    }
}

#[test]
fn the_sheet_says_what_the_object_says() {
    for instant in INSTANTS {
        let (sheet, found) = (stdout(&command(instant, &[]), 0), object(instant, &[]));
        let sheet = sheet.replace('−', "-");
        let mut lines = sheet.lines();
        for (name, key) in [
            ("crank angle", "crank_angle_deg"),
            ("lever angle", "lever_angle_deg"),
            ("angle at the pin", "angle_at_pin_deg"),
            ("pin distance", "pin_distance_m"),
            ("pin", VELOCITIES[0]),
            ("lever's point", VELOCITIES[1]),
            ("sliding", VELOCITIES[2]),
            ("lever, angular", "lever_speed_rad_s"),
            ("pin, normal", ACCELERATIONS[0]),
            ("pin, tangential", ACCELERATIONS[1]),
            ("lever, normal", ACCELERATIONS[2]),
            ("lever, tangential", ACCELERATIONS[3]),
            ("sliding, normal", ACCELERATIONS[4]),
            ("sliding, tangential", ACCELERATIONS[5]),
            ("Coriolis", ACCELERATIONS[6]),
            ("lever, angular", "lever_acceleration_rad_s2"),
        ] {
            let line = lines.find_map(|line| line.strip_prefix("  ")?.strip_prefix(name)?.strip_prefix("  "));
            let line = line.unwrap_or_else(|| panic!("{instant:?}: no line for {name}"));
            let said = on_sheet(line);
            let (value, scale) = match &found[key] {
                Value::Object(vector) => {
                    let towards = line.split_once("at ").and_then(|(_, rest)| rest.split_once('°')).map(|(at, _)| at);
                    let towards = towards.map(|at| at.trim().parse::<f64>().expect("a direction"));
                    let expected = vector["direction_deg"].as_f64();
                    assert_eq!(towards.is_some(), expected.is_some(), "{instant:?}: {line}");
                    let apart = (towards.unwrap_or_default() - expected.unwrap_or_default()).abs();
                    assert!(apart < 0.01 || (apart - 360.0).abs() < 0.01, "{instant:?}: {line}");
                    assert_eq!(said == 0.0, expected.is_none() && line.contains("zero: "), "{instant:?}: {line}");
                    let scale = if key.ends_with("s2") { ACCELERATIONS[0] } else { VELOCITIES[0] };
                    (number(vector, "magnitude"), found[scale]["magnitude"].as_f64().unwrap_or_default())
                }
                value if name.ends_with("angular") => {
                    let speed = number(&found, "crank_speed_rad_s").abs();
                    (value.as_f64().expect("a number").abs(), if key.ends_with("s2") { speed * speed } else { speed })
                }
                value => (value.as_f64().expect("a number"), 1.0),
            };
            // To the digits shown, and zero where the lever is at rest as near as its angle can be typed.
            assert!((said - value).abs() <= 6e-4 * value.abs() + 1e-7 * scale, "{instant:?}: {line}: {value}");
        }
    }
}

#[test]
fn one_lever_angle_has_a_crank_on_each_branch() {
    let instant = ["0.3", "0.1", "--lever-angle", "10", "60"];
    let (far, near) = (object(instant, &["--branch", "far"]), object(instant, &["--branch", "near"]));
    assert_eq!(object(instant, &[]), far, "the far branch is the default");
    assert_eq!((&far["branch"], &far["stroke"]), (&"far".into(), &"slow".into()));
    assert_eq!((&near["branch"], &near["stroke"]), (&"near".into(), &"fast".into()));
    assert_eq!(far["lever_angle_deg"], near["lever_angle_deg"]);
    assert!(number(&near, "crank_angle_deg") > number(&far, "crank_angle_deg") + 90.0);
    // The power of the lever's pivot with respect to the crank's circle.
    let product = number(&far, "pin_distance_m") * number(&near, "pin_distance_m");
    assert!((product - (0.3 * 0.3 - 0.1 * 0.1)).abs() < 1e-15, "{product}");
    assert!(number(&far, "lever_speed_rad_s") > 0.0 && number(&near, "lever_speed_rad_s") < 0.0);
}

#[test]
fn the_drawings_are_those_of_the_figures_and_stand_alone() {
    for instant in INSTANTS {
        let [ground, crank, angle, degrees, rpm] = instant;
        let [ground, crank, degrees, rpm] = [ground, crank, degrees, rpm].map(|text| text.parse().expect("a number"));
        let linkage = QuickReturn::new(ground, crank).expect("possible");
        let position = match angle {
            "--lever-angle" => linkage.at_lever_degrees(degrees, Branch::Far),
            _ => linkage.at_crank_degrees(degrees),
        };
        let (position, drive) = (position.expect("possible"), Drive::steady(rpm * PI / 30.0));
        for (options, draw) in [
            (&[][..], mechanism as fn(&_, &_, &_, &_) -> _),
            (&["--figure", "mechanism"], mechanism),
            (&["--figure", "velocity"], velocity_diagram),
            (&["--figure", "acceleration"], acceleration_diagram),
        ] {
            assert_is_drawn(&command(instant, options), &draw(&linkage, &position, &drive, "m"));
        }
    }
}

#[test]
fn an_angle_and_the_angle_with_whole_turns_give_the_same_answer() {
    let of = |ground: &str, crank: &str, option: &str, degrees: f64| {
        let degrees = degrees.to_string();
        let sheet = stdout(&command([ground, crank, option, &degrees, "60"], &[]), 0);
        (sheet, object([ground, crank, option, &degrees, "60"], &[]))
    };
    for (ground, crank) in [("0.3", "0.1"), ("0.1", "0.3")] {
        let turns = crank == "0.3";
        let of_crank = (-175..=180).step_by(35).map(|degrees| ("--crank-angle", degrees));
        // A lever that swings reaches less than 20° to either side.
        let of_lever = if turns { -175..=180 } else { -18..=18 };
        let of_lever = of_lever.step_by(if turns { 35 } else { 9 }).map(|degrees| ("--lever-angle", degrees));
        for (option, degrees) in of_crank.chain(of_lever) {
            // A little aside, so that no rounding of the last bit shows in the digits of the sheet.
            let degrees = f64::from(degrees) + 0.13;
            let (sheet, first) = of(ground, crank, option, degrees);
            for whole in [-720.0, -360.0, 360.0, 1080.0] {
                let (later_sheet, later) = of(ground, crank, option, degrees + whole);
                assert_eq!(sheet, later_sheet, "{option} {degrees}° and {whole}° more");
                for (key, value) in first.iter().filter_map(|(key, value)| Some((key, value.as_f64()?))) {
                    approx::assert_abs_diff_eq!(number(&later, key), value, epsilon = 1e-9 * (1.0 + value.abs()));
                }
            }
        }
    }
}
