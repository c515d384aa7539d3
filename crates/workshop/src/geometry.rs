//! Distances from edges, and what a loop encloses: exact but for rounding.

use geneva_kinematics::wheel::{Edge, Loop};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

pub(crate) type Point = Vector2<f64>;

/// The unit vector at an angle in radians.
pub(crate) fn direction(angle: f64) -> Point {
    let (sine, cosine) = libm::sincos(angle);
    Point::new(cosine, sine)
}

/// A point turned about the origin by an angle in radians.
pub(crate) fn turned(p: Point, angle: f64) -> Point {
    let along = direction(angle);
    Point::new(along.x * p.x - along.y * p.y, along.y * p.x + along.x * p.y)
}

/// The point a part of the way along an edge.
pub(crate) fn point_along(edge: &Edge, part: f64) -> Point {
    match *edge {
        Edge::Line { from, to } => from + (to - from) * part,
        Edge::Arc { centre, radius, start, sweep } => centre + direction(start + sweep * part) * radius,
    }
}

/// The angle in radians from the start of an arc to this direction, in the arc's sense, from 0 to a whole turn.
pub(crate) fn into_arc(start: f64, sweep: f64, to: f64) -> f64 {
    let turn = if sweep < 0.0 { start - to } else { to - start };
    turn - 2.0 * PI * libm::floor(turn / (2.0 * PI))
}

