//! Where the names of curves and points stand: where they hide least.

use super::frame::Frame;
use crate::svg::{Canvas, Label, LabelPosition, Path, Pixels, Placing, Shape, leader, positions_around};
use crate::theme::PAPER;
use nalgebra::Vector2;
use std::ops::Range;

/// How far names may stand from what they name, in pixels.
const NEAR: [f64; 9] = [10.0, 15.0, 21.0, 30.0, 42.0, 56.0, 72.0, 90.0, 112.0];
/// At so many of the points that are given a name is tried.
const TRIED: usize = 8;
/// From line to line of words, and between the names beside a frame, in pixels.
const LINE: f64 = 26.0;
const BESIDE: f64 = 23.0;

/// Where a name may stand.
#[derive(Clone, Debug)]
pub(crate) enum Spot {
    /// Near one of the points that lie in the frame, first in this direction (radians, counter-clockwise as seen).
    Near(Vec<(f64, f64)>, f64),
    /// In the middle of a range of the x axis, at this height: less of it, or beside it, where there is no room.
    Within(Range<f64>, f64),
    /// On a curve, which it interrupts, the nearer to the middle the better; not at all where there is no room.
    On(Vec<(f64, f64)>),
    /// Centred at one of these places, given in shares of the frame from its lower left corner; not at all where there
    /// is no room.
    Free(Vec<[f64; 2]>),
    /// To the right of the frame at this height, as near as the others there allow.
    Beside(f64),
}

/// A name and where it may stand.
#[derive(Clone, Debug)]
pub(super) struct Name {
    pub label: Label,
    pub spot: Spot,
}

/// Writes the names of a panel, each where it hides least of what has been drawn and written before.
///
/// `all` keeps clear of all curves and marks, `off_curves` of all but those that have a name on them.
pub(super) fn write(canvas: &mut Canvas, frame: &Frame, mut all: Placing, mut off_curves: Placing, names: &[Name]) {
    for Name { label, spot } in names {
        match spot {
            Spot::Near(points, first) => {
                let places = frame.inside(points);
                let spots = places.iter().step_by(places.len().div_ceil(TRIED).max(1)).flat_map(|at| {
                    positions_around(at, *first, &NEAR).into_iter().chain(above_and_below(frame, at, label.width()))
                });
                if let Some(place) = all.put(canvas, label, spots.collect::<Vec<_>>()) {
                    // A place aside of all points has nothing to which a line could lead.
                    if places.contains(&place.point) {
                        leader(canvas, &place);
                    }
                    off_curves.take(label.extent(label.width(), &place.point, &place.towards, place.distance));
                }
            }
            Spot::Within(range, y) => within(canvas, frame, label, range, *y),
            Spot::On(points) => on(canvas, &mut off_curves, label, &frame.inside(points)),
            Spot::Free(shares) => free(canvas, frame, [&mut all, &mut off_curves], label, shares),
            Spot::Beside(_) => {}
        }
    }
    beside(canvas, frame, names);
}

/// Above and below a point, and as far to the side as the frame wants it.
fn above_and_below(frame: &Frame, at: &Pixels, width: f64) -> Vec<LabelPosition> {
    let [least, greatest] = frame.corners();
    let half = (width / 2.0 + 10.0).min((greatest.x - least.x) / 2.0);
    let place = |shift: f64, y: f64, distance: f64| {
        let x = (at.x + shift).clamp(least.x + half, greatest.x - half);
        LabelPosition { point: Vector2::new(x, at.y), towards: Vector2::new(0.0, y), distance }
    };
    let shifts = [0.0, -30.0, 30.0, -60.0, 60.0].into_iter();
    let sides = shifts.flat_map(|shift| [(shift, -1.0), (shift, 1.0)]);
    sides.flat_map(|(shift, y)| [20.0, 28.0, 38.0, 50.0].map(|distance| place(shift, y, distance))).collect()
}

