//! Compares the second routes with the first, on tables that are from no source.

use crate::tables::{LISTING, tables};
use geneva_case1973::witness::{lagged_run, run_with_lag, steps};
use geneva_case1973::{Column, EXPLAINED, Hypothesis, Run};

/// The program of a row of four pins with an exact π, whose sign is late by this, run by the second route.
fn late(delay: f64, duration: f64) -> Option<Run> {
    run_with_lag(&Hypothesis::WITHOUT_LAG.program(&tables()[8]).expect("a program"), delay, LISTING.interval, duration)
}

#[test]
fn the_lagged_runs_are_those_of_the_program() {
    for row in tables().iter().step_by(3) {
        let (program, witness) = (Hypothesis::AS_RUN.run(row).expect("a run"), lagged_run(row).expect("a run"));
        for column in EXPLAINED {
            let apart = (witness.number(column) / program.number(column) - 1.0).abs();
            assert!(apart < 1e-3, "{}: {column:?} {apart:e}", row.slug());
        }
    }
}

#[test]
fn without_delay_it_is_the_motion_with_the_exact_sign() {
    let solved = Hypothesis::WITHOUT_LAG.run(&tables()[8]).expect("a run");
    let found = late(1e-9, 0.3).expect("a run");
    for column in [Column::Peak, Column::Minimum, Column::Period, Column::Rise] {
        // A lag shorter than a step is that of a step.
        let apart = (found.number(column) / solved.number(column) - 1.0).abs();
        assert!(apart < 1e-4, "{column:?}: {found:?} {solved:?}");
    }
}

#[test]
fn a_longer_delay_is_noticed_and_a_run_without_a_whole_engagement_has_no_result() {
    let [short, long] = [5e-5, 2.5e-4].map(|delay| late(delay, 0.2).expect("a run"));
    assert!((long.peak / short.peak - 1.0).abs() > 1e-3, "{short:?} {long:?}");
    assert_eq!(late(5e-5, 0.01), None);
}

#[test]
fn the_steady_cycle_in_steps_is_the_steady_state() {
    for row in tables() {
        for hypothesis in [Hypothesis::IDEAL, Hypothesis::WITHOUT_LAG] {
            let steady = hypothesis.engagement(row).and_then(|of| of.steady_state().ok()).expect("a steady state");
            let found = steps::cycle_of_row(&hypothesis, row).expect("a cycle");
            for (found, solved) in found.into_iter().zip([steady.minimum.speed, steady.period, steady.peak.speed]) {
                assert!((found / solved - 1.0).abs() < 1e-5, "{}: {found} {solved}", row.slug());
            }
        }
    }
}
