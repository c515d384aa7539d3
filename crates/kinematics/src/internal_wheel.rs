//! The internal Geneva wheel: a ring whose slots open inwards, and a driver inside the ring.
//!
//! Notation: `N` stations, α = π/N half the angle between slots, θ crank angle from the far side of the line of centres,
//! where the pin is deepest in its slot, φ wheel angle from the middle of the index, m = sin α crank radius over centre
//! distance, as of the external wheel. Wheel and driver turn in the same sense, and θ and φ grow in it.
//!
//! The pin's place from the wheel's axis, in crank radii, is (1/m + cos θ, sin θ): that of the external wheel's pin at
//! π − θ. So the internal wheel moves while the external one with the same centres would rest: over π + 2α of the
//! driver's turn. That is more than half a turn, and the driver has one pin.

use crate::error::KinematicsError;
use crate::indexing::{AccelerationPeak, Indexing, JerkPeak, Phase, PinInSlot, WheelMotion, within_half_pitch};
use crate::wheel::STATIONS;
use crate::{Field, Turn};
use std::f64::consts::{FRAC_PI_2, PI};

/// An internal Geneva wheel with its driver of one pin; lengths are in crank radii.
///
/// Its motion tends to that of a Scotch yoke as N grows: the velocity ratio over sin α to cos θ. What the methods return
/// is right to 4 · 10⁻¹⁵ of the greatest of its kind over the engagement.
///
/// ```
/// use geneva_kinematics::indexing::Indexing;
/// use geneva_kinematics::internal_wheel::InternalWheel;
///
/// let wheel = InternalWheel::new(6)?; // m = sin 30° = 1/2
/// assert!((wheel.centre_distance_ratio() - 2.0).abs() < 1e-15); // 1 / m, in crank radii
/// assert_eq!(wheel.motion_fraction(), 2.0 / 3.0); // an external wheel of six stations rests just as long
/// assert!((wheel.peak_velocity() - 1.0 / 3.0).abs() < 1e-15); // m / (1 + m)
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InternalWheel {
    stations: u32,
    sine: f64,
    cosine: f64,
}

/// Angular velocity of the wheel over that of the driver, dimensionless: m (cos θ + m) / (1 + m² + 2 m cos θ).
///
/// `sine` is m = sin α (above 0, below 1). Positive in the driver's sense; zero at entry and exit, where cos θ = −m.
///
/// ```
/// use geneva_kinematics::internal_wheel::velocity_ratio;
/// use geneva_kinematics::{Turn, rational};
///
/// // Six stations, in the middle of the engagement: m / (1 + m) with m = 1/2, without rounding.
/// let middle = Turn { cos: rational(1, 1), sin: rational(0, 1) };
/// assert_eq!(velocity_ratio(&rational(1, 2), &middle), rational(1, 3));
/// ```
pub fn velocity_ratio<S: Field>(sine: &S, crank: &Turn<S>) -> S {
    sine.clone() * (crank.cos.clone() + sine.clone()) / square(sine, crank)
}

/// Angular acceleration of the wheel over the square of the driver's constant angular velocity, dimensionless:
/// −m (1 − m²) sin θ / (1 + m² + 2 m cos θ)².
///
/// Positive while the wheel speeds up (θ < 0).
///
/// ```
/// use geneva_kinematics::Turn;
/// use geneva_kinematics::internal_wheel::acceleration_ratio;
///
/// // The pin enters a wheel of six stations at −120°, with the acceleration tan 30°.
/// let entry = acceleration_ratio(&0.5, &Turn::from_degrees(-120.0));
/// assert!((entry - 1.0 / 3_f64.sqrt()).abs() < 1e-15);
/// ```
pub fn acceleration_ratio<S: Field>(sine: &S, crank: &Turn<S>) -> S {
    let square = square(sine, crank);
    -(shape(sine) * crank.sin.clone()) / (square.clone() * square)
}

