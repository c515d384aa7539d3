//! How far the axes may be from their right distance.
//!
//! Nearer or farther, something takes the play up. Nearer, it is the slot's end at the pin, the locking arc at its disc, or
//! a horn at the crescent; farther, a corner of the slot at the pin as it comes in.

use super::clearance::{Assembly, ClosestApproach};
use super::mouth::Mouth;
use super::play::EntryContact;
use super::sizes::Sizes;
use crate::KinematicsError;
use crate::bisection::bisect_times;
use crate::indexing::Indexing;

/// How far the axes may be from their right distance, each way, until no clearance is left.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// let with_play = |play: f64| { // in mm
///     let choices = Choices { play: Some(Play::from_slot(play)), ..Choices::default() };
///     Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)
/// };
/// let (sizes, tight) = (with_play(0.2)?, with_play(0.0)?);
/// let tolerance = sizes.centre_tolerance();
/// assert!(tolerance.nearer > 0.0 && tolerance.nearer <= 0.1); // mm: no more than the gap at the locking disc
/// assert!(sizes.clearance_at(sizes.centre_distance - tolerance.nearer)?.closest_approach().distance >= 0.0);
/// assert_eq!(tight.centre_tolerance().farther, 0.0); // without play the axes must be exactly right
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentreTolerance {
    /// How much nearer, in millimetres: zero or more. It is a bound for which the parts are proven to keep clear, so it is below the
    /// distance of first touching: by a billionth of it where only the pin comes to the slot's end or the disc to its arc, and otherwise
    /// by a thousandth at most, as far as the crank angles that may be looked at decide that.
    pub nearer: f64,
    /// How much farther, in millimetres: zero or more.
    pub farther: f64,
}

/// Halvings of the interval in which a limit is.
const STEPS: u32 = 30;
/// Whole turns that are looked at for a limit at most; two or three are enough.
const TURNS: u32 = 24;
/// The part of a limit that need not be known where crank angles are short, and in how many steps it is given up.
const NEAR_ENOUGH: f64 = 1e-3;
const BACK: f64 = NEAR_ENOUGH / 4.0;
/// By how much the reserve is divided that the search leaves, in the order in which it is tried, dimensionless.
const FINER: [f64; 2] = [64.0, 8.0];
/// Crank angles for such a search.
const FINER_ANGLES: u32 = 12_000;
/// The part of the way at which pin and slot's end, or disc and arc, touch that is looked at, dimensionless: all but what rounding takes.
const SHORT_OF_ALL: f64 = 1.0 - 1e-9;
/// First step and least step, in radians, on the way to the crank angle at which two parts are nearest.
const FIRST_STEP: f64 = 0.02;
const LEAST_STEP: f64 = 1e-6;

impl Sizes {
    /// How far the axes may be from their right distance so that parts as sized are proven to keep clear of each other over a
    /// whole turn, and the pin comes into its slot without meeting a corner. Both are zero without play.
    ///
    /// A mouth that is not sharp counts in the clearances, but not in where the pin comes in: that limit is the one of sharp
    /// corners.
    ///
    /// Shafts that are loose in their bores are such an error too: they may bring the axes nearer, or take them farther
    /// apart, by the play of one bore.
    pub fn centre_tolerance(&self) -> CentreTolerance {
        // Nobody waits for four thousand million crank angles.
        self.centre_tolerance_within(u32::MAX).unwrap_or(CentreTolerance { nearer: 0.0, farther: 0.0 })
    }

