//! What one may choose about an escapement, checked once: slots, inertias, torque, friction.
//!
//! Any coherent system of units will do; the source measures in inches, pounds (force) and seconds, so that a torque is
//! in in·lb and a moment of inertia in in·lb·s².

use crate::existence;
use crate::{Acceleration, Coefficients, EquationError, Pose};
use geneva_kinematics::Turn;
use std::f64::consts::PI;
use std::fmt;

/// Slots of the follower. Each fixes the number of pins: a pin must enter as the one before it leaves.
///
/// A pin is in its slot while the driver turns by 2π/m and the follower by 2π/n. At entry the crank is at right angles
/// to the slot, so π/m + π/n = π/2: m = 2 n / (n − 2), a whole number of at least three for three, four and six slots
/// only. Meyer 1973, Eq. (1-3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slots {
    /// Three slots, six pins.
    Three,
    /// Four slots, four pins.
    Four,
    /// Six slots, three pins.
    Six,
}

impl Slots {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Three, Self::Four, Self::Six];

    /// The follower with so many slots: three, four or six.
    pub fn new(count: u32) -> Result<Self, ParameterError> {
        Self::ALL.into_iter().find(|slots| slots.count() == count).ok_or(ParameterError::Slots(count))
    }

    /// Number of slots, n.
    pub fn count(self) -> u32 {
        match self {
            Self::Three => 3,
            Self::Four => 4,
            Self::Six => 6,
        }
    }

    /// Number of pins on the driver, m = 2 n / (n − 2). Meyer 1973, Eq. (1-3).
    pub fn pins(self) -> u32 {
        2 * self.count() / (self.count() - 2)
    }

    /// Centre distance over crank radius, a = 1 / sin(π/n). Meyer 1973, Eq. (1-2).
    pub fn ratio(self) -> f64 {
        self.ratio_squared().sqrt()
    }

    /// a², a fraction: 4/3, 2 and 4.
    pub fn ratio_squared(self) -> f64 {
        match self {
            Self::Three => 4.0 / 3.0,
            Self::Four => 2.0,
            Self::Six => 4.0,
        }
    }

    /// Crank angle at which a pin leaves its slot, π/m in radians; it enters at minus this angle.
    pub fn engagement_half_angle(self) -> f64 {
        PI / f64::from(self.pins())
    }
}

/// Moments of inertia of the two members about their own axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertias {
    driver: f64,
    follower: f64,
}

impl Inertias {
    /// Driver and follower, both positive and finite, in one unit.
    ///
    /// Without inertia of the driver nothing is left to accelerate as a pin enters, where the follower stands still:
    /// there A = D = 0, and near it A < |D| for any friction. Without inertia of the follower there is no normal
    /// force, no friction and no brake; the equation, written per unit of I_f, does not cover it.
    pub fn new(driver: f64, follower: f64) -> Result<Self, ParameterError> {
        let inertias =
            Self { driver: positive("driver inertia", driver)?, follower: positive("follower inertia", follower)? };
        positive("driver inertia over follower inertia", inertias.ratio())?;
        Ok(inertias)
    }

    /// Moment of inertia of the driver, I_D.
    pub fn driver(&self) -> f64 {
        self.driver
    }

    /// Moment of inertia of the follower, I_f.
    pub fn follower(&self) -> f64 {
        self.follower
    }

    /// I_D / I_f.
    pub fn ratio(&self) -> f64 {
        self.driver / self.follower
    }
}

/// An escapement whose equation of motion has one solution wherever a pin is in its slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    slots: Slots,
    inertias: Inertias,
    torque: f64,
    friction: f64,
}

