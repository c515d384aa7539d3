//! The motion in equal steps of the driver's angle, by Runge and Kutta: the second route to what `motion` integrates.
//!
//! u = θ'² as a function of the angle has twice the acceleration for its derivative.

use super::*;
use geneva_dynamics::Sign;
use geneva_mimic::runge_kutta_step;
use nalgebra::Vector1;
use std::convert::Infallible;

/// The angles of an engagement that starts at entry and lasts for a turn of `reset` radians.
pub fn angles(parameters: &Parameters, reset: f64, steps: u32) -> Vec<f64> {
    let (start, step) = (-parameters.mechanism().engagement_half_angle(), reset / f64::from(steps));
    (0..=steps).map(|k| start + step * f64::from(k)).collect()
}

/// u at these angles, from its value at the first.
pub fn squares(parameters: &Parameters, angles: &[f64], first: f64) -> Vec<f64> {
    squares_along(parameters, angles, first, |angle| angle)
}

/// u where the driver has turned so far, from its value at the first: `engaged` gives the angle of the pin in its slot.
pub fn squares_along(parameters: &Parameters, turned: &[f64], first: f64, engaged: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut squares = vec![first];
    for ends in turned.windows(2) {
        let state = Vector1::new(squares[squares.len() - 1]);
        let rate = |angle: f64, state: &Vector1<f64>| -> Result<_, Infallible> {
            Ok(Vector1::new(slope(parameters, engaged(angle), state[0])))
        };
        let slope = Vector1::new(slope(parameters, engaged(ends[0]), state[0]));
        let Ok(next) = runge_kutta_step(rate, ends[0], ends[1], &state, &slope);
        squares.push(next[0]);
    }
    squares
}

/// du/dθ.
fn slope(parameters: &Parameters, angle: f64, square: f64) -> f64 {
    let terms = parameters.coefficients(angle);
    let speed = square.max(0.0).sqrt();
    2.0 * terms.acceleration_with(&speed, Sign::from_number(terms.sign_switching_function(&speed)))
}

/// Least speed, duration and greatest speed of the engagement that repeats itself, for a torque and a follower of one;
/// none if the steps are too long for the equation.
pub fn cycle(parameters: &Parameters, reset: f64, steps: u32) -> Option<[f64; 3]> {
    let ratio = Inertias::new(parameters.inertias().ratio(), 1.0).ok()?;
    let unit = Parameters::new(parameters.mechanism(), ratio, 1.0, parameters.friction()).ok()?;
    let angles = angles(&unit, reset, steps);
    let squares = repeated(&unit, &angles)?;
    let least = squares.windows(3).map(|w| lowest(w[0], w[1], w[2]));
    let least = squares.iter().copied().chain(least).fold(f64::INFINITY, f64::min);
    // The greatest stands upside down.
    let greatest = squares.windows(3).map(|w| -lowest(-w[0], -w[1], -w[2]));
    let greatest = squares.iter().copied().chain(greatest).fold(0.0, f64::max);
    let found = [least.sqrt(), duration(&unit, &angles, &squares), greatest.sqrt()];
    found.iter().all(|number| number.is_finite()).then_some(found)
}

/// The squares of the engagement that ends as it starts.
///
/// One engagement takes u to nearly a multiple of u and a constant. Two of them tell both, and so what repeats itself.
fn repeated(parameters: &Parameters, angles: &[f64]) -> Option<Vec<f64>> {
    let mut first = 1.0;
    for _ in 0..MOST_TRIALS {
        let squares = squares(parameters, angles, first);
        let once = *squares.last()?;
        if (once - first).abs() <= 1e-12 * first {
            return Some(squares);
        }
        let twice = *self::squares(parameters, angles, once).last()?;
        let (angular_acceleration, next_gain) = (once - first, twice - once);
        first = once + next_gain / (1.0 - next_gain / angular_acceleration);
    }
    None
}

/// Trials until an engagement repeats itself; a handful is enough.
const MOST_TRIALS: u32 = 50;

/// ∫ dθ / √u by Simpson's rule, with u in the middle of a step by the cubic through values and slopes.
fn duration(parameters: &Parameters, angles: &[f64], squares: &[f64]) -> f64 {
    let slopes: Vec<_> = angles.iter().zip(squares).map(|(angle, u)| slope(parameters, *angle, *u)).collect();
    (1..angles.len())
        .map(|k| {
            let (step, a, b) = (angles[k] - angles[k - 1], squares[k - 1], squares[k]);
            let middle = f64::midpoint(a, b) + step / 8.0 * (slopes[k - 1] - slopes[k]);
            step / 6.0 * (1.0 / a.sqrt() + 4.0 / middle.sqrt() + 1.0 / b.sqrt())
        })
        .sum()
}

/// The lowest value of the parabola through three neighbours; the middle one if it is not the lowest of the three.
fn lowest(before: f64, middle: f64, next: f64) -> f64 {
    let bend = before - 2.0 * middle + next;
    if middle < before && middle < next { middle - (next - before) * (next - before) / (8.0 * bend) } else { middle }
}
