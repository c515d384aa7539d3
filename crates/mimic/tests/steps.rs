//! Does the step halve and double by the rule, is the right result kept, and what does a run cost?

use crate::problems::{KEPT, LOGISTIC, Points, Problem, SMOOTH, SPRING, run};
use geneva_mimic::{MinStepPolicy, SolverParameters, SolverStats, StepSolution, System, integrate, runge_kutta_step};
use nalgebra::{Vector1, Vector2};
use std::convert::Infallible;

/// A problem that records every point of the run, and how often it is asked.
struct Recorded {
    problem: Problem,
    kept: Points,
    calls: u64,
}

impl System<2> for Recorded {
    type Fault = Infallible;

    fn derivative(&mut self, time: f64, state: &Vector2<f64>) -> Result<Vector2<f64>, Infallible> {
        self.calls += 1;
        Ok((self.problem.rate)(time, state))
    }

    fn accepted(&mut self, time: f64, state: &Vector2<f64>, rate: &Vector2<f64>) -> Result<(), Infallible> {
        assert_eq!(*rate, (self.problem.rate)(time, state));
        self.kept.push((time, *state));
        Ok(())
    }
}

fn recorded(problem: Problem, parameters: &SolverParameters) -> (Recorded, SolverStats) {
    let mut system = Recorded { problem, kept: Vec::new(), calls: 0 };
    let work = integrate(&mut system, (problem.exact)(0.0), parameters, |_| ()).expect("a smooth problem").work;
    (system, work)
}

/// The whole step and two half steps from a time to another.
fn both(problem: &Problem, from: f64, to: f64, state: &Vector2<f64>) -> (Vector2<f64>, Vector2<f64>) {
    let rate = |time: f64, state: &Vector2<f64>| Ok::<_, Infallible>((problem.rate)(time, state));
    let step = |from: f64, to: f64, state: &Vector2<f64>| {
        runge_kutta_step(rate, from, to, state, &(problem.rate)(from, state)).unwrap()
    };
    let middle = from + (to - from) / 2.0;
    (step(from, to, state), step(middle, to, &step(from, middle, state)))
}

/// Difference of the two over the tolerance, by the parameters' own words.
fn excess(full: &Vector2<f64>, halves: &Vector2<f64>, parameters: &SolverParameters) -> f64 {
    let allowed = |size: f64| parameters.relative_tolerance * size.abs().max(parameters.absolute_floor);
    (0..2).map(|i| (full[i] - halves[i]).abs() / allowed(halves[i])).fold(0.0, f64::max)
}

/// The kept points and the number of refused steps, from the first step on.
fn by_hand(problem: &Problem, parameters: &SolverParameters) -> (Points, u64) {
    let (mut time, mut state, mut step) = (0.0, (problem.exact)(0.0), parameters.initial_step);
    let (mut kept, mut refused) = (vec![(time, state)], 0);
    let points = (parameters.run_length / parameters.print_interval).round() as u32;
    for point in 1..=points {
        let target = f64::from(point) * parameters.print_interval;
        while time < target {
            let cut = target - time < step * 0.999_999;
            let end = if target - time < step * 1.000_000_001 { target } else { time + step };
            let (full, halves) = both(problem, time, end, &state);
            let excess = excess(&full, &halves, parameters);
            if excess > 1.0 {
                refused += 1;
                step = (end - time) / 2.0;
                continue;
            }
            if !cut && 64.0 * excess <= 1.0 {
                step = (2.0 * step).min(parameters.print_interval);
            }
            (time, state) = (end, if parameters.kept == StepSolution::FullStep { full } else { halves });
            kept.push((time, state));
        }
    }
    (kept, refused)
}

#[test]
fn a_run_is_its_rule_step_by_step_to_the_bit() {
    let (mut refused_in_all, mut doubled_in_all) = (0, 0);
    for problem in SMOOTH {
        for kept in [StepSolution::FullStep, StepSolution::TwoHalfSteps] {
            for (relative_tolerance, parts) in [(5e-6, 1.0), (5e-6, 7.0), (1e-9, 10.0)] {
                let whole = SolverParameters::new(problem.run_length / parts, problem.run_length);
                let parameters = SolverParameters { kept, relative_tolerance, ..whole };
                let (system, work) = recorded(problem, &parameters);
                let (expected, refused) = by_hand(&problem, &parameters);
                assert_eq!(work.rejected, refused, "{}", problem.name);
                assert!(system.kept == expected, "{}: another way", problem.name);
                let steps: Vec<f64> = expected.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
                doubled_in_all += steps.windows(2).filter(|pair| pair[1] > 1.9 * pair[0]).count();
                refused_in_all += refused;
            }
        }
    }
    assert!(refused_in_all > 100 && doubled_in_all > 20, "{refused_in_all} refused, {doubled_in_all} doubled");
}

