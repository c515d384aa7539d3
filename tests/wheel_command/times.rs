//! Do the wheels that are proposed for given times really have the times stated for them?

use crate::{assert_is_plain, number, object, pin, refused, stdout};
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

fn drivers(arguments: &[&str]) -> Vec<Value> {
    let found = object(&[&["wheel"], arguments].concat());
    found["drivers"].as_array().expect("an array").clone()
}

/// With a table of eight places, of which each index may take 0.6 s and each dwell must last 0.9 s.
#[test]
fn with_stations_the_times_are_limits_and_the_speeds_are_those_that_fulfil_both() {
    let found = drivers(&["--stations", "8", "--index-time", "0.6", "--dwell-time", "0.9"]);
    let [driver] = &found[..] else { panic!("{found:?}") };
    assert_eq!((&driver["type"], &driver["pins"], &driver["fits"]), (&"external".into(), &1.into(), &true.into()));
    for (key, right) in [
        ("least_turn_s", 1.44),
        ("greatest_turn_s", 1.6),
        ("least_rpm", 37.5),
        ("greatest_rpm", 60.0 / 1.44),
        ("least_index_time_s", 0.54),
        ("greatest_index_time_s", 0.6),
        ("least_dwell_time_s", 0.9),
        ("greatest_dwell_time_s", 1.0),
    ] {
        approx::assert_relative_eq!(driver[key].as_f64().expect(key), right, max_relative = 1e-12);
    }
}

/// By asking the wheel itself, of each kind and with each number of pins, at each end of the range and beyond it.
#[test]
fn at_every_speed_of_a_range_both_limits_hold_and_beyond_it_one_does_not() {
    let (mut fitting, mut none) = (0, 0);
    for stations in ["3", "5", "6", "8", "30"] {
        for (index, dwell) in [("1", "2"), ("0.6", "0.9"), ("1", "0.3"), ("2", "1.5"), ("0.5", "5")] {
            let found = drivers(&["--stations", stations, "--index-time", index, "--dwell-time", dwell]);
            let [most, least] = [index, dwell].map(|time| time.parse::<f64>().expect("a time"));
            let mut said = Vec::new();
            for of in &found {
                let (pins, kind) = (of["pins"].to_string(), of["type"].as_str().expect("a kind"));
                let holds = |rpm: f64| {
                    let rpm = rpm.to_string();
                    let found =
                        object(&["wheel", "--stations", stations, "--pins", &pins, "--type", kind, "--rpm", &rpm]);
                    let slack = 1.0 + 1e-9;
                    [number(&found, "indexing_time_s") <= most * slack, number(&found, "dwell_time_s") * slack >= least]
                };
                let [slow, fast] = ["least_rpm", "greatest_rpm"].map(|key| of[key].as_f64().expect("a speed"));
                let fits = of["fits"] == true;
                assert_eq!([holds(slow), holds(fast)], [[true, fits], [fits, true]], "{of}");
                assert_eq!([holds(0.99 * slow)[0], holds(1.01 * fast)[1]], [false, false], "{of}");
                said.push((kind.to_owned(), pins));
            }
            let fits = found[0]["fits"] == true;
            assert!(fits || found.len() == 1, "{found:?}");
            if fits {
                fitting += 1
            } else {
                none += 1
            }
            // All the others have another ratio of dwell to index than one that both limits allow.
            for kind in ["external", "internal", "spherical"] {
                for pins in 1..=6 {
                    let n: f64 = stations.parse().expect("a number");
                    let motion = match kind {
                        "external" => f64::from(pins) * (0.5 - 1.0 / n),
                        "internal" => 0.5 + 1.0 / n,
                        _ => 0.5,
                    };
                    let is_one = motion < 1.0 - 1e-9 && (pins == 1 || kind == "external");
                    let is_said = said.contains(&(kind.to_owned(), pins.to_string()));
                    let allowed = (1.0 - motion) / motion >= least / most - 1e-9;
                    assert!(!fits || is_said == (is_one && allowed), "{stations} {kind} {pins}: {found:?}");
                    assert!(fits || !is_one || !allowed, "{stations} {kind} {pins}: {found:?}");
                }
            }
        }
    }
    assert!(fitting > 5 && none > 5, "{fitting} {none}");
}

#[test]
fn speeds_for_a_number_of_stations_are_written_in_each_format() {
    let eight = ["wheel", "--stations", "8", "--index-time", "0.6", "--dwell-time", "0.9"];
    pin("wheel-for-stations-and-times", &eight);
    pin("wheel-for-stations-and-times-csv", &[&eight[..], &["--format", "csv"]].concat());
    pin("wheel-for-stations-out-of-reach", &["wheel", "--stations", "8", "--index-time", "0.5", "--dwell-time", "0.9"]);
    assert_is_plain(&stdout(&eight, 0));
    let said = refused(&["wheel", "--stations", "2", "--index-time", "1", "--dwell-time", "1"]);
    assert!(said.contains("2 stations") && said.contains("3 to 1000"), "{said}");
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
