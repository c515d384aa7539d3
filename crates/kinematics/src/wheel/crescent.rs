//! How much to cut out of the locking disc before each pin, so that the wheel's horns pass.
//!
//! The cut is a circular arc through the two edges of the opening, which stand at the crank angle of entry to each side
//! of the pin: there the disc lets the wheel go just as the pin takes it. One number is left free, where on the pin's
//! line the arc has its centre, and it is found from the motion. Of all points of a horn the tip, where the rim meets
//! the locking arc, comes nearest to a cut of this kind; the centre is as far out (the cut as shallow) as lets the tip
//! pass at all crank angles with the gap that [`Crescent::shallowest`] states. That nothing else of the wheel bites either is not
//! assumed: [`Sizes::clearance`] looks at the whole outlines over the whole turn.
//!
//! An arc of the wheel's radius about the wheel's axis in mid-index is not safe: it bites on both sides of mid-index.

use super::fit::Remedy::{LessPlay, ThinnerHorn, ThinnerPin};
use super::fit::SizesError;
use super::sizes::{Crescent, LockingDisc, Sizes};
use crate::KinematicsError;
use crate::indexing::Indexing;
use nalgebra::Vector2;

/// Crank angles looked at before the search, and steps of the search, each of which leaves 0.618 of the interval. The
/// place is then known to 10⁻⁴ of the engagement, and what depends on it to the square of that.
const PLACES: u32 = 12;
const STEPS: u32 = 16;
/// What that leaves open of the gap, over the centre distance, with room to spare.
const LEFT_OPEN: f64 = 1e-8;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Crescent {
    /// The arc through both edges of the opening of a disc of this radius, with its centre at this distance.
    pub(super) fn through_edges(disc: f64, half_angle: f64, centre: f64) -> Self {
        let (x, y) = (disc * libm::cos(half_angle), disc * libm::sin(half_angle));
        Self { centre, radius: libm::hypot(centre - x, y), half_angle }
    }

    /// The shallowest cut with which the horns' tips pass a disc of this radius.
    ///
    /// They pass it by the gap of the locking disc in its arc and, besides, by as much as the tip moves when the wheel
    /// is turned through half its slot play where the pin is deepest.
    ///
    /// # Errors
    ///
    /// [`SizesError::DoesNotFit`] if the cut would have to reach the driver's axis.
    pub(super) fn shallowest(sizes: &Sizes, disc: f64) -> Result<Self, SizesError> {
        let swing = sizes.slot_gap() * sizes.tip_radius / sizes.deepest();
        let gap = sizes.play.locking / 2.0 + swing + LEFT_OPEN * sizes.centre_distance;
        let passing = Passing::new(sizes, disc, gap);
        let thinner =
            |what, by| Err(SizesError::DoesNotFit { what, by, remedies: &[ThinnerPin, ThinnerHorn, LessPlay] });
        let room = passing.mouth() - sizes.play.locking / 2.0;
        if room <= 0.0 {
            return thinner("the edges of the locking disc run into the wheel's horns", -room);
        }
        let centre = passing.least_centre().min(sizes.centre_distance);
        let bottom = if centre > 0.0 {
            let cut = Self::through_edges(disc, passing.half_angle, centre);
            if cut.centre > cut.radius {
                return Ok(cut);
            }
            cut.centre - cut.radius
        } else {
            -disc
        };
        thinner("the crescent in the locking disc would reach beyond the driver's axis", -bottom)
    }
}

/// The tip of the horn behind the slot from the driver's axis, in millimetres: along the line of centres away from the
/// wheel, and across it. The crank angle is in radians; the lengths are crank radius, centre distance and rim.
fn tip(theta: f64, [a, c, rim]: [f64; 3], tip_angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(theta);
    let (px, py) = (c - a * cos, a * sin);
    let r = (px * px + py * py).sqrt();
    let (tip_sin, tip_cos) = libm::sincos(tip_angle);
    // Behind the slot, turned with the slot to the pin.
    let at = [rim * (px * tip_cos + py * tip_sin) / r, rim * (py * tip_cos - px * tip_sin) / r];
    [at[0] - c, at[1]]
}

impl Sizes {
    /// Where the tip of the horn behind the slot is as seen from the driver, in millimetres from the driver's axis: along
    /// the pin's line, and across it. The crank angle is in radians.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] for an angle at which no pin is in a slot.
    pub fn horn_tip(&self, crank_angle: f64) -> Result<Vector2<f64>, KinematicsError> {
        self.wheel.engaged(crank_angle)?;
        let lengths = [self.crank_radius, self.centre_distance, self.tip_radius];
        let [x, y] = tip(crank_angle, lengths, self.tip_angle());
        let (sin, cos) = libm::sincos(crank_angle);
        Ok(Vector2::new(y * sin - x * cos, y * cos + x * sin))
    }

