//! Motion of a pin in a slot by differentiating where the pin is: vectors and power series, no triangle.
//!
//! Frame: the follower's pivot O is the origin, the driver's axis B lies at (l, 0). The crank angle φ is measured
//! counter-clockwise from the direction O → B; it is 180° minus the angle θ from the line of centres.

use crate::{Field, Jet, Turn, angular_velocity};
use nalgebra::Vector2;
use num_traits::Zero;

/// Position and velocities of the pin and of the slot under it, at one instant.
///
/// ```
/// use geneva_kinematics::pin_vectors::PinMotion;
/// use nalgebra::Vector2;
///
/// // A pin 2 m from the pivot moves outward at 3 m/s and across at 4 m/s; the follower turns at 4 / 2 = 2 rad/s.
/// let motion = PinMotion::carried(Vector2::new(2.0, 0.0), Vector2::new(3.0, 4.0), 2.0);
/// assert_eq!(motion.slot_point_velocity, Vector2::new(0.0, 4.0)); // m/s
/// assert_eq!(motion.sliding_velocity, Vector2::new(3.0, 0.0)); // m/s, along the slot
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PinMotion<S> {
    /// Position of the pin from the follower's pivot, in the caller's unit of length.
    pub position: Vector2<S>,
    /// Absolute velocity of the pin, in the unit of length over the unit of time of the driver's speed.
    pub pin_velocity: Vector2<S>,
    /// Velocity of the follower's point under the pin, in the unit of the pin's velocity.
    pub slot_point_velocity: Vector2<S>,
    /// Velocity of the pin relative to the follower, along the slot, in the unit of the pin's velocity.
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
///
/// ```
/// use geneva_kinematics::pin_vectors::path;
/// use geneva_kinematics::{Turn, rational};
/// use nalgebra::Vector2;
///
/// // A crank of 1 at right angles to the line of centres, axes 3 apart, one radian per unit of time.
/// let crank = Turn { cos: rational(0, 1), sin: rational(1, 1) };
/// let path = path(&rational(1, 1), &rational(3, 1), &crank.moving::<2>(rational(1, 1)));
/// assert_eq!(path.map(|of| of.value()), Vector2::new(rational(3, 1), rational(1, 1)));
/// assert_eq!(path.map(|of| of.rate()), Vector2::new(rational(-1, 1), rational(0, 1))); // towards the pivot
/// ```
pub fn path<S: Field, const N: usize>(
    crank_radius: &S,
    centre_distance: &S,
    crank: &Turn<Jet<S, N>>,
) -> Vector2<Jet<S, N>> {
    crank.direction() * Jet::constant(crank_radius.clone())
        + Vector2::new(Jet::constant(centre_distance.clone()), Jet::zero())
}

/// The pin's motion for a crank of radius R at centre distance l, both in one unit of length, at an angle φ and an
/// angular velocity, both counter-clockwise.
///
/// `None` if the pin is on the follower's pivot, where the slot has no direction. The pin's place as a power series
/// in time gives its velocity and, as the rate of its direction, the follower's angular velocity.
///
/// ```
/// use geneva_kinematics::pin_vectors::solve;
/// use geneva_kinematics::{Turn, rational};
///
/// // The pin is between the axes, which are 3 apart, 2 from the pivot: it moves at 1 across the slot.
/// let between = Turn { cos: rational(-1, 1), sin: rational(0, 1) };
/// let motion = solve(&rational(1, 1), &rational(3, 1), &between, &rational(1, 1)).expect("off the pivot");
/// assert_eq!(motion.follower_speed, rational(-1, 2)); // against the driver
/// assert_eq!(motion.sliding_velocity.x, rational(0, 1));
/// ```
pub fn solve<S: Field>(crank_radius: &S, centre_distance: &S, crank: &Turn<S>, driver: &S) -> Option<PinMotion<S>> {
    let path = path(crank_radius, centre_distance, &crank.moving::<2>(driver.clone()));
    let follower_speed = angular_velocity(&path)?.value();
    let position = path.map(|coordinate| coordinate.value());
    let pin_velocity = path.map(|coordinate| coordinate.rate());
    Some(PinMotion::carried(position, pin_velocity, follower_speed))
}

/// The vector turned by a quarter, counter-clockwise: the direction of motion of a point that rotates so.
///
/// ```
/// use geneva_kinematics::pin_vectors::quarter_turn;
/// use nalgebra::Vector2;
///
/// assert_eq!(quarter_turn(&Vector2::new(3.0, 1.0)), Vector2::new(-1.0, 3.0));
/// ```
pub fn quarter_turn<S: Field>(vector: &Vector2<S>) -> Vector2<S> {
    Vector2::new(-vector.y.clone(), vector.x.clone())
}
