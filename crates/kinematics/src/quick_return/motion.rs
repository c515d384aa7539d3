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
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<S> {
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

impl<S: Field> Motion<S> {
    /// The motion at crank angle φ, for ground distance l and crank radius R in one unit of length.
    ///
    /// `None` if the pin is on the lever's pivot.
    pub fn at(ground: &S, radius: &S, crank: &Turn<S>, drive: &Drive<S>) -> Option<Self> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pin_slot;
    use crate::quick_return::QuickReturn;
    use crate::wheel::{Wheel, acceleration_ratio};

    #[test]
    fn both_diagrams_close_all_around_and_for_both_kinds_of_lever() {
        for (ground, radius) in [(3.0, 1.0), (0.4, 1.0)] {
            for degrees in (0..360).step_by(7) {
                let crank = Turn::from_degrees(f64::from(degrees));
                let drive = Drive { speed: 2.0, acceleration: -3.0 };
                let motion = Motion::at(&ground, &radius, &crank, &drive).expect("off the pivot");
                assert!(motion.velocity_gap().norm() < 1e-12 * motion.velocities.pin_velocity.norm());
                assert!(motion.acceleration_gap().norm() < 1e-12 * motion.accelerations.coriolis.norm().max(1.0));
            }
        }
    }

    #[test]
    fn the_lever_is_a_geneva_wheel_that_is_never_let_go() {
        let wheel = Wheel::new(4).expect("possible");
        let (ratio, speed) = (wheel.centre_distance_ratio(), 1.7);
        for degrees in [-40.0, -13.0, 0.0, 8.0, 44.0] {
            let crank = Turn::from_degrees(degrees);
            // The wheel's angle is measured from the line of centres, the crank's here from the other side.
            let motion = Motion::at(&ratio, &1.0, &crank.supplement(), &Drive::steady(-speed)).expect("off the pivot");
            let expected = pin_slot::velocity_ratio(&ratio, &crank) * speed;
            approx::assert_relative_eq!(motion.velocities.follower_speed, expected, max_relative = 1e-12);
            let expected = acceleration_ratio(&ratio, &crank) * speed * speed;
            approx::assert_relative_eq!(
                motion.accelerations.follower_acceleration,
                expected,
                max_relative = 1e-12,
                epsilon = 1e-12
            );
        }
    }

    #[test]
    fn the_lever_stands_still_at_the_ends_of_its_swing() {
        let linkage = QuickReturn::new(2.0, 1.0).expect("possible");
        let end = Turn::from_radians(std::f64::consts::PI - linkage.strokes().fast / 2.0);
        let motion = Motion::at(&2.0, &1.0, &end, &Drive::steady(5.0)).expect("off the pivot");
        approx::assert_abs_diff_eq!(motion.velocities.follower_speed, 0.0, epsilon = 1e-14);
        approx::assert_abs_diff_eq!(motion.accelerations.coriolis.norm(), 0.0, epsilon = 1e-13);
    }
}
