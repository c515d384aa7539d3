//! Motion of a pin in a slot by the laws of sines and cosines: the route of a textbook.
//!
//! The triangle has the follower's pivot O, the driver's axis B and the pin P as corners. Notation as in
//! [`pin_slot`](crate::pin_slot); β is the angle of the slot at O, γ the angle between the slot and the pin's velocity.

use crate::Turn;
use crate::pin_slot::{PinSlot, slot_radius_squared};

/// Lengths, angles and speeds at one instant, as the triangle gives them.
///
/// The signs hold for a driver that turns so that θ decreases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleSolution {
    /// Square of the pin's distance from the follower's pivot over that of the crank radius, r² / R², dimensionless.
    pub radius_squared_ratio: f64,
    /// Distance of the pin from the follower's pivot over the crank radius, r / R, dimensionless.
    pub radius_ratio: f64,
    /// Distance of the pin from the follower's pivot, r, in the unit of the mechanism.
    pub slot_radius: f64,
    /// Sine of the slot's angle at the pivot, sin β, by the law of sines, dimensionless.
    pub sine_at_pivot: f64,
    /// Angle of the slot from the line of centres, β, in radians.
    pub angle_at_pivot: f64,
    /// Angle between the slot and the pin's velocity, γ = 90° − β − θ, in radians.
    pub velocity_angle: f64,
    /// Speed of the pin, R ω, in the unit of length times that of the driver's angular speed.
    pub pin_speed: f64,
    /// Speed across the slot of the follower's point under the pin, v sin γ, in the unit of length times that of the
    /// driver's angular speed; positive against the driver's sense.
    pub slot_point_speed: f64,
    /// Speed of the pin along the slot, v cos γ, in the unit of length times that of the driver's angular speed;
    /// positive towards the follower's pivot.
    pub sliding_speed: f64,
    /// Angular speed of the follower, in the unit of the driver's; positive against the driver's sense.
    pub follower_speed: f64,
}

/// Solves the triangle at crank angle θ (`from_line_of_centres`) for a driver of this angular speed, in radians per any
/// unit of time. Lengths are in the unit of the mechanism.
///
/// ```
/// use geneva_kinematics::Turn;
/// use geneva_kinematics::pin_slot::PinSlot;
/// use geneva_kinematics::pin_triangle::solve;
///
/// // 60° from the line of centres the pin of this mechanism moves along the slot.
/// let mechanism = PinSlot::new(0.05, 0.1)?; // m
/// let motion = solve(&mechanism, &Turn::from_degrees(60.0), 10.0); // rad/s
/// assert!((motion.radius_ratio - 3_f64.sqrt()).abs() < 1e-15);
/// assert!((motion.sliding_speed - motion.pin_speed).abs() < 1e-15); // m/s
/// assert!(motion.follower_speed.abs() < 1e-14); // rad/s
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
pub fn solve(mechanism: &PinSlot, from_line_of_centres: &Turn<f64>, driver_speed: f64) -> TriangleSolution {
    let radius_squared_ratio = slot_radius_squared(&mechanism.ratio(), from_line_of_centres);
    let radius_ratio = radius_squared_ratio.sqrt();
    let slot_radius = radius_ratio * mechanism.crank_radius();
    let sine_at_pivot = from_line_of_centres.sin / radius_ratio;
    let angle_at_pivot = libm::asin(sine_at_pivot);
    let velocity_angle = std::f64::consts::FRAC_PI_2 - angle_at_pivot - from_line_of_centres.radians();
    let pin_speed = mechanism.crank_radius() * driver_speed;
    let slot_point_speed = pin_speed * libm::sin(velocity_angle);
    TriangleSolution {
        radius_squared_ratio,
        radius_ratio,
        slot_radius,
        sine_at_pivot,
        angle_at_pivot,
        velocity_angle,
        pin_speed,
        slot_point_speed,
        sliding_speed: pin_speed * libm::cos(velocity_angle),
        follower_speed: slot_point_speed / slot_radius,
    }
}
