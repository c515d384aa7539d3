//! A line moved away from its material, as the middle of a beam or a cutter runs.
//!
//! Lines stay lines and arcs stay arcs. Around a corner that stands out the path is an arc about it, so that the corner stays
//! sharp; in a hollow corner the neighbours are cut off where they meet.

use crate::geometry::{Point, into_arc};
use geneva_kinematics::wheel::{Edge, Loop};

/// Ends that are nearer than this part of a millimetre are one.
const SAME: f64 = 1e-9;

/// The loop moved by a distance in millimetres to the right of its sense, away from the material; none if a piece of it is too
/// short or too narrow for that.
pub(crate) fn offset(of: &Loop, by: f64) -> Option<Loop> {
    if by == 0.0 {
        return Some(of.clone());
    }
    let mut moved = of.edges.iter().map(|edge| aside(edge, by)).collect::<Option<Vec<Edge>>>()?;
    let count = moved.len();
    if count < 2 {
        return Some(Loop { edges: moved });
    }
    let mut joints = vec![None; count];
    for k in 0..count {
        let next = (k + 1) % count;
        let (one, other) = (moved[k], moved[next]);
        let corner = of.edges[k].end_point();
        let (end, start) = (one.end_point(), other.start_point());
        if (end - start).norm() < SAME {
            continue;
        }
        let (from, to) = (end - corner, start - corner);
        let turn = libm::atan2(from.perp(&to), from.dot(&to));
        if turn > 0.0 {
            joints[k] = Some(Edge::Arc { centre: corner, radius: by, start: libm::atan2(from.y, from.x), sweep: turn });
        } else {
            let meet = meeting(&one, &other, corner)?;
            moved[k] = ending_at(&one, meet)?;
            moved[next] = starting_at(&other, meet)?;
        }
    }
    let edges = moved.into_iter().zip(joints).flat_map(|(edge, joint)| std::iter::once(edge).chain(joint)).collect();
    Some(Loop { edges })
}

/// The line of a hole or a pocket, made wider by a distance in millimetres on all sides, or narrower below zero; none if a piece of it
/// is too narrow for that. Corners that point away from the hole's middle get rounded by as much.
pub(crate) fn widened(hole: &Loop, by: f64) -> Option<Loop> {
    if by < 0.0 { offset(hole, -by) } else { Some(reversed(&offset(&reversed(hole), by)?)) }
}

/// The loop in the other sense.
fn reversed(of: &Loop) -> Loop {
    let back = |edge: &Edge| match *edge {
        Edge::Line { from, to } => Edge::Line { from: to, to: from },
        Edge::Arc { centre, radius, start, sweep } => Edge::Arc { centre, radius, start: start + sweep, sweep: -sweep },
    };
    Loop { edges: of.edges.iter().rev().map(back).collect() }
}

/// An edge moved to its right; none for a hollow arc that is too narrow.
fn aside(edge: &Edge, by: f64) -> Option<Edge> {
    match *edge {
        Edge::Line { from, to } => {
            let along = (to - from).normalize();
            let right = Point::new(along.y, -along.x) * by;
            Some(Edge::Line { from: from + right, to: to + right })
        }
        Edge::Arc { centre, radius, start, sweep } => {
            let radius = if sweep > 0.0 { radius + by } else { radius - by };
            (radius > 0.0).then_some(Edge::Arc { centre, radius, start, sweep })
        }
    }
}

/// Where two edges, lengthened, meet nearest to a corner.
fn meeting(one: &Edge, other: &Edge, corner: Point) -> Option<Point> {
    let on_circle = |from: Point, to: Point, centre: Point, radius: f64| {
        let along = (to - from).normalize();
        let foot = from + along * (centre - from).dot(&along);
        let square = radius * radius - (foot - centre).norm_squared();
        let half = if square < 0.0 { return Vec::new() } else { square.sqrt() };
        vec![foot + along * half, foot - along * half]
    };
    let all = match (*one, *other) {
        (Edge::Line { from: a, to: b }, Edge::Line { from: c, to: d }) => {
            let across = (b - a).perp(&(d - c));
            if across == 0.0 { Vec::new() } else { vec![a + (b - a) * ((c - a).perp(&(d - c)) / across)] }
        }
        (Edge::Line { from, to }, Edge::Arc { centre, radius, .. })
        | (Edge::Arc { centre, radius, .. }, Edge::Line { from, to }) => on_circle(from, to, centre, radius),
        (Edge::Arc { centre: a, radius: r, .. }, Edge::Arc { centre: b, radius: s, .. }) => {
            let (between, far) = (b - a, (b - a).norm());
            if far == 0.0 {
                return None;
            }
            // On the line on which both circles have the same power.
            let along = (far * far + r * r - s * s) / (2.0 * far);
            let foot = a + between * (along / far);
            on_circle(foot, foot + Point::new(-between.y, between.x), a, r)
        }
    };
    all.into_iter().min_by(|p, q| (p - corner).norm().total_cmp(&(q - corner).norm()))
}

