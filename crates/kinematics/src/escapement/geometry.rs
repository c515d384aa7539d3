//! Numbers of pins and slots, and the sizes that follow from them.

use crate::indexing::Indexing;
use crate::pin_slot::slot_radius_squared;
use crate::wheel::Wheel;
use crate::{KinematicsError, Rational, Turn, rational};
use std::f64::consts::PI;
use std::fmt;

/// The mechanism of an escapement: m pins on the driver, n slots in the follower, and a, the centre distance over the
/// crank radius; lengths are in crank radii, the radius of the pins' circle.
///
/// A pin must enter as the one before it leaves. It is in its slot while the driver turns by 2π/m and the follower by
/// 2π/n; at entry the crank is at right angles to the slot, so π/m + π/n = π/2 and m = 2 n / (n − 2), an integer
/// above two for three, four and six slots only. They are ordered by rising number of slots. Meyer 1973, Eq. (1-3) and
/// the table after it.
///
/// ```
/// use geneva_kinematics::{Mechanism, Turn};
///
/// let mechanism = Mechanism::new(6)?; // slots
/// assert_eq!((mechanism.pins(), mechanism), (3, Mechanism::THREE_PIN));
/// assert_eq!(mechanism.centre_distance_ratio(), 2.0); // 1 / sin 30°, in crank radii
/// assert_eq!(mechanism.pin_distance(&Turn::from_radians(0.0)), 1.0); // a − 1, on the line of centres
/// assert!(Mechanism::new(5).is_err()); // it would need 10/3 pins
/// # Ok::<(), geneva_kinematics::EscapementError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Mechanism {
    slots: u32,
    pins: u32,
    /// a² = 1 / sin²(π/n), as numerator and denominator.
    square: [u32; 2],
}

/// A mechanism that does not exist, or an angle at which its first pin is in no slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EscapementError {
    /// For a follower with this many slots, no integer number of pins keeps one always engaged and the follower at rest at
    /// each hand-over.
    Slots(u32),
    /// What the wheel refuses.
    Wheel(KinematicsError),
}

impl fmt::Display for EscapementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Slots(asked) => write!(
                f,
                "a follower with {asked} slots: each pin comes and goes along its slot only with 3, 4 or 6 slots (6, 4 or \
                 3 pins), where 2 n / (n - 2) is a whole number above 2; give one of these numbers of slots"
            ),
            Self::Wheel(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for EscapementError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Slots(_) => None,
            Self::Wheel(error) => Some(error),
        }
    }
}

impl From<KinematicsError> for EscapementError {
    fn from(error: KinematicsError) -> Self {
        Self::Wheel(error)
    }
}

/// Number of pins that keep one engaged in so many slots, if each comes and goes along its slot: m = 2 n / (n − 2). Meyer
/// 1973, Eq. (1-3).
///
/// In general it is not an integer. `None` for two slots or fewer, which no number of pins serves.
///
/// ```
/// use geneva_kinematics::escapement::pins_needed;
/// use geneva_kinematics::rational;
///
/// assert_eq!(pins_needed(6), Some(rational(3, 1)));
/// assert_eq!(pins_needed(5), Some(rational(10, 3))); // no escapement
/// assert_eq!(pins_needed(2), None);
/// ```
pub fn pins_needed(slots: u32) -> Option<Rational> {
    (slots > 2).then(|| rational(2 * i64::from(slots), i64::from(slots) - 2))
}

/// All pairs (slots, pins) of positive integers with 1/m + 1/n = 1/2, by rising slots.
///
/// The condition is (m − 2)(n − 2) = 4 ([`entry_proofs::PinsAndSlots`](super::entry_proofs::PinsAndSlots)), so n − 2 is
/// a divisor of 4 and m − 2 the other one. Both divisors are positive: with negative ones m and n would be 1 and −2, or
/// both 0, or −2 and 1. Meyer 1973, table after Eq. (1-3).
///
/// ```
/// use geneva_kinematics::escapement::possible_pairs;
///
/// assert_eq!(possible_pairs(), [(3, 6), (4, 4), (6, 3)]); // 1/3 + 1/6 = 1/4 + 1/4 = 1/2
/// ```
pub fn possible_pairs() -> Vec<(u32, u32)> {
    const PRODUCT: u32 = 4;
    (1..=PRODUCT)
        .filter(|divisor| PRODUCT.is_multiple_of(*divisor))
        .map(|divisor| (2 + divisor, 2 + PRODUCT / divisor))
        .collect()
}

