//! Any numbers of pins and slots with a pin always engaged: how far apart the axes must be, and how the follower turns.
//!
//! m pins stand 2π/m apart, n slots 2π/n. One pin leaves at the driver angle π/m as the next enters at −π/m; the
//! follower's angle must then differ by one slot between the two: φ(π/m) = π/n. By the law of sines that fixes the
//! centre distance, a = sin(π/m + π/n) / sin(π/n). The velocity ratio is even in θ, so both pins ask the follower for
//! the same speed, whatever m and n are: nothing strikes ([`ContinuityStep`]).
//!
//! The pin enters along the slot only where the follower is at rest, π/m + π/n = π/2. Those are the three of
//! [`Mechanism`](super::Mechanism); there a = 1 / sin(π/n). With a smaller sum the follower never stops, with a
//! larger one it turns back a little at each hand-over. Pins are taken as thin.

use crate::pin_slot::{pin_from_pivot, velocity_ratio};
use crate::{Expression, Identity, Turn};
use std::cmp::Ordering;
use std::f64::consts::PI;

/// m pins and n slots with one pin always engaged; lengths are in radii of the pins' circle.
///
/// ```
/// use geneva_kinematics::escapement::{ContinuousEscapement, HandOverMotion};
///
/// let four = ContinuousEscapement::new(4, 4).expect("4 pins, 4 slots");
/// assert!((four.centre_distance_ratio() - 2_f64.sqrt()).abs() < 1e-15); // sin 90° / sin 45°
/// assert_eq!(four.hand_over_motion(), HandOverMotion::Rests); // 1/4 + 1/4 = 1/2
/// let twelve = ContinuousEscapement::new(12, 12).expect("12 pins, 12 slots");
/// assert_eq!((twelve.rim_radius(), twelve.hand_over_motion()), (1.0, HandOverMotion::TurnsOn));
/// assert!((twelve.hand_over_ratio() - 0.75_f64.sqrt()).abs() < 1e-15); // cos 30°
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContinuousEscapement {
    pins: u32,
    slots: u32,
}

/// Motion of the follower as one pin takes over from the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandOverMotion {
    /// It turns on: 1/m + 1/n is below one half.
    TurnsOn,
    /// It is at rest for an instant: 1/m + 1/n is one half.
    Rests,
    /// It turns back: 1/m + 1/n is above one half.
    TurnsBack,
}

impl ContinuousEscapement {
    /// A mechanism with so many pins and slots; `None` unless the follower's axis is outside the circle of the pins,
    /// 1/m + 2/n < 1.
    ///
    /// a > 1 is sin(π/m + π/n) > sin(π/n), so π/m + 2π/n < π.
    pub fn new(pins: u32, slots: u32) -> Option<Self> {
        let [m, n] = [pins, slots].map(u64::from);
        (n + 2 * m < m * n).then_some(Self { pins, slots })
    }

    /// Number of pins on the driver, m.
    pub fn pins(&self) -> u32 {
        self.pins
    }

    /// Number of slots on the follower, n.
    pub fn slots(&self) -> u32 {
        self.slots
    }

    /// Driver angle at which a pin leaves, π/m, in radians from the line of centres.
    pub fn engagement_half_angle(&self) -> f64 {
        PI / f64::from(self.pins)
    }

    /// Follower angle at which a pin leaves, π/n, in radians from the line of centres.
    pub fn follower_half_angle(&self) -> f64 {
        PI / f64::from(self.slots)
    }

    /// Centre distance over radius of the pins' circle, a = sin(π/m + π/n) / sin(π/n), dimensionless.
    pub fn centre_distance_ratio(&self) -> f64 {
        let slot = self.follower_half_angle();
        libm::sin(self.engagement_half_angle() + slot) / libm::sin(slot)
    }

    /// Radius of the follower's rim, sin(π/m) / sin(π/n), in crank radii: the distance of a pin from the follower's axis as
    /// it enters and leaves.
    ///
    /// A pin is the nearer to that axis the nearer it is to the line of centres, so no other pin is inside the rim.
    pub fn rim_radius(&self) -> f64 {
        libm::sin(self.engagement_half_angle()) / libm::sin(self.follower_half_angle())
    }

    /// Angular velocity of the follower over that of the driver at the hand-over, cos(π/m + π/n) sin(π/n) / sin(π/m),
    /// dimensionless: the least of the motion.
    pub fn hand_over_ratio(&self) -> f64 {
        let (crank, slot) = (self.engagement_half_angle(), self.follower_half_angle());
        libm::cos(crank + slot) * libm::sin(slot) / libm::sin(crank)
    }

    /// Motion of the follower at the hand-over, by integers: 2 (m + n) against m n.
    pub fn hand_over_motion(&self) -> HandOverMotion {
        let [m, n] = [self.pins, self.slots].map(u64::from);
        match (2 * (m + n)).cmp(&(m * n)) {
            Ordering::Less => HandOverMotion::TurnsOn,
            Ordering::Equal => HandOverMotion::Rests,
            Ordering::Greater => HandOverMotion::TurnsBack,
        }
    }
}

/// Why one pin takes over from the next without a gap and without a blow. Variables: the tangents of θ₀/2 and φ₀/2,
/// with θ₀ = π/m and φ₀ = π/n, or any other angles; a = sin(θ₀ + φ₀) / sin φ₀.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContinuityStep {
    /// The leaving pin is in the direction φ₀ from the follower's axis: no gap in the follower's angle.
    Angle,
    /// Leaving and entering pin ask for one speed of the follower: no jump.
    Speed,
    /// That speed over the driver's is cos(θ₀ + φ₀) sin φ₀ / sin θ₀, zero only at a quarter turn.
    HandOverRatio,
    /// The square of the pin's distance is then (sin θ₀ / sin φ₀)².
    Rim,
}

impl ContinuityStep {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Angle, Self::Speed, Self::HandOverRatio, Self::Rim];
}

impl Identity<2> for ContinuityStep {
    fn difference(&self, [half_crank, half_slot]: [Expression; 2]) -> Expression {
        let (crank, slot) = (Turn::from_half_tangent(&half_crank), Turn::from_half_tangent(&half_slot));
        let sum = crank.plus(&slot);
        let ratio = sum.sin / slot.sin;
        let leaving = pin_from_pivot(&ratio, &crank);
        match self {
            Self::Angle => leaving.perp(&slot.direction()),
            Self::Speed => velocity_ratio(&ratio, &crank) - velocity_ratio(&ratio, &crank.reversed()),
            Self::HandOverRatio => velocity_ratio(&ratio, &crank) - sum.cos * slot.sin / crank.sin,
            Self::Rim => leaving.dot(&leaving) - (crank.sin / slot.sin).squared(),
        }
    }
}
