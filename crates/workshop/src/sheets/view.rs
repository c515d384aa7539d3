//! What is dimensioned on a part.

use super::callout::{Row, Side};
use super::dimension::{Measured, PrintedDimension};
use super::ink::Pen;
use super::length::mm;
use super::limits::{BORE, KEYWAY, LimitOrigin, Limits, general_tolerance};
use super::making::Making;
use crate::geometry::{Point, direction, into_arc, point_along};
use crate::parts::{Fastener, Hole, HolePurpose, Layer, Part};
use geneva_kinematics::wheel::{Edge, Loop};
use std::f64::consts::{FRAC_PI_2, PI};

/// Chords of an arc of another part.
const CHORDS: u32 = 96;

/// Where on a part, turned as it is drawn, something is dimensioned; in millimetres of the part.
#[derive(Clone, Copy, Debug)]
pub(super) enum Target {
    /// A leader to an edge.
    Edge(Point),
    /// A dimension across the page, above the part.
    Across([Point; 2]),
    /// A dimension along the page, beside the part.
    Along([Point; 2]),
}

/// A feature: where it is and what is written about it.
#[derive(Clone, Debug)]
pub(super) struct Feature {
    pub target: Target,
    pub side: Side,
    pub rows: Vec<Row>,
}

/// A part as it is drawn: turned, with its features and notes.
#[derive(Clone, Debug)]
pub(super) struct View {
    pub part: Part,
    pub features: Vec<Feature>,
    /// Lines of other parts, in millimetres of the part.
    pub lines: Vec<(Pen, Vec<Point>)>,
    /// Circles of centres about the axis: their radii.
    pub circles: Vec<f64>,
    pub notes: Vec<String>,
}

impl View {
    /// A view of a part turned by an angle in radians.
    pub(super) fn new(part: &Part, turn: f64) -> Self {
        let moved = |of: &Loop| of.transform(turn, Point::zeros());
        let point = |p: Point| direction(turn) * p.x + direction(turn + FRAC_PI_2) * p.y;
        let mut part = part.clone();
        part.outer = moved(&part.outer);
        part.marks = part.marks.iter().map(|p| point(*p)).collect();
        for hole in &mut part.holes {
            hole.outline = moved(&hole.outline);
            hole.centre = point(hole.centre);
            if let Some(wide) = &mut hole.widening {
                wide.outline = moved(&wide.outline);
            }
        }
        Self { part, features: Vec::new(), lines: Vec::new(), circles: Vec::new(), notes: Vec::new() }
    }

    pub(super) fn add(&mut self, target: Target, side: Side, rows: Vec<Row>) {
        self.features.push(Feature { target, side, rows });
    }

    /// Least and greatest corner of the part, in millimetres.
    pub(super) fn extent(&self) -> [Point; 2] {
        let mut corners = [Point::repeat(f64::INFINITY), Point::repeat(f64::NEG_INFINITY)];
        // Quarters of a degree at most: an arc reaches no farther than a hundred thousandth of its radius beyond.
        for edge in &self.part.outer.edges {
            for k in 0..=64 {
                let p = point_along(edge, f64::from(k) / 64.0);
                corners = [corners[0].inf(&p), corners[1].sup(&p)];
            }
        }
        for p in self.lines.iter().flat_map(|(_, points)| points) {
            corners = [corners[0].inf(p), corners[1].sup(p)];
        }
        corners
    }

    /// All dimensions on it.
    pub(super) fn dimensions(&self) -> impl Iterator<Item = &PrintedDimension> {
        let rows = self.features.iter().flat_map(|feature| &feature.rows);
        rows.filter_map(|row| if let Row::Size(size) = row { Some(size) } else { None })
    }

    /// Whether a limit or a zone on it has this origin.
    pub(super) fn has_limits_of(&self, wanted: LimitOrigin) -> bool {
        let mut rows = self.features.iter().flat_map(|feature| &feature.rows);
        rows.any(|row| match row {
            Row::Size(size) => size.origin == wanted && size.limits.is_some(),
            Row::Position { origin, .. } => *origin == wanted,
            Row::Words(_) | Row::Datum(_) => false,
        })
    }

