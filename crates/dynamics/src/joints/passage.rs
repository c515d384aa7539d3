//! The motion over one engagement, in equal steps of the driver's angle.
//!
//! u = θ'² has the slope 2 θ'' over the angle. On one flank, with the sliding one way, everything is smooth, so that
//! the classical step of Runge and Kutta keeps its fourth order. The two angles at which the sliding can turn are ends
//! of steps. Where the pin changes its flank, the step is cut in two: the place is found by bisection with the step
//! itself. With u go the logarithm of how much a small difference of two motions shrinks, the time, and the work of
//! friction. Two changes of the flank within one step would be missed.

use super::equation::{Escapement, JointMotion, Power};
use crate::DynamicsError;
use crate::Sign;
use crate::steady::Extreme;
use geneva_kinematics::bisection::bisect_times;
use geneva_mimic::runge_kutta_step;
use nalgebra::SVector;
use std::ops::RangeInclusive;

/// Numbers of steps into which an engagement can be divided.
pub const STEPS: RangeInclusive<u32> = 16..=65_536;

/// Most changes of the flank that are looked for within one step.
const MOST_CHANGES: usize = 4;

/// u, ln of the shrinking, time, and work in the slot, in the driver's and in the follower's bearing.
type State = SVector<f64, 6>;

/// One engagement, from entry to exit. Speeds are the driver's.
///
/// ```
/// use geneva_dynamics::joints::{Escapement, Joints};
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let passage = Escapement::new(&timer, Joints { pin_radius: 0.1, ..Joints::IDEAL })?.passage(1.0, 1024)?;
/// // What friction leaves of the work goes into the driver, as the follower is at rest at both ends.
/// let gain = 2.0 * (passage.exit_speed.powi(2) - passage.entry_speed.powi(2)) / 2.0;
/// assert!((passage.work.growth() - gain).abs() < 1e-9);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JointPassage {
    /// θ' at entry, in radians per unit of time.
    pub entry_speed: f64,
    /// θ' at exit, in radians per unit of time.
    pub exit_speed: f64,
    /// Factor by which the engagement reduces a small difference of the squares of two entry speeds, dimensionless.
    pub multiplier: f64,
    /// Time from entry to exit, in units of time.
    pub duration: f64,
    /// 2π/m over the duration, in radians per unit of time.
    pub mean_speed: f64,
    /// Greatest speed.
    pub peak: Extreme,
    /// Least speed.
    pub minimum: Extreme,
    /// Crank angles in radians from the line of centres at which the pin changes its flank, in order.
    pub changes: Vec<f64>,
    /// Work over the engagement: of the spring, and of friction in the three places.
    pub work: Power,
}

/// A part of the engagement within which the sliding has one sense on either flank.
struct SlidingInterval {
    start: f64,
    end: f64,
    leading: Sign,
    trailing: Sign,
}

/// A node, with the slope of the state on the side of the step that it belongs to.
struct StepNode {
    angle: f64,
    state: State,
    slope: State,
}

impl Escapement {
    /// The motion over one engagement that is entered at this speed (≥ 0), in about so many steps ([`STEPS`]).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::OutOfRange`], [`DynamicsError::Speed`], and [`DynamicsError::Stalls`] if the driver comes to rest. A start
    /// from rest is refused too: over the angle, the time of the first step has no bound there.
    pub fn passage(&self, entry_speed: f64, steps: u32) -> Result<JointPassage, DynamicsError> {
        let square = entry_speed * entry_speed;
        if !(entry_speed >= 0.0 && square.is_finite()) {
            return Err(DynamicsError::Speed { name: "driver speed", asked: entry_speed });
        }
        self.passage_of_square(square, steps)
    }

