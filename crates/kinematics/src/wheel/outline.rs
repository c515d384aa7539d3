//! The two parts as closed loops of straight lines and circular arcs, and areas of what they enclose.
//!
//! Each part lies about its own axis. The wheel has the middle of one slot, the driver one pin, on the first axis. In the
//! assembly the wheel's axis is the origin, the driver's is at (c, 0), the wheel is turned by φ and the driver by π − θ.

use super::mouth::MouthFace;
use super::sizes::Sizes;
use crate::Turn;
use crate::error::{KinematicsError, size};
use crate::indexing::Indexing;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// A piece of an outline, in millimetres.
///
/// ```
/// use geneva_kinematics::wheel::Edge;
/// use nalgebra::Vector2;
/// use std::f64::consts::PI;
///
/// // Half of a circle of 5 mm, counter-clockwise from its right end.
/// let arc = Edge::Arc { centre: Vector2::zeros(), radius: 5.0, start: 0.0, sweep: PI };
/// assert!((arc.end_point() - Vector2::new(-5.0, 0.0)).norm() < 1e-14); // mm
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    /// A straight line.
    Line {
        /// Where it begins, in millimetres.
        from: Vector2<f64>,
        /// Where it ends, in millimetres.
        to: Vector2<f64>,
    },
    /// A circular arc.
    Arc {
        /// Its centre, in millimetres.
        centre: Vector2<f64>,
        /// Its radius, in millimetres.
        radius: f64,
        /// Direction from the centre to where it begins, in radians.
        start: f64,
        /// Angle from there to where it ends, in radians: positive counter-clockwise, negative clockwise.
        sweep: f64,
    },
}

impl Edge {
    /// Point at which the edge begins, in millimetres.
    pub fn start_point(&self) -> Vector2<f64> {
        match *self {
            Self::Line { from, .. } => from,
            Self::Arc { centre, radius, start, .. } => centre + Turn::from_radians(start).direction() * radius,
        }
    }

    /// Point at which the edge ends, in millimetres.
    pub fn end_point(&self) -> Vector2<f64> {
        match *self {
            Self::Line { to, .. } => to,
            Self::Arc { centre, radius, start, sweep } => {
                centre + Turn::from_radians(start + sweep).direction() * radius
            }
        }
    }

    /// The edge turned about the origin by an angle in radians and then moved.
    pub fn transform(&self, angle: f64, by: Vector2<f64>) -> Self {
        let turn = Turn::from_radians(angle);
        let at = |p: Vector2<f64>| Vector2::new(turn.cos * p.x - turn.sin * p.y, turn.sin * p.x + turn.cos * p.y) + by;
        match *self {
            Self::Line { from, to } => Self::Line { from: at(from), to: at(to) },
            Self::Arc { centre, radius, start, sweep } => {
                Self::Arc { centre: at(centre), radius, start: start + angle, sweep }
            }
        }
    }

    /// Twice what the edge contributes to the area, by Green's theorem.
    fn twice_area(&self) -> f64 {
        match *self {
            Self::Line { from, to } => from.perp(&to),
            Self::Arc { centre, radius, sweep, .. } => {
                centre.perp(&(self.end_point() - self.start_point())) + radius * radius * sweep
            }
        }
    }

    /// What the edge contributes to the second moment about the origin: a quarter of ∮ |p|² (x dy − y dx).
    fn second_moment(&self) -> f64 {
        match *self {
            Self::Line { from, to } => {
                from.perp(&to) * (from.norm_squared() + from.dot(&to) + to.norm_squared()) / 12.0
            }
            Self::Arc { centre: c, radius: r, start, sweep } => {
                let ([s1, c1], [s2, c2]) = (sine_cosine(start), sine_cosine(start + sweep));
                // Of g = c · e, with e the unit vector to the arc's point, and of its square.
                let once = c.x * (s2 - s1) - c.y * (c2 - c1);
                let double = s2 * c2 - s1 * c1;
                let squared = (c.norm_squared() * sweep + (c.x * c.x - c.y * c.y) * double) / 2.0
                    + c.x * c.y * (s2 * s2 - s1 * s1);
                let sum = c.norm_squared() + r * r;
                r * (sum * r * sweep + (sum + 2.0 * r * r) * once + 2.0 * r * squared) / 4.0
            }
        }
    }
}

