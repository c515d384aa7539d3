//! The Geneva escapement: its kinds, its hand-over, and each line of the source.

mod clearance;
mod configuration;
mod continuous;
mod entry_proofs;
mod geometry;
