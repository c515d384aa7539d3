//! A wheel whose axes stand at another distance than the right one.
//!
//! Driver and wheel are those of the right distance: crank radius, slots and rim stay. Only the tangent condition is lost:
//! as the pin passes the rim, it no longer moves along the slot.

use super::{Wheel, acceleration_ratio, jerk_ratio};
use crate::Turn;
use crate::error::KinematicsError;
use crate::indexing::{Indexing, Phase, WheelMotion};
use crate::pin_slot::{pin_from_pivot, sliding_product, velocity_ratio};

/// A wheel and its driver at a given distance of their axes.
///
/// ```
/// use geneva_kinematics::wheel::{MisplacedWheel, Wheel};
///
/// let wheel = Wheel::new(6)?; // k = 2 and the rim at √3, in crank radii
/// let error = 0.01; // the axes are 1 % too far apart
/// let wrong = MisplacedWheel::new(&wheel, error)?;
/// let k = 2.0 * (1.0 + error);
/// // At the rim k cos θ − 1 = (k² − 4) / 2, over the square of the distance, 3.
/// assert!((wrong.entry_velocity_ratio() - (k * k - 4.0) / 6.0).abs() < 1e-15);
/// assert_eq!(MisplacedWheel::new(&wheel, 0.0)?.entry_velocity_ratio(), 0.0); // no blow at the right distance
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MisplacedWheel {
    wheel: Wheel,
    error: f64,
    ratio: f64,
    half: f64,
}

impl MisplacedWheel {
    /// A wheel whose axes stand by this part of the right distance too far apart (above zero) or too near (below).
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Misplaced`] for a distance at which the pin does not pass the rim on its way in and out, or
    /// the driver's axis does not lie outside the crank circle about the wheel's.
    pub fn new(wheel: &Wheel, error: f64) -> Result<Self, KinematicsError> {
        let (right, rim) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
        if error == 0.0 {
            return Ok(Self { wheel: *wheel, error, ratio: right, half: wheel.engagement_half_angle() });
        }
        let ratio = right * (1.0 + error);
        // The pin is at the rim: the law of cosines in the triangle of axes and pin.
        let cosine = (1.0 + ratio * ratio - rim * rim) / (2.0 * ratio);
        if !(ratio > 1.0 && cosine.abs() < 1.0) {
            let [least, most] = [(rim - 1.0).max(1.0), rim + 1.0].map(|end| end / right - 1.0);
            return Err(KinematicsError::Misplaced { asked: error, least, most });
        }
        Ok(Self { wheel: *wheel, error, ratio, half: libm::acos(cosine) })
    }

    /// The wheel as it is at the right distance.
    pub fn wheel(&self) -> &Wheel {
        &self.wheel
    }

    /// Part of the right distance by which the axes are too far apart, dimensionless; below zero they are too near.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Centre distance over crank radius as it is, dimensionless.
    pub fn centre_distance_ratio(&self) -> f64 {
        self.ratio
    }

    /// Crank angle in radians from the line of centres at which the pin's centre passes the rim.
    pub fn engagement_half_angle(&self) -> f64 {
        self.half
    }

    /// Angle in radians by which a pin turns the wheel on its way from rim to rim: 2π/N at the right distance.
    pub fn index_angle(&self) -> f64 {
        let pin = pin_from_pivot(&self.ratio, &Turn::from_radians(self.half));
        2.0 * libm::atan2(pin.y, pin.x)
    }

    /// The blow: the jump of the wheel's angular velocity over the driver's as the pin enters, dimensionless.
    ///
    /// Zero at the right distance; negative where the wheel is first turned the wrong way.
    pub fn entry_velocity_ratio(&self) -> f64 {
        if self.error == 0.0 {
            return 0.0;
        }
        velocity_ratio(&self.ratio, &Turn::from_radians(self.half))
    }

    /// The motion at a crank angle from −π to π radians, for a driver of constant speed; between two pins the wheel rests
    /// where the last one left it.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Turn`] for a crank angle beyond half a turn, and for what is not finite.
    pub fn motion(&self, crank: f64) -> Result<WheelMotion, KinematicsError> {
        let right = self.wheel.motion(0, crank)?;
        if self.error == 0.0 {
            return Ok(right);
        }
        let crank = self.past_nearest_pin(crank);
        let stations = right.stations;
        if crank.abs() > self.half {
            let angle = (self.index_angle() / 2.0).copysign(crank);
            return Ok(WheelMotion {
                phase: Phase::Dwell,
                stations,
                angle,
                velocity: 0.0,
                acceleration: 0.0,
                jerk: 0.0,
            });
        }
        let turn = Turn::from_radians(crank);
        let pin = pin_from_pivot(&self.ratio, &turn);
        Ok(WheelMotion {
            phase: Phase::Advance,
            stations,
            angle: libm::atan2(pin.y, pin.x),
            velocity: velocity_ratio(&self.ratio, &turn),
            acceleration: acceleration_ratio(&self.ratio, &turn),
            jerk: jerk_ratio(&self.ratio, &turn),
        })
    }

    /// Velocity of the pin along its slot over the pin's speed on the crank circle, dimensionless, at a crank angle from −π to
    /// π radians: k sin θ / √(1 + k² − 2 k cos θ). Negative while the pin goes in; none between two pins.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{MisplacedWheel, Wheel};
    ///
    /// // With six stations, k = 2. The pin goes in at 60° with its full speed, and at 30° with 1 / √(5 − 2 √3) of it.
    /// let right = MisplacedWheel::new(&Wheel::new(6)?, 0.0)?;
    /// let sliding = right.sliding_ratio(-30_f64.to_radians())?.ok_or("no pin")?;
    /// assert!((sliding + (5.0 - 2.0 * 3_f64.sqrt()).sqrt().recip()).abs() < 1e-15);
    /// assert_eq!(right.sliding_ratio(-70_f64.to_radians())?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Turn`] for a crank angle beyond half a turn, and for what is not finite.
    pub fn sliding_ratio(&self, crank: f64) -> Result<Option<f64>, KinematicsError> {
        let is_engaged = self.motion(crank)?.phase == Phase::Advance;
        let turn = Turn::from_radians(self.past_nearest_pin(crank));
        let pin = pin_from_pivot(&self.ratio, &turn);
        Ok(is_engaged.then(|| sliding_product(&self.ratio, &turn) / libm::hypot(pin.x, pin.y)))
    }

    /// The crank angle in radians, counted from where the nearest pin is on the line of centres.
    fn past_nearest_pin(&self, crank: f64) -> f64 {
        let pitch = std::f64::consts::TAU / f64::from(self.wheel.pins());
        crank - libm::round(crank / pitch) * pitch
    }
}