fn sine_cosine(angle: f64) -> [f64; 2] {
    let (sine, cosine) = libm::sincos(angle);
    [sine, cosine]
}

/// A closed line: each edge begins where the one before it ends.
///
/// ```
/// use geneva_kinematics::wheel::Loop;
/// use nalgebra::Vector2;
///
/// let circle = Loop::circle(Vector2::zeros(), 20.0, false); // radius in mm
/// let corners = circle.corners(0.01)?; // of a polygon that leaves it by 0.01 mm at most
/// let middle = (corners[0] + corners[1]) / 2.0; // of a side
/// assert!(corners.iter().all(|corner| (corner.norm() - 20.0).abs() < 1e-12) && middle.norm() > 20.0 - 0.01);
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Its pieces in order, the material on the left.
    pub edges: Vec<Edge>,
}

impl Loop {
    /// A whole circle, counter-clockwise for an outer edge, clockwise for a hole; lengths in millimetres.
    pub fn circle(centre: Vector2<f64>, radius: f64, is_hole: bool) -> Self {
        let sweep = if is_hole { -2.0 * PI } else { 2.0 * PI };
        Self { edges: vec![Edge::Arc { centre, radius, start: 0.0, sweep }] }
    }

    /// The loop turned about the origin by an angle in radians and then moved, in millimetres.
    pub fn transform(&self, angle: f64, by: Vector2<f64>) -> Self {
        Self { edges: self.edges.iter().map(|edge| edge.transform(angle, by)).collect() }
    }

    /// The corners of a polygon that leaves the loop by this much at most, in millimetres.
    ///
    /// They are on the loop, at the ends of all edges and, where an arc is too long for its chord, evenly along it.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a tolerance that is not positive and finite.
    pub fn corners(&self, tolerance: f64) -> Result<Vec<Vector2<f64>>, KinematicsError> {
        let tolerance = size("chord tolerance in mm", tolerance)?;
        let mut corners = Vec::new();
        for edge in &self.edges {
            corners.push(edge.start_point());
            let Edge::Arc { centre, radius, start, sweep } = *edge else { continue };
            // A chord of the angle x leaves its arc by r (1 − cos(x/2)); never more than a quarter turn to a chord.
            let chord = 4.0 * libm::asin((tolerance / (2.0 * radius)).sqrt().min(0.38));
            let count = libm::ceil(sweep.abs() / chord).clamp(1.0, 1e5) as u32;
            for k in 1..count {
                let angle = start + sweep * f64::from(k) / f64::from(count);
                corners.push(centre + Turn::from_radians(angle).direction() * radius);
            }
        }
        Ok(corners)
    }

    fn area(&self) -> f64 {
        self.edges.iter().map(Edge::twice_area).sum::<f64>() / 2.0
    }

    fn second_moment(&self) -> f64 {
        self.edges.iter().map(Edge::second_moment).sum()
    }
}

/// A flat face with holes.
///
/// ```
/// use geneva_kinematics::wheel::{Face, Loop};
/// use nalgebra::Vector2;
/// use std::f64::consts::PI;
///
/// // A round plate of steel: radius 100 mm, 10 mm thick, 7800 kg/m³. Its moment of inertia is half its mass times r².
/// let plate = Face { outer: Loop::circle(Vector2::zeros(), 100.0, false), holes: vec![] };
/// let mass = 7800.0 * PI * 0.1 * 0.1 * 0.01; // kg
/// assert!((plate.area() - PI * 1e4).abs() < 1e-9); // mm²
/// assert!((plate.moment_of_inertia(10.0, 7800.0)? - mass * 0.1 * 0.1 / 2.0).abs() < 1e-15); // kg m²
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Its outer edge, counter-clockwise.
    pub outer: Loop,
    /// Its holes, clockwise.
    pub holes: Vec<Loop>,
}

