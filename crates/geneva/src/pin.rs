//! A pin in the slot of a Geneva wheel at an instant: the answers, and the solution step by step.

use crate::fields;
use crate::output::TextLayout;
use crate::typed::{self, CommandFormat, Output, SpeedArguments, formats, steps};
use clap::Args;
use geneva_ask::pin::{AxisDistance, PinDesign, PinQuestion};
use geneva_ask::worked::{AngleOrigin, LengthUnit};

/// Options of `geneva pin`.
#[derive(Args, Debug)]
pub(crate) struct PinArguments {
    /// Distance of the pin's centre from the driver's axis, above zero
    #[arg(long, value_name = "LENGTH", value_parser = typed::positive, allow_hyphen_values = true)]
    pub crank_radius: f64,
    /// How far the axes are apart: one of the two.
    #[command(flatten)]
    pub axes: AxisArguments,
    /// The crank's angle: one of the two.
    #[command(flatten)]
    pub angle: CrankArguments,
    /// The driver's speed: one of the two.
    #[command(flatten)]
    pub speed: SpeedArguments,
    /// Unit of all lengths
    #[arg(long, default_value = "mm", value_parser = typed::value_named(&LengthUnit::ALL, LengthUnit::name, LengthUnit::in_words))]
    pub unit: LengthUnit,
    /// Show the solution step by step with your numbers, as one writes it for homework; only with --format text
    #[arg(long)]
    pub steps: bool,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "A readable sheet, which says in which sense everything moves"),
        (CommandFormat::Json, "An object with all digits"),
        (CommandFormat::Fields, "The numbers as CSV: a row with key, name, value, unit and meaning for each"),
    ]))]
    pub format: CommandFormat,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// How far the two axes are apart.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct AxisArguments {
    /// Distance between the two axes, greater than the crank radius; give this or --stations
    #[arg(long, value_name = "LENGTH", value_parser = typed::positive, allow_hyphen_values = true)]
    pub centre_distance: Option<f64>,
    /// Number of slots of a wheel that is at rest when the pin enters; give this or --centre-distance
    #[arg(long, value_name = "N", value_parser = typed::stations, allow_negative_numbers = true)]
    pub stations: Option<u32>,
}

/// The angle of the crank, counted in the sense in which the driver turns.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct CrankArguments {
    /// Crank angle in degrees from the line of centres, negative before the pin is nearest to the wheel's axis; give this or
    /// --angle-from-extension
    #[arg(long, value_name = "DEG", value_parser = typed::finite_degrees, allow_hyphen_values = true)]
    pub angle: Option<f64>,
    /// Crank angle in degrees from the extension of the line of centres beyond the driver's axis; give this or --angle
    #[arg(long, value_name = "DEG", value_parser = typed::finite_degrees, allow_hyphen_values = true)]
    pub angle_from_extension: Option<f64>,
}

impl PinArguments {
    /// One of each two was given; the parser sees to that.
    fn question(&self) -> PinQuestion {
        let axes = match (self.axes.centre_distance, self.axes.stations) {
            (_, Some(stations)) => AxisDistance::Stations(stations),
            (length, None) => AxisDistance::Length(length.unwrap_or_default()),
        };
        let (origin, angle) = match (self.angle.angle, self.angle.angle_from_extension) {
            (_, Some(angle)) => (AngleOrigin::Extension, angle),
            (angle, None) => (AngleOrigin::LineOfCentres, angle.unwrap_or_default()),
        };
        PinQuestion { crank_radius: self.crank_radius, axes, angle, origin, speed: self.speed.given(), unit: self.unit }
    }
}

/// The pin that is wanted, in the format that is wanted.
pub(crate) fn page(wanted: &PinArguments, layout: TextLayout) -> anyhow::Result<String> {
    CommandFormat::Text.only_with(wanted.format, "--steps", wanted.steps.then(String::new), "a readable sheet")?;
    let design = PinDesign::new(&wanted.question())?;
    let answer = design.answer();
    match wanted.format {
        CommandFormat::Json => fields::json(&answer),
        CommandFormat::Fields => Ok(answer.table()),
        _ if wanted.steps => Ok(fields::sheet(&answer, layout) + &steps(&design.steps(), layout)),
        _ => Ok(fields::sheet(&answer, layout)),
    }
}
