//! Which escapements a sweep asks for, in the order of its rows.

use super::SweepArguments;
use anyhow::ensure;
use geneva_ask::escapement::{no_reset, own_reset};
use geneva_dynamics::DynamicsError;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// Most rows of a sweep.
const MOST_ROWS: u64 = 10_000_000;

/// The values along each axis. Rows go through the torques fastest, then through the inertia ratios, then through the
/// frictions, and through the slots last.
pub(super) struct SweepGrid {
    mechanisms: Vec<Mechanism>,
    frictions: Vec<f64>,
    inertia_ratios: Vec<f64>,
    torques: Vec<f64>,
    follower_inertia: f64,
    reset_deg: Option<f64>,
}

/// One row's escapement.
#[derive(Clone, Copy, Debug)]
pub(super) struct SweepCell {
    pub mechanism: Mechanism,
    pub friction: f64,
    pub inertia_ratio: f64,
    pub torque: f64,
    pub follower_inertia: f64,
    pub reset_deg: f64,
}

impl SweepGrid {
    /// The one that is wanted.
    pub(super) fn new(wanted: &SweepArguments) -> anyhow::Result<Self> {
        let mechanisms = wanted.slots.iter().map(|count| Mechanism::new(*count)).collect::<Result<Vec<_>, _>>()?;
        let again = wanted.slots.iter().enumerate().find(|(at, one)| wanted.slots[..*at].contains(one));
        ensure!(again.is_none(), "--slots lists {} twice; give each number once", again.map_or(0, |(_, slots)| *slots));
        let axes =
            [wanted.friction.count(), wanted.inertia_ratio.count(), wanted.torque.count(), mechanisms.len() as u64];
        let rows = axes.into_iter().fold(1_u64, u64::saturating_mul);
        ensure!(
            rows <= MOST_ROWS,
            "{} frictions × {} inertia ratios × {} torques × {} numbers of slots are more than {MOST_ROWS} rows; give \
             smaller counts",
            axes[0],
            axes[1],
            axes[2],
            axes[3]
        );
        if let Some(reset_angle) = wanted.reset_deg {
            mechanisms.iter().try_for_each(|mechanism| reset(*mechanism, reset_angle))?;
        }
        Ok(Self {
            mechanisms,
            frictions: wanted.friction.values("--friction", wanted.spacing)?,
            inertia_ratios: wanted.inertia_ratio.values("--inertia-ratio", wanted.spacing)?,
            torques: wanted.torque.values("--torque", wanted.spacing)?,
            follower_inertia: wanted.follower_inertia,
            reset_deg: wanted.reset_deg,
        })
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        self.mechanisms.len() * self.frictions.len() * self.inertia_ratios.len() * self.torques.len()
    }

    /// The escapement of a row; none behind the last.
    pub(super) fn cell(&self, row: usize) -> Option<SweepCell> {
        let (rest, torque) = (row / self.torques.len(), self.torques[row % self.torques.len()]);
        let (rest, ratio) = (rest / self.inertia_ratios.len(), self.inertia_ratios[rest % self.inertia_ratios.len()]);
        let (rest, friction) = (rest / self.frictions.len(), self.frictions[rest % self.frictions.len()]);
        let mechanism = *self.mechanisms.get(rest)?;
        Some(SweepCell {
            mechanism,
            friction,
            inertia_ratio: ratio,
            torque,
            follower_inertia: self.follower_inertia,
            reset_deg: self.reset_deg.unwrap_or(own_reset(mechanism)),
        })
    }
}

/// Whether the driver's angle can be reset after so many degrees: asked of an escapement that is easy to compute.
fn reset(mechanism: Mechanism, reset_deg: f64) -> anyhow::Result<()> {
    let easy = Parameters::new(mechanism, Inertias::new(1.0, 1.0)?, 1.0, 0.0)?;
    match Engagement::reset_after(&easy, reset_deg.to_radians(), 1e-6) {
        Err(DynamicsError::Reset { limit, .. }) => Err(no_reset(reset_deg, limit).into()),
        _ => Ok(()),
    }
}
