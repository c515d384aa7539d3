//! Problems with closed forms, integrators to solve them, and one judge for all of them.

use geneva_mimic::{Solution, SolverParameters, StepSolution, integrate};
use nalgebra::{Vector2, Vector3};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, System};

/// The values of a step that a run can go on with.
pub(crate) const KEPT: [StepSolution; 3] =
    [StepSolution::FullStep, StepSolution::TwoHalfSteps, StepSolution::Extrapolated];

/// Two equations, their solution and how far to follow it from time 0.
#[derive(Clone, Copy)]
pub(crate) struct Problem {
    pub name: &'static str,
    pub rate: fn(f64, &Vector2<f64>) -> Vector2<f64>,
    pub exact: fn(f64) -> Vector2<f64>,
    pub run_length: f64,
}

/// x'' = −x.
pub(crate) const SPRING: Problem = Problem {
    name: "spring",
    rate: |_, state| Vector2::new(state[1], -state[0]),
    exact: |time| Vector2::new(libm::cos(time), -libm::sin(time)),
    run_length: 6.0,
};

/// x' = x (1 − x) and y' = −y².
pub(crate) const LOGISTIC: Problem = Problem {
    name: "logistic",
    rate: |_, state| Vector2::new(state[0] * (1.0 - state[0]), -state[1] * state[1]),
    exact: |time| Vector2::new(1.0 / (1.0 + 3.0 * libm::exp(-time)), 1.0 / (1.0 + time)),
    run_length: 4.0,
};

/// All: besides these two x' = x with y' = −y, and one with time on the right, x' = −2 t x with y' = y cos t.
pub(crate) const SMOOTH: [Problem; 4] = [
    Problem {
        name: "exponentials",
        rate: |_, state| Vector2::new(state[0], -state[1]),
        exact: |time| Vector2::new(libm::exp(time), libm::exp(-time)),
        run_length: 2.0,
    },
    SPRING,
    LOGISTIC,
    Problem {
        name: "driven",
        rate: |time, state| Vector2::new(-2.0 * time * state[0], state[1] * libm::cos(time)),
        exact: |time| Vector2::new(libm::exp(-time * time), libm::exp(libm::sin(time))),
        run_length: 2.0,
    },
];

/// Times and states.
pub(crate) type Points = Vec<(f64, Vector2<f64>)>;

/// The largest error at any point, over the size of the component or over one.
#[track_caller]
pub(crate) fn largest_error(problem: &Problem, points: &Points) -> f64 {
    let reached = points.last().expect("no point").0;
    assert!((reached - problem.run_length).abs() < 1e-9, "{} ends at {reached}", problem.name);
    let error = |(time, state): &(f64, Vector2<f64>)| {
        let exact = (problem.exact)(*time);
        (0..2).map(|i| (state[i] - exact[i]).abs() / exact[i].abs().max(1.0)).fold(0.0, f64::max)
    };
    points.iter().map(error).fold(0.0, f64::max)
}

/// A run of a problem, with its printed points.
#[track_caller]
pub(crate) fn run(problem: &Problem, parameters: &SolverParameters) -> (Points, Solution<2>) {
    let mut rate = problem.rate;
    let mut points = Vec::new();
    let end = integrate(&mut rate, (problem.exact)(0.0), parameters, |point| points.push((point.time, point.state)));
    (points, end.expect("a smooth problem"))
}

/// The right-hand side with time as a third state: one of the other integrators asks at wrong times.
struct Autonomous(Problem);

impl System<f64, Vector3<f64>> for Autonomous {
    fn system(&self, _: f64, state: &Vector3<f64>, rates: &mut Vector3<f64>) {
        let rate = (self.0.rate)(state[2], &state.xy());
        *rates = Vector3::new(rate[0], rate[1], 1.0);
    }
}

macro_rules! by_dormand_and_prince {
    ($name:ident, $solver:ident, $order:literal) => {
        #[doc = concat!("Dormand and Prince, order ", $order, ", at its own steps.")]
        pub(crate) fn $name(problem: &Problem, tolerance: f64) -> Points {
            let (start, end) = ((problem.exact)(0.0), problem.run_length);
            let start = Vector3::new(start[0], start[1], 0.0);
            let mut solver = $solver::new(Autonomous(*problem), 0.0, end, end, start, tolerance, tolerance);
            solver.set_output(OutputType::Sparse);
            solver.integrate().expect("a smooth problem");
            solver.x_out().iter().copied().zip(solver.y_out().iter().map(|state| state.xy())).collect()
        }
    };
}
by_dormand_and_prince!(dopri5, Dopri5, 5);
by_dormand_and_prince!(dop853, Dop853, 8);
