//! Flat faces of a solid where lines of its two slabs cross, such as a plate's bore and the outline of what stands on the plate.
//!
//! Lines are first cut where they meet, so that each piece between two meetings has one kind of cell on either side. A cell is
//! material below, above, both or neither. The flat faces are the cells with material on one side only, and the pieces around
//! them, followed with the cell on the left, are their bounds.

use crate::geometry::{Point, distance, encloses, into_arc, point_along};
use geneva_kinematics::wheel::{Edge, Loop};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

/// A piece of a solid's line: which line, and which of its edges.
pub(crate) type PieceKey = (usize, usize);

/// A piece of a line in one of its senses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BoundPiece {
    /// Which piece.
    pub piece: PieceKey,
    /// Whether it runs as its line does.
    pub is_forward: bool,
}

/// Lines in pieces that meet at their ends only, and which of these ends and pieces are in the same place.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct CutLines {
    /// Pairs of lines that meet.
    pairs: BTreeSet<(usize, usize)>,
    /// The first piece that begins where this one begins, if another one does.
    corners: BTreeMap<PieceKey, PieceKey>,
    /// The first piece in the same place, and whether it runs in the same sense.
    pieces: BTreeMap<PieceKey, BoundPiece>,
    /// The pieces that begin in the middle of an edge of the line as it was.
    inner: BTreeSet<PieceKey>,
}

impl CutLines {
    /// Cuts lines where they meet others of their group; what is nearer than `snap`, in millimetres, is in the same place.
    pub(crate) fn new(lines: &mut [Loop], groups: &[Vec<usize>], snap: f64) -> Self {
        let mut cut = Self::default();
        let mut meetings: Vec<Point> = Vec::new();
        let boxes: Vec<[Point; 2]> = lines.iter().map(|of| bounding_box(&of.edges)).collect();
        for group in groups {
            for (k, one) in group.iter().enumerate() {
                for other in group.iter().skip(k + 1).filter(|other| *other != one) {
                    let pair = (*one.min(other), *one.max(other));
                    if cut.pairs.contains(&pair) || !boxes_meet(&boxes[pair.0], &boxes[pair.1], snap) {
                        continue;
                    }
                    let found = loops_meet(&lines[pair.0], &lines[pair.1], snap);
                    if !found.is_empty() {
                        cut.pairs.insert(pair);
                        meetings.extend(found);
                    }
                }
            }
        }
        // Those that are in the same place are one; they are farther from each other than a corner is from its meeting.
        let mut places: Vec<Point> = Vec::new();
        for p in meetings {
            if places.iter().all(|known| (known - p).norm() > 3.0 * snap) {
                places.push(p);
            }
        }
        let involved: BTreeSet<usize> = cut.pairs.iter().flat_map(|(one, other)| [*one, *other]).collect();
        for line in &involved {
            let pieces = cut_loop(&lines[*line], &places, snap);
            let inner = pieces.iter().enumerate().filter(|(_, (_, is_inner))| *is_inner);
            cut.inner.extend(inner.map(|(piece, _)| (*line, piece)));
            lines[*line] = Loop { edges: pieces.into_iter().map(|(edge, _)| edge).collect() };
        }
        cut.find_shared(lines, &involved, &places, snap);
        cut
    }

    /// Finds the pieces with shared corners, and those in the same place.
    fn find_shared(&mut self, lines: &[Loop], involved: &BTreeSet<usize>, places: &[Point], snap: f64) {
        let mut first: BTreeMap<usize, PieceKey> = BTreeMap::new();
        for line in involved {
            for (piece, edge) in lines[*line].edges.iter().enumerate() {
                let start = edge.start_point();
                if let Some(place) = places.iter().position(|known| (known - start).norm() < 2.0 * snap) {
                    let key = (*line, piece);
                    let known = *first.entry(place).or_insert(key);
                    self.corners.insert(key, known);
                }
            }
        }
        let mut between: BTreeMap<[PieceKey; 2], Vec<PieceKey>> = BTreeMap::new();
        for line in involved {
            for (piece, edge) in lines[*line].edges.iter().enumerate() {
                let key = (*line, piece);
                let [from, to] = self.ends(lines, key);
                let known = between.entry([from.min(to), from.max(to)]).or_default();
                let middle = point_along(edge, 0.5);
                let is_same =
                    |other: &&PieceKey| (point_along(&lines[other.0].edges[other.1], 0.5) - middle).norm() < 3.0 * snap;
                match known.iter().find(is_same) {
                    Some(other) => {
                        let is_forward = self.ends(lines, *other)[0] == from;
                        self.pieces.insert(key, BoundPiece { piece: *other, is_forward });
                    }
                    None => known.push(key),
                }
            }
        }
    }