#[test]
fn a_step_is_refused_as_soon_as_it_is_above_the_tolerance() {
    for problem in SMOOTH {
        let (full, halves) = both(&problem, 0.0, 0.25, &(problem.exact)(0.0));
        let limit =
            excess(&full, &halves, &SolverParameters { relative_tolerance: 1.0, ..SolverParameters::new(0.25, 0.25) });
        for (part, steps) in [(1.0 + 1e-12, 1), (1.0 - 1e-12, 2)] {
            let parameters = SolverParameters { relative_tolerance: part * limit, ..SolverParameters::new(0.25, 0.25) };
            let work = recorded(problem, &parameters).1;
            assert_eq!((work.accepted, work.rejected), (steps, steps - 1), "{}", problem.name);
        }
    }
}

#[test]
fn each_named_parameter_is_heeded() {
    let steps = |change: fn(&mut SolverParameters)| {
        let mut parameters = SolverParameters { relative_tolerance: 1e-8, ..SolverParameters::new(0.5, 4.0) };
        change(&mut parameters);
        recorded(LOGISTIC, &parameters).0.kept
    };
    let usual = steps(|_| ());
    assert_eq!(steps(|p| p.initial_step = 0.015_625)[1].0, 0.015_625);
    assert_eq!(steps(|p| (p.largest_step, p.initial_step) = (0.015_625, 0.015_625)).len(), 257);
    assert_eq!(steps(|p| (p.growth_factor, p.initial_step) = (1.0, 0.015_625)).len(), 257, "never longer");
    assert!(steps(|p| p.growth_below = 0.0).len() > usual.len());
    assert!(steps(|p| p.shrink_factor = 0.125).len() > usual.len());
    assert!(steps(|p| p.absolute_floor = 10.0).len() < usual.len());
    assert_ne!(steps(|p| p.kept = StepSolution::Extrapolated).last(), usual.last());
    assert!(steps(|p| p.relative_tolerance = 1e-11).len() > 2 * usual.len());
}

#[test]
fn an_attempt_takes_ten_evaluations_and_a_kept_point_one() {
    for problem in SMOOTH {
        for points in [1.0, 10.0, 300.0] {
            for kept in KEPT {
                let parameters = SolverParameters::new(problem.run_length / points, problem.run_length);
                let (system, work) = recorded(problem, &SolverParameters { kept, ..parameters });
                assert_eq!(work.evaluations, system.calls, "{}: hidden work", problem.name);
                assert_eq!(work.evaluations, 10 * (work.accepted + work.rejected) + work.accepted + 1);
                assert_eq!((system.kept.len() as u64, work.forced), (work.accepted + 1, 0), "{}", problem.name);
            }
        }
    }
}

#[test]
fn the_spring_takes_this_many_steps() {
    let table = [
        (SolverParameters::new(0.5, 6.0), SolverStats { accepted: 52, rejected: 4, forced: 0, evaluations: 613 }),
        // Each printed point takes a step.
        (
            SolverParameters::new(0.005, 6.0),
            SolverStats { accepted: 1200, rejected: 0, forced: 0, evaluations: 13_201 },
        ),
        // Steps kept against the tolerance are counted.
        (
            SolverParameters::with_fixed_step(1.0, 1.0, 6.0),
            SolverStats { accepted: 6, rejected: 0, forced: 6, evaluations: 67 },
        ),
    ];
    for (parameters, work) in table {
        assert_eq!(run(&SPRING, &parameters).1.work, work);
    }
}

#[test]
fn over_a_jump_that_no_step_can_hide_the_smallest_is_forced() {
    let mut jump = |time: f64, _: &Vector1<f64>| Vector1::new(if time < 0.3 { 0.0 } else { 1e6 });
    let forced = SolverParameters { at_smallest_step: MinStepPolicy::Continue, ..SolverParameters::new(0.25, 1.0) };
    let end = integrate(&mut jump, Vector1::zeros(), &forced, |_| ()).unwrap();
    assert!((end.last.state[0] / 0.7e6 - 1.0).abs() < 1e-8);
    assert!(end.work.forced == 1 && end.work.rejected >= 29, "{:?}", end.work);
}
