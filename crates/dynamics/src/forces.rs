//! Forces between pin and slot, and what friction takes from the driver.
//!
//! The follower is moved by the normal force alone: N R = I_f φ''. A positive N drives the follower on, so the pin
//! bears on the flank ahead of it; a negative one holds it back, so the pin bears on the flank behind it. Friction acts
//! along the slot, against the sliding, with the moment arm c |sin φ| = |dR/dθ| about the driver's axis.

use crate::{DynamicsError, Parameters};

/// The flank of the slot that the pin bears on; ahead and behind as the follower turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flank {
    /// The flank ahead of the pin: the pin drives the follower.
    Leading,
    /// The flank behind the pin: the follower, running ahead, drives the pin.
    Trailing,
    /// Neither presses: the follower keeps its speed by itself.
    Neither,
}

/// Forces between pin and slot at one instant. They are moments at the crank radius: lengths have not been chosen
/// yet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactForces {
    /// Angular acceleration of the follower, φ'', in radians per square of the unit of time.
    pub follower_acceleration: f64,
    /// N r, normal force times crank radius, in the unit of the torque; positive on the leading flank.
    pub normal_moment: f64,
    /// Torque of friction about the driver's axis, in the unit of the torque, never negative; it acts against the
    /// driver's motion.
    pub friction_torque: f64,
    /// Flank of the slot that the pin bears on.
    pub flank: Flank,
}

impl ContactForces {
    /// The normal force for a crank of this radius: in the unit of the torque over that of the radius.
    pub fn normal_force(&self, crank_radius: f64) -> f64 {
        self.normal_moment / crank_radius
    }
}

impl Parameters {
    /// Forces at a crank angle (radians from the line of centres) and a speed of the driver (≥ 0).
    ///
    /// Meyer 1973, Eqs. (1-13), with its first exponent put right, and (1-14).
    ///
    /// ```
    /// use geneva_dynamics::forces::Flank;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// // As the pin enters a follower of four slots, R = r and φ'' = θ'²; friction is along the slot with the arm r.
    /// let inertias = Inertias::new(0.5, 2.0)?; // kg m²
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, inertias, 1.0, 0.2)?;
    /// let entry = timer.contact_forces(-timer.mechanism().engagement_half_angle(), 3.0)?; // rad/s
    /// assert!((entry.normal_moment - 2.0 * 3.0 * 3.0).abs() < 1e-12); // N m: I_f θ'²
    /// assert!((entry.friction_torque - 0.2 * entry.normal_moment).abs() < 1e-12); // N m
    /// assert_eq!(entry.flank, Flank::Leading);
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Parameters::acceleration`].
    pub fn contact_forces(&self, angle: f64, speed: f64) -> Result<ContactForces, DynamicsError> {
        let angular_acceleration = self.acceleration(angle, speed)?.value;
        let pose = self.pose(angle);
        let follower_acceleration = pose.follower_acceleration(&speed, &angular_acceleration);
        let normal_moment = self.inertias().follower() * follower_acceleration / pose.radius_squared.sqrt();
        let friction_torque =
            self.friction() * normal_moment.abs() * moment_arm_ratio(pose.k_sin_theta, pose.radius_squared);
        let flank = match normal_moment {
            moment if moment > 0.0 => Flank::Leading,
            moment if moment < 0.0 => Flank::Trailing,
            _ => Flank::Neither,
        };
        Ok(ContactForces { follower_acceleration, normal_moment, friction_torque, flank })
    }
}

/// Moment arm of the friction about the driver's axis over the crank radius, a |sin θ| / R: also |dR/dθ|.
fn moment_arm_ratio(cross: f64, square: f64) -> f64 {
    cross.abs() / square.sqrt()
}
