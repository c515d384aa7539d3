//! Is the cycle that `geneva wheel` writes the motion of the library, at every angle and in every format?

use super::kinds;
use crate::{geneva, object, on_sheet, pin, stdout};
use geneva_kinematics::indexing::{Indexing, Phase};
use geneva_kinematics::wheel::Wheel;
use std::collections::BTreeSet;

/// The header, and the rows by it.
fn table(arguments: &[&str]) -> (Vec<String>, Vec<Vec<String>>) {
    let text = stdout(&[arguments, &["--format", "csv"]].concat(), 0);
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let header = lines.next().expect("a header");
    (header, lines.collect())
}

fn cell(header: &[String], row: &[String], key: &str) -> Option<f64> {
    let at = header.iter().position(|column| column == key).unwrap_or_else(|| panic!("no column {key}"));
    (!row[at].is_empty()).then(|| row[at].parse().expect("a number"))
}

#[test]
fn the_cycle_has_a_row_for_each_degree_and_is_that_of_the_library() {
    for (kind, wheel) in kinds(5) {
        let (header, rows) = table(&["wheel", "--stations", "5", "--type", kind]);
        assert_eq!(rows.len(), 361);
        for (row, degrees) in rows.iter().zip(-180..=180) {
            let degrees = f64::from(degrees);
            let motion = wheel.motion(0, degrees.to_radians()).expect("in the turn");
            let is_engaged = motion.phase == Phase::Advance;
            let pin = is_engaged.then(|| wheel.pin_in_slot(degrees.to_radians()).expect("engaged"));
            let angle = 72.0 * motion.stations as f64 + motion.angle.to_degrees();
            for (key, right) in [
                ("crank_angle_deg", Some(degrees)),
                ("wheel_angle_deg", Some(angle)),
                ("velocity_ratio", Some(motion.velocity)),
                ("acceleration_ratio", Some(motion.acceleration)),
                ("jerk_ratio", Some(motion.jerk)),
                ("pin_radius_ratio", pin.map(|pin| pin.radius)),
                ("sliding_ratio", pin.map(|pin| pin.sliding)),
                ("coriolis_ratio", pin.map(|pin| pin.coriolis)),
                ("time_s", None),
                ("wheel_torque_nm", None),
            ] {
                assert_eq!(cell(&header, row, key), right, "{kind} {key} at {degrees}");
            }
            assert_eq!(row.contains(&"index".to_owned()), is_engaged);
        }
    }
}

#[test]
fn an_instant_may_be_given_by_the_angle_of_the_wheel() {
    for kind in ["external", "internal", "spherical"] {
        let told =
            object(&["wheel", "--stations", "8", "--type", kind, "--at-wheel", "-9", "--at-wheel", "0", "--at", "7"]);
        let of = |row: usize, key: &str| told["at"][row][key].as_f64().expect("a number");
        approx::assert_relative_eq!(of(1, "wheel_angle_deg"), -9.0, max_relative = 1e-12);
        approx::assert_abs_diff_eq!(of(2, "crank_angle_deg"), 0.0, epsilon = 1e-12);
        // Asked the other way round, the wheel is where it was wanted.
        let crank = of(1, "crank_angle_deg").to_string();
        let back = object(&["wheel", "--stations", "8", "--type", kind, "--at", &crank]);
        approx::assert_relative_eq!(
            back["at"][0]["wheel_angle_deg"].as_f64().expect("a number"),
            -9.0,
            max_relative = 1e-12
        );
    }
}

#[test]
fn what_is_told_at_an_angle_is_the_same_in_every_format() {
    let wheel = ["wheel", "--stations", "6", "--rpm", "90", "--crank-radius", "40", "--total-inertia", "0.01"];
    let at = [&wheel[..], &["--at", "-12.5", "--at", "100", "--at", "725"]].concat();
    let (header, rows) = table(&at);
    let found = object(&at);
    let told = found["at"].as_array().expect("an array");
    assert_eq!((rows.len(), told.len()), (3, 3));
    for (row, told) in rows.iter().zip(told) {
        let keys: BTreeSet<_> = told.as_object().expect("an object").keys().collect();
        assert_eq!(keys, header.iter().collect());
        for key in header.iter().filter(|key| *key != "phase") {
            assert_eq!(told[key].as_f64(), cell(&header, row, key), "{key}");
        }
    }
    let speed = 3.0 * std::f64::consts::PI;
    let motion = Wheel::new(6).expect("possible").engaged((-12.5_f64).to_radians()).expect("engaged");
    for (key, right) in [
        ("wheel_speed_rad_s", motion.velocity * speed),
        ("wheel_acceleration_rad_s2", motion.acceleration * speed * speed),
        ("wheel_torque_nm", 0.01 * motion.acceleration * speed * speed),
        ("time_s", (-12.5_f64).to_radians() / speed),
    ] {
        approx::assert_relative_eq!(told[0][key].as_f64().expect(key), right, max_relative = 1e-14);
    }
    // In the dwell there is no pin in a slot; two turns on, the wheel is two stations on.
    assert!(told[1]["pin_radius_ratio"].is_null() && told[1]["pin_force_n"].is_null());
    assert_eq!(told[1]["velocity_ratio"], 0.0);
    let later = object(&["wheel", "--stations", "6", "--at", "5"])["at"][0]["wheel_angle_deg"].as_f64().expect("angle");
    approx::assert_relative_eq!(
        told[2]["wheel_angle_deg"].as_f64().expect("angle"),
        later + 120.0,
        max_relative = 1e-12
    );

    let sheet = stdout(&at, 0);
    let lines: Vec<_> = sheet.lines().skip_while(|line| !line.starts_with("At a crank angle")).collect();
    for (name, key) in [("velocity", "velocity_ratio"), ("pin force", "pin_force_n"), ("Coriolis", "coriolis_ratio")] {
        let line = lines.iter().find_map(|line| line.strip_prefix("  ")?.strip_prefix(name)).expect(name);
        approx::assert_relative_eq!(on_sheet(line), told[0][key].as_f64().expect(key), max_relative = 6e-4);
    }
    pin("wheel-at-angles", &at);
    pin("wheel-at-angles-csv", &[&at[..], &["--format", "csv"]].concat());
}

