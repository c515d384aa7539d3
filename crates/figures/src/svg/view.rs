//! From the plane of the mechanism to the page.

use geneva_kinematics::Turn;
use nalgebra::Vector2;

/// A point or an offset of the page, in pixels of the view box, y downwards.
pub(crate) type Pixels = Vector2<f64>;

/// A scale and a place: the mechanism's plane (y upwards) on the page.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// Where the plane's origin lies.
    pub origin: Pixels,
    /// Pixels per unit.
    pub scale: f64,
}

impl View {
    /// Points of the plane as large as they have room, in pixels each way, with their middle at a place of the page.
    ///
    /// Points that all lie in one place have a scale of one.
    pub(crate) fn fitting(points: impl IntoIterator<Item = Vector2<f64>>, room: Pixels, middle: Pixels) -> Self {
        let bounds = |(a, b): (Vector2<f64>, Vector2<f64>), point: Vector2<f64>| (a.inf(&point), b.sup(&point));
        let (least, greatest) = points.into_iter().fold((Vector2::zeros(), Vector2::zeros()), bounds);
        let size = greatest - least;
        let fit = |room: f64, size: f64| if size > 0.0 { room / size } else { f64::INFINITY };
        let scale = fit(room.x, size.x).min(fit(room.y, size.y));
        let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        let centre = (least + greatest) / 2.0 * scale;
        Self { origin: middle + Vector2::new(-centre.x, centre.y), scale }
    }

    /// Where a point of the plane lies on the page.
    pub(crate) fn place(&self, point: &Vector2<f64>) -> Pixels {
        self.origin + Vector2::new(point.x, -point.y) * self.scale
    }
}

/// Unit vector of the page at an angle (radians, counter-clockwise as seen).
pub(crate) fn heading(angle: f64) -> Pixels {
    let turn = Turn::from_radians(angle);
    Vector2::new(turn.cos, -turn.sin)
}

/// The angle (radians, counter-clockwise as seen) of an offset of the page.
pub(crate) fn angle_of(offset: &Pixels) -> f64 {
    libm::atan2(-offset.y, offset.x)
}

/// Which part of a line lies within an area, given by its least and its greatest corner: from which share of the way
/// to which.
pub(crate) fn part_within(from: &Pixels, to: &Pixels, [least, greatest]: &[Pixels; 2]) -> Option<[f64; 2]> {
    let ((x, y), along) = ((from.x, from.y), to - from);
    clip([[x, along.x], [y, along.y]], [[least.x, greatest.x], [least.y, greatest.y]])
}

/// Which part of a line lies within an area, as shares of the way: line and area in x and in y, the line by its start and
/// its step, the area by its least and its greatest.
///
/// Plain numbers: every place of every label asks for every line, also where vectors are not optimised.
pub(super) fn clip(line: [[f64; 2]; 2], area: [[f64; 2]; 2]) -> Option<[f64; 2]> {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for ([start, step], [least, greatest]) in [(line[0], area[0]), (line[1], area[1])] {
        if step.abs() < 1e-9 {
            if start < least || start > greatest {
                return None;
            }
            continue;
        }
        let (a, b) = ((least - start) / step, (greatest - start) / step);
        let (first, last) = if a < b { (a, b) } else { (b, a) };
        if first > enter {
            enter = first;
        }
        if last < leave {
            leave = last;
        }
        if enter > leave {
            return None;
        }
    }
    Some([enter, leave])
}
