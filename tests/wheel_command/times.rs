//! Do the wheels that are proposed for given times really have the times stated for them?

use crate::{assert_is_plain, number, object, pin, stdout};
use serde_json::Value;

fn proposals(arguments: &[&str]) -> Vec<Value> {
    let found = object(&[&["wheel"], arguments].concat());
    found["proposals"].as_array().expect("an array").clone()
}

#[test]
fn a_proposed_wheel_has_the_times_that_it_is_said_to_have() {
    for (index, dwell) in [("0.4", "1"), ("1", "1"), ("2", "0.7"), ("0.1", "3"), ("3", "0.05")] {
        for of in proposals(&["--index-time", index, "--dwell-time", dwell]) {
            let stations = of["stations"].as_u64().unwrap_or(5).to_string();
            let (pins, rpm) = (of["pins"].to_string(), of["rpm"].to_string());
            let kind = of["type"].as_str().expect("a kind");
            let found = object(&["wheel", "--stations", &stations, "--pins", &pins, "--type", kind, "--rpm", &rpm]);
            for (key, proposed) in [("indexing_time_s", "index_time_s"), ("dwell_time_s", "dwell_time_s")] {
                let proposed = of[proposed].as_f64().expect("a time");
                approx::assert_relative_eq!(number(&found, key), proposed, max_relative = 1e-12);
            }
            let whole = index.parse::<f64>().expect("a time") + dwell.parse::<f64>().expect("a time");
            let cycle = number(&found, "indexing_time_s") + number(&found, "dwell_time_s");
            approx::assert_relative_eq!(cycle, whole, max_relative = 1e-12);
        }
    }
}

/// By trying all wheels one after another.
#[test]
fn no_other_wheel_comes_nearer() {
    let wanted = 0.4 / 1.4;
    let error = |motion: f64| (motion - wanted).abs();
    let said: Vec<f64> = proposals(&["--index-time", "0.4", "--dwell-time", "1"])
        .iter()
        .map(|of| error(of["index_time_s"].as_f64().expect("a time") / 1.4))
        .collect();
    assert!(said.is_sorted() && said.len() == 5);
    let mut all = Vec::new();
    for stations in 3..=60 {
        for pins in 1..=6 {
            let n = f64::from(stations);
            let motion = f64::from(pins) * (0.5 - 1.0 / n);
            if motion < 1.0 - 1e-9 {
                all.push(error(motion));
            }
        }
        all.push(error(0.5 + 1.0 / f64::from(stations)));
    }
    all.push(error(0.5));
    all.sort_by(f64::total_cmp);
    for (said, right) in said.iter().zip(all) {
        approx::assert_abs_diff_eq!(*said, right, epsilon = 1e-12);
    }
}

#[test]
fn the_kind_can_be_chosen() {
    for kind in ["external", "internal", "spherical"] {
        let found = proposals(&["--index-time", "1", "--dwell-time", "0.6", "--type", kind]);
        assert!(!found.is_empty() && found.iter().all(|of| of["type"] == kind), "{kind}");
    }
    // Five stations inside: the dwell is three sevenths of the index.
    let found = proposals(&["--index-time", "7", "--dwell-time", "3", "--type", "internal"]);
    assert_eq!((&found[0]["stations"], &found[0]["pins"]), (&5.into(), &1.into()));
}

#[test]
fn the_proposals_are_written_in_each_format() {
    pin("wheel-for-times", &["wheel", "--index-time", "0.4", "--dwell-time", "1"]);
    pin("wheel-for-times-out-of-reach", &["wheel", "--index-time", "0.1", "--dwell-time", "1"]);
    pin("wheel-for-times-csv", &["wheel", "--index-time", "1", "--dwell-time", "1", "--format", "csv"]);
    assert_is_plain(&stdout(&["wheel", "--index-time", "1", "--dwell-time", "1"], 0));
    // Wheels of more stations have these two ratios, or nearer ones; what is said is said of those that were looked at.
    for dwell in ["0.005", "1.012"] {
        let sheet = stdout(&["wheel", "--index-time", "1", "--dwell-time", dwell], 0);
        assert!(sheet.contains("with up to 60"), "{sheet}");
    }
}