/// Rate of change of the wheel's angular acceleration over the cube of the driver's constant angular velocity,
/// dimensionless: −m (1 − m²) {(1 + m² + 2 m cos θ) cos θ + 4 m sin² θ} / (1 + m² + 2 m cos θ)³.
///
/// Negative over the whole engagement, as its braces are positive there
/// ([`BracesArePositive`](crate::internal_wheel_proofs::BracesArePositive)): the acceleration falls from entry to exit.
/// At the ends it jumps, and the jerk has no finite value.
///
/// ```
/// use geneva_kinematics::internal_wheel::{acceleration_ratio, jerk_ratio};
/// use geneva_kinematics::{Jet, Turn, rational};
///
/// // The rate of the acceleration ratio with the crank angle, without rounding.
/// let (sine, crank) = (rational(1, 2), Turn::from_half_tangent(&rational(1, 2)));
/// let acceleration = acceleration_ratio(&Jet::constant(sine.clone()), &crank.moving::<2>(rational(1, 1)));
/// assert_eq!(jerk_ratio(&sine, &crank), acceleration.rate());
/// // In the middle it is −m (1 − m) / (1 + m)³.
/// let middle = Turn { cos: rational(1, 1), sin: rational(0, 1) };
/// assert_eq!(jerk_ratio(&sine, &middle), rational(-2, 27));
/// ```
pub fn jerk_ratio<S: Field>(sine: &S, crank: &Turn<S>) -> S {
    let square = square(sine, crank);
    let sines = S::integer(4) * sine.clone() * crank.sin.clone() * crank.sin.clone();
    let braces = square.clone() * crank.cos.clone() + sines;
    -(shape(sine) * braces) / (square.clone() * square.clone() * square)
}

/// 1 + m² + 2 m cos θ: the square of the pin's distance from the wheel's axis, over that of the centre distance.
fn square<S: Field>(sine: &S, crank: &Turn<S>) -> S {
    S::one() + sine.clone() * sine.clone() + S::integer(2) * sine.clone() * crank.cos.clone()
}

/// m (1 − m²).
fn shape<S: Field>(sine: &S) -> S {
    sine.clone() * (S::one() - sine.clone() * sine.clone())
}

impl InternalWheel {
    /// A wheel of so many stations.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Stations`] outside [`STATIONS`]. With two the crank would be as long as the centre distance,
    /// and the pin would pass over the wheel's axis.
    pub fn new(stations: u32) -> Result<Self, KinematicsError> {
        if !STATIONS.contains(&stations) {
            return Err(KinematicsError::Stations(stations));
        }
        let half_pitch = PI / f64::from(stations);
        Ok(Self { stations, sine: libm::sin(half_pitch), cosine: libm::cos(half_pitch) })
    }

    /// An internal wheel with a number of pins, of which only one is possible.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new), and [`KinematicsError::Pins`] for another number of pins.
    pub fn with_pins(stations: u32, pins: u32) -> Result<Self, KinematicsError> {
        let wheel = Self::new(stations)?;
        if pins == 1 { Ok(wheel) } else { Err(KinematicsError::Pins { asked: pins, most: 1, stations }) }
    }

    /// Distance between the two axes in crank radii, 1 / sin α: the slot is tangent to the pin's circle as the pin enters.
    pub fn centre_distance_ratio(&self) -> f64 {
        self.sine.recip()
    }

    /// Inner radius of the wheel in crank radii, 1 / tan α: where the pin's centre enters.
    pub fn wheel_radius_ratio(&self) -> f64 {
        self.cosine / self.sine
    }

    /// Distance of the pin's centre from the wheel's axis where it is deepest, in crank radii: 1 + 1 / sin α.
    pub fn slot_bottom_ratio(&self) -> f64 {
        (1.0 + self.sine) / self.sine
    }

    /// Least length of a slot, from where the pin's centre enters to where it is deepest, in crank radii.
    pub fn slot_length_ratio(&self) -> f64 {
        // 1 + sin α − cos α without a difference of large numbers: 1 − cos α is twice the square of sin(α/2).
        let half = libm::sin(0.5 * self.half_pitch_angle());
        (self.sine + 2.0 * half * half) / self.sine
    }

    /// γ = (1 + sin² α) / (2 sin α), as of the external wheel.
    fn gamma(&self) -> f64 {
        (1.0 + self.sine * self.sine) / (2.0 * self.sine)
    }

