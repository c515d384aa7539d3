//! Two routes through time: a library's integrators with located switches, and steps that halve until they fit.
//!
//! Neither knows the angle ψ, the switch's formula u = Q or the terminal speed: they have the acceleration of
//! [`Parameters`] alone, and the first the sign with which it is to be taken.

use super::{escapement, samples};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Parameters, Sign};
use geneva_kinematics::Mechanism;
use geneva_mimic::{MinStepPolicy, StepSolution};
use nalgebra::Vector2;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, System};

/// θ and θ', with one sign of the friction.
struct Driver<'a> {
    escapement: &'a Parameters,
    sign: Sign,
}

impl Driver<'_> {
    fn acceleration(&self, state: &Vector2<f64>) -> f64 {
        self.escapement.coefficients(state[0]).acceleration_with(&state[1], self.sign)
    }
}

impl System<f64, Vector2<f64>> for Driver<'_> {
    fn system(&self, _: f64, state: &Vector2<f64>, rates: &mut Vector2<f64>) {
        *rates = Vector2::new(state[1], self.acceleration(state));
    }
}

const TOLERANCE: f64 = 1e-14;

/// The state after a time.
fn after(escapement: &Parameters, sign: Sign, state: Vector2<f64>, time: f64, eight: bool) -> Vector2<f64> {
    if time == 0.0 {
        return state;
    }
    let driver = Driver { escapement, sign };
    macro_rules! run {
        ($solver:ident) => {{
            let mut solver = $solver::new(driver, 0.0, time, time, state, TOLERANCE, TOLERANCE);
            solver.set_output(OutputType::Sparse);
            solver.integrate().expect("a smooth problem");
            *solver.y_out().last().expect("an end")
        }};
    }
    if eight { run!(Dop853) } else { run!(Dopri5) }
}

/// Where a function of the state changes its sign within a time, by the chord: state and time.
fn event(
    from: Vector2<f64>,
    span: f64,
    go: impl Fn(Vector2<f64>, f64) -> Vector2<f64>,
    of: impl Fn(&Vector2<f64>) -> f64,
) -> (Vector2<f64>, f64) {
    let (mut low, mut high) = (0.0, span);
    let (mut low_value, mut high_value) = (of(&from), of(&go(from, span)));
    // Regula falsi in the Illinois manner.
    let (mut side, mut last) = (0, f64::INFINITY);
    loop {
        let middle = (low * high_value - high * low_value) / (high_value - low_value);
        let state = go(from, middle);
        let value = of(&state);
        if value == 0.0 || (middle - last).abs() <= 1e-15 * span {
            return (state, middle);
        }
        last = middle;
        if (value > 0.0) == (high_value > 0.0) {
            (high, high_value) = (middle, value);
            low_value /= if side == 1 { 2.0 } else { 1.0 };
            side = 1;
        } else {
            (low, low_value) = (middle, value);
            high_value /= if side == -1 { 2.0 } else { 1.0 };
            side = -1;
        }
    }
}

/// What the other route finds over one engagement.
struct Found {
    end: f64,
    duration: f64,
    peak: f64,
    minimum: f64,
    reversal: Option<f64>,
}

fn integrate(engagement: &Engagement, entry: f64, eight: bool) -> Found {
    let escapement = engagement.parameters();
    let half = escapement.mechanism().engagement_half_angle();
    let end = engagement.reset() - half;
    let mut state = Vector2::new(-half, entry);
    let mut found = Found { end: entry, duration: 0.0, peak: entry, minimum: entry, reversal: None };
    for (leg, sign) in [Sign::Minus, Sign::Plus, Sign::Minus].into_iter().enumerate() {
        let go = |state: Vector2<f64>, time: f64| after(escapement, sign, state, time, eight);
        let over = |state: &Vector2<f64>| -> f64 {
            let past = state[0] - end;
            match leg {
                0 => past.max(state[0]),
                1 => past.max(-escapement.coefficients(state[0]).sign_switching_function(&state[1])),
                _ => past,
            }
        };
        let rising = |state: &Vector2<f64>| Driver { escapement, sign }.acceleration(state);
        if leg == 1 && end <= 0.0 {
            break;
        }
        if leg == 1 {
            // On the line of centres all are zero: a little beyond, so that a change of sign is one.
            let (step, time) = (go(state, 1e-4 / state[1]), 1e-4 / state[1]);
            state = step;
            found.duration += time;
        }
        while over(&state) < 0.0 {
            let mut span = 0.02 / (state[1] + 0.1);
            let mut next = go(state, span);
            let done = over(&next) >= 0.0;
            if done {
                (next, span) = event(state, span, go, over);
            }
            if (rising(&state) > 0.0) != (rising(&next) > 0.0) {
                let speed = event(state, span, go, rising).0[1];
                found.peak = found.peak.max(speed);
                found.minimum = found.minimum.min(speed);
            }
            found.duration += span;
            state = next;
            if done {
                break;
            }
        }
        if leg == 1 && state[0] < end - 1e-9 {
            found.reversal = Some(state[0]);
        }
    }
    found.end = state[1];
    found.peak = found.peak.max(state[1]);
    found.minimum = found.minimum.min(state[1]);
    found
}

