//! Are results printed at exactly the times that were asked for, to the last bit?

use crate::problems::{LOGISTIC, SPRING, run};
use geneva_mimic::{SolverParameters, StepSolution, integrate};
use nalgebra::Vector2;

/// The grid, compiled here by itself: a run of so many points would take too long.
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../src/print_times.rs"]
mod source;

use source::PrintTimes;

/// Times of the printed points of the spring.
#[track_caller]
fn times(parameters: &SolverParameters) -> Vec<f64> {
    run(&SPRING, parameters).0.into_iter().map(|(time, _)| time).collect()
}

#[test]
fn every_time_is_a_product_to_the_bit_whatever_the_tolerance() {
    for (print_interval, points) in [(0.1_f64, 40_u32), (5e-4, 400), (1.0 / 3.0, 30), (0.07, 100), (0.7, 11)] {
        let run_length = f64::from(points) * print_interval;
        let expected: Vec<u64> = (0..=points).map(|index| (f64::from(index) * print_interval).to_bits()).collect();
        for relative_tolerance in [1e-3, 5e-6, 1e-10] {
            for kept in [StepSolution::FullStep, StepSolution::Extrapolated] {
                let asked =
                    SolverParameters { relative_tolerance, kept, ..SolverParameters::new(print_interval, run_length) };
                let printed: Vec<u64> = times(&asked).into_iter().map(f64::to_bits).collect();
                assert_eq!(printed, expected, "every {print_interval} at {relative_tolerance}");
            }
        }
    }
}

#[test]
fn steps_that_do_not_divide_the_interval_do_not_move_the_points() {
    let expected: Vec<f64> = (0..=20).map(|index| f64::from(index) * 0.1).collect();
    for step in [0.03, 0.1 / 3.0, 0.099_999, 0.1, 0.25] {
        assert_eq!(times(&SolverParameters::with_fixed_step(step, 0.1, 2.0)), expected, "steps of {step}");
    }
    let odd = SolverParameters { growth_factor: 1.7, shrink_factor: 0.3, ..SolverParameters::new(0.1, 2.0) };
    assert_eq!(times(&odd), expected);
}

#[test]
fn a_long_step_after_a_short_one_lands_on_the_point() {
    let mut still = |_: f64, _: &Vector2<f64>| Vector2::zeros();
    for part in 1..200 {
        let initial_step = 0.1 * f64::from(part) / 401.0;
        let parameters = SolverParameters { initial_step, growth_factor: 1e3, ..SolverParameters::new(0.1, 0.1) };
        let end = integrate(&mut still, Vector2::zeros(), &parameters, |_| ()).unwrap();
        assert_eq!((end.last.time, end.work.accepted), (0.1, 2), "first step {initial_step}");
    }
}

#[test]
fn a_run_that_is_no_multiple_of_the_interval_ends_with_a_shorter_one() {
    assert_eq!(times(&SolverParameters::new(0.25, 1.125)), [0.0, 0.25, 0.5, 0.75, 1.0, 1.125]);
    assert_eq!(times(&SolverParameters::new(2.0, 0.5)), [0.0, 0.5]);
    // Three tenths are not three times a tenth in f64, but are meant to be.
    assert_eq!(times(&SolverParameters::new(0.1, 0.3)), [0.0, 0.1, 0.2, 3.0 * 0.1]);
    let (points, end) = run(&SPRING, &SolverParameters::new(0.25, 1.125));
    assert_eq!((end.last.time, end.last.index, end.last.state), (1.125, 5, points[5].1));
}

#[test]
fn a_point_has_its_number_and_the_derivative_at_its_state() {
    let mut rate = LOGISTIC.rate;
    let start = Vector2::new(0.25, 1.0);
    let mut next = 0;
    let end = integrate(&mut rate, start, &SolverParameters::new(0.5, 4.0), |point| {
        assert_eq!(point.index, next);
        assert_eq!(point.derivative, (LOGISTIC.rate)(point.time, &point.state));
        if point.index == 0 {
            assert_eq!(point.state, start);
        }
        next += 1;
    });
    assert_eq!((end.unwrap().last.index, next), (8, 9));
}

#[test]
fn the_right_hand_side_is_never_asked_beyond_the_next_printed_point() {
    let mut latest: f64 = 0.0;
    let mut rate = |time: f64, state: &Vector2<f64>| {
        latest = latest.max(time);
        Vector2::new(state[1], -state[0])
    };
    integrate(&mut rate, Vector2::new(1.0, 0.0), &SolverParameters::new(0.3, 2.1), |_| ()).unwrap();
    assert_eq!(latest, 7.0 * 0.3);
}

/// Times of the points of a grid, without a run.
fn times_of_grid(interval: f64, end: f64) -> Vec<f64> {
    let grid = PrintTimes::new(interval, end);
    (0..=grid.last).map(|index| grid.time(index)).collect()
}

#[test]
fn a_run_length_within_rounding_of_a_multiple_is_that_multiple() {
    assert_eq!(times_of_grid(0.1, 0.3 + 1e-7).last(), Some(&(0.3 + 1e-7)));
    assert_eq!(PrintTimes::new(5e-4, 0.2).last, 400);
}

#[test]
fn extreme_sizes_give_a_grid_too() {
    assert_eq!(times_of_grid(f64::MAX, f64::MAX), [0.0, f64::MAX]);
    assert_eq!(times_of_grid(f64::MAX * 0.7, f64::MAX).last(), Some(&f64::MAX));
    assert_eq!(times_of_grid(f64::MAX, f64::MIN_POSITIVE), [0.0, f64::MIN_POSITIVE]);
    assert_eq!(PrintTimes::new(1e-12, 1.0).last, 1_000_000_000_000);
}
