//! Does `geneva pin` say what the kinematics say, and are the steps of both problems, on the page and here, chains whose numbers
//! agree?

use crate::{pin, stdout};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::{sliding_product, slot_radius_squared, velocity_ratio};
use geneva_live::LiveArguments;
use serde_json::Value;

#[test]
fn the_answers_are_those_of_the_closed_forms() {
    for (stations, angle, speed) in [("4", "-30", "10"), ("6", "12.5", "2"), ("3", "-29", "0.5"), ("12", "70", "4")] {
        let line = ["pin", "--crank-radius", "35", "--stations", stations, "--angle", angle, "--rad-s", speed];
        let answer: Value =
            serde_json::from_str(&stdout(&[&line[..], &["--format", "json"]].concat(), 0)).expect("JSON");
        let number = |text: &str| text.parse::<f64>().expect("a number");
        let ratio = 1.0 / (std::f64::consts::PI / number(stations)).sin();
        let crank = Turn::from_degrees(number(angle));
        let wheel = velocity_ratio(&ratio, &crank) * number(speed);
        let inwards =
            -sliding_product(&ratio, &crank) / slot_radius_squared(&ratio, &crank).sqrt() * 35.0 * number(speed);
        for (key, expected) in [("wheel_speed_rad_s", wheel), ("sliding_speed", inwards)] {
            let found = answer[key].as_f64().expect("a number");
            approx::assert_abs_diff_eq!(found, expected, epsilon = 1e-9 * expected.abs().max(1e-3));
        }
    }
}

#[test]
fn the_sheet_and_the_steps_are_pinned() {
    let line =
        ["pin", "--crank-radius", "2", "--centre-distance", "4", "--unit", "in", "--angle-from-extension", "160"];
    pin("pin-steps", &[&line[..], &["--rpm", "90", "--steps"]].concat());
    let lever =
        ["quick-return", "--ground", "300", "--crank", "100", "--unit", "mm", "--lever-angle", "15", "--rad-s", "6"];
    pin("quick-return-steps", &[&lever[..], &["--steps"]].concat());
}

#[test]
fn a_speed_in_radians_a_second_asks_the_same_of_a_wheel() {
    let of = |speed: [&str; 2]| stdout(&[&["wheel", "--stations", "6", "--format", "json"], &speed[..]].concat(), 0);
    let [turns, radians] = [["--rpm", "60"], ["--rad-s", "6.283185307179586"]].map(|speed| {
        let answer: Value = serde_json::from_str(&of(speed)).expect("JSON");
        answer["index_time_s"].as_f64().or(answer["indexing_time_s"].as_f64()).expect("a time")
    });
    approx::assert_relative_eq!(turns, radians, max_relative = 1e-14);
}

#[test]
fn what_is_impossible_is_refused_with_what_to_give() {
    let refused = |more: &[&str]| {
        let answer = crate::answered(&[&["pin", "--crank-radius", "40"], more].concat());
        assert_eq!(answer.code, 2, "{more:?}");
        answer.stderr
    };
    for (more, words) in [
        (&["--stations", "6", "--angle", "70", "--rpm", "9"][..], "outside of the slot the wheel stands still"),
        (&["--centre-distance", "30", "--angle", "0", "--rpm", "9"], "give more than --crank-radius 40"),
        (&["--stations", "6", "--angle", "0", "--rpm", "-9"], "--rpm -9: the driver must turn"),
        (&["--stations", "6", "--angle", "0", "--rpm", "9", "--steps", "--format", "json"], "--steps"),
        (&["--stations", "6", "--angle", "0"], "--rpm"),
        (&["--stations", "6", "--angle", "0", "--rpm", "9", "--unit", "mile"], "possible values"),
    ] {
        let said = refused(more);
        assert!(said.contains(words), "{more:?}: {said}");
    }
}

/// The lines of the steps that a command writes.
fn steps_of(line: &[&str]) -> Vec<String> {
    let page = stdout(&[line, &["--steps"]].concat(), 0);
    let (_, steps) = page.split_once("Steps\n").expect("steps");
    // A pipe is as wide as a terminal: a line that was folded goes on without a capital or a symbol at its start.
    steps.split("\n\n").flat_map(|step| step.lines()).map(str::to_owned).collect()
}