    /// |θ|, if it is within the engagement; cos θ + m, which is zero at its ends; and 1 + m² + 2 m cos θ.
    fn place(&self, crank: f64) -> Result<(f64, f64, f64), KinematicsError> {
        let most = self.engagement_half_angle();
        let size = crank.abs();
        if !(0.0..=most).contains(&size) {
            return Err(KinematicsError::OutsideEngagement { asked: crank, most });
        }
        let above = 2.0 * libm::sin(0.5 * (most + size)) * libm::sin(0.5 * (most - size));
        Ok((size, above, self.cosine * self.cosine + 2.0 * self.sine * above))
    }
}

impl Indexing for InternalWheel {
    fn stations(&self) -> u32 {
        self.stations
    }

    fn pins(&self) -> u32 {
        1
    }

    /// Crank angle at which a pin enters and leaves: π/2 + α.
    fn engagement_half_angle(&self) -> f64 {
        FRAC_PI_2 + self.half_pitch_angle()
    }

    fn motion_fraction(&self) -> f64 {
        (f64::from(self.stations) + 2.0) / (2.0 * f64::from(self.stations))
    }

    fn dwell_fraction(&self) -> f64 {
        (f64::from(self.stations) - 2.0) / (2.0 * f64::from(self.stations))
    }

    fn engaged(&self, crank: f64) -> Result<WheelMotion, KinematicsError> {
        let (size, above, square) = self.place(crank)?;
        let (sine, cosine) = (libm::sin(size), libm::cos(size));
        let shape = self.sine * self.cosine * self.cosine;
        let before = crank < 0.0;
        let acceleration = shape * sine / (square * square);
        let angle = libm::atan2(self.sine * sine, 1.0 + self.sine * cosine);
        let braces = cosine * square + 4.0 * self.sine * sine * sine;
        Ok(WheelMotion {
            phase: Phase::Advance,
            stations: 0,
            angle: if before { -angle } else { angle },
            velocity: self.sine * above / square,
            // No negative zero in the middle.
            acceleration: if before { acceleration } else { 0.0 - acceleration },
            jerk: -(shape * braces) / (square * square * square),
        })
    }

    fn pin_in_slot(&self, crank: f64) -> Result<PinInSlot, KinematicsError> {
        let (_, above, square) = self.place(crank)?;
        let distance = square.sqrt();
        // In crank radii the distance is that over m, and its rate −sin θ over the distance.
        let sliding = libm::sin(crank) / distance;
        Ok(PinInSlot {
            radius: distance / self.sine,
            radius_rate: 0.0 - sliding,
            sliding,
            coriolis: 0.0 - 2.0 * (self.sine * above / square) * sliding,
            turning: self.sine * above / square - 1.0,
        })
    }

    /// By the law of sines, sin(θ − φ) = sin φ / sin α.
    fn crank_at(&self, wheel_angle: f64) -> Result<f64, KinematicsError> {
        let (angle, most) = (within_half_pitch(self, wheel_angle)?, self.engagement_half_angle());
        let sine = (libm::sin(angle) / self.sine).clamp(-1.0, 1.0);
        Ok((libm::asin(sine) + angle).clamp(-most, most))
    }

    /// Greatest velocity ratio: sin α / (1 + sin α).
    fn peak_velocity(&self) -> f64 {
        self.sine / (1.0 + self.sine)
    }

    /// Size of the acceleration ratio as the pin enters: tan α.
    fn entry_acceleration(&self) -> f64 {
        self.sine / self.cosine
    }

    /// At the ends of the engagement: the acceleration falls over all of it.
    fn acceleration_peak(&self) -> AccelerationPeak {
        AccelerationPeak { angle: self.engagement_half_angle(), ratio: self.entry_acceleration() }
    }

    /// Where cos θ = 2 γ − √(3 γ² + 6) with γ = (1 + sin² α) / (2 sin α), if there is such an angle in the engagement.
    ///
    /// With eleven stations or fewer it is at the ends, 3 tan² α; from 32 stations on it is in the middle.
    fn jerk_peak(&self) -> JerkPeak {
        let gamma = self.gamma();
        let cosine = 2.0 * gamma - (3.0 * gamma * gamma + 6.0).sqrt();
        let angle = if cosine <= -self.sine { self.engagement_half_angle() } else { libm::acos(cosine.min(1.0)) };
        let ratio = self.engaged(angle).map_or(0.0, |motion| motion.jerk.abs());
        JerkPeak { angle, ratio }
    }
}
