//! One row: an escapement, and its motion or why it has none.

use super::grid::SweepCell;

use crate::fields::DataRow;
use geneva_ask::escapement::{engagement, engagements_until_steady};
use geneva_dynamics::steady::SteadyState;
use geneva_dynamics::{DynamicsError, Inertias, Parameters};

/// Status of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Status {
    /// Every number is there.
    Ok,
    /// The friction is critical or more.
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
    pub(super) const ALL: [Self; 5] = [Self::Ok, Self::Jams, Self::NoTerminalSpeed, Self::TooSharp, Self::LongRise];

    /// As it stands in a row.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Jams => "may-jam",
            Self::NoTerminalSpeed => "no-terminal-speed",
            Self::TooSharp => "too-sharp",
            Self::LongRise => "long-rise",
        }
    }
}

/// The row of an escapement. What there is no number for is missing, and the status says why.
pub(super) fn row(cell: &SweepCell) -> (DataRow, Status) {
    let (steady, rise_time, status) = match motion(cell) {
        Ok((steady, Some(rise))) => (Some(steady), Some(rise), Status::Ok),
        Ok((steady, None)) => (Some(steady), None, Status::LongRise),
        Err(status) => (None, None, status),
    };
    let row = DataRow(vec![
        ("slots", cell.mechanism.slots().into()),
        ("pins", cell.mechanism.pins().into()),
        ("friction", cell.friction.into()),
        ("inertia_ratio", cell.inertia_ratio.into()),
        ("torque", cell.torque.into()),
        ("follower_inertia", cell.follower_inertia.into()),
        ("entry_speed", steady.map(|steady| steady.entry_speed).into()),
        ("peak_speed", steady.map(|steady| steady.peak.speed).into()),
        ("minimum_speed", steady.map(|steady| steady.minimum.speed).into()),
        ("mean_speed", steady.map(|steady| steady.mean_speed).into()),
        ("period", steady.map(|steady| steady.period).into()),
        ("multiplier", steady.map(|steady| steady.multiplier).into()),
        ("switch_angle_deg", steady.and_then(|steady| steady.reversal_angle).map(f64::to_degrees).into()),
        ("entry_speed_rise_time", rise_time.into()),
        ("status", status.name().into()),
    ]);
    (row, status)
}

/// The steady state, and the time that the rise to it takes unless that is too long.
fn motion(cell: &SweepCell) -> Result<(SteadyState, Option<f64>), Status> {
    let driver = cell.inertia_ratio * cell.follower_inertia;
    let inertias = Inertias::new(driver, cell.follower_inertia).map_err(|_| Status::TooSharp)?;
    let parameters =
        Parameters::new(cell.mechanism, inertias, cell.torque, cell.friction).map_err(|error| match error {
            DynamicsError::TooMuchFriction { .. } => Status::Jams,
            _ => Status::TooSharp,
        })?;
    let unsteady = |error| match error {
        DynamicsError::NoTerminalSpeed { .. } => Status::NoTerminalSpeed,
        _ => Status::TooSharp,
    };
    let engagement = engagement(&parameters, cell.reset_deg).map_err(unsteady)?;
    let steady = engagement.steady_state().map_err(unsteady)?;
    let numbers = [steady.entry_speed, steady.peak.speed, steady.minimum.speed, steady.mean_speed, steady.period];
    if !numbers.into_iter().all(f64::is_finite) {
        return Err(Status::TooSharp);
    }
    let rise = engagements_until_steady(&engagement, &steady).map_err(unsteady)?;
    Ok((steady, rise.map(|(_, time)| time)))
}
