//! What every Geneva wheel does, be it external, internal or spherical: it moves by a station while a pin is in a slot,
//! and rests until the next pin enters.
//!
//! Notation: θ crank angle from the middle of the engagement, φ wheel angle from there; α = π/N half the angle between
//! slots, a the crank radius. The driver turns at constant speed, and θ and φ grow as driver and wheel turn.

use crate::KinematicsError;
use crate::error::size;
use std::f64::consts::{PI, TAU};

/// Whether a pin is in a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// A pin is in a slot.
    Advance,
    /// The wheel is locked.
    Dwell,
}

/// The wheel at one crank angle, for a driver of constant speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelMotion {
    /// Whether a pin moves the wheel, or the wheel dwells.
    pub phase: Phase,
    /// Whole stations that the wheel has passed: the middle of the last advance begun, or the dwell behind it.
    pub stations: i64,
    /// Wheel angle from there in radians, between −α and α; the whole angle is `stations` times 2α and this.
    pub angle: f64,
    /// Angular velocity over the driver's, dimensionless.
    pub velocity: f64,
    /// Angular acceleration over the square of the driver's speed, dimensionless.
    pub acceleration: f64,
    /// Jerk over the cube of the driver's speed, dimensionless.
    pub jerk: f64,
}

/// Where the acceleration is greatest, and how great.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationPeak {
    /// Crank angle of the peak of deceleration, in radians; the acceleration has its peak at minus this angle.
    pub angle: f64,
    /// Size of the acceleration over the square of the driver's speed, dimensionless.
    pub ratio: f64,
}

/// Greatest jerk while a pin is in a slot, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JerkPeak {
    /// Crank angle in radians, zero or positive; at its negative the jerk is the same.
    pub angle: f64,
    /// Size of the jerk over the cube of the driver's speed, dimensionless.
    pub ratio: f64,
}

/// The pin in its slot at one crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinInSlot {
    /// Distance of the pin's centre from the wheel's axis, in crank radii.
    pub radius: f64,
    /// Rate of change of the pin's distance from the wheel's axis with the crank angle, in crank radii per radian.
    pub radius_rate: f64,
    /// Velocity of the pin along the slot over its speed on the crank circle, dimensionless. Negative while it goes in,
    /// positive while it comes out.
    pub sliding: f64,
    /// Coriolis acceleration of the pin over its acceleration on the crank circle, dimensionless: twice the wheel's
    /// velocity ratio times [`radius_rate`](Self::radius_rate). Positive in the sense in which the wheel turns.
    pub coriolis: f64,
    /// Rate at which the pin turns in its slot about its own axis, in radians per radian of the crank: how much faster its
    /// surface slides outward on the wall that it pushes the wheel with than its centre does, over the pin's radius. On the
    /// other wall it is as much slower. External wheels: 1 + v, v the wheel's velocity ratio; internal wheels: v − 1, as
    /// driver and wheel turn in the same sense; spherical wheels: zero, as the turning of their pins is not followed.
    pub turning: f64,
}

