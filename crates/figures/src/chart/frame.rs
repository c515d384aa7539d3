//! Where data lie on the page: the frame of a panel, with the scales of its axes.

use super::axis::ChartAxis;
use crate::svg::{Pixels, part_within};
use nalgebra::Vector2;

/// Where data lie on the page.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    corners: [Pixels; 2],
    /// The x axis.
    pub x: ChartAxis,
    left: ChartAxis,
}

impl Frame {
    /// The frame between two corners, the upper left and the lower right, with an x axis and the y axis at its left.
    pub(super) fn new(corners: [Pixels; 2], x: &ChartAxis, left: &ChartAxis) -> Self {
        Self { corners, x: x.clone(), left: left.clone() }
    }

    /// The upper left and the lower right corner.
    pub(super) fn corners(&self) -> [Pixels; 2] {
        self.corners
    }

    /// Where values of the x axis and of the y axis meet.
    pub(super) fn place(&self, x: f64, y: f64) -> Pixels {
        self.at_share([self.x.share(x), self.left.share(y)])
    }

    /// A place in shares of the frame, from its lower left corner.
    pub(super) fn at_share(&self, [x, y]: [f64; 2]) -> Pixels {
        let [least, greatest] = self.corners;
        Vector2::new(least.x + x * (greatest.x - least.x), greatest.y + y * (least.y - greatest.y))
    }

    /// The places of points, as far as they lie within.
    pub(super) fn inside(&self, points: &[(f64, f64)]) -> Vec<Pixels> {
        points.iter().map(|(x, y)| self.place(*x, *y)).filter(|at| self.contains(at)).collect()
    }

    /// Whether a place is within, or on the edge.
    pub(super) fn contains(&self, at: &Pixels) -> bool {
        let [least, greatest] = self.corners;
        let slack = Vector2::new(1e-6, 1e-6);
        at.sup(&(least - slack)) == *at && at.inf(&(greatest + slack)) == *at
    }

    /// The parts of a curve that lie within: plotters would draw the rest along the edge.
    pub(super) fn parts(&self, points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
        let mut parts: Vec<Vec<(f64, f64)>> = Vec::new();
        let mut goes_on = false;
        for pair in points.windows(2) {
            let [from, to] = [pair[0], pair[1]].map(|(x, y)| self.place(x, y));
            let Some([enter, leave]) = part_within(&from, &to, &self.corners) else {
                goes_on = false;
                continue;
            };
            let end = if leave < 1.0 { self.data(&from.lerp(&to, leave)) } else { pair[1] };
            match parts.last_mut() {
                Some(part) if goes_on => part.push(end),
                _ => parts.push(vec![if enter > 0.0 { self.data(&from.lerp(&to, enter)) } else { pair[0] }, end]),
            }
            goes_on = leave >= 1.0;
        }
        parts
    }

    /// The values at a place.
    fn data(&self, at: &Pixels) -> (f64, f64) {
        let [least, greatest] = self.corners;
        let x = self.x.value_at((at.x - least.x) / (greatest.x - least.x));
        (x, self.left.value_at((greatest.y - at.y) / (greatest.y - least.y)))
    }
}
