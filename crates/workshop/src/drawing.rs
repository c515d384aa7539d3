//! What lies on which layer of a drawing, and where.

use crate::geometry::Point;
use crate::parts::{Hole, HolePurpose, Layer, Part};
use geneva_kinematics::wheel::{Edge, Loop};

/// Arrangement of the parts on the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartLayout {
    /// In place, as they run: the wheel's axis at the origin, the driver's at (c, 0), in the middle of a dwell.
    Assembled,
    /// Side by side, to be cut out, each once: wheel, locking disc, plate with the holes of its pins, base plate.
    Apart,
}

/// Space between parts that lie side by side, over the width of the first.
const SPACE: f64 = 0.05;
/// Half the length of a mark's arms over the part's greatest radius, in millimetres at least and at most: our choice.
const OF_MARK: f64 = 0.04;
const MARK: [f64; 2] = [0.5, 3.0];

/// Where parts that lie side by side have their axes, along the first axis: the first at the origin. Those in which nothing
/// is cut have none.
pub(crate) fn side_by_side(parts: &[Part]) -> Vec<(&Part, Point)> {
    let mut right: Option<f64> = None;
    let mut space = 0.0;
    let mut places = Vec::new();
    for part in parts.iter().filter(|part| part.is_cut()) {
        let [from, to] = extent(part);
        if right.is_none() {
            space = SPACE * (to - from);
        }
        let at = right.map_or(0.0, |right| right + space - from);
        right = Some(at + to);
        places.push((part, Point::new(at, 0.0)));
    }
    places
}

/// Width over height of a sheet that lies on its side (ISO 216).
const SHEET: f64 = std::f64::consts::SQRT_2;

/// Where parts that are cut from one sheet have their axes: in rows, the first at the origin, so that all together have about the shape
/// of a sheet and need a small one. Those in which nothing is cut have none.
pub(crate) fn in_rows(parts: &[Part]) -> Vec<(&Part, Point)> {
    let cut: Vec<&Part> = parts.iter().filter(|part| part.is_cut()).collect();
    let in_columns = (1..=cut.len()).map(|count| rows_of(&cut, count));
    // The least sheet in which all lie; of equal ones that with the longest rows.
    let found = in_columns.min_by(|one, other| one.1.total_cmp(&other.1));
    cut.into_iter().zip(found.map(|(places, _)| places).unwrap_or_default()).collect()
}

/// The places of parts in rows that are as wide as the first so many are side by side, or the widest is, and the width in millimetres of
/// the sheet that they need.
fn rows_of(parts: &[&Part], count: usize) -> (Vec<Point>, f64) {
    let [across, along] = [0, 1].map(|axis| parts.iter().map(|part| reach(part, axis)).collect::<Vec<_>>());
    let width = |of: &[f64; 2]| of[1] - of[0];
    let space = across.first().map_or(0.0, |first| SPACE * width(first));
    let together = across.iter().take(count).map(|of| width(of) + space).sum::<f64>() - space;
    let row = across.iter().map(width).fold(together, f64::max) * (1.0 + 1e-9);
    let (mut places, mut right, mut top, mut bottom, mut widest) = (Vec::new(), 0.0, 0.0, 0.0_f64, 0.0_f64);
    for (across, along) in across.iter().zip(&along) {
        if right > 0.0 && right + space + width(across) > row {
            (right, top) = (0.0, bottom - space);
        }
        let left = if right > 0.0 { right + space } else { 0.0 };
        places.push(Point::new(left - across[0], top - along[1]));
        right = left + width(across);
        bottom = bottom.min(top - width(along));
        widest = widest.max(right);
    }
    let first = places.first().copied().unwrap_or_default();
    (places.into_iter().map(|at| at - first).collect(), widest.max(-bottom * SHEET))
}

/// How far a part reaches along the first axis, in millimetres.
pub(crate) fn extent(part: &Part) -> [f64; 2] {
    reach(part, 0)
}

/// How far a part reaches along an axis, 0 or 1, in millimetres.
pub(crate) fn reach(part: &Part, axis: usize) -> [f64; 2] {
    let mut reach = [f64::INFINITY, f64::NEG_INFINITY];
    for edge in &part.outer.edges {
        let (from, to) = match *edge {
            Edge::Line { from, to } => (from[axis].min(to[axis]), from[axis].max(to[axis])),
            // No less than the arc reaches.
            Edge::Arc { centre, radius, .. } if centre.norm() <= radius => {
                (centre[axis] - radius, centre[axis] + radius)
            }
            Edge::Arc { .. } => {
                let (a, b) = (edge.start_point()[axis], edge.end_point()[axis]);
                (a.min(b), a.max(b))
            }
        };
        reach = [reach[0].min(from), reach[1].max(to)];
    }
    reach
}

/// The two lines of each mark of a part.
pub(crate) fn marks(part: &Part) -> Vec<Edge> {
    let [from, to] = extent(part);
    let arm = (OF_MARK * (to - from) / 2.0).clamp(MARK[0], MARK[1]);
    let line = |at: Point, by: Point| Edge::Line { from: at - by, to: at + by };
    let both = |at: &Point| [line(*at, Point::new(arm, 0.0)), line(*at, Point::new(0.0, arm))];
    part.marks.iter().flat_map(both).chain(part.engraved.iter().copied()).collect()
}

/// All pieces of the drawing in place, each with its layer.
pub(crate) fn edges(parts: &[Part], layout: PartLayout) -> Vec<(Layer, Edge)> {
    let mut all = Vec::new();
    let mut add = |layer, edges: &[Edge], turn, by| {
        all.extend(edges.iter().map(|edge| (layer, edge.transform(turn, by))));
    };
    match layout {
        PartLayout::Apart => {
            let bush = parts.iter().find(|part| part.is_bush());
            for (part, at) in side_by_side(parts) {
                lines(part, true).iter().for_each(|(layer, edges)| add(*layer, edges, 0.0, at));
                // The pin is as thick as its bush, whatever the hole of its screw.
                let screws = part.holes.iter().filter(|hole| hole.purpose == HolePurpose::PinScrew);
                for (hole, bush) in screws.flat_map(|hole| bush.map(|bush| (hole, bush))) {
                    add(Layer::Pins, &bush.outer.edges, 0.0, at + hole.centre);
                }
            }
        }
        PartLayout::Assembled => {
            let has_pins = parts.iter().any(|part| part.layer == Layer::Pins);
            for part in parts {
                let lines = lines(part, !has_pins);
                for place in &part.places {
                    lines.iter().for_each(|(layer, edges)| add(*layer, edges, place.turn, place.at));
                }
            }
        }
    }
    all
}

/// The lines of a part about its own axis, with or without the holes of pins.
fn lines(part: &Part, with_pins: bool) -> Vec<(Layer, Vec<Edge>)> {
    let of = |layer, of: &Loop| (layer, of.edges.clone());
    let layer = |hole: &Hole| if hole.purpose == HolePurpose::Pin { Layer::Pins } else { part.layer };
    // On the layer of pins each circle is as thick as a pin; the hole of a bush is seen in the plate.
    let is_drawn = move |hole: &&Hole| (with_pins || hole.purpose != HolePurpose::Pin) && !part.is_bush();
    let holes = || part.holes.iter().filter(is_drawn);
    let outer = std::iter::once(of(part.layer, &part.outer));
    let through = holes().map(|hole| of(layer(hole), &hole.outline));
    let pockets = holes().filter_map(|hole| Some(of(Layer::Pockets, &hole.widening.as_ref()?.outline)));
    outer.chain(through).chain(pockets).chain([(Layer::Centres, marks(part))]).collect()
}
