//! What does a run cost, and does it say so?

use crate::problems::{Problem, SMOOTH, SPRING, run};
use geneva_mimic::{AtSmallestStep, Kept, Parameters, Work, integrate};
use nalgebra::{Vector1, Vector2};

/// A run with its right-hand side counted from outside.
fn counted(problem: &Problem, parameters: &Parameters) -> (Work, u64) {
    let mut calls = 0;
    let mut rate = |time: f64, state: &Vector2<f64>| {
        calls += 1;
        (problem.rate)(time, state)
    };
    let end = integrate(&mut rate, (problem.exact)(0.0), parameters, |_| ()).expect("a smooth problem");
    (end.work, calls)
}

#[test]
fn an_attempt_takes_ten_evaluations_and_a_kept_point_one() {
    for problem in &SMOOTH {
        for print_interval in [problem.run_length, problem.run_length / 10.0, problem.run_length / 300.0] {
            for kept in [Kept::FullStep, Kept::TwoHalfSteps, Kept::Extrapolated] {
                let parameters = Parameters { kept, ..Parameters::new(print_interval, problem.run_length) };
                let (work, calls) = counted(problem, &parameters);
                assert_eq!(work.evaluations, calls, "{}: hidden work", problem.name);
                assert_eq!(calls, 10 * (work.accepted + work.rejected) + work.accepted + 1, "{}", problem.name);
                assert_eq!(work.forced, 0);
            }
        }
    }
}

#[test]
fn without_refusals_a_step_costs_eleven_evaluations() {
    let (work, calls) = counted(&SPRING, &Parameters::with_fixed_step(0.125, 0.5, 6.0));
    assert_eq!((work.accepted, work.rejected), (48, 0));
    assert_eq!(calls, 11 * 48 + 1, "one more for the derivative of the last point");
}

#[test]
fn the_spring_takes_this_many_steps() {
    let work = run(&SPRING, &Parameters::new(0.5, 6.0)).1.work;
    assert_eq!(work, Work { accepted: 52, rejected: 4, forced: 0, evaluations: 613 });
}

#[test]
fn more_printed_points_or_a_smaller_tolerance_never_come_for_nothing() {
    let steps = |relative_tolerance, print_interval| {
        let parameters = Parameters { relative_tolerance, ..Parameters::new(print_interval, 6.0) };
        run(&SPRING, &parameters).1.work.accepted
    };
    assert!(steps(1e-9, 0.5) > 3 * steps(5e-6, 0.5));
    assert_eq!(steps(5e-6, 0.005), 1200, "each printed point takes a step");
}

#[test]
fn steps_kept_against_the_tolerance_are_counted() {
    let coarse = Parameters::with_fixed_step(1.0, 1.0, 6.0);
    let work = run(&SPRING, &coarse).1.work;
    assert_eq!((work.accepted, work.rejected, work.forced), (6, 0, 6));
    // A jump that no step can hide: the smallest goes over it, and the run goes on.
    let mut jump = |time: f64, _: &Vector1<f64>| Vector1::new(if time < 0.3 { 0.0 } else { 1e6 });
    let forced = Parameters { at_smallest_step: AtSmallestStep::Continue, ..Parameters::new(0.25, 1.0) };
    let end = integrate(&mut jump, Vector1::zeros(), &forced, |_| ()).unwrap();
    assert!((end.last.state[0] / 0.7e6 - 1.0).abs() < 1e-8);
    assert_eq!(end.work.forced, 1);
    assert!(end.work.rejected >= 29);
}
