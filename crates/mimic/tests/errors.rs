//! What cannot be integrated: is it reported, with the place, and without a panic?

use geneva_mimic::{
    AllowedRange, Cause, EarlyStop, IntegrationError, MOST_STEPS, MinStepPolicy, ParameterError, Solution,
    SolverParameters, SolverQuantity, integrate,
};
use nalgebra::{Vector1, Vector2};
use std::convert::Infallible;

type Ended = Result<Solution<1>, IntegrationError<1, Infallible>>;

fn run(mut rate: impl FnMut(f64, f64) -> f64, start: f64, parameters: &SolverParameters) -> Ended {
    let mut rate = |time: f64, state: &Vector1<f64>| Vector1::new(rate(time, state[0]));
    integrate(&mut rate, Vector1::new(start), parameters, |_| ())
}

#[track_caller]
fn stopped(rate: impl FnMut(f64, f64) -> f64, start: f64, parameters: &SolverParameters) -> EarlyStop<1, Infallible> {
    match run(rate, start, parameters) {
        Err(IntegrationError::EarlyStop(stopped)) => stopped,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_solution_that_blows_up_is_followed_to_its_pole() {
    for start in [1.0, 0.5, 8.0] {
        let parameters = SolverParameters::new(0.125, 3.0);
        let stop = stopped(|_, x| x * x, start, &parameters);
        assert!((stop.time * start - 1.0).abs() < 5e-6, "from {start}: {stop}");
        assert!(stop.state[0] > 1e6 && stop.state[0].is_finite(), "from {start}: {stop}");
        let Cause::StepUnderflow { step, smallest_step, excess } = stop.cause else { panic!("{stop}") };
        assert!(excess > 1.0 && step <= smallest_step * 1.000_001 && smallest_step == parameters.smallest_step);
        let work = stop.work;
        assert_eq!(work.evaluations, 10 * (work.accepted + work.rejected) + work.accepted + 1);
        let message = stop.to_string();
        for part in [&format!("{:?}", stop.time), "in state [", "must be at least", "look for a singularity"] {
            assert!(message.contains(part), "{part} is not in: {message}");
        }
    }
}

#[test]
fn what_is_no_number_is_named_where_it_is() {
    let stop = stopped(|_, _| f64::NAN, 2.0, &SolverParameters::new(1.0, 1.0));
    let Cause::NonFinite { quantity: SolverQuantity::Derivative, component: 0, value } = stop.cause else {
        panic!("{stop}")
    };
    assert!(value.is_nan() && (stop.time, stop.state[0]) == (0.0, 2.0));
    assert!(stop.to_string().contains("component 0 of the derivative there is NaN"), "{stop}");
    // From time 1 on there is no root; to go on all the same is no help against what is no number.
    for at_smallest_step in [MinStepPolicy::Stop, MinStepPolicy::Continue] {
        let parameters = SolverParameters { at_smallest_step, ..SolverParameters::new(0.3, 2.0) };
        let stop = stopped(|time, _| (1.0 - time).sqrt(), 0.0, &parameters);
        assert!((stop.time - 1.0).abs() < 1e-8 && (stop.state[0] - 2.0 / 3.0).abs() < 1e-4, "{stop}");
        assert!(matches!(stop.cause, Cause::NonFinite { quantity: SolverQuantity::State, .. }), "{stop}");
    }
    let mut rate = |_: f64, state: &Vector2<f64>| *state;
    let ended = integrate(&mut rate, Vector2::new(0.0, f64::INFINITY), &SolverParameters::new(1.0, 1.0), |_| ());
    let Err(IntegrationError::EarlyStop(stop)) = ended else { panic!("{ended:?}") };
    let infinite = f64::INFINITY;
    assert_eq!(stop.cause, Cause::NonFinite { quantity: SolverQuantity::Start, component: 1, value: infinite });
    assert_eq!(stop.work.evaluations, 0);
    assert!(stop.to_string().contains("component 1 of the start is inf"), "{stop}");
}

#[test]
fn growth_without_bound_ends_where_numbers_end() {
    let parameters = SolverParameters { relative_tolerance: 0.5, ..SolverParameters::new(1.0, 1e4) };
    let stop = stopped(|_, x| 1e3 * x, 1.0, &parameters);
    assert!((stop.time - 0.7097).abs() < 0.01 && stop.state[0] > 1e300, "{stop}");
}

#[test]
fn the_number_of_steps_is_bounded() {
    let parameters = SolverParameters { most_steps: 100, ..SolverParameters::with_fixed_step(0.001, 1.0, 1.0) };
    let stop = stopped(|_, _| 1.0, 0.0, &parameters);
    assert_eq!((stop.cause, stop.work.accepted), (Cause::TooManySteps { most_steps: 100 }, 100));
    assert!((stop.time - 0.1).abs() < 1e-12 && stop.to_string().contains("100 steps"), "{stop}");
    let Err(ParameterError::PrintedPoints { points, .. }) = SolverParameters::new(1e-9, 1.0).check() else {
        panic!("a thousand million points")
    };
    assert!((points / 1e9 - 1.0).abs() < 1e-9);
}

#[test]
fn steps_that_do_not_move_the_time_are_an_underflow() {
    let tiny = SolverParameters { smallest_step: 1e-300, initial_step: 1e-300, ..SolverParameters::new(1.0, 1.0) };
    let jump = |time: f64, _| if time < 0.3 { 0.0 } else { 1e300 };
    let stop = stopped(jump, 0.0, &SolverParameters { initial_step: 1.0, ..tiny });
    assert!(matches!(stop.cause, Cause::StepUnderflow { smallest_step: 1e-300, .. }), "{stop}");
    assert!((stop.time - 0.3).abs() < 1e-15, "{stop}");
    // From time 0 the smallest of steps can be made, and grow.
    assert!(run(|_, x| -x, 1.0, &tiny).is_ok());
}

#[test]
fn each_parameter_outside_its_range_is_named_with_the_range() {
    type Set = fn(&mut SolverParameters, f64);
    let parameters: [(&str, Set, &[f64], &str); 10] = [
        ("print_interval", |p, x| p.print_interval = x, &[0.0, -1.0], "positive and finite"),
        ("run_length", |p, x| p.run_length = x, &[0.0, -1.0], "positive and finite"),
        ("relative_tolerance", |p, x| p.relative_tolerance = x, &[0.0, -1.0, 1.0], "above 0.0 and below 1.0"),
        ("absolute_floor", |p, x| p.absolute_floor = x, &[-1.0], "at least 0.0 and finite"),
        ("growth_below", |p, x| p.growth_below = x, &[-0.5, 1.5], "from 0.0 to 1.0"),
        ("growth_factor", |p, x| p.growth_factor = x, &[0.0, 0.5], "at least 1.0 and finite"),
        ("shrink_factor", |p, x| p.shrink_factor = x, &[0.0, 1.0, -0.5], "above 0.0 and below 1.0"),
        ("smallest_step", |p, x| p.smallest_step = x, &[0.0, -1.0], "positive and finite"),
        ("largest_step", |p, x| p.largest_step = x, &[0.0, 1e-12], "at least 2.3283064365386963e-10 and finite"),
        ("initial_step", |p, x| p.initial_step = x, &[0.0, 1e-12, 0.5], "to 0.25"),
    ];
    for (name, set, values, range) in parameters {
        for &value in values.iter().chain(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]) {
            let mut parameters = SolverParameters::new(0.25, 1.0);
            set(&mut parameters, value);
            let ended = run(|_, _| panic!("{name} {value} is run"), 1.0, &parameters);
            let Err(IntegrationError::Parameter(error)) = ended else { panic!("{name} {value}: {ended:?}") };
            let message = error.to_string();
            assert!(message.starts_with(&format!("{name} {value:?}: ")) && message.contains(range), "{message}");
        }
    }
    for most_steps in [0, MOST_STEPS + 1] {
        let error = SolverParameters { most_steps, ..SolverParameters::new(0.25, 1.0) }.check();
        assert_eq!(error, Err(ParameterError::MostSteps(most_steps)));
    }
    assert!(SolverParameters { most_steps: MOST_STEPS, ..SolverParameters::new(0.25, 1.0) }.check().is_ok());
    assert!(!AllowedRange::Positive.includes(f64::INFINITY));
}

#[test]
fn no_input_makes_it_panic_or_go_on_for_ever() {
    let sizes = [f64::NAN, 0.0, -1.0, 5e-324, 1e-300, 1e-9, 0.3, 1.0, 1e9, 1e300, f64::MAX, f64::INFINITY];
    let rates: [fn(f64, f64) -> f64; 4] = [|_, x| x * x, |t, _| 1.0 / (t - 0.3), |_, x| -1e300 * x, |_, x| (-x).sqrt()];
    let cases = sizes.iter().flat_map(|print| sizes.iter().flat_map(move |length| sizes.map(|x| (*print, *length, x))));
    let (mut ended, mut runs) = (0, 0);
    for (print_interval, run_length, other) in cases {
        let usual = SolverParameters { most_steps: 60, ..SolverParameters::new(print_interval, run_length) };
        let variants = [
            SolverParameters { relative_tolerance: other, ..usual },
            SolverParameters { absolute_floor: other, relative_tolerance: 1e-300, ..usual },
            SolverParameters { smallest_step: other, largest_step: f64::MAX, initial_step: f64::MAX, ..usual },
            SolverParameters { growth_factor: other, shrink_factor: f64::MIN_POSITIVE, ..usual },
            SolverParameters { most_steps: 60, ..SolverParameters::with_fixed_step(other, print_interval, run_length) },
        ];
        for (rate, parameters) in rates.into_iter().flat_map(|rate| variants.map(|variant| (rate, variant))) {
            runs += 1;
            match run(rate, other, &parameters) {
                Ok(_) => ended += 1,
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
    assert!(ended > 1000 && ended < runs / 2, "{ended} of {runs}");
}
