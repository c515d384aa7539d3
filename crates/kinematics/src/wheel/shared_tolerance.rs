//! How far all sizes may be wrong together.
//!
//! Two gaps are shared by several errors. In the dwell the disc has half the locking play, of which the disc's radius, the
//! arc's radius and axes that are too near take their parts, and the shafts that are loose in their bores another. At entry
//! the pin has half the slot's play, of which crank radius, axes, pin, slot and the slot's direction take theirs. Loose shafts
//! take axes that are already wrong no farther than the play of one bore, in the dwell and at entry. A pin that is off its place in
//! the holes of its screw takes as much at entry. What they leave is divided into equal parts. The horns that pass the crescent have a third gap, which all these errors share in a way that
//! depends on the motion. So all parts are made smaller together until a whole turn is clear with all errors at once.
//!
//! Notation: `a` crank radius, `c` centre distance, α half the angle between slots, `g` the gap of slot or arc.

use super::sizes::{Crescent, LockingDisc, Play, Sizes};
use crate::KinematicsError;
use crate::indexing::Indexing;

/// How far every size may be wrong while all the others are wrong by as much as they may be, and the shafts as loose as their
/// bores allow.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
/// let shared = sizes.shared_tolerance().expect("the play is large enough");
/// // Where all sizes may be wrong at once, the axes may be less wrong than where they alone may be.
/// assert!(shared.nearer > 0.0 && shared.nearer < sizes.centre_tolerance().nearer); // mm
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SharedTolerance {
    /// How much longer the locking disc's radius may be, and how much shorter the locking arc's, each in millimetres.
    pub locking: f64,
    /// How much nearer the axes may be, in millimetres, besides the bores' play.
    pub nearer: f64,
    /// How much farther apart the axes may be, in millimetres, besides the bores' play.
    pub farther: f64,
    /// How much longer or shorter the crank radius may be, in millimetres.
    pub crank: f64,
    /// How much thicker the pin may be, and how much narrower the slot, each in millimetres.
    pub width: f64,
    /// By what angle one slot may be off its place between the locking arcs, to either side, in radians.
    pub direction: f64,
    /// How much less deep a slot may be, in millimetres: its end farther from the wheel's axis, or nearer to it in an internal wheel.
    pub slot_end: f64,
}

/// Sizes that share the gap of the disc in its arc: both radii and the centre distance.
const IN_DWELL: f64 = 3.0;
/// Sizes that share the gap of the pin at entry: crank radius, centre distance, pin, slot, and the slot's direction.
const AT_ENTRY: f64 = 5.0;
/// The part of the gap at the slot's bottom that is shared; the rest keeps the pin clear of it for certain.
const OF_BOTTOM: f64 = 0.98;
/// Parts of the equal shares that are tried.
const PARTS: u32 = 64;

/// The gaps that errors share, and what their parts depend on.
pub(crate) struct SharedGaps {
    /// Sine of half the angle between slots, dimensionless.
    pub sine: f64,
    /// Its cosine, dimensionless.
    pub cosine: f64,
    /// Distance of a pin's centre from the driver's axis, in millimetres.
    pub crank_radius: f64,
    /// Distance of a pin's centre from the wheel's axis as it enters, in millimetres.
    pub wheel_radius: f64,
    /// Gap of the driver in a locking arc, in millimetres.
    pub locking: f64,
    /// Gap of the pin on either side of it in its slot, in millimetres.
    pub slot: f64,
    /// Gap between pin and bottom of the slot, in millimetres.
    pub bottom: f64,
    /// The plays, of which those of bores and pins count.
    pub play: Play,
    /// Whether the pin goes deeper where the axes are farther apart: in an internal wheel.
    pub is_deeper_apart: bool,
}

/// The gaps of external or internal sizes, whose fields have the same names: those of the locking, and whether the pin goes deeper
/// where the axes are farther apart.
macro_rules! shared_gaps {
    ($sizes:expr, $locking:expr, $is_deeper_apart:expr) => {{
        let (sine, cosine) = libm::sincos($sizes.wheel.half_pitch_angle());
        $crate::wheel::SharedGaps {
            sine,
            cosine,
            crank_radius: $sizes.crank_radius,
            wheel_radius: $sizes.wheel_radius,
            locking: $locking,
            slot: $sizes.slot_gap(),
            bottom: $sizes.bottom_gap(),
            play: $sizes.play,
            is_deeper_apart: $is_deeper_apart,
        }
    }};
}

/// Makes external or internal sizes wrong by the limits of what they have under the same names: arc, crank, pin and slot, the crank
/// longer or shorter by its sense of 1 or −1, and the pin off its place in the same sense.
macro_rules! make_wrong {
    ($wrong:ident, $limit:expr, $sense:expr) => {
        $wrong.locking_arc_radius -= $limit.locking;
        $wrong.crank_radius += $sense * ($limit.crank + $wrong.play.pin);
        $wrong.pin_diameter += $limit.width;
        $wrong.slot_width -= $limit.width;
        $wrong.play.slot -= 2.0 * $limit.width;
    };
}

pub(crate) use {make_wrong, shared_gaps};

