//! What can stop a run, in words: the card and the time.

use super::digits::eight_digits;
use crate::DelayError;
use core::fmt;
use thiserror::Error;

/// Where a number that is none came from: the instruction that made it.
#[derive(Clone, Debug, PartialEq)]
pub struct FaultOrigin {
    /// Its card, counted from 1; 0 if it came with the data.
    pub card: usize,
    /// The text of the card.
    pub text: String,
    /// What happened.
    pub reason: String,
}

impl fmt::Display for FaultOrigin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.card == 0 {
            return write!(f, "{}", self.reason);
        }
        write!(f, "card {} ({}): {}", self.card, self.text, self.reason)
    }
}

/// Why a run was not begun, or not ended.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Trouble {
    /// A parameter without a number.
    #[error("no number for {0}; every name of a CON or PAR card needs one")]
    Missing(String),
    /// A number for a name that is no parameter.
    #[error("no CON or PAR card has the name {0}")]
    Unknown(String),
    /// Too many integrals or delays.
    #[error("the program has {asked} {what}; at most {most} can be run together")]
    TooMany {
        /// Of what.
        what: &'static str,
        /// How many it has.
        asked: usize,
        /// The most.
        most: usize,
    },
    /// DT, DTMIN or DTMAX out of their ranges.
    #[error("{name} is {}: {allowed}", eight_digits(*.value))]
    Step {
        /// Which.
        name: &'static str,
        /// What it is, in the unit of T.
        value: f64,
        /// What it can be, and a way out.
        allowed: String,
    },
    /// A run that ends before it begins, or too late.
    #[error(
        "card {card} ({text}): the run would end at T = {value}; it must be above zero, and at most {most} DT away \
         (numbers in a row: {numbers}); give a longer DT, another FIN or fewer names on OUT and PLO cards",
        value = eight_digits(*.value)
    )]
    RunLength {
        /// The FIN card.
        card: usize,
        /// Its text.
        text: String,
        /// The end, in the unit of T.
        value: f64,
        /// How many DT away it can be at most.
        most: u64,
        /// How many numbers each printed point has, with the parameters.
        numbers: usize,
    },
    /// A value that is no number.
    #[error("at T = {}: {origin}{}{}", eight_digits(*.time), after_forced(*.forced), way_out(*.time, origin))]
    NonFinite {
        /// When, in the unit of T.
        time: f64,
        /// Where it came from.
        origin: FaultOrigin,
        /// Steps before it that were as short as DTMIN allows and missed the tolerance.
        forced: u64,
    },
    /// A step that would have to be smaller than DTMIN.
    #[error(
        "at T = {time}: card {card} ({text}) changes too quickly: with a step of {step} the error of {name} is {excess:.1} \
         times what is allowed; give a smaller DTMIN or a larger tolerance, or let such steps be kept",
        time = eight_digits(*.time),
        step = eight_digits(*.step)
    )]
    StepTooSmall {
        /// When, in the unit of T.
        time: f64,
        /// The card of the integral.
        card: usize,
        /// Its text.
        text: String,
        /// Its name.
        name: String,
        /// The step, in the unit of T.
        step: f64,
        /// Its error over what is allowed, dimensionless.
        excess: f64,
    },
    /// Too many steps.
    #[error(
        "at T = {time}: FIN is not reached after {steps} steps; {origin}; give a larger tolerance, DTMIN, DTMAX \
         or gap between switching on and off, or an earlier FIN",
        time = eight_digits(*.time)
    )]
    TooManySteps {
        /// When, in the unit of T.
        time: f64,
        /// The bound.
        steps: u64,
        /// What makes the steps short.
        origin: FaultOrigin,
    },
    /// The limit of printed rows is reached.
    #[error(
        "at T = {time}: FIN is not reached after {rows} printed rows; give a longer DT or an earlier FIN, or print \
             fewer names",
        time = eight_digits(*.time)
    )]
    TooManyRows {
        /// When, in the unit of T.
        time: f64,
        /// How many are printed.
        rows: u64,
    },
    /// A delay that does not work.
    #[error("at T = {time}: card {card} ({text}): {error}", time = eight_digits(*.time))]
    Delay {
        /// When, in the unit of T.
        time: f64,
        /// The card.
        card: usize,
        /// Its text.
        text: String,
        /// What is wrong.
        error: DelayError,
    },
    /// A delay that spans more values than there is room for.
    #[error(
        "at T = {time}: card {card} ({text}): the delay of {delay} spans more than {capacity} kept steps, and no \
         more values are remembered; give a larger tolerance or DTMIN, or let the delay keep as many values as its \
         third argument says (--delay-keeps as-asked)",
        time = eight_digits(*.time),
        delay = eight_digits(*.delay)
    )]
    DelayFull {
        /// When, in the unit of T.
        time: f64,
        /// The card.
        card: usize,
        /// Its text.
        text: String,
        /// The most values that are remembered.
        capacity: usize,
        /// The delay, in the unit of T.
        delay: f64,
    },
    /// The delays of a run remember more values than there is room for.
    #[error(
        "at T = {time}: {delays} TDL, the longest of which goes back by {longest}, need room for more than {most} values, \
         the most that is remembered; give fewer or shorter delays, longer steps (DTMAX or DT) or an earlier FIN, or let each \
         delay keep as many values as its third argument says (--delay-keeps as-asked)",
        time = eight_digits(*.time),
        longest = eight_digits(*.longest)
    )]
    DelaysFull {
        /// When, in the unit of T.
        time: f64,
        /// How many delays there are.
        delays: usize,
        /// The longest delay, in the unit of T.
        longest: f64,
        /// The most values.
        most: usize,
    },
    /// All runs of a deck come to more than one answer can hold.
    #[error(
        "the first {runs} data sets need {asked} {what}, but all together can have at most {most}; give fewer data sets, {way_out} or an \
             earlier FIN"
    )]
    TooMuch {
        /// The data sets up to the one that was too much.
        runs: usize,
        /// Of what.
        what: &'static str,
        /// How many there are.
        asked: u64,
        /// The most.
        most: u64,
        /// What makes them fewer.
        way_out: &'static str,
    },
    /// A parameter of the integrator out of its range.
    #[error("{0}")]
    Integrator(crate::ParameterError),
}

impl Trouble {
    /// Adds the number of steps before it that missed the tolerance.
    pub(super) fn with_forced_steps(self, steps: u64) -> Self {
        match self {
            Self::NonFinite { time, origin, .. } => Self::NonFinite { time, origin, forced: steps },
            other => other,
        }
    }
}

/// What to do about a value that is no number, where its origin does not say.
fn way_out(time: f64, origin: &FaultOrigin) -> &'static str {
    match time {
        _ if origin.reason.contains("; ") => "",
        0.0 => "; give other numbers on the cards or as data",
        _ => "; give other numbers on the cards or as data, or end the run earlier with FIN",
    }
}

fn after_forced(steps: u64) -> String {
    match steps {
        0 => String::new(),
        _ => format!(
            "; of the steps before, {steps} missed the tolerance and could not be shorter than DTMIN: give a smaller DTMIN"
        ),
    }
}

/// Error of a run, with its number.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("data set {number}: {trouble}")]
pub struct RunError {
    /// Number of the data set, counted from 1.
    pub number: usize,
    /// What went wrong.
    pub trouble: Trouble,
}
