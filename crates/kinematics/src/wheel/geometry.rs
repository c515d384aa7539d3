//! Sizes of a wheel and its driver, all from the number of stations.

use super::accurate::{Double, WheelConstants};
use crate::KinematicsError;
use crate::pin_slot::PinSlot;
use std::ops::RangeInclusive;

/// How many stations a wheel can have: three is the geometric least. The greatest is a limit of this crate, to which all that
/// it says of wheels is tested; geometry sets none.
pub const STATIONS: RangeInclusive<u32> = 3..=1000;

/// A Geneva wheel with its driver; lengths are in crank radii.
///
/// α is π/N itself, not its rounding: what the methods return is within 2 units in the last place of the value for
/// that α and for the crank angle as given.
///
/// ```
/// use geneva_kinematics::indexing::Indexing;
/// use geneva_kinematics::wheel::Wheel;
///
/// let wheel = Wheel::new(6)?; // α = π/6, so sin α = 1/2
/// assert!((wheel.centre_distance_ratio() - 2.0).abs() < 1e-15); // 1 / sin α, in crank radii
/// assert!((wheel.wheel_radius_ratio() - 3_f64.sqrt()).abs() < 1e-15); // 1 / tan α, in crank radii
/// assert_eq!(wheel.motion_fraction(), 1.0 / 3.0); // it moves while the driver turns by 120° of 360°
/// assert!((wheel.indexing_time(10.0)? - wheel.dwell_time(10.0)? / 2.0).abs() < 1e-15); // in s, at 10 rad/s
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    pub(super) stations: u32,
    pub(super) pins: u32,
    pub(super) constants: WheelConstants,
}

/// The two numbers determine all the rest.
impl PartialEq for Wheel {
    fn eq(&self, other: &Self) -> bool {
        (self.stations, self.pins) == (other.stations, other.pins)
    }
}

impl Eq for Wheel {}

impl Wheel {
    /// A wheel of so many stations with one pin on its driver.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Stations`] outside [`STATIONS`].
    pub fn new(stations: u32) -> Result<Self, KinematicsError> {
        Self::with_pins(stations, 1)
    }

    /// A wheel of so many stations, and so many evenly spaced pins on its driver.
    ///
    /// ```
    /// use geneva_kinematics::KinematicsError;
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// // With four stations each pin is in a slot for a quarter of a turn, so four pins leave no dwell and five don't fit.
    /// assert_eq!(Wheel::with_pins(4, 4)?.dwell_fraction(), 0.0);
    /// assert!(matches!(Wheel::with_pins(4, 5), Err(KinematicsError::Pins { most: 4, .. })));
    /// # Ok::<(), KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Stations`] outside [`STATIONS`], [`KinematicsError::Pins`] for none or too many.
    pub fn with_pins(stations: u32, pins: u32) -> Result<Self, KinematicsError> {
        if !STATIONS.contains(&stations) {
            return Err(KinematicsError::Stations(stations));
        }
        let most = most_pins(stations);
        if !(1..=most).contains(&pins) {
            return Err(KinematicsError::Pins { asked: pins, most, stations });
        }
        Ok(Self::from_fitting_counts(stations, pins))
    }

    /// A wheel of numbers that are known to fit.
    pub(crate) fn from_fitting_counts(stations: u32, pins: u32) -> Self {
        Self { stations, pins, constants: WheelConstants::new(stations) }
    }

    /// Centre distance in crank radii, k = 1 / sin α: the slot is tangent to the pin's circle as the pin enters.
    /// JAZAR, text before Eq. (5.30).
    pub fn centre_distance_ratio(&self) -> f64 {
        Double::ONE.over(self.constants.sine).hi
    }

    /// Outer radius of the wheel in crank radii, 1 / tan α: where the pin's centre enters.
    /// JAZAR, text before Eq. (5.30).
    pub fn wheel_radius_ratio(&self) -> f64 {
        self.constants.cosine.over(self.constants.sine).hi
    }

    /// Least length of a slot, from the wheel's rim to the pin's deepest place, in crank radii.
    ///
    /// The rim is at 1/tan α, the deepest place at k − 1: (cos α − (1 − sin α)) / sin α.
    pub fn slot_length_ratio(&self) -> f64 {
        self.constants.cosine.minus(self.constants.rest).over(self.constants.sine).hi
    }

    /// Radius of the circle on which the centres of the wheel's locking arcs lie, in crank radii: the centre distance.
    pub fn locking_centres_ratio(&self) -> f64 {
        self.centre_distance_ratio()
    }

    /// The wheel as a pin in a slot, with a crank of this radius in any unit of length.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let mechanism = Wheel::new(6)?.pin_and_slot(25.0)?; // crank radius in mm
    /// assert!((mechanism.centre_distance() - 50.0).abs() < 1e-13); // mm
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a crank radius that is not positive, or with which the centre distance is not
    /// finite.
    pub fn pin_and_slot(&self, crank_radius: f64) -> Result<PinSlot, KinematicsError> {
        PinSlot::new(crank_radius, crank_radius * self.centre_distance_ratio())
            .map_err(|_| KinematicsError::Size { name: "crank radius", asked: crank_radius })
    }
}

/// γ = (1 + sin² α) / (2 sin α), dimensionless, never below 1. JAZAR, Eq. (5.33).
///
/// ```
/// use geneva_kinematics::wheel::{Wheel, gamma};
///
/// assert!((gamma(&Wheel::new(6)?) - 5.0 / 4.0).abs() < 1e-15); // (1 + 1/4) / 1
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub fn gamma(wheel: &Wheel) -> f64 {
    wheel.constants.gamma.hi
}

/// The greatest number of pins: each engages for π − 2α, and together they have one turn: 2 N / (N − 2), cut off.
fn most_pins(stations: u32) -> u32 {
    2 * stations / (stations - 2)
}
