//! At the tolerance of the thesis, and at others: how far from the closed form, and from other integrators?

use crate::problems::{SMOOTH, dop853, dopri5, largest_error, mimic, run};
use geneva_mimic::{Kept, Parameters};

const KEPT: [Kept; 3] = [Kept::FullStep, Kept::TwoHalfSteps, Kept::Extrapolated];

/// A tenth of the run between printed points.
fn at(kept: Kept, relative_tolerance: f64) -> impl Fn(f64) -> Parameters {
    move |end| Parameters { kept, relative_tolerance, ..Parameters::new(end / 10.0, end) }
}

/// The tolerance is for one step; over a run some dozens of them add up, and growing solutions magnify the early ones.
/// Seen: 4.5, 0.31 and 0.026 times the tolerance.
const IN_TOLERANCES: [f64; 3] = [8.0, 0.5, 0.05];

#[test]
fn the_error_of_a_run_is_a_few_tolerances() {
    let tolerance = 5e-6;
    assert_eq!(Parameters::new(1.0, 1.0).relative_tolerance, tolerance);
    for (kept, bound) in KEPT.into_iter().zip(IN_TOLERANCES) {
        for problem in &SMOOTH {
            let error = largest_error(problem, mimic(at(kept, tolerance))) / tolerance;
            println!("{}, {kept:?}: {error:.4} tolerances", problem.name);
            assert!(error < bound, "{}, {kept:?}: {error} tolerances", problem.name);
        }
    }
}

#[test]
fn a_smaller_tolerance_gives_a_smaller_error() {
    for problem in &SMOOTH {
        for kept in KEPT {
            let [coarse, fine] = [1e-5, 1e-9].map(|tolerance| largest_error(problem, mimic(at(kept, tolerance))));
            // The step follows the fifth root of the tolerance, the error its fourth power: 10^3.2 for 10^4.
            assert!(fine < coarse / 200.0, "{}, {kept:?}: {coarse} and {fine}", problem.name);
        }
    }
}

#[test]
fn other_integrators_are_judged_by_the_same_judge() {
    for problem in &SMOOTH {
        let [five, eight] = [largest_error(problem, dopri5(1e-12)), largest_error(problem, dop853(1e-12))];
        println!("{}: Dopri5 {five:.1e}, Dop853 {eight:.1e}", problem.name);
        assert!(five < 1e-11 && eight < 1e-11, "{}: {five} and {eight}", problem.name);
        let here = largest_error(problem, mimic(at(Kept::Extrapolated, 1e-12)));
        assert!(here < 1e-11, "{}: {here}", problem.name);
    }
}

#[test]
fn the_ends_of_runs_are_those_of_another_integrator() {
    for problem in &SMOOTH {
        let theirs = dop853(1e-12)(problem).last().expect("an end").1;
        let ours = run(problem, &at(Kept::Extrapolated, 1e-12)(problem.run_length)).1.last.state;
        assert!((ours - theirs).amax() < 1e-10, "{}: {ours} and {theirs}", problem.name);
    }
}

#[test]
fn a_judge_that_is_shown_a_wrong_solution_says_so() {
    let shifted = |problem: &crate::problems::Problem| {
        let mut points = mimic(at(Kept::TwoHalfSteps, 1e-9))(problem);
        points[3].1[1] += 0.001;
        points
    };
    for problem in &SMOOTH {
        assert!(largest_error(problem, shifted) > 0.0005, "{}", problem.name);
    }
}
