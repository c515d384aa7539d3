//! All parts as solids with true planes and cylinders, in the exchange format STEP, application protocol 214 (ISO 10303-214).
//!
//! Each solid is a closed shell of faces that share their edges: each edge is in two faces, which run along it in opposite
//! senses. The parts are where they are in the assembly, in the middle of a dwell; the wheel's lower face is on the plane z = 0.

use crate::body::{Body, bodies};
use crate::crossings::{BoundPiece, PieceKey};
use crate::geometry::{Point, turned};
use crate::parts::{MountingError, Part, Place};
use geneva_kinematics::wheel::{Edge, Loop};
use std::collections::BTreeMap;
use std::fmt::Write;

/// All solids in place, in millimetres.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Mounting, parts, step};
///
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let list = parts(&sizes, 5.0, &Mounting::default()).expect("bare parts");
/// let text = step(&list.parts).expect("solids");
/// assert!(text.starts_with("ISO-10303-21;"));
/// assert_eq!(text.matches("MANIFOLD_SOLID_BREP(").count(), 2); // wheel and driver
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// [`MountingError::TooDeep`] for a pocket that leaves nothing below it, and [`MountingError::Floating`] for a disc that touches its
/// plate nowhere.
pub fn step(parts: &[Part]) -> Result<String, MountingError> {
    let header = HEADER.replace("'Geneva wheel and driver'", &format!("'Geneva wheel and driver'{}", allowance(parts)));
    let mut file = File { text: header, next: FIRST };
    for body in bodies(parts)? {
        file.product(&body);
    }
    Ok(file.text + "ENDSEC;\nEND-ISO-10303-21;\n")
}

/// The description's further entry where holes are wider than they should become.
fn allowance(parts: &[Part]) -> String {
    crate::parts::allowance_words(parts).map_or_else(String::new, |words| format!(",'{words}'"))
}

/// Header, and what all products have in common: the entities 1 to 11.
const HEADER: &str = "ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('Geneva wheel and driver'),'2;1');
FILE_NAME('geneva-wheel.step','1970-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('core data for automotive mechanical design processes');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#5=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#6=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#7=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#8=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#5,'distance_accuracy_value','');
#9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#8))GLOBAL_UNIT_ASSIGNED_CONTEXT((#5,#6,#7))REPRESENTATION_CONTEXT('',''));
#10=DIRECTION('',(0.,0.,1.));
#11=DIRECTION('',(0.,0.,-1.));
";
const CONTEXT: u32 = 9;
const UP: u32 = 10;
const DOWN: u32 = 11;
const FIRST: u32 = 12;

/// A number as the format has it: with a point.
fn real(x: f64) -> String {
    let text = format!("{:?}", x + 0.0);
    match text.split_once('e') {
        Some((digits, power)) => {
            let point = if digits.contains('.') { "" } else { "." };
            format!("{digits}{point}E{power}")
        }
        None => text,
    }
}

struct File {
    text: String,
    next: u32,
}

/// Which entity an edge is, and whether it is used from its start to its end.
type Oriented = (u32, bool);

/// A solid in its place, with the entities of its corners and of its edges along lines that are written so far.
struct PlacedSolid<'a> {
    body: &'a Body,
    place: Place,
    /// The solid's lines where they are, in pieces.
    lines: Vec<Vec<Edge>>,
    /// Entities by line, piece and height.
    corners: BTreeMap<(usize, usize, u64), u32>,
    edges: BTreeMap<(usize, usize, u64), u32>,
}

impl<'a> PlacedSolid<'a> {
    fn new(body: &'a Body, place: Place) -> Self {
        let pieces = |of: &Loop| of.edges.iter().map(|edge| edge.transform(place.turn, place.at)).collect();
        let lines = body.lines.iter().map(pieces).collect();
        Self { body, place, lines, corners: BTreeMap::new(), edges: BTreeMap::new() }
    }

    fn pieces(&self, line: usize) -> &[Edge] {
        self.lines.get(line).map_or(&[], Vec::as_slice)
    }
}

