//! Walls around the holes: what breaks out, what is thin, and what else can't be mounted.

use super::error::MountingError;
use super::holes::{Hole, HolePurpose};
use super::part::{Layer, Part};
use crate::geometry::{Point, distance, encloses, point_along};
use geneva_kinematics::wheel::{Edge, Loop};
use std::f64::consts::PI;
use std::fmt;

/// A wall beside a hole that is thin: less than half the hole's width, a limit of our choice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinWall {
    /// Which part.
    pub part: &'static str,
    /// Which hole.
    pub hole: &'static str,
    /// What is on the wall's other side.
    pub other: &'static str,
    /// Its thickness, in millimetres.
    pub thickness: f64,
    /// What it should be at least, in millimetres: half of a width.
    pub least: f64,
    /// Which width that is of.
    pub width_of: &'static str,
    /// What to change.
    pub remedy: &'static str,
}

impl fmt::Display for ThinWall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { part, hole, other, thickness, least, width_of, remedy } = self;
        write!(
            f,
            "{part}: only {thickness:.3} mm are left between {hole} and {other}, less than {least:.3} mm, half of the {width_of}'s \
             width: {remedy}"
        )
    }
}

/// The least width of a wall over that of its hole: our choice.
const OF_HOLE: f64 = 0.5;

/// What to change of a hole.
pub(crate) fn remedy(hole: &Hole) -> &'static str {
    match hole.purpose {
        HolePurpose::Bore if is_keyed(hole) => "choose a thinner shaft, or one without keyway",
        HolePurpose::Bore => "choose a thinner shaft",
        HolePurpose::Pin | HolePurpose::PinScrew => "choose a thinner screw for the pin, or one without a nut",
        HolePurpose::Hub => "choose another circle for the hub, fewer or thinner screws or dowels",
        HolePurpose::DiscDowel => "choose another circle for the dowels, fewer or thinner ones",
        HolePurpose::Fixing => "choose thinner screws for the base plate",
        HolePurpose::Inside | HolePurpose::TestSlot => "choose a thinner pin",
    }
}

/// What to change where a bore and the holes of a hub are too near to each other.
const BESIDE_HUB: &str = "choose a larger circle for the hub, thinner screws or dowels, or a thinner shaft";

/// Whether a bore has a keyway: three lines, where one with a flat has one.
fn is_keyed(hole: &Hole) -> bool {
    hole.outline.edges.iter().filter(|edge| matches!(edge, Edge::Line { .. })).count() > 1
}

/// The width of a hole in millimetres, and what is so wide. A keyway has the width of its bottom, and a bore with a flat is measured from
/// the flat to its opposite side.
fn width(hole: &Hole) -> (f64, &'static str) {
    if let Some(diameter) = hole.diameter() {
        return (diameter, "hole");
    }
    let lines = hole.outline.edges.iter().filter_map(|edge| match edge {
        Edge::Line { from, to } => Some((to - from).norm()),
        Edge::Arc { .. } => None,
    });
    let arcs = hole.outline.edges.iter().filter_map(|edge| match edge {
        Edge::Arc { radius, .. } => Some(*radius),
        Edge::Line { .. } => None,
    });
    let (line, radius) = (lines.fold(0.0, f64::max), arcs.fold(0.0, f64::max));
    if is_keyed(hole) {
        return (line, "keyway");
    }
    (radius + (radius * radius - line * line / 4.0).max(0.0).sqrt(), "hole")
}

/// Points on an edge at which a wall is looked for, its end left out.
const POINTS: u32 = 4;

fn points(of: &Loop) -> impl Iterator<Item = Point> {
    let parts = || (0..POINTS).map(|k| f64::from(k) / f64::from(POINTS));
    of.edges.iter().flat_map(move |edge| parts().map(move |part| point_along(edge, part)))
}

/// The circle that a loop is, if it is one.
fn circle(of: &Loop) -> Option<(Point, f64)> {
    match of.edges.as_slice() {
        [Edge::Arc { centre, radius, sweep, .. }] if sweep.abs() >= 2.0 * PI => Some((*centre, *radius)),
        _ => None,
    }
}

