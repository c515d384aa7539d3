//! Numbers of pins and slots, and the sizes that follow from them.

use crate::pin_slot::slot_radius_squared;
use crate::wheel::Wheel;
use crate::{KinematicsError, Rational, Turn, rational};
use std::f64::consts::PI;
use std::fmt;

/// The mechanism of an escapement: m pins on the driver, n slots in the follower, and a, the centre distance over the
/// crank radius; lengths are in crank radii, the radius of the pins' circle.
///
/// A pin must enter as the one before it leaves. It is in its slot while the driver turns by 2π/m and the follower by
/// 2π/n; at entry the crank is at right angles to the slot, so π/m + π/n = π/2 and m = 2 n / (n − 2), a whole number
/// above two for three, four and six slots only. They are ordered by rising number of slots. Meyer 1973, Eq. (1-3) and
/// the table after it.
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
    /// For a follower with this many slots, no whole number of pins keeps one always engaged and the follower at rest at
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

/// How many pins keep one engaged in so many slots, if each comes and goes along its slot: m = 2 n / (n − 2). Meyer
/// 1973, Eq. (1-3).
///
/// In general no whole number. `None` for two slots or fewer, which no number of pins serves.
pub fn pins_needed(slots: u32) -> Option<Rational> {
    (slots > 2).then(|| rational(2 * i64::from(slots), i64::from(slots) - 2))
}