/// A value that no such escapement can have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterError {
    /// Not three, four or six slots.
    Slots(u32),
    /// A quantity that must be positive and finite is not.
    NotPositive {
        /// Which quantity.
        name: &'static str,
        /// What was asked for.
        asked: f64,
    },
    /// A coefficient of friction that is negative or not finite.
    Friction(f64),
    /// So much friction that somewhere no acceleration, or more than one, obeys the equation of motion.
    TooMuchFriction {
        /// What was asked for.
        asked: f64,
        /// The friction that it must stay below.
        limit: f64,
        /// Crank angle in radians, to either side of the line of centres, where the limit is first reached.
        angle: f64,
    },
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Slots(asked) => write!(
                f,
                "{asked} slots: each pin comes and goes along its slot only with 3, 4 or 6 slots (6, 4 or 3 pins), where \
                 2 n / (n - 2) is a whole number above 2; give one of these"
            ),
            Self::NotPositive { name, asked } => {
                write!(f, "{name} {asked}: it must be positive and finite; give a number above zero")
            }
            Self::Friction(asked) => {
                write!(f, "friction coefficient {asked}: it must be finite and not negative; give zero or more")
            }
            Self::TooMuchFriction { asked, limit, angle } => write!(
                f,
                "friction coefficient {asked}: from {limit} on, the equation of motion has no single solution at \
                 {angle} rad from the line of centres; give less friction or a driver with more inertia"
            ),
        }
    }
}

impl std::error::Error for ParameterError {}

impl Parameters {
    /// An escapement with this torque K (> 0) on its driver and this coefficient of friction μ between pin and slot.
    ///
    /// μ may be zero; it must stay below [`existence::critical_friction`].
    pub fn new(slots: Slots, inertias: Inertias, torque: f64, friction: f64) -> Result<Self, ParameterError> {
        let torque = positive("torque", torque)?;
        positive("torque over follower inertia", torque / inertias.follower)?;
        let friction = not_negative(friction)?;
        if !existence::surely_below_critical(slots, inertias.ratio(), friction) {
            let critical = existence::critical_friction(slots, inertias.ratio())?;
            if friction >= critical.friction {
                let (limit, angle) = (critical.friction, critical.angle);
                return Err(ParameterError::TooMuchFriction { asked: friction, limit, angle });
            }
        }
        Ok(Self { slots, inertias, torque, friction })
    }

    /// Slots of the follower.
    pub fn slots(&self) -> Slots {
        self.slots
    }

    /// Moments of inertia.
    pub fn inertias(&self) -> Inertias {
        self.inertias
    }

    /// Torque on the driver, K.
    pub fn torque(&self) -> f64 {
        self.torque
    }

    /// Coefficient of friction between pin and slot, μ.
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// E = K / I_f, per square of the unit of time.
    pub fn drive(&self) -> f64 {
        self.torque / self.inertias.follower
    }

    /// The pose at a crank angle in radians from the line of centres.
    pub fn pose(&self, angle: f64) -> Pose<f64> {
        let pose = Pose::new(&self.slots.ratio(), &Turn::from_radians(angle));
        Pose { shape: 1.0 - self.slots.ratio_squared(), ..pose }
    }

    /// Coefficients of Eq. (1-19) at a crank angle in radians from the line of centres.
    pub fn coefficients(&self, angle: f64) -> Coefficients<f64> {
        Coefficients::of_pose(&self.pose(angle), &self.inertias.ratio(), &self.friction, &self.drive())
    }

    /// The driver's acceleration at a crank angle (radians) and a speed (≥ 0, radians per unit of time).
    ///
    /// While a pin is in its slot there always is one. Beyond, the formula is evaluated all the same, and may have
    /// none.
    pub fn acceleration(&self, angle: f64, speed: f64) -> Result<Acceleration, EquationError> {
        if !angle.is_finite() {
            return Err(EquationError::Angle(angle));
        }
        self.coefficients(angle).acceleration(speed)
    }
}

/// The value, if it is positive and finite.
pub(crate) fn positive(name: &'static str, asked: f64) -> Result<f64, ParameterError> {
    if asked > 0.0 && asked.is_finite() { Ok(asked) } else { Err(ParameterError::NotPositive { name, asked }) }
}

