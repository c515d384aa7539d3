//! The run from rest: its lines agree with the dynamics, and they end near the steady state.

use super::{DESIGNS, Design, FOUR, command, object};
use crate::{number, stdout};

const COLUMNS: [&str; 7] = ["time", "engagement", "turned_deg", "angle_deg", "speed", "acceleration", "follower_speed"];

/// The lines of a run.
#[track_caller]
fn lines(design: Design, more: &[&str]) -> Vec<[f64; 7]> {
    let text = stdout(&command(design, &[&["--format", "csv"], more].concat()), 0);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    assert_eq!(reader.headers().expect("a header"), COLUMNS.as_slice());
    let row = |row: Result<csv::StringRecord, csv::Error>| {
        let cells: Vec<f64> = row.expect("cells").iter().map(|cell| cell.parse().expect("a number")).collect();
        cells.try_into().expect("as many cells as columns")
    };
    reader.records().map(row).collect()
}

#[test]
fn speed_is_the_rate_of_the_angle_and_acceleration_that_of_the_speed() {
    for more in [&[][..], &["--reset-deg", "100"]] {
        let found = lines(FOUR, &[&["--duration", "0.03", "--interval", "1e-6"], more].concat());
        let (mut compared, interval) = (0, 1e-6);
        for three in found.windows(3) {
            let [before, line, after] = [three[0], three[1], three[2]];
            let rate = |column: usize| (after[column] - before[column]) / (2.0 * interval);
            let [time, _, _, _, speed, acceleration, _] = line;
            assert!((rate(2).to_radians() / speed - 1.0).abs() < 1e-3, "{more:?}, {time}: {speed}");
            // Where the contact changes its flank, or a pin enters, the acceleration jumps.
            let jumps = before[1] != after[1] || (after[5] - before[5]).abs() > 0.01 * acceleration.abs();
            if !jumps {
                compared += 1;
                assert!((rate(4) / acceleration - 1.0).abs() < 1e-3, "{more:?}, {time}: {acceleration}");
            }
        }
        assert!(compared > found.len() / 2, "{more:?}: {compared} of {}", found.len());
    }
}

#[test]
fn a_run_starts_from_rest_and_ends_near_the_steady_state() {
    for design in DESIGNS {
        let (found, steady) = (lines(design, &[]), object(design, &[]));
        let [.., last] = found[..] else { panic!("no lines") };
        let [time, _, _, _, speed, acceleration, _] = found[0];
        assert!(time == 0.0 && speed.abs() < 1e-9 * last[4] && acceleration > 0.0, "{design:?}: {:?}", found[0]);
        if number(&steady, "entry_speed_rise_engagements") < 97.0 {
            let [peak, minimum, mean] = ["peak_speed", "minimum_speed", "mean_speed"].map(|key| number(&steady, key));
            assert!(last[4] <= 1.001 * peak && last[4] >= 0.98 * minimum, "{design:?}: {last:?}");
            // The driver's mean speed over its last turn by the reset angle, and the last turn is of the steady state.
            let turn = number(&steady, "reset_deg");
            let before = found.iter().rev().find(|line| line[2] <= last[2] - turn).expect("a period before the last");
            let over = (last[2] - before[2]).to_radians() / (last[0] - before[0]);
            assert!((over / mean - 1.0).abs() < 0.05, "{design:?}: {over} {mean}");
        }
        let (lines_of_last, engagement) = (found.iter().filter(|line| line[1] == last[1]).count(), last[1]);
        assert!(lines_of_last >= 30 && engagement >= 3.0, "{design:?}: {lines_of_last} {engagement}");
        assert!(found.len() < 30_000, "{design:?}: {}", found.len());
    }
}

#[test]
fn without_friction_there_is_a_run_and_it_gains_what_the_torque_gives() {
    let design = ["4", "0", "2", "1", "5"];
    let found = lines(design, &[]);
    assert_eq!(found.last().map(|line| line[1]), Some(9.0), "ten engagements");
    for [_, _, turned, angle, speed, _, follower] in found {
        assert!((-45.0..=45.0).contains(&(angle * (1.0 - 1e-12))), "{angle}");
        let energy = 0.5 * (speed * speed + 5.0 * follower * follower);
        let work = 2.0 * turned.to_radians();
        assert!((energy - work).abs() < 1e-9 * work.max(1.0), "{energy} {work}");
    }
}

#[test]
fn the_grid_is_the_one_asked_for() {
    let found = lines(FOUR, &["--interval", "5e-4", "--duration", "0.01"]);
    let times: Vec<_> = found.iter().map(|line| line[0]).collect();
    let expected: Vec<_> = (0..=20).map(|number| f64::from(number) * 5.0 / 1e4).collect();
    assert_eq!(times, expected);
    // A duration without an interval, and an interval without a duration.
    let short = lines(FOUR, &["--duration", "1e-6"]);
    assert!((100..=250).contains(&short.len()) && short.iter().all(|line| line[0] <= 1e-6), "{}", short.len());
    let long = lines(FOUR, &["--duration", "1"]);
    assert!((10_000..=20_001).contains(&long.len()), "{}", long.len());
    let coarse = lines(FOUR, &["--interval", "0.01"]);
    assert_eq!(coarse.iter().map(|line| line[0]).collect::<Vec<_>>(), [0.0, 0.01, 0.02, 0.03, 0.04]);
}
