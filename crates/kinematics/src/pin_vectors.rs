//! Motion of a pin in a slot by differentiating where the pin is: vectors and power series, no triangle.
//!
//! Frame: the follower's pivot O is the origin, the driver's axis B lies at (l, 0). The crank angle φ is measured
//! counter-clockwise from the direction O → B; it is 180° minus the angle θ from the line of centres.

use crate::scalars::turn::angular_velocity;
use crate::{Field, Jet, Turn};
use nalgebra::Vector2;
use num_traits::Zero;

/// Position and velocities of the pin and of the slot under it, at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct PinMotion<S> {
    /// Position of the pin from the follower's pivot, in the caller's unit of length.
    pub position: Vector2<S>,
    /// Absolute velocity of the pin, in that unit over the unit of time of the driver's speed; so are the others.
    pub pin_velocity: Vector2<S>,
    /// Velocity of the follower's point under the pin.
    pub slot_point_velocity: Vector2<S>,
    /// Velocity of the pin relative to the follower, along the slot.
    pub sliding_velocity: Vector2<S>,
    /// Angular velocity of the follower in the unit of the driver's, counter-clockwise positive.
    pub follower_speed: S,
}

impl<S: Field> PinMotion<S> {
    /// The motion of a pin in the slot of a follower that turns at `follower_speed`, counter-clockwise positive.
    ///
    /// The slot's point is carried around the pivot; what the pin does beside that is sliding.
    pub fn carried(position: Vector2<S>, pin_velocity: Vector2<S>, follower_speed: S) -> Self {
        let slot_point_velocity = quarter_turn(&position) * follower_speed.clone();
        let sliding_velocity = pin_velocity.clone() - slot_point_velocity.clone();
        Self { position, pin_velocity, slot_point_velocity, sliding_velocity, follower_speed }
    }
}

/// Position of the pin, from the follower's pivot, as a power series of a moving crank: (l + R cos φ, R sin φ).
pub fn path<S: Field, const N: usize>(
    crank_radius: &S,
    centre_distance: &S,
    crank: &Turn<Jet<S, N>>,
) -> Vector2<Jet<S, N>> {
    crank.direction() * Jet::constant(crank_radius.clone())
        + Vector2::new(Jet::constant(centre_distance.clone()), Jet::zero())
}

/// The pin's motion for a crank of radius R at centre distance l, angle φ and angular velocity (counter-clockwise).
///
/// `None` if the pin is on the follower's pivot, where the slot has no direction. The pin's place as a power series
/// in time gives its velocity and, as the rate of its direction, the follower's angular velocity.
pub fn solve<S: Field>(crank_radius: &S, centre_distance: &S, crank: &Turn<S>, driver: &S) -> Option<PinMotion<S>> {
    let path = path(crank_radius, centre_distance, &crank.moving::<2>(driver.clone()));
    let follower_speed = angular_velocity(&path)?.value();
    let position = path.map(|coordinate| coordinate.value());
    let pin_velocity = path.map(|coordinate| coordinate.rate());
    Some(PinMotion::carried(position, pin_velocity, follower_speed))
}

/// The vector turned by a quarter, counter-clockwise: the direction of motion of a point that rotates so.
pub fn quarter_turn<S: Field>(vector: &Vector2<S>) -> Vector2<S> {
    Vector2::new(-vector.y.clone(), vector.x.clone())
}