impl SharedGaps {
    /// The largest equal parts of the gaps with which a wheel runs; none where loose bores take all, or the wheel runs with none.
    pub(crate) fn divided(
        &self,
        runs_with: impl Fn(&SharedTolerance) -> Result<bool, KinematicsError>,
    ) -> Result<Option<SharedTolerance>, KinematicsError> {
        let Self { sine, cosine, slot: gap, play: Play { bore, pin, .. }, .. } = *self;
        let locking = (self.locking - bore) / IN_DWELL;
        // Axes that are too far apart by e let the pin in later: it is then (e cos α)²/(2 a) more beside the slot's middle.
        let late = (bore + gap / (AT_ENTRY * sine)) * cosine;
        let entry = (gap - pin - bore * sine - late * late / (2.0 * self.crank_radius)) / AT_ENTRY;
        if locking <= 0.0 || entry <= 0.0 {
            return Ok(None);
        }
        let (mut runs, mut fails) = (0, PARTS + 1);
        while fails - runs > 1 {
            let middle = (runs + fails) / 2;
            let part = f64::from(middle) / f64::from(PARTS);
            let limit = self.shares(part * locking, part * entry);
            if runs_with(&limit)? { runs = middle } else { fails = middle }
        }
        let part = f64::from(runs) / f64::from(PARTS);
        Ok((runs > 0).then(|| self.shares(part * locking, part * entry)))
    }

    /// The tolerances from the share of a size in the dwell and at entry, in millimetres.
    fn shares(&self, locking: f64, entry: f64) -> SharedTolerance {
        let farther = entry / self.sine;
        // The internal wheel's driver comes nearer to its arc where the axes are farther apart, and near the arc's ends where
        // they are nearer.
        let nearer = locking.min(farther);
        let farther = if self.is_deeper_apart { nearer } else { farther };
        let deeper = if self.is_deeper_apart { farther } else { nearer };
        SharedTolerance {
            locking,
            nearer,
            farther,
            crank: entry,
            width: 2.0 * entry,
            direction: libm::asin(entry / self.wheel_radius),
            // A pin that is too thick and a slot that is too narrow take half of their errors, and there are two.
            slot_end: (OF_BOTTOM * self.bottom - self.play.bore - self.play.pin - deeper - 3.0 * entry).max(0.0),
        }
    }
}

impl Sizes {
    /// How far all sizes may be wrong together so that nothing touches. None without a locking disc, and where loose bores alone
    /// take all clearance.
    pub fn shared_tolerance(&self) -> Option<SharedTolerance> {
        self.shared_tolerance_within(u32::MAX).ok().flatten()
    }

    /// How far all sizes may be wrong together, as [`shared_tolerance`](Self::shared_tolerance), with a limit on how many crank
    /// angles are looked at for each of the clearances that it needs, 28 at most, or twice as many with loose pins.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::TooManyAngles`] where the play is so small that more crank angles are needed.
    pub fn shared_tolerance_within(&self, angles: u32) -> Result<Option<SharedTolerance>, KinematicsError> {
        let Some(locking) = self.locking_gap() else { return Ok(None) };
        shared_gaps!(self, locking, false).divided(|limit| self.runs_with(limit, angles))
    }

    /// Whether a whole turn is clear with all errors at these limits, in both senses of crank radius and centre distance.
    fn runs_with(&self, limit: &SharedTolerance, angles: u32) -> Result<bool, KinematicsError> {
        // A pin that is off its place along its circle is as good as a disc that is turned.
        let turn = self.play.pin / self.crank_radius;
        let turns: &[f64] = if turn > 0.0 { &[-turn, turn] } else { &[0.0] };
        for error in [-self.play.bore - limit.nearer, self.play.bore + limit.farther] {
            for sense in [-1.0, 1.0] {
                let wrong = self.with_errors(limit, sense);
                for turn in turns {
                    let Ok(assembly) = wrong.assembly_at(self.centre_distance + error) else { return Ok(false) };
                    let tolerance = assembly.tolerance;
                    let nearest = assembly.with_disc_turn(*turn).closest_approach_within(angles, 0.0)?;
                    if nearest.distance < tolerance {
                        return Ok(false);
                    }
                }
            }
        }
        Ok(true)
    }

    /// The sizes with all errors but those of the axes and of the slot's direction at these limits, the crank longer or shorter
    /// by its sense of 1 or −1. The cut in the disc stays where it is, so a larger disc has its edges farther out on it.
    fn with_errors(&self, limit: &SharedTolerance, sense: f64) -> Self {
        let larger = |disc: LockingDisc| {
            let (cut, radius) = (disc.crescent, disc.radius + limit.locking);
            let (far, near) = (cut.centre + radius, cut.centre - radius);
            // By half the angle: sin²(x/2) = (cut² − (centre − disc)²) / (4 centre disc).
            let square = (cut.radius - near) * (cut.radius + near) / ((far - near) * (far + near));
            let half_angle = 2.0 * libm::asin(square.clamp(0.0, 1.0).sqrt());
            LockingDisc { radius, crescent: Crescent { half_angle, ..cut } }
        };
        let mut wrong = *self;
        wrong.locking_disc = self.locking_disc.map(larger);
        make_wrong!(wrong, limit, sense);
        wrong.slot_end += limit.slot_end;
        wrong.tip_radius = libm::hypot(self.wheel_radius, wrong.slot_width / 2.0);
        wrong
    }
}