    /// The passage of an engagement from the square of the entry speed.
    pub(super) fn passage_of_square(&self, square: f64, steps: u32) -> Result<JointPassage, DynamicsError> {
        if !STEPS.contains(&steps) {
            return Err(DynamicsError::OutOfRange {
                name: "steps",
                asked: steps.into(),
                least: (*STEPS.start()).into(),
                most: (*STEPS.end()).into(),
            });
        }
        let half = self.parameters().mechanism().engagement_half_angle();
        let mut state = State::zeros();
        state[0] = square;
        let mut track = Track::new(square, -half);
        let mut flank = self.flank(-half, square);
        for part in self.parts() {
            let width = part.end - part.start;
            let count = (width / (2.0 * half) * f64::from(steps)).ceil().max(4.0);
            let (mut from, mut number) = (part.start, 1.0);
            while number <= count {
                let to = if number == count { part.end } else { part.start + width * (number / count) };
                (state, flank) = self.advance(&part, (from, to), state, flank, &mut track)?;
                from = to;
                number += 1.0;
            }
        }
        let input = 2.0 * half * self.parameters().torque();
        Ok(JointPassage {
            entry_speed: square.sqrt(),
            exit_speed: state[0].sqrt(),
            multiplier: libm::exp(state[1]),
            duration: state[2],
            mean_speed: 2.0 * half / state[2],
            peak: track.peak.extreme(),
            minimum: track.minimum.extreme(),
            changes: track.changes,
            work: Power { input, sliding: state[3], driver_bearing: state[4], follower_bearing: state[5] },
        })
    }

    /// The flank at an angle, by the square of the speed.
    fn flank(&self, angle: f64, square: f64) -> Sign {
        Sign::from_number(self.place(angle).terms.flank_switching_function(&square))
    }

    /// The parts between entry, the two angles at which the sliding can turn, and exit.
    fn parts(&self) -> impl Iterator<Item = SlidingInterval> {
        let (half, turn) = (self.parameters().mechanism().engagement_half_angle(), self.reversal_angle());
        let part = |start, end, leading, trailing| SlidingInterval { start, end, leading, trailing };
        let all = [
            part(-half, -turn, Sign::Minus, Sign::Minus),
            part(-turn, turn, Sign::Plus, Sign::Minus),
            part(turn, half, Sign::Plus, Sign::Plus),
        ];
        all.into_iter().filter(|part| part.end > part.start)
    }

