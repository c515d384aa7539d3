//! A pin in a straight slot through the pivot of a turning follower: velocities and accelerations term by term.
//!
//! The route is that of the vector diagrams. What moves the pin does not matter: a driver's crank under a Geneva wheel
//! and the crank of a quick-return mechanism are the same case. Known are the place, the velocity and the
//! acceleration of the pin, seen from the follower's pivot in a frame that stands still. Known are also two
//! *directions*: the slot's own, and the one across it. Two directions close a diagram.

use crate::Field;
use crate::pin_vectors::{PinMotion, quarter_turn};
use nalgebra::Vector2;

/// The acceleration of a pin in a slot, as the sum of what the follower carries and what the slot lets through.
///
/// pin = follower normal + follower tangential + sliding normal + sliding tangential + Coriolis.
#[derive(Clone, Debug, PartialEq)]
pub struct SlotAccelerations<S> {
    /// Acceleration of the follower's point under the pin, towards the follower's pivot: −ω² r, a vector.
    pub follower_normal: Vector2<S>,
    /// Acceleration of the follower's point under the pin, across the slot: α × r.
    pub follower_tangential: Vector2<S>,
    /// Acceleration of the pin relative to the follower, across its path there. The path is a straight slot: zero.
    pub sliding_normal: Vector2<S>,
    /// Acceleration of the pin relative to the follower, along the slot.
    pub sliding_tangential: Vector2<S>,
    /// Coriolis acceleration, 2 ω × v with v the sliding velocity: v turned by a quarter with the follower, 2 ω times.
    pub coriolis: Vector2<S>,
    /// Angular acceleration of the follower in the unit of the pin's acceleration over that of its distance,
    /// counter-clockwise positive.
    pub follower_acceleration: S,
}

/// Closes the velocity diagram: the pin's velocity is the slot's, across, plus the sliding, along.
///
/// Position and velocity are vectors from the follower's pivot, in any units of length and time that fit together.
/// `None` if the pin is on the follower's pivot, where the slot has no direction.
///
/// ```
/// use geneva_kinematics::relative_motion::velocities;
/// use nalgebra::Vector2;
///
/// // A pin 2 m from the pivot moves outward at 3 m/s and across the slot at 4 m/s.
/// let motion = velocities(&Vector2::new(2.0, 0.0), &Vector2::new(3.0, 4.0)).expect("off the pivot");
/// assert_eq!(motion.follower_speed, 2.0); // rad/s: 4 / 2
/// assert_eq!(motion.sliding_velocity, Vector2::new(3.0, 0.0)); // m/s
/// ```
pub fn velocities<S: Field>(position: &Vector2<S>, pin_velocity: &Vector2<S>) -> Option<PinMotion<S>> {
    let square = position.dot(position);
    if square.is_zero() {
        return None;
    }
    // Across the slot the follower's point moves as the pin does.
    let follower_speed = quarter_turn(position).dot(pin_velocity) / square;
    Some(PinMotion::new(position.clone(), pin_velocity.clone(), follower_speed))
}

/// Closes the acceleration diagram of a motion whose velocities are known, in the units of that motion.
///
/// Normal and Coriolis terms follow from the velocities; of the two tangential terms the directions are known, along
/// the slot and across it, and what is left of the pin's acceleration has one component in each.
/// `None` if the pin is on the follower's pivot.
///
/// ```
/// use geneva_kinematics::relative_motion::{accelerations, velocities};
/// use nalgebra::Vector2;
///
/// // The pin flies straight on: 2 m from the pivot, 3 m/s outward, 4 m/s across, no acceleration.
/// let motion = velocities(&Vector2::new(2.0, 0.0), &Vector2::new(3.0, 4.0)).expect("off the pivot");
/// let terms = accelerations(&motion, &Vector2::zeros()).expect("off the pivot");
/// assert_eq!(terms.coriolis, Vector2::new(0.0, 12.0)); // m/s²: 2 · 2 rad/s · 3 m/s
/// assert_eq!(terms.follower_acceleration, -6.0); // rad/s²: −12 / 2
/// assert_eq!(terms.sliding_tangential, Vector2::new(8.0, 0.0)); // m/s²: 2 m (2 rad/s)²
/// ```
pub fn accelerations<S: Field>(motion: &PinMotion<S>, pin_acceleration: &Vector2<S>) -> Option<SlotAccelerations<S>> {
    let (along, across) = (&motion.position, quarter_turn(&motion.position));
    let square = along.dot(along);
    if square.is_zero() {
        return None;
    }
    let speed = motion.follower_speed.clone();
    let follower_normal = -(along.clone() * (speed.clone() * speed.clone()));
    let coriolis = quarter_turn(&motion.sliding_velocity) * (S::integer(2) * speed);
    let rest = pin_acceleration.clone() - follower_normal.clone() - coriolis.clone();
    let follower_acceleration = across.dot(&rest) / square.clone();
    let sliding_tangential = along.clone() * (along.dot(&rest) / square);
    let follower_tangential = across * follower_acceleration.clone();
    Some(SlotAccelerations {
        follower_normal,
        follower_tangential,
        sliding_normal: Vector2::zeros(),
        sliding_tangential,
        coriolis,
        follower_acceleration,
    })
}

impl<S: Field> SlotAccelerations<S> {
    /// The sum of the terms, which is the pin's acceleration.
    pub fn sum(&self) -> Vector2<S> {
        self.follower_normal.clone()
            + self.follower_tangential.clone()
            + self.sliding_normal.clone()
            + self.sliding_tangential.clone()
            + self.coriolis.clone()
    }
}
