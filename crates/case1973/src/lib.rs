//! What the runs of 1973 were: a study of printed tables of the Geneva escapement's runs.
//!
//! A thesis of 1973 prints the results of runs of a program, and parts of the program. What was run is not known for
//! sure. This crate asks what the runs might have been, makes them again, and says how well each possibility explains
//! the tables. The tables themselves are arguments: no number that a source prints is written here, and nothing here
//! knows of claims or books.
//!
//! ```
//! use geneva_case1973::{Given, Hypothesis, Listing, Row, Score};
//! use geneva_kinematics::Mechanism;
//! use std::f64::consts::{FRAC_PI_2, PI};
//!
//! // A program that resets after a quarter of a turn, prints every millisecond and stops after 0.3 s.
//! let listing =
//!     Listing { reset: FRAC_PI_2, pi: PI, first_line: 0.0, interval: 1e-3, duration: 0.3, delay: 1e-4 };
//! let inertias = [4e-6, 46e-6]; // driver and follower, in lb s²
//! let given = Given { headed: inertias, drawn: inertias, listing };
//! // Friction, torque, and what was printed: peak, minimum, rise time and period.
//! let rows = [Row::read(Mechanism::FOUR_PIN, ".22 .04 99 14 .036 .053", given)?];
//!
//! // All three results are explained by what was run, and with four pins by the mechanism as well.
//! assert_eq!(Score::new(Hypothesis::AS_RUN, &rows).within_one(), 3);
//! assert_eq!(Score::new(Hypothesis::IDEAL, &rows).within_one(), 3);
//! # Ok::<(), geneva_case1973::UnreadableRow>(())
//! ```
//!
//! - [`Row`]: a printed run, and what is given for it besides; [`series`], [`weakest`] and others: which rows stand for others.
//! - [`Hypothesis`]: what the runs might have been. This is the one place where a row is run.
//! - [`program`]: the program of 1973 on an integrator like its own; [`deck`]: the runs by a deck in its language.
//! - [`Run`]: what a run gives, and how it is read off the printed lines.
//! - [`Score`]: how well the runs of a hypothesis explain the tables.
//! - [`likelihood`], [`weighing`], [`chance`]: how likely the tables are, whether that depends on how the errors are
//!   taken, and what chance would explain.
//! - [`rise_times`]: which definition could be that of the rise times.
//! - [`fitted`]: friction, torque and inertias, found from the results.
//! - [`integrator`]: whether the tables depend on what is not known of the integrator.
//! - [`witness`]: second routes, which share no code with the others.

pub mod chance;
pub mod deck;
pub mod fitted;
mod hypothesis;
pub mod integrator;
pub mod likelihood;
pub mod program;
pub mod rise_times;
mod run;
mod scores;
mod tables;
pub mod weighing;
pub mod witness;

pub use hypothesis::{Constants, Hypothesis, Lag, PeakReading, Reset, SixPin, fitting_interval};
pub use run::Run;
pub use scores::{ColumnFit, ComparedCell, Score, compared_hypotheses, delays, within_one};
pub use tables::{
    Column, EXPLAINED, Given, Listing, Row, Trend, UnreadableRow, obeys, pairs_by_friction, pairs_by_torque, rows_of,
    rows_with_friction, rows_with_least_friction, series, slug, strongest, weakest,
};
pub use weighing::Weighing;