fn centred(point: Pixels, cost: f64) -> LabelPosition {
    // Counts as a cost, not as a distance: there is no direction.
    LabelPosition { point, towards: Pixels::zeros(), distance: cost }
}

fn within(canvas: &mut Canvas, frame: &Frame, label: &Label, range: &Range<f64>, y: f64) {
    let [left, right] = [range.start, range.end].map(|x| frame.place(x, y));
    let short = label.first_word();
    if label.width() < right.x - left.x {
        canvas.label(&left.lerp(&right, 0.5), &Pixels::zeros(), 0.0, label);
    } else if short.width() < right.x - left.x {
        canvas.label(&left.lerp(&right, 0.5), &Pixels::zeros(), 0.0, &short);
    } else {
        canvas.label(&right, &Vector2::new(1.0, 0.0), 5.0, &short);
    }
}

fn on(canvas: &mut Canvas, placing: &mut Placing, label: &Label, places: &[Pixels]) {
    let count = places.len();
    let order = (0..count).map(|k| if k % 2 == 0 { count / 2 + k / 2 } else { count / 2 - k.div_ceil(2) });
    let spots = order.filter_map(|k| places.get(k)).enumerate().map(|(rank, point)| centred(*point, rank as f64));
    if !placing.has_room(label, spots.clone()) {
        return;
    }
    if let Some(place) = placing.put(canvas, &label.clone().bare(), spots) {
        // A halo would leave dots of the line between the digits.
        let [least, greatest] = label.extent(label.width(), &place.point, &place.towards, 0.0);
        let [b, d] = [Vector2::new(greatest.x, least.y), Vector2::new(least.x, greatest.y)];
        canvas.draw(Shape::path(Path::through(&[least, b, greatest, d], 1)).fill(PAPER).class("ground"));
    }
}

fn free(canvas: &mut Canvas, frame: &Frame, placings: [&mut Placing; 2], label: &Label, shares: &[[f64; 2]]) {
    let [all, off_curves] = placings;
    let lines = label.lines();
    for share in shares {
        let first = frame.at_share(*share);
        let places = (0..lines.len()).map(|k| [centred(first + Vector2::new(0.0, LINE * k as f64), 0.0)]);
        let places: Vec<_> = places.collect();
        if lines.iter().zip(&places).all(|(line, place)| all.has_room(line, *place)) {
            for (line, place) in lines.iter().zip(places) {
                all.put(canvas, line, place);
                off_curves.put(&mut Canvas::new(0.0, 0.0), line, place);
            }
            return;
        }
    }
}

fn beside(canvas: &mut Canvas, frame: &Frame, names: &[Name]) {
    let [least, greatest] = frame.corners();
    let mut beside: Vec<(f64, &Label)> = names
        .iter()
        .filter_map(|name| match name.spot {
            Spot::Beside(y) => Some((frame.place(frame.x.range.end, y).y, &name.label)),
            _ => None,
        })
        .collect();
    beside.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut heights: Vec<f64> = beside.iter().map(|(y, _)| y.clamp(least.y + 8.0, greatest.y - 8.0)).collect();
    for _ in 0..400 {
        for k in 1..heights.len() {
            let close = BESIDE - (heights[k] - heights[k - 1]);
            if close > 0.0 {
                heights[k - 1] -= close / 2.0;
                heights[k] += close / 2.0;
            }
        }
        if let Some(first) = heights.first_mut() {
            *first = first.max(least.y);
        }
        if let Some(last) = heights.last_mut() {
            *last = last.min(greatest.y - 8.0);
        }
    }
    for ((y, label), height) in beside.into_iter().zip(heights) {
        let [from, to] = [Vector2::new(greatest.x + 2.0, y), Vector2::new(greatest.x + 13.0, height)];
        canvas.draw(Shape::line(&from, &to).stroke(label.colour(), 1.0).class("leader"));
        canvas.label(&to, &Vector2::new(1.0, 0.0), 3.0, &label.clone().bare());
    }
}