#[test]
fn with_several_pins_each_index_is_told() {
    let wheel = Wheel::with_pins(4, 3).expect("possible");
    let (header, rows) = table(&["wheel", "--stations", "4", "--pins", "3"]);
    let engaged = rows.iter().filter(|row| row.contains(&"index".to_owned())).count() as f64;
    assert!((engaged / 361.0 - Indexing::motion_fraction(&wheel)).abs() < 0.01, "{engaged}");
    let angles: Vec<_> = rows.iter().map(|row| cell(&header, row, "wheel_angle_deg").expect("an angle")).collect();
    assert!(angles.windows(2).all(|pair| pair[1] >= pair[0] - 1e-9));
    assert_eq!(angles[360] - angles[0], 270.0);
}

#[test]
fn a_zero_has_no_sign() {
    let spherical = ["wheel", "--stations", "8", "--type", "spherical", "--rpm", "477.7", "--format", "csv"];
    let still = ["wheel", "--stations", "6", "--at", "-0", "--rpm", "60", "--inertia", "0", "--format", "json"];
    let at_zero = ["wheel", "--stations", "6", "--at", "−0.0", "--format", "text"];
    for told in [&spherical[..], &still, &at_zero].map(|line| stdout(line, 0)) {
        let mut words = told.split([',', ' ', '\n', ':']);
        let is_signed = |word: &&str| word.starts_with(['-', '−']) && !word.contains(|sign| matches!(sign, '1'..='9'));
        assert_eq!(words.find(|word| word.contains('0') && is_signed(word)), None, "{told}");
    }
}

#[test]
fn no_number_of_a_cycle_is_beyond_computing() {
    let huge = ["wheel", "--stations", "3", "--rpm", "1e30", "--inertia", "1e30", "--crank-radius", "1e-30"];
    for format in ["text", "json", "csv"] {
        let output = geneva(&[&huge[..], &["--format", format]].concat()).output().expect("the program runs");
        let text = String::from_utf8(output.stdout).expect("UTF-8") + &String::from_utf8(output.stderr).expect("UTF-8");
        assert!(!text.contains("inf") || text.contains("finite"), "{text}");
        assert!(!text.contains("NaN"), "{text}");
    }
}

#[test]
fn whole_turns_of_the_crank_move_the_wheel_on_and_change_nothing_else() {
    for kind in ["external", "internal", "spherical"] {
        let of = |degrees: f64| {
            let line = ["wheel", "--stations", "6", "--type", kind, "--rpm", "90", "--inertia", "0.01"];
            let mut found = object(&[&line[..], &["--at", &degrees.to_string()]].concat());
            let at = found["at"][0].take();
            at.as_object().expect("an object").clone()
        };
        for degrees in [-170.0, -91.25, -29.5, -12.5, 0.0, 7.0, 30.25, 59.0, 100.0, 179.0] {
            let first = of(degrees);
            for turns in [-3.0, -1.0, 1.0, 2.0, 40.0] {
                let later = of(degrees + 360.0 * turns);
                assert_eq!(first.keys().collect::<Vec<_>>(), later.keys().collect::<Vec<_>>());
                for (key, value) in &first {
                    let Some(value) = value.as_f64() else {
                        assert_eq!(&later[key], value, "{kind} {degrees}° {key}");
                        continue;
                    };
                    // A wheel of six stations goes on by one of them in each turn; a turn takes two thirds of a second.
                    let step = match key.as_str() {
                        "crank_angle_deg" => 360.0,
                        "wheel_angle_deg" => 60.0,
                        "time_s" => 2.0 / 3.0,
                        _ => 0.0,
                    };
                    let found = later[key].as_f64().unwrap_or_else(|| panic!("{kind} {degrees}° {key}"));
                    approx::assert_abs_diff_eq!(
                        found,
                        value + turns * step,
                        epsilon = 1e-9 * (1.0 + value.abs() + (turns * step).abs())
                    );
                }
            }
        }
    }
}
