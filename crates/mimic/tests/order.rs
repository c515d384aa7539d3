//! With steps of one length: by which power of it does the error fall?

use crate::problems::{Problem, SMOOTH, largest_error, mimic};
use geneva_mimic::{Kept, Parameters};

/// Steps of the coarser run: fine enough for the leading power, coarse enough to stay clear of rounding.
const STEPS: f64 = 64.0;

/// How far an observed order may be from the whole number. Seen: 0.06 at most.
const TOLERANCE: f64 = 0.1;

/// Binary logarithm of the ratio of the errors with [`STEPS`] steps and with twice as many.
fn observed(problem: &Problem, kept: Kept) -> f64 {
    let [error, with_half_the_step] = [STEPS, 2.0 * STEPS].map(|steps| {
        let fixed = |end: f64| Parameters { kept, ..Parameters::with_fixed_step(end / steps, end, end) };
        largest_error(problem, mimic(fixed))
    });
    libm::log2(error / with_half_the_step)
}

#[test]
fn the_order_is_four_and_five_if_extrapolated() {
    for problem in &SMOOTH {
        for (kept, order) in [(Kept::FullStep, 4.0), (Kept::TwoHalfSteps, 4.0), (Kept::Extrapolated, 5.0)] {
            let observed = observed(problem, kept);
            println!("{}, {kept:?}: order {observed:.3}", problem.name);
            assert!((observed - order).abs() < TOLERANCE, "{}, {kept:?}: order {observed}", problem.name);
        }
    }
}

#[test]
fn two_half_steps_have_a_sixteenth_of_the_error() {
    for problem in &SMOOTH {
        let [full, halves] = [Kept::FullStep, Kept::TwoHalfSteps].map(|kept| {
            let fixed = |end: f64| Parameters { kept, ..Parameters::with_fixed_step(end / STEPS, end, end) };
            largest_error(problem, mimic(fixed))
        });
        assert!((full / halves - 16.0).abs() < 1.0, "{}: {full} and {halves}", problem.name);
    }
}
