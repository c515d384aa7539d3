//! Second routes to what the other modules compute, which share no code with them.
//!
//! A witness and what it vouches for have the same questions in common (a [`Row`](crate::Row), a
//! [`Hypothesis`](crate::Hypothesis), the cards of the [`Program1973`](crate::program::Program1973)) and nothing that answers
//! them. No witness calls the solution over the angle, the program's run or a statistic of this crate, and nothing in
//! this crate calls a witness. A test of the repository's rules makes sure of both.
//!
//! They are here and not in the ledger, because they need no printed number either. `steps` and what builds on it take the
//! factors of the equation of motion from `geneva-dynamics`, where the equation is proven exactly; `lagged` has forces of
//! its own. The likelihoods and the chances start from the results of a [`Score`](crate::Score), as the first routes do.
//!
//! - `lagged`: the runs with the lagged sign, from Newton's laws, with steps and events of its own;
//! - `steps`: the steady motion in equal steps of the driver's angle;
//! - `gauss_newton`: the data of the runs, by the method of Gauss and Newton over the motion in steps;
//! - `densities`: how likely the tables are, by the densities of the errors;
//! - `sampling`: what chance would explain, by deals of another kind.

pub mod densities;
pub mod gauss_newton;
mod lagged;
pub mod sampling;
pub mod steps;

pub use lagged::{lagged_run, run_with_lag};
