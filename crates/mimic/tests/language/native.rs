//! The escapement's deck written in Rust: what the compiler of decks is measured against.

use geneva_mimic::{DelayError, DelayLine, Extrapolation, Interpolation, MinStepPolicy, SolverParameters, System};
use nalgebra::Vector2;
use std::cell::Cell;
use std::rc::Rc;

/// What the deck computes at an instant, in the order of its cards.
pub(crate) struct Escapement {
    data: [f64; 6],
    line: Box<DelayLine<16_384>>,
    follower: f64,
    /// What the follower's speed was at the last kept point.
    kept: Rc<Cell<[f64; 2]>>,
}

impl System<2> for Escapement {
    type Fault = DelayError;

    fn derivative(&mut self, time: f64, state: &Vector2<f64>) -> Result<Vector2<f64>, DelayError> {
        let [slots, start, mu, torque, follower, driver] = self.data;
        let pi = 4.0 * libm::atan(1.0);
        let lambda = 1.0 / libm::sin(pi / slots);
        let angle = libm::fmod(state[1], -2.0 * start) + start;
        let numerator = lambda * libm::cos(angle) - 1.0;
        let cross = lambda * libm::sin(angle);
        let square = 1.0 + lambda * lambda - 2.0 * lambda * libm::cos(angle);
        let ratio = numerator / square;
        let change = cross * (1.0 - lambda * lambda) / (square * square);
        let slide = cross / square;
        let follower_acceleration = change * state[0] * state[0] + ratio * self.line.value(time)?;
        let sign = if slide * follower_acceleration < 0.0 { -1.0 } else { 1.0 };
        let arm = ratio + sign * mu * slide;
        let (drive, inertia) = (torque / follower, driver / follower);
        self.follower = ratio * state[0];
        let acceleration = if time <= 0.0 {
            drive / (inertia + ratio * ratio + (mu * slide * ratio).abs())
        } else {
            (drive - arm * change * (state[0] * state[0])) / (inertia + arm * ratio)
        };
        Ok(Vector2::new(acceleration, state[0]))
    }

    fn accepted(&mut self, time: f64, _: &Vector2<f64>, rate: &Vector2<f64>) -> Result<(), DelayError> {
        self.kept.set([rate[0], self.follower]);
        self.line.record(time, rate[0])
    }
}

impl Escapement {
    /// With the numbers of a data card, and where the accelerations and the follower's speeds of kept points go.
    pub(crate) fn new(data: [f64; 6], kept: Rc<Cell<[f64; 2]>>) -> Self {
        let line = DelayLine::new(INTERVAL / 10.0, 0.0, Interpolation::Linear, Extrapolation::Hold);
        Self { data, line: Box::new(line.expect("a line")), follower: 0.0, kept }
    }
}

/// The deck's print interval.
const INTERVAL: f64 = 5e-4;

/// The integrator as the deck uses it.
pub(crate) fn parameters() -> SolverParameters {
    SolverParameters { at_smallest_step: MinStepPolicy::Continue, ..SolverParameters::new(INTERVAL, 0.2) }
}
