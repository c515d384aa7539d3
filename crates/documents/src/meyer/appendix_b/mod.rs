//! Appendix B: how the equation of motion was solved on the computer, and the program.

mod after;
mod cards;
mod contact;
mod counts;
mod example;
pub(super) mod listing;
mod listing_start;
mod method;
mod print_out;
mod program;
mod program_letters;
mod reset;
mod stages;

pub(super) use listing_start::start_solves;
pub(super) use program::{start_formula, start_line};
pub(super) use program_letters::holds_from_rest;

use super::instants::{equal, holds, instants, letters_of, moments};
use super::*;

pub(super) fn claims() -> Vec<Claim> {
    [
        example::claims(),
        method::claims(),
        counts::claims(),
        contact::claims(),
        listing::claims(),
        listing_start::claims(),
        after::claims(),
        cards::claims(),
        print_out::claims(),
    ]
    .concat()
}
