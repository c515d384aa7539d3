//! What a run computes, against closed forms and other integrators, and what the language makes of decks: one file, one
//! question.

mod accuracy;
mod delay_line;
mod errors;
mod language;
mod one_step;
mod print_times;
mod problems;
mod steps;
mod switches;
