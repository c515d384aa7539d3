//! One escapement: whether it runs, its steady state, its rise from rest, the run itself, or a drawing.

use crate::fields;
use crate::output::TextLayout;
use crate::typed::{self, CommandFormat, Output, as_typed, formats, name_of};
use clap::{Args, ValueEnum};
use geneva_ask::escapement::{EscapementDesign, EscapementDrawing, EscapementQuestion, Further, UnitSystem};

/// Options of `geneva escapement`.
#[derive(Args, Debug)]
pub(crate) struct EscapementArguments {
    /// Number of slots of the follower: 3, 4 or 6; the driver then has 6, 4 or 3 pins
    #[arg(long, value_name = "N", value_parser = typed::slots, allow_negative_numbers = true)]
    pub slots: u32,
    /// Coefficient of friction between pin and slot, above zero; --format csv allows zero
    #[arg(long, value_name = "MU", value_parser = typed::zero_or_more, allow_hyphen_values = true)]
    pub friction: f64,
    /// Torque of the spring on the driver, constant, above zero
    #[arg(long, value_name = "K", value_parser = typed::positive, allow_hyphen_values = true)]
    pub torque: f64,
    /// Moment of inertia of the driver about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, allow_hyphen_values = true)]
    pub driver_inertia: f64,
    /// Moment of inertia of the follower about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, allow_hyphen_values = true)]
    pub follower_inertia: f64,
    /// Units of torque and inertias, to report them in SI units too
    #[arg(long, value_enum)]
    pub units: Option<UnitsName>,
    /// Turn of the driver, in degrees, after which its angle is reset to where a pin enters. A mechanism does what the
    /// default does; another value does what a program does that resets the angle at a fixed value
    /// [default: 360 over the number of pins]
    #[arg(long, alias = "modulus-deg", value_name = "D", value_parser = typed::degrees, allow_hyphen_values = true)]
    pub reset_deg: Option<f64>,
    /// How long the run from rest lasts; only with --format csv
    /// [default: the rise plus three periods, or a hundred engagements if that is shorter; ten without friction]
    #[arg(long, value_name = "T", value_parser = typed::positive, allow_hyphen_values = true)]
    pub duration: Option<f64>,
    /// Time between the lines of the run; only with --format csv
    /// [default: the round number that puts 100 to 250 lines in the last engagement; longer for a long --duration]
    #[arg(long, value_name = "T", value_parser = typed::positive, allow_hyphen_values = true)]
    pub interval: Option<f64>,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "A readable sheet, which says where everything is measured from"),
        (CommandFormat::Json, "An object with all digits: the steady state and the rise from rest"),
        (CommandFormat::Csv, "The run from rest, one row per time"),
        (CommandFormat::Fields, "The numbers as CSV: a row with key, name, value, unit and meaning for each"),
        (CommandFormat::Svg, "A drawing as a standalone file; --figure chooses which"),
    ]))]
    pub format: CommandFormat,
    /// Which drawing to make; only with --format svg [default: mechanism]
    #[arg(long, value_enum)]
    pub figure: Option<EscapementFigureName>,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Coherent systems of units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum UnitsName {
    /// Inch, pound-force and second: torque in in lb, inertias in in lb s²
    InLbS,
    /// Metre, kilogram and second: torque in N m, inertias in kg m²
    Si,
}

/// The drawings of an escapement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum EscapementFigureName {
    /// The mechanism, to scale
    #[default]
    Mechanism,
    /// Normal force and friction torque over one engagement of the steady state
    NormalForce,
    /// Speeds of driver and follower over the first engagements from rest, in rad/s and ms; for torques and inertias
    /// whose unit of time is the second
    Run,
}

impl EscapementArguments {
    fn question(&self) -> EscapementQuestion {
        let units = |name| match name {
            UnitsName::InLbS => UnitSystem::InLbS,
            UnitsName::Si => UnitSystem::Si,
        };
        EscapementQuestion {
            slots: self.slots,
            friction: self.friction,
            torque: self.torque,
            driver_inertia: self.driver_inertia,
            follower_inertia: self.follower_inertia,
            units: self.units.map(units),
            reset_deg: self.reset_deg,
            further: Further::default(),
        }
    }
}

/// The escapement that is wanted, in the format that is wanted.
pub(crate) fn page(wanted: &EscapementArguments, layout: TextLayout) -> anyhow::Result<String> {
    CommandFormat::Csv.only_with(wanted.format, "--duration", wanted.duration.map(as_typed), "a run")?;
    CommandFormat::Csv.only_with(wanted.format, "--interval", wanted.interval.map(as_typed), "a run")?;
    CommandFormat::Svg.only_with(wanted.format, "--figure", wanted.figure.and_then(name_of), "a drawing")?;
    let design = EscapementDesign::new(wanted.question())?;
    match wanted.format {
        CommandFormat::Csv => {
            let rows = design.run(wanted.duration, wanted.interval)?;
            fields::csv(rows.first(), rows.iter().cloned())
        }
        CommandFormat::Svg => {
            let drawing = match wanted.figure.unwrap_or_default() {
                EscapementFigureName::Mechanism => EscapementDrawing::Mechanism,
                EscapementFigureName::NormalForce => EscapementDrawing::NormalForce,
                EscapementFigureName::Run => EscapementDrawing::Run,
            };
            Ok(design.drawing(drawing)?.standalone())
        }
        CommandFormat::Json => fields::json(&design.answer()?),
        CommandFormat::Fields => Ok(design.answer()?.table()),
        _ => Ok(fields::sheet(&design.answer()?, layout)),
    }
}
