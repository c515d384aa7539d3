//! The program, its runs and the statistics, on invented rows: no number of a source is known here. What the printed
//! tables say is tested where they are, in the ledger. The files are named after the modules that they test.

#![allow(clippy::unwrap_used, reason = "clippy knows the functions of a test program as tests only by #[test]")]

mod chance;
mod fitted;
mod hypothesis;
mod likelihood;
mod program;
mod run;
mod tables;
mod witness;
