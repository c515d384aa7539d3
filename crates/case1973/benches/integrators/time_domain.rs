//! Dormand and Prince's methods of `ode_solvers`, as one would use them at first, and with the switches located.
//!
//! Both systems are autonomous: the library's method of order eight is not right for a right-hand side with the time.

use crate::race::{ReferenceRun, SolverAnswer, TIMES};
use geneva_dynamics::{Parameters, Sign};
use nalgebra::Vector2;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, System};

/// Turned angle and θ', with the reset angle and the exact sign on the right-hand side.
struct Naive<'a> {
    escapement: &'a Parameters,
}

impl System<f64, Vector2<f64>> for Naive<'_> {
    fn system(&self, _: f64, state: &Vector2<f64>, rates: &mut Vector2<f64>) {
        let half = self.escapement.mechanism().engagement_half_angle();
        let angle = state[0] - (state[0] / (2.0 * half)).floor() * (2.0 * half) - half;
        let angular_acceleration = self
            .escapement
            .acceleration(angle, state[1].max(0.0))
            .map_or(f64::NAN, |angular_acceleration| angular_acceleration.value);
        *rates = Vector2::new(state[1], angular_acceleration);
    }
}

/// θ and θ' with one sign.
struct Signed<'a> {
    escapement: &'a Parameters,
    sign: Sign,
}

impl System<f64, Vector2<f64>> for Signed<'_> {
    fn system(&self, _: f64, state: &Vector2<f64>, rates: &mut Vector2<f64>) {
        let angular_acceleration = self.escapement.coefficients(state[0]).acceleration_with(&state[1], self.sign);
        *rates = Vector2::new(state[1], angular_acceleration);
    }
}

macro_rules! naive {
    ($solver:ident, $row:ident, $tolerance:ident) => {{
        let system = Naive { escapement: &$row.escapement };
        let (duration, interval) = ($row.duration, $row.interval);
        // Half an interval more than asked for: the library takes a line at the very end from a step too early.
        let end = duration + interval / 2.0;
        let mut solver = $solver::new(system, 0.0, end, interval, Vector2::zeros(), $tolerance, $tolerance);
        let stats = solver.integrate().ok()?;
        let numbers = solver.y_out().iter().skip(1).take(TIMES).map(|state| state[1]).collect();
        Some(SolverAnswer { numbers, evaluations: Some(u64::from(stats.num_eval)) })
    }};
}

/// Order five, one integration over the whole run.
pub(crate) fn dopri5(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    naive!(Dopri5, row, tolerance)
}

/// Order eight, one integration over the whole run.
pub(crate) fn dop853(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    naive!(Dop853, row, tolerance)
}

/// The state after a time with one sign, and the evaluations.
type Go = fn(&Parameters, Sign, Vector2<f64>, f64, f64) -> Option<(Vector2<f64>, u64)>;

macro_rules! go {
    ($solver:ident) => {
        |escapement, sign, state, time, tolerance| {
            let system = Signed { escapement, sign };
            let mut solver = $solver::new(system, 0.0, time, time, state, tolerance, tolerance);
            solver.set_output(OutputType::Sparse);
            let stats = solver.integrate().ok()?;
            Some((*solver.y_out().last()?, u64::from(stats.num_eval)))
        }
    };
}

/// Order five, from switch to switch.
pub(crate) fn dopri5_located(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    located(row, tolerance, go!(Dopri5))
}

/// Order eight, from switch to switch.
pub(crate) fn dop853_located(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    located(row, tolerance, go!(Dop853))
}

/// A run from line to line, which stops where the sign changes and where the next pin takes over.
fn located(row: &ReferenceRun, tolerance: f64, go: Go) -> Option<SolverAnswer> {
    let escapement = &row.escapement;
    let half = escapement.mechanism().engagement_half_angle();
    let mut answer = SolverAnswer { numbers: Vec::with_capacity(TIMES), evaluations: Some(0) };
    let (mut state, mut leg, mut since) = (Vector2::new(-half, 0.0), 0, 0.0);
    let mut evaluations = 0;
    while answer.numbers.len() < TIMES {
        let sign = if leg == 1 { Sign::Plus } else { Sign::Minus };
        let mut advance = |time: f64| {
            let (next, count) = go(escapement, sign, state, time, tolerance)?;
            evaluations += count;
            Some(next)
        };
        // Positive when the leg is over.
        let over = |state: &Vector2<f64>| match leg {
            0 => state[0],
            1 => {
                let (pose, inertia) = (escapement.pose(state[0]), escapement.inertias().ratio());
                let square = state[1] * state[1];
                -(inertia * pose.acceleration_ratio() * square + pose.velocity_ratio() * escapement.drive())
            }
            _ => state[0] - half,
        };
        let whole = row.interval - since;
        let next = advance(whole)?;
        if over(&next) < 0.0 {
            answer.numbers.push(next[1]);
            (state, since) = (next, 0.0);
            continue;
        }
        // The chord in the Illinois manner, each time from the last stop.
        let (mut low, mut high) = ((0.0, over(&state)), (whole, over(&next)));
        let (mut found, mut side) = ((next, whole), 0);
        for _ in 0..60 {
            let middle = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let moved = (middle - found.1).abs();
            let there = advance(middle)?;
            found = (there, middle);
            let value = over(&there);
            if value == 0.0 || moved <= 0.1 * tolerance * whole {
                break;
            }
            if value > 0.0 {
                high = (middle, value);
                low.1 /= if side == 1 { 2.0 } else { 1.0 };
                side = 1;
            } else {
                low = (middle, value);
                high.1 /= if side == -1 { 2.0 } else { 1.0 };
                side = -1;
            }
        }
        (state, since) = (found.0, since + found.1);
        // The place is known better than it was found.
        match leg {
            0 => state[0] = 0.0,
            1 => {}
            _ => state[0] = -half,
        }
        leg = (leg + 1) % 3;
    }
    answer.evaluations = Some(evaluations);
    Some(answer)
}
