//! What the solver and other integrators cost, from the record.

use crate::measurements::{Measurement, integrators};
use geneva_press::chain::scientific;
use geneva_press::html::{Cells, Table, escape, table};

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
    let mut rows = Vec::new();
    for (contestant, words) in CONTESTANTS {
        for one in all.iter().filter(|one| one.contestant == contestant).filter(is_shown) {
            let evaluations = one.evaluations.map_or_else(|| "–".to_owned(), |count| count.to_string());
            let error = one.true_error.map_or_else(|| "–".to_owned(), |error| format!("{error:.0e}"));
            rows.push(Ok(vec![
                escape(words),
                scientific(&one.tolerance)?,
                evaluations,
                format!("{:.2}", one.milliseconds),
                scientific(&error)?,
            ]));
        }
    }
    let head = ["Solver", "Error allowed", "Evaluations", "Time for 49, ms", "Largest relative error"];
    table(
        "Cost and error of the solvers for 49 escapements, which cover all three mechanisms",
        Cells::NamedNumbers,
        &head,
        rows,
    )
}

/// Maps of the terminal speed: time against points.
pub fn maps() -> anyhow::Result<Table> {
    let all = integrators()?;
    let of_maps = all.iter().filter_map(|one| Some((one, one.points?, one.threads?)));
    let rows = of_maps.map(|(one, points, threads)| {
        Ok(vec![
            points.to_string(),
            scientific(&one.tolerance)?,
            threads.to_string(),
            format!("{:.2}", one.milliseconds / 1e3),
            format!("{:.2}", 1e3 * one.milliseconds / points as f64),
        ])
    });
    let head = ["Points", "Error allowed", "Threads", "Time, s", "Time per point, µs"];
    table(
        "Time for maps of the terminal speed over friction and inertias, for all three mechanisms",
        Cells::Numbers,
        &head,
        rows,
    )
}
