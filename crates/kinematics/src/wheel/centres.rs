//! How far the axes may be from their right distance.
//!
//! Nearer or farther, something takes the play up. Nearer, it is the slot's end at the pin, the locking arc at its disc, or
//! a horn at the crescent; farther, a corner of the slot at the pin as it comes in.

use super::play::EntryContact;
use super::sizes::Sizes;
use crate::KinematicsError;

/// How far the axes may be from their right distance, each way, until no clearance is left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentreTolerance {
    /// How much nearer, in millimetres: zero or more.
    pub nearer: f64,
    /// How much farther, in millimetres: zero or more.
    pub farther: f64,
}

/// Halvings of the interval in which a limit is.
const STEPS: u32 = 24;

/// The part of a limit that need not be known.
const NEAR_ENOUGH: f64 = 1e-3;

impl Sizes {
    /// How far the axes may be from their right distance so that parts as sized are proven to keep clear of each other over a
    /// whole turn, and the pin comes into its slot without meeting a corner. Both are zero without play.
    ///
    /// Shafts that are loose in their bores are such an error too: they may bring the axes nearer, or take them farther
    /// apart, by the play of one bore.
    pub fn centre_tolerance(&self) -> CentreTolerance {
        // Nobody waits for four thousand million crank angles.
        self.centre_tolerance_within(u32::MAX).unwrap_or(CentreTolerance { nearer: 0.0, farther: 0.0 })
    }

    /// The errors of the axes as by [`centre_tolerance`](Self::centre_tolerance), from so many crank angles at most for each of
    /// 48 distances. Where these do not decide the last part of a limit, it is told too small, by a thousandth of the play's own
    /// limit at most.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::TooManyAngles`] where the play is so small that more crank angles are needed, or finer numbers than
    /// these.
    pub fn centre_tolerance_within(&self, angles: u32) -> Result<CentreTolerance, KinematicsError> {
        let gap = self.slot_gap();
        // Nearer than this the pin is in the slot's end or the disc in its arc. Farther than this the pin passes beside the
        // driving wall.
        let bottom = self.bottom_gap();
        let nearest = self.locking_gap().map_or(bottom, |arc| bottom.min(arc));
        let farthest = gap / libm::sin(self.wheel.half_pitch_angle());
        let last = |error| self.last_that_runs(error, angles);
        let found = CentreTolerance { nearer: last(-nearest)?, farther: last(farthest)? };
        // Less than the finest tolerance of a clearance is not known to be more than none.
        let is_lost = nearest > 0.0 && farthest > 0.0 && found.nearer.min(found.farther) == 0.0;
        if is_lost { Err(KinematicsError::TooManyAngles { limit: angles }) } else { Ok(found) }
    }

    /// The size of the greatest error on the way from none to this one, in millimetres, with which the wheel runs. So short
    /// is the way that the clearances along it are straight lines or bent downwards: past the first error that does not
    /// do, none does.
    fn last_that_runs(&self, error: f64, angles: u32) -> Result<f64, KinematicsError> {
        if error == 0.0 {
            return Ok(0.0);
        }
        let (mut runs, mut fails) = (0.0, 1.0);
        for _ in 0..STEPS {
            let middle = (runs + fails) / 2.0;
            match self.runs_with(middle * error, angles) {
                Ok(true) => runs = middle,
                Ok(false) => fails = middle,
                // The nearer to the limit, the more crank angles decide; what runs for certain is near enough.
                Err(_) if fails - runs < NEAR_ENOUGH => break,
                Err(error) => return Err(error),
            }
        }
        Ok(runs * error.abs())
    }

    fn runs_with(&self, error: f64, angles: u32) -> Result<bool, KinematicsError> {
        if self.entry(error).is_none_or(|entry| entry.contact != EntryContact::DrivingWall) {
            return Ok(false);
        }
        match self.keeps_clear_at(self.centre_distance + error, angles) {
            Err(error @ KinematicsError::TooManyAngles { .. }) => Err(error),
            clear => Ok(clear.unwrap_or(false)),
        }
    }
}
