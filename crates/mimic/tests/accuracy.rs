//! By which power of the step does the error fall, how far is a run from the closed form at its tolerance, and are its
//! bits always the same?

use crate::problems::{KEPT, Problem, SMOOTH, SPRING, dop853, dopri5, largest_error, run};
use geneva_mimic::{SolverParameters, StepSolution, integrate};
use nalgebra::Vector2;

fn error(problem: &Problem, parameters: &SolverParameters) -> f64 {
    largest_error(problem, &run(problem, parameters).0)
}

#[test]
fn the_order_is_four_and_five_if_extrapolated_and_half_steps_have_a_sixteenth_of_the_error() {
    // Fine enough for the leading power, coarse enough to stay clear of rounding.
    const STEPS: f64 = 64.0;
    for problem in &SMOOTH {
        let end = problem.run_length;
        let fixed = |kept, steps| SolverParameters { kept, ..SolverParameters::with_fixed_step(end / steps, end, end) };
        let errors = KEPT.map(|kept| [STEPS, 2.0 * STEPS].map(|steps| error(problem, &fixed(kept, steps))));
        let orders = errors.map(|[error, with_half_the_step]| libm::log2(error / with_half_the_step));
        println!("{}: orders {orders:.3?}", problem.name);
        // Seen: 0.06 at most.
        for (order, whole) in orders.into_iter().zip([4.0, 4.0, 5.0]) {
            assert!((order - whole).abs() < 0.1, "{}: {orders:?}", problem.name);
        }
        let [[full, _], [halves, _], _] = errors;
        assert!((full / halves - 16.0).abs() < 1.0, "{}: {full} and {halves}", problem.name);
    }
}

/// A tenth of the run between printed points.
fn at(problem: &Problem, kept: StepSolution, relative_tolerance: f64) -> SolverParameters {
    SolverParameters {
        kept,
        relative_tolerance,
        ..SolverParameters::new(problem.run_length / 10.0, problem.run_length)
    }
}

#[test]
fn the_error_of_a_run_is_a_few_tolerances() {
    // The tolerance is for one step; over a run some dozens of them add up, and growing solutions magnify the early
    // ones. Seen: 4.5, 0.31 and 0.026 times the tolerance.
    const BOUNDS: [f64; 3] = [8.0, 0.5, 0.05];
    let tolerance = 5e-6;
    assert_eq!(SolverParameters::new(1.0, 1.0).relative_tolerance, tolerance);
    for problem in &SMOOTH {
        for (kept, bound) in KEPT.into_iter().zip(BOUNDS) {
            let error = error(problem, &at(problem, kept, tolerance)) / tolerance;
            assert!(error < bound, "{}, {kept:?}: {error} tolerances", problem.name);
        }
    }
}

#[test]
fn a_smaller_tolerance_gives_a_smaller_error() {
    for problem in &SMOOTH {
        for kept in KEPT {
            let [coarse, fine] = [1e-5, 1e-9].map(|tolerance| error(problem, &at(problem, kept, tolerance)));
            // The step follows the fifth root of the tolerance, the error its fourth power: 10^3.2 for 10^4.
            assert!(fine < coarse / 200.0, "{}, {kept:?}: {coarse} and {fine}", problem.name);
        }
    }
}

#[test]
fn other_integrators_and_this_one_meet_in_the_closed_form() {
    for problem in &SMOOTH {
        let here = run(problem, &at(problem, StepSolution::Extrapolated, 1e-12)).0;
        for (name, points) in [("5", dopri5(problem, 1e-12)), ("8", dop853(problem, 1e-12)), ("here", here)] {
            let error = largest_error(problem, &points);
            assert!(error < 1e-11, "{}, {name}: {error}", problem.name);
        }
    }
}

#[test]
fn a_judge_that_is_shown_a_wrong_solution_says_so() {
    for problem in &SMOOTH {
        let mut points = run(problem, &at(problem, StepSolution::TwoHalfSteps, 1e-9)).0;
        points[3].1[1] += 0.001;
        assert!(largest_error(problem, &points) > 0.0005, "{}", problem.name);
    }
}

#[test]
fn the_bits_are_these() {
    // Every printed number of the spring, a right-hand side of plain arithmetic, in a 64-bit FNV-1a hash.
    let expected = [0xff48_1289_5461_97e5, 0xa671_c66e_093c_5b3d, 0x92c7_0e4d_c85c_9269];
    for (kept, expected) in KEPT.into_iter().zip(expected) {
        let (mut rate, mut hash) = (SPRING.rate, 0xcbf2_9ce4_8422_2325_u64);
        let end = integrate(
            &mut rate,
            Vector2::new(1.0, 0.0),
            &SolverParameters { kept, ..SolverParameters::new(0.1, 6.0) },
            |at| {
                let numbers = [at.time, at.state[0], at.state[1], at.derivative[0], at.derivative[1]];
                for byte in numbers.into_iter().flat_map(|number| number.to_bits().to_le_bytes()) {
                    hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
                }
            },
        );
        end.expect("a smooth problem");
        assert_eq!(hash, expected, "{kept:?}: {hash:#018x}");
    }
}
