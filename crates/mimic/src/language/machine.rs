//! A program as the integrator sees it: its derivatives, what it remembers of kept points, and what stopped it.

use super::code::execute;
use super::digits::eight_digits;
use super::program::{Memory, Program, State, StateRule, TIME};
use super::trouble::{FaultOrigin, Trouble};
use crate::step::Attempt;
use crate::{Cause, DelayError, DelayLine, SolverParameters, System};
use core::cell::Cell;
use nalgebra::SVector;

/// Most kept points that a delay line holds: sixteen megabytes.
const KEPT: usize = 1 << 20;

/// A delay line, how far apart its entries are at least, and when the last was made.
pub(super) struct RecordedDelay {
    pub(super) line: DelayLine<KEPT>,
    pub(super) apart: f64,
    pub(super) last: f64,
}

/// A program that runs.
pub(super) struct Machine<'a> {
    pub(super) program: &'a Program,
    pub(super) registers: Vec<f64>,
    pub(super) lines: Vec<RecordedDelay>,
    /// Most entries that all lines may have memory for.
    pub(super) room: usize,
    /// What the held registers had at the last point that was kept.
    pub(super) held: Vec<f64>,
    /// The last point that was kept, and how near to it nothing is located.
    pub(super) kept: (f64, Vec<f64>),
    pub(super) nearest: f64,
    /// The memories whose cards do not count over the step that begins at the last kept point.
    pub(super) closed: Vec<usize>,
    /// How often a memory has changed within the run, and which did last.
    pub(super) changes: u64,
    pub(super) changed: Option<usize>,
    /// Kept steps that were longer than the delay of a TDL.
    pub(super) longer_than_delay: u64,
    /// What is printed and plotted, and what it was at the last point that was kept.
    pub(super) watched: Vec<u32>,
    pub(super) latest: &'a [Cell<f64>],
    pub(super) latest_time: &'a Cell<f64>,
    /// Whether a FIN card knows the end before the run: the integrator then ends there.
    pub(super) has_end: bool,
    /// Where a derivative was no number last.
    pub(super) odd: Option<(f64, Vec<f64>)>,
}

/// What stops a run from inside.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Stop {
    Finished,
    Delay(usize, DelayError),
    /// The memory of all delays is used up.
    Delays,
    Value(u32),
}

impl core::fmt::Display for Stop {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the run was stopped by the program")
    }
}

impl<const D: usize> System<D> for Machine<'_> {
    type Fault = Stop;

    fn derivative(&mut self, time: f64, state: &SVector<f64, D>) -> Result<SVector<f64, D>, Stop> {
        self.evaluate(time, state)?;
        let Self { program, registers, .. } = self;
        let mut rate = SVector::<f64, D>::zeros();
        for (rate, of) in rate.iter_mut().zip(&program.states) {
            *rate = of.rate(registers);
        }
        if rate.iter().any(|rate: &f64| !rate.is_finite()) {
            self.odd = Some((time, state.iter().copied().collect()));
        }
        Ok(rate)
    }

    /// Memories change at kept points only: inside a step one could change and change back, and the kept points would
    /// never see it.
    fn kept_derivative(&mut self, time: f64, state: &SVector<f64, D>) -> Result<SVector<f64, D>, Stop> {
        self.set_gates(1.0);
        self.derivative(time, state)
    }

    fn switches(&mut self, time: f64, state: &SVector<f64, D>) -> Result<bool, Stop> {
        if self.program.memories.is_empty() {
            return Ok(false);
        }
        self.set_gates(1.0);
        let changes = self.evaluate(time, state).map(|()| (self.change().is_some(), self.closes()));
        self.set_gates(0.0);
        let (changes, closes) = changes?;
        if changes || !closes {
            return Ok(changes);
        }
        // What counts at one instant only, as at the start, need not be located.
        let (from, states) = &self.kept;
        let (soon, state) = (from + self.nearest, SVector::from_fn(|at, _| states.get(at).copied().unwrap_or(0.0)));
        self.evaluate::<D>(soon, &state)?;
        Ok(!self.closes())
    }

    fn accepted(&mut self, time: f64, state: &SVector<f64, D>, _: &SVector<f64, D>) -> Result<(), Stop> {
        if let Some(changed) = self.change() {
            self.changed = Some(changed);
            self.changes += 1;
        }
        let program = self.program;
        let registers = &mut self.registers;
        let mut is_long = false;
        for (line, of) in self.lines.iter_mut().zip(&program.delays) {
            // A step from the last value that is longer than the delay asks for times behind that value.
            is_long |= time - line.last > registers[of.delay as usize] * (1.0 + 1e-9) && line.last.is_finite();
            if time - line.last >= line.apart * (1.0 - 1e-9) {
                line.line.record(time, registers[of.feed as usize]).map_err(|error| Stop::Delay(of.card, error))?;
                line.last = time;
            }
        }
        if self.lines.iter().map(|line| line.line.room()).sum::<usize>() > self.room {
            return Err(Stop::Delays);
        }
        self.longer_than_delay += u64::from(is_long);
        for sample in &program.samples {
            if time >= registers[sample.next as usize] {
                registers[sample.held as usize] = registers[sample.feed as usize];
                let interval = registers[sample.interval as usize];
                // An interval that is none samples at every point.
                let next = (libm::floor(time / interval * (1.0 + 1e-12)) + 1.0) * interval;
                registers[sample.next as usize] = if next > time { next } else { time };
            }
        }
        for slope in &program.slopes {
            for (before, now) in slope.before.iter().zip(slope.now) {
                registers[*before as usize] = registers[now as usize];
            }
        }
        for (register, held) in program.held.iter().zip(&mut self.held) {
            *held = registers[*register as usize];
        }
        let memories = program.memories.iter().enumerate();
        self.closed.clear();
        self.closed.extend(memories.filter(|(_, memory)| memory.is_closed(registers)).map(|(at, _)| at));
        self.closed.iter().for_each(|at| registers[program.memories[*at].gate as usize] = 0.0);
        if let Some(register) = program.deciding().find(|register| registers[*register as usize].is_nan()) {
            return Err(Stop::Value(register));
        }
        for (register, latest) in self.watched.iter().zip(self.latest) {
            let value = registers[*register as usize];
            if !value.is_finite() {
                return Err(Stop::Value(*register));
            }
            latest.set(value);
        }
        self.latest_time.set(time);
        self.kept.0 = time;
        self.kept.1.clear();
        self.kept.1.extend(state.iter());
        let ended = program.finishes.iter().filter(|finish| !(self.has_end && finish.is_run_length));
        let mut ended = ended.map(|finish| registers[finish.value as usize] >= registers[finish.limit as usize]);
        if ended.any(|ended| ended) { Err(Stop::Finished) } else { Ok(()) }
    }
}