    /// The corner at which a piece begins, by the first piece that begins there.
    pub(crate) fn corner(&self, key: PieceKey) -> PieceKey {
        self.corners.get(&key).copied().unwrap_or(key)
    }

    /// The first piece in the place of this one, and whether it runs in the same sense.
    pub(crate) fn piece(&self, key: PieceKey) -> BoundPiece {
        self.pieces.get(&key).copied().unwrap_or(BoundPiece { piece: key, is_forward: true })
    }

    /// Whether a piece begins in the middle of an edge of its line as it was, where the line has no corner of its own.
    pub(crate) fn is_inner(&self, key: PieceKey) -> bool {
        self.inner.contains(&key)
    }

    /// Whether any of these lines meet.
    pub(crate) fn has_crossings(&self, of: &[usize]) -> bool {
        self.pairs.iter().any(|(one, other)| of.contains(one) && of.contains(other))
    }

    /// Whether no lines meet here that don't meet in another cut of them.
    pub(crate) fn meets_only_as(&self, other: &Self) -> bool {
        self.pairs.is_subset(&other.pairs)
    }

    /// Whether a line meets another one.
    pub(crate) fn is_cut(&self, line: usize) -> bool {
        self.pairs.iter().any(|(one, other)| *one == line || *other == line)
    }

    /// The corners at which a piece begins and ends.
    fn ends(&self, lines: &[Loop], (line, piece): PieceKey) -> [PieceKey; 2] {
        let next = (piece + 1) % lines[line].edges.len().max(1);
        [self.corner((line, piece)), self.corner((line, next))]
    }

    /// The bounds of the faces between the lines below and above a height, seen from above: of those with material below only, and of
    /// those with material above only. Each face has its outer bound, counter-clockwise, and its holes, clockwise.
    pub(crate) fn faces(&self, lines: &[Loop], below: &[usize], above: &[usize]) -> [Vec<Vec<Vec<BoundPiece>>>; 2] {
        let levels = [below, above];
        let mut all: Vec<usize> = below.iter().chain(above).copied().collect();
        all.sort_unstable();
        all.dedup();
        // Which of the levels has material on the left and on the right of each piece.
        let mut sides: BTreeMap<PieceKey, [[Option<bool>; 2]; 2]> = BTreeMap::new();
        for (level, its) in levels.iter().enumerate() {
            for line in *its {
                for piece in 0..lines[*line].edges.len() {
                    let BoundPiece { piece, is_forward } = self.piece((*line, piece));
                    // The material is on the left of its line; of two in the same place, on the left of each.
                    let known = &mut sides.entry(piece).or_default()[level];
                    let is_left = [is_forward, !is_forward];
                    *known = [0, 1].map(|k| Some(is_left[k] || known[k] == Some(true)));
                }
            }
        }
        for line in &all {
            let mut known: [Option<bool>; 2] = [None; 2];
            for piece in 0..lines[*line].edges.len() {
                if self.corners.contains_key(&(*line, piece)) {
                    known = [None; 2];
                }
                let Some(of) = sides.get_mut(&(*line, piece)) else { continue };
                for (level, its) in
                    levels.iter().enumerate().filter(|(level, _)| of[*level][0].is_none()).collect::<Vec<_>>()
                {
                    let middle = point_along(&lines[*line].edges[piece], 0.5);
                    let around = || its.iter().filter(|other| encloses(&lines[**other], middle)).count();
                    let is_material = *known[level].get_or_insert_with(|| around() % 2 == 1);
                    of[level] = [Some(is_material); 2];
                }
            }
        }
        [0, 1].map(|level| {
            let has_face = |sides: &[[Option<bool>; 2]; 2], left: usize| {
                sides[level][left] == Some(true) && sides[1 - level][left] == Some(false)
            };
            let around = sides.iter().filter_map(|(piece, of)| match [has_face(of, 0), has_face(of, 1)] {
                [true, false] => Some(BoundPiece { piece: *piece, is_forward: true }),
                [false, true] => Some(BoundPiece { piece: *piece, is_forward: false }),
                _ => None,
            });
            group(lines, self.follow(lines, around.collect()))
        })
    }