fn angle(centre: Point, at: Point) -> f64 {
    libm::atan2(at.y - centre.y, at.x - centre.x)
}

/// The edge up to a point on it; none if the point is not on it.
fn ending_at(edge: &Edge, end: Point) -> Option<Edge> {
    match *edge {
        Edge::Line { from, to } => {
            let is_on = (end - from).dot(&(to - from)) > 0.0;
            is_on.then_some(Edge::Line { from, to: end })
        }
        Edge::Arc { centre, radius, start, sweep } => {
            let length = into_arc(start, sweep, angle(centre, end));
            let is_on = length <= sweep.abs();
            is_on.then_some(Edge::Arc { centre, radius, start, sweep: length.copysign(sweep) })
        }
    }
}

/// The edge from a point on it; none if the point is not on it.
fn starting_at(edge: &Edge, start_point: Point) -> Option<Edge> {
    match *edge {
        Edge::Line { from, to } => {
            let is_on = (to - start_point).dot(&(to - from)) > 0.0;
            is_on.then_some(Edge::Line { from: start_point, to })
        }
        Edge::Arc { centre, radius, start, sweep } => {
            let cut = into_arc(start, sweep, angle(centre, start_point));
            let is_on = cut <= sweep.abs();
            let rest = (sweep.abs() - cut).copysign(sweep);
            is_on.then_some(Edge::Arc { centre, radius, start: start + cut.copysign(sweep), sweep: rest })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{distance, point_along};
    use crate::parts::{Mounting, PinMount, ScrewHole, ShaftFit, Thread, parts};
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    use std::f64::consts::PI;

    #[test]
    fn each_point_of_the_path_is_as_far_from_the_line_as_was_asked_for() {
        let mounting = Mounting {
            wheel_fit: ShaftFit::Key,
            driver_fit: ShaftFit::Flat { across: 4.5 },
            pins: PinMount::Screw(Thread::M4, ScrewHole::NutTrap),
            ..Mounting::default()
        };
        let choices = Choices { wheel_shaft: Some(8.0), driver_shaft: Some(5.0), ..Choices::default() };
        for (stations, pins, by) in [(4, 1, 0.05), (6, 1, 0.1), (6, 2, 0.4), (8, 1, 0.25)] {
            let wheel = Wheel::with_pins(stations, pins).unwrap();
            let sizes = Sizes::new(wheel, Scale::CrankRadius(50.0), &choices).unwrap();
            for part in parts(&sizes, 8.0, &mounting).unwrap().parts {
                let pockets = part.holes.iter().filter_map(|hole| Some(&hole.widening.as_ref()?.outline));
                let face = part.face();
                for line in face.loops().chain(pockets) {
                    let path = offset(line, by).unwrap();
                    for (edge, next) in path.edges.iter().zip(path.edges.iter().cycle().skip(1)) {
                        assert!((edge.end_point() - next.start_point()).norm() < 1e-9, "{edge:?} {next:?}");
                        for k in 0..=20 {
                            let p = point_along(edge, f64::from(k) / 20.0);
                            let far = line.edges.iter().map(|of| distance(of, p)).fold(f64::INFINITY, f64::min);
                            assert!((far - by).abs() < 1e-9, "{:?}: {far}", part.layer);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn outer_lines_grow_and_holes_shrink() {
        let disc = offset(&Loop::circle(Point::zeros(), 10.0, false), 0.1).unwrap();
        assert_eq!(disc, Loop::circle(Point::zeros(), 10.0 + 0.1, false));
        let hole = offset(&Loop::circle(Point::zeros(), 10.0, true), 0.1).unwrap();
        assert_eq!(hole, Loop::circle(Point::zeros(), 10.0 - 0.1, true));
        assert_eq!(offset(&Loop::circle(Point::zeros(), 0.1, true), 0.1), None);
        // A square grows by its sides and quarters of a circle at its corners: area 1 + 4 k + π k².
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)].map(|(x, y)| Point::new(x, y));
        let lines = corners.windows(2).map(|pair| Edge::Line { from: pair[0], to: pair[1] });
        let square = Loop { edges: lines.collect() };
        let area = crate::geometry::area(&offset(&square, 0.1).unwrap());
        approx::assert_relative_eq!(area, 1.0 + 0.4 + PI * 0.01, max_relative = 1e-12);
    }
}
