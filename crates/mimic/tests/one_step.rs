//! Is one step the classical one, when does it ask the system, and what does a run make of its two results?

use geneva_mimic::{
    Cause, EarlyStop, IntegrationError, MinStepPolicy, Solution, SolverParameters, StepSolution, System, integrate,
    runge_kutta_step,
};
use nalgebra::{SVector, Vector1, Vector2, Vector3};
use std::convert::Infallible;

type Rate<const D: usize> = Result<SVector<f64, D>, Infallible>;

#[test]
fn a_step_over_a_cubic_in_time_is_exact_and_over_a_quartic_is_not() {
    let cubic = |t: f64, _: &Vector1<f64>| -> Rate<1> { Ok(Vector1::new(4.0 * t * t * t - 6.0 * t)) };
    let end = runge_kutta_step(cubic, 1.0, 3.0, &Vector1::new(-2.0), &Vector1::new(-2.0)).unwrap();
    assert_eq!(end[0], 54.0);
    // Simpson's rule: 2/6 (1 + 4 * 16 + 81) for 1/5 (243 - 1).
    let quartic = |t: f64, _: &Vector1<f64>| -> Rate<1> { Ok(Vector1::new(t * t * t * t)) };
    let end = runge_kutta_step(quartic, 1.0, 3.0, &Vector1::zeros(), &Vector1::new(1.0)).unwrap();
    assert!((end[0] - 146.0 / 3.0).abs() < 1e-13);
}

#[test]
fn a_step_of_growth_is_the_exponential_series_to_the_fourth_power() {
    let growth = |_: f64, x: &Vector1<f64>| -> Rate<1> { Ok(*x) };
    let end = runge_kutta_step(growth, 0.0, 0.5, &Vector1::new(1.0), &Vector1::new(1.0)).unwrap();
    let series = 1.0 + 1.0 / 2.0 + 1.0 / 8.0 + 1.0 / 48.0 + 1.0 / 384.0;
    assert!((end[0] - series).abs() < 1e-15, "{end}");
}

/// A rate that writes down when it is asked for at trial points, and fails beyond a time.
struct Asked<F> {
    rate: F,
    times: Vec<f64>,
    fails_beyond: f64,
}

impl<const D: usize, F: Fn(&SVector<f64, D>) -> SVector<f64, D>> System<D> for Asked<F> {
    type Fault = f64;

    fn derivative(&mut self, time: f64, state: &SVector<f64, D>) -> Result<SVector<f64, D>, f64> {
        self.times.push(time);
        if time > self.fails_beyond { Err(time) } else { Ok((self.rate)(state)) }
    }

    fn kept_derivative(&mut self, _: f64, state: &SVector<f64, D>) -> Result<SVector<f64, D>, f64> {
        Ok((self.rate)(state))
    }
}

#[test]
fn an_attempt_asks_at_the_quarters_and_hands_on_a_fault() {
    let rate = |x: &Vector2<f64>| Vector2::new(x[1], -x[0]);
    let mut asked = Asked { rate, times: Vec::new(), fails_beyond: f64::INFINITY };
    integrate(&mut asked, Vector2::new(1.0, 0.0), &SolverParameters::with_fixed_step(4.0, 4.0, 8.0), |_| ()).unwrap();
    assert_eq!(asked.times[..10], [2.0, 2.0, 4.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0]);
    assert_eq!(asked.times[10..], [6.0, 6.0, 8.0, 5.0, 5.0, 6.0, 6.0, 7.0, 7.0, 8.0]);
    let mut faulty = Asked { rate: |x: &Vector1<f64>| *x, times: Vec::new(), fails_beyond: 1.7 };
    let ended = integrate(&mut faulty, Vector1::new(1.0), &SolverParameters::with_fixed_step(1.0, 1.0, 2.0), |_| ());
    let Err(IntegrationError::EarlyStop(stopped)) = ended else { panic!("{ended:?}") };
    assert_eq!((stopped.time, stopped.cause), (1.0, Cause::System(2.0)));
}

