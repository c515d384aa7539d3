//! Evaluation: the value of a side, under each reading that its characters allow.

pub(crate) mod atom;
pub(crate) mod binding;
mod cursor;
mod evaluation_bar;
pub(crate) mod exponent;
pub(crate) mod expression;
mod function;
pub(crate) mod interval;
pub(crate) mod numeral;
pub(crate) mod operation;
pub(crate) mod printed;
mod progression;
pub(crate) mod reading;
pub(crate) mod step_rounding;
mod units_after;
pub(crate) mod value;
mod whole;
