//! From the plane of the mechanism to the page.

use geneva_kinematics::Turn;
use nalgebra::Vector2;

/// A point or an offset of the page, in pixels of the view box, y downwards.
pub type Pixels = Vector2<f64>;

/// A scale and a place: the mechanism's plane (y upwards) on the page.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Where the plane's origin lies.
    pub origin: Pixels,
    /// Pixels per unit.
    pub scale: f64,
}

impl View {
    /// Where a point of the plane lies on the page.
    pub fn place(&self, point: &Vector2<f64>) -> Pixels {
        self.origin + Vector2::new(point.x, -point.y) * self.scale
    }
}

/// Unit vector of the page at an angle (radians, counter-clockwise as seen).
pub fn heading(angle: f64) -> Pixels {
    let turn = Turn::from_radians(angle);
    Vector2::new(turn.cos, -turn.sin)
}

/// The angle (radians, counter-clockwise as seen) of an offset of the page.
pub fn angle_of(offset: &Pixels) -> f64 {
    libm::atan2(-offset.y, offset.x)
}
