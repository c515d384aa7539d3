//! The numbers that the formulas run on.

pub(crate) mod field;
pub(crate) mod jet;
pub(crate) mod surd;
pub(crate) mod turn;