/// Settings of both problems, seeded: the query of the page, and the same line of the command.
fn settings() -> Vec<(&'static str, String, Vec<String>)> {
    let mut random = fastrand::Rng::with_seed(20_261_129);
    let mut all = Vec::new();
    for k in 0..120 {
        let (radius, slots) = (random.i32(5..400), random.i32(3..16));
        let half = 90.0 - 180.0 / f64::from(slots);
        let angle = (half * (2.0 * random.f64() - 1.0) * 10.0).round() / 10.0;
        let speed = f64::from(random.i32(1..300)) / 10.0;
        let (origin, option, shown) = if k % 2 == 0 {
            ("theta", "--angle", angle)
        } else {
            ("extension", "--angle-from-extension", 180.0 + angle)
        };
        let (per, rate) = if k % 3 == 0 { ("rpm", "--rpm") } else { ("speed", "--rad-s") };
        let query = format!("radius={radius}&stations={slots}&{origin}={shown}&{per}={speed}");
        let line = format!("pin --crank-radius {radius} --stations {slots} {option} {shown} {rate} {speed}");
        all.push(("pin", query, line.split(' ').map(str::to_owned).collect()));
    }
    for k in 0..120 {
        let (ground, radius) = (random.i32(50..500), random.i32(20..400));
        let speed = f64::from(random.i32(1..300)) / 10.0 * if k % 5 == 0 { -1.0 } else { 1.0 };
        let direction = f64::from(random.i32(-1790..1790)) / 10.0;
        let (per, rate) = if k % 3 == 0 { ("rpm", "--rpm") } else { ("speed", "--rad-s") };
        let query = format!("ground={ground}&radius={radius}&unit=0&direction={direction}&{per}={speed}");
        let line = format!(
            "quick-return --ground {ground} --crank {radius} --unit mm --crank-angle {direction} {rate} {speed}"
        );
        all.push(("polygon", query, line.split(' ').map(str::to_owned).collect()));
    }
    all
}

#[test]
fn the_page_and_the_command_write_the_same_steps() {
    let folded = |lines: &[String]| lines.concat().replace([' ', '\n'], "");
    for (name, query, line) in settings() {
        let live = geneva_live::by_name(name).expect("a figure");
        let Ok(reply) = live.answer(&LiveArguments::parse(&query).expect("a query")) else { continue };
        let line: Vec<&str> = line.iter().map(String::as_str).collect();
        let of_the_page = geneva_ask::worked::as_text(&reply.steps);
        let of_the_page: Vec<String> = of_the_page.lines().map(str::to_owned).collect();
        assert_eq!(folded(&of_the_page), folded(&steps_of(&line)), "{line:?}");
    }
}

#[test]
fn the_proofreader_finds_nothing_in_the_steps() {
    let mut checked = 0;
    for (name, query, _) in settings() {
        let live = geneva_live::by_name(name).expect("a figure");
        let Ok(reply) = live.answer(&LiveArguments::parse(&query).expect("a query")) else { continue };
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("steps.txt");
        // Each line a paragraph: a formula that goes on over several lines is not meant.
        let text: String = reply
            .steps
            .iter()
            .flat_map(|step| &step.lines)
            .fold(String::new(), |text, line| text + &geneva_ask::worked::plain(line) + "\n\n");
        std::fs::write(&path, &text).expect("a file");
        let answer = crate::answered(&["proofread", path.to_str().expect("a path")]);
        assert_eq!(answer.code, 0, "{name}?{query}\n{text}\n{}", answer.stdout);
        let counted = answer.stdout.split("Checked ").nth(1).and_then(|rest| rest.split(' ').next());
        checked += counted.and_then(|count| count.parse::<usize>().ok()).expect("a count");
    }
    // Nothing found means something only where much was checked.
    assert!(checked > 2000, "only {checked} chains");
    // And a wrong digit is found.
    let wrong = "γ = 90° − 42.37° − 30° = 17.83°\n";
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("steps.txt");
    std::fs::write(&path, wrong).expect("a file");
    assert_eq!(crate::answered(&["proofread", path.to_str().expect("a path")]).code, 1);
}
