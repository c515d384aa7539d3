//! The language: what decks mean, what is wrong with them, and whether they run as the same equations in Rust do.

mod bounded;
mod cards;
mod code;
mod decks;
mod escapement;
mod faults;
mod functions;
mod memory;
mod native;
mod running;
mod sorting;
mod steps;
mod tokens;

use geneva_mimic::language::{CardLayout, DataSet, Deck, DeckRun, Program, RunOptions, deck_named};

/// The deck in a text without columns.
#[track_caller]
fn deck(text: &str) -> Deck {
    Deck::read(text, CardLayout::Free).unwrap_or_else(|faults| panic!("{faults}"))
}

#[track_caller]
fn program(text: &str) -> Program {
    Program::new(&deck(text)).unwrap_or_else(|faults| panic!("{faults}"))
}

/// The runs that a text asks for.
#[track_caller]
fn runs(text: &str) -> Vec<DeckRun> {
    let deck = deck(text);
    let sets = deck.data_sets().unwrap_or_else(|faults| panic!("{faults}"));
    let program = Program::new(&deck).unwrap_or_else(|faults| panic!("{faults}"));
    program.runs(&sets, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The columns after T at the end of a run.
#[track_caller]
fn last(text: &str) -> Vec<f64> {
    runs(text)[0].rows.last().expect("a row").clone()
}

/// A deck of this project, with the names of its data and some numbers for them.
#[track_caller]
fn own(name: &str, numbers: &[f64]) -> (Program, DataSet) {
    let text = deck_named(name).expect("a deck");
    let deck = Deck::read(text, CardLayout::detect(text)).unwrap_or_else(|faults| panic!("{faults}"));
    let names = deck.parameters();
    assert_eq!(names.len(), numbers.len(), "{names:?}");
    let set = names.iter().map(|name| (*name).to_owned()).zip(numbers.iter().copied()).collect();
    (Program::new(&deck).unwrap_or_else(|faults| panic!("{faults}")), DataSet(set))
}

/// What is wrong with a text, all of it.
#[track_caller]
fn told(text: &str) -> String {
    match Deck::read(text, CardLayout::detect(text)).and_then(|deck| Program::new(&deck)) {
        Ok(_) => panic!("nothing is wrong with\n{text}"),
        Err(faults) => faults.to_string(),
    }
}
