//! The numbers that the formulas run on.

mod jet;
mod surd;
mod turn;