impl Face {
    /// All loops of the face, the outer one first.
    pub fn loops(&self) -> impl Iterator<Item = &Loop> {
        std::iter::once(&self.outer).chain(&self.holes)
    }

    /// The face turned about the origin by an angle in radians and then moved, in millimetres.
    pub fn transform(&self, angle: f64, by: Vector2<f64>) -> Self {
        let holes = self.holes.iter().map(|hole| hole.transform(angle, by)).collect();
        Self { outer: self.outer.transform(angle, by), holes }
    }

    /// Area of the face in square millimetres, exact but for rounding.
    pub fn area(&self) -> f64 {
        self.loops().map(Loop::area).sum()
    }

    /// Polar second moment of the face's area about the origin, in the fourth power of millimetres, exact but for rounding.
    pub fn second_moment(&self) -> f64 {
        self.loops().map(Loop::second_moment).sum()
    }

    /// Moment of inertia about the origin in kg m², of a plate of this face, from its thickness in millimetres and its density
    /// in kg/m³.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Length`] and [`KinematicsError::Size`] for what is not positive and finite.
    pub fn moment_of_inertia(&self, thickness: f64, density: f64) -> Result<f64, KinematicsError> {
        let thickness = crate::error::length("thickness", thickness)?;
        // Five lengths in millimetres.
        Ok(self.second_moment() * thickness * size("density", density)? * 1e-15)
    }
}

/// The outlines of both parts, each about its own axis.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use std::f64::consts::PI;
///
/// let sizes = Sizes::new(Wheel::with_pins(6, 2)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let outline = sizes.outline();
/// // At each station: two walls and the end of a slot, two pieces of rim and a locking arc. A mouth adds two faces.
/// assert_eq!((outline.wheel.outer.edges.len(), outline.pins.len()), (6 * 6, 2));
/// assert!(outline.wheel.area() < PI * sizes.tip_radius * sizes.tip_radius); // mm²
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The wheel.
    pub wheel: Face,
    /// The driver's locking disc, in the plane of the wheel, if there is a dwell.
    pub disc: Option<Face>,
    /// The driver's plate, behind the wheel.
    pub plate: Face,
    /// The driver's pins, in the plane of the wheel and fast to the plate.
    pub pins: Vec<Loop>,
}

impl Sizes {
    /// The outlines of wheel, disc, plate and pins, in millimetres, each part about its own axis.
    pub fn outline(&self) -> Outline {
        let bore = |diameter: f64| {
            let hole = |diameter| Loop::circle(Vector2::zeros(), diameter / 2.0, true);
            Some(diameter).filter(|diameter| *diameter > 0.0).map(hole).into_iter().collect::<Vec<_>>()
        };
        let plate = Loop::circle(Vector2::zeros(), self.plate_radius, false);
        let pins = self.pin_directions().map(|angle| {
            let at = Turn::from_radians(angle).direction() * self.crank_radius;
            Loop::circle(at, self.pin_radius(), false)
        });
        Outline {
            wheel: Face { outer: self.wheel_loop(), holes: bore(self.wheel_bore()) },
            disc: self.disc_loop().map(|outer| Face { outer, holes: bore(self.driver_bore()) }),
            plate: Face { outer: plate, holes: bore(self.plate_bore()) },
            pins: pins.collect(),
        }
    }

    /// Directions of the pins from the driver's axis, the first on the first axis, in radians.
    pub(super) fn pin_directions(&self) -> impl Iterator<Item = f64> {
        let pins = self.wheel.pins();
        (0..pins).map(move |k| 2.0 * PI * f64::from(k) / f64::from(pins))
    }