/// The coefficient of friction, if it is finite and not negative.
pub(crate) fn not_negative(friction: f64) -> Result<f64, ParameterError> {
    if friction >= 0.0 && friction.is_finite() { Ok(friction) } else { Err(ParameterError::Friction(friction)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::wheel::Wheel;

    #[test]
    fn slots_and_pins_are_those_that_fit() {
        for count in 0..40 {
            let whole = count > 2 && (2 * count) % (count - 2) == 0;
            let fits = whole && 2 * count / (count - 2) > 2;
            assert_eq!(Slots::new(count).is_ok(), fits, "{count}");
        }
        let message = Slots::new(5).expect_err("five slots").to_string();
        assert!(message.contains("5 slots") && message.contains("3, 4 or 6"), "{message}");
        for slots in Slots::ALL {
            let wheel = Wheel::with_pins(slots.count(), slots.pins()).expect("a wheel without dwell");
            approx::assert_relative_eq!(slots.ratio(), wheel.centre_distance_ratio(), max_relative = 1e-15);
            let ends = (slots.engagement_half_angle(), wheel.engagement_half_angle());
            approx::assert_relative_eq!(ends.0, ends.1, max_relative = 1e-15);
            assert_eq!(wheel.dwell_fraction(), 0.0);
        }
    }

    #[test]
    fn impossible_values_are_named() {
        let bad = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        let sound = Inertias::new(1.0, 10.0).expect("sound");
        for value in bad {
            assert!(Inertias::new(value, 1.0).is_err() && Inertias::new(1.0, value).is_err(), "{value}");
            assert!(Parameters::new(Slots::Four, sound, value, 0.0).is_err(), "{value}");
        }
        for friction in &bad[1..] {
            let error = Parameters::new(Slots::Four, sound, 1.0, *friction).expect_err("bad friction");
            assert!(matches!(error, ParameterError::Friction(_)), "{error}");
        }
        assert!(Inertias::new(f64::MAX, f64::MIN_POSITIVE).is_err(), "their ratio overflows");
        assert!(Inertias::new(f64::MIN_POSITIVE, f64::MAX).is_err(), "their ratio vanishes");
        let error = Parameters::new(Slots::Four, sound, 1.0, 3.0).expect_err("too much friction");
        assert!(matches!(error, ParameterError::TooMuchFriction { .. }), "{error}");
        assert!(Parameters::new(Slots::Four, sound, 1.0, 0.0).is_ok());
    }

    #[test]
    fn every_pose_of_a_sound_escapement_has_one_acceleration() {
        for slots in Slots::ALL {
            let inertias = Inertias::new(3.0, 50.0).expect("sound");
            let limit = existence::critical_friction(slots, inertias.ratio()).expect("sound").friction;
            for part in 0..8 {
                let friction = limit * f64::from(part) / 8.0;
                let escapement = Parameters::new(slots, inertias, 7.0, friction).expect("below the limit");
                for step in -100..=100 {
                    let angle = slots.engagement_half_angle() * f64::from(step) / 100.0;
                    for speed in [0.0, 1.0, 30.0] {
                        let acceleration = escapement.acceleration(angle, speed).expect("one acceleration");
                        let coefficients = escapement.coefficients(angle);
                        let residual = coefficients.residual(&speed, &acceleration.value, acceleration.sign);
                        let scale = coefficients.e + coefficients.b.abs() * speed * speed;
                        assert!(residual.abs() < 1e-12 * scale, "{slots:?} {angle} {speed}");
                        let bars = coefficients.between_the_bars(&speed, &acceleration.value);
                        assert!(acceleration.sign.of(bars) >= -1e-12 * scale, "{slots:?} {angle} {speed}");
                    }
                }
            }
            let escapement = Parameters::new(slots, inertias, 7.0, 0.0).expect("no friction");
            for angle in [f64::NAN, f64::INFINITY] {
                assert!(matches!(escapement.acceleration(angle, 1.0), Err(EquationError::Angle(_))));
            }
        }
    }
}
