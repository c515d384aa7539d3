//! A run with the lagged sign of the program, from Newton's laws: the second route to what the program gives.
//!
//! Forces and accelerations are vectors, lengths are in crank radii. Steps are equal; a step is cut short where the pin
//! changes over to the other flank in the program's belief, and where the driver's angle is reset.

use crate::program::Program1973;
use crate::{Hypothesis, Row, Run};
use nalgebra::Vector2;

/// The mechanism as the program has it, and its data card.
struct Card {
    /// Centre distance over crank radius.
    ratio: f64,
    /// Crank angle at the start of an engagement, in rad.
    start: f64,
    /// Angle after which the driver's angle is reset, in rad.
    reset: f64,
    /// Moments of inertia of driver and follower, in in lb s².
    inertias: [f64; 2],
    /// Torque, in in lb.
    torque: f64,
    /// Coefficient of friction.
    friction: f64,
    /// By how much the acceleration is late that chooses the sign, in s.
    delay: f64,
}

/// Time, crank angle and speed.
#[derive(Clone, Copy)]
struct State {
    time: f64,
    angle: f64,
    speed: f64,
}

/// The pin at a crank angle: everything that the follower's motion depends on.
struct Pin {
    /// Distance from the follower's axis.
    radius: f64,
    /// Follower's angular velocity over the driver's.
    turning: f64,
    /// Follower's angular acceleration over the square of the driver's speed, if the driver is not accelerated.
    change: f64,
    /// Sense in which the pin slides along the slot.
    sliding: f64,
    /// Moments about the driver's axis of a unit force across the slot and of one along it.
    moments: [f64; 2],
}

impl Pin {
    fn at(ratio: f64, angle: f64) -> Self {
        let from_driver = Vector2::new(libm::cos(angle), libm::sin(angle));
        let velocity = Vector2::new(-from_driver.y, from_driver.x);
        let place = from_driver - Vector2::new(ratio, 0.0);
        let radius = place.norm();
        let along = place / radius;
        let across = Vector2::new(-along.y, along.x);
        let (turning, sliding) = (across.dot(&velocity) / radius, along.dot(&velocity));
        // The pin's acceleration across the slot without Coriolis's part is the follower's.
        let change = (-across.dot(&from_driver) - 2.0 * sliding * turning) / radius;
        let moments = [from_driver.perp(&across), from_driver.perp(&along)];
        Self { radius, turning, change, sliding: sliding.signum(), moments }
    }
}

impl Card {
    /// What a program reads, with the lag of its sign.
    fn new(program: &Program1973, delay: f64) -> Self {
        Self {
            ratio: program.ratio,
            start: program.start,
            reset: program.reset,
            inertias: [program.inertias.driver(), program.inertias.follower()],
            torque: program.torque,
            friction: program.friction,
            delay,
        }
    }

    /// The driver's acceleration if the pin is believed to press on this flank (1 or −1).
    fn acceleration(&self, state: &State, flank: f64) -> f64 {
        self.acceleration_at(&Pin::at(self.ratio, state.angle), state.speed, flank)
    }

    fn acceleration_at(&self, pin: &Pin, speed: f64, flank: f64) -> f64 {
        let [driver, follower] = self.inertias;
        // Force on the follower: N across the slot, μ|N| along it as the pin slides; N R turns the follower.
        let lever = follower / pin.radius * (pin.moments[0] + self.friction * flank * pin.sliding * pin.moments[1]);
        (self.torque - lever * pin.change * speed * speed) / (driver + lever * pin.turning)
    }

    /// On which flank the pin presses by the acceleration of a moment before.
    fn flank(pin: &Pin, speed: f64, before: f64) -> f64 {
        (pin.turning * before + pin.change * speed * speed).signum()
    }

    /// A step of the classical Runge and Kutta, from an acceleration that is known.
    fn step(&self, from: &State, known: f64, length: f64, flank: f64) -> State {
        let ahead = |part: f64, speed: f64, angular_acceleration: f64| State {
            time: from.time + part,
            angle: from.angle + part * speed,
            speed: from.speed + part * angular_acceleration,
        };
        let slope = |state: &State| (state.speed, self.acceleration(state, flank));
        let half = length / 2.0;
        let first = (from.speed, known);
        let second = slope(&ahead(half, first.0, first.1));
        let third = slope(&ahead(half, second.0, second.1));
        let last = slope(&ahead(length, third.0, third.1));
        let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * b + 2.0 * c + d) / 6.0;
        ahead(length, mean(first.0, second.0, third.0, last.0), mean(first.1, second.1, third.1, last.1))
    }
}

