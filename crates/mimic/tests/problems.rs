//! Problems with closed forms, integrators to solve them, and one judge for all of them.

use geneva_mimic::{Outcome, Parameters, integrate};
use nalgebra::{Vector2, Vector3};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, System};

/// Two equations, their solution and how far to follow it from time 0.
#[derive(Clone, Copy)]
pub struct Problem {
    pub name: &'static str,
    pub rate: fn(f64, &Vector2<f64>) -> Vector2<f64>,
    pub exact: fn(f64) -> Vector2<f64>,
    pub run_length: f64,
}

/// x' = x and y' = −y.
pub const EXPONENTIALS: Problem = Problem {
    name: "exponentials",
    rate: |_, state| Vector2::new(state[0], -state[1]),
    exact: |time| Vector2::new(libm::exp(time), libm::exp(-time)),
    run_length: 2.0,
};

/// x'' = −x.
pub const SPRING: Problem = Problem {
    name: "spring",
    rate: |_, state| Vector2::new(state[1], -state[0]),
    exact: |time| Vector2::new(libm::cos(time), -libm::sin(time)),
    run_length: 6.0,
};

/// x' = x (1 − x) and y' = −y².
pub const LOGISTIC: Problem = Problem {
    name: "logistic",
    rate: |_, state| Vector2::new(state[0] * (1.0 - state[0]), -state[1] * state[1]),
    exact: |time| Vector2::new(1.0 / (1.0 + 3.0 * libm::exp(-time)), 1.0 / (1.0 + time)),
    run_length: 4.0,
};

/// x' = −2 t x and y' = y cos t: time stands on the right.
pub const DRIVEN: Problem = Problem {
    name: "driven",
    rate: |time, state| Vector2::new(-2.0 * time * state[0], state[1] * libm::cos(time)),
    exact: |time| Vector2::new(libm::exp(-time * time), libm::exp(libm::sin(time))),
    run_length: 2.0,
};

pub const SMOOTH: [Problem; 4] = [EXPONENTIALS, SPRING, LOGISTIC, DRIVEN];

/// The largest error at any point that the solver gives, over the size of the component or over one.
#[track_caller]
pub fn largest_error(problem: &Problem, solve: impl FnOnce(&Problem) -> Vec<(f64, Vector2<f64>)>) -> f64 {
    let points = solve(problem);
    let reached = points.last().expect("no point").0;
    assert!((reached - problem.run_length).abs() < 1e-9, "{} ends at {reached}", problem.name);
    let error = |(time, state): (f64, Vector2<f64>)| {
        let exact = (problem.exact)(time);
        (0..2).map(|i| (state[i] - exact[i]).abs() / exact[i].abs().max(1.0)).fold(0.0, f64::max)
    };
    points.into_iter().map(error).fold(0.0, f64::max)
}

/// A run of a problem, with its printed points.
#[track_caller]
pub fn run(problem: &Problem, parameters: &Parameters) -> (Vec<(f64, Vector2<f64>)>, Outcome<2>) {
    let mut rate = problem.rate;
    let mut points = Vec::new();
    let end = integrate(&mut rate, (problem.exact)(0.0), parameters, |point| points.push((point.time, point.state)));
    (points, end.expect("a smooth problem"))
}

/// This crate, with parameters that may depend on the run length.
pub fn mimic(parameters: impl Fn(f64) -> Parameters) -> impl Fn(&Problem) -> Vec<(f64, Vector2<f64>)> {
    move |problem| run(problem, &parameters(problem.run_length)).0
}

/// The right-hand side with time as a third state: one of the other integrators asks at wrong times.
struct Autonomous(Problem);

impl System<f64, Vector3<f64>> for Autonomous {
    fn system(&self, _: f64, state: &Vector3<f64>, rates: &mut Vector3<f64>) {
        let rate = (self.0.rate)(state[2], &state.xy());
        *rates = Vector3::new(rate[0], rate[1], 1.0);
    }
}

fn with_time(problem: &Problem) -> Vector3<f64> {
    let start = (problem.exact)(0.0);
    Vector3::new(start[0], start[1], 0.0)
}

fn without_time(times: &[f64], states: &[Vector3<f64>]) -> Vec<(f64, Vector2<f64>)> {
    times.iter().copied().zip(states.iter().map(|state| state.xy())).collect()
}

/// Dormand and Prince, order 5, at its own steps.
pub fn dopri5(tolerance: f64) -> impl Fn(&Problem) -> Vec<(f64, Vector2<f64>)> {
    move |problem| {
        let end = problem.run_length;
        let mut solver = Dopri5::new(Autonomous(*problem), 0.0, end, end, with_time(problem), tolerance, tolerance);
        solver.set_output(OutputType::Sparse);
        solver.integrate().expect("a smooth problem");
        without_time(solver.x_out(), solver.y_out())
    }
}

/// Dormand and Prince, order 8, at its own steps.
pub fn dop853(tolerance: f64) -> impl Fn(&Problem) -> Vec<(f64, Vector2<f64>)> {
    move |problem| {
        let end = problem.run_length;
        let mut solver = Dop853::new(Autonomous(*problem), 0.0, end, end, with_time(problem), tolerance, tolerance);
        solver.set_output(OutputType::Sparse);
        solver.integrate().expect("a smooth problem");
        without_time(solver.x_out(), solver.y_out())
    }
}