/// Distance of a point from an edge, in millimetres.
pub(crate) fn distance(edge: &Edge, p: Point) -> f64 {
    match *edge {
        Edge::Line { from, to } => {
            let along = to - from;
            let part = ((p - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (from + along * part - p).norm()
        }
        Edge::Arc { centre, radius, start, sweep } => {
            let from_centre = p - centre;
            let angle = libm::atan2(from_centre.y, from_centre.x);
            if from_centre.norm_squared() == 0.0 || into_arc(start, sweep, angle) <= sweep.abs() {
                return (from_centre.norm() - radius).abs();
            }
            (edge.start_point() - p).norm().min((edge.end_point() - p).norm())
        }
    }
}

/// The least distance between two edges that don't cross, in millimetres.
pub(crate) fn gap(one: &Edge, other: &Edge) -> f64 {
    gap_from(one, other).min(gap_from(other, one))
}

/// The least distance from the ends of an edge, and from its points in line with its centre and the other edge, to that edge.
fn gap_from(one: &Edge, other: &Edge) -> f64 {
    let ends = distance(other, one.start_point()).min(distance(other, one.end_point()));
    let Edge::Arc { centre, radius, start, sweep } = *one else { return ends };
    let towards = match *other {
        Edge::Arc { centre: its, .. } => its - centre,
        Edge::Line { from, to } => {
            let along = to - from;
            from + along * ((centre - from).dot(&along) / along.norm_squared()) - centre
        }
    };
    let angle = libm::atan2(towards.y, towards.x);
    let on_arc = [angle, angle + PI].into_iter().filter(|to| into_arc(start, sweep, *to) <= sweep.abs());
    on_arc.map(|angle| distance(other, centre + direction(angle) * radius)).fold(ends, f64::min)
}

/// The angle by which the direction from a point turns along an edge, in radians.
fn seen(edge: &Edge, p: Point) -> f64 {
    let between = |a: Point, b: Point| libm::atan2((a - p).perp(&(b - p)), (a - p).dot(&(b - p)));
    match *edge {
        Edge::Line { from, to } => between(from, to),
        Edge::Arc { centre, radius, start, sweep } => {
            // In pieces of a quarter turn at most; the point may be between a piece and its chord.
            let count = libm::ceil(sweep.abs() / FRAC_PI_2).max(1.0) as u32;
            let at = |k: u32| centre + direction(start + sweep * f64::from(k) / f64::from(count)) * radius;
            let piece = |k: u32| {
                let (a, b) = (at(k), at(k + 1));
                let beyond_chord = (b - a).perp(&(p - a)) * sweep < 0.0;
                let is_between = beyond_chord && (p - centre).norm() < radius;
                let whole = if sweep < 0.0 { -2.0 * PI } else { 2.0 * PI };
                between(a, b) + if is_between { whole } else { 0.0 }
            };
            (0..count).map(piece).sum()
        }
    }
}

/// Whether a point is inside a loop, whichever way it runs.
pub(crate) fn encloses(of: &Loop, p: Point) -> bool {
    of.edges.iter().map(|edge| seen(edge, p)).sum::<f64>().abs() > PI
}

/// Area inside a loop in square millimetres, positive if it runs counter-clockwise.
pub(crate) fn area(of: &Loop) -> f64 {
    let twice = |edge: &Edge| match *edge {
        Edge::Line { from, to } => from.perp(&to),
        Edge::Arc { centre, radius, sweep, .. } => {
            centre.perp(&(edge.end_point() - edge.start_point())) + radius * radius * sweep
        }
    };
    of.edges.iter().map(twice).sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};

    /// By the polygon of many corners: crossings of a ray, and the least distance from a corner.
    fn by_corners(corners: &[Point], p: Point) -> (bool, f64) {
        let next = corners.iter().cycle().skip(1);
        let crosses =
            |a: &Point, b: &Point| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        let is_inside = corners.iter().zip(next.clone()).filter(|(a, b)| crosses(a, b)).count() % 2 == 1;
        let to = |a: &Point, b: &Point| distance(&Edge::Line { from: *a, to: *b }, p);
        (is_inside, corners.iter().zip(next).map(|(a, b)| to(a, b)).fold(f64::INFINITY, f64::min))
    }

    #[test]
    fn the_gap_between_edges_is_that_of_many_points_on_both() {
        let mut edges = vec![
            Edge::Line { from: Point::new(3.0, -1.0), to: Point::new(4.0, 6.0) },
            Edge::Line { from: Point::new(-9.0, 2.0), to: Point::new(-3.0, -7.0) },
        ];
        for k in 0..8 {
            let k = f64::from(k);
            let centre = direction(1.1 * k) * (15.0 + 3.0 * k);
            edges.push(Edge::Arc { centre, radius: 1.0 + 0.4 * k, start: 0.7 * k, sweep: 4.0 - k });
        }
        for (k, one) in edges.iter().enumerate() {
            for other in &edges[k + 1..] {
                let far = |part: u32| distance(other, point_along(one, f64::from(part) / 2000.0));
                let sampled = (0..=2000).map(far).fold(f64::INFINITY, f64::min);
                let ours = gap(one, other);
                assert!(ours <= sampled + 1e-12 && ours > sampled - 1e-4, "{one:?} {other:?}: {ours} {sampled}");
            }
        }
    }

    #[test]
    fn a_polygon_of_many_corners_says_the_same() {
        let wheel = Wheel::with_pins(5, 2).unwrap();
        let sizes = Sizes::new(wheel, Scale::CrankRadius(40.0), &Choices::default()).unwrap();
        let outline = sizes.outline();
        let mut inside = 0;
        for of in [&outline.wheel.outer, &outline.disc.unwrap().outer, &Loop::circle(Point::new(3.0, 5.0), 20.0, true)]
        {
            let corners = of.corners(1e-5).unwrap();
            for k in 0..300 {
                let p = direction(0.37 * f64::from(k)) * (0.24 * f64::from(k) + 0.01);
                let (is_inside, far) = by_corners(&corners, p);
                let ours = of.edges.iter().map(|edge| distance(edge, p)).fold(f64::INFINITY, f64::min);
                assert!((ours - far).abs() < 2e-5, "{p:?}: {ours} {far}");
                assert!(far < 1e-4 || encloses(of, p) == is_inside, "{p:?}");
                inside += usize::from(is_inside);
            }
        }
        assert!((150..750).contains(&inside), "{inside}");
    }
}
