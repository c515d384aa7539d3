//! The spherical Geneva wheel with axes at right angles: a part of a sphere with slots along meridians, and a driver
//! whose pin points to the centre of the sphere, where the two axes meet.
//!
//! Notation: `N` stations, α = π/N half the angle between slots, τ = tan α, θ crank angle from where the pin is deepest
//! in its slot, φ wheel angle from the middle of the index, s = sin θ.
//!
//! With the wheel's axis as z and the driver's as x, the pin is in the direction (cos α, sin α sin θ, sin α cos θ): it
//! stands at the angle α to the driver's axis, so that it enters and leaves along a meridian. The wheel's angle is
//! φ = atan(τ sin θ), and the pin is in a slot for half of the driver's turn, whatever N is. Two pins leave no dwell.

use crate::error::KinematicsError;
use crate::indexing::{AccelerationPeak, Indexing, JerkPeak, Phase, PinInSlot, WheelMotion, within_half_pitch};
use crate::wheel::STATIONS;
use crate::{Field, Turn};
use std::f64::consts::{FRAC_PI_2, PI};

/// The most pins that a driver can have: each is in a slot for half a turn.
const MOST_PINS: u32 = 2;

/// A spherical Geneva wheel with its driver; lengths are in crank radii, the distance of a pin from the driver's axis.
///
/// Its motion tends to that of a Scotch yoke as N grows: the velocity ratio over tan α to cos θ. What the methods return
/// is right to 4 · 10⁻¹⁵ of the greatest of its kind over the engagement.
///
/// ```
/// use geneva_kinematics::indexing::Indexing;
/// use geneva_kinematics::spherical_wheel::SphericalWheel;
///
/// let wheel = SphericalWheel::new(4)?; // α = 45°, so tan α = 1
/// assert!((wheel.sphere_radius_ratio() - 2_f64.sqrt()).abs() < 1e-15); // 1 / sin α, in crank radii
/// assert!((wheel.peak_velocity() - 1.0).abs() < 1e-15); // tan α
/// assert_eq!(SphericalWheel::with_pins(4, 2)?.dwell_fraction(), 0.0); // two pins take turns
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphericalWheel {
    stations: u32,
    pins: u32,
    sine: f64,
    cosine: f64,
}

/// Angular velocity of the wheel over that of the driver, dimensionless: τ cos θ / (1 + τ² s²).
///
/// `tangent` is τ = tan α. Zero at entry and exit, a quarter of a turn from the middle.
///
/// ```
/// use geneva_kinematics::spherical_wheel::velocity_ratio;
/// use geneva_kinematics::{Turn, rational};
///
/// // In the middle it is tan α; at cos θ = 3/5, sin θ = 4/5 and tan α = 1 it is (3/5) / (1 + 16/25).
/// let (middle, later) = (Turn { cos: rational(1, 1), sin: rational(0, 1) }, Turn::from_half_tangent(&rational(1, 2)));
/// assert_eq!(velocity_ratio(&rational(1, 1), &middle), rational(1, 1));
/// assert_eq!(velocity_ratio(&rational(1, 1), &later), rational(15, 41));
/// ```
pub fn velocity_ratio<S: Field>(tangent: &S, crank: &Turn<S>) -> S {
    tangent.clone() * crank.cos.clone() / (S::one() + slope_squared(tangent, crank))
}

/// Angular acceleration of the wheel over the square of the driver's constant angular velocity, dimensionless:
/// −τ s (1 + 2 τ² − τ² s²) / (1 + τ² s²)².
///
/// ```
/// use geneva_kinematics::spherical_wheel::acceleration_ratio;
/// use geneva_kinematics::{Turn, rational};
///
/// // As the pin enters it is sin α cos α: one half for four stations.
/// let entry = Turn { cos: rational(0, 1), sin: rational(-1, 1) };
/// assert_eq!(acceleration_ratio(&rational(1, 1), &entry), rational(1, 2));
/// ```
pub fn acceleration_ratio<S: Field>(tangent: &S, crank: &Turn<S>) -> S {
    let w = slope_squared(tangent, crank);
    let square = S::one() + w.clone();
    -(tangent.clone() * crank.sin.clone() * (twice_and_one(tangent) - w)) / (square.clone() * square)
}