    /// Whether a part has a round bore or one with a keyway; its circle is the part's datum.
    pub(super) fn has_bore(&self) -> bool {
        self.part.holes.iter().any(|hole| hole.purpose == HolePurpose::Bore)
    }

    /// Adds bores, patterns of holes and their pockets.
    pub(super) fn add_holes(&mut self, making: &Making<'_>) {
        let holes = self.part.holes.clone();
        if let Some(bore) = holes.iter().find(|hole| hole.purpose == HolePurpose::Bore) {
            self.add_bore(bore, making);
        }
        let patterns = [
            (HolePurpose::Hub, making.hub(self.part.layer), Measured::HubHole, Measured::HubCircle),
            (HolePurpose::DiscDowel, making.mounting.disc_dowels, Measured::DowelHole, Measured::DowelCircle),
        ];
        for (purpose, pattern, of_hole, of_circle) in patterns {
            let of_pattern: Vec<&Hole> = holes.iter().filter(|hole| hole.purpose == purpose).collect();
            let (Some(pattern), false) = (pattern, of_pattern.is_empty()) else { continue };
            // The one that is farthest down, beside the view's other leaders.
            let Some(hole) = of_pattern
                .iter()
                .min_by(|a, b| (a.centre.y - 1e-3 * a.centre.x).total_cmp(&(b.centre.y - 1e-3 * b.centre.x)))
            else {
                continue;
            };
            let Some(diameter) = hole.diameter() else { continue };
            let size = PrintedDimension::new(of_hole, &format!("{}× Ø", of_pattern.len()), diameter, "");
            let is_dowel = matches!(pattern.fastener, Fastener::Dowel(_));
            let size = if is_dowel {
                size.limited(making.held(Limits::class(BORE, diameter), [f64::INFINITY; 2]))
            } else {
                size
            };
            let mut rows = vec![Row::Size(size)];
            rows.push(Row::Size(PrintedDimension::new(of_circle, "evenly on Ø", pattern.circle, "")));
            rows.push(Row::Words(beside_upright(&of_pattern)));
            rows.extend(pocket_rows(hole));
            let side = if hole.centre.x < 0.0 { Side::Left } else { Side::Right };
            self.circles.push(pattern.circle / 2.0);
            self.add(Target::Edge(on_circle(hole, side, -0.6)), side, rows);
        }
    }

    fn add_bore(&mut self, bore: &Hole, making: &Making<'_>) {
        let circle = bore.outline.edges.iter().find_map(|edge| match edge {
            Edge::Arc { radius, .. } => Some(*radius),
            Edge::Line { .. } => None,
        });
        let Some(radius) = circle else { return };
        let limits = making.held_bore(2.0 * radius);
        let mut rows = vec![Row::Size(PrintedDimension::new(Measured::Bore, "Ø", 2.0 * radius, "").limited(limits))];
        rows.push(making.shaft_row(2.0 * radius));
        rows.push(Row::Datum("A"));
        let lines: Vec<[Point; 2]> = bore.outline.edges.iter().filter_map(straight).collect();
        let far = |line: &[Point; 2]| {
            let along = (line[1] - line[0]).normalize();
            (line[0] - bore.centre).perp(&along).abs()
        };
        match lines.as_slice() {
            [flat] => rows.push(Row::Size(
                PrintedDimension::new(Measured::AcrossBore, "", radius + far(flat), " to flat").limited(
                    making.over_shaft(
                        making.held(Limits::new([0.0, general_tolerance(radius) / 2.0]), [f64::INFINITY; 2]),
                        radius + far(flat),
                    ),
                ),
            )),
            [_, bottom, _] => {
                let width = (bottom[1] - bottom[0]).norm();
                let name = PrintedDimension::new(Measured::KeywayWidth, "keyway ", width, "");
                rows.push(Row::Size(name.limited(making.held(Limits::class(KEYWAY, width), [f64::INFINITY; 2]))));
                let across = PrintedDimension::new(Measured::AcrossBore, "", radius + far(bottom), " with keyway");
                rows.push(Row::Size(
                    across.limited(making.held(Limits::new([0.0, keyway_depth(width)]), [f64::INFINITY; 2])),
                ));
                // A key that slides would let the part turn on its shaft.
                self.notes.push("Key h9, fitted without play to its keyway (JS9: DIN 6885-1, normal fit).".to_owned());
            }
            _ => {}
        }
        if !lines.is_empty() {
            let place = match (self.part.layer, making.sizes.pins()) {
                (Layer::Wheel | Layer::RingPlate, _) => "midway between two slots",
                (_, 1) => "opposite to the pin",
                _ => "midway between two pins",
            };
            rows.push(Row::Words(place.to_owned()));
        }
        // On the left, below or above the middle, where the circle is whole.
        let on_arc = |angle: f64| {
            bore.outline.edges.iter().any(|edge| match *edge {
                Edge::Arc { start, sweep, .. } => into_arc(start, sweep, angle) <= sweep.abs(),
                Edge::Line { .. } => false,
            })
        };
        let angle = [1.2, 0.8, 1.0].into_iter().map(|part| part * PI).find(|angle| on_arc(*angle)).unwrap_or(PI);
        self.add(Target::Edge(bore.centre + direction(angle) * radius), Side::Left, rows);
    }
}

