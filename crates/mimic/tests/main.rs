//! What a run computes, against closed forms and other integrators: one file, one question.

mod accuracy;
mod delay_line;
mod errors;
mod grid;
mod problems;
mod steps;
mod switches;