    /// Distance of the [tip of a horn](Self::horn_tip) from a locking disc, the one of these sizes or another, in millimetres:
    /// from its cut, or from its edge where that is the shorter way; below zero how deep the tip is in the disc. The crank
    /// angle is in radians.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?;
    /// let disc = sizes.locking_disc.expect("one pin leaves a dwell");
    /// for crank_angle in [-0.5, 0.0, 0.5] { // rad
    ///     assert!(sizes.horn_gap(crank_angle, &disc)? > 0.0); // mm: the crescent lets the horn pass
    /// }
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`horn_tip`](Self::horn_tip).
    pub fn horn_gap(&self, crank_angle: f64, disc: &LockingDisc) -> Result<f64, KinematicsError> {
        let (tip, cut) = (self.horn_tip(crank_angle)?, disc.crescent);
        Ok((tip.norm() - disc.radius).max(cut.radius - libm::hypot(tip.x - cut.centre, tip.y)))
    }
}

/// The tip of a horn as it passes the locking disc, in millimetres and radians.
struct Passing {
    a: f64,
    c: f64,
    rim: f64,
    tip_angle: f64,
    half_angle: f64,
    disc: f64,
    /// Where the opening's edges stand along the pin's line.
    edge: f64,
    gap: f64,
}

impl Passing {
    fn new(sizes: &Sizes, disc: f64, gap: f64) -> Self {
        let half_angle = sizes.wheel.engagement_half_angle();
        Self {
            a: sizes.crank_radius,
            c: sizes.centre_distance,
            rim: sizes.tip_radius,
            tip_angle: sizes.tip_angle(),
            half_angle,
            disc,
            edge: disc * libm::sin(sizes.wheel.half_pitch_angle()),
            gap,
        }
    }

    /// How far the opening's edge passes beside the horn's tip as it comes out of the locking arc, in millimetres.
    fn mouth(&self) -> f64 {
        let Self { a, c, rim, disc, .. } = *self;
        let cosine = (c * c + disc * disc - rim * rim) / (2.0 * c * disc);
        let out = libm::acos(cosine.clamp(-1.0, 1.0));
        let theta = self.half_angle - out;
        let phi = libm::atan2(a * libm::sin(theta), c - a * libm::cos(theta));
        let beside = libm::atan2(disc * libm::sin(out), c - disc * libm::cos(out));
        rim * libm::sin(phi - self.tip_angle + beside)
    }

    /// The greatest distance of the cut's centre from the driver's axis that lets the tip pass at this crank angle.
    ///
    /// With the tip at (u, v) from the driver's axis, u along the pin's line, at the distance s; x and z the edge's
    /// place along that line and its distance; g the gap: √(q² − 2 q u + s²) + g = √(q² − 2 q x + z²).
    fn centre_at(&self, theta: f64) -> f64 {
        let (sin, cos) = libm::sincos(theta);
        let [x, y] = tip(theta, [self.a, self.c, self.rim], self.tip_angle);
        let (u, s) = (y * sin - x * cos, x * x + y * y);
        let (g, z) = (self.gap, self.disc);
        let (left, behind) = (z * z - s - g * g, 2.0 * (self.edge - u));
        if behind <= 0.0 {
            return f64::INFINITY;
        }
        let middle = left * behind - 4.0 * g * g * u;
        let product = (left * left - 4.0 * g * g * s) * (behind * behind - 4.0 * g * g);
        let divisor = middle + (middle * middle - product).max(0.0).sqrt();
        if left <= 0.0 || divisor <= 0.0 { 0.0 } else { (left * left - 4.0 * g * g * s) / divisor }
    }

    /// The least of them over the engagement. The motion back is the mirror image of the motion forth, and the tip
    /// before the slot of the one behind it, so one tip and half of the engagement will do.
    fn least_centre(&self) -> f64 {
        let step = self.half_angle / f64::from(PLACES);
        let at = |k: u32| self.centre_at(step * f64::from(k));
        let Some((k, least)) = (0..=PLACES).map(|k| (k, at(k))).min_by(|a, b| a.1.total_cmp(&b.1)) else {
            return f64::INFINITY;
        };
        let (mut from, mut to) = (step * (f64::from(k) - 1.0).max(0.0), step * f64::from((k + 1).min(PLACES)));
        let inner = |from: f64, to: f64| [to - GOLDEN * (to - from), from + GOLDEN * (to - from)];
        let [mut left, mut right] = inner(from, to);
        let [mut at_left, mut at_right] = [left, right].map(|theta| self.centre_at(theta));
        for _ in 0..STEPS {
            if at_left < at_right {
                (to, right, at_right) = (right, left, at_left);
                left = inner(from, to)[0];
                at_left = self.centre_at(left);
            } else {
                (from, left, at_left) = (left, right, at_right);
                right = inner(from, to)[1];
                at_right = self.centre_at(right);
            }
        }
        least.min(at_left).min(at_right)
    }
}