impl Mechanism {
    /// Six pins, three slots.
    pub const SIX_PIN: Self = Self { slots: 3, pins: 6, square: [4, 3] };
    /// Four pins, four slots.
    pub const FOUR_PIN: Self = Self { slots: 4, pins: 4, square: [2, 1] };
    /// Three pins, six slots.
    pub const THREE_PIN: Self = Self { slots: 6, pins: 3, square: [4, 1] };
    /// All that are possible, by rising number of slots.
    pub const ALL: [Self; 3] = [Self::SIX_PIN, Self::FOUR_PIN, Self::THREE_PIN];

    /// The mechanism whose follower has this many **slots**. The constants are named by the driver's pins, so `new(6)` is
    /// [`Mechanism::THREE_PIN`] and `new(3)` is [`Mechanism::SIX_PIN`].
    ///
    /// # Errors
    ///
    /// [`EscapementError::Slots`] if Eq. (1-3) gives no integer number of pins above two.
    pub fn new(slots: u32) -> Result<Self, EscapementError> {
        Self::ALL.into_iter().find(|one| one.slots == slots).ok_or(EscapementError::Slots(slots))
    }

    /// The mechanism as a wheel, which gives the motion and has no dwell.
    pub fn wheel(self) -> Wheel {
        Wheel::from_fitting_counts(self.slots, self.pins)
    }

    /// Number of slots in the follower, n.
    pub const fn slots(self) -> u32 {
        self.slots
    }

    /// Number of pins on the driver, m. Meyer 1973, Eq. (1-3).
    pub const fn pins(self) -> u32 {
        self.pins
    }

    /// Its place in [`Mechanism::ALL`], for tables with an entry for each.
    pub const fn index(self) -> usize {
        match self.slots {
            3 => 0,
            4 => 1,
            _ => 2,
        }
    }

    /// Crank angle at which a pin leaves its slot, θ₀ = π/m, in radians from the line of centres; it enters at minus this
    /// angle. Meyer 1973, display before Eq. (1-1).
    pub fn engagement_half_angle(self) -> f64 {
        PI / f64::from(self.pins)
    }

    /// Follower angle at which a pin leaves, φ₀ = π/n, in radians from the line of centres. Meyer 1973, display before
    /// Eq. (1-1).
    pub fn follower_half_angle(self) -> f64 {
        self.wheel().half_pitch_angle()
    }

    /// Driver's turn from one hand-over to the next, 2π/m, in radians.
    pub fn driver_pitch_angle(self) -> f64 {
        2.0 * PI / f64::from(self.pins)
    }

    /// Follower's turn from one hand-over to the next, 2π/n, in radians; against the driver's sense.
    pub fn follower_pitch_angle(self) -> f64 {
        2.0 * PI / f64::from(self.slots)
    }

    /// Turns of the follower per turn of the driver, m/n: the mean of the velocity ratio over the driver's angle.
    pub fn mean_ratio(self) -> Rational {
        rational(self.pins.into(), self.slots.into())
    }

    /// Centre distance over crank radius, a = c/r = 1 / sin(π/n), dimensionless. Meyer 1973, Eq. (1-2).
    pub fn centre_distance_ratio(self) -> f64 {
        self.centre_distance_ratio_squared().sqrt()
    }

    /// Square of centre distance over crank radius, a², dimensionless: 4/3, 2 or 4.
    pub fn centre_distance_ratio_squared(self) -> f64 {
        let [numerator, denominator] = self.square.map(f64::from);
        numerator / denominator
    }

    /// Radius of the follower's rim, cot(π/n) = √(a² − 1), in crank radii: R at entry and exit, where the slots begin.
    ///
    /// The source writes it r sin θ₀ / sin φ₀. Meyer 1973, Eq. (1-5) and appendix A.
    pub fn rim_radius(self) -> f64 {
        let [numerator, denominator] = self.square.map(f64::from);
        ((numerator - denominator) / denominator).sqrt()
    }

    /// Distance of a pin from the follower's axis at any driver angle, R = √(1 + a² − 2 a cos θ), in crank radii.
    ///
    /// Meyer 1973, display after Eq. (1-12).
    pub fn pin_distance(self, crank: &Turn<f64>) -> f64 {
        slot_radius_squared(&self.centre_distance_ratio(), crank).sqrt()
    }
}
