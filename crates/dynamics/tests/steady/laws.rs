//! Laws that the motion obeys whatever its numbers are.

use super::{escapement, samples};
use approx::assert_relative_eq;
use geneva_dynamics::DynamicsError;
use geneva_dynamics::similarity::Scaling;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

#[test]
fn the_steady_state_is_handed_on_unchanged() {
    for engagement in samples() {
        let steady = engagement.steady_state().expect("a terminal speed");
        let end = engagement.return_map(steady.entry_speed).expect("a speed");
        assert_relative_eq!(end, steady.entry_speed, max_relative = 2e-13);
        let passage = engagement.passage(steady.entry_speed).expect("a speed");
        assert_relative_eq!(passage.duration(), steady.period, max_relative = 2e-13);
        assert_relative_eq!(passage.multiplier(), steady.multiplier, max_relative = 1e-9);
        assert_eq!(passage.reversal_angle().is_some(), steady.reversal_angle.is_some());
        let [low, high] = [steady.minimum.speed, steady.peak.speed];
        assert!(low > 0.0 && low <= steady.entry_speed && steady.entry_speed <= high);
        assert!(low < steady.mean_speed && steady.mean_speed < high);
        assert!(
            (0.0..=steady.period).contains(&steady.peak.time) && (0.0..=steady.period).contains(&steady.minimum.time)
        );
    }
}

#[test]
fn two_motions_approach_by_the_multiplier() {
    for engagement in samples() {
        let steady = engagement.steady_state().expect("a terminal speed").entry_speed;
        for part in [0.5, 1.0, 1.7] {
            let square = |speed: f64| speed * speed;
            let (low, high) = (steady * part * (1.0 - 1e-4), steady * part * (1.0 + 1e-4));
            let ends = [low, high].map(|speed| square(engagement.return_map(speed).expect("a speed")));
            let slope = (ends[1] - ends[0]) / (square(high) - square(low));
            let factor = engagement.passage(steady * part).expect("a speed").multiplier();
            assert!(factor > 0.0 && factor < 1.0, "{factor}");
            assert!((slope - factor).abs() < 1e-6 * factor + 1e-10, "{slope} and {factor}");
        }
    }
}

#[test]
fn without_friction_the_energy_is_the_work_of_the_torque() {
    for mechanism in Mechanism::ALL {
        let engagement = Engagement::new(&escapement(mechanism, 0.07, 0.0)).expect("an engagement");
        for speed in [0.0, 0.5, 4.0, 1e3] {
            let passage = engagement.passage(speed).expect("a speed");
            // i u/2 grows by the torque, which is one, times the turn.
            let square = speed * speed + 2.0 * engagement.reset() / 0.07;
            assert_relative_eq!(passage.end_speed(), square.sqrt(), max_relative = 1e-13);
            assert_eq!(passage.multiplier(), 1.0);
        }
        let error = engagement.steady_state().expect_err("nothing brakes");
        assert_eq!(error, DynamicsError::NoTerminalSpeed { multiplier: 1.0 });
        assert!(matches!(engagement.rise(0.01), Err(DynamicsError::NoTerminalSpeed { .. })));
        // A reset angle elsewhere than at the exit loses the energy of the follower each time: it brakes.
        let reset_after =
            Engagement::reset_after(engagement.parameters(), engagement.reset() * 1.2, 1e-12).expect("in range");
        let (steady, end) =
            (reset_after.steady_state().expect("a brake"), reset_after.reset() - engagement.reset() / 2.0);
        let numerator = reset_after.parameters().pose(end).velocity_ratio();
        assert_relative_eq!(steady.multiplier, 0.07 / (0.07 + numerator * numerator), max_relative = 1e-12);
        let square = 2.0 * reset_after.reset() / (numerator * numerator);
        assert_relative_eq!(steady.entry_speed, square.sqrt(), max_relative = 1e-12);
    }
}

#[test]
fn speeds_scale_with_the_root_of_the_torque_over_the_inertia() {
    for mechanism in Mechanism::ALL {
        let make = |torque: f64, scale: f64| {
            let inertias = Inertias::new(0.07 * scale, scale).expect("sound");
            let escapement = Parameters::new(mechanism, inertias, torque, 0.21).expect("sound");
            (Engagement::new(&escapement).expect("an engagement"), escapement)
        };
        let (one, base) = make(1.0, 1.0);
        let steady = one.steady_state().expect("a terminal speed");
        for (torque, inertia) in [(0.3, 1.0), (7.0, 0.001), (1e-8, 1e8), (1e100, 1e-100)] {
            let (other, scaled) = make(torque, inertia);
            let (scaling, other) =
                (Scaling::from_drives(base.drive(), scaled.drive()).expect("sound"), other.steady_state());
            let other = other.expect("a terminal speed");
            for (name, one, other) in [
                ("entry", steady.entry_speed * scaling.speed, other.entry_speed),
                ("peak", steady.peak.speed * scaling.speed, other.peak.speed),
                ("minimum", steady.minimum.speed * scaling.speed, other.minimum.speed),
                ("period", steady.period * scaling.time, other.period),
                ("multiplier", steady.multiplier, other.multiplier),
                ("angle", steady.minimum.angle, other.minimum.angle),
            ] {
                assert!((one / other - 1.0).abs() < 1e-13, "{mechanism:?} {torque} {inertia} {name}: {one} {other}");
            }
        }
    }
}

