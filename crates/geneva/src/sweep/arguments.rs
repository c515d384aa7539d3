//! What can be said to `geneva sweep`.

use super::range::{Range, Spacing};
use crate::escapement::typed;
use clap::Args;
use std::num::NonZeroUsize;

/// Which escapements, and where their rows go.
#[derive(Args, Debug)]
pub struct SweepArguments {
    /// Numbers of slots of the follower, each 3, 4 or 6, with commas between
    #[arg(long, value_name = "N[,N...]", value_parser = typed::slots, value_delimiter = ',', required = true,
          allow_negative_numbers = true)]
    pub slots: Vec<u32>,
    /// Coefficients of friction between pin and slot, zero or more: FROM:TO:COUNT, FROM:TO:COUNT:log, or a single one
    #[arg(long, value_name = "RANGE", value_parser = range, allow_hyphen_values = true)]
    pub friction: Range,
    /// Moments of inertia of the driver over that of the follower, above zero
    #[arg(long, value_name = "RANGE", value_parser = range, allow_hyphen_values = true)]
    pub inertia_ratio: Range,
    /// Torques of the spring on the driver, above zero; speeds grow with their square root
    #[arg(long, value_name = "RANGE", value_parser = range, default_value = "1", allow_hyphen_values = true)]
    pub torque: Range,
    /// Moment of inertia of the follower about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, default_value = "1", allow_hyphen_values = true)]
    pub follower_inertia: f64,
    /// Turn of the driver in degrees after which its angle is put back to the pin's entering, one for all slots
    /// [default: 360 over the number of pins, which is what a mechanism does]
    #[arg(long, value_name = "D", value_parser = typed::degrees, allow_hyphen_values = true)]
    pub modulus_deg: Option<f64>,
    /// How the values of a range are spaced that does not say so itself
    #[arg(long, value_enum, default_value_t)]
    pub spacing: Spacing,
    /// How many threads compute; the rows do not depend on it
    /// [default: RAYON_NUM_THREADS, or as many as the machine has]
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub threads: Option<NonZeroUsize>,
    /// The file for the rows, or - for standard output; a file that is there is replaced when all rows are complete
    #[arg(long, value_name = "FILE")]
    pub output: String,
}

/// Most threads that may be asked for.
const MOST_THREADS: usize = 1024;

fn range(text: &str) -> Result<Range, String> {
    text.parse()
}

fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let number = text.parse().ok().filter(|number: &NonZeroUsize| number.get() <= MOST_THREADS);
    number.ok_or_else(|| format!("not a number of threads; give a whole number from 1 to {MOST_THREADS}"))
}
