//! The figures of the book by name: the ledger says for which mechanism, the figures draw it.

use crate::html::escape;
use anyhow::{Context, anyhow};
use geneva_figures::Figure;
use geneva_ledger::pin::Instant;

/// The names of all figures, in the order of the book.
pub const NAMES: &[&str] = &["pin-position", "pin-velocity", "pin-engagement"];

/// The figure of this name, for the printed data of its source.
pub fn by_name(name: &str) -> anyhow::Result<Figure> {
    let pin = || Instant::printed().context("the printed data make no mechanism");
    match name {
        "pin-position" => pin().map(|at| geneva_figures::pin::position_triangle(&at.mechanism, &at.crank)),
        "pin-velocity" => {
            pin().map(|at| geneva_figures::pin::velocity_triangle(&at.mechanism, &at.crank, at.driver_speed, "mm/s"))
        }
        "pin-engagement" => {
            pin().map(|at| geneva_figures::pin::over_the_engagement(&at.mechanism, &at.crank, at.driver_speed, "mm"))
        }
        _ => Err(anyhow!("no figure `{name}`; there are: {}", NAMES.join(", "))),
    }
}

/// The figure as HTML, with its number and caption.
pub fn figure(name: &str, number: &str) -> anyhow::Result<String> {
    let figure = by_name(name)?;
    Ok(format!(
        "<figure class=\"fig\" id=\"fig-{name}\">\n{}\n<figcaption><strong>Figure {number}.</strong> {}</figcaption>\n</figure>",
        figure.svg.trim_end(),
        escape(&figure.caption),
    ))
}