#[test]
fn the_rise_ends_where_each_definition_says() {
    for mechanism in Mechanism::ALL {
        let engagement = Engagement::new(&escapement(mechanism, 0.07, 0.21)).expect("an engagement");
        let rise = engagement.rise(1e-9).expect("a rise");
        let steady = rise.steady;
        let mut last = 0.0;
        for cycle in &rise.cycles {
            assert_eq!(cycle.start, last);
            assert!(cycle.entry_speed <= cycle.end_speed && cycle.end_speed <= steady.entry_speed * (1.0 + 1e-12));
            assert!(cycle.start <= cycle.peak.time && cycle.peak.time <= cycle.end);
            last = cycle.end;
        }
        // The difference of squares falls by the multiplier, in the end.
        let gap = |cycle: &geneva_dynamics::steady::RiseCycle| steady.entry_speed.powi(2) - cycle.end_speed.powi(2);
        let near = rise.cycles.windows(2).find(|pair| gap(&pair[0]) < 1e-3 * steady.entry_speed.powi(2)).expect("near");
        let factor = gap(&near[1]) / gap(&near[0]);
        assert!((factor / steady.multiplier - 1.0).abs() < 0.02, "{factor} {}", steady.multiplier);
        let times = [
            rise.until_entry_speed(0.01),
            rise.until_mean_speed(0.01),
            rise.until_peak(0.01),
            rise.until_minimum(0.01),
        ];
        for time in times {
            let (loose, tight) = (time.expect("reached"), rise.until_entry_speed(1e-6).expect("reached"));
            assert!(loose > 0.0 && loose <= tight + steady.period, "{mechanism:?} {loose} {tight}");
        }
        let (count, time) = engagement.engagements_to_settle(0.01).expect("a rise");
        assert_eq!(Some(time), rise.until_entry_speed(0.01));
        assert_eq!(rise.cycles[count - 1].end, time);
    }
}

#[test]
fn a_printed_run_is_the_motion_of_the_engagements() {
    let engagement = Engagement::new(&escapement(Mechanism::FOUR_PIN, 0.07, 0.33)).expect("an engagement");
    let (lines, rise) = (engagement.run(0.01, 12.0).expect("a run"), engagement.rise(1e-9).expect("a rise"));
    assert_eq!(lines.len(), 1201);
    assert!(lines[0].speed == 0.0 && lines[0].turned.abs() < 1e-15, "{:?}", lines[0]);
    for line in &lines {
        let angular_acceleration =
            engagement.parameters().acceleration(line.angle, line.speed).expect("one acceleration");
        assert!(
            (line.acceleration - angular_acceleration.value).abs() < 1e-10 * (1.0 + angular_acceleration.value.abs()),
            "{line:?} {angular_acceleration:?}"
        );
        let cycle = rise.cycles.get(line.engagement);
        let [low, high] = cycle.map_or([0.0, f64::MAX], |cycle| [cycle.minimum.speed, cycle.peak.speed]);
        assert!(line.speed >= low * (1.0 - 1e-12) && line.speed <= high * (1.0 + 1e-12), "{line:?}");
    }
    // A finer grid has the same lines among its own.
    let finer = engagement.run(0.005, 12.0).expect("a run");
    for (line, same) in lines.iter().zip(finer.iter().step_by(2)) {
        assert_relative_eq!(line.speed, same.speed, max_relative = 1e-12, epsilon = 1e-12);
    }
}

#[test]
fn the_first_minimum_from_rest_is_where_the_acceleration_turns() {
    for mechanism in Mechanism::ALL {
        for (inertia, friction) in [(0.07, 0.21), (0.7, 0.33)] {
            let engagement = Engagement::new(&escapement(mechanism, inertia, friction)).expect("an engagement");
            let found = engagement.first_minimum().expect("a motion").expect("a minimum");
            let lines = engagement.run(1e-3, 8.0).expect("a run");
            let turn = lines.windows(2).find(|w| w[0].acceleration < 0.0 && w[1].acceleration >= 0.0).expect("a turn");
            assert!(turn[0].time <= found.time && found.time <= turn[1].time, "{mechanism:?} {inertia}: {found:?}");
            assert!(found.speed <= turn[0].speed && found.speed <= turn[1].speed);
            assert_relative_eq!(found.speed, turn[0].speed, max_relative = 1e-5);
        }
    }
}