/// Steps of a print interval.
const STEPS: u32 = 20;

/// Halvings that locate an event within a step.
const HALVINGS: u32 = 40;

/// Steps that a run may take; a sign that never settles would take more.
const MOST: u32 = 1_000_000;

/// The accelerations so far, at the ends of all steps; two at one time where it jumps.
struct History {
    kept: Vec<(f64, f64)>,
    /// Where the last answer was found: times that are asked for do not go back by more than a step.
    near: usize,
}

impl History {
    /// The acceleration at a time, between two ends as if it were straight; none before the start.
    fn at(&mut self, time: f64) -> f64 {
        if time <= 0.0 {
            return 0.0;
        }
        while self.near > 0 && self.kept[self.near].0 > time {
            self.near -= 1;
        }
        while self.near + 1 < self.kept.len() && self.kept[self.near + 1].0 <= time {
            self.near += 1;
        }
        let (then, value) = self.kept[self.near];
        self.kept
            .get(self.near + 1)
            .map_or(value, |(later, next)| value + (next - value) * ((time - then) / (later - then)))
    }
}

/// The run of a row as the program ran it; none if it has no two engagements.
pub fn lagged_run(row: &Row) -> Option<Run> {
    let listing = &row.given.listing;
    run_with_lag(&Hypothesis::AS_RUN.program(row)?, listing.delay, listing.interval, listing.duration)
}

/// A run of a program with its sign late by `delay` instead of what the program says, printed at every `interval` until
/// `duration`, all in units of time. None if it has no two engagements.
pub fn run_with_lag(program: &Program1973, delay: f64, interval: f64, duration: f64) -> Option<Run> {
    let card = Card::new(program, delay);
    let step = interval / f64::from(STEPS);
    let mut state = State { time: 0.0, angle: card.start, speed: 0.0 };
    // At rest the friction opposes the driver.
    let mut flank = Pin::at(card.ratio, card.start).turning.signum();
    let mut before = card.acceleration(&state, flank);
    let mut history = History { kept: vec![(0.0, before)], near: 0 };
    let (mut peak, mut first_minimum) = (0.0_f64, None);
    let (mut entered, mut least, mut whole) = (0.0, f64::INFINITY, None);
    let mut at = 1_u32;
    for _ in 0..MOST {
        let end = f64::from(at) * step;
        if end > duration * (1.0 + 1e-12) {
            break;
        }
        let reached = |history: &mut History, length: f64| {
            let next = card.step(&state, before, length, flank);
            let old = history.at(next.time - card.delay);
            let over = next.angle - card.start >= card.reset;
            let pin = Pin::at(card.ratio, next.angle);
            (next, over, Card::flank(&pin, next.speed, old) != flank && next.time > card.delay, pin)
        };
        let length = end - state.time;
        let (mut next, mut over, mut changes, mut pin) = reached(&mut history, length);
        if over || changes {
            let (mut low, mut high) = (0.0, length);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(low, high);
                let (_, over, changes, _) = reached(&mut history, middle);
                *(if over || changes { &mut high } else { &mut low }) = middle;
            }
            (next, over, changes, pin) = reached(&mut history, high);
        } else {
            next.time = end;
        }
        let mut after = card.acceleration_at(&pin, next.speed, flank);
        history.kept.push((next.time, after));
        if before < 0.0 && after >= 0.0 {
            let part = before / (before - after);
            first_minimum = first_minimum.or(Some(state.time + part * (next.time - state.time)));
            // At the lowest, between the ends of the step, the speed is a parabola.
            least = least.min(state.speed + before * part * (next.time - state.time) / 2.0);
        }
        least = least.min(next.speed);
        if over {
            whole = Some((least, next.time - entered));
            (entered, least) = (next.time, f64::INFINITY);
            next.angle -= card.reset;
        }
        if changes {
            flank = -flank;
        }
        if over || changes {
            after = card.acceleration(&next, flank);
            history.kept.push((next.time, after));
        }
        (state, before) = (next, after);
        if state.time >= end {
            if at.is_multiple_of(STEPS) {
                peak = peak.max(state.speed);
            }
            at += 1;
        }
    }
    let (minimum, period) = whole?;
    Some(Run { peak, minimum, period, first_minimum: first_minimum? })
}
