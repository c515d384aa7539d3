//! What the solver and other integrators cost, from the record.

use crate::measurements::{Measurement, integrators};
use geneva_press::chain::scientific;
use geneva_press::html::escape;
use geneva_press::table::{Cells, Table};

/// The contestants of the record and what they are, in the order of the table.
pub const CONTESTANTS: [(&str, &str); 8] = [
    ("angle-terminal", "over the angle: entry speed and period"),
    ("angle-steady", "over the angle: steady state"),
    ("angle-run", "over the angle: run"),
    ("dopri5", "Dopri5: run"),
    ("dop853", "Dop853: run"),
    ("dopri5-located", "Dopri5, switches located: run"),
    ("dop853-located", "Dop853, switches located: run"),
    ("mimic", "the program of 1973: run"),
];

/// Cost and true error at a few tolerances.
pub fn speeds() -> anyhow::Result<Table> {
    let all = integrators()?;
    let is_shown = |one: &&Measurement| {
        ["1e-6", "1e-9", "1e-12"].contains(&one.tolerance.as_str())
            || one.contestant.starts_with("angle") && one.tolerance == "1e-10"
            || one.contestant == "mimic" && ["5e-6", "5e-8", "5e-10"].contains(&one.tolerance.as_str())
    };
    let of = |contestant| all.iter().filter(move |one| one.contestant == contestant).filter(is_shown);
    let rows = CONTESTANTS.into_iter().flat_map(|(name, words)| of(name).map(move |one| (words, one)));
    let dash = || "–".to_owned();
    Table::with_rows(Cells::NamedNumbers, rows)
        .column("Solver", |(words, _)| escape(words))
        .column("Error allowed", |(_, one)| scientific(&one.tolerance))
        .column("Evaluations", |(_, one)| one.evaluations.map_or_else(dash, |count| count.to_string()))
        .column("Time for 49, ms", |(_, one)| format!("{:.2}", one.milliseconds))
        .column("Largest relative error", |(_, one)| {
            scientific(&one.true_error.map_or_else(dash, |error| format!("{error:.0e}")))
        })
        .finish()
}

/// Maps of the terminal speed: time against points.
pub fn maps() -> anyhow::Result<Table> {
    let all = integrators()?;
    let of_maps = all.iter().filter_map(|one| Some((one, one.points?, one.threads?)));
    Table::with_rows(Cells::Numbers, of_maps)
        .column("Points", |(_, points, _)| points.to_string())
        .column("Error allowed", |(one, ..)| scientific(&one.tolerance))
        .column("Threads", |(.., threads)| threads.to_string())
        .column("Time, s", |(one, ..)| format!("{:.2}", one.milliseconds / 1e3))
        .column("Time per point, µs", |(one, points, _)| format!("{:.2}", 1e3 * one.milliseconds / *points as f64))
        .finish()
}
