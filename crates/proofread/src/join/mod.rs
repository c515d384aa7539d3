//! Joining: what readers leave in pieces becomes the tokens that are evaluated, and these become chains of sides.

pub(crate) mod chain;
mod congruence;
mod equation_columns;
mod joined_operations;
pub(crate) mod matrix_sides;
mod split_units;
pub(crate) mod token_joining;
