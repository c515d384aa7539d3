//! Appendix E: the runs of the computer, and what they were.
//!
//! What the runs were is a study of its own, in `geneva-case1973`, which knows no printed number. Here is what is printed,
//! the study of it, and the claims.
//!
//! - `table`: the printed rows, with the verdicts on record of their results, and what is given for all runs.
//! - `choice`: which rows stand for the others where not all are shown.
//! - `cache`: results of all rows, kept once they are computed.
//! - `study`: what `geneva-case1973` makes of the tables and takes long.
//! - `statistics`: the numbers of our own on which the study rests, by two routes.
//! - `cells`: the claims, one for each printed number.
//! - `data`: the claims of friction, torque and inertias, which are found from the results.
//! - `headings`: the claims of the inertias above the tables.

mod cache;
pub(super) mod cells;
pub mod choice;
pub mod data;
pub(super) mod headings;
pub mod statistics;
pub mod study;
pub mod table;