#[track_caller]
fn agree(name: &str, one: f64, other: f64, bound: f64, worst: &mut f64) {
    let error = (one / other - 1.0).abs();
    *worst = worst.max(error);
    assert!(error <= bound, "{name}: {one} and {other}, {error:e}");
}

#[test]
fn integrators_with_located_switches_agree() {
    for eight in [false, true] {
        let mut worst = 0.0;
        for engagement in samples().iter().step_by(if eight { 1 } else { 5 }) {
            let steady = engagement.steady_state().expect("a terminal speed");
            let found = integrate(engagement, steady.entry_speed, eight);
            let bound = 1e-12;
            agree("end", found.end, steady.entry_speed, bound, &mut worst);
            agree("peak", found.peak, steady.peak.speed, bound, &mut worst);
            agree("minimum", found.minimum, steady.minimum.speed, bound, &mut worst);
            agree("period", found.duration, steady.period, bound, &mut worst);
            assert_eq!(found.reversal.is_some(), steady.reversal_angle.is_some());
            if let (Some(found), Some(reversal)) = (found.reversal, steady.reversal_angle) {
                agree("switch", found, reversal, bound, &mut worst);
            }
        }
        println!("worst relative difference: {worst:e}");
    }
}

#[test]
fn a_run_in_small_steps_from_rest_prints_the_same() {
    for mechanism in Mechanism::ALL {
        let escapement = escapement(mechanism, 0.07, if mechanism == Mechanism::SIX_PIN { 0.21 } else { 0.33 });
        let natural = 2.0 * mechanism.engagement_half_angle();
        for reset in [natural, natural * 1.2] {
            let engagement = Engagement::reset_after(&escapement, reset, 1e-12).expect("a reset angle in range");
            let lines = engagement.run(0.125, 8.0).expect("a run");
            let half = natural / 2.0;
            let mut rates = |_: f64, state: &Vector2<f64>| {
                let angle = state[0] - (state[0] / reset).floor() * reset - half;
                let angular_acceleration = escapement.acceleration(angle, state[1].max(0.0)).expect("one acceleration");
                Vector2::new(state[1], angular_acceleration.value)
            };
            let parameters = geneva_mimic::SolverParameters {
                relative_tolerance: 1e-12,
                kept: StepSolution::Extrapolated,
                smallest_step: 1e-13,
                // Of several steps that miss a switch by themselves none may pass for exact.
                largest_step: 1.0 / 1024.0,
                initial_step: 1.0 / 1024.0,
                at_smallest_step: MinStepPolicy::Continue,
                ..geneva_mimic::SolverParameters::new(0.125, 8.0)
            };
            let (mut worst, mut number) = (0.0_f64, 0);
            geneva_mimic::integrate(&mut rates, Vector2::zeros(), &parameters, |point| {
                let line = &lines[number];
                assert_eq!(line.time, point.time);
                worst = worst.max((line.turned - point.state[0]).abs() / (1.0 + line.turned));
                worst = worst.max((line.speed - point.state[1]).abs() / (1.0 + line.speed));
                number += 1;
            })
            .expect("a run");
            println!("{mechanism:?} {reset}: {worst:e} over {number} lines");
            assert_eq!(number, lines.len());
            assert!(worst < 2e-11, "{mechanism:?} {reset}: {worst:e}");
        }
    }
}
