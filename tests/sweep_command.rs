//! Does `geneva sweep` write what the dynamics say, in the same order whatever computes it?

mod destination;
mod refusals;

use crate::{geneva, pin, run, stdout};
use geneva_dynamics::existence::critical_friction;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use serde_json::{Map, Value};
use std::fs;

const SMALL: [&str; 7] = ["sweep", "--slots", "4,6", "--friction", "0:0.6:4", "--inertia-ratio", "0.1:1:2:log"];

/// The rows of a sweep to standard output.
#[track_caller]
fn rows(options: &[&str]) -> Vec<Map<String, Value>> {
    parsed(&stdout(&[options, &["--output", "-"]].concat(), 0))
}

fn parsed(text: &str) -> Vec<Map<String, Value>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let value = |cell: &str| cell.parse::<f64>().map_or(Value::from(cell), Value::from);
    let row = |row: csv::StringRecord| header.iter().map(str::to_owned).zip(row.iter().map(value)).collect();
    reader.records().map(|cells| row(cells.expect("as many cells as columns"))).collect()
}

#[test]
fn a_sweep_has_a_row_for_each_escapement() {
    pin("sweep", &[&SMALL[..], &["--output", "-"]].concat());
    let found = rows(&[&SMALL[..], &["--torque", "1:9:3"]].concat());
    let mut at = found.iter();
    for slots in [4.0, 6.0] {
        for friction in [0.0, 0.2, 0.4, 0.6] {
            for ratio in [0.1, 1.0] {
                for torque in [1.0, 5.0, 9.0] {
                    let row = at.next().expect("a row");
                    let inputs = ["slots", "friction", "inertia_ratio", "torque"].map(|key| row[key].as_f64());
                    assert_eq!(inputs, [slots, friction, ratio, torque].map(Some));
                }
            }
        }
    }
    assert!(at.next().is_none());
}

#[test]
fn numbers_are_those_of_the_dynamics_with_all_their_digits() {
    for (modulus, more) in [(None, &[][..]), (Some(90_f64), &["--modulus-deg", "90"])] {
        let options = ["sweep", "--slots", "3,4,6", "--friction", "0.05:0.8:6", "--inertia-ratio", "0.03:2:4:log"];
        let units = ["--torque", "2:7:2", "--follower-inertia", "6e-5"];
        let found = rows(&[&options[..], &units, more].concat());
        assert_eq!(found.len(), 3 * 6 * 4 * 2);
        let mut jams = 0;
        for row in &found {
            let number = |key: &str| row[key].as_f64().expect("a number");
            let mechanism = Mechanism::new(number("slots") as u32).expect("possible");
            let follower = number("follower_inertia");
            let inertias = Inertias::new(number("inertia_ratio") * follower, follower).expect("possible");
            let limit = critical_friction(mechanism, inertias.ratio()).expect("possible").friction;
            assert_eq!(number("pins"), f64::from(mechanism.pins()));
            if number("friction") >= limit {
                jams += 1;
                assert_eq!(row["status"], "jams");
                assert!(row.values().filter(|value| **value == "").count() == 8, "{row:?}");
                continue;
            }
            let parameters = Parameters::new(mechanism, inertias, number("torque"), number("friction")).expect("sound");
            let engagement = match modulus.filter(|modulus| *modulus != 360.0 / number("pins")) {
                None => Engagement::new(&parameters),
                Some(modulus) => Engagement::folded(&parameters, modulus.to_radians(), 1e-12),
            };
            let engagement = engagement.expect("an engagement");
            let steady = engagement.steady_state().expect("a steady state");
            let (_, rise) = engagement.engagements_to_settle(0.01).expect("a rise");
            assert_eq!(row["status"], "ok");
            for (key, value) in [
                ("entry_speed", steady.entry_speed),
                ("peak_speed", steady.peak.speed),
                ("minimum_speed", steady.minimum.speed),
                ("mean_speed", steady.mean_speed),
                ("period", steady.period),
                ("contraction", steady.contraction),
                ("rise_time", rise),
            ] {
                assert_eq!(number(key).to_bits(), value.to_bits(), "{row:?}: {key}");
            }
            assert_eq!(row["switch_angle_deg"].as_f64(), steady.switch_angle.map(f64::to_degrees));
        }
        assert!(jams > 0 && jams < found.len());
    }
}

