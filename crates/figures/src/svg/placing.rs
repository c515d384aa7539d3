//! Where a label has room: of several places the one that hides least.

use super::canvas::Canvas;
use super::label::{Label, LabelPosition};
use super::shape::Shape;
use super::view::{Pixels, clip, heading};
use crate::theme::INK;
use std::f64::consts::PI;

/// Cost of a pixel of distance, of a pixel outside the bounds, of touching another label, and of a label that lies all
/// on other grounds than most of it.
const DISTANCE: f64 = 0.12;
const OUTSIDE: f64 = 100.0;
const TOUCHING: f64 = 2000.0;
const ASTRAY: f64 = 60.0;
/// A label farther from what it names than this has a line that leads to it, in pixels.
const LEADER: f64 = 24.0;
/// A place of no higher cost hides hardly anything.
const ROOMY: f64 = 14.0;
/// Free space about a label, in pixels.
const AIR: f64 = 3.0;

/// An area in plain numbers: its least and its greatest x, its least and its greatest y.
type Bounds = [[f64; 2]; 2];

fn area([least, greatest]: &[Pixels; 2], air: f64) -> Bounds {
    [[least.x - air, greatest.x + air], [least.y - air, greatest.y + air]]
}

/// A line in plain numbers, in x and in y by its start and its step, and what a pixel of it costs.
#[derive(Clone, Copy, Debug)]
struct Line {
    course: [[f64; 2]; 2],
    length: f64,
    weight: f64,
}

impl Line {
    fn new(from: &Pixels, to: &Pixels, weight: f64) -> Self {
        let along = to - from;
        Self { course: [[from.x, along.x], [from.y, along.y]], length: along.norm(), weight }
    }

    /// How much of it lies within an area.
    fn length_within(&self, area: Bounds) -> f64 {
        clip(self.course, area).map_or(0.0, |[enter, leave]| (leave - enter) * self.length)
    }
}

/// What labels must keep clear of within a part of the page.
#[derive(Clone, Debug)]
pub(crate) struct Placing {
    bounds: [Pixels; 2],
    taken: Vec<Bounds>,
    lines: Vec<Line>,
    spent: f64,
}

impl Placing {
    /// An empty part of the page, between its least and its greatest corner.
    pub(crate) fn new(least: Pixels, greatest: Pixels) -> Self {
        Self { bounds: [least, greatest], taken: Vec::new(), lines: Vec::new(), spent: 0.0 }
    }

    /// Keeps labels off a line; a pixel of it under a label costs `weight`.
    pub(crate) fn avoid(&mut self, from: &Pixels, to: &Pixels, weight: f64) {
        self.lines.push(Line::new(from, to, weight));
    }

    /// Keeps labels off a line through several points.
    pub(crate) fn avoid_all(&mut self, points: &[Pixels], weight: f64) {
        for pair in points.windows(2) {
            if let [from, to] = pair {
                self.avoid(from, to, weight);
            }
        }
    }

    /// Keeps labels off an arc about a centre, from one angle to another.
    pub(crate) fn avoid_arc(&mut self, centre: &Pixels, radius: f64, from: f64, to: f64, weight: f64) {
        let steps = (8.0 * (to - from).abs()) as u32 + 2;
        let at = |k: u32| centre + heading(from + (to - from) * f64::from(k) / f64::from(steps)) * radius;
        self.avoid_all(&(0..=steps).map(at).collect::<Vec<_>>(), weight);
    }

    /// Keeps labels off an area, given by its least and its greatest corner.
    pub(crate) fn take(&mut self, corners: [Pixels; 2]) {
        self.taken.push(area(&corners, 0.0));
    }

    /// Writes the label at the place where it hides least, the earlier of equals, and keeps later ones off it.
    pub(crate) fn put(
        &mut self,
        canvas: &mut Canvas,
        label: &Label,
        places: impl IntoIterator<Item = LabelPosition>,
    ) -> Option<LabelPosition> {
        let (cost, place) = self.best(label, places, |extent| ASTRAY * canvas.overhang(extent))?;
        self.spent += cost;
        self.take(label.extent(label.width(), &place.point, &place.towards, place.distance));
        canvas.label(&place.point, &place.towards, place.distance, label);
        Some(place)
    }

    /// What all labels so far have cost: the less, the more readable.
    pub(crate) fn spent(&self) -> f64 {
        self.spent
    }

    /// Whether the label has a place that hides hardly anything.
    pub(crate) fn has_room(&self, label: &Label, places: impl IntoIterator<Item = LabelPosition>) -> bool {
        self.best(label, places, |_| 0.0).is_some_and(|(cost, _)| cost < ROOMY)
    }

    /// The place of the least cost, to which `more` adds for what the label would stand on.
    fn best(
        &self,
        label: &Label,
        places: impl IntoIterator<Item = LabelPosition>,
        more: impl Fn(&[Pixels; 2]) -> f64,
    ) -> Option<(f64, LabelPosition)> {
        let mut best: Option<(f64, LabelPosition)> = None;
        let width = label.width();
        for place in places {
            let extent = label.extent(width, &place.point, &place.towards, place.distance);
            let cost = self.cost(&extent) + DISTANCE * place.distance;
            let is_less = |cost: f64| best.is_none_or(|(least, _)| cost < least - 1e-6);
            if is_less(cost) {
                let cost = cost + more(&extent);
                if is_less(cost) {
                    best = Some((cost, place));
                }
            }
        }
        best
    }

