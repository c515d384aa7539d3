//! Appendix E: the runs of the computer, and what they were.
//!
//! What the runs were is a study of its own, in `geneva-case1973`, which knows no printed number. Here is what is printed,
//! the study of it, and the claims.
//!
//! - `table`: the printed rows, with the verdicts on record of their results.
//! - `choice`: which rows stand for the others where not all are shown.
//! - `study`: what `geneva-case1973` makes of them.
//! - `statistics`: the numbers of our own on which the study rests, by two routes.
//! - `cells`: the claims, one for each printed number.
//! - `data`: the claims of friction, torque and inertias, which are found from the results.
//! - `headings`: the claims of the inertias above the tables.

mod cells;
pub mod choice;
pub mod data;
mod headings;
pub mod statistics;
mod study;
mod table;

pub use cells::claims;
pub use geneva_case1973::{
    Column, Constants, EXPLAINED, Fit, Given, Hypothesis, Lag, Listing, Reading, Reset, Row, Run, Score, SixPin,
    Weighing, slug,
};
pub use headings::{of_figures, of_headings};
pub use study::{deck, delays, fitting_interval, interval, listing, rise_times, rows, scores, series, within_one};
pub use table::expected;

use super::*;
use crate::by_id::decimal;
use geneva_kinematics::Mechanism;
