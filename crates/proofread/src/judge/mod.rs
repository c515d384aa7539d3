//! Judging: whether two neighbouring sides agree, what may explain that they do not, and whether that may be a misreading.

mod bracket_symbols;
pub(crate) mod chain_verdict;
pub(crate) mod counted_nouns;
pub(crate) mod denial;
pub(crate) mod doubt;
mod equals_conventions;
pub(crate) mod explanation;
mod flattened;
pub(crate) mod frequent;
pub(crate) mod letter_units;
mod lost_digits;
pub(crate) mod money;
mod notation;
pub(crate) mod number_columns;
mod number_marks;
mod other_arithmetic;
pub(crate) mod running_calculation;
pub(crate) mod section;
mod seldom_real;
mod substitution;
pub(crate) mod surroundings;
mod two_equations;
pub(crate) mod unchecked;
pub(crate) mod unrounded;
pub(crate) mod verdict;
