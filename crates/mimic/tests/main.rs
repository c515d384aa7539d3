//! What a run computes, against closed forms and other integrators: one file, one question.

mod accuracy;
mod bits;
mod controller;
mod delay_line;
mod delayed_systems;
mod errors;
mod grid;
mod order;
mod problems;
mod switches;
mod work;
