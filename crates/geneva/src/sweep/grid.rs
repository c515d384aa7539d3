//! Which escapements a sweep asks for, in the order of its rows.

use super::arguments::SweepArguments;
use crate::escapement::assembly::{no_fold, own_modulus};
use crate::escapement::typed;
use anyhow::ensure;
use geneva_dynamics::Slots;
use geneva_dynamics::steady::{Engagement, SteadyError};
use geneva_dynamics::{Inertias, Parameters};

/// Most rows of a sweep.
const MOST_ROWS: u64 = 10_000_000;

/// The values along each axis. Rows go through the torques fastest, then through the inertia ratios, then through the
/// frictions, and through the slots last.
pub struct Grid {
    slots: Vec<Slots>,
    frictions: Vec<f64>,
    inertia_ratios: Vec<f64>,
    torques: Vec<f64>,
    follower_inertia: f64,
    modulus_deg: Option<f64>,
}

/// One row's escapement.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    pub slots: Slots,
    pub friction: f64,
    pub inertia_ratio: f64,
    pub torque: f64,
    pub follower_inertia: f64,
    pub modulus_deg: f64,
}

impl Grid {
    /// The one that is wanted.
    pub fn new(wanted: &SweepArguments) -> anyhow::Result<Self> {
        let slots = wanted.slots.iter().map(|count| Slots::new(*count)).collect::<Result<Vec<_>, _>>()?;
        ensure!(
            slots.iter().enumerate().all(|(at, one)| !slots[..at].contains(one)),
            "--slots: a number stands there twice; give each once"
        );
        let axes = [wanted.friction.count(), wanted.inertia_ratio.count(), wanted.torque.count(), slots.len() as u64];
        let rows = axes.into_iter().fold(1_u64, u64::saturating_mul);
        ensure!(
            rows <= MOST_ROWS,
            "{} frictions × {} inertia ratios × {} torques × {} numbers of slots: more than {MOST_ROWS} rows; give smaller counts",
            axes[0],
            axes[1],
            axes[2],
            axes[3]
        );
        if let Some(modulus) = wanted.modulus_deg {
            slots.iter().try_for_each(|slots| fold(*slots, modulus))?;
        }
        Ok(Self {
            slots,
            frictions: wanted.friction.values("--friction", wanted.spacing, typed::friction)?,
            inertia_ratios: wanted.inertia_ratio.values("--inertia-ratio", wanted.spacing, typed::computable)?,
            torques: wanted.torque.values("--torque", wanted.spacing, typed::computable)?,
            follower_inertia: typed::computable("--follower-inertia", wanted.follower_inertia)?,
            modulus_deg: wanted.modulus_deg,
        })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.slots.len() * self.frictions.len() * self.inertia_ratios.len() * self.torques.len()
    }

    /// The escapement of a row; none behind the last.
    pub fn cell(&self, row: usize) -> Option<Cell> {
        let (rest, torque) = (row / self.torques.len(), self.torques[row % self.torques.len()]);
        let (rest, ratio) = (rest / self.inertia_ratios.len(), self.inertia_ratios[rest % self.inertia_ratios.len()]);
        let (rest, friction) = (rest / self.frictions.len(), self.frictions[rest % self.frictions.len()]);
        let slots = *self.slots.get(rest)?;
        Some(Cell {
            slots,
            friction,
            inertia_ratio: ratio,
            torque,
            follower_inertia: self.follower_inertia,
            modulus_deg: self.modulus_deg.unwrap_or(own_modulus(slots)),
        })
    }
}

/// Whether the driver's angle can be put back after so many degrees: asked of an escapement that is easy to compute.
fn fold(slots: Slots, modulus_deg: f64) -> anyhow::Result<()> {
    let easy = Parameters::new(slots, Inertias::new(1.0, 1.0)?, 1.0, 0.0)?;
    match Engagement::folded(&easy, modulus_deg.to_radians(), 1e-6) {
        Err(SteadyError::Fold { limit, .. }) => Err(no_fold(modulus_deg, limit)),
        _ => Ok(()),
    }
}
