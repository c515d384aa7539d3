//! A point that moves in a frame that moves, by dual numbers: what the letters of the moving frame stand for.

use super::*;

/// A point that moves at will in a frame that moves at will; its axes are those of the ground at the instant.
pub(super) struct Moving {
    /// Place, velocity and acceleration of the point, of the frame's origin, and of the point as seen in the frame.
    pub whole: [Vector2<f64>; 3],
    pub origin: [Vector2<f64>; 3],
    pub inside: [Vector2<f64>; 3],
    /// The frame's angular velocity and angular acceleration.
    pub speed: f64,
    pub angular_acceleration: f64,
}

/// Where the frame's origin is.
///
/// A function, and [`inside`] too: closures that are handed the same number twice get it changed in between by
/// rustc 1.95 (its issue 155241).
fn origin(t: Time) -> [Time; 2] {
    [t * t * -0.7 + t * 1.1 + 0.3, t * t * 0.9 + t * 0.4 - 0.2]
}

/// Where the point is in the frame, with its distance from the origin so many times as large.
fn inside(t: Time, scale: f64) -> [Time; 2] {
    [t * t * 0.6 - t * 0.5 + 0.8 * scale, t * t * -0.3 + t * 0.7 + 0.5 * scale]
}

/// The point at this many times a distance from the origin.
pub(super) fn moving(scale: f64) -> Moving {
    let (speed, angular_acceleration) = (1.3, 0.9);
    let whole = path(|t| {
        let ([a, b], [x, y]) = (origin(t), turned(inside(t, scale), advance(speed, angular_acceleration, t)));
        [a + x, b + y]
    });
    Moving { whole, origin: path(origin), inside: path(|t| inside(t, scale)), speed, angular_acceleration }
}