/// A Geneva wheel with its driver.
///
/// ```
/// use geneva_kinematics::indexing::Indexing;
/// use geneva_kinematics::internal_wheel::InternalWheel;
/// use geneva_kinematics::spherical_wheel::SphericalWheel;
/// use geneva_kinematics::wheel::Wheel;
///
/// let wheels: [&dyn Indexing; 3] = [&Wheel::new(4)?, &InternalWheel::new(4)?, &SphericalWheel::new(4)?];
/// // Per station the three kinds need a quarter, three quarters and half of the driver's turn.
/// assert_eq!(wheels.map(|wheel| wheel.motion_fraction()), [0.25, 0.75, 0.5]);
/// for wheel in wheels {
///     assert!((wheel.engaged(0.0)?.velocity - wheel.peak_velocity()).abs() < 1e-15); // fastest in the middle
///     assert!(wheel.engaged(wheel.engagement_half_angle())?.velocity.abs() < 1e-15); // at rest at the end
/// }
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub trait Indexing {
    /// Number of slots, N.
    fn stations(&self) -> u32;

    /// Number of evenly spaced pins on the driver.
    fn pins(&self) -> u32;

    /// Crank angle at which a pin enters and leaves, in radians from the middle of the engagement.
    fn engagement_half_angle(&self) -> f64;

    /// Position, velocity, acceleration and jerk while a pin is in a slot. Both ends of the engagement belong to it.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] beyond the ends, and for what is not finite.
    fn engaged(&self, crank: f64) -> Result<WheelMotion, KinematicsError>;

    /// The pin in its slot: its distance from the wheel's axis, its sliding and its Coriolis acceleration.
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?; // k = 2
    /// let middle = wheel.pin_in_slot(0.0)?;
    /// assert!((middle.radius - 1.0).abs() < 1e-15); // k − 1, in crank radii
    /// assert_eq!((middle.sliding, middle.coriolis), (0.0, 0.0)); // the pin moves across the slot
    /// assert!((middle.turning - 2.0).abs() < 1e-15); // driver and wheel turn against each other, each at the driver's speed
    /// let entry = wheel.pin_in_slot(-wheel.engagement_half_angle())?;
    /// assert!((entry.sliding + 1.0).abs() < 1e-15); // it goes in along the slot, at its whole speed
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`engaged`](Self::engaged).
    fn pin_in_slot(&self, crank: f64) -> Result<PinInSlot, KinematicsError>;

    /// Crank angle in radians at which the wheel is at this angle, from the middle of the index, in radians too: from −α to α.
    ///
    /// Near the ends a small change of the wheel's angle is a large one of the crank's: half of the digits are left there.
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// let wheel_angle = wheel.engaged(0.5)?.angle; // rad
    /// assert!((wheel.crank_at(wheel_angle)? - 0.5).abs() < 1e-14); // there and back
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::WheelAngle`] beyond a half pitch angle, and for what is not finite.
    fn crank_at(&self, wheel_angle: f64) -> Result<f64, KinematicsError>;

    /// Greatest velocity ratio, in the middle of the engagement, dimensionless.
    fn peak_velocity(&self) -> f64;

    /// Size of the acceleration ratio as a pin enters and as it leaves, dimensionless.
    fn entry_acceleration(&self) -> f64;

    /// Where the acceleration is greatest, and how great; at the end of the engagement if it is greatest there.
    fn acceleration_peak(&self) -> AccelerationPeak;

    /// Greatest jerk while a pin is in a slot, and where it is.
    fn jerk_peak(&self) -> JerkPeak;

    /// α, half the angle between successive slots, in radians: π/N.
    fn half_pitch_angle(&self) -> f64 {
        PI / f64::from(self.stations())
    }

    /// Part of the driver's turn during which the wheel moves, all pins together, dimensionless.
    fn motion_fraction(&self) -> f64 {
        f64::from(self.pins()) * self.engagement_half_angle() / PI
    }

    /// Part of the driver's turn during which the wheel stands still, dimensionless.
    fn dwell_fraction(&self) -> f64 {
        1.0 - self.motion_fraction()
    }

    /// Time of one index in seconds, for a driver of this angular speed in rad/s.
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::spherical_wheel::SphericalWheel;
    /// use std::f64::consts::PI;
    ///
    /// let wheel = SphericalWheel::new(5)?; // it moves during half of the driver's turn, whatever the stations
    /// assert!((wheel.indexing_time(PI)? - 1.0).abs() < 1e-15); // s, at half a turn per second
    /// assert!((wheel.dwell_time(PI)? - 1.0).abs() < 1e-15); // s
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a speed that is not positive and finite.
    fn indexing_time(&self, driver_speed: f64) -> Result<f64, KinematicsError> {
        Ok(2.0 * self.engagement_half_angle() / size("driver speed", driver_speed)?)
    }

    /// Time of one dwell in seconds, for a driver of this angular speed in rad/s.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a speed that is not positive and finite.
    fn dwell_time(&self, driver_speed: f64) -> Result<f64, KinematicsError> {
        Ok(TAU / size("driver speed", driver_speed)? * self.dwell_fraction() / f64::from(self.pins()))
    }

    /// The wheel after `turns` whole turns of the driver and `crank` radians, −π to π, of the next.
    ///
    /// At crank angle zero a pin is in the middle of its engagement. At the very ends of an engagement the wheel is in it.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Turn`] for a crank angle beyond half a turn, and for what is not finite.
    fn motion(&self, turns: i64, crank: f64) -> Result<WheelMotion, KinematicsError> {
        if !(-PI..=PI).contains(&crank) {
            return Err(KinematicsError::Turn(crank));
        }
        let (pin, from_pin) = self.nearest_pin(crank);
        let stations = turns.saturating_mul(i64::from(self.pins())).saturating_add(pin);
        Ok(self.engaged(from_pin).map_or_else(
            |_| {
                let angle = if from_pin > 0.0 { self.half_pitch_angle() } else { -self.half_pitch_angle() };
                WheelMotion { phase: Phase::Dwell, stations, angle, velocity: 0.0, acceleration: 0.0, jerk: 0.0 }
            },
            |motion| WheelMotion { stations, ..motion },
        ))
    }

    /// Which pin is nearest to the middle of its engagement at this crank angle, in radians, and how far past it: the
    /// pins are counted against the driver's sense from the one that is there at zero.
    fn nearest_pin(&self, crank: f64) -> (i64, f64) {
        let pitch = TAU / f64::from(self.pins());
        let pin = libm::round(crank / pitch);
        (pin as i64, crank - pin * pitch)
    }
}

/// A wheel angle in radians, if it is within a half pitch angle.
pub(crate) fn within_half_pitch(wheel: &dyn Indexing, asked: f64) -> Result<f64, KinematicsError> {
    let most = wheel.half_pitch_angle();
    if (-most..=most).contains(&asked) { Ok(asked) } else { Err(KinematicsError::WheelAngle { asked, most }) }
}