/// A system whose only step, of length 12 from zero, has these two results.
struct Scripted<const D: usize> {
    full: SVector<f64, D>,
    halves: SVector<f64, D>,
    asked: u32,
}

impl<const D: usize> System<D> for Scripted<D> {
    type Fault = Infallible;

    fn derivative(&mut self, _: f64, _: &SVector<f64, D>) -> Rate<D> {
        self.asked += 1;
        // The rate at the end counts a sixth of the step: of the whole one 2, of the second half 1.
        Ok(match self.asked {
            3 => self.full / 2.0,
            10 => self.halves,
            _ => SVector::zeros(),
        })
    }

    fn kept_derivative(&mut self, _: f64, _: &SVector<f64, D>) -> Rate<D> {
        Ok(SVector::zeros())
    }
}

/// The one step of a scripted system, from zero.
fn scripted<const D: usize>(
    full: SVector<f64, D>,
    halves: SVector<f64, D>,
    change: impl FnOnce(&mut SolverParameters),
) -> Result<Solution<D>, EarlyStop<D, Infallible>> {
    let mut parameters = SolverParameters::with_fixed_step(12.0, 12.0, 12.0);
    change(&mut parameters);
    let ended = integrate(&mut Scripted { full, halves, asked: 0 }, SVector::zeros(), &parameters, |_| ());
    ended.map_err(|error| match error {
        IntegrationError::EarlyStop(stopped) => stopped,
        IntegrationError::Parameter(error) => panic!("{error}"),
    })
}

/// The difference of two results over what is allowed, as the refusal of the step says it; none if the step is kept.
#[track_caller]
fn excess<const D: usize>(full: SVector<f64, D>, halves: SVector<f64, D>, tolerance: f64, floor: f64) -> Option<f64> {
    let ended = scripted(full, halves, |parameters| {
        parameters.at_smallest_step = MinStepPolicy::Stop;
        (parameters.relative_tolerance, parameters.absolute_floor) = (tolerance, floor);
    });
    match ended {
        Ok(_) => None,
        Err(EarlyStop { cause: Cause::StepUnderflow { excess, .. }, .. }) => Some(excess),
        Err(stopped) => panic!("{stopped}"),
    }
}

#[test]
fn the_excess_is_relative_above_the_floor_and_absolute_below() {
    // The third component agrees, and is so large that no floor of these is cut to the size of what there is.
    let (full, halves) = (Vector3::new(8.5, 0.0, 16.0), Vector3::new(8.0, 0.25, 16.0));
    assert_eq!(excess(full, halves, 0.125, 0.0), Some(8.0), "the second component: all of it");
    // A quarter over an eighth of four, and a half over an eighth of eight: half of what is allowed.
    assert_eq!(excess(full, halves, 0.125, 4.0), None);
    assert_eq!(excess(full, halves, 0.125 / 16.0, 4.0), Some(16.0 * 0.5));
    assert_eq!(excess(full, halves, 0.125, 16.0), None);
    assert_eq!(excess(full, halves, 0.125 / 16.0, 16.0), Some(16.0 * 0.25));
    assert_eq!(excess(Vector1::zeros(), Vector1::zeros(), 1e-300, 0.0), None);
    let (full, halves) = (Vector1::new(-f64::MAX), Vector1::new(f64::MAX));
    assert_eq!(excess(full, halves, 0.5, 1.0), Some(f64::INFINITY));
}

#[test]
fn each_state_that_can_be_kept_is_its_own() {
    let kept = [StepSolution::FullStep, StepSolution::TwoHalfSteps, StepSolution::Extrapolated].map(|kept| {
        let end = scripted(Vector1::new(1.0), Vector1::new(16.0), |parameters| parameters.kept = kept);
        end.unwrap().last.state[0]
    });
    assert_eq!(kept, [1.0, 16.0, 17.0]);
}
