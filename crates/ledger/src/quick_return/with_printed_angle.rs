//! What would follow, had the angle that is printed with the velocities been right.

use super::*;

/// What the source would have found, had the angle printed with the velocities been that between crank and lever.
///
/// The speed of the pin and the length of the lever stay as they are. Not a motion that exists: the triangle of
/// ground, crank and lever does not close with this angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithPrintedAngle {
    /// Speed of the lever's point, in m/s.
    pub lever_point_speed: f64,
    /// Sliding speed, in m/s.
    pub sliding_speed: f64,
    /// Angular velocity of the lever, in rad/s.
    pub lever_speed: f64,
    /// Centripetal acceleration of the lever's point, in m/s².
    pub lever_normal: f64,
    /// Coriolis acceleration, in m/s².
    pub coriolis: f64,
    /// Sliding acceleration towards the pivot, in m/s².
    pub sliding_acceleration: f64,
    /// Tangential acceleration of the lever's point, clockwise, in m/s².
    pub lever_tangential: f64,
    /// Angular acceleration of the lever, clockwise, in rad/s².
    pub lever_acceleration: f64,
}

/// The same computation with the printed angle throughout, unrounded.
pub fn with_printed_angle() -> WithPrintedAngle {
    let angle = Turn::from_degrees(printed("quick-return.crank-angle"));
    let length = position_of(|position| position.pin_distance);
    let (speed, normal) =
        (diagram(|motion| motion.velocities.pin_velocity.norm()), diagram(|motion| motion.pin_normal.norm()));
    let [lever_point_speed, sliding_speed] = [speed * angle.cos, speed * angle.sin];
    let lever_speed = lever_point_speed / length;
    let lever_normal = lever_speed * lever_point_speed;
    let coriolis = 2.0 * lever_speed * sliding_speed;
    let lever_tangential = normal * angle.sin - coriolis;
    WithPrintedAngle {
        lever_point_speed,
        sliding_speed,
        lever_speed,
        lever_normal,
        coriolis,
        sliding_acceleration: normal * angle.cos - lever_normal,
        lever_tangential,
        lever_acceleration: lever_tangential / length,
    }
}