    /// The state and the flank after a step, cut where the flank changes.
    fn advance(
        &self,
        part: &SlidingInterval,
        (mut from, to): (f64, f64),
        mut state: State,
        mut flank: Sign,
        track: &mut Track,
    ) -> Result<(State, Sign), DynamicsError> {
        for _ in 0..MOST_CHANGES {
            let end = self.step(part, flank, from, to, &state)?;
            if self.flank(to, end[0]) == flank {
                break;
            }
            let (mut low, mut high) = (from, to);
            loop {
                let middle = low + (high - low) / 2.0;
                if middle <= low || middle >= high {
                    break;
                }
                let there = self.step(part, flank, from, middle, &state)?;
                if self.flank(middle, there[0]) == flank {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let there = self.step(part, flank, from, high, &state)?;
            self.record(part, flank, (from, state), (high, there), track)?;
            track.changes.push(high);
            flank = if flank == Sign::Plus { Sign::Minus } else { Sign::Plus };
            (from, state) = (high, there);
            if from >= to {
                return Ok((state, flank));
            }
        }
        let end = self.step(part, flank, from, to, &state)?;
        self.record(part, flank, (from, state), (to, end), track)?;
        Ok((end, flank))
    }

    /// One step on one flank.
    fn step(
        &self,
        part: &SlidingInterval,
        flank: Sign,
        from: f64,
        to: f64,
        state: &State,
    ) -> Result<State, DynamicsError> {
        let first = self.rate(part, flank, from, state)?;
        let rate = |angle: f64, state: &State| self.rate(part, flank, angle, state);
        let end = runge_kutta_step(rate, from, to, state, &first)?;
        let runs = end[0] > 0.0 && end[0].is_finite();
        if runs { Ok(end) } else { Err(DynamicsError::Stalls { angle: to }) }
    }

    /// The state's slope over the angle on one flank.
    fn rate(&self, part: &SlidingInterval, flank: Sign, angle: f64, state: &State) -> Result<State, DynamicsError> {
        let square = state[0];
        let runs = square > 0.0 && square.is_finite();
        if !runs {
            return Err(DynamicsError::Stalls { angle });
        }
        let place = self.place(angle);
        let sense = if flank == Sign::Plus { part.leading } else { part.trailing };
        let arms = self.arms(&place.reach, flank, sense);
        let leverage = arms.driver / arms.follower;
        let angular_acceleration = place.terms.angular_acceleration(&square, &leverage);
        let moment = place.terms.moment(&square, &angular_acceleration);
        let motion = JointMotion {
            angular_acceleration,
            follower_acceleration: moment - place.terms.drag,
            normal_moment: self.parameters().inertias().follower() * moment / arms.follower,
            flank,
            sliding: place.reach.sliding(&self.joints().pin_radius, flank),
        };
        let work = self.work_rate(place.reach.ratio, &motion);
        let shrinking = -2.0 * leverage * place.terms.bend / place.terms.slope(&leverage);
        let slowness = 1.0 / square.sqrt();
        Ok(State::from([
            2.0 * angular_acceleration,
            shrinking,
            slowness,
            work.sliding,
            work.driver_bearing,
            work.follower_bearing,
        ]))
    }

    /// Takes a step into account that is on one flank.
    fn record(
        &self,
        part: &SlidingInterval,
        flank: Sign,
        (from, state): (f64, State),
        (to, end): (f64, State),
        track: &mut Track,
    ) -> Result<(), DynamicsError> {
        let slope = self.rate(part, flank, from, &state)?;
        let before = StepNode { angle: from, state, slope };
        let slope = self.rate(part, flank, to, &end)?;
        track.take(&before, &StepNode { angle: to, state: end, slope });
        Ok(())
    }
}

/// u, angle and time of an extreme.
#[derive(Clone, Copy)]
struct Spot {
    square: f64,
    angle: f64,
    time: f64,
}

impl Spot {
    fn extreme(self) -> Extreme {
        Extreme { speed: self.square.sqrt(), angle: self.angle, time: self.time }
    }
}

/// What is kept of a passage on the way.
struct Track {
    peak: Spot,
    minimum: Spot,
    changes: Vec<f64>,
}

impl Track {
    fn new(square: f64, angle: f64) -> Self {
        let spot = Spot { square, angle, time: 0.0 };
        Self { peak: spot, minimum: spot, changes: Vec::new() }
    }

    fn take(&mut self, from: &StepNode, to: &StepNode) {
        let turns = from.slope[0] * to.slope[0] < 0.0;
        for part in [turns.then(|| level(from, to)), Some(1.0)].into_iter().flatten() {
            let angle = if part < 1.0 { from.angle + part * (to.angle - from.angle) } else { to.angle };
            let spot = Spot { square: cubic(from, to, 0, part), angle, time: cubic(from, to, 2, part) };
            if spot.square > self.peak.square {
                self.peak = spot;
            }
            if spot.square < self.minimum.square {
                self.minimum = spot;
            }
        }
    }
}

/// The cubic through values and slopes at both nodes, at a part of the way.
fn cubic(from: &StepNode, to: &StepNode, which: usize, part: f64) -> f64 {
    let (width, rest) = (to.angle - from.angle, 1.0 - part);
    let ends =
        from.state[which] * rest * rest * (1.0 + 2.0 * part) + to.state[which] * part * part * (1.0 + 2.0 * rest);
    ends + width * part * rest * (from.slope[which] * rest - to.slope[which] * part)
}

/// Where between two nodes the cubic of u is level; its slopes there have opposite signs.
fn level(from: &StepNode, to: &StepNode) -> f64 {
    let (width, first, last) = (to.angle - from.angle, from.slope[0], to.slope[0]);
    let chord = (to.state[0] - from.state[0]) / width;
    // The cubic's slope as a parabola.
    let slope = |part: f64| {
        let rest = 1.0 - part;
        first * rest * (1.0 - 3.0 * part) + last * part * (3.0 * part - 2.0) + 6.0 * chord * part * rest
    };
    let [low, high] = bisect_times(60, [0.0, 1.0], |part| (slope(part) < 0.0) == (first < 0.0));
    f64::midpoint(low, high)
}
