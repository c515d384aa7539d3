//! Of the chapter on the solver: what it takes, from the record.

use super::Number;
use crate::measurements::{Measurement, integrators};
use anyhow::Context;

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("solver.escapements", || Ok(each()?.1.to_string())),
    ("solver.steady-state", || Ok(format!("{:.0} µs", each()?.0))),
];

/// Microseconds for the steady state of one escapement, and how many were found.
fn each() -> anyhow::Result<(f64, u32)> {
    let is_asked = |one: &Measurement| one.contestant == "angle-steady" && one.tolerance == "1e-10";
    let found = integrators()?.into_iter().find(is_asked).context("no such measurement in the record")?;
    let runs = found.runs.context("a measurement without runs")?;
    Ok((1e3 * found.milliseconds / f64::from(runs), runs))
}
