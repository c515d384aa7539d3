//! One row: an escapement, and what the library says of it.

use super::grid::Cell;
use crate::escapement::assembly::engagement;
use crate::escapement::rise;
use geneva_dynamics::steady::{SteadyError, SteadyState};
use geneva_dynamics::{Inertias, ParameterError, Parameters};
use serde::Serialize;

/// The columns. What there is no number for is empty, and the status says why.
#[derive(Debug, Serialize)]
pub struct Row {
    slots: u32,
    pins: u32,
    friction: f64,
    inertia_ratio: f64,
    torque: f64,
    follower_inertia: f64,
    entry_speed: Option<f64>,
    peak_speed: Option<f64>,
    minimum_speed: Option<f64>,
    mean_speed: Option<f64>,
    period: Option<f64>,
    contraction: Option<f64>,
    switch_angle_deg: Option<f64>,
    rise_time: Option<f64>,
    pub status: Status,
}

/// What became of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// All is there.
    Ok,
    /// The friction is the critical one or more.
    Jams,
    /// Nothing brakes.
    NoTerminalSpeed,
    /// The motion changes too quickly to be computed.
    TooSharp,
    /// The steady state is there, the rise to it takes more engagements than are counted.
    LongRise,
}

impl Status {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Ok, Self::Jams, Self::NoTerminalSpeed, Self::TooSharp, Self::LongRise];

    /// As it stands in a row.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Jams => "jams",
            Self::NoTerminalSpeed => "no-terminal-speed",
            Self::TooSharp => "too-sharp",
            Self::LongRise => "long-rise",
        }
    }
}

impl Row {
    /// The header, which is that of any row.
    pub const COLUMNS: [&str; 15] = [
        "slots",
        "pins",
        "friction",
        "inertia_ratio",
        "torque",
        "follower_inertia",
        "entry_speed",
        "peak_speed",
        "minimum_speed",
        "mean_speed",
        "period",
        "contraction",
        "switch_angle_deg",
        "rise_time",
        "status",
    ];

    /// The row of an escapement.
    pub fn new(cell: &Cell) -> Self {
        let (steady, rise_time, status) = match motion(cell) {
            Ok((steady, Some(rise))) => (Some(steady), Some(rise), Status::Ok),
            Ok((steady, None)) => (Some(steady), None, Status::LongRise),
            Err(status) => (None, None, status),
        };
        Self {
            slots: cell.mechanism.slots(),
            pins: cell.mechanism.pins(),
            friction: cell.friction,
            inertia_ratio: cell.inertia_ratio,
            torque: cell.torque,
            follower_inertia: cell.follower_inertia,
            entry_speed: steady.map(|steady| steady.entry_speed),
            peak_speed: steady.map(|steady| steady.peak.speed),
            minimum_speed: steady.map(|steady| steady.minimum.speed),
            mean_speed: steady.map(|steady| steady.mean_speed),
            period: steady.map(|steady| steady.period),
            contraction: steady.map(|steady| steady.contraction),
            switch_angle_deg: steady.and_then(|steady| steady.switch_angle).map(f64::to_degrees),
            rise_time,
            status,
        }
    }
}

/// The steady state, and the time that the rise to it takes unless that is too long.
fn motion(cell: &Cell) -> Result<(SteadyState, Option<f64>), Status> {
    let driver = cell.inertia_ratio * cell.follower_inertia;
    let inertias = Inertias::new(driver, cell.follower_inertia).map_err(|_| Status::TooSharp)?;
    let parameters =
        Parameters::new(cell.mechanism, inertias, cell.torque, cell.friction).map_err(|error| match error {
            ParameterError::TooMuchFriction { .. } => Status::Jams,
            _ => Status::TooSharp,
        })?;
    let unsteady = |error| match error {
        SteadyError::NoTerminalSpeed { .. } => Status::NoTerminalSpeed,
        _ => Status::TooSharp,
    };
    let engagement = engagement(&parameters, cell.modulus_deg).map_err(unsteady)?;
    let steady = engagement.steady_state().map_err(unsteady)?;
    let numbers = [steady.entry_speed, steady.peak.speed, steady.minimum.speed, steady.mean_speed, steady.period];
    if !numbers.into_iter().all(f64::is_finite) {
        return Err(Status::TooSharp);
    }
    let rise = rise(&engagement, &steady).map_err(unsteady)?;
    Ok((steady, rise.map(|(_, time)| time)))
}
