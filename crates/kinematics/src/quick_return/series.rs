//! Motion of the lever by differentiating the loop closure twice: no vector diagram, no relative velocity.
//!
//! Around the loop, l + R e(φ) = r e(ψ) with e a unit vector in that direction. The left side is known as a power
//! series in time; so is the polar angle's rate of the right side, and r² = |l + R e(φ)|². In polar coordinates the
//! acceleration is (r̈ − r ψ̇²) e(ψ) + (r ψ̈ + 2 ṙ ψ̇) e(ψ + 90°), and that is where the four terms come from.

use super::motion::Drive;
use crate::pin_vectors::path;
use crate::{Field, Turn, angular_velocity};
use nalgebra::Vector2;

/// Rates of the lever's polar coordinates at an instant. All are rational; lengths are divided by r, which has a root.
#[derive(Clone, Debug, PartialEq)]
pub struct PolarRates<S> {
    /// From the lever's pivot to the pin, in the unit of the ground distance: r e(ψ).
    pub position: Vector2<S>,
    /// Angular velocity of the lever, ψ̇, in the unit of the crank's speed, counter-clockwise positive.
    pub angular_velocity: S,
    /// Angular acceleration of the lever, ψ̈, in the unit of the crank's acceleration, counter-clockwise positive.
    pub angular_acceleration: S,
    /// Sliding speed of the pin over its distance, ṙ / r, in the unit of the crank's speed, outwards positive.
    pub sliding: S,
    /// Rate of the sliding speed over the pin's distance, r̈ / r, in the unit of the crank's acceleration.
    pub sliding_rate: S,
}

/// Rates of the lever by differentiating the loop closure at crank angle φ, for ground distance l and crank radius R in
/// one unit of length. `None` if the pin is on the lever's pivot.
///
/// ```
/// use geneva_kinematics::quick_return::Drive;
/// use geneva_kinematics::quick_return::series::polar_rates;
/// use geneva_kinematics::{Turn, rational};
///
/// // Axes 2 apart and a crank of 1 at 90°: r² = 5 + 4 cos φ, so r ṙ = −2 and r r̈ + ṙ² = 0, with r² = 5.
/// let across = Turn { cos: rational(0, 1), sin: rational(1, 1) };
/// let drive = Drive::steady(rational(1, 1));
/// let rates = polar_rates(&rational(2, 1), &rational(1, 1), &across, &drive).expect("off the pivot");
/// assert_eq!(rates.sliding, rational(-2, 5)); // ṙ / r
/// assert_eq!(rates.sliding_rate, rational(-4, 25)); // r̈ / r
/// assert_eq!(rates.angular_velocity, rational(1, 5)); // the pin moves at 1 along the line of centres, 1 beside the pivot
/// ```
pub fn polar_rates<S: Field>(ground: &S, radius: &S, crank: &Turn<S>, drive: &Drive<S>) -> Option<PolarRates<S>> {
    let path = path(radius, ground, &crank.speeding_up(drive.speed.clone(), drive.acceleration.clone()));
    let turned = angular_velocity(&path)?;
    // From r² = s: ṙ/r = ṡ / 2s, and r̈/r = (s̈/2 − ṙ²) / s = s̈ / 2s − (ṙ/r)².
    let square = path.x.clone() * path.x.clone() + path.y.clone() * path.y.clone();
    let twice = S::integer(2) * square.value();
    let sliding = square.rate() / twice.clone();
    let second = S::integer(2) * square.coefficient(2);
    let sliding_rate = second / twice - sliding.clone() * sliding.clone();
    Some(PolarRates {
        position: path.map(|coordinate| coordinate.value()),
        angular_velocity: turned.value(),
        angular_acceleration: turned.rate(),
        sliding,
        sliding_rate,
    })
}
