//! One quick-return mechanism at an instant: where its parts are, every velocity and acceleration, or a drawing.

mod instant;
mod report;
mod vector;

use crate::arguments::{Format, Output, formats, name_of};
use crate::fields;
use crate::typed::{self, as_typed, rounded_down};
use anyhow::{anyhow, ensure};
use clap::{Args, ValueEnum};
use geneva_figures::quick_return::{acceleration_diagram, mechanism, velocity_diagram};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::quick_return::{Branch, Drive, Position, QuickReturn};
use std::f64::consts::PI;

/// Options of `geneva quick-return`.
#[derive(Args, Debug)]
pub struct QuickReturnArguments {
    /// Distance from the lever's pivot to the crank's axis, in metres, above zero
    #[arg(long, value_name = "M", value_parser = typed::metres, allow_hyphen_values = true)]
    pub ground: f64,
    /// Distance from the crank's axis to the pin, in metres, above zero. If it is less than the ground distance, the lever
    /// swings to and fro; if it is more, the lever turns round and round
    #[arg(long, value_name = "M", value_parser = typed::metres, allow_hyphen_values = true)]
    pub crank: f64,
    /// Where the mechanism is: one of the two.
    #[command(flatten)]
    pub angle: Angle,
    /// At which of the two points where the lever's ray meets the crank's circle the pin is; only with --lever-angle
    /// [default: far]
    #[arg(long, value_enum, requires = "lever_angle", conflicts_with = "crank_angle")]
    pub branch: Option<BranchName>,
    /// Constant speed of the crank in turns per minute: above zero counter-clockwise, below zero clockwise
    #[arg(long, value_name = "R", value_parser = typed::turns_a_minute, allow_hyphen_values = true)]
    pub rpm: f64,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (Format::Text, "A readable sheet, which says where everything is measured from and in which sense"),
        (Format::Json, "An object with all digits; a zero vector has null for its direction"),
        (Format::Svg, "A drawing to scale as a standalone file; --figure chooses which"),
    ]))]
    pub format: Format,
    /// Which drawing to make; only with --format svg [default: mechanism]
    #[arg(long, value_enum)]
    pub figure: Option<FigureName>,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Where the mechanism is, by one of its two angles.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct Angle {
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
pub enum BranchName {
    /// The point nearer to the lever's pivot: the lever is on its fast stroke
    Near,
    /// The point farther from the lever's pivot: the lever is on its slow stroke
    #[default]
    Far,
}

/// The drawings of a quick-return mechanism.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum FigureName {
    /// The mechanism
    #[default]
    Mechanism,
    /// The velocity diagram
    Velocity,
    /// The acceleration diagram
    Acceleration,
}

/// Crank radii from the lever's pivot below which rounding would show in the lever's acceleration.
const NEAREST: f64 = 1e-3;

/// The mechanism that is wanted, in the format that is wanted.
pub fn page(wanted: &QuickReturnArguments) -> anyhow::Result<String> {
    Format::Svg.only_with(wanted.format, "--figure", wanted.figure.and_then(name_of), "a drawing")?;
    let linkage = QuickReturn::new(wanted.ground, wanted.crank).map_err(|error| impossible(wanted, error))?;
    let position = place(&linkage, wanted).map_err(|error| impossible(wanted, error))?;
    ensure!(position.pin_distance >= NEAREST * linkage.crank(), too_near(wanted, &linkage, &position));
    let drive = Drive::steady(wanted.rpm * PI / 30.0);
    let report = report::report(&linkage, &position, &drive, wanted.rpm)?;
    match wanted.format {
        Format::Json => fields::json(&report),
        Format::Svg => {
            let draw = match wanted.figure.unwrap_or_default() {
                FigureName::Mechanism => mechanism,
                FigureName::Velocity => velocity_diagram,
                FigureName::Acceleration => acceleration_diagram,
            };
            Ok(draw(&linkage, &position, &drive, "m").standalone())
        }
        _ => Ok(report.sheet()),
    }
}

/// Where the parts are. One of the two angles was given; the parser sees to that.
fn place(linkage: &QuickReturn, wanted: &QuickReturnArguments) -> Result<Position, KinematicsError> {
    let branch = match wanted.branch.unwrap_or_default() {
        BranchName::Near => Branch::Near,
        BranchName::Far => Branch::Far,
    };
    match (wanted.angle.crank_angle, wanted.angle.lever_angle) {
        (_, Some(lever)) => linkage.at_lever_degrees(lever, branch),
        (crank, None) => linkage.at_crank_degrees(crank.unwrap_or_default()),
    }
}

/// The library's refusal, in terms of the options and the values that the reader typed.
fn impossible(wanted: &QuickReturnArguments, error: KinematicsError) -> anyhow::Error {
    let (ground, crank) =
        (format!("--ground {}", as_typed(wanted.ground)), format!("--crank {}", as_typed(wanted.crank)));
    match error {
        KinematicsError::Angle { name, asked } => {
            let option = if name == "lever angle" { "--lever-angle" } else { "--crank-angle" };
            anyhow!("{option} {} is not a finite angle; give an angle in degrees", as_typed(asked))
        }
        KinematicsError::BeyondTheSwing { asked, limit, open } => anyhow!(
            "--lever-angle {} is out of reach: with {ground} and {crank} the lever swings {} −{limit}° and {limit}°; give \
             an angle in this range, or a --crank-angle ({} possible)",
            as_typed(asked),
            if open { "between, but not to," } else { "between" },
            if open { "all but 180° are" } else { "all are" },
            limit = rounded_down(limit),
        ),
        KinematicsError::OnlyFar { .. } => anyhow!(
            "--branch near: with {crank}, which is at least as long as {ground}, the lever's ray meets the crank's circle \
             only once, at the far point; give --branch far (all lever angles{} are possible)",
            if wanted.crank > wanted.ground { "" } else { " between −90° and 90°" },
        ),
        KinematicsError::PinOnPivot => anyhow!(
            "--crank-angle {}: with {crank}, which is as long as {ground}, the pin is on the lever's pivot, so the lever \
             has no direction; give another angle (all but 180° are possible)",
            as_typed(wanted.angle.crank_angle.unwrap_or_default())
        ),
        // Lengths that can be typed are possible, and so is their ratio.
        other => other.into(),
    }
}

/// The pin is off the lever's pivot, but not by enough.
fn too_near(wanted: &QuickReturnArguments, linkage: &QuickReturn, position: &Position) -> anyhow::Error {
    let (option, asked) = match wanted.angle.lever_angle {
        Some(lever) => ("--lever-angle", lever),
        None => ("--crank-angle", wanted.angle.crank_angle.unwrap_or_default()),
    };
    anyhow!(
        "{option} {}: the pin is only {:.1e} crank radii from the lever's pivot, too near to compute the lever's motion; \
         give an angle at which it is at least {NEAREST} crank radii away",
        as_typed(asked),
        position.pin_distance / linkage.crank(),
    )
}
