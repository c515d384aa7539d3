//! The runs by a deck in the language of the thesis: the escapement's deck of `geneva-mimic`, with a row's data card.
//!
//! The deck has the mechanics of the thesis in other variables and in words of this project, and the mechanism's own
//! reset angle. Two of its names can be set to what the thesis's program has: see [`AS_LISTED`].

use super::*;
use geneva_dynamics::program::{Line, Printout, Readings};
use geneva_mimic::language::{Choices, DataSet, Deck, Layout, Program, deck_named};
use std::sync::OnceLock;

/// The names of the deck with other values in the program of the thesis: the reset angle and π.
///
/// Each comes with the claim that has the program's number.
pub const AS_LISTED: [(&str, &str); 2] = [("RESET", "meyer.listing.quarter-turn"), ("PI", "meyer.listing.pi")];

/// The escapement's deck, with some names set to other numbers than its cards have. None if there is no such name, or if
/// something is wrong with the deck.
pub fn deck(set: &[(&str, f64)]) -> Option<Deck> {
    let text = deck_named("escapement")?;
    let mut deck = Deck::read(text, Layout::of(text)).ok()?;
    set.iter().all(|(name, value)| deck.set(name, *value)).then_some(deck)
}

/// The names with other values in the program of the thesis, with its numbers.
pub fn as_listed() -> [(&'static str, f64); 2] {
    AS_LISTED.map(|(name, id)| (name, printed(id)))
}

/// A row's data card for a program, with the inertias of Fig. 11 for six pins.
pub fn data(program: &Program, row: &Row) -> DataSet {
    let names = program.parameters().into_iter().map(str::to_owned);
    DataSet(names.zip(Hypothesis::as_run().data_card(row)).collect())
}

/// The result of a run of a program with a row's data card, read off its printed columns.
///
/// The columns are the time, the angle through which the driver has turned, its speed and acceleration, and the
/// follower's speed. The angle is reset after `reset` radians.
pub fn run(program: &Program, row: &Row, reset: f64, choices: &Choices) -> Option<Run> {
    let printed = program.run(&data(program, row), choices).ok()?;
    let line = |row: &Vec<f64>| {
        let [time, turned, speed, acceleration, follower_speed] = row[..] else { return None };
        Some(Line { time, turned, angle: f64::NAN, speed, acceleration, follower_speed })
    };
    let lines = printed.rows.iter().map(line).collect::<Option<_>>()?;
    Some(Readings::of(&Printout { lines, work: printed.work }, reset)?.into())
}

/// All rows by the deck, run once.
///
/// The deck runs as it is, with the angle between two pins for the reset, or with the values of the program of the
/// thesis.
pub fn runs(reset: Reset) -> Option<&'static [Run]> {
    static RUNS: [OnceLock<Option<Vec<Run>>>; 2] = [const { OnceLock::new() }; 2];
    let (kept, set) = match reset {
        Reset::OfTheMechanism => (&RUNS[0], Vec::new()),
        Reset::QuarterTurn => (&RUNS[1], as_listed().to_vec()),
    };
    let all = || {
        let program = Program::new(&deck(&set)?).ok()?;
        let hypothesis = Hypothesis { reset, ..Hypothesis::as_run() };
        rows().iter().map(|row| run(&program, row, hypothesis.angle(row.mechanism), &Choices::default())).collect()
    };
    kept.get_or_init(all).as_deref()
}
