//! The motion of wheels, escapements and levers, against exact proofs, other routes and other people's numbers. The files
//! and folders are named after the modules that they test; `accuracy` compares with 240 bits.

#![allow(clippy::unwrap_used, reason = "clippy knows the functions of a test program as tests only by #[test]")]

mod accuracy;
mod bisection;
mod escapement;
mod indexing;
mod internal_assemblies;
mod internal_clearance;
mod internal_sizes;
mod internal_wheel;
mod internal_wheel_proofs;
mod oracle;
mod pin_proofs;
mod pin_slot;
mod pin_triangle;
mod pin_vectors;
mod quick_return;
mod relative_motion;
mod spherical_wheel;
mod spherical_wheel_proofs;
mod wheel;
mod wheel_jerk_proofs;
mod wheel_peak_proofs;
mod wheel_proofs;
