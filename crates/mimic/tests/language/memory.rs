//! Results that keep their value while none of their control variables is true: latches, and switches with a gap.

use super::{own, program, runs};
use geneva_mimic::language::{DataSet, DeckRun, Program, RunOptions};
use geneva_mimic::{SolverParameters, StepSolution};

/// A run with each kept value and some tolerances.
fn in_all_ways(program: &Program, set: &DataSet, mut check: impl FnMut(&DeckRun, f64)) {
    let usual = RunOptions::default();
    for kept in [StepSolution::FullStep, StepSolution::TwoHalfSteps, StepSolution::Extrapolated] {
        for relative_tolerance in [1e-4, 5e-6, 1e-8, 1e-11] {
            let integrator = SolverParameters { kept, relative_tolerance, ..usual.integrator };
            let run = program
                .run(set, &RunOptions { integrator, ..usual })
                .unwrap_or_else(|trouble| panic!("{kept:?} {relative_tolerance} {trouble}"));
            assert!(run.work.forced == 0 && run.work.accepted + run.work.rejected < 200_000, "{:?}", run.work);
            check(&run, relative_tolerance.max(1e-8));
        }
    }
}

/// The room and its heater by exponentials, piece by piece: from 10° to 30° or back with a time constant of 5.
fn room(time: f64, [low, high]: [f64; 2]) -> (f64, f64) {
    let (mut began, mut from, mut heats) = (0.0, 10.0, true);
    loop {
        let (to, until) = if heats { (30.0, high) } else { (10.0, low) };
        let ends = began + 5.0 * libm::log((from - to) / (until - to));
        if time <= ends {
            return (to + (from - to) * libm::exp((began - time) / 5.0), f64::from(u8::from(heats)));
        }
        (began, from, heats) = (ends, until, !heats);
    }
}

#[test]
fn a_thermostat_with_a_gap_is_that_of_exponentials() {
    assert!((room(3.0, [19.0, 21.0]).0 - (30.0 - 20.0 * libm::exp(-0.6))).abs() < 1e-12);
    for limits in [[19.0, 21.0], [19.9, 20.1]] {
        let (program, set) = own("thermostat", &[limits[0], limits[1], 4.0]);
        in_all_ways(&program, &set, |run, tolerance| {
            assert_eq!(run.rows.len(), 81);
            for row in &run.rows {
                let exact = room(row[0], limits);
                // A change comes a print interval over 2²⁴ too late at most, some hundred times.
                assert!((row[1] - exact.0).abs() < 100.0 * tolerance + 1e-5, "{row:?} {exact:?}");
                assert_eq!(row[2], exact.1, "{row:?}");
            }
        });
        // It has switched again and again.
        let heats: Vec<f64> = (0..2000).map(|place| room(f64::from(place) * 0.01, limits).1).collect();
        assert!(heats.windows(2).filter(|pair| pair[0] != pair[1]).count() > 15);
    }
}

/// A parachute that opens for good at a speed of 20.
const PARACHUTE: &str = " DT .1\n V INT(9.81-K*V*V,0.)\n K LSW(OPEN,.4,.002)\n FAST FSW(V-20.,FALSE,TRUE,TRUE)\n \
                         FAST OPEN TRUE\n OUT(T,V,OPEN)\n FIN(T,10.)\n END\n";

#[test]
fn a_parachute_opens_once_and_stays_open() {
    let limits = [0.002, 0.4].map(|drag: f64| (9.81 / drag).sqrt());
    let opens = limits[0] / 9.81 * libm::atanh(20.0 / limits[0]);
    // Two cards under two names say the same as one.
    let both = PARACHUTE.replace(" FAST OPEN TRUE", " SLOW NOT(FAST)\n FAST OPEN TRUE\n SLOW X V");
    for text in [PARACHUTE, &both] {
        in_all_ways(&program(text), &DataSet::default(), |run, tolerance| {
            for row in &run.rows {
                let exact = if row[0] < opens {
                    limits[0] * libm::tanh(9.81 * row[0] / limits[0])
                } else {
                    let since = libm::atanh(limits[1] / 20.0) + 9.81 * (row[0] - opens) / limits[1];
                    limits[1] / libm::tanh(since)
                };
                assert!((row[1] - exact).abs() < 100.0 * tolerance, "{row:?} {exact}");
                assert_eq!(row[2] == 1.0, row[0] > opens, "{row:?}");
            }
        });
    }
}

#[test]
fn what_follows_keeps_its_value_from_where_its_card_ceases_to_count() {
    // WHEN follows the time until a sine passes a half, with steps far longer than it must be known to.
    let text = " DT 1.\n X INT(COS(T),0.)\n BELOW FSW(X-.5,TRUE,FALSE,FALSE)\n BELOW WHEN T\n OUT(T,X,WHEN)\n \
                FIN(T,2.)\n END\n";
    let kept = std::f64::consts::FRAC_PI_6 - runs(text)[0].rows[2][2];
    assert!(kept.abs() < 1e-5, "{kept}");
    // Other cards change nothing of it.
    let more = text.replace(" OUT", " LATE FSW(T-1.5,FALSE,TRUE,TRUE)\n LATE GO TRUE\n OUT");
    assert!((runs(&more)[0].rows[2][2] - runs(text)[0].rows[2][2]).abs() < 1e-6);
}

#[test]
fn of_two_cards_that_count_the_last_in_the_sorted_order_does() {
    for (cards, value) in [(" A X 1.\n B X 2.\n", 2.0), (" B X 2.\n A X 1.\n", 1.0)] {
        let text = format!(" A FSW(T-1.,FALSE,TRUE,TRUE)\n B TRUE\n{cards} OUT(T,X)\n FIN(T,2.)\n END\n");
        assert_eq!(runs(&text)[0].rows.iter().map(|row| row[1]).next_back(), Some(value), "{text}");
    }
}

#[test]
fn a_gap_too_narrow_to_stay_in_ends_with_the_card_and_the_time() {
    let usual = RunOptions::default();
    let choices = |relative_tolerance: f64| {
        let integrator = SolverParameters { most_steps: 20_000, relative_tolerance, ..usual.integrator };
        RunOptions { integrator, ..usual }
    };
    let (program, set) = own("thermostat", &[20.0, 20.000_1, 4.0]);
    let told = program.run(&set, &choices(1e-8)).expect_err("it switches all the time").to_string();
    assert!(told.starts_with("at T = 3.") && told.contains("card 7 (COLD HEATS = TRUE): HEATS has changed"), "{told}");
    // A tolerance wider than the gap passes over it, as over no gap at all: the room stays at the limits.
    let run = program.run(&set, &choices(5e-5)).unwrap_or_else(|trouble| panic!("{trouble}"));
    assert!(run.rows.iter().filter(|row| row[0] > 4.0).all(|row| (row[1] - 20.0).abs() < 1e-2), "{:?}", run.rows);
    // Without a memory it is the integral that is named.
    let (program, set) = own("switch", &[20.0, 4.0, 0.1]);
    let told = program.run(&set, &choices(1e-14)).expect_err("it takes too many").to_string();
    assert!(told.contains("has the largest error"), "{told}");
}
