//! Does `geneva sweep` write what the dynamics say, always in the same order?

mod destination;
mod refusals;

use crate::{geneva, object, pin, refused, run, stdout, written};
use serde_json::{Map, Value};
use std::fs;

const SMALL: [&str; 7] = ["sweep", "--slots", "4,6", "--friction", "0:0.6:4", "--inertia-ratio", "0.1:1:2:log"];

/// The rows of a sweep to standard output.
#[track_caller]
fn rows(options: &[&str]) -> Vec<Map<String, Value>> {
    parsed(&written(&[options, &["--output", "-"]].concat(), 0))
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
fn a_row_is_what_the_escapement_command_says() {
    for reset_angle in [&[][..], &["--reset-deg", "100"]] {
        let options = ["sweep", "--slots", "3,4,6", "--friction", "0.05:0.8:3", "--inertia-ratio", "0.05:2:2:log"];
        let units = ["--torque", "2", "--follower-inertia", "6e-5"];
        let mut jams = 0;
        for row in rows(&[&options[..], &units, reset_angle].concat()) {
            let [slots, friction, ratio] =
                ["slots", "friction", "inertia_ratio"].map(|key| row[key].as_f64().expect("a number"));
            let design = [slots.to_string(), friction.to_string(), (ratio * 6e-5).to_string()];
            let [slots, friction, driver] = design.each_ref().map(String::as_str);
            let inertias = ["--driver-inertia", driver, "--follower-inertia", "6e-5"];
            let command = ["escapement", "--slots", slots, "--friction", friction, "--torque", "2"];
            let command = [&command[..], &inertias, reset_angle].concat();
            if row["status"] == "may-jam" {
                jams += 1;
                assert!(refused(&command).contains("may jam"), "{row:?}");
                assert!(row.values().filter(|value| **value == "").count() == 8, "{row:?}");
                continue;
            }
            let object = object(&command);
            for key in ["pins", "entry_speed", "peak_speed", "minimum_speed", "mean_speed", "period", "multiplier"] {
                assert_eq!(row[key].as_f64(), object[key].as_f64(), "{row:?}: {key}");
            }
            assert_eq!(
                (&row["status"], row["entry_speed_rise_time"].as_f64()),
                (&"ok".into(), object["entry_speed_rise_time"].as_f64())
            );
            assert_eq!(row["switch_angle_deg"].as_f64(), object["switch_angles_deg"][1].as_f64(), "{row:?}");
        }
        assert!(jams > 0 && jams < 18);
    }
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
    assert!(said.contains("429 rows") && said.contains(" ok") && said.contains(" may-jam"), "{said}");
}

#[test]
fn what_there_is_no_number_for_is_empty_and_the_status_says_why() {
    let steady = ["entry_speed", "peak_speed", "minimum_speed", "mean_speed", "period", "multiplier"];
    for (friction, ratio, status, is_steady) in [
        ("0.3", "1", "ok", true),
        ("30", "1", "may-jam", false),
        ("0", "1", "no-terminal-speed", false),
        ("0.1", "1e-30", "may-jam", false),
        ("0", "1e-30", "too-sharp", false),
        ("1e-8", "1", "long-rise", true),
    ] {
        let row = &rows(&["sweep", "--slots", "6", "--friction", friction, "--inertia-ratio", ratio])[0];
        assert_eq!(row["status"], status, "{friction} {ratio}");
        assert!(steady.iter().all(|key| row[*key].is_f64() == is_steady), "{row:?}");
        assert_eq!(row["entry_speed_rise_time"].is_f64(), status == "ok", "{row:?}");
        assert!(stdout(&["sweep", "--help"], 0).contains(status));
    }
}

#[test]
fn nothing_but_rows_goes_into_a_pipe() {
    let output = run(&SMALL);
    assert!(output.stderr.is_empty() && !output.stdout.contains(&0x1b), "{output:?}");
    assert!(output.stdout.starts_with(b"slots,pins,friction,"));
}
