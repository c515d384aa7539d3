//! The outlines of the two links, and where the mechanism lies on the page.

use super::instant::Instant;
use crate::number::trimmed;
use crate::svg::path::{Path, Sense};
use crate::svg::view::{Pixels, View, angle_of, heading};
use geneva_kinematics::Turn;
use geneva_kinematics::quick_return::QuickReturn;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Width of the drawing, in pixels.
pub const WIDTH: f64 = 640.0;
/// The largest that the mechanism may be, in pixels.
const ROOM: (f64, f64) = (500.0, 380.0);
/// Free space above and below the mechanism, in pixels: for the senses and the names.
const MARGIN: f64 = 56.0;
/// How far the lever reaches beyond the pin's farthest point, over that distance.
const REACH: f64 = 1.05;
/// Half the widths of the lever, of its slot and of the crank, in pixels.
pub const LEVER: f64 = 13.0;
pub const SLOT: f64 = 7.0;
pub const CRANK: f64 = 8.0;

/// Where the parts lie on the page.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The mechanism's plane about O4.
    pub view: View,
    /// O4, O2 and the pin.
    pub pivot: Pixels,
    pub axis: Pixels,
    pub pin: Pixels,
    /// Crank radius, in pixels.
    pub crank: f64,
    /// Length of the lever from O4, in pixels.
    pub lever: f64,
    /// Nearest and farthest place of the pin from O4, in pixels.
    pub pin_range: (f64, f64),
    /// +1 if the pin is above the line of centres or on it, −1 below.
    pub side: f64,
    /// Height of the mechanism with its margins.
    pub height: f64,
}

impl Layout {
    /// The mechanism with its circle, its lever and the ends of the swing, as large as there is room, so far below the
    /// upper edge of the page.
    pub fn new(linkage: &QuickReturn, instant: &Instant, top: f64) -> Self {
        let (l, r) = (linkage.ground(), linkage.crank());
        let reach = REACH * (l + r);
        let tip = |angle: f64| {
            let towards = heading(angle);
            Vector2::new(towards.x, -towards.y) * reach
        };
        let mut ends = vec![Vector2::zeros(), Vector2::new(l + r, r), Vector2::new(l - r, -r)];
        ends.push(tip(instant.lever_angle));
        if let Some(limit) = linkage.strokes().swing_limit {
            ends.extend([tip(limit), tip(-limit)]);
        }
        let least = ends.iter().fold(Vector2::zeros(), |a: Vector2<f64>, b| a.inf(b));
        let greatest = ends.iter().fold(Vector2::zeros(), |a: Vector2<f64>, b| a.sup(b));
        let size = greatest - least;
        let scale = (ROOM.0 / size.x).min(ROOM.1 / size.y);
        let middle = (least + greatest) / 2.0 * scale;
        let height = size.y * scale + 2.0 * MARGIN;
        let view = View { origin: Vector2::new(WIDTH / 2.0 - middle.x, top + height / 2.0 + middle.y), scale };
        let pin = view.place(&(instant.along * instant.pin_distance));
        Self {
            view,
            pivot: view.origin,
            axis: view.place(&Vector2::new(l, 0.0)),
            pin,
            crank: r * scale,
            lever: reach * scale,
            pin_range: ((l - r).abs() * scale, (l + r) * scale),
            side: if instant.along.y < -1e-9 { -1.0 } else { 1.0 },
            height,
        }
    }

    /// The tip of the lever at an angle.
    pub fn tip(&self, angle: f64) -> Pixels {
        self.pivot + heading(angle) * self.lever
    }

    /// The slot: its ends are the pin's nearest and farthest place, as far as the pivot leaves room.
    pub fn slot(&self, angle: f64) -> Path {
        let towards = heading(angle);
        let (near, far) = self.pin_range;
        let near = near.max((LEVER + SLOT + 2.0).min(far));
        rounded(&(self.pivot + towards * near), &(self.pivot + towards * far), SLOT)
    }
}

/// The outline of a link with round ends.
pub fn rounded(from: &Pixels, to: &Pixels, half_width: f64) -> Path {
    let along = to - from;
    let angle = if along.norm() > 0.0 { angle_of(&along) } else { 0.0 };
    let aside = heading(angle + FRAC_PI_2) * half_width;
    Path::start(&(from + aside))
        .arc_to(half_width, Sense::CounterClockwise, &(from - aside))
        .line_to(&(to - aside))
        .arc_to(half_width, Sense::CounterClockwise, &(to + aside))
        .close()
}

/// An angle in radians, brought into (−π, π].
pub fn wrapped(angle: f64) -> f64 {
    let turn = Turn::from_radians(angle).radians();
    if turn <= -PI { PI } else { turn }
}

/// A length that was given, as text.
pub fn length(value: f64, unit: &str) -> String {
    format!("{} {unit}", trimmed(value, 6))
}
