//! How far the axes may be from their right distance.
//!
//! Nearer or farther, something takes the play up. Nearer, it is the slot's end at the pin, the locking arc at its disc, or
//! a horn at the crescent; farther, a corner of the slot at the pin as it comes in.

use super::play::EntryContact;
use super::sizes::Sizes;

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

impl Sizes {
    /// How far the axes may be from their right distance so that parts as sized keep clear of each other over a whole
    /// turn, by the proven bound of [`clearance_at`](Self::clearance_at), and the pin comes into its slot without meeting
    /// a corner. Both are zero without play.
    ///
    /// Shafts that are loose in their bores are such an error too: they may bring the axes nearer, or take them farther
    /// apart, by the play of one bore.
    pub fn centre_tolerance(&self) -> CentreTolerance {
        let gap = self.slot_gap();
        // Nearer than this the pin is in the slot's end or the disc in its arc. Farther than this the pin passes beside the
        // driving wall.
        let nearest = self.locking_disc.map_or(gap, |_| gap.min(self.play.locking / 2.0));
        let farthest = gap / libm::sin(self.wheel.half_pitch_angle());
        CentreTolerance { nearer: self.last_that_runs(-nearest), farther: self.last_that_runs(farthest) }
    }

    /// The size of the greatest error on the way from none to this one, in millimetres, with which the wheel runs. So short
    /// is the way that the clearances along it are straight lines or bent downwards: past the first error that does not
    /// do, none does.
    fn last_that_runs(&self, error: f64) -> f64 {
        let (mut runs, mut fails) = (0.0, 1.0);
        for _ in 0..STEPS {
            let middle = (runs + fails) / 2.0;
            if self.runs_with(middle * error) { runs = middle } else { fails = middle }
        }
        runs * error.abs()
    }

    fn runs_with(&self, error: f64) -> bool {
        let clearance = self.clearance_at(self.centre_distance + error);
        let is_clear = clearance.is_ok_and(|of| of.least().distance >= of.tolerance);
        is_clear && self.entry(error).is_some_and(|entry| entry.contact == EntryContact::DrivingWall)
    }
}