/// The edge of a loop that is nearest to a point, and its distance.
fn nearest(of: &Loop, p: Point) -> Option<(&Edge, f64)> {
    of.edges.iter().map(|edge| (edge, distance(edge, p))).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The wall between a hole and another line, which is around it or beside it, and that line's edge; negative where they cross.
///
/// It is exact for a round hole, and between a polygon and a circle around it; else it is seen from points on both.
fn wall<'l>(hole: &Loop, other: &'l Loop, is_around: bool) -> Option<(&'l Edge, f64)> {
    let signed = |p: Point| {
        let (edge, far) = nearest(other, p)?;
        Some((edge, if encloses(other, p) == is_around { far } else { -far }))
    };
    if let Some((centre, radius)) = circle(hole) {
        return signed(centre).map(|(edge, far)| (edge, far - radius));
    }
    if let (Some((centre, radius)), false) = (circle(other), is_around) {
        let (edge, (_, far)) = (other.edges.first()?, nearest(hole, centre)?);
        return Some((edge, if encloses(hole, centre) { -far } else { far } - radius));
    }
    let from_hole = points(hole).filter_map(signed);
    let back = other.edges.iter().flat_map(|edge| {
        let alone = Loop { edges: vec![*edge] };
        let seen: Vec<_> = points(&alone).filter_map(|p| Some((p, nearest(hole, p)?.1))).collect();
        seen.into_iter().map(move |(p, far)| (edge, if encloses(hole, p) { -far } else { far }))
    });
    from_hole.chain(back).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// What an edge of a part's outer line is called.
fn rim(layer: Layer, edge: &Edge) -> &'static str {
    match (layer, edge) {
        (Layer::Wheel, Edge::Line { .. }) => "a slot",
        // The corner of a rounded mouth.
        (Layer::Wheel, Edge::Arc { centre, sweep, .. }) if centre.norm() > 0.0 && *sweep > 0.0 => "a slot",
        (Layer::Wheel, Edge::Arc { centre, radius, .. }) if centre.norm() > *radius => {
            // The end of a slot is nearer to the axis than its mouth; a locking arc is about the driver's axis.
            if edge.start_point().norm() > centre.norm() { "a slot" } else { "a locking arc" }
        }
        (Layer::LockingDisc, Edge::Arc { centre, .. }) if centre.norm() > 0.0 => "a crescent",
        _ => "the rim",
    }
}

/// The least wall between a hole and all else of its part; negative by how much they run into each other.
pub(super) fn least_wall(part: &Part, hole: &Hole) -> Option<(&'static str, f64)> {
    let to_rim = wall(hole.widest(), &part.outer, true).map(|(edge, far)| (rim(part.layer, edge), far));
    let others = part.holes.iter().filter(|other| *other != hole);
    let to_others = others.filter_map(|other| {
        let (_, far) = wall(hole.widest(), other.widest(), false)?;
        Some((other.purpose.words(), far))
    });
    to_rim.into_iter().chain(to_others).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Thin walls of the holes that were chosen for mounting; those of round bores and pins are among the warnings of the sizes.
pub(super) fn thin_walls(part: &Part) -> Result<Vec<ThinWall>, MountingError> {
    let mut thin: Vec<ThinWall> = Vec::new();
    // A ring's own inside is seen from the holes beside it, which were chosen.
    for hole in part.holes.iter().filter(|hole| hole.purpose != HolePurpose::Inside) {
        let Some((other, thickness)) = least_wall(part, hole) else { continue };
        let (name, words) = (part.layer.words(), hole.purpose.words());
        // The circle of a hub is easier to choose than its shaft.
        let pair = [words, other];
        let is_beside_hub = pair.contains(&HolePurpose::Bore.words()) && pair.contains(&HolePurpose::Hub.words());
        let remedy = if is_beside_hub { BESIDE_HUB } else { remedy(hole) };
        if thickness <= 0.0 {
            return Err(MountingError::BreaksOut { part: name, hole: words, other, by: -thickness, remedy });
        }
        let is_plain = hole.diameter().is_some() && hole.widening.is_none();
        let is_of_sizes =
            is_plain && matches!(hole.purpose, HolePurpose::Bore | HolePurpose::Pin | HolePurpose::PinScrew);
        let (width, width_of) = width(hole);
        let least = OF_HOLE * width;
        if thickness < least && !is_of_sizes {
            let wall = ThinWall { part: name, hole: words, other, thickness, least, width_of, remedy };
            // Of walls between the same two kinds of holes the thinnest is told.
            let is_like = |known: &&mut ThinWall| {
                [(known.hole, known.other), (known.other, known.hole)].contains(&(wall.hole, wall.other))
            };
            match thin.iter_mut().find(is_like) {
                Some(known) if known.thickness <= wall.thickness => {}
                Some(known) => *known = wall,
                None => thin.push(wall),
            }
        }
    }
    Ok(thin)
}
