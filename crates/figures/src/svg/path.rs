//! Path data: lines and true arcs.

use super::view::{Pixels, angle_of, heading};
use crate::number::format_trimmed;
use std::f64::consts::TAU;

/// Along an arc, a point at least every so many radians.
const STEP: f64 = 0.1;

/// Which way round, as seen on the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sense {
    /// Against the hands of a clock.
    CounterClockwise,
    /// With the hands of a clock.
    Clockwise,
}

impl Sense {
    /// Counter-clockwise for a positive rate, as angles are counted.
    pub(crate) fn from_rate(rate: f64) -> Self {
        if rate < 0.0 { Self::Clockwise } else { Self::CounterClockwise }
    }

    /// +1 counter-clockwise, −1 clockwise.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::CounterClockwise => 1.0,
            Self::Clockwise => -1.0,
        }
    }
}

/// The `d` attribute of a path, written as it goes.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    data: String,
    decimals: usize,
    loops: Vec<Vec<Pixels>>,
}

impl Path {
    /// Begins at a point.
    pub(crate) fn start(at: &Pixels) -> Self {
        Self::start_rounded(at, 2)
    }

    /// Begins at a point; all coordinates are written to so many decimals.
    pub(crate) fn start_rounded(at: &Pixels, decimals: usize) -> Self {
        Self::empty(decimals).again_at(at)
    }

    /// A path without a beginning, of which all coordinates are written to so many decimals.
    pub(crate) fn empty(decimals: usize) -> Self {
        Self { data: String::new(), decimals, loops: Vec::new() }
    }

    /// Whether nothing has been drawn.
    pub(crate) fn is_empty(&self) -> bool {
        self.data.is_empty()
    }

    /// An outline through points, returning to the first.
    pub(crate) fn through(points: &[Pixels], decimals: usize) -> Self {
        Self::along(points, decimals).close()
    }

    /// A line through points, from the first to the last.
    pub(crate) fn along(points: &[Pixels], decimals: usize) -> Self {
        let next = |path: Self, point: &Pixels| {
            if path.is_empty() { path.again_at(point) } else { path.line_to(point) }
        };
        points.iter().fold(Self::empty(decimals), next)
    }

    /// Goes straight on to a point.
    pub(crate) fn line_to(mut self, to: &Pixels) -> Self {
        self.data += &format!(" L{}", pair(to, self.decimals));
        self.reaches(*to)
    }

    /// Begins again at another point: a further part of the same path.
    pub(crate) fn again_at(mut self, at: &Pixels) -> Self {
        self.data += &format!("M{}", pair(at, self.decimals));
        self.loops.push(vec![*at]);
        self
    }

    /// Goes straight on by an offset.
    pub(crate) fn line_by(mut self, offset: &Pixels) -> Self {
        self.data += &format!("l{}", pair(offset, self.decimals));
        let to = self.end() + offset;
        self.reaches(to)
    }

    /// Goes on by nothing: a point, which shows if the line has round or square ends.
    pub(crate) fn dot(mut self) -> Self {
        self.data += "h0";
        self
    }

    /// Goes to a point along a circle of this radius, by no more than half of it.
    pub(crate) fn arc_to(self, radius: f64, sense: Sense, to: &Pixels) -> Self {
        self.arc(radius, false, sense, to)
    }

    /// Goes to a point along a circle of this radius, by more than half of it if `large`.
    pub(crate) fn arc(mut self, radius: f64, large: bool, sense: Sense, to: &Pixels) -> Self {
        let (r, sweep) = (format_trimmed(radius, self.decimals), u8::from(sense == Sense::Clockwise));
        self.data += &format!(" A{r} {r} 0 {} {sweep} {}", u8::from(large), pair(to, self.decimals));
        let from = self.end();
        if let Some(part) = self.loops.last_mut() {
            part.extend(along_arc(&from, to, radius, large, sense));
        }
        self.reaches(*to)
    }

    /// Returns to the start.
    pub(crate) fn close(mut self) -> Self {
        self.data += " Z";
        self
    }

    /// The finished data.
    pub(crate) fn data(&self) -> &str {
        &self.data
    }

    /// The outlines of its parts: their corners, with points along the arcs.
    pub(crate) fn loops(self) -> Vec<Vec<Pixels>> {
        self.loops
    }

    fn end(&self) -> Pixels {
        self.loops.last().and_then(|part| part.last()).copied().unwrap_or_default()
    }

    fn reaches(mut self, to: Pixels) -> Self {
        if let Some(part) = self.loops.last_mut() {
            part.push(to);
        }
        self
    }
}

fn pair(point: &Pixels, decimals: usize) -> String {
    format!("{} {}", format_trimmed(point.x, decimals), format_trimmed(point.y, decimals))
}

/// Points along an arc between its ends, in the manner of path data: by more than half of the circle if `large`.
fn along_arc(from: &Pixels, to: &Pixels, radius: f64, large: bool, sense: Sense) -> Vec<Pixels> {
    let chord = to - from;
    let Some(across) = Pixels::new(-chord.y, chord.x).try_normalize(1e-9) else { return Vec::new() };
    let height = (radius * radius - chord.norm_squared() / 4.0).max(0.0).sqrt();
    let side = if large == (sense == Sense::Clockwise) { -1.0 } else { 1.0 };
    let centre = (from + to) / 2.0 + across * height * side;
    let start = angle_of(&(from - centre));
    let turn = (sense.sign() * (angle_of(&(to - centre)) - start)).rem_euclid(TAU);
    let count = (turn / STEP) as u32 + 1;
    let at = |k: u32| centre + heading(start + sense.sign() * turn * f64::from(k) / f64::from(count)) * radius;
    (1..count).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_bulges_to_the_side_that_path_data_says() {
        let ends = [Pixels::new(0.0, 0.0), Pixels::new(20.0, 0.0)];
        for (large, sense, highest, lowest) in
            [(false, Sense::Clockwise, -10.0, 0.0), (false, Sense::CounterClockwise, 0.0, 10.0)]
        {
            let points = along_arc(&ends[0], &ends[1], 10.0, large, sense);
            let heights: Vec<f64> = points.iter().map(|at| at.y).collect();
            let (least, most) =
                (heights.iter().copied().fold(0.0, f64::min), heights.iter().copied().fold(0.0, f64::max));
            assert!((least - highest).abs() < 0.1 && (most - lowest).abs() < 0.1, "{least} to {most}");
        }
        // By more than half of a circle of radius 12.5, whose centre is 7.5 from the chord: as far as 20 from it.
        let far = along_arc(&ends[0], &ends[1], 12.5, true, Sense::Clockwise);
        assert!((far.iter().map(|at| at.y).fold(0.0, f64::min) + 20.0).abs() < 0.1, "{far:?}");
        assert!(along_arc(&ends[0], &ends[0], 10.0, false, Sense::Clockwise).is_empty());
    }
}
