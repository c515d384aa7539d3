//! From what was typed to a linkage, its position and its speed, or to a refusal in terms of the options.

use super::arguments::{BranchName, QuickReturnArguments};
use super::digits::typed;
use anyhow::{anyhow, ensure};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::quick_return::{Branch, Drive, Position, QuickReturn};
use std::f64::consts::PI;
use std::ops::RangeInclusive;

const GROUND: &str = "--ground";
const CRANK: &str = "--crank";
const CRANK_ANGLE: &str = "--crank-angle";
const LEVER_ANGLE: &str = "--lever-angle";
const RPM: &str = "--rpm";

/// Lengths and speeds whose squares and products are numbers of full precision, far outside of any machine.
const COMPUTABLE: RangeInclusive<f64> = 1e-30..=1e30;

/// Crank radii from the lever's pivot below which rounding would show in the lever's acceleration.
const NEAREST: f64 = 1e-3;

/// A mechanism at an instant.
pub struct Assembly {
    pub linkage: QuickReturn,
    pub position: Position,
    pub rpm: f64,
    pub drive: Drive<f64>,
}

impl Assembly {
    /// The one that is wanted.
    pub fn new(wanted: &QuickReturnArguments) -> anyhow::Result<Self> {
        let linkage = QuickReturn::new(wanted.ground, wanted.crank).map_err(|error| impossible(wanted, error))?;
        for (option, length) in [(GROUND, wanted.ground), (CRANK, wanted.crank)] {
            ensure!(COMPUTABLE.contains(&length), beyond(option, length));
        }
        ensure!(
            wanted.rpm.is_finite() && wanted.rpm != 0.0,
            "{RPM} {}: the crank must turn, or nothing moves; give turns a minute, above zero for counter-clockwise \
             or below it for clockwise",
            typed(wanted.rpm)
        );
        ensure!(COMPUTABLE.contains(&wanted.rpm.abs()), beyond(RPM, wanted.rpm));
        let position = place(&linkage, wanted).map_err(|error| impossible(wanted, error))?;
        ensure!(position.pin_distance >= NEAREST * linkage.crank(), too_near(wanted, &linkage, &position));
        Ok(Self { linkage, position, rpm: wanted.rpm, drive: Drive::steady(wanted.rpm * PI / 30.0) })
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
    let option = |name| match name {
        "ground distance" => GROUND,
        "crank" => CRANK,
        "crank angle" => CRANK_ANGLE,
        "lever angle" => LEVER_ANGLE,
        other => other,
    };
    let [ground, crank] =
        [(GROUND, wanted.ground), (CRANK, wanted.crank)].map(|(option, length)| format!("{option} {}", typed(length)));
    match error {
        KinematicsError::Length { name, asked } => KinematicsError::Length { name: option(name), asked }.into(),
        KinematicsError::Angle { name, asked } => KinematicsError::Angle { name: option(name), asked }.into(),
        KinematicsError::Ratio { .. } => beyond(GROUND, wanted.ground),
        KinematicsError::BeyondTheSwing { asked, limit, open } => anyhow!(
            "{LEVER_ANGLE} {}: the lever does not reach it; with {ground} and {crank} it swings {} −{limit}° and \
             {limit}°; give an angle there, or a {CRANK_ANGLE} ({} possible)",
            typed(asked),
            if open { "between, but not to," } else { "between" },
            if open { "all but 180° are" } else { "all are" },
        ),
        KinematicsError::OnlyFar { .. } => anyhow!(
            "--branch near: with {crank}, at least as long as {ground}, the lever's ray meets the crank's circle in \
             one point only, the far one; give --branch far (all lever angles{} are possible)",
            if wanted.crank > wanted.ground { "" } else { " between −90° and 90°" },
        ),
        KinematicsError::PinOnPivot => anyhow!(
            "{CRANK_ANGLE} {}: with {crank}, as long as {ground}, the pin is on the lever's pivot, and the lever has no \
             direction; give another angle (all but 180° are possible)",
            typed(wanted.angle.crank_angle.unwrap_or_default())
        ),
        other => other.into(),
    }
}

/// The pin is off the lever's pivot, but not by enough.
fn too_near(wanted: &QuickReturnArguments, linkage: &QuickReturn, position: &Position) -> anyhow::Error {
    let (option, asked) = match wanted.angle.lever_angle {
        Some(lever) => (LEVER_ANGLE, lever),
        None => (CRANK_ANGLE, wanted.angle.crank_angle.unwrap_or_default()),
    };
    anyhow!(
        "{option} {}: the pin is {:.1e} crank radii from the lever's pivot, too near to compute the lever's motion; give \
         an angle for which it is at least {NEAREST} from it",
        typed(asked),
        position.pin_distance / linkage.crank(),
    )
}

/// A value is allowed, but what follows from it is no number that can be held.
fn beyond(option: &'static str, asked: f64) -> anyhow::Error {
    let (least, most) = (COMPUTABLE.start(), COMPUTABLE.end());
    anyhow!(
        "{option} {}: too large or too small to compute with; give one that a machine can have, between {least:e} and \
         {most:e}",
        typed(asked)
    )
}
