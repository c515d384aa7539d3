//! Does `geneva quick-return` say what the kinematics say, and does it refuse what they refuse?

mod refusals;

use crate::{pin, stdout};
use geneva_figures::quick_return::{acceleration_diagram, mechanism, velocity_diagram};
use geneva_kinematics::Turn;
use geneva_kinematics::quick_return::{Branch, Drive, Motion, Position, QuickReturn};
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
    let text = stdout(&command(instant, &[&["--format", "json"], more].concat()), 0);
    serde_json::from_str(&text).expect("an object")
}

/// The same by the library alone.
fn computed([ground, crank, angle, degrees, rpm]: Instant, branch: Branch) -> (QuickReturn, Position, Drive<f64>) {
    let [ground, crank, degrees, rpm] = [ground, crank, degrees, rpm].map(|text| text.parse().expect("a number"));
    let linkage = QuickReturn::new(ground, crank).expect("possible");
    let position = match angle {
        "--lever-angle" => linkage.at_lever_degrees(degrees, branch),
        _ => linkage.at_crank_degrees(degrees),
    };
    (linkage, position.expect("possible"), Drive::steady(rpm * PI / 30.0))
}

#[track_caller]
fn number(object: &Map<String, Value>, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("{key} is {}", object[key]))
}

#[track_caller]
fn components(object: &Map<String, Value>, key: &str) -> [f64; 2] {
    ["x", "y"].map(|axis| object[key][axis].as_f64().unwrap_or_else(|| panic!("{key} is {}", object[key])))
}

#[test]
fn a_mechanism_is_written_in_each_format() {
    pin("quick-return", &command(SLOW, &[]));
    pin("quick-return-json", &command(SLOW, &["--format", "json"]));
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
fn numbers_are_those_of_the_kinematics_with_all_their_digits() {
    for (instant, branch, more) in INSTANTS.map(|instant| (instant, Branch::Far, &[][..])).into_iter().chain([(
        ["0.3", "0.1", "--lever-angle", "10", "60"],
        Branch::Near,
        &["--branch", "near"][..],
    )]) {
        let found = object(instant, more);
        let (linkage, position, drive) = computed(instant, branch);
        let (ground, crank) = (linkage.ground(), linkage.crank());
        let motion = Motion::at(&ground, &crank, &position.crank, &drive).expect("off the pivot");
        let strokes = linkage.strokes();
        for (key, value) in [
            ("ground_m", ground),
            ("crank_m", crank),
            ("crank_speed_rad_s", drive.speed),
            ("crank_angle_deg", position.crank.degrees()),
            ("lever_angle_deg", position.lever.degrees()),
            ("angle_at_pin_deg", position.angle_at_pin().to_degrees()),
            ("pin_distance_m", position.pin_distance),
            ("lever_speed_rad_s", motion.velocities.follower_speed),
            ("lever_acceleration_rad_s2", motion.accelerations.follower_acceleration),
            ("slow_stroke_deg", strokes.slow.to_degrees()),
            ("fast_stroke_deg", strokes.fast.to_degrees()),
        ] {
            // Zero is written without a sign.
            assert_eq!(number(&found, key).to_bits(), (value + 0.0).to_bits(), "{instant:?}: {key}");
        }
        assert_eq!(found["rpm"].as_f64(), instant[4].parse().ok());
        assert_eq!(found["swing_limit_deg"].as_f64(), strokes.swing_limit.map(f64::to_degrees), "{instant:?}");
        assert_eq!(found["time_ratio"].as_f64(), Some(strokes.time_ratio()).filter(|ratio| ratio.is_finite()));
        let (velocities, terms) = (&motion.velocities, &motion.accelerations);
        let vectors = [
            &velocities.pin_velocity,
            &velocities.slot_point_velocity,
            &velocities.sliding_velocity,
            &motion.pin_normal,
            &motion.pin_tangential,
            &terms.follower_normal,
            &terms.follower_tangential,
            &terms.sliding_normal,
            &terms.sliding_tangential,
            &terms.coriolis,
        ];
        for (key, vector) in VELOCITIES.iter().chain(&ACCELERATIONS).zip(vectors) {
            let (x, y) = (vector.x + 0.0, vector.y + 0.0);
            assert_eq!(components(&found, key).map(f64::to_bits), [x, y].map(f64::to_bits), "{instant:?}: {key}");
            assert_eq!(found[*key]["magnitude"].as_f64(), Some((x * x + y * y).sqrt()), "{instant:?}: {key}");
            if let Some(direction) = found[*key]["direction_deg"].as_f64() {
                assert_eq!(direction, Turn { cos: x, sin: y }.degrees(), "{instant:?}: {key}");
            }
        }
    }
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
            let said: f64 = line.split_whitespace().next().and_then(|number| number.parse().ok()).expect("a number");
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
        let (linkage, position, drive) = computed(instant, Branch::Far);
        for (options, figure) in [
            (&[][..], mechanism(&linkage, &position, &drive, "m")),
            (&["--figure", "mechanism"], mechanism(&linkage, &position, &drive, "m")),
            (&["--figure", "velocity"], velocity_diagram(&linkage, &position, &drive, "m")),
            (&["--figure", "acceleration"], acceleration_diagram(&linkage, &position, &drive, "m")),
        ] {
            let svg = stdout(&command(instant, &[&["--format", "svg"], options].concat()), 0);
            assert!(!svg.contains("var("), "a colour that only a browser understands");
            let (drawn, expected) = (roxmltree::Document::parse(&svg), roxmltree::Document::parse(&figure.svg));
            let (drawn, expected) = (drawn.expect("XML"), expected.expect("XML"));
            assert!(drawn.root_element().has_tag_name(("http://www.w3.org/2000/svg", "svg")));
            let paths = |document: &roxmltree::Document| -> Vec<String> {
                document.descendants().filter_map(|node| node.attribute("d")).map(str::to_owned).collect()
            };
            assert_eq!(paths(&drawn), paths(&expected), "{instant:?}: {}", figure.id);
        }
    }
}

#[test]
fn every_shell_completes_its_options() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = stdout(&["completions", shell], 0);
        for word in ["quick-return", "lever-angle", "branch", "acceleration"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}