impl Memory {
    /// Whether none of its cards counts.
    fn is_closed(&self, registers: &[f64]) -> bool {
        self.controls.iter().all(|control| registers[*control as usize] != 1.0)
    }
}

impl State {
    /// What is integrated, in the unit of the integral over that of T.
    fn rate(&self, registers: &[f64]) -> f64 {
        let of = |register: u32| registers[register as usize];
        if self.control.is_some_and(|control| of(control) != 1.0) {
            return 0.0;
        }
        let (feed, own) = (of(self.feed), of(self.register));
        match self.more {
            StateRule::Nothing => feed,
            StateRule::TimeConstant(constant) => (feed - own) / of(constant),
            StateRule::Limits([low, high]) if (own <= of(low) && feed < 0.0) || (own >= of(high) && feed > 0.0) => 0.0,
            StateRule::Limits(_) => feed,
        }
    }
}

impl Machine<'_> {
    /// Runs the code at a time and a state.
    fn evaluate<const D: usize>(&mut self, time: f64, state: &SVector<f64, D>) -> Result<(), Stop> {
        let program = self.program;
        let registers = &mut self.registers;
        registers[TIME as usize] = time;
        for (value, of) in state.iter().zip(&program.states) {
            registers[of.register as usize] = *value;
        }
        for (line, of) in self.lines.iter().zip(&program.delays) {
            registers[of.register as usize] = line.line.value(time).map_err(|error| Stop::Delay(of.card, error))?;
        }
        for (register, value) in program.held.iter().zip(&self.held) {
            registers[*register as usize] = *value;
        }
        execute(&program.each.instructions, registers);
        Ok(())
    }

    /// Whether the cards of the closed memories count: 1 or 0.
    fn set_gates(&mut self, truth: f64) {
        for at in &self.closed {
            self.registers[self.program.memories[*at].gate as usize] = truth;
        }
    }

    /// A closed memory that has another value now than at the last kept point.
    fn change(&self) -> Option<usize> {
        let value = |held: usize| self.program.held.get(held).map(|register| self.registers[*register as usize]);
        self.closed.iter().copied().find(|at| {
            let held = self.program.memories[*at].held;
            value(held).map(f64::to_bits) != self.held.get(held).copied().map(f64::to_bits)
        })
    }

    /// Whether a memory closes that was open at the last kept point: what it then keeps is the value of that point.
    fn closes(&self) -> bool {
        let memories = self.program.memories.iter().enumerate();
        let mut open = memories.filter(|(at, _)| !self.closed.contains(at));
        open.any(|(_, memory)| memory.is_closed(&self.registers))
    }

    /// What stopped the run, by the card and the time.
    pub(super) fn trouble<const D: usize>(
        &mut self,
        time: f64,
        state: &SVector<f64, D>,
        cause: Cause<Stop>,
        parameters: &SolverParameters,
    ) -> Trouble {
        let program = self.program;
        match cause {
            Cause::TooManySteps { most_steps } => {
                let origin = self.what_makes_steps_short(time, state, most_steps, parameters);
                Trouble::TooManySteps { time, steps: most_steps, origin }
            }
            Cause::System(Stop::Delay(card, DelayError::Full { capacity, delay, .. })) => {
                Trouble::DelayFull { time, card, text: program.card_text(card), capacity, delay }
            }
            Cause::System(Stop::Delay(card, error)) => {
                Trouble::Delay { time, card, text: program.card_text(card), error }
            }
            Cause::System(Stop::Delays) => {
                let longest = program.delays.iter().map(|of| self.registers[of.delay as usize]).fold(0.0, f64::max);
                Trouble::DelaysFull { time, delays: program.delays.len(), longest, most: self.room }
            }
            Cause::System(Stop::Value(register)) => {
                let time = self.registers[TIME as usize];
                Trouble::NonFinite { time, origin: program.origin(&self.registers, register), forced: 0 }
            }
            Cause::StepUnderflow { step, excess, .. } if excess.is_finite() => {
                self.too_small(time, state, step, excess, parameters)
            }
            // Finished is no trouble; what is left is a number that is none.
            _ => self.not_finite(time),
        }
    }

    /// The memory that changes again and again, or the integral with the largest error.
    fn what_makes_steps_short<const D: usize>(
        &mut self,
        time: f64,
        state: &SVector<f64, D>,
        steps: u64,
        parameters: &SolverParameters,
    ) -> FaultOrigin {
        let program = self.program;
        let longest = parameters.largest_step;
        if longest < parameters.print_interval && 2.0 * time > longest * steps as f64 {
            let reason = format!("most are as long as DTMAX, {}, allows", eight_digits(longest));
            return FaultOrigin { card: 0, text: String::new(), reason };
        }
        // To locate a change takes less than a hundred steps.
        let memory = self.changed.filter(|_| self.changes >= steps / 100).and_then(|at| program.memories.get(at));
        let (card, reason) = match memory {
            Some(memory) => (memory.card, format!("{} has changed {} times", memory.name, self.changes)),
            None => {
                let worst = self.worst(time, state, parameters.largest_step, parameters);
                let of = program.states.get(worst);
                of.map_or((0, "there is no integral".to_owned()), |of| {
                    (of.card, format!("{} has the largest error", of.name))
                })
            }
        };
        FaultOrigin { card, text: program.card_text(card), reason }
    }

    /// The integral with the largest error in a step.
    fn worst<const D: usize>(
        &mut self,
        time: f64,
        state: &SVector<f64, D>,
        step: f64,
        parameters: &SolverParameters,
    ) -> usize {
        let first = self.derivative(time, state).unwrap_or_else(|_| SVector::zeros());
        let attempt = Attempt::new(|time, state| self.derivative(time, state), time, time + step, state, &first);
        let floor = parameters.absolute_floor.min(state.amax());
        attempt.map_or(0, |attempt| attempt.worst(parameters.relative_tolerance, floor))
    }

    /// The integral with the largest error in a step that was refused.
    fn too_small<const D: usize>(
        &mut self,
        time: f64,
        state: &SVector<f64, D>,
        step: f64,
        excess: f64,
        parameters: &SolverParameters,
    ) -> Trouble {
        let worst = self.worst(time, state, step, parameters);
        let (card, name) = self.program.states.get(worst).map_or((0, String::new()), |of| (of.card, of.name.clone()));
        Trouble::StepTooSmall { time, card, text: self.program.card_text(card), name, step, excess }
    }

    /// Where a derivative or a state that is no number came from.
    fn not_finite(&mut self, time: f64) -> Trouble {
        let program = self.program;
        let Some((odd_time, state)) = self.odd.take() else {
            let reason = "an integral has grown without bound".to_owned();
            return Trouble::NonFinite {
                time,
                origin: FaultOrigin { card: 0, text: String::new(), reason },
                forced: 0,
            };
        };
        let registers = &mut self.registers;
        registers[TIME as usize] = odd_time;
        for (value, of) in state.iter().zip(&program.states) {
            registers[of.register as usize] = *value;
        }
        for (register, value) in program.held.iter().zip(&self.held) {
            registers[*register as usize] = *value;
        }
        execute(&program.each.instructions, registers);
        let odd = program.states.iter().find(|of| !of.rate(registers).is_finite());
        let register = odd.map_or(TIME, |of| match of.more {
            StateRule::TimeConstant(constant) if registers[of.feed as usize].is_finite() => constant,
            _ => of.feed,
        });
        let origin = match odd {
            Some(of) if registers[register as usize].is_finite() => FaultOrigin {
                card: of.card,
                text: program.card_text(of.card),
                reason: match of.more {
                    StateRule::TimeConstant(_) => format!("{} has a time constant of zero", of.name),
                    _ => format!("the rate of {} is not a number", of.name),
                },
            },
            _ => program.origin(registers, register),
        };
        Trouble::NonFinite { time: odd_time, origin, forced: 0 }
    }
}