    /// Closed bounds of these pieces, each of which is in one of them.
    fn follow(&self, lines: &[Loop], around: Vec<BoundPiece>) -> Vec<Vec<BoundPiece>> {
        let ends = |side: &BoundPiece| {
            let [from, to] = self.ends(lines, side.piece);
            if side.is_forward { [from, to] } else { [to, from] }
        };
        let mut leaving: BTreeMap<PieceKey, Vec<BoundPiece>> = BTreeMap::new();
        for side in around {
            leaving.entry(ends(&side)[0]).or_default().push(side);
        }
        let mut bounds = Vec::new();
        while let Some(first) = leaving.values_mut().find_map(Vec::pop) {
            let (start, mut bound, mut last) = (ends(&first)[0], vec![first], first);
            loop {
                let at = ends(&last)[1];
                if at == start {
                    bounds.push(bound);
                    break;
                }
                // Where several leave a corner, the sharpest turn to the left stays around the same face.
                let back = heading(lines, &last, true) + PI;
                let turn = |side: &BoundPiece| into_arc(back, -1.0, heading(lines, side, false));
                let Some(next) = leaving.get_mut(&at).and_then(|sides| {
                    let best = (0..sides.len()).min_by(|a, b| turn(&sides[*a]).total_cmp(&turn(&sides[*b])))?;
                    Some(sides.swap_remove(best))
                }) else {
                    break;
                };
                bound.push(next);
                last = next;
            }
        }
        bounds
    }
}

/// The direction of a piece in its sense, where it ends or begins, in radians.
fn heading(lines: &[Loop], side: &BoundPiece, is_at_end: bool) -> f64 {
    let edge = &lines[side.piece.0].edges[side.piece.1];
    let along = match *edge {
        Edge::Line { from, to } => libm::atan2(to.y - from.y, to.x - from.x),
        Edge::Arc { start, sweep, .. } => {
            let at = if is_at_end == side.is_forward { start + sweep } else { start };
            at + PI / 2.0 * sweep.signum()
        }
    };
    if side.is_forward { along } else { along + PI }
}

/// The bounds by their faces: each outer one, followed by the holes in it.
fn group(lines: &[Loop], bounds: Vec<Vec<BoundPiece>>) -> Vec<Vec<Vec<BoundPiece>>> {
    let loops: Vec<(Vec<BoundPiece>, Loop)> =
        bounds.into_iter().map(|bound| (bound.clone(), bound_loop(lines, &bound))).collect();
    let (outer, holes): (Vec<_>, Vec<_>) = loops.into_iter().partition(|(_, of)| crate::geometry::area(of) > 0.0);
    let mut faces: Vec<(Loop, f64, Vec<Vec<BoundPiece>>)> =
        outer.into_iter().map(|(bound, of)| (of.clone(), crate::geometry::area(&of), vec![bound])).collect();
    for (bound, of) in holes {
        let Some(p) = of.edges.first().map(|edge| point_along(edge, 0.5)) else { continue };
        let around = faces.iter_mut().filter(|(outer, ..)| encloses(outer, p)).min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((_, _, face)) = around {
            face.push(bound);
        }
    }
    faces.into_iter().map(|(_, _, face)| face).collect()
}

/// The closed line of a bound.
pub(crate) fn bound_loop(lines: &[Loop], bound: &[BoundPiece]) -> Loop {
    let edge = |side: &BoundPiece| {
        let edge = *lines.get(side.piece.0)?.edges.get(side.piece.1)?;
        Some(match edge {
            edge if side.is_forward => edge,
            Edge::Line { from, to } => Edge::Line { from: to, to: from },
            Edge::Arc { centre, radius, start, sweep } => {
                Edge::Arc { centre, radius, start: start + sweep, sweep: -sweep }
            }
        })
    };
    Loop { edges: bound.iter().filter_map(edge).collect() }
}

/// The least and the greatest coordinates of edges, in millimetres, or somewhat beyond.
fn bounding_box(edges: &[Edge]) -> [Point; 2] {
    let of = |edge: &Edge| match *edge {
        Edge::Line { from, to } => [from.inf(&to), from.sup(&to)],
        Edge::Arc { centre, radius, .. } => {
            let by = Point::new(radius, radius);
            [centre - by, centre + by]
        }
    };
    let none = [Point::repeat(f64::INFINITY), Point::repeat(f64::NEG_INFINITY)];
    edges.iter().map(of).fold(none, |a, b| [a[0].inf(&b[0]), a[1].sup(&b[1])])
}

fn boxes_meet(one: &[Point; 2], other: &[Point; 2], snap: f64) -> bool {
    let apart = |k: usize| one[0][k] > other[1][k] + snap || other[0][k] > one[1][k] + snap;
    !apart(0) && !apart(1)
}

