//! What the runs of 1973 were: a study of printed tables of the Geneva escapement's runs.
//!
//! A thesis of 1973 prints the results of runs of a program, and parts of the program. What was run is not known for
//! sure. This crate asks what the runs might have been, makes them again, and says how well each possibility explains
//! the tables. The tables themselves are arguments: no number that a source prints is written here, and nothing here
//! knows of claims or books.
//!
//! - [`Row`]: a printed run, and what is given for it besides; `choice`: which rows stand for others.
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
pub mod choice;
pub mod deck;
pub mod fitted;
mod hypothesis;
pub mod integrator;
pub mod likelihood;
pub mod program;
pub mod rise_times;
mod row;
mod run;
mod scores;
pub mod weighing;
pub mod witness;

pub use hypothesis::{Constants, Hypothesis, Lag, Reading, Reset, SixPin, fitting_interval};
pub use row::{Column, EXPLAINED, Given, Listing, Row, Unreadable, series, slug};
pub use run::Run;
pub use scores::{Cell, Fit, Score, compared, delays, within_one};
pub use weighing::Weighing;