/// How far the hole of a pattern that is nearest to straight above the axis is from there.
fn beside_upright(holes: &[&Hole]) -> String {
    let angle = |hole: &&Hole| libm::atan2(hole.centre.x, hole.centre.y).to_degrees();
    let nearest =
        holes.iter().map(angle).fold(180.0, |best: f64, next| if next.abs() < best.abs() - 1e-6 { next } else { best });
    match mm(nearest.abs()).as_str() {
        "0" => "one on the upper centre line".to_owned(),
        degrees => format!("one {degrees}° {} of upright", if nearest > 0.0 { "right" } else { "left" }),
    }
}

/// Widths of keyways up to 6 mm may be 0.1 mm deeper, others up to 32 mm 0.2 mm, and wider ones 0.3 mm: DIN 6885-1, t2.
fn keyway_depth(width: f64) -> f64 {
    if width <= 6.0 {
        0.1
    } else if width <= 32.0 {
        0.2
    } else {
        0.3
    }
}

fn straight(edge: &Edge) -> Option<[Point; 2]> {
    match *edge {
        Edge::Line { from, to } => Some([from, to]),
        Edge::Arc { .. } => None,
    }
}

/// A place on a round hole's edge towards a side of the page, and so much up.
pub(super) fn on_circle(hole: &Hole, side: Side, up: f64) -> Point {
    let towards = Point::new(if side == Side::Left { -1.0 } else { 1.0 }, up).normalize();
    hole.centre + towards * (hole.diameter().unwrap_or(0.0) / 2.0)
}

/// What is written about the pocket of a nut, or about a shoulder.
pub(super) fn pocket_rows(hole: &Hole) -> Vec<Row> {
    let Some(wide) = &hole.widening else { return Vec::new() };
    let side = if wide.is_from_below { " deep from the back" } else { " deep from the front" };
    let depth = Row::Size(PrintedDimension::new(Measured::PocketDepth, "", wide.depth, side));
    match wide.outline.edges.as_slice() {
        [Edge::Arc { radius, .. }] => {
            vec![Row::Size(PrintedDimension::new(Measured::Shoulder, "Ø", 2.0 * radius, "")), depth]
        }
        edges => {
            let first = edges.iter().find_map(straight);
            let width = first.map(|[from, to]| 2.0 * (from - hole.centre).perp(&(to - from).normalize()).abs());
            let size = |width| Row::Size(PrintedDimension::new(Measured::NutWidth, "hexagon ", width, " across flats"));
            width.map(size).into_iter().chain([depth]).collect()
        }
    }
}

/// A closed line as lines through points on it, each of an edge.
pub(super) fn polylines(pen: Pen, of: &Loop) -> impl Iterator<Item = (Pen, Vec<Point>)> {
    let points = |edge: &Edge| {
        let count = if matches!(edge, Edge::Line { .. }) { 1 } else { CHORDS };
        (0..=count).map(|k| point_along(edge, f64::from(k) / f64::from(count))).collect()
    };
    of.edges.iter().map(move |edge| (pen, points(edge)))
}