#[test]
fn a_row_is_what_the_escapement_command_says() {
    let row = &rows(&["sweep", "--slots", "4", "--friction", "0.3", "--inertia-ratio", "0.25", "--torque", "2"])[0];
    let options = ["escapement", "--slots", "4", "--friction", "0.3", "--torque", "2", "--format", "json"];
    let text = stdout(&[&options[..], &["--driver-inertia", "0.25", "--follower-inertia", "1"]].concat(), 0);
    let object: Map<String, Value> = serde_json::from_str(&text).expect("an object");
    for key in ["entry_speed", "peak_speed", "minimum_speed", "mean_speed", "period", "contraction", "rise_time"] {
        assert_eq!(row[key].as_f64(), object[key].as_f64(), "{key}");
    }
    assert_eq!(row["switch_angle_deg"].as_f64(), object["switch_angles_deg"][1].as_f64());
}

#[test]
fn the_bytes_do_not_depend_on_the_threads() {
    // Some blocks of rows, the last of which is not full.
    let options = ["sweep", "--slots", "3,4,6", "--friction", "0:0.9:13", "--inertia-ratio", "0.05:1:11:log"];
    let of = |threads: &[&str], variable: &str| {
        let mut command = geneva(&[&options[..], threads, &["--output", "-"]].concat());
        let output = command.env("RAYON_NUM_THREADS", variable).output().expect("the program runs");
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        output.stdout
    };
    let one = of(&["--threads", "1"], "");
    assert_eq!(String::from_utf8_lossy(&one).lines().count(), 1 + 3 * 13 * 11);
    for threads in ["2", "4", "7"] {
        assert!(of(&["--threads", threads], "") == one, "{threads} threads");
    }
    assert!(of(&[], "3") == one, "three threads by the variable");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("sweep.csv");
    let said = stdout(&[&options[..], &["--output", &file.to_string_lossy()]].concat(), 0);
    assert!(fs::read(&file).expect("it is there") == one, "in a file");
    assert!(said.contains("429 rows") && said.contains(" ok") && said.contains(" jams"), "{said}");
}

#[test]
fn what_there_is_no_number_for_is_empty_and_the_status_says_why() {
    let steady = ["entry_speed", "peak_speed", "minimum_speed", "mean_speed", "period", "contraction"];
    for (friction, ratio, status, is_steady) in [
        ("0.3", "1", "ok", true),
        ("30", "1", "jams", false),
        ("0", "1", "no-terminal-speed", false),
        ("0.1", "1e-30", "jams", false),
        ("0", "1e-30", "too-sharp", false),
        ("1e-8", "1", "long-rise", true),
    ] {
        let row = &rows(&["sweep", "--slots", "6", "--friction", friction, "--inertia-ratio", ratio])[0];
        assert_eq!(row["status"], status, "{friction} {ratio}");
        assert!(steady.iter().all(|key| row[*key].is_f64() == is_steady), "{row:?}");
        assert_eq!(row["rise_time"].is_f64(), status == "ok", "{row:?}");
        assert!(stdout(&["sweep", "--help"], 0).contains(status));
    }
}

#[test]
fn four_times_the_torque_doubles_speeds_and_halves_times() {
    let options = ["sweep", "--slots", "3,4,6", "--friction", "0.1:0.3:3", "--inertia-ratio", "0.2"];
    let found = rows(&[&options[..], &["--torque", "1:4:2"]].concat());
    for pair in found.chunks(2) {
        for (key, factor) in [("entry_speed", 2.0), ("peak_speed", 2.0), ("period", 0.5), ("rise_time", 0.5)] {
            let [weak, strong] = [0, 1].map(|at| pair[at][key].as_f64().expect("a number"));
            assert!((strong / weak / factor - 1.0).abs() < 1e-12, "{key}: {weak} {strong}");
        }
    }
}

#[test]
fn nothing_but_rows_goes_into_a_pipe() {
    let output = run(&[&SMALL[..], &["--output", "-"]].concat());
    assert!(output.stderr.is_empty() && !output.stdout.contains(&0x1b), "{output:?}");
    assert!(output.stdout.starts_with(b"slots,pins,friction,"));
}
