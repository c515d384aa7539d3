//! What is lost where the right-hand side jumps: the order falls to one, whichever value is kept.

use crate::problems::KEPT;
use geneva_mimic::{Solution, SolverParameters, SolverStats, StepSolution, integrate};
use nalgebra::{SVector, Vector1, Vector2};
use std::f64::consts::PI;

#[track_caller]
fn run<const D: usize>(
    mut rate: impl FnMut(f64, &SVector<f64, D>) -> SVector<f64, D>,
    start: SVector<f64, D>,
    parameters: &SolverParameters,
) -> Solution<D> {
    integrate(&mut rate, start, parameters, |_| ()).map_err(|error| error.to_string()).expect("no end")
}

fn fixed(kept: StepSolution, steps: f64, end: f64) -> SolverParameters {
    SolverParameters { kept, ..SolverParameters::with_fixed_step(end / steps, end, end) }
}

/// x' = 1 before x = `switch` and 2 after it, from 0. At time 1: 2 − `switch`.
fn speed_up(switch: f64, parameters: &SolverParameters) -> (f64, SolverStats) {
    let end = run(|_, x| Vector1::new(if x[0] < switch { 1.0 } else { 2.0 }), Vector1::zeros(), parameters);
    ((end.last.state[0] - (2.0 - switch)).abs(), end.work)
}

/// x'' = −sign x' on a level floor, from 0 with speed `speed` < 1. At time 1: at rest at speed² / 2.
fn sliding_block(speed: f64, parameters: &SolverParameters) -> f64 {
    let friction = |speed: f64| if speed == 0.0 { 0.0 } else { -speed.signum() };
    let end = run(|_, state| Vector2::new(state[1], friction(state[1])), Vector2::new(0.0, speed), parameters);
    (end.last.state[0] - speed * speed / 2.0).abs()
}

/// Dry friction over the spring constant.
const FRICTION: f64 = 0.0625;

/// x'' = −x − [`FRICTION`] sign x', from 1 at rest. Each swing is a half cosine about a centre on its own side of zero.
fn dry_swing(end: f64, parameters: &SolverParameters) -> f64 {
    let friction = |speed: f64| if speed > 0.0 { -FRICTION } else { FRICTION };
    let run = run(|_, s| Vector2::new(s[1], -s[0] + friction(s[1])), Vector2::new(1.0, 0.0), parameters);
    let swing = (end / PI).floor();
    let side = if swing % 2.0 == 0.0 { 1.0 } else { -1.0 };
    let amplitude = 1.0 - FRICTION - 2.0 * FRICTION * swing;
    let exact = side * (FRICTION + amplitude * libm::cos(end - swing * PI));
    (run.last.state[0] - exact).abs()
}

/// The largest error over places of the switch within a step, times the number of steps.
fn worst(error: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    (0..100).map(|place| error(from + (to - from) * f64::from(place) / 99.6)).fold(0.0, f64::max)
}

/// Order over a number of halvings of the step.
fn order(error: impl Fn(f64) -> f64) -> f64 {
    libm::log2(error(16.0) / error(256.0)) / 4.0
}

#[test]
fn the_order_is_one() {
    for kept in KEPT {
        let orders = [
            order(|steps| worst(|switch| speed_up(switch, &fixed(kept, steps, 1.0)).0, 0.3, 0.6)),
            order(|steps| worst(|speed| sliding_block(speed, &fixed(kept, steps, 1.0)), 0.5, 0.8)),
            order(|steps| worst(|end| dry_swing(end, &fixed(kept, steps, end)), 8.0, 9.0)),
        ];
        for order in orders {
            assert!((order - 1.0).abs() < 0.2, "{kept:?}: {orders:?}");
        }
    }
}

#[test]
fn a_switch_costs_a_third_of_a_step_times_the_jump_and_extrapolation_does_not_help() {
    // A switch in the middle of a step is seen by all four evaluations but the first, or by the last alone: 5/6 or 1/6
    // of the weight, where a half would be right.
    let steps = 64.0;
    let cost = KEPT.map(|kept| steps * worst(|switch| speed_up(switch, &fixed(kept, steps, 1.0)).0, 0.3, 0.6));
    let [full, halves, extrapolated] = cost;
    assert!((full - 1.0 / 3.0).abs() < 0.01, "{cost:?}");
    assert!((halves - 1.0 / 6.0).abs() < 0.01, "{cost:?}");
    assert!(extrapolated > halves, "{cost:?}");
}

#[test]
fn the_tolerance_holds_at_a_switch_and_a_few_dozen_refusals_pay_for_it() {
    for tolerance in [1e-4, 5e-6, 1e-7] {
        for kept in KEPT {
            let parameters =
                SolverParameters { kept, relative_tolerance: tolerance, ..SolverParameters::new(0.125, 1.0) };
            let error = worst(|switch| speed_up(switch, &parameters).0, 0.3, 0.6);
            let refused = (0..100).map(|place| speed_up(0.3 + 0.003 * f64::from(place), &parameters).1.rejected).max();
            assert!(error < 1.5 * tolerance, "{kept:?} at {tolerance}: {error}");
            assert!(refused.is_some_and(|refused| (10..40).contains(&refused)), "{refused:?}");
        }
    }
}
