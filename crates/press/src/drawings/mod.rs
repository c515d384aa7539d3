//! The figures of the book by name: the ledger says for which mechanism, the figures draw it.

mod escapement;
mod joints;
mod runs;
mod solver;
mod steady;

use crate::html::escape;
use anyhow::{Context, anyhow};
use geneva_figures::{Figure, quick_return, stations};
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn};
use geneva_kinematics::wheel::Wheel;
use geneva_ledger::{jazar, pin::Instant, quick_return::Instant as Lever};

/// The names of all figures, in the order of the book.
pub const NAMES: &[&str] = &[
    "pin-position",
    "pin-velocity",
    "pin-engagement",
    "quick-return-mechanism",
    "quick-return-velocity",
    "quick-return-acceleration",
    "quick-return-turn",
    "wheel-mechanism",
    "wheel-model",
    "wheel-critical",
    "wheel-advance",
    "wheel-motion",
    "wheel-extremes",
    "escapement-mechanism-4",
    "escapement-hand-over-4",
    "escapement-mechanism-3",
    "escapement-mechanism-6",
    "escapement-angles-4",
    "escapement-ratios",
    "escapement-forces",
    "escapement-normal-force",
    "escapement-existence",
    "integrator-order",
    "runs-hypotheses",
    "runs-aliasing",
    "runs-speeds",
    "runs-four-pin",
    "runs-six-pin",
    "runs-three-pin",
    "steady-collapse",
    "steady-hand-over",
    "steady-phase",
    "steady-map-four-pin",
    "steady-map-six-pin",
    "steady-map-three-pin",
    "joints-losses",
    "solver-work-precision",
];

/// Crank angle at which the model of a wheel is drawn: wide enough apart from the line of centres to see the angles.
const MODEL_ANGLE: f64 = 0.5;

/// The figure of this name, for the printed data of its source.
pub fn by_name(name: &str) -> anyhow::Result<Figure> {
    let pin = || Instant::printed().context("the printed data make no mechanism");
    let four = || jazar::four_stations().context("the source's wheel cannot be built");
    match name {
        "pin-position" => pin().map(|at| geneva_figures::pin::position_triangle(&at.mechanism, &at.crank)),
        "pin-velocity" => {
            pin().map(|at| geneva_figures::pin::velocity_triangle(&at.mechanism, &at.crank, at.driver_speed, "mm/s"))
        }
        "pin-engagement" => {
            pin().map(|at| geneva_figures::pin::over_the_engagement(&at.mechanism, &at.crank, at.driver_speed, "mm"))
        }
        "quick-return-mechanism" => lever(quick_return::mechanism),
        "quick-return-velocity" => lever(quick_return::velocity_diagram),
        "quick-return-acceleration" => lever(quick_return::acceleration_diagram),
        "quick-return-turn" => lever(|linkage, position, drive, _| quick_return::over_a_turn(linkage, position, drive)),
        "wheel-mechanism" => four().map(|wheel| stations::mechanism(&wheel)),
        "wheel-model" => Ok(stations::model(&four()?, MODEL_ANGLE)?),
        "wheel-critical" => {
            let wheel: Wheel = jazar::example().context("the example's wheel cannot be built")?;
            Ok(stations::critical_geometry(&wheel))
        }
        "wheel-advance" => four().map(|wheel| stations::advance(&wheel)),
        "wheel-motion" => four().map(|wheel| stations::motion(&wheel)),
        "wheel-extremes" => Ok(stations::extremes(3..=18)),
        _ => escapement::by_name(name)
            .or_else(|| runs::by_name(name))
            .or_else(|| steady::by_name(name))
            .or_else(|| (name == "joints-losses").then(joints::losses))
            .or_else(|| (name == "solver-work-precision").then(solver::work_precision))
            .unwrap_or_else(|| Err(anyhow!("no figure `{name}`; there are: {}", NAMES.join(", ")))),
    }
}

/// A drawing of the quick-return mechanism at the printed instant, in metres.
fn lever(draw: fn(&QuickReturn, &Position, &Drive<f64>, &str) -> Figure) -> anyhow::Result<Figure> {
    let at = Lever::printed().context("the printed data make no quick-return mechanism")?;
    Ok(draw(&at.linkage, &at.position, &at.drive, "m"))
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
