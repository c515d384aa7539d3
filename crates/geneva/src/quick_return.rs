//! One quick-return mechanism at an instant: where its parts are, every velocity and acceleration, or a drawing.

use crate::fields;
use crate::output::TextLayout;
use crate::typed::{self, CommandFormat, Output, SpeedArguments, formats, name_of, rounded, steps};
use clap::{Args, ValueEnum};
use geneva_ask::quick_return::{LinkageAngle, QuickReturnDesign, QuickReturnDrawing, QuickReturnQuestion};
use geneva_ask::worked::{AngleOrigin, LengthUnit};
use geneva_kinematics::quick_return::Branch;

/// Options of `geneva quick-return`.
#[derive(Args, Debug)]
pub(crate) struct QuickReturnArguments {
    /// Distance from the lever's pivot to the crank's axis, above zero
    #[arg(long, value_name = "LENGTH", value_parser = typed::positive, allow_hyphen_values = true)]
    pub ground: f64,
    /// Distance from the crank's axis to the pin, above zero. If it is less than the ground distance, the lever swings to and
    /// fro; if it is more, the lever turns round and round
    #[arg(long, value_name = "LENGTH", value_parser = typed::positive, allow_hyphen_values = true)]
    pub crank: f64,
    /// Unit of the two lengths, and of the steps; the sheet and the data are in metres
    #[arg(long, default_value = "m", value_parser = typed::value_named(&LengthUnit::ALL, LengthUnit::name, LengthUnit::in_words))]
    pub unit: LengthUnit,
    /// Where the mechanism is: one of the two.
    #[command(flatten)]
    pub angle: AngleArguments,
    /// At which of the two points where the lever's ray meets the crank's circle the pin is; only with --lever-angle
    /// [default: far]
    #[arg(long, value_enum, requires = "lever_angle", conflicts_with = "crank_angle")]
    pub branch: Option<BranchName>,
    /// Constant speed of the crank, above zero counter-clockwise, below zero clockwise: one of the two.
    #[command(flatten)]
    pub speed: SpeedArguments,
    /// Show the solution step by step with your numbers, as one writes it for homework; only with --format text
    #[arg(long)]
    pub steps: bool,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "A readable sheet, which says where everything is measured from and in which sense"),
        (CommandFormat::Json, "An object with all digits; a zero vector has null for its direction"),
        (CommandFormat::Fields, "The numbers as CSV: a row with key, name, value, unit and meaning for each"),
        (CommandFormat::Svg, "A drawing to scale as a standalone file; --figure chooses which"),
    ]))]
    pub format: CommandFormat,
    /// Which drawing to make; only with --format svg [default: mechanism]
    #[arg(long, value_enum)]
    pub figure: Option<QuickReturnFigureName>,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Where the mechanism is, by one of its two angles.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct AngleArguments {
    /// Direction from the crank's axis to the pin, in degrees counter-clockwise from the direction that points from
    /// the lever's pivot to the crank's axis; give this or --lever-angle
    #[arg(long, value_name = "DEG", value_parser = typed::degrees, allow_hyphen_values = true)]
    pub crank_angle: Option<f64>,
    /// Direction from the lever's pivot to the pin, in degrees counter-clockwise from the same direction; give this
    /// or --crank-angle
    #[arg(long, value_name = "DEG", value_parser = typed::degrees, allow_hyphen_values = true)]
    pub lever_angle: Option<f64>,
}

/// Where the pin is on the lever's ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum BranchName {
    /// The point nearer to the lever's pivot: the lever is on its fast stroke
    Near,
    /// The point farther from the lever's pivot: the lever is on its slow stroke
    #[default]
    Far,
}

/// The drawings of a quick-return mechanism.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum QuickReturnFigureName {
    /// The mechanism
    #[default]
    Mechanism,
    /// The velocity diagram
    Velocity,
    /// The acceleration diagram
    Acceleration,
}

impl QuickReturnArguments {
    /// The question with lengths as they were typed. One of the two angles was given; the parser sees to that.
    fn question(&self) -> QuickReturnQuestion {
        let branch = match self.branch.unwrap_or_default() {
            BranchName::Near => Branch::Near,
            BranchName::Far => Branch::Far,
        };
        let place = match (self.angle.crank_angle, self.angle.lever_angle) {
            (_, Some(lever)) => LinkageAngle::Lever(lever, branch),
            (crank, None) => LinkageAngle::Crank(crank.unwrap_or_default()),
        };
        QuickReturnQuestion { ground: self.ground, crank: self.crank, place, speed: self.speed.given() }
    }
}

/// The mechanism that is wanted, in the format that is wanted.
pub(crate) fn page(wanted: &QuickReturnArguments, layout: TextLayout) -> anyhow::Result<String> {
    CommandFormat::Svg.only_with(wanted.format, "--figure", wanted.figure.and_then(name_of), "a drawing")?;
    CommandFormat::Text.only_with(wanted.format, "--steps", wanted.steps.then(String::new), "a readable sheet")?;
    let typed = QuickReturnDesign::new(&wanted.question())?;
    let [ground, crank] = [wanted.ground, wanted.crank].map(|length| rounded(length / wanted.unit.per_metre()));
    let design = QuickReturnDesign::new(&QuickReturnQuestion { ground, crank, ..wanted.question() })?;
    let answer = design.answer()?;
    match wanted.format {
        CommandFormat::Json => fields::json(&answer),
        CommandFormat::Fields => Ok(answer.table()),
        CommandFormat::Svg => {
            let drawing = match wanted.figure.unwrap_or_default() {
                QuickReturnFigureName::Mechanism => QuickReturnDrawing::Mechanism,
                QuickReturnFigureName::Velocity => QuickReturnDrawing::Velocity,
                QuickReturnFigureName::Acceleration => QuickReturnDrawing::Acceleration,
            };
            Ok(design.drawing(drawing).standalone())
        }
        _ if wanted.steps => {
            let solution = typed.steps(wanted.unit, AngleOrigin::Extension)?;
            Ok(fields::sheet(&answer, layout) + &steps(&solution, layout))
        }
        _ => Ok(fields::sheet(&answer, layout)),
    }
}