/// Where two loops meet: corners of one on the other, and then the points where they cross.
fn loops_meet(one: &Loop, other: &Loop, snap: f64) -> Vec<Point> {
    let whole = bounding_box(&other.edges);
    let boxed = |of: &Loop| -> Vec<(Edge, [Point; 2])> {
        of.edges.iter().map(|edge| (*edge, bounding_box(std::slice::from_ref(edge)))).collect()
    };
    let (ones, others) = (boxed(one), boxed(other));
    let (mut corners, mut crossings) = (Vec::new(), Vec::new());
    for (edge, its) in ones.iter().filter(|(_, its)| boxes_meet(its, &whole, snap)) {
        for (against, _) in others.iter().filter(|(_, other)| boxes_meet(its, other, snap)) {
            corners.extend([edge.start_point(), edge.end_point()].into_iter().filter(|p| distance(against, *p) < snap));
            corners
                .extend([against.start_point(), against.end_point()].into_iter().filter(|p| distance(edge, *p) < snap));
            let is_on_both = |p: &Point| distance(edge, *p) < snap && distance(against, *p) < snap;
            crossings.extend(carriers_meet(edge, against).into_iter().flatten().filter(is_on_both));
        }
    }
    corners.extend(crossings);
    corners
}

/// Where the whole lines or circles on which two edges are cross.
fn carriers_meet(one: &Edge, other: &Edge) -> [Option<Point>; 2] {
    match (*one, *other) {
        (Edge::Line { from, to }, Edge::Line { from: start, to: end }) => {
            let (along, across) = (to - from, end - start);
            let part = (start - from).perp(&across) / along.perp(&across);
            [Some(from + along * part).filter(|_| part.is_finite()), None]
        }
        (Edge::Line { from, to }, Edge::Arc { centre, radius, .. })
        | (Edge::Arc { centre, radius, .. }, Edge::Line { from, to }) => {
            let along = (to - from).normalize();
            let foot = from + along * (centre - from).dot(&along);
            along_chord(foot, along, radius * radius - (foot - centre).norm_squared())
        }
        (Edge::Arc { centre, radius, .. }, Edge::Arc { centre: second, radius: its, .. }) => {
            let between = second - centre;
            let far = between.norm();
            let foot = (far * far + radius * radius - its * its) / (2.0 * far);
            let along = between / far;
            let across = Point::new(-along.y, along.x);
            along_chord(centre + along * foot, across, radius * radius - foot * foot)
        }
    }
}

/// The two points on a line from its middle whose distance from that has this square; none if there are none.
fn along_chord(middle: Point, along: Point, square: f64) -> [Option<Point>; 2] {
    if square.is_finite() && square >= 0.0 {
        let half = along * square.sqrt();
        [Some(middle - half), Some(middle + half)]
    } else {
        [None; 2]
    }
}

/// The pieces of a loop with corners at all places that are on it, and which of them begin in the middle of an edge.
fn cut_loop(of: &Loop, places: &[Point], snap: f64) -> Vec<(Edge, bool)> {
    let at_place = |p: Point| places.iter().find(|place| (*place - p).norm() < snap).copied().unwrap_or(p);
    let mut edges = Vec::new();
    for edge in &of.edges {
        let (start, end) = (edge.start_point(), edge.end_point());
        let is_within =
            |p: &&Point| (*p - start).norm() >= snap && (*p - end).norm() >= snap && distance(edge, **p) < snap;
        let within: Vec<Point> = places.iter().filter(is_within).copied().collect();
        match *edge {
            Edge::Line { from, to } => {
                let mut corners = within;
                corners.sort_by(|a, b| (a - from).norm().total_cmp(&(b - from).norm()));
                corners.insert(0, at_place(from));
                corners.push(at_place(to));
                let pairs = corners.windows(2).filter(|pair| pair[0] != pair[1]).enumerate();
                edges.extend(pairs.map(|(k, pair)| (Edge::Line { from: pair[0], to: pair[1] }, k > 0)));
            }
            Edge::Arc { centre, radius, start, sweep } => {
                let turn = |p: &Point| into_arc(start, sweep, libm::atan2(p.y - centre.y, p.x - centre.x));
                let mut turns: Vec<f64> = within.iter().map(turn).filter(|turn| *turn < sweep.abs()).collect();
                turns.sort_by(f64::total_cmp);
                turns.insert(0, 0.0);
                turns.push(sweep.abs());
                let sense = sweep.signum();
                edges.extend(turns.windows(2).enumerate().map(|(k, pair)| {
                    let (start, sweep) = (start + sense * pair[0], sense * (pair[1] - pair[0]));
                    (Edge::Arc { centre, radius, start, sweep }, k > 0)
                }));
            }
        }
    }
    edges
}
