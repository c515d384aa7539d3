//! The quick-return lever: positions, motion and proofs.

mod linkage;
mod motion;
mod proofs;
mod series;
