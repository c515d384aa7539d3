//! Proof of an algebraic identity by exact evaluation at enough points.

pub(crate) mod degree;
pub(crate) mod expression;
pub(crate) mod identity;
mod numerator;