    /// The errors of the axes as by [`centre_tolerance`](Self::centre_tolerance), from so many crank angles at most for each of a
    /// few turns. Where these do not decide the last part of a limit, it is told too small, by a thousandth at most.
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
        let nearest = self.locking_gap().map_or(bottom, |arc| bottom.min(arc)).min(self.deepest() / 2.0);
        let farthest = (gap / libm::sin(self.wheel.half_pitch_angle())).min(self.centre_distance);
        let nearer = self.last_that_runs(-nearest, angles)?;
        let found = CentreTolerance { nearer, farther: self.last_that_runs(farthest, angles)? };
        // Less than the finest tolerance of a clearance is not known to be more than none.
        let is_lost = nearest > 0.0 && farthest > 0.0 && found.nearer.min(found.farther) == 0.0;
        if is_lost { Err(KinematicsError::TooManyAngles { limit: angles }) } else { Ok(found) }
    }

    /// The size of the greatest error on the way from none to this one, in millimetres, with which the wheel runs. So short
    /// is the way that the clearances along it are straight lines or bent downwards: past the first error that does not
    /// do, none does.
    ///
    /// Where parts meet with an error, they meet at some crank angle, and for that angle alone the error with which they just
    /// keep clear is quickly found. With that error the whole turn is looked at again, until nothing meets.
    fn last_that_runs(&self, error: f64, angles: u32) -> Result<f64, KinematicsError> {
        if error == 0.0 {
            return Ok(0.0);
        }
        // However many angles are allowed, a limit is the same.
        let few = angles.min(FINER_ANGLES);
        let finer = FINER.into_iter().map(|finer| self.last_that_runs_with(error, few, finer, 0.0));
        let found = finer.into_iter().find_map(Result::ok);
        found.map_or_else(|| self.last_that_runs_with(error, angles, 1.0, NEAR_ENOUGH), Ok)
    }

    /// What [`last_that_runs`](Self::last_that_runs) says with a reserve of the tolerance of clearances divided by `finer`,
    /// where the last part of up to `most_given_up` need not be known.
    fn last_that_runs_with(
        &self,
        error: f64,
        angles: u32,
        finer: f64,
        most_given_up: f64,
    ) -> Result<f64, KinematicsError> {
        // A mouth only takes material away: what runs with sharp corners runs with it.
        let sharp = Self { mouth: Mouth::Sharp, ..*self };
        let is_on_wall =
            |part: f64| sharp.entry(part * error).is_some_and(|entry| entry.contact == EntryContact::DrivingWall);
        let at = |part: f64| {
            let mut assembly = self.assembly_at(self.centre_distance + part * error)?;
            assembly.tolerance /= finer;
            Ok::<_, KinematicsError>(assembly)
        };
        let mut runs = last(SHORT_OF_ALL, is_on_wall);
        let mut given_up = 0.0;
        for _ in 0..TURNS {
            let assembly = at(runs)?;
            let tolerance = assembly.tolerance;
            match assembly.searched_approach_within(angles, 0.0) {
                Ok(Some(nearest)) if nearest.distance < tolerance => {
                    let assembly = at(runs)?;
                    let (angle, is_at_rest) = (assembly.nearest_angle(nearest), assembly.phase(nearest.crank_angle).2);
                    let is_clear = |part: f64| {
                        at(part)
                            .is_ok_and(|assembly| assembly.distance_at(nearest.contact, angle, is_at_rest) >= tolerance)
                    };
                    let next = last(runs, is_clear);
                    runs = if next < runs { next } else { runs * (1.0 - BACK) };
                }
                Ok(_) => return Ok(runs * error.abs()),
                // The nearer to the limit, the more crank angles decide; what runs for certain is near enough.
                Err(_) if given_up < most_given_up => {
                    given_up += BACK;
                    runs *= 1.0 - BACK;
                }
                Err(error) => return Err(error),
            }
        }
        Err(KinematicsError::TooManyAngles { limit: angles })
    }
}

/// The last part, from none to this one, of which something holds, if it holds of none and of no part after the first of which
/// it does not.
fn last(all: f64, holds: impl Fn(f64) -> bool) -> f64 {
    if holds(all) {
        return all;
    }
    bisect_times(STEPS, [0.0, all], holds)[0]
}

impl Assembly<'_> {
    /// The crank angle near that of a distance at which the same two parts are nearest, in radians.
    fn nearest_angle(&self, from: ClosestApproach) -> f64 {
        let (mut angle, mut step) = (from.crank_angle, FIRST_STEP);
        let (first, end, is_at_rest) = self.phase(angle);
        let at = |angle: f64| self.distance_at(from.contact, angle, is_at_rest);
        let mut least = at(angle);
        while step > LEAST_STEP {
            let beside = [angle - step, angle + step].map(|next| next.clamp(first, end));
            let next = beside.into_iter().find(|next| at(*next) < least);
            match next {
                Some(next) => (angle, least) = (next, at(next)),
                None => step /= 2.0,
            }
        }
        angle
    }
}
