//! Reads the lines and arcs of a drawing in the exchange format DXF, and the sizes of a wheel from them.
//!
//! Of release 12 and later, in text: `LINE`, `ARC`, `CIRCLE`, `POLYLINE` and `LWPOLYLINE` with their bulges. Everything else is
//! passed over and counted. The header's unit is taken into account; without one, numbers are millimetres.

use geneva_kinematics::wheel::Edge;
use nalgebra::Vector2;
use std::f64::consts::PI;

type Point = Vector2<f64>;
/// A corner of a polyline, and the bulge of the edge that begins there.
type Corner = (Point, f64);

/// Why a drawing can't be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DrawingError {
    /// The text is not pairs of a code and a value.
    #[error("line {line}: \"{text}\" is not a group code; choose a DXF file in text, not a binary one")]
    NotACode {
        /// Number of the line, from 1.
        line: usize,
        /// What is there.
        text: String,
    },
    /// A number that is none.
    #[error("line {line}: \"{text}\" is not a number; export the drawing again")]
    NotANumber {
        /// Number of the line, from 1.
        line: usize,
        /// What is there.
        text: String,
    },
    /// A layer without what is looked for on it.
    #[error("layer {layer}: {missing}; draw it there, or say which layer has it")]
    Missing {
        /// Name of the layer.
        layer: String,
        /// What is missing.
        missing: &'static str,
    },
    /// A drawing of an internal wheel.
    #[error(
        "layer {layer}: this is a drawing of an internal wheel, and only external wheels can be checked; give one of an external wheel"
    )]
    Internal {
        /// Name of the layer that only internal wheels have.
        layer: &'static str,
    },
    /// Sizes that no wheel has.
    #[error("{0}")]
    Sizes(String),
}

/// A line or arc of a drawing, on its layer.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnEdge {
    /// Name of the layer.
    pub layer: String,
    /// The line or arc, in millimetres.
    pub edge: Edge,
}

/// What was read of a drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// All lines and arcs.
    pub edges: Vec<DrawnEdge>,
    /// How many entities were passed over.
    pub passed_over: usize,
}

/// A group of a file: its code, its value, and the line of the value.
struct Group<'a> {
    code: i32,
    value: &'a str,
    line: usize,
}

impl Group<'_> {
    fn number(&self) -> Result<f64, DrawingError> {
        let is_not = || DrawingError::NotANumber { line: self.line, text: self.value.to_owned() };
        self.value.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(is_not)
    }
}

fn groups(text: &str) -> Result<Vec<Group<'_>>, DrawingError> {
    let mut lines = text.lines().map(str::trim).zip(1..);
    let mut groups = Vec::new();
    while let Some((code, line)) = lines.next() {
        let Some((value, at)) = lines.next() else { break };
        let not_a_code = || DrawingError::NotACode { line, text: code.chars().take(20).collect() };
        groups.push(Group { code: code.parse().map_err(|_| not_a_code())?, value, line: at });
    }
    Ok(groups)
}

/// A record of a file: its kind and its groups.
struct Record<'a, 'b> {
    kind: &'a str,
    groups: &'b [Group<'a>],
}

impl Record<'_, '_> {
    fn find(&self, code: i32) -> Option<&Group<'_>> {
        self.groups.iter().find(|group| group.code == code)
    }

    fn number(&self, code: i32) -> Result<f64, DrawingError> {
        self.find(code).map_or(Ok(0.0), Group::number)
    }

    fn point(&self, first: i32) -> Result<Point, DrawingError> {
        Ok(Point::new(self.number(first)?, self.number(first + 10)?))
    }

    fn layer(&self) -> String {
        self.find(8).map_or_else(|| "0".to_owned(), |group| group.value.to_owned())
    }

    fn is_closed(&self) -> Result<bool, DrawingError> {
        Ok(self.number(70)? as i64 & 1 == 1)
    }
}

/// The edge from one corner of a polyline to the next: a line, or an arc whose bulge is the tangent of a quarter of its angle.
fn bulged(from: Point, to: Point, bulge: f64) -> Edge {
    let chord = to - from;
    if bulge == 0.0 || chord.norm() == 0.0 {
        return Edge::Line { from, to };
    }
    let sweep = 4.0 * libm::atan(bulge);
    let across = Point::new(-chord.y, chord.x);
    let centre = (from + to) / 2.0 + across * ((1.0 - bulge * bulge) / (4.0 * bulge));
    let start = from - centre;
    Edge::Arc { centre, radius: start.norm(), start: libm::atan2(start.y, start.x), sweep }
}

/// The edges through corners with their bulges.
fn through(corners: &[Corner], is_closed: bool) -> Vec<Edge> {
    let next = corners.iter().skip(1).chain(corners.first().filter(|_| is_closed));
    let edges = corners.iter().zip(next).map(|((from, bulge), (to, _))| bulged(*from, *to, *bulge));
    edges.filter(|edge| (edge.end_point() - edge.start_point()).norm() > 0.0).collect()
}

