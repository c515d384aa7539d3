//! One quick-return mechanism at an instant: where its parts are, every velocity and acceleration, or a drawing.

mod arguments;
mod assembly;
mod digits;
mod instant;
mod record;
mod sheet;
mod vector;
mod words;

pub use arguments::QuickReturnArguments;

use crate::sheet::standalone;
use anyhow::ensure;
use arguments::{FigureName, QuickReturnFormat};
use assembly::Assembly;
use clap::ValueEnum;
use geneva_figures::quick_return::{acceleration_diagram, mechanism, velocity_diagram};
use record::QuickReturnRecord;

/// The mechanism that is wanted, as it is wanted.
pub fn page(wanted: &QuickReturnArguments) -> anyhow::Result<String> {
    if let Some(figure) = wanted.figure {
        let name = figure.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
        ensure!(
            wanted.format == QuickReturnFormat::Svg,
            "--figure {name}: only a drawing has one; give --format svg with it, or leave it out"
        );
    }
    let assembly = Assembly::new(wanted)?;
    let record = QuickReturnRecord::new(&assembly)?;
    match wanted.format {
        QuickReturnFormat::Text => Ok(sheet::page(&record)),
        QuickReturnFormat::Json => Ok(serde_json::to_string_pretty(&record)? + "\n"),
        QuickReturnFormat::Svg => Ok(standalone(&drawing(&assembly, wanted.figure.unwrap_or_default())) + "\n"),
    }
}

/// The drawing that is wanted, as it is in a page.
fn drawing(Assembly { linkage, position, drive, .. }: &Assembly, figure: FigureName) -> String {
    let draw = match figure {
        FigureName::Mechanism => mechanism,
        FigureName::Velocity => velocity_diagram,
        FigureName::Acceleration => acceleration_diagram,
    };
    draw(linkage, position, drive, "m").svg
}