/// Rate of change of the wheel's angular acceleration over the cube of the driver's constant angular velocity,
/// dimensionless, with w = τ² s²: −τ cos θ (1 + 2 τ² − 6 (1 + τ²) w + w²) / (1 + w)³.
///
/// At the ends of the engagement the acceleration jumps, and the jerk has no finite value.
///
/// ```
/// use geneva_kinematics::spherical_wheel::{acceleration_ratio, jerk_ratio};
/// use geneva_kinematics::{Jet, Turn, rational};
///
/// // The rate of the acceleration ratio with the crank angle, without rounding.
/// let (tangent, crank) = (rational(1, 1), Turn::from_half_tangent(&rational(1, 2)));
/// let acceleration = acceleration_ratio(&Jet::constant(tangent.clone()), &crank.moving::<2>(rational(1, 1)));
/// assert_eq!(jerk_ratio(&tangent, &crank), acceleration.rate());
/// ```
pub fn jerk_ratio<S: Field>(tangent: &S, crank: &Turn<S>) -> S {
    let w = slope_squared(tangent, crank);
    let square = S::one() + w.clone();
    let sum = S::one() + tangent.clone() * tangent.clone();
    let braces = twice_and_one(tangent) - S::integer(6) * sum * w.clone() + w.clone() * w;
    -(tangent.clone() * crank.cos.clone() * braces) / (square.clone() * square.clone() * square)
}

/// τ² s².
fn slope_squared<S: Field>(tangent: &S, crank: &Turn<S>) -> S {
    let slope = tangent.clone() * crank.sin.clone();
    slope.clone() * slope
}

/// 1 + 2 τ².
fn twice_and_one<S: Field>(tangent: &S) -> S {
    S::one() + S::integer(2) * tangent.clone() * tangent.clone()
}

impl SphericalWheel {
    /// A wheel of so many stations, and one pin.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Stations`] outside [`STATIONS`]. With two the pin would pass over the wheel's axis.
    pub fn new(stations: u32) -> Result<Self, KinematicsError> {
        Self::with_pins(stations, 1)
    }

    /// A wheel of so many stations, and one pin or two opposite ones.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Stations`] outside [`STATIONS`], [`KinematicsError::Pins`] for none or more than two.
    pub fn with_pins(stations: u32, pins: u32) -> Result<Self, KinematicsError> {
        if !STATIONS.contains(&stations) {
            return Err(KinematicsError::Stations(stations));
        }
        if !(1..=MOST_PINS).contains(&pins) {
            return Err(KinematicsError::Pins { asked: pins, most: MOST_PINS, stations });
        }
        let half_pitch = PI / f64::from(stations);
        Ok(Self { stations, pins, sine: libm::sin(half_pitch), cosine: libm::cos(half_pitch) })
    }

    /// τ = tan α.
    fn tangent(&self) -> f64 {
        self.sine / self.cosine
    }

    /// Distance of a pin's centre from the point where the axes meet, in crank radii: 1 / sin α.
    ///
    /// As the pin enters it is also the distance from the wheel's axis: the wheel's radius.
    pub fn sphere_radius_ratio(&self) -> f64 {
        self.sine.recip()
    }

    /// Least length of a slot along its meridian, from where the pin's centre enters to where it is deepest, in crank
    /// radii: α / sin α.
    pub fn slot_length_ratio(&self) -> f64 {
        self.half_pitch_angle() / self.sine
    }

    /// |θ| as sine and cosine, if it is within the engagement. The cosine is zero at its ends.
    fn place(&self, crank: f64) -> Result<Turn<f64>, KinematicsError> {
        let (size, most) = (crank.abs(), FRAC_PI_2);
        if !(0.0..=most).contains(&size) {
            return Err(KinematicsError::OutsideEngagement { asked: crank, most });
        }
        Ok(Turn { cos: libm::sin(most - size), sin: libm::sin(size) })
    }
}