    fn cost(&self, corners: &[Pixels; 2]) -> f64 {
        let [least, greatest] = corners;
        let beyond = (self.bounds[0] - least).sup(&(greatest - self.bounds[1])).sup(&Pixels::zeros());
        let own = area(corners, AIR);
        let common = |[a, b]: [f64; 2], [c, d]: [f64; 2]| b.min(d) - a.max(c);
        let touched = self.taken.iter().map(|other| {
            let (x, y) = (common(own[0], other[0]), common(own[1], other[1]));
            if x > 0.0 && y > 0.0 { TOUCHING + x * y } else { 0.0 }
        });
        let hidden = self.lines.iter().map(|line| line.weight * line.length_within(own));
        OUTSIDE * (beyond.x + beyond.y) + touched.sum::<f64>() + hidden.sum::<f64>()
    }
}

/// Places on both sides of a line, its middle first, at each of the distances.
pub(crate) fn positions_beside_line(from: &Pixels, to: &Pixels, distances: &[f64]) -> Vec<LabelPosition> {
    let along = to - from;
    let across = Pixels::new(-along.y, along.x);
    let shares = [0.5, 0.38, 0.62, 0.25, 0.75];
    let places = |share: f64| {
        let point = from.lerp(to, share);
        [across, -across].into_iter().flat_map(move |towards| {
            distances.iter().map(move |distance| LabelPosition { point, towards, distance: *distance })
        })
    };
    shares.into_iter().flat_map(places).collect()
}

/// Places all around a point, beginning at an angle, at each of the distances.
pub(crate) fn positions_around(point: &Pixels, first: f64, distances: &[f64]) -> Vec<LabelPosition> {
    let turns = (0..16).map(|k| if k % 2 == 0 { k / 2 } else { -(k + 1) / 2 });
    let places = |turn: i32| {
        let towards = heading(first + f64::from(turn) * PI / 8.0);
        distances.iter().map(move |distance| LabelPosition { point: *point, towards, distance: *distance })
    };
    turns.flat_map(places).collect()
}

/// A thin line to a label that stands far from what it names.
pub(crate) fn leader(canvas: &mut Canvas, place: &LabelPosition) {
    let LabelPosition { point, towards, distance } = place;
    if let (true, Some(direction)) = (*distance > LEADER, towards.try_normalize(1e-12)) {
        let (from, to) = (point + direction * 4.0, point + direction * (distance - 3.0));
        canvas.draw(Shape::line(&from, &to).stroke(INK, 1.0).attribute("stroke-opacity", "0.5").class("leader"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_lies_within_counts() {
        let area = [[0.0, 4.0], [0.0, 2.0]];
        let length = |a: [f64; 2], b: [f64; 2]| Line::new(&a.into(), &b.into(), 1.0).length_within(area);
        approx::assert_relative_eq!(length([-1.0, 1.0], [9.0, 1.0]), 4.0, max_relative = 1e-12);
        approx::assert_relative_eq!(length([1.0, -5.0], [1.0, 1.0]), 1.0, max_relative = 1e-12);
        assert_eq!(length([-1.0, 3.0], [9.0, 3.0]), 0.0);
        assert_eq!(length([1.0, 1.0], [1.0, 1.0]), 0.0);
    }

    #[test]
    fn a_label_keeps_to_one_ground() {
        let mut canvas = Canvas::new(300.0, 200.0);
        let disc = Pixels::new(100.0, 100.0);
        canvas.draw(Shape::circle(&disc, 60.0).tint(INK, 0.2));
        let mut placing = Placing::new(Pixels::zeros(), Pixels::new(300.0, 200.0));
        // From a point within, the nearest place is across the edge, and the next one beyond it.
        let place = |distance| LabelPosition { point: disc, towards: Pixels::new(1.0, 0.0), distance };
        let put = placing.put(&mut canvas, &Label::words("name"), [30.0, 66.0].map(place)).expect("a place");
        assert_eq!(put.distance, 66.0);
    }

    #[test]
    fn a_label_keeps_off_lines_and_other_labels() {
        let mut placing = Placing::new(Pixels::new(0.0, 0.0), Pixels::new(200.0, 200.0));
        let (from, to) = (Pixels::new(0.0, 100.0), Pixels::new(200.0, 100.0));
        placing.avoid(&from, &to, 1.0);
        let mut canvas = Canvas::new(200.0, 200.0);
        let places = || positions_beside_line(&from, &to, &[14.0]);
        let first = placing.put(&mut canvas, &Label::words("first"), places()).expect("a place");
        let second = placing.put(&mut canvas, &Label::words("second"), places()).expect("a place");
        assert!(first.towards.y > 0.0 && second.towards.y < 0.0);
        assert!(placing.put(&mut canvas, &Label::words("nowhere"), []).is_none());
    }
}