/// Millimetres of the unit with a number of the header's `$INSUNITS`.
fn unit(number: f64) -> f64 {
    match number as i64 {
        1 => 25.4,
        2 => 304.8,
        5 => 10.0,
        6 => 1000.0,
        _ => 1.0,
    }
}

impl Drawing {
    /// Reads a drawing.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    /// use geneva_workshop::{Drawing, Mounting, PartLayout, dxf, parts};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
    /// let list = parts(&sizes, 5.0, &Mounting::default())?; // thickness in mm
    /// let drawing = Drawing::read(&dxf(&list.parts, PartLayout::Apart))?;
    /// assert!(drawing.edges.iter().any(|edge| edge.layer == "WHEEL"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`DrawingError::NotACode`] for a text that is no DXF, and [`DrawingError::NotANumber`] for a number that is none.
    pub fn read(text: &str) -> Result<Self, DrawingError> {
        let groups = groups(text)?;
        let scale = groups
            .windows(2)
            .find(|pair| pair[0].code == 9 && pair[0].value == "$INSUNITS")
            .map_or(Ok(1.0), |pair| pair[1].number().map(unit))?;
        let starts: Vec<usize> = (0..groups.len()).filter(|at| groups[*at].code == 0).collect();
        let records = starts.iter().enumerate().map(|(k, at)| {
            let end = starts.get(k + 1).copied().unwrap_or(groups.len());
            Record { kind: groups[*at].value, groups: &groups[at + 1..end] }
        });
        let mut drawing = Self::default();
        let mut is_in_entities = false;
        let mut polyline: Option<(String, bool, Vec<Corner>)> = None;
        for record in records {
            match record.kind {
                "SECTION" => is_in_entities = record.find(2).is_some_and(|name| name.value == "ENTITIES"),
                "ENDSEC" => is_in_entities = false,
                _ if !is_in_entities => {}
                "POLYLINE" => polyline = Some((record.layer(), record.is_closed()?, Vec::new())),
                "VERTEX" => {
                    if let Some((_, _, corners)) = &mut polyline {
                        corners.push((record.point(10)?, record.number(42)?));
                    }
                }
                "SEQEND" => {
                    if let Some((layer, is_closed, corners)) = polyline.take() {
                        drawing.add(&layer, through(&corners, is_closed));
                    }
                }
                _ => match edges(&record)? {
                    Some(edges) => drawing.add(&record.layer(), edges),
                    None => drawing.passed_over += 1,
                },
            }
        }
        for drawn in &mut drawing.edges {
            drawn.edge = scaled(&drawn.edge, scale);
        }
        Ok(drawing)
    }

    fn add(&mut self, layer: &str, edges: Vec<Edge>) {
        self.edges.extend(edges.into_iter().map(|edge| DrawnEdge { layer: layer.to_owned(), edge }));
    }
}

/// The edges of an entity; none if it is of another kind.
fn edges(record: &Record<'_, '_>) -> Result<Option<Vec<Edge>>, DrawingError> {
    let edge = match record.kind {
        "LINE" => Edge::Line { from: record.point(10)?, to: record.point(11)? },
        "CIRCLE" => Edge::Arc { centre: record.point(10)?, radius: record.number(40)?, start: 0.0, sweep: 2.0 * PI },
        "ARC" => {
            let (start, end) = (record.number(50)?, record.number(51)?);
            let sweep = (end - start) % 360.0;
            let sweep = if sweep <= 0.0 { sweep + 360.0 } else { sweep };
            Edge::Arc {
                centre: record.point(10)?,
                radius: record.number(40)?,
                start: start.to_radians(),
                sweep: sweep.to_radians(),
            }
        }
        "LWPOLYLINE" => {
            let mut corners: Vec<Corner> = Vec::new();
            for group in record.groups {
                match (group.code, corners.last_mut()) {
                    (10, _) => corners.push((Point::new(group.number()?, 0.0), 0.0)),
                    (20, Some(last)) => last.0.y = group.number()?,
                    (42, Some(last)) => last.1 = group.number()?,
                    _ => {}
                }
            }
            return Ok(Some(through(&corners, record.is_closed()?)));
        }
        _ => return Ok(None),
    };
    Ok(Some(vec![edge]))
}

fn scaled(edge: &Edge, scale: f64) -> Edge {
    match *edge {
        Edge::Line { from, to } => Edge::Line { from: from * scale, to: to * scale },
        Edge::Arc { centre, radius, start, sweep } => {
            Edge::Arc { centre: centre * scale, radius: radius * scale, start, sweep }
        }
    }
}
