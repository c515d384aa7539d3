//! Every velocity and acceleration of the mechanism at an instant, by closing the vector diagrams.

use crate::pin_vectors::{PinMotion, quarter_turn};
use crate::relative_motion::{self, SlotAccelerations};
use crate::{Field, Turn};
use nalgebra::Vector2;

/// How the crank turns at the instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive<S> {
    /// Angular velocity of the crank in rad/s or radians per any unit of time, counter-clockwise positive.
    pub speed: S,
    /// Angular acceleration of the crank in radians per that unit squared, counter-clockwise positive.
    pub acceleration: S,
}

impl<S: Field> Drive<S> {
    /// A crank that turns at constant speed.
    pub fn steady(speed: S) -> Self {
        Self { speed, acceleration: S::zero() }
    }
}

/// The whole motion at an instant: vectors in the frame of the [module](super), with directions and senses.
///
/// ```
/// use geneva_kinematics::quick_return::{Drive, LeverMotion};
/// use geneva_kinematics::{Turn, rational};
///
/// // Axes 2 apart, crank 1, at crank angle zero: the pin is 3 from the lever's pivot and moves across the lever.
/// let along = Turn { cos: rational(1, 1), sin: rational(0, 1) };
/// let drive = Drive::steady(rational(1, 1)); // rad per unit of time
/// let motion = LeverMotion::new(&rational(2, 1), &rational(1, 1), &along, &drive).expect("off the pivot");
/// assert_eq!(motion.velocities.follower_speed, rational(1, 3));
/// assert_eq!(motion.acceleration_gap().x, rational(0, 1)); // the diagram closes
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LeverMotion<S> {
    /// From the crank's axis to the pin, in the unit of its radius.
    pub crank: Vector2<S>,
    /// Place and velocities of the pin and of the lever's point under it; angular velocity of the lever.
    pub velocities: PinMotion<S>,
    /// Acceleration of the pin towards the crank's axis.
    pub pin_normal: Vector2<S>,
    /// Acceleration of the pin along its circle.
    pub pin_tangential: Vector2<S>,
    /// The five terms of the other side, and the angular acceleration of the lever.
    pub accelerations: SlotAccelerations<S>,
}

impl<S: Field> LeverMotion<S> {
    /// The motion at crank angle φ, for ground distance l and crank radius R in one unit of length.
    ///
    /// `None` if the pin is on the lever's pivot.
    pub fn new(ground: &S, radius: &S, crank: &Turn<S>, drive: &Drive<S>) -> Option<Self> {
        let crank = crank.direction() * radius.clone();
        let position = crank.clone() + Vector2::new(ground.clone(), S::zero());
        let pin_velocity = quarter_turn(&crank) * drive.speed.clone();
        let pin_normal = -(crank.clone() * (drive.speed.clone() * drive.speed.clone()));
        let pin_tangential = quarter_turn(&crank) * drive.acceleration.clone();
        let velocities = relative_motion::velocities(&position, &pin_velocity)?;
        let pin_acceleration = pin_normal.clone() + pin_tangential.clone();
        let accelerations = relative_motion::accelerations(&velocities, &pin_acceleration)?;
        Some(Self { crank, velocities, pin_normal, pin_tangential, accelerations })
    }

    /// What is missing to close the velocity diagram: zero, but for rounding.
    pub fn velocity_gap(&self) -> Vector2<S> {
        let PinMotion { pin_velocity, slot_point_velocity, sliding_velocity, .. } = &self.velocities;
        pin_velocity.clone() - slot_point_velocity.clone() - sliding_velocity.clone()
    }

    /// What is missing to close the acceleration diagram: zero, but for rounding.
    pub fn acceleration_gap(&self) -> Vector2<S> {
        self.pin_normal.clone() + self.pin_tangential.clone() - self.accelerations.sum()
    }
}
