//! Of the chapter on the wheel of N stations: what the answer about its exercise's wheel doesn't have.

use super::{Number, with_unit};
use crate::asked::design;
use anyhow::Context;

/// The numbers of this chapter.
pub const NUMBERS: &[(&str, Number)] = &[("jazar.exercise.turn", || {
    // Seconds of a turn of the driver.
    Ok(with_unit(60.0 / design("eight")?.question.rpm.context("a speed")?, 2, "s"))
})];