impl File {
    fn entity(&mut self, text: impl AsRef<str>) -> u32 {
        let id = self.next;
        self.next += 1;
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "#{id}={};", text.as_ref());
        id
    }

    fn point(&mut self, at: Point, height: f64) -> u32 {
        self.entity(format!("CARTESIAN_POINT('',({},{},{}))", real(at.x), real(at.y), real(height)))
    }

    fn direction(&mut self, of: Point) -> u32 {
        self.entity(format!("DIRECTION('',({},{},0.))", real(of.x), real(of.y)))
    }

    /// An axis through a point, towards `axis`, with a first direction across it.
    fn axes(&mut self, at: Point, height: f64, axis: u32) -> u32 {
        let (at, first) = (self.point(at, height), self.direction(Point::new(1.0, 0.0)));
        self.entity(format!("AXIS2_PLACEMENT_3D('',#{at},#{axis},#{first})"))
    }

    fn product(&mut self, body: &Body) {
        let solids: Vec<u32> = body.places.iter().map(|place| self.solid(body, *place)).collect();
        let name = body.name;
        let product = self.entity(format!("PRODUCT('{name}','{name}','',(#3))"));
        self.entity(format!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#{product}))"));
        let formation = self.entity(format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let definition = self.entity(format!("PRODUCT_DEFINITION('design','',#{formation},#4)"));
        let shape = self.entity(format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
        let origin = self.axes(Point::zeros(), 0.0, UP);
        let items = std::iter::once(origin).chain(solids).map(|id| format!("#{id}")).collect::<Vec<_>>().join(",");
        let represented = self.entity(format!("ADVANCED_BREP_SHAPE_REPRESENTATION('{name}',({items}),#{CONTEXT})"));
        self.entity(format!("SHAPE_DEFINITION_REPRESENTATION(#{shape},#{represented})"));
    }

    fn solid(&mut self, body: &Body, place: Place) -> u32 {
        let mut solid = PlacedSolid::new(body, place);
        let mut faces = Vec::new();
        for cap in &body.caps {
            let mut bounds: Vec<Vec<Oriented>> = Vec::new();
            for of in &cap.bounds {
                let mut bound: Vec<Oriented> = Vec::new();
                // The entities of a line are in its own order.
                let is_backward = of.iter().all(|side| !side.is_forward);
                let sides: Vec<&BoundPiece> = if is_backward { of.iter().rev().collect() } else { of.iter().collect() };
                for side in sides {
                    let (edge, is_forward) = self.around(&mut solid, side.piece, cap.height);
                    bound.push((edge, is_forward == (side.is_forward == cap.is_up)));
                }
                // Seen from outside the outer line runs counter-clockwise, and the holes clockwise.
                if cap.is_up == is_backward {
                    bound.reverse();
                }
                bounds.push(bound);
            }
            let height = cap.height + place.bottom;
            let axes = self.axes(place.at, height, if cap.is_up { UP } else { DOWN });
            let plane = self.entity(format!("PLANE('',#{axes})"));
            faces.push(self.face(&bounds, plane, true));
        }
        for wall in &body.walls {
            let pieces = solid.pieces(wall.line).to_vec();
            let count = pieces.len();
            let upright: Vec<u32> = pieces
                .iter()
                .enumerate()
                .map(|(piece, edge)| {
                    let ends =
                        [wall.bottom, wall.top].map(|height| self.corner(&mut solid, (wall.line, piece), height));
                    let at = self.point(edge.start_point(), wall.bottom + place.bottom);
                    let vector = self.entity(format!("VECTOR('',#{UP},1.)"));
                    let line = self.entity(format!("LINE('',#{at},#{vector})"));
                    self.entity(format!("EDGE_CURVE('',#{},#{},#{line},.T.)", ends[0], ends[1]))
                })
                .collect();
            for (piece, edge) in pieces.iter().enumerate() {
                let [low, high] =
                    [wall.bottom, wall.top].map(|height| self.around(&mut solid, (wall.line, piece), height));
                let [from, to] = [piece, (piece + 1) % count].map(|k| upright.get(k).copied().unwrap_or_default());
                let bound = vec![low, (to, true), (high.0, !high.1), (from, false)];
                let (surface, is_same) = self.surface(edge, wall.bottom + place.bottom);
                faces.push(self.face(&[bound], surface, is_same));
            }
        }
        let all = faces.iter().map(|id| format!("#{id}")).collect::<Vec<_>>().join(",");
        let shell = self.entity(format!("CLOSED_SHELL('',({all}))"));
        self.entity(format!("MANIFOLD_SOLID_BREP('{}',#{shell})", body.name))
    }

    /// The surface of a wall over an edge, and whether its normal points out of the material on the edge's left.
    fn surface(&mut self, edge: &Edge, height: f64) -> (u32, bool) {
        match *edge {
            Edge::Line { from, to } => {
                let along = (to - from).normalize();
                let out = self.direction(turned(along, -std::f64::consts::FRAC_PI_2));
                let at = self.point(from, height);
                let first = self.direction(along);
                let axes = self.entity(format!("AXIS2_PLACEMENT_3D('',#{at},#{out},#{first})"));
                (self.entity(format!("PLANE('',#{axes})")), true)
            }
            Edge::Arc { centre, radius, sweep, .. } => {
                let axes = self.axes(centre, height, UP);
                (self.entity(format!("CYLINDRICAL_SURFACE('',#{axes},{})", real(radius))), sweep > 0.0)
            }
        }
    }

    fn face(&mut self, bounds: &[Vec<Oriented>], surface: u32, is_same: bool) -> u32 {
        let mut names = Vec::new();
        for (k, bound) in bounds.iter().enumerate() {
            let edges: Vec<String> = bound
                .iter()
                .map(|(edge, is_forward)| {
                    let id = self.entity(format!("ORIENTED_EDGE('',*,*,#{edge},{})", logical(*is_forward)));
                    format!("#{id}")
                })
                .collect();
            let around = self.entity(format!("EDGE_LOOP('',({}))", edges.join(",")));
            let kind = if k == 0 { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
            let id = self.entity(format!("{kind}('',#{around},.T.)"));
            names.push(format!("#{id}"));
        }
        self.entity(format!("ADVANCED_FACE('',({}),#{surface},{})", names.join(","), logical(is_same)))
    }

    /// The corner at the start of a piece of a line, at a height.
    fn corner(&mut self, solid: &mut PlacedSolid, piece: PieceKey, height: f64) -> u32 {
        let (line, piece) = solid.body.cut.corner(piece);
        let key = (line, piece, (height + 0.0).to_bits());
        if let Some(id) = solid.corners.get(&key) {
            return *id;
        }
        let at = solid.pieces(line).get(piece).map_or(Point::zeros(), Edge::start_point);
        let at = self.point(at, height + solid.place.bottom);
        let id = self.entity(format!("VERTEX_POINT('',#{at})"));
        solid.corners.insert(key, id);
        id
    }

    /// The edge along a piece of a line, at a height, and whether it runs as the piece does.
    fn around(&mut self, solid: &mut PlacedSolid, piece: PieceKey, height: f64) -> Oriented {
        let BoundPiece { piece: (line, piece), is_forward } = solid.body.cut.piece(piece);
        let key = (line, piece, (height + 0.0).to_bits());
        if let Some(id) = solid.edges.get(&key) {
            return (*id, is_forward);
        }
        let Some(edge) = solid.pieces(line).get(piece).copied() else { return (0, true) };
        let next = (piece + 1) % solid.pieces(line).len();
        let ends = [piece, next].map(|piece| self.corner(solid, (line, piece), height));
        let level = height + solid.place.bottom;
        let (curve, is_same) = match edge {
            Edge::Line { from, to } => {
                let (at, along) = (self.point(from, level), self.direction((to - from).normalize()));
                let vector = self.entity(format!("VECTOR('',#{along},1.)"));
                (self.entity(format!("LINE('',#{at},#{vector})")), true)
            }
            Edge::Arc { centre, radius, sweep, .. } => {
                let axes = self.axes(centre, level, UP);
                (self.entity(format!("CIRCLE('',#{axes},{})", real(radius))), sweep > 0.0)
            }
        };
        let id = self.entity(format!("EDGE_CURVE('',#{},#{},#{curve},{})", ends[0], ends[1], logical(is_same)));
        solid.edges.insert(key, id);
        (id, is_forward)
    }
}

fn logical(is_true: bool) -> &'static str {
    if is_true { ".T." } else { ".F." }
}