    /// The face of a mouth that is not sharp, above the slot on the first axis, from the wall to the rim; in millimetres.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Edge, Mouth, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { mouth: Mouth::Round { radius: 1.0 }, ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &choices)?;
    /// assert!(matches!(sizes.mouth_face(), Some(Edge::Arc { radius, .. }) if radius == 1.0));
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn mouth_face(&self) -> Option<Edge> {
        let mouth = self.mouth_profile();
        Some(match mouth.face? {
            MouthFace::Flat { .. } => Edge::Line { from: mouth.wall_end, to: mouth.rim },
            MouthFace::Round { centre, radius, end } => {
                Edge::Arc { centre, radius, start: -FRAC_PI_2, sweep: FRAC_PI_2 + end }
            }
        })
    }

    fn wheel_loop(&self) -> Loop {
        let half_pitch = self.wheel.half_pitch_angle();
        let (half, end, wall_end) = (self.slot_width / 2.0, self.slot_end, self.mouth_profile().wall_end.x);
        let (corner, tip) = (self.corner_angle(), self.tip_angle());
        let locking = self.locking_end_angle();
        let (rim, c) = (self.tip_radius, self.centre_distance);
        let opening = libm::atan2(rim * libm::sin(locking), c - rim * libm::cos(locking));
        let line = |from, to| Edge::Line { from: Vector2::from(from), to: Vector2::from(to) };
        let round = |start, sweep| Edge::Arc { centre: Vector2::zeros(), radius: rim, start, sweep };
        let above = self.mouth_face();
        // Its mirror image below the slot runs from the rim to the wall.
        let below = above.map(|face| match face {
            Edge::Line { from, to } => line([to.x, -to.y], [from.x, -from.y]),
            Edge::Arc { centre, radius, start, sweep } => {
                Edge::Arc { centre: Vector2::new(centre.x, -centre.y), radius, start: -start - sweep, sweep }
            }
        });
        let slot = [
            line([wall_end, -half], [end, -half]),
            Edge::Arc { centre: Vector2::new(end, 0.0), radius: half, start: -FRAC_PI_2, sweep: -PI },
            line([end, half], [wall_end, half]),
        ];
        let horns = [
            round(corner, tip - corner),
            Edge::Arc {
                centre: Turn::from_radians(half_pitch).direction() * c,
                radius: self.locking_arc_radius,
                start: half_pitch + PI + opening,
                sweep: -2.0 * opening,
            },
            round(2.0 * half_pitch - tip, tip - corner),
        ];
        let sector: Vec<Edge> = below.into_iter().chain(slot).chain(above).chain(horns).collect();
        let turns = (0..self.wheel.stations()).map(|k| 2.0 * half_pitch * f64::from(k));
        let at = |turn: f64| sector.iter().map(move |edge| edge.transform(turn, Vector2::zeros()));
        Loop { edges: turns.flat_map(at).collect() }
    }

    fn disc_loop(&self) -> Option<Loop> {
        let disc = self.locking_disc?;
        let cut = disc.crescent;
        let (x, y) = (disc.radius * libm::cos(cut.half_angle), disc.radius * libm::sin(cut.half_angle));
        let half = libm::atan2(y, cut.centre - x);
        let solid = 2.0 * PI / f64::from(self.wheel.pins()) - 2.0 * cut.half_angle;
        let pitch = [
            Edge::Arc {
                centre: Vector2::new(cut.centre, 0.0),
                radius: cut.radius,
                start: PI + half,
                sweep: -2.0 * half,
            },
            Edge::Arc { centre: Vector2::zeros(), radius: disc.radius, start: cut.half_angle, sweep: solid },
        ];
        let pins = self.pin_directions();
        Some(Loop { edges: pins.flat_map(|pin| pitch.map(|edge| edge.transform(pin, Vector2::zeros()))).collect() })
    }
}