impl Indexing for SphericalWheel {
    fn stations(&self) -> u32 {
        self.stations
    }

    fn pins(&self) -> u32 {
        self.pins
    }

    /// Crank angle at which a pin enters and leaves: π/2, whatever N is.
    fn engagement_half_angle(&self) -> f64 {
        FRAC_PI_2
    }

    fn motion_fraction(&self) -> f64 {
        0.5 * f64::from(self.pins)
    }

    fn engaged(&self, crank: f64) -> Result<WheelMotion, KinematicsError> {
        let (tangent, place) = (self.tangent(), self.place(crank)?);
        let (before, angle) = (crank < 0.0, libm::atan(tangent * place.sin));
        // Of the deceleration, at the positive angle. No negative zero in the middle.
        let acceleration = acceleration_ratio(&tangent, &place);
        Ok(WheelMotion {
            phase: Phase::Advance,
            stations: 0,
            angle: if before { -angle } else { angle },
            velocity: velocity_ratio(&tangent, &place),
            acceleration: if before { -acceleration } else { 0.0 + acceleration },
            jerk: jerk_ratio(&tangent, &place),
        })
    }

    /// The distance from the wheel's axis is √(1 + τ² s²) / τ; along the meridian the pin moves at
    /// sin θ / (cos α √(1 + τ² s²)) of its speed.
    fn pin_in_slot(&self, crank: f64) -> Result<PinInSlot, KinematicsError> {
        let (tangent, place) = (self.tangent(), self.place(crank)?);
        let root = (1.0 + slope_squared(&tangent, &place)).sqrt();
        let sine = if crank < 0.0 { -place.sin } else { place.sin };
        let rate = tangent * sine * place.cos / root;
        Ok(PinInSlot {
            radius: root / tangent,
            radius_rate: rate,
            sliding: sine / (self.cosine * root),
            coriolis: 2.0 * velocity_ratio(&tangent, &place) * rate,
            turning: 0.0,
        })
    }

    /// sin θ = tan φ / tan α.
    fn crank_at(&self, wheel_angle: f64) -> Result<f64, KinematicsError> {
        let angle = within_half_pitch(self, wheel_angle)?;
        Ok(libm::asin((libm::tan(angle) / self.tangent()).clamp(-1.0, 1.0)))
    }

    /// Greatest velocity ratio: tan α.
    fn peak_velocity(&self) -> f64 {
        self.tangent()
    }

    /// Size of the acceleration ratio as a pin enters: sin α cos α.
    fn entry_acceleration(&self) -> f64 {
        self.sine * self.cosine
    }

    /// Where τ² s² = (1 + 2 τ²) / (3 (1 + τ²) + √(9 (1 + τ²)² − 1 − 2 τ²)), with up to seven stations; with more, at the
    /// ends of the engagement.
    fn acceleration_peak(&self) -> AccelerationPeak {
        let square = self.tangent() * self.tangent();
        let (sum, product) = (3.0 * (1.0 + square), 1.0 + 2.0 * square);
        let w = product / (sum + (sum * sum - product).sqrt());
        let angle = if w < square { libm::asin((w / square).sqrt()) } else { FRAC_PI_2 };
        let ratio = self.engaged(angle).map_or(0.0, |motion| motion.acceleration.abs());
        AccelerationPeak { angle, ratio }
    }

    /// In the middle, tan α (1 + 2 tan² α).
    ///
    /// It is the greatest of the engagement for every N: [`SphericalJerkBound`](crate::spherical_wheel_proofs::SphericalJerkBound).
    fn jerk_peak(&self) -> JerkPeak {
        JerkPeak { angle: 0.0, ratio: self.tangent() * twice_and_one(&self.tangent()) }
    }
}
