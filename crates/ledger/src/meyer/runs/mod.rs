//! Appendix E: the runs of the computer, and what they were.
//!
//! - `table`: the printed rows.
//! - `motion`: a row's motion under a [`Hypothesis`], by two routes.
//! - `hypotheses`: how many cells each hypothesis explains.
//! - `cells`: the claims, one for each printed result.
//! - `steps`: the second route to the motion.
//! - `record`: the verdicts and fingerprints on record.
//! - `headings`: the inertias above the tables.

mod cells;
mod headings;
mod hypotheses;
mod motion;
mod record;
pub mod steps;
mod table;

pub use cells::{claims, lines};
pub use headings::of_figures;
pub use hypotheses::{Score, scores};
pub use motion::{Fold, Hypothesis, Reading, Run, SixPin, fitting_interval, interval};
pub use table::{Column, Mechanism, Row, rows};

use super::*;
use geneva_dynamics::{Inertias, Parameters, Slots};
