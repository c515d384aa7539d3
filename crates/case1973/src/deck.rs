//! The runs by a deck in the language of the thesis: the escapement's deck of `geneva-mimic`, with a row's data card.
//!
//! The deck has the mechanics of the thesis in other variables and in words of this project, and the mechanism's own
//! reset angle. Two of its names can be set to what the thesis's program has: see [`listed_settings`].

use crate::program::Printout;
use crate::{Hypothesis, Listing, Reset, Row, Run};
use geneva_dynamics::steady::PrintedLine;
use geneva_mimic::language::{CardLayout, DataSet, Deck, Program, RunOptions, deck_named};

/// The names of the deck with other values in the program of the thesis: the reset angle and π.
pub const AS_LISTED: [&str; 2] = ["RESET", "PI"];

/// The names with other values in the program of the thesis, with its numbers: an angle in radians, and π, dimensionless.
pub fn listed_settings(listing: &Listing) -> [(&'static str, f64); 2] {
    [(AS_LISTED[0], listing.reset), (AS_LISTED[1], listing.pi)]
}

/// The escapement's deck, with some names set to other numbers than its cards have. None if there is no such name, or if
/// something is wrong with the deck.
pub fn deck(set: &[(&str, f64)]) -> Option<Deck> {
    let text = deck_named("escapement")?;
    let mut deck = Deck::read(text, CardLayout::detect(text)).ok()?;
    set.iter().all(|(name, value)| deck.set(name, *value)).then_some(deck)
}

/// A row's data card for a program, with the inertias of Fig. 11 for six pins.
pub fn data(program: &Program, row: &Row) -> DataSet {
    let names = program.parameters().into_iter().map(str::to_owned);
    DataSet(names.zip(Hypothesis::AS_RUN.data_card(row)).collect())
}

/// The result of a run of a program with a row's data card, read off its printed columns.
///
/// The columns are the time, the angle through which the driver has turned, its speed and acceleration, and the
/// follower's speed. The angle is reset after `reset` radians.
pub fn run(program: &Program, row: &Row, reset: f64, choices: &RunOptions) -> Option<Run> {
    let printed = program.run(&data(program, row), choices).ok()?;
    let half = row.mechanism.engagement_half_angle();
    let line = |row: &Vec<f64>| {
        let [time, turned, speed, acceleration, follower_speed] = row[..] else { return None };
        let angle = libm::fmod(turned, reset) - half;
        let engagement = (turned / reset) as usize;
        Some(PrintedLine { time, turned, angle, speed, acceleration, follower_speed, engagement })
    };
    let lines = printed.rows.iter().map(line).collect::<Option<_>>()?;
    Run::read_off(&Printout { lines, work: printed.work }, reset)
}

/// What part of the steps of each row's run is longer than the delay, dimensionless, with the numbers of the thesis's program.
/// None if a run comes to no end.
pub fn longer_than_delay(rows: &[Row]) -> Option<Vec<f64>> {
    let program = Program::new(&deck(&listed_settings(&rows.first()?.given.listing))?).ok()?;
    let part = |row| {
        let run = program.run(&data(&program, row), &RunOptions::default()).ok()?;
        Some(run.longer_than_delay as f64 / run.work.accepted as f64)
    };
    rows.iter().map(part).collect()
}

/// How far the driver has turned, in radians, in the first printed line of a row's run in which the follower runs backwards, with
/// some names of the deck set to other numbers. None if it never does.
pub fn turned_when_backwards(row: &Row, set: &[(&str, f64)]) -> Option<f64> {
    let program = Program::new(&deck(set)?).ok()?;
    let printed = program.run(&data(&program, row), &RunOptions::default()).ok()?.rows;
    printed.iter().find(|line| line.last().is_some_and(|speed| *speed < 0.0))?.get(1).copied()
}

/// All rows by the deck. None if one of them comes to no end.
///
/// The deck runs as it is, with the angle between two pins for the reset, or with the π of the thesis's program and its
/// reset angle or another one.
pub fn runs(rows: &[Row], reset: Reset) -> Option<Vec<Run>> {
    let listing = rows.first()?.given.listing;
    let set = match reset {
        Reset::OfTheMechanism => Vec::new(),
        Reset::QuarterTurn => listed_settings(&listing).to_vec(),
        Reset::After(angle) => listed_settings(&Listing { reset: angle, ..listing }).to_vec(),
    };
    let program = Program::new(&deck(&set)?).ok()?;
    let hypothesis = Hypothesis { reset, ..Hypothesis::AS_RUN };
    rows.iter().map(|row| run(&program, row, hypothesis.angle(row), &RunOptions::default())).collect()
}
