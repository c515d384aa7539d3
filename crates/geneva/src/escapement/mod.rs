//! One escapement: whether it runs, its steady state, its rise from rest, the run itself, or a drawing.

mod arguments;
pub mod assembly;
mod record;
mod run;
mod sheet;
pub mod typed;
mod units;

pub use arguments::EscapementArguments;
pub use record::rise;

use crate::sheet::standalone;
use anyhow::ensure;
use arguments::{EscapementFormat, FigureName};
use assembly::{Assembly, own_modulus, unsteady};
use clap::ValueEnum;
use geneva_figures::escapement::{mechanism, normal_force};
use geneva_figures::runs::speeds;
use record::EscapementRecord;

/// The escapement that is wanted, as it is wanted.
pub fn page(wanted: &EscapementArguments) -> anyhow::Result<String> {
    for (option, value) in [("--duration", wanted.duration), ("--interval", wanted.interval)] {
        if let Some(value) = value {
            typed::computable(option, value)?;
            ensure!(
                wanted.format == EscapementFormat::Csv,
                "{option} {}: only a run has one; give --format csv with it, or leave it out",
                typed::again(value)
            );
        }
    }
    if let Some(figure) = wanted.figure {
        let name = figure.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
        ensure!(
            wanted.format == EscapementFormat::Svg,
            "--figure {name}: only a drawing has one; give --format svg with it, or leave it out"
        );
    }
    let assembly = Assembly::new(wanted)?;
    match wanted.format {
        EscapementFormat::Csv => run::csv(&assembly, wanted.duration, wanted.interval),
        EscapementFormat::Svg => Ok(standalone(&drawing(wanted, &assembly)?) + "\n"),
        EscapementFormat::Text => Ok(sheet::page(&record(wanted, &assembly)?)),
        EscapementFormat::Json => Ok(serde_json::to_string_pretty(&record(wanted, &assembly)?)? + "\n"),
    }
}

fn record(wanted: &EscapementArguments, assembly: &Assembly) -> anyhow::Result<EscapementRecord> {
    let record = EscapementRecord::new(assembly).map_err(|error| unsteady(wanted, error))?;
    ensure!(record.is_finite(), assembly::too_short(assembly.modulus_deg));
    Ok(record)
}

/// The drawing that is wanted, as it is in a page.
fn drawing(wanted: &EscapementArguments, assembly: &Assembly) -> anyhow::Result<String> {
    let parameters = &assembly.parameters;
    Ok(match wanted.figure.unwrap_or_default() {
        FigureName::Mechanism => {
            let escapement = parameters.mechanism();
            mechanism(&escapement, -escapement.engagement_half_angle() / 3.0)?.svg
        }
        FigureName::NormalForce => {
            if let Some(modulus) = wanted.modulus_deg {
                ensure!(
                    modulus == own_modulus(parameters.mechanism()),
                    "--modulus-deg {}: the normal force is drawn over an engagement of the mechanism; leave it out",
                    typed::again(modulus)
                );
            }
            let steady = assembly.engagement.steady_state().map_err(|error| unsteady(wanted, error))?;
            normal_force(parameters, steady.entry_speed)?.svg
        }
        FigureName::Run => {
            assembly.engagement.steady_state().map_err(|error| unsteady(wanted, error))?;
            speeds(&assembly.engagement, "")?.svg
        }
    })
}
