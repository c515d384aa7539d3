//! The quick-return lever: positions, motion and proofs.

mod frame_proofs;
mod linkage;
mod motion;
mod proofs;
mod series;
