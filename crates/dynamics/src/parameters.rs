//! What one may choose about an escapement, checked once: mechanism, inertias, torque, friction.
//!
//! Any coherent system of units will do; the source measures in inches, pounds (force) and seconds, so that a torque is
//! in in·lb and a moment of inertia in in·lb·s².

use crate::error::{not_negative, positive};
use crate::existence;
use crate::{Acceleration, Coefficients, DynamicsError, Pose};
use geneva_kinematics::{Mechanism, Turn};

/// Moments of inertia of the two members about their own axes.
///
/// ```
/// use geneva_dynamics::Inertias;
///
/// let inertias = Inertias::new(2e-6, 1e-6)?; // driver and follower, kg m²
/// assert_eq!(inertias.ratio(), 2.0);
/// assert!(Inertias::new(0.0, 1e-6).is_err());
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
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
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for an inertia, or a quotient of the two, that is not positive and finite.
    pub fn new(driver: f64, follower: f64) -> Result<Self, DynamicsError> {
        let inertias =
            Self { driver: positive("driver inertia", driver)?, follower: positive("follower inertia", follower)? };
        positive("driver inertia over follower inertia", inertias.ratio())?;
        Ok(inertias)
    }

    /// Moment of inertia of the driver, I_D, in the unit of the torque times the square of the unit of time.
    pub fn driver(&self) -> f64 {
        self.driver
    }

    /// Moment of inertia of the follower, I_f, in the unit of [`driver`](Self::driver).
    pub fn follower(&self) -> f64 {
        self.follower
    }

    /// I_D / I_f, dimensionless.
    pub fn ratio(&self) -> f64 {
        self.driver / self.follower
    }
}

/// An escapement whose equation of motion has one solution wherever a pin is in its slot.
///
/// ```
/// use geneva_dynamics::{DynamicsError, Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let inertias = Inertias::new(2e-6, 1e-6)?; // driver and follower, kg m²
/// let timer = Parameters::new(Mechanism::FOUR_PIN, inertias, 1e-3, 0.2)?; // torque in N m, friction coefficient
/// assert!((timer.drive() - 1000.0).abs() < 1e-9); // K / I_f, per s²
/// let rough = Parameters::new(Mechanism::FOUR_PIN, inertias, 1e-3, 1e3);
/// assert!(matches!(rough, Err(DynamicsError::TooMuchFriction { .. }))); // it might jam
/// # Ok::<(), DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    mechanism: Mechanism,
    inertias: Inertias,
    torque: f64,
    friction: f64,
}

impl Parameters {
    /// An escapement with this torque K (> 0) on its driver and this coefficient of friction μ between pin and slot.
    ///
    /// μ may be zero; it must stay below [`existence::critical_friction`].
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for a torque, or one over I_f, that is not positive and finite; [`DynamicsError::Negative`] for a
    /// friction that is negative or not finite; [`DynamicsError::TooMuchFriction`] from the critical friction on.
    pub fn new(mechanism: Mechanism, inertias: Inertias, torque: f64, friction: f64) -> Result<Self, DynamicsError> {
        let torque = positive("torque", torque)?;
        positive("torque over follower inertia", torque / inertias.follower)?;
        let friction = not_negative("friction coefficient", friction)?;
        if !existence::surely_below_critical(mechanism, inertias.ratio(), friction) {
            let critical = existence::critical_friction(mechanism, inertias.ratio())?;
            if friction >= critical.friction {
                let (limit, angle) = (critical.friction, critical.angle);
                return Err(DynamicsError::TooMuchFriction { asked: friction, limit, angle });
            }
        }
        Ok(Self { mechanism, inertias, torque, friction })
    }

    /// The escapement with another friction.
    ///
    /// # Errors
    ///
    /// As for [`Parameters::new`].
    pub fn with_friction(&self, friction: f64) -> Result<Self, DynamicsError> {
        Self::new(self.mechanism, self.inertias, self.torque, friction)
    }

    /// Pins, slots and centre distance.
    pub fn mechanism(&self) -> Mechanism {
        self.mechanism
    }

    /// Moments of inertia.
    pub fn inertias(&self) -> Inertias {
        self.inertias
    }

    /// Torque on the driver, K, in any unit that is consistent with those of the inertias and of time.
    pub fn torque(&self) -> f64 {
        self.torque
    }

    /// Coefficient of friction between pin and slot, μ, dimensionless.
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// E = K / I_f, per square of the unit of time.
    pub fn drive(&self) -> f64 {
        self.torque / self.inertias.follower
    }

    /// The pose at a crank angle in radians from the line of centres.
    pub fn pose(&self, angle: f64) -> Pose<f64> {
        let pose = Pose::new(&self.mechanism.centre_distance_ratio(), &Turn::from_radians(angle));
        Pose { one_minus_k_squared: 1.0 - self.mechanism.centre_distance_ratio_squared(), ..pose }
    }

    /// Coefficients of Eq. (1-19) at a crank angle in radians from the line of centres.
    pub fn coefficients(&self, angle: f64) -> Coefficients<f64> {
        Coefficients::from_pose(&self.pose(angle), &self.inertias.ratio(), &self.friction, &self.drive())
    }

    /// The driver's acceleration at a crank angle (radians) and a speed (≥ 0, radians per unit of time).
    ///
    /// While a pin is in its slot and the friction is below the critical friction, there is exactly one. Beyond these
    /// limits the formula is evaluated all the same, and may give none.
    ///
    /// ```
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// // As a pin enters, from rest, it does not yet press on the slot: the torque accelerates the driver alone.
    /// let inertias = Inertias::new(0.5, 1.0)?; // kg m²
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, inertias, 3.0, 0.2)?; // N m
    /// let entry = -timer.mechanism().engagement_half_angle(); // rad
    /// assert!((timer.acceleration(entry, 0.0)?.value - 3.0 / 0.5).abs() < 1e-12); // rad/s²
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotFinite`] for an angle that is not finite; those of [`Coefficients::acceleration`].
    pub fn acceleration(&self, angle: f64, speed: f64) -> Result<Acceleration, DynamicsError> {
        if !angle.is_finite() {
            return Err(DynamicsError::NotFinite { name: "crank angle", asked: angle });
        }
        self.coefficients(angle).acceleration(speed)
    }
}
