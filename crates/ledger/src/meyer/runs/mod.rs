//! Appendix E: the runs of the computer, and what they were.
//!
//! - `table`: the printed rows, with the verdicts on record of their results.
//! - `motion`: a row's motion under a [`Hypothesis`], by two routes.
//! - `scores`: how well computed numbers explain printed ones.
//! - `hypotheses`: how many cells each hypothesis explains.
//! - `weighing`: by how much one hypothesis makes the tables likelier than others.
//! - `chance`: what chance would explain.
//! - `rise_times`: which definition could be that of the rise times.
//! - `integrator`: whether the tables depend on what is not known of the integrator.
//! - `cells`: the claims, one for each printed number.
//! - `data`: friction, torque and inertias, found from the results.
//! - `steps`, `lagged`: the second routes, to the motion of the mechanism and to the runs with the lagged sign.
//! - `choice`: which rows stand for the others where not all are shown.
//! - `words`: a hypothesis in words.
//! - `deck`: the runs by a deck in the language of the thesis.
//! - `headings`: the claims of the inertias above the tables.

mod cells;
pub mod chance;
pub mod choice;
pub mod data;
pub mod deck;
mod headings;
mod hypotheses;
pub mod integrator;
mod lagged;
mod motion;
pub mod rise_times;
mod scores;
pub mod steps;
mod table;
mod weighing;
mod words;

pub use cells::claims;
pub use headings::{of_figures, of_headings};
pub use hypotheses::{EXPLAINED, Score, delays, scores};
pub use lagged::Lagged;
pub use motion::{
    Constants, Hypothesis, Reading, Reset, Run, SixPin, delay, duration, fitting_interval, interval, printouts, usual,
};
pub use scores::{Fit, within_one};
pub use table::{Column, Row, rows, series, slug};
pub use weighing::Weighing;

use super::*;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
