//! Ratios of the wheel's motion to the driver's while the pin is in the slot, beyond the velocity ratio.
//!
//! Written with k = 1 / sin α: multiplying numerator and denominator by k² turns the sources' forms in sin α into these.

use crate::pin_slot::{slot_radius_squared, velocity_ratio};
use crate::{Field, Turn};

/// Angular acceleration of the wheel over the square of the driver's constant angular velocity, dimensionless:
/// −k (k² − 1) sin θ / (1 + k² − 2 k cos θ)².
///
/// Positive while the wheel speeds up (θ < 0). JAZAR, Eq. (5.32); Eq. (5.29) with its lost sign for N = 4.
///
/// ```
/// use geneva_kinematics::Turn;
/// use geneva_kinematics::wheel::acceleration_ratio;
///
/// // Six stations: k = 2, and the pin enters at −60° with the acceleration tan 30°.
/// let entry = acceleration_ratio(&2.0, &Turn::from_degrees(-60.0));
/// assert!((entry - 1.0 / 3_f64.sqrt()).abs() < 1e-15);
/// ```
pub fn acceleration_ratio<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    let square = slot_radius_squared(ratio, crank);
    let shape = ratio.clone() * (ratio.clone() * ratio.clone() - S::one());
    -(shape * crank.sin.clone()) / (square.clone() * square)
}

/// Rate of change of the wheel's angular acceleration over the cube of the driver's constant angular velocity,
/// dimensionless:
/// −k (k² − 1) {(1 + k² − 2 k cos θ) cos θ − 4 k sin² θ} / (1 + k² − 2 k cos θ)³.
///
/// Inside the engagement; at its ends the acceleration jumps and the jerk has no finite value.
/// JAZAR, example (e), derivative of Eq. (5.32).
///
/// ```
/// use geneva_kinematics::wheel::{acceleration_ratio, jerk_ratio};
/// use geneva_kinematics::{Jet, Turn, rational};
///
/// // The rate of the acceleration ratio with the crank angle, without rounding.
/// let (ratio, crank) = (rational(2, 1), Turn::from_half_tangent(&rational(1, 2)));
/// let acceleration = acceleration_ratio(&Jet::constant(ratio.clone()), &crank.moving::<2>(rational(1, 1)));
/// assert_eq!(jerk_ratio(&ratio, &crank), acceleration.rate());
/// // On the line of centres it is −k (k + 1) / (k − 1)³.
/// let middle = Turn { cos: rational(1, 1), sin: rational(0, 1) };
/// assert_eq!(jerk_ratio(&ratio, &middle), rational(-6, 1));
/// ```
pub fn jerk_ratio<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    let square = slot_radius_squared(ratio, crank);
    let shape = ratio.clone() * (ratio.clone() * ratio.clone() - S::one());
    let sines = S::integer(4) * ratio.clone() * crank.sin.clone() * crank.sin.clone();
    -(shape * (square.clone() * crank.cos.clone() - sines)) / (square.clone() * square.clone() * square)
}

/// Angular acceleration of the wheel for a driver that speeds up: θ'' times the velocity ratio, plus θ'² times the
/// acceleration ratio. In the unit of the driver's acceleration.
///
/// JAZAR, display before Eq. (5.29), for any N.
///
/// ```
/// use geneva_kinematics::Turn;
/// use geneva_kinematics::wheel::unsteady_acceleration;
///
/// // On the line of centres a wheel with k = 2 follows the driver one to one, at any speed.
/// let (middle, speed, acceleration) = (Turn::from_radians(0.0), 40.0, 3.0); // rad/s, rad/s²
/// assert_eq!(unsteady_acceleration(&2.0, &middle, &speed, &acceleration), acceleration);
/// ```
pub fn unsteady_acceleration<S: Field>(ratio: &S, crank: &Turn<S>, driver_speed: &S, driver_acceleration: &S) -> S {
    driver_acceleration.clone() * velocity_ratio(ratio, crank)
        + driver_speed.clone() * driver_speed.clone() * acceleration_ratio(ratio, crank)
}