/// All pairs (slots, pins) of positive whole numbers with 1/m + 1/n = 1/2, by rising slots.
///
/// The condition is (m − 2)(n − 2) = 4 ([`entry_proofs::PinsAndSlots`](super::entry_proofs::PinsAndSlots)), so n − 2 is
/// a divisor of 4 and m − 2 the other one. Both divisors are positive: with negative ones m and n would be 1 and −2, or
/// both 0, or −2 and 1. Meyer 1973, table after Eq. (1-3).
pub fn possible() -> Vec<(u32, u32)> {
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
    /// [`EscapementError::Slots`] if Eq. (1-3) gives no whole number of pins above two.
    pub fn new(slots: u32) -> Result<Self, EscapementError> {
        Self::ALL.into_iter().find(|one| one.slots == slots).ok_or(EscapementError::Slots(slots))
    }

    /// The same as a wheel: it gives the motion, and has no dwell.
    pub fn wheel(self) -> Wheel {
        Wheel::of_fitting_counts(self.slots, self.pins)
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

    /// θ₀ = π/m, the crank angle in radians at which a pin leaves its slot; it enters at minus this angle. Meyer 1973,
    /// display before Eq. (1-1).
    pub fn engagement_half_angle(self) -> f64 {
        PI / f64::from(self.pins)
    }

    /// φ₀ = π/n, the follower angle in radians at which a pin leaves. Meyer 1973, display before Eq. (1-1).
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

    /// a², a fraction, dimensionless: 4/3, 2 and 4.
    pub fn centre_distance_ratio_squared(self) -> f64 {
        let [numerator, denominator] = self.square.map(f64::from);
        numerator / denominator
    }

    /// R at entry and exit in crank radii, cot(π/n) = √(a² − 1): there the slots begin, so it is the radius of the
    /// follower's rim.
    ///
    /// The source writes it r sin θ₀ / sin φ₀. Meyer 1973, Eq. (1-5) and appendix A.
    pub fn rim_radius(self) -> f64 {
        let [numerator, denominator] = self.square.map(f64::from);
        ((numerator - denominator) / denominator).sqrt()
    }

    /// R = √(1 + a² − 2 a cos θ) at any driver angle: distance of a pin from the follower's axis, in crank radii.
    ///
    /// Meyer 1973, display after Eq. (1-12).
    pub fn pin_distance(self, crank: &Turn<f64>) -> f64 {
        slot_radius_squared(&self.centre_distance_ratio(), crank).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wheel::Phase;

    #[test]
    fn the_three_are_all_that_trying_finds() {
        let mut found = Vec::new();
        for slots in 1..=2000_u64 {
            for pins in 1..=2000_u64 {
                if 2 * (slots + pins) == slots * pins {
                    found.push((slots as u32, pins as u32));
                }
            }
        }
        assert_eq!(found, possible());
        assert_eq!(found, Mechanism::ALL.map(|one| (one.slots(), one.pins())));
        assert!(Mechanism::ALL.iter().enumerate().all(|(index, one)| one.index() == index));
    }

    #[test]
    fn the_formula_is_whole_for_these_only_and_never_comes_down_to_two() {
        for slots in (3..=10_000).chain([1_000_000_007, u32::MAX]) {
            let pins = pins_needed(slots).unwrap();
            let whole = possible().iter().any(|&(n, m)| n == slots && rational(m.into(), 1) == pins);
            assert_eq!(pins.denominator().is_one(), whole, "{slots}");
            assert!(pins > rational(2, 1), "{slots}");
            assert_eq!(Mechanism::new(slots).is_ok(), whole, "{slots}");
            assert!(slots <= 6 || pins < rational(3, 1), "{slots}");
        }
        assert_eq!((pins_needed(2), pins_needed(0)), (None, None));
    }

    #[test]
    fn what_does_not_exist_is_said_with_what_does() {
        let message = Mechanism::new(5).unwrap_err().to_string();
        assert!(message.contains("5 slots") && message.contains("3, 4 or 6"), "{message}");
        for slots in [0, 1, 2, 7, 18, u32::MAX] {
            assert_eq!(Mechanism::new(slots), Err(EscapementError::Slots(slots)));
        }
    }

    #[test]
    fn sizes_are_those_of_a_wheel_without_dwell() {
        for escapement in Mechanism::ALL {
            let (n, m) = (f64::from(escapement.slots()), f64::from(escapement.pins()));
            assert_eq!(escapement.wheel().dwell_fraction(), 0.0);
            approx::assert_relative_eq!(escapement.engagement_half_angle(), PI / m, max_relative = 1e-15);
            approx::assert_relative_eq!(escapement.follower_half_angle(), PI / n, max_relative = 1e-15);
            approx::assert_relative_eq!(escapement.driver_pitch_angle(), 2.0 * PI / m, max_relative = 1e-15);
            approx::assert_relative_eq!(escapement.centre_distance_ratio(), 1.0 / (PI / n).sin(), max_relative = 1e-15);
            assert_eq!(escapement.centre_distance_ratio(), escapement.wheel().centre_distance_ratio());
            assert_eq!(escapement.rim_radius(), escapement.wheel().wheel_radius_ratio());
            // The form of appendix A, and the general distance at exit.
            let entry = (PI / m).sin() / (PI / n).sin();
            approx::assert_relative_eq!(escapement.rim_radius(), entry, max_relative = 1e-15);
            let exit = Turn::from_radians(escapement.engagement_half_angle());
            approx::assert_relative_eq!(escapement.pin_distance(&exit), entry, max_relative = 1e-14);
        }
        let sizes = Mechanism::ALL.map(Mechanism::mean_ratio);
        assert_eq!(sizes, [rational(2, 1), rational(1, 1), rational(1, 2)]);
    }

    #[test]
    fn the_follower_goes_on_at_its_mean_ratio_and_never_dwells() {
        for escapement in Mechanism::ALL {
            let (wheel, pitch) = (escapement.wheel(), escapement.driver_pitch_angle());
            for pin in 0..escapement.pins() / 2 {
                for step in 1..200 {
                    let crank = pitch * (f64::from(pin) + f64::from(step) / 200.0 - 0.5);
                    let motion = wheel.at(7, crank).unwrap();
                    assert_eq!(motion.phase, Phase::Advance);
                    assert!(motion.velocity > 0.0);
                }
            }
            let half = escapement.engagement_half_angle();
            let (first, last) = (wheel.engaged(-half).unwrap(), wheel.engaged(half).unwrap());
            approx::assert_relative_eq!(
                last.angle - first.angle,
                escapement.follower_pitch_angle(),
                max_relative = 1e-15
            );
            // Simpson's rule over the velocity ratio gives its mean.
            let steps = 400;
            let sum: f64 = (0..=steps)
                .map(|k| {
                    let weight = if k == 0 || k == steps { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                    weight * wheel.velocity_ratio(half * (2.0 * f64::from(k) / f64::from(steps) - 1.0)).unwrap()
                })
                .sum();
            let mean = sum / (3.0 * f64::from(steps));
            let ratio = escapement.mean_ratio().to_f64().value();
            approx::assert_relative_eq!(mean, ratio, max_relative = 1e-6);
        }
    }
}
