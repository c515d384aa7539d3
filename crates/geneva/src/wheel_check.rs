//! A wheel that exists: does it turn, and which of its measured sizes contradicts the others?

use crate::fields::{self, SheetUnit, SheetUnitArgument};
use crate::output::TextLayout;
use crate::typed::{self, CommandFormat, Output, formats};
use anyhow::{Context, bail};
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use geneva_ask::length_units::TypedLengths;
use geneva_ask::wheel::{CHECK_ARGUMENTS, CheckQuestion, LayerNames, UNCERTAINTY, mouth_arguments};
use std::fs;
use std::path::PathBuf;

/// Options of `geneva wheel check`.
#[derive(Args, Debug)]
pub(crate) struct CheckArguments {
    /// Number of slots of the wheel; a drawing says it itself
    #[arg(long, value_name = "N", value_parser = typed::stations, required_unless_present = "dxf", conflicts_with = "dxf")]
    pub stations: Option<u32>,
    /// Number of pins of the driver [default: 1]
    #[arg(long, value_name = "P", value_parser = typed::pins, conflicts_with = "dxf")]
    pub pins: Option<u32>,
    /// The measured sizes.
    #[command(flatten)]
    pub sizes: MeasuredSizes,
    /// Standard uncertainty of sizes without one of their own [default: 0.05, that of a calliper]
    #[arg(long, value_name = "MM", value_parser = typed::millimetres, allow_hyphen_values = true)]
    pub uncertainty: Option<f64>,
    /// Take the sizes from a drawing in DXF, with a part on each layer; what is typed besides counts, too
    #[arg(long, value_name = "FILE")]
    pub dxf: Option<PathBuf>,
    /// The layer of a part in the drawing, as wheel=NAME, disc=NAME, plate=NAME or pins=NAME, if it isn't that of our files; can be
    /// repeated
    #[arg(long, value_name = "PART=NAME", requires = "dxf")]
    pub layer: Vec<String>,
    /// Speed of the driver in turns per minute; adds blows in mm/s
    #[arg(long, value_name = "R", value_parser = typed::positive, allow_hyphen_values = true)]
    pub rpm: Option<f64>,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "A readable report: does it turn, which size is wrong, what to change first"),
        (CommandFormat::Json, "An object with all digits"),
        (CommandFormat::Csv, "The measurements, one row for each, with what the nearest right wheel has"),
        (CommandFormat::Fields, "The numbers as CSV: a row with key, name, value, unit and meaning for each"),
    ]))]
    pub format: CommandFormat,
    /// The unit of the lengths on the sheet.
    #[command(flatten)]
    pub unit: SheetUnitArgument,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Measured sizes as they are typed, by the names of their options.
#[derive(Clone, Debug, Default)]
pub(crate) struct MeasuredSizes(Vec<(&'static str, String)>);

/// The sizes that can be typed, each with its name, the word for its value, and its help: those that are measured, and those of the mouths.
fn typed_sizes() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let measured = CHECK_ARGUMENTS.iter().map(|of| (of.name, of.value, of.help));
    measured.chain(mouth_arguments().map(|of| (of.name, of.unit, of.help)))
}

impl Args for MeasuredSizes {
    fn augment_args(command: Command) -> Command {
        command.args(typed_sizes().map(|(name, value, help)| {
            Arg::new(name).long(name).value_name(value).help(help).allow_hyphen_values(true)
        }))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for MeasuredSizes {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut sizes = Self::default();
        sizes.update_from_arg_matches(matches)?;
        Ok(sizes)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        let given = typed_sizes().filter_map(|(name, ..)| Some((name, matches.get_one::<String>(name)?.clone())));
        self.0 = given.collect();
        Ok(())
    }
}

/// What is said of the wheel, in the format that is wanted. What is refused is told in the units that were typed.
pub(crate) fn page(wanted: &CheckArguments, layout: TextLayout) -> anyhow::Result<String> {
    let mut typed = TypedLengths::new(wanted.unit.unit == SheetUnit::In);
    let lengths: Vec<&str> = typed_sizes().filter(|(_, value, _)| *value == "MM").map(|(name, ..)| name).collect();
    for (name, text) in wanted.sizes.0.iter().filter(|(name, _)| lengths.contains(name)) {
        typed.add(name, text);
    }
    answer(wanted, layout).map_err(|refused| fields::in_typed_units(refused, &typed, &lengths))
}

fn answer(wanted: &CheckArguments, layout: TextLayout) -> anyhow::Result<String> {
    wanted.unit.reject_without_sheet(wanted.format)?;
    let uncertainty = wanted.uncertainty.unwrap_or(UNCERTAINTY);
    let mut question = match (&wanted.dxf, wanted.stations) {
        (Some(path), _) => {
            let text = fs::read_to_string(path).with_context(|| {
                format!("--dxf {}: the drawing cannot be read; give a text file in DXF", path.display())
            })?;
            CheckQuestion::of_drawing(&text, &layers(&wanted.layer)?, uncertainty)
                .with_context(|| format!("--dxf {}", path.display()))?
        }
        (None, Some(stations)) => CheckQuestion::new(stations, wanted.pins.unwrap_or(1))?,
        (None, None) => bail!("--stations is missing; give the number of slots, or --dxf FILE"),
    };
    for (name, text) in &wanted.sizes.0 {
        question.add(name, text, uncertainty)?;
    }
    question.rpm = wanted.rpm;
    let report = question.answer()?;
    Ok(match wanted.format {
        CommandFormat::Json => fields::json(&report)?,
        CommandFormat::Fields => report.table(),
        CommandFormat::Csv => fields::csv(report.rows().next(), report.rows().cloned())?,
        _ => fields::sheet(&fields::with_lengths_in(wanted.unit.unit, report), layout),
    })
}

/// The names of the layers, with those that were given.
fn layers(given: &[String]) -> anyhow::Result<LayerNames> {
    let mut names = LayerNames::default();
    for text in given {
        let (part, name) = text.split_once('=').unwrap_or((text, ""));
        let place = match part {
            "wheel" => &mut names.wheel,
            "disc" => &mut names.disc,
            "plate" => &mut names.plate,
            "pins" => &mut names.pins,
            _ => bail!("--layer {text}: no such part; give wheel=NAME, disc=NAME, plate=NAME or pins=NAME"),
        };
        if name.is_empty() {
            bail!("--layer {text}: the layer's name is missing; give {part}=NAME");
        }
        name.clone_into(place);
    }
    Ok(names)
}
