//! Appendix B: how the equation of motion was solved on the computer, and the program.

mod after;
mod contact;
mod example;
mod fold;
mod listing;
mod listing_start;
mod method;
mod program;

pub use program::DELAY_PARTS;

use super::instants::{Value, display, equal, instants, miscopied, reads, slip, statement};
use super::*;

pub fn claims() -> Vec<Claim> {
    [
        example::claims(),
        method::claims(),
        contact::claims(),
        listing::claims(),
        listing_start::claims(),
        after::claims(),
    ]
    .concat()
}
