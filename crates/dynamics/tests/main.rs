//! Compares the equation of motion, the steady state and the loads with exact proofs, other routes and laws of mechanics. The
//! files and folders are named after the modules that they test.

#![allow(clippy::unwrap_used, reason = "clippy knows the functions of a test program as tests only by #[test]")]

mod energy;
mod equation;
mod equation_proofs;
mod existence;
mod existence_proofs;
mod forces;
mod joints;
mod line_contact;
mod parameters;
mod pin_strength;
mod pose;
mod proving;
mod sign;
mod similarity;
mod singularity;
mod steady;
mod timer;
mod wheel_loads;
