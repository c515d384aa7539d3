//! What a run computes, against closed forms and other integrators, and what the language makes of decks: one file, one
//! question.

mod accuracy;
mod delay_line;
mod errors;
mod grid;
mod language;
mod one_step;
mod problems;
mod steps;
mod switches;
