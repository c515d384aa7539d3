//! The motion of the external wheel: as one of the three kinds, and what it has beyond them.

use super::Wheel;
use super::accurate::{Double, fraction_of_pi};
use crate::error::size;
use crate::indexing::{AccelerationPeak, Indexing, JerkPeak, Phase, PinInSlot, WheelMotion, within_half_pitch};
use crate::{KinematicsError, Turn, pin_slot};
use std::f64::consts::PI;

/// The formulas are closed and are evaluated in twice the precision, as [`Wheel`] says.
impl Indexing for Wheel {
    fn stations(&self) -> u32 {
        self.stations
    }

    fn pins(&self) -> u32 {
        self.pins
    }

    fn half_pitch_angle(&self) -> f64 {
        self.constants.half_pitch_angle.hi
    }

    /// π/2 − α, from the line of centres: the pin enters along the slot.
    fn engagement_half_angle(&self) -> f64 {
        self.constants.entry.hi
    }

    /// Position, velocity, acceleration and jerk while the pin is at this crank angle, from the line of centres.
    ///
    /// Both ends of the engagement belong to it. JAZAR, Eqs. (5.30) to (5.32).
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// let middle = wheel.engaged(0.0)?; // pin on the line of centres
    /// assert!((middle.velocity - 1.0).abs() < 1e-15); // 1 / (k − 1) with k = 2
    /// assert_eq!((middle.angle, middle.acceleration), (0.0, 0.0));
    /// let entry = wheel.engaged(-wheel.engagement_half_angle())?; // without a blow
    /// assert!(entry.velocity.abs() < 1e-15);
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] beyond the ends, and for what is not finite.
    fn engaged(&self, crank: f64) -> Result<WheelMotion, KinematicsError> {
        self.engaged_at(Double::from(crank))
    }

    /// With the distance from the law of cosines as √((k − 1)² + 2 k vers θ), in which nothing cancels.
    fn pin_in_slot(&self, crank: f64) -> Result<PinInSlot, KinematicsError> {
        let velocity = self.velocity_ratio(crank)?;
        let (rest, sine) = (self.constants.rest.hi, self.constants.sine.hi);
        let (turn, half) = (Turn::from_radians(crank), libm::sin(0.5 * crank));
        let radius = (rest * rest + 4.0 * sine * half * half).sqrt() / sine;
        let rate = pin_slot::sliding_product(&self.centre_distance_ratio(), &turn) / radius;
        Ok(PinInSlot {
            radius,
            radius_rate: rate,
            sliding: rate,
            coriolis: 2.0 * velocity * rate,
            turning: 1.0 + velocity,
        })
    }

    /// By the law of sines, sin(θ + φ) = sin φ / sin α.
    fn crank_at(&self, wheel_angle: f64) -> Result<f64, KinematicsError> {
        let (angle, most) = (within_half_pitch(self, wheel_angle)?, self.engagement_half_angle());
        let sine = (libm::sin(angle) / self.constants.sine.hi).clamp(-1.0, 1.0);
        Ok((libm::asin(sine) - angle).clamp(-most, most))
    }

    /// sin α / (1 − sin α), on the line of centres. JAZAR, example (d).
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// assert!((Wheel::new(6)?.peak_velocity() - 1.0).abs() < 1e-15); // sin 30° = 1/2
    /// assert!((Wheel::new(4)?.peak_velocity() - (1.0 + 2_f64.sqrt())).abs() < 1e-15);
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    fn peak_velocity(&self) -> f64 {
        self.constants.sine.over(self.constants.rest).hi
    }

    /// tan α: the acceleration jumps from zero and to zero.
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// assert!((Wheel::new(4)?.entry_acceleration() - 1.0).abs() < 1e-15); // tan 45°
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    fn entry_acceleration(&self) -> f64 {
        self.constants.sine.over(self.constants.cosine).hi
    }

    /// cos θ = (−γ + √(γ² + 8)) / 2, inside the engagement for every N. JAZAR, Eqs. (5.33), (5.34) and (5.32).
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(4)?;
    /// let peak = wheel.acceleration_peak();
    /// assert!(peak.ratio > wheel.entry_acceleration()); // it is not at the ends of the engagement,
    /// assert!(wheel.engaged(peak.angle)?.jerk.abs() < 1e-12); // so the acceleration is level there
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    fn acceleration_peak(&self) -> AccelerationPeak {
        let peak = self.constants.peak;
        let (_, ratio, _) = self.constants.angle_acceleration_jerk(peak);
        AccelerationPeak { angle: peak.hi, ratio }
    }

    /// sin α (1 + sin α) / (1 − sin α)³, on the line of centres: the greatest of the engagement for every N, see
    /// [`wheel_jerk_proofs`](crate::wheel_jerk_proofs). As the pin enters and leaves the acceleration jumps, and the
    /// jerk has no finite value.
    ///
    /// ```
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// assert!((Wheel::new(6)?.jerk_peak().ratio - 6.0).abs() < 1e-14); // (1/2) (3/2) / (1/2)³
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    fn jerk_peak(&self) -> JerkPeak {
        let (sine, rest) = (self.constants.sine, self.constants.rest);
        let ratio = sine.plus(sine.times(sine)).over(rest.times(rest).times(rest)).hi;
        JerkPeak { angle: 0.0, ratio }
    }

    /// P (N − 2) / (2 N).
    fn motion_fraction(&self) -> f64 {
        let (stations, pins) = (f64::from(self.stations), f64::from(self.pins));
        pins * (stations - 2.0) / (2.0 * stations)
    }

    /// 1 − P (N − 2) / (2 N), without a difference of numbers that are nearly equal.
    fn dwell_fraction(&self) -> f64 {
        let (stations, pins) = (f64::from(self.stations), f64::from(self.pins));
        (2.0 * stations - pins * (stations - 2.0)) / (2.0 * stations)
    }

    /// The motion after `turns` whole turns of the driver and `crank` radians, −π to π, of the next.
    ///
    /// At crank angle zero a pin is on the line of centres. Turns are counted in integers, so the wheel's angle
    /// has no running error however many there are. At the very ends of an engagement the wheel is in it.
    ///
    /// ```
    /// use geneva_kinematics::indexing::{Indexing, Phase};
    /// use geneva_kinematics::wheel::Wheel;
    /// use std::f64::consts::PI;
    ///
    /// let wheel = Wheel::new(4)?;
    /// let middle = wheel.motion(3, 0.0)?; // three turns of the driver: three stations
    /// assert_eq!((middle.phase, middle.stations, middle.angle), (Phase::Advance, 3, 0.0));
    /// let dwell = wheel.motion(3, 2.0)?; // 2 rad later the wheel stands, half a station on
    /// assert_eq!((dwell.phase, dwell.stations, dwell.velocity), (Phase::Dwell, 3, 0.0));
    /// assert!((dwell.angle - PI / 4.0).abs() < 1e-15); // rad
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Turn`] for a crank angle beyond half a turn, and for what is not finite.
    fn motion(&self, turns: i64, crank: f64) -> Result<WheelMotion, KinematicsError> {
        if !(-PI..=PI).contains(&crank) {
            return Err(KinematicsError::Turn(crank));
        }
        let pitch = 2.0 * PI / f64::from(self.pins());
        let pin = libm::round(crank / pitch);
        let advances = turns.saturating_mul(i64::from(self.pins())).saturating_add(pin as i64);
        let behind = fraction_of_pi(2 * libm::fabs(pin) as u32, self.pins());
        let from_pin = Double::from(crank).minus(if pin < 0.0 { behind.negate() } else { behind });
        match self.engaged_at(from_pin) {
            Ok(motion) => Ok(WheelMotion { stations: advances, ..motion }),
            Err(_) => {
                let angle = if from_pin.hi > 0.0 { self.half_pitch_angle() } else { -self.half_pitch_angle() };
                let (velocity, acceleration, jerk) = (0.0, 0.0, 0.0);
                Ok(WheelMotion { phase: Phase::Dwell, stations: advances, angle, velocity, acceleration, jerk })
            }
        }
    }
}

impl Wheel {
    /// The angular velocity over the driver's alone, dimensionless, as [`engaged`](Self::engaged) gives it, where speed
    /// matters.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// assert!((wheel.velocity_ratio(0.0)? - 1.0).abs() < 1e-15); // 1 / (k − 1) with k = 2
    /// assert_eq!(wheel.velocity_ratio(-0.5)?, wheel.velocity_ratio(0.5)?); // even in the crank angle
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`engaged`](Self::engaged).
    #[inline]
    pub fn velocity_ratio(&self, crank: f64) -> Result<f64, KinematicsError> {
        let (size, most) = (crank.abs(), self.engagement_half_angle());
        if size <= most {
            Ok(self.constants.velocity(Double::from(size)))
        } else {
            Err(KinematicsError::OutsideEngagement { asked: crank, most })
        }
    }

    /// The motion at a crank angle of twice the precision.
    fn engaged_at(&self, crank: Double) -> Result<WheelMotion, KinematicsError> {
        let most = self.engagement_half_angle();
        if !(-most..=most).contains(&crank.hi) {
            return Err(KinematicsError::OutsideEngagement { asked: crank.hi, most });
        }
        let before = crank.hi < 0.0;
        let size = if before { crank.negate() } else { crank };
        let (angle, acceleration, jerk) = self.constants.angle_acceleration_jerk(size);
        Ok(WheelMotion {
            phase: Phase::Advance,
            stations: 0,
            angle: if before { -angle } else { angle },
            velocity: self.constants.velocity(size),
            // No negative zero on the line of centres.
            acceleration: if before { acceleration } else { 0.0 - acceleration },
            jerk,
        })
    }

    /// Peak angular speed in rad/s and peak angular acceleration in rad/s² for a driver of this speed in rad/s.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// let (slow, fast) = (wheel.peaks(10.0)?, wheel.peaks(20.0)?); // driver speeds in rad/s
    /// assert!((slow.0 - 10.0).abs() < 1e-13); // rad/s: sin α / (1 − sin α) = 1 with six stations
    /// assert!((fast.1 / slow.1 - 4.0).abs() < 1e-13); // accelerations go as the square of the speed
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a speed that is not positive and finite.
    pub fn peaks(&self, driver_speed: f64) -> Result<(f64, f64), KinematicsError> {
        let speed = size("driver speed", driver_speed)?;
        Ok((speed * self.peak_velocity(), speed * speed * self.acceleration_peak().ratio))
    }
}
